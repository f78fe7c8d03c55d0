<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>ripstop</name>
    <message>
        <location filename="align.cpp"/>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <location filename="align.cpp"/>
        <source>Distribute</source>
        <translation>Répartir</translation>
    </message>
    <message>
        <location filename="align.cpp"/>
        <source>Flatten</source>
        <translation>Aplatir</translation>
    </message>
    <message>
        <location filename="arrivals.cpp"/>
        <source>Imported %1. Pin what is to be held: nothing holds it yet.</source>
        <translation>%1 importé. Fixer ce qui doit être tenu : rien ne le tient encore.</translation>
    </message>
    <message>
        <location filename="assimp_mesh.cpp"/>
        <source>The mesh cannot be written: %1</source>
        <translation>Le maillage ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <location filename="autosave.cpp"/>
        <source>%1 cannot be written: free some space.</source>
        <translation>%1 ne peut pas être écrit : libérer de la place.</translation>
    </message>
    <message>
        <location filename="autosave.cpp"/>
        <source>Unsaved work cannot be kept in %1: make the folder one that you may write to, or save often.</source>
        <translation>Le travail non enregistré ne peut pas être gardé dans %1 : permettre l’écriture dans ce dossier, ou enregistrer souvent.</translation>
    </message>
    <message>
        <location filename="autosave.cpp"/>
        <source>Unsaved work is not kept: %1</source>
        <translation>Le travail non enregistré n’est pas gardé : %1</translation>
    </message>
    <message>
        <location filename="band_chart.cpp"/>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <location filename="bend_force.cpp"/>
        <source>bending</source>
        <translation>la flexion</translation>
    </message>
    <message>
        <location filename="bridle.cpp"/>
        <source>lengths, row %1, column %2: %3 m do not reach; it takes %4 m.</source>
        <translation>longueurs, rang %1, colonne %2 : %3 m ne suffisent pas ; il faut %4 m.</translation>
    </message>
    <message>
        <location filename="bridle.cpp"/>
        <source>lengths, row 1, column 11: more than 10 levels would be more than a thousand lines in each row.</source>
        <translation>longueurs, rang 1, colonne 11 : plus de 10 niveaux feraient plus de mille lignes dans chaque rang.</translation>
    </message>
    <message>
        <location filename="brush.cpp"/>
        <source>Paint %1</source>
        <translation>Peindre : %1</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Drag over the fabric. Ctrl and the wheel, or [ and ], change the radius. Esc gives a stroke up.</source>
        <translation>Tirez sur le tissu. Ctrl et la molette, ou [ et ], changent le rayon. Échap abandonne le trait.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Falloff</source>
        <translation>Atténuation</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Grain</source>
        <translation>Droit-fil</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Hard</source>
        <translation>Net</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>How far the brush reaches from the cursor; [ and ], or Ctrl and the wheel, change it.</source>
        <translation>Jusqu’où le pinceau agit autour du curseur ; [ et ], ou Ctrl et la molette, le changent.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>How far the warp is turned from the way that the picture on the fabric goes up, counterclockwise as one sees the front of the panels.</source>
        <translation>De combien la chaîne est tournée par rapport au haut de l’image imprimée sur le tissu, dans le sens inverse des aiguilles d’une montre, les panneaux vus de face.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>How many times as stiff as its material the fabric is to be: above 1 where cloth lies double, below where it is worn; 1 takes the paint off.</source>
        <translation>Combien de fois le tissu doit être plus raide que son matériau : plus de 1 là où il est doublé, moins là où il est usé ; 1 enlève la peinture.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>How many times as strong as its material the fabric is to be: below 1 where it is worn, above where it is reinforced; 1 takes the paint off.</source>
        <translation>Combien de fois le tissu doit être plus résistant que son matériau : moins de 1 là où il est usé, plus là où il est renforcé ; 1 enlève la peinture.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Mirror</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Paint the other side of the part as well: across the plane that it is most nearly its own mirror image at. A second ring shows where that is.</source>
        <translation>Peindre aussi l’autre côté de la pièce : par rapport au plan qui en fait le plus exactement sa propre image. Un second cercle montre où il se trouve.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Painted</source>
        <translation>Peint</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Soft</source>
        <translation>Doux</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Soft: less and less towards the edge of the brush. Hard: all alike.</source>
        <translation>Doux : de moins en moins vers le bord du pinceau. Net : partout pareil.</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>Strength</source>
        <translation>Résistance</translation>
    </message>
    <message>
        <location filename="brush_bar.cpp"/>
        <source>What the brush paints.</source>
        <translation>Ce que le pinceau peint.</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>%1 · radius %2 m</source>
        <translation>%1 · rayon %2 m</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>No panels and no links here to paint.</source>
        <translation>Il n’y a ici ni panneau ni liaison à peindre.</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>No panels here to paint: only parts whose panels carry the pull of the fabric have a grain.</source>
        <translation>Il n’y a ici aucun panneau à peindre : seules les pièces dont les panneaux portent la traction du tissu ont un droit-fil.</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>grain %1°</source>
        <translation>droit-fil %1°</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>stiffness × %1</source>
        <translation>raideur × %1</translation>
    </message>
    <message>
        <location filename="brush_tool.cpp"/>
        <source>strength × %1</source>
        <translation>résistance × %1</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>%1 must be a number from %2 to %3, and is %4.</source>
        <translation>%1 doit être un nombre de %2 à %3, et est %4.</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>%1 must be a whole number from %2 to %3, and is %4.</source>
        <translation>%1 doit être un nombre entier de %2 à %3, et est %4.</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>%1, row %2, column %3: "%4" is not a number.</source>
        <translation>%1, rang %2, colonne %3 : « %4 » n’est pas un nombre.</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>%1, row %2, column %3: each row needs as many numbers as the first, %4, and this one has %5.</source>
        <translation>%1, rang %2, colonne %3 : chaque rang demande autant de nombres que le premier, %4, et celui-ci en a %5.</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>%1, row %2, column %3: must be from %4 to %5 %6, and is %7.</source>
        <translation>%1, rang %2, colonne %3 : doit être de %4 à %5 %6, et est %7.</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>The builder %1 has no parameter "%2"; did you mean "%3"?</source>
        <translation>Le générateur %1 n’a pas de paramètre « %2 » ; vouliez-vous dire « %3 » ?</translation>
    </message>
    <message>
        <location filename="builder.cpp"/>
        <source>The builder %1 has no parameter "%2"; it has %3.</source>
        <translation>Le générateur %1 n’a pas de paramètre « %2 » ; il a %3.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Defaults</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Design</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Empty: by the numbers above. Or paste from a spreadsheet.</source>
        <translation>Vide : d’après les nombres ci-dessus. Ou coller depuis un tableur.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Ideal materials</source>
        <translation>Matériaux idéaux</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Insert</source>
        <translation>Insérer</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>New from builder</source>
        <translation>Nouveau à partir d’un générateur</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Parameters of %1</source>
        <translation>Paramètres de %1</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Raises the substeps of the scene to %1.</source>
        <translation>Porte les sous-pas de la scène à %1.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Sets every parameter to what goes with ideal cloth, lines and spars: deltas, gliders and parachutes are those of the papers then.</source>
        <translation>Met chaque paramètre à ce qui va avec un tissu, des lignes et des longerons idéaux : deltas, planeurs et parachutes sont alors ceux des articles.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Sets every parameter to what it was at first.</source>
        <translation>Redonne à chaque paramètre sa valeur de départ.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Show in the view</source>
        <translation>Montrer dans la vue</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Show in the view (not in a run)</source>
        <translation>Montrer dans la vue (pas pendant une simulation)</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Strength, stiffness and grain that were painted stay at their places: on %1 of the links and panels.</source>
        <translation>Résistance, raideur et droit-fil peints restent à leur place : sur %1 des liaisons et panneaux.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>The design shows the outcome while this dialog is open.</source>
        <translation>Le modèle montre le résultat tant que cette fenêtre est ouverte.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>The view shows a run, which goes on as it is. What is inserted comes into it; to see it before, go back to the start first.</source>
        <translation>La vue montre une simulation, qui continue telle quelle. Ce qui est inséré y entre ; pour le voir avant, revenez d’abord au départ.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>The view shows a run, which stays as it is until the part is changed; the view goes back to the start then. To see it before, go there first.</source>
        <translation>La vue montre une simulation, qui reste telle quelle jusqu’à ce que la pièce soit changée ; la vue revient alors au départ. Pour le voir avant, revenez-y d’abord.</translation>
    </message>
    <message>
        <location filename="builder_dialog.cpp"/>
        <source>Too large to be shown while you type.</source>
        <translation>Trop grand pour être montré pendant la saisie.</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>Part %1 %2, or set its canopyPressure to 0.</source>
        <translation>La pièce %1 %2, ou mettre sa pression de voilure à 0.</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure and closed fabric that no air can enter: leave a mouth open</source>
        <translation>a une pression de voilure et un tissu fermé où l’air ne peut entrer : laisser une bouche ouverte</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure and fabric with one side only, like a twisted ribbon: remove a panel of the twist</source>
        <translation>a une pression de voilure et un tissu à une seule face, comme un ruban tordu : supprimer un panneau de la torsion</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure and lies flat where the run starts, so that neither side is the inside: give it a hollow</source>
        <translation>a une pression de voilure et démarre à plat, sans intérieur d’aucun côté : lui donner un creux</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure and no panels to hold the air: add panels</source>
        <translation>a une pression de voilure et pas de panneaux pour tenir l’air : ajouter des panneaux</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure, and more than two panels meet between particles %1 and %2: remove all but two of them</source>
        <translation>a une pression de voilure, et plus de deux panneaux se rejoignent entre les particules %1 et %2 : n’en garder que deux</translation>
    </message>
    <message>
        <location filename="canopy_shape.cpp"/>
        <source>has canopy pressure, and panel %1 has a corner that is not a particle of this part: join the two parts</source>
        <translation>a une pression de voilure, et le panneau %1 a un coin qui n’est pas une particule de cette pièce : joindre les deux pièces</translation>
    </message>
    <message>
        <location filename="carry_fabric.cpp"/>
        <source>%1 has no membrane stiffness that panels could carry: give it one first, in N/m, or the numbers of a fabric of the library.</source>
        <translation>%1 n’a pas de raideur de membrane que des panneaux pourraient porter : donnez-lui-en d’abord une, en N/m, ou les nombres d’un tissu de la bibliothèque.</translation>
    </message>
    <message>
        <location filename="carry_fabric.cpp"/>
        <source>Panels carry the fabric</source>
        <translation>Tissu porté par les panneaux</translation>
    </message>
    <message>
        <location filename="carry_fabric.cpp"/>
        <source>There is no panel of this material that could carry its pull.</source>
        <translation>Il n’y a pas de panneau de ce matériau qui pourrait porter sa traction.</translation>
    </message>
    <message>
        <location filename="certify.cpp"/>
        <source>nothing is certified in less than a time step, %1 s; certify a longer time</source>
        <translation>rien n’est certifié en moins d’un pas de temps, %1 s ; certifier une durée plus longue</translation>
    </message>
    <message>
        <location filename="certify.cpp"/>
        <source>the scene has no probe that could be judged: add one</source>
        <translation>la scène n’a pas de sonde que l’on puisse juger : ajoutez-en une</translation>
    </message>
    <message>
        <location filename="certify.cpp"/>
        <source>with %1 times as many substeps: %2</source>
        <translation>avec %1 fois autant de sous-pas : %2</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>&amp;Certify</source>
        <translation>&amp;Certifier</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>&amp;Save table…</source>
        <translation>&amp;Enregistrer le tableau…</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>After %1 s. Select a probe to see how far it may be off over time. The plots show it, too, when the design runs as it is now.</source>
        <translation>Après %1 s. Sélectionnez une sonde pour voir de combien elle peut s’écarter au cours du temps. Les graphiques le montrent aussi quand le modèle vole tel qu’il est.</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Cannot save the recording</source>
        <translation>Impossible d’enregistrer la simulation</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Cannot save the table</source>
        <translation>Impossible d’enregistrer le tableau</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Certify</source>
        <translation>Certifier</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Certifying…</source>
        <translation>Certification…</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Digits</source>
        <translation>Chiffres</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Flies the design three times: as it is, with each substep cut in two, and in four. How the values of the probes come nearer to each other tells how far they are from where they go, and so which of their digits hold.</source>
        <translation>Fait voler le modèle trois fois : tel quel, avec chaque sous-pas coupé en deux, et en quatre. La façon dont les valeurs des sondes se rapprochent dit à quelle distance elles sont de leur limite, et donc lesquels de leurs chiffres sont justes.</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>It takes about seven times as long as the run.</source>
        <translation>Cela prend environ sept fois le temps de la simulation.</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Judged by</source>
        <translation>Jugée par</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Recordings (*.ripstop-run)</source>
        <translation>Enregistrements (*.ripstop-run)</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>S&amp;imulated time</source>
        <translation>Temps s&amp;imulé</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Save &amp;recording…</source>
        <translation>Enregistrer la &amp;simulation…</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Save the run with its certificate</source>
        <translation>Enregistrer la simulation avec son certificat</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Save the values and their errors</source>
        <translation>Enregistrer les valeurs et leurs erreurs</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Saving…</source>
        <translation>Enregistrement…</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>last value</source>
        <translation>la dernière valeur</translation>
    </message>
    <message>
        <location filename="certify_dialog.cpp"/>
        <source>mean of the second half</source>
        <translation>la moyenne de la seconde moitié</translation>
    </message>
    <message>
        <location filename="chart.cpp"/>
        <source>%1: %2 ± %3, by the certificate of the run</source>
        <translation>%1 : %2 ± %3, d’après le certificat de la simulation</translation>
    </message>
    <message>
        <location filename="chart.cpp"/>
        <source>error band</source>
        <translation>bande d’erreur</translation>
    </message>
    <message>
        <location filename="chart_style.cpp"/>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1 needs three different particles as its corners; remove it.</source>
        <translation>%1 : il faut trois particules différentes à ses coins ; le supprimer.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1 needs two different particles as its ends; remove it.</source>
        <translation>%1 : il faut deux particules différentes à ses bouts ; la supprimer.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1 of %2 is free and has no mass: give it a mass or pin it.</source>
        <translation>%1 de %2 est libre et sans masse : lui donner une masse ou la fixer.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1 of %2 needs a guide axis that is not zero.</source>
        <translation>%1 de %2 demande un axe de guidage non nul.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1 of material %2 is above %3 %4, which no step can solve and nothing is: check the unit.</source>
        <translation>%1 du matériau %2 dépasse %3 %4, ce qu’aucun pas ne peut résoudre et que rien n’atteint : vérifiez l’unité.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1: %2 points at %3 of the type %4, which this version does not know; choose another or remove it.</source>
        <translation>%1 : %2 désigne %3, de la sorte %4, que cette version ne connaît pas ; en choisir un autre ou le retirer.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1: %2 points at %3, which does not exist; choose another or remove it.</source>
        <translation>%1 : %2 désigne %3, qui n’existe pas ; en choisir un autre ou le retirer.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>%1: %2 points at %3, which is a %4.</source>
        <translation>%1 : %2 désigne %3, qui est de la sorte : %4.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Control %1 has no targets and does nothing.</source>
        <translation>La commande %1 n’a pas de cible et ne fait rien.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Control %1 is to move by itself at %2 m/s, and its rate lets it move at %3 m/s: raise the rate, or lower the automatic one.</source>
        <translation>La commande %1 doit se mouvoir d’elle-même à %2 m/s, et sa vitesse de réponse ne lui permet que %3 m/s : augmentez celle-ci, ou réduisez la vitesse automatique.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Control %1 needs an axis that is not zero.</source>
        <translation>La commande %1 demande un axe non nul.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Control %1 shifts weights, and a collider has none: make it move, or remove the collider from its targets.</source>
        <translation>La commande %1 déporte des poids, et un obstacle n’en a pas : la faire déplacer, ou retirer l’obstacle de ses cibles.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Materials #%1 and #%2 are both called %3, and a path of that name means the first: rename one.</source>
        <translation>Les matériaux #%1 et #%2 s’appellent tous deux %3, et un chemin de ce nom désigne le premier : renommez-en un.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Plot %1 needs the probe that its curves are against.</source>
        <translation>Le graphique %1 demande la sonde en abscisse de ses courbes.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Plot %1 shows no values: its lowest has to be below its highest.</source>
        <translation>Le graphique %1 ne montre aucune valeur : sa plus basse doit être sous sa plus haute.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Probe %1 needs a target and a particle to measure from.</source>
        <translation>La sonde %1 demande une cible et une particule de référence.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Probe %1 needs a third particle, on the right.</source>
        <translation>La sonde %1 demande une troisième particule, à droite.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>The formula of probe %1 cannot be worked out: %2.</source>
        <translation>La formule de la sonde %1 ne peut pas être calculée : %2.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>The id %1 is used twice; give one of the two another id.</source>
        <translation>L’id %1 sert deux fois ; donner un autre id à l’un des deux.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>The scene has no particles: insert a part or import a mesh.</source>
        <translation>La scène n’a pas de particules : insérer une pièce ou importer un maillage.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 blows by its first row until %2 s of the run: let the times of its table count from the start of the run.</source>
        <translation>Le vent %1 souffle selon sa première ligne jusqu’à %2 s du vol : que les temps de son tableau comptent depuis le début du vol.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 blows with %2 m/s, and a run stops where something goes faster than the speed limit of %3 m/s: check the unit.</source>
        <translation>Le vent %1 souffle à %2 m/s, et un calcul s’arrête dès que quelque chose dépasse la vitesse limite de %3 m/s : vérifiez l’unité.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 comes again after %2 s, before it has ended at %3 s: make the interval as long as the duration or longer, or 0 for one gust.</source>
        <translation>Le vent %1 revient après %2 s, avant de finir à %3 s : rendez l’intervalle au moins aussi long que la durée, ou nul pour une seule rafale.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 has one row of velocities, and blows by it all the time: read a table of more.</source>
        <translation>Le vent %1 n’a qu’une ligne de vitesses, et souffle ainsi tout le temps : lisez un tableau qui en a davantage.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 is over in %2 s, less than ten steps of %3 s: make it longer, or the time step shorter.</source>
        <translation>Le vent %1 est fini en %2 s, moins de dix pas de %3 s : allongez-le, ou raccourcissez le pas de temps.</translation>
    </message>
    <message>
        <location filename="check.cpp"/>
        <source>Wind %1 needs a roughness that is below its reference height.</source>
        <translation>Le vent %1 demande une rugosité inférieure à sa hauteur de référence.</translation>
    </message>
    <message>
        <location filename="clipboard.cpp"/>
        <source>There is nothing to paste: the clipboard holds no design. Copy something that is selected first.</source>
        <translation>Il n’y a rien à coller : le presse-papiers ne contient pas de modèle. Copier d’abord une sélection.</translation>
    </message>
    <message>
        <location filename="cloth.cpp"/>
        <source>The sheet hangs %1 m down from a level of %2 m, into the ground: give it a level of at least its height, or start it flat.</source>
        <translation>La toile pend sur %1 m depuis un niveau de %2 m, jusque dans le sol : lui donner un niveau au moins égal à sa hauteur, ou la faire commencer à plat.</translation>
    </message>
    <message>
        <location filename="collider_path.cpp"/>
        <source>must be times and places as 0: 0 1 0; 2.5: 3 1 0 (%1 is not)</source>
        <translation>doit être des temps et des lieux comme 0: 0 1 0; 2.5: 3 1 0 (%1 n’en est pas)</translation>
    </message>
    <message>
        <location filename="collider_path.cpp"/>
        <source>must have times that ascend (%1 is not later than the row before)</source>
        <translation>doit avoir des temps croissants (%1 n’est pas après le rang d’avant)</translation>
    </message>
    <message>
        <location filename="collider_shape.cpp"/>
        <source>Collider %1: %2</source>
        <translation>Obstacle %1 : %2</translation>
    </message>
    <message>
        <location filename="collider_shape.cpp"/>
        <source>Collider %1: its path %2.</source>
        <translation>Obstacle %1 : son trajet %2.</translation>
    </message>
    <message>
        <location filename="collider_shape.cpp"/>
        <source>It needs a mesh: set its file to an OBJ, STL or PLY.</source>
        <translation>il lui faut un maillage : donner comme fichier un OBJ, STL ou PLY.</translation>
    </message>
    <message>
        <location filename="collider_shape.cpp"/>
        <source>It needs a width and a depth above 0 and a height of at least 0: correct its size.</source>
        <translation>il faut une largeur et une profondeur au-dessus de 0 et une hauteur d’au moins 0 : corriger sa taille.</translation>
    </message>
    <message>
        <location filename="columns_view.cpp"/>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <location filename="columns_view.cpp"/>
        <source>Which variables and measures are shown</source>
        <translation>Les variables et les mesures montrées</translation>
    </message>
    <message>
        <location filename="compare_runs.cpp"/>
        <source>One of the recordings holds no frame.</source>
        <translation>L’un des enregistrements ne contient aucune image.</translation>
    </message>
    <message>
        <location filename="compare_runs.cpp"/>
        <source>The recordings have no time in common.</source>
        <translation>Les enregistrements n’ont aucun instant en commun.</translation>
    </message>
    <message>
        <location filename="compass.cpp"/>
        <source>No wind</source>
        <translation>Pas de vent</translation>
    </message>
    <message>
        <location filename="compass.cpp"/>
        <source>Squares of %1</source>
        <translation>Carreaux de %1</translation>
    </message>
    <message>
        <location filename="compass.cpp"/>
        <source>Wind %1 m/s</source>
        <translation>Vent %1 m/s</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>"not" goes with a switch, as in not pinned; elsewhere compare with !=</source>
        <translation>« not » va avec un interrupteur, comme not pinned ; ailleurs, comparer avec !=</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 has no x, y or z; say %2</source>
        <translation>%1 n’a ni x, ni y, ni z ; dire %2</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 has three numbers; say %2.x, %3.y or %4.z</source>
        <translation>%1 a trois nombres ; dire %2.x, %3.y ou %4.z</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 is a list and cannot be compared; choose another property</source>
        <translation>%1 est une liste et ne se compare pas ; choisir une autre propriété</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 is a number; go on with &lt;, &gt; or = and a value</source>
        <translation>%1 est un nombre ; continuer avec &lt;, &gt; ou = et une valeur</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 is not a number; compare it with = or !=</source>
        <translation>%1 n’est pas un nombre ; le comparer avec = ou !=</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 is not a number; write one, as in %2 &gt; 1</source>
        <translation>%1 n’est pas un nombre ; en écrire un, comme dans %2 &gt; 1</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>%1 is not a unit of %2; %3</source>
        <translation>%1 n’est pas une unité de %2 ; %3</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>a number is missing; write one, as in %1 &gt; 1</source>
        <translation>il manque un nombre ; en écrire un, comme dans %1 &gt; 1</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>go on with = and a value, as in %1 = %2</source>
        <translation>continuer avec = et une valeur, comme dans %1 = %2</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>go on with = and the name of a %1</source>
        <translation>continuer avec = et le nom de : %1</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>leave it out</source>
        <translation>l’omettre</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>nothing has a %1; did you mean %2?</source>
        <translation>rien n’a de %1 ; vouliez-vous dire %2 ?</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>nothing has a %1; say for example mass, restLength, material or strain</source>
        <translation>rien n’a de %1 ; dire par exemple mass, restLength, material ou strain</translation>
    </message>
    <message>
        <location filename="condition.cpp"/>
        <source>use one of %1</source>
        <translation>en prendre une parmi %1</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>%1 match now.</source>
        <translation>%1 correspondent pour l’instant.</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Add to the selection</source>
        <translation>Ajouter à la sélection</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Double click to put it into the condition.</source>
        <translation>Un double-clic la met dans la condition.</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Keep only those selected already</source>
        <translation>Ne garder que ce qui est déjà sélectionné</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Nothing matches now.</source>
        <translation>Rien ne correspond pour l’instant.</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Particles, links and panels with</source>
        <translation>Particules, liaisons et panneaux avec</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Property</source>
        <translation>Propriété</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Replace the selection</source>
        <translation>Remplacer la sélection</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Select by property</source>
        <translation>Sélectionner par propriété</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Take away from the selection</source>
        <translation>Retirer de la sélection</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>What becomes of the selection</source>
        <translation>Ce que devient la sélection</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>Write a property, a comparison and a value; "and" joins several.</source>
        <translation>Écrire une propriété, une comparaison et une valeur ; « and » en joint plusieurs.</translation>
    </message>
    <message>
        <location filename="condition_dialog.cpp"/>
        <source>strain &gt; 5 %    mass &lt; 1 g and not pinned    material = ripstop</source>
        <translation>strain &gt; 5 %    mass &lt; 1 g and not pinned    material = ripstop</translation>
    </message>
    <message>
        <location filename="condition_text.cpp"/>
        <source>At character %1: %2</source>
        <translation>Au caractère %1 : %2</translation>
    </message>
    <message>
        <location filename="condition_text.cpp"/>
        <source>a property is missing; begin with one, as in mass &lt; 1 g</source>
        <translation>il manque une propriété ; commencer par une, comme dans mass &lt; 1 g</translation>
    </message>
    <message>
        <location filename="condition_text.cpp"/>
        <source>a value is missing after %1</source>
        <translation>il manque une valeur après %1</translation>
    </message>
    <message>
        <location filename="condition_text.cpp"/>
        <source>expected &lt;, &gt;, =, != or "and", not "%1"</source>
        <translation>attendu &lt;, &gt;, =, != ou « and », et non « %1 »</translation>
    </message>
    <message>
        <location filename="constant_mesh.cpp"/>
        <source>The lines of the design change after %1 s, and this format knows one mesh only; choose a sequence of files.</source>
        <translation>Les lignes du modèle changent après %1 s, et ce format ne connaît qu’un maillage ; choisir une suite de fichiers.</translation>
    </message>
    <message>
        <location filename="constant_mesh.cpp"/>
        <source>The panels of the design change after %1 s, and this format knows one mesh only; choose a sequence of files.</source>
        <translation>Les panneaux du modèle changent après %1 s, et ce format ne connaît qu’un maillage ; choisir une suite de fichiers.</translation>
    </message>
    <message>
        <location filename="constant_mesh.cpp"/>
        <source>The scene has neither fabric nor lines, so there is nothing to show.</source>
        <translation>La scène n’a ni tissu ni lignes, il n’y a donc rien à montrer.</translation>
    </message>
    <message>
        <location filename="control_strip.cpp"/>
        <source>%1%2 m for each press of %3</source>
        <translation>%1%2 m à chaque appui sur %3</translation>
    </message>
    <message>
        <location filename="control_strip.cpp"/>
        <source>%1%2 m. It has no key yet; set one in the inspector.</source>
        <translation>%1%2 m. Pas encore de touche ; en choisir une dans l’inspecteur.</translation>
    </message>
    <message>
        <location filename="control_strip.cpp"/>
        <source>No controls. Add one in the outline to steer with keys.</source>
        <translation>Aucune commande. En ajouter une dans l’arborescence pour piloter au clavier.</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>%1 is empty: a table of time (s), control and value (m) is wanted.</source>
        <translation>%1 est vide : on attend un tableau de temps (s), commande et valeur (m).</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>%1, line %2: %3</source>
        <translation>%1, ligne %2 : %3</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>there is no control "%1".</source>
        <translation>il n’y a pas de commande « %1 ».</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>there is no control "%1"; did you mean "%2"?</source>
        <translation>il n’y a pas de commande « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>there is no control "%1"; the scene has none.</source>
        <translation>il n’y a pas de commande « %1 » ; la scène n’en a aucune.</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>time (s) and value (m) must be finite numbers.</source>
        <translation>le temps (s) et la valeur (m) doivent être des nombres finis.</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>time (s) must be a finite number.</source>
        <translation>le temps (s) doit être un nombre fini.</translation>
    </message>
    <message>
        <location filename="control_track.cpp"/>
        <source>write TIME,CONTROL,VALUE.</source>
        <translation>écrire TEMPS,COMMANDE,VALEUR.</translation>
    </message>
    <message>
        <location filename="copy.cpp"/>
        <source>Array in a ring</source>
        <translation>Répétition circulaire</translation>
    </message>
    <message>
        <location filename="copy.cpp"/>
        <source>Array in a row</source>
        <translation>Répétition linéaire</translation>
    </message>
    <message>
        <location filename="copy.cpp"/>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <location filename="curve_figure.cpp"/>
        <source>The scene has no probes, so there is nothing to draw in %1; add a probe first.</source>
        <translation>La scène n’a pas de sondes, il n’y a donc rien à tracer dans %1 ; ajouter d’abord une sonde.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>&amp;Other design…</source>
        <translation>&amp;Autre modèle…</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>&amp;Select all that differs</source>
        <translation>&amp;Sélectionner tout ce qui diffère</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>A row selects in the view what it tells of.</source>
        <translation>Une ligne sélectionne dans la vue ce dont elle parle.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>A scene, or a recording with the design that it began with.</source>
        <translation>Une scène, ou un enregistrement avec le modèle par lequel il a commencé.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>As sa&amp;ved</source>
        <translation>Tel qu’&amp;enregistré</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>Choose a design to compare with.</source>
        <translation>Choisissez un modèle à comparer.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>Compare designs</source>
        <translation>Comparer des modèles</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>From %1: %2</source>
        <translation>De %1 : %2</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>From the design as saved: %1</source>
        <translation>Du modèle tel qu’enregistré : %1</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>Scenes and recordings (*.ripstop.json *.ripstop-run);;All files (*)</source>
        <translation>Scènes et enregistrements (*.ripstop.json *.ripstop-run);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>Show the other one as a &amp;ghost</source>
        <translation>Montrer l’autre en &amp;fantôme</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>The design as its file has it: what you have changed since.</source>
        <translation>Le modèle tel que son fichier le contient : ce que vous avez changé depuis.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>The open design has no file yet.</source>
        <translation>Le modèle ouvert n’a pas encore de fichier.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>The two say the same.</source>
        <translation>Les deux disent la même chose.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>There is nothing to compare with.</source>
        <translation>Il n’y a rien à comparer.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>They differ in %1 things.</source>
        <translation>Ils diffèrent en %1 points.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>They differ in 1 thing.</source>
        <translation>Ils diffèrent en 1 point.</translation>
    </message>
    <message>
        <location filename="design_difference_dialog.cpp"/>
        <source>To the open design: %1</source>
        <translation>Au modèle ouvert : %1</translation>
    </message>
    <message>
        <location filename="design_gallery.cpp"/>
        <source>%1 is %2. </source>
        <translation>%1 vaut %2. </translation>
    </message>
    <message>
        <location filename="design_gallery.cpp"/>
        <source>Best designs</source>
        <translation>Meilleurs modèles</translation>
    </message>
    <message>
        <location filename="design_picture.cpp"/>
        <source>The picture could not be made (%1).</source>
        <translation>L’image n’a pas pu être faite (%1).</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Align</source>
        <translation>&amp;Aligner</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Design</source>
        <translation>&amp;Modèle</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Flatten</source>
        <translation>Aplat&amp;ir</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Heavier</source>
        <translation>Plus l&amp;ourd</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Lighter</source>
        <translation>Plus &amp;léger</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Move</source>
        <translation>Dé&amp;placer</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Rotate</source>
        <translation>&amp;Tourner</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Scale</source>
        <translation>Mettre à l’é&amp;chelle</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Softer</source>
        <translation>Plus &amp;souple</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>&amp;Weaker</source>
        <translation>Moins &amp;résistant</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Add the other half of what is selected, in one piece with it.</source>
        <translation>Ajouter l’autre moitié de la sélection, d’un seul tenant avec elle.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Along %1</source>
        <translation>Le long de %1</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Array in a rin&amp;g…</source>
        <translation>Répétition circ&amp;ulaire…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Array in a ro&amp;w…</source>
        <translation>Répétition &amp;linéaire…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Bring all to the greatest %1 of what is selected.</source>
        <translation>Amener tout au plus grand %1 de la sélection.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Bring all to the least %1 of what is selected.</source>
        <translation>Amener tout au plus petit %1 de la sélection.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Bring all to the middle of what is selected along %1.</source>
        <translation>Amener tout au milieu de la sélection le long de %1.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copied.</source>
        <translation>Copié.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copies around an axis: gores, spokes.</source>
        <translation>Des copies autour d’un axe : fuseaux, rayons.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copies in a row: ribs, rows of lines.</source>
        <translation>Des copies en ligne : nervures, rangées de suspentes.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copy what is selected within its part, and move the copy.</source>
        <translation>Copier la sélection dans sa pièce, et déplacer la copie.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copy what is selected, and remove it.</source>
        <translation>Copier la sélection, et la supprimer.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Copy what is selected, with the links and panels among it, for this or another scene.</source>
        <translation>Copier la sélection, avec ses liaisons et panneaux, pour cette scène ou une autre.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Cu&amp;t</source>
        <translation>&amp;Couper</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>D&amp;istribute</source>
        <translation>Répart&amp;ir</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>D&amp;uplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Even steps along %1 between the outermost ones.</source>
        <translation>Pas égaux le long de %1 entre les deux extrêmes.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Free along a line or &amp;in a plane…</source>
        <translation>L&amp;ibre sur une ligne ou dans un plan…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Give the selected particles mass: each, by length, by area, or a total to share.</source>
        <translation>Donner une masse aux particules sélectionnées : chacune, par longueur, par aire, ou un total à répartir.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Have the panels of the selected parts carry the pull of their fabric, in place of threads.</source>
        <translation>Faire porter la traction du tissu par les panneaux des pièces sélectionnées, à la place des fils.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Hold the selected particles where they are, or let them go when all are held.</source>
        <translation>Tenir en place les particules sélectionnées, ou les lâcher quand toutes sont tenues.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Least %1</source>
        <translation>%1 minimal</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Let the selected particles slide along a line or in a plane only, as rings on a rail: along x, y or z, or as two or three selected particles lie.</source>
        <translation>Laisser les particules sélectionnées glisser seulement le long d’une ligne ou dans un plan, comme des anneaux sur un rail : le long de x, y ou z, ou selon deux ou trois particules sélectionnées.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>M&amp;ass…</source>
        <translation>&amp;Masse…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Make one particle of those that lie together, or of all that are selected.</source>
        <translation>Faire une seule particule de celles qui sont confondues, ou de toutes celles qui sont sélectionnées.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Make several links of each selected one, with particles between them.</source>
        <translation>Faire plusieurs liaisons de chaque liaison sélectionnée, avec des particules entre elles.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Make what is selected larger or smaller: pull a box or the middle, or type a factor.</source>
        <translation>Agrandir ou réduire la sélection : tirer un cube ou le centre, ou taper un facteur.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Map by a form&amp;ula…</source>
        <translation>Carte par une form&amp;ule…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Mate&amp;rial</source>
        <translation>Maté&amp;riau</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Middle %1</source>
        <translation>%1 médian</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Mirr&amp;or…</source>
        <translation>S&amp;ymétrie…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Most %1</source>
        <translation>%1 maximal</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Move what is selected: pull an arrow, a square or the middle, or type how far.</source>
        <translation>Déplacer la sélection : tirer une flèche, un carré ou le centre, ou taper la distance.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Pi&amp;n or unpin</source>
        <translation>&amp;Fixer ou libérer</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Pinned.</source>
        <translation>Fixé.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Put what is selected into the plane that fits it best.</source>
        <translation>Mettre la sélection dans le plan qui lui convient le mieux.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Put what was copied into this scene, as a part of its own, and move it.</source>
        <translation>Mettre ce qui a été copié dans cette scène, comme pièce à part, et le déplacer.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>S&amp;plit links…</source>
        <translation>Di&amp;viser les liaisons…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>S&amp;tiffer</source>
        <translation>Plus &amp;raide</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Select particles to pin.</source>
        <translation>Sélectionner des particules à fixer.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Select three or more particles to flatten.</source>
        <translation>Sélectionner au moins trois particules à aplatir.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Select three or more things to distribute.</source>
        <translation>Sélectionner au moins trois choses à répartir.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Select two or more things to align.</source>
        <translation>Sélectionner au moins deux choses à aligner.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Select what is to be copied first.</source>
        <translation>Sélectionner d’abord ce qui est à copier.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Set a number of what is selected, such as the tear limit, by a formula of where it lies or by a picture: worn places, patches, a grain that fans out.</source>
        <translation>Fixer un nombre de ce qui est sélectionné, comme la limite de déchirure, par une formule de sa position ou par une image : endroits usés, renforts, droit-fil en éventail.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Smoo&amp;th…</source>
        <translation>Li&amp;sser…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Str&amp;onger</source>
        <translation>Plus rés&amp;istant</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>T&amp;hreads to panels…</source>
        <translation>&amp;Fils en panneaux…</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Take bumps and creases out of the selected fabric and lines.</source>
        <translation>Ôter les bosses et les plis du tissu et des lignes sélectionnés.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next heavier material of the library for what is selected; masses follow.</source>
        <translation>Le matériau suivant, plus lourd, de la bibliothèque pour ce qui est sélectionné ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next lighter material of the library for what is selected; masses follow.</source>
        <translation>Le matériau suivant, plus léger, de la bibliothèque pour ce qui est sélectionné ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next softer material of the library for what is selected, by E t, EA or EI; masses follow.</source>
        <translation>Le matériau suivant, plus souple, de la bibliothèque pour ce qui est sélectionné, selon E t, EA ou EI ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next stiffer material of the library for what is selected, by E t, EA or EI; masses follow.</source>
        <translation>Le matériau suivant, plus raide, de la bibliothèque pour ce qui est sélectionné, selon E t, EA ou EI ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next stronger material of the library for what is selected, by what it can bear; masses follow.</source>
        <translation>Le matériau suivant, plus résistant, de la bibliothèque pour ce qui est sélectionné, selon ce qu’il supporte ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>The next weaker material of the library for what is selected; masses follow.</source>
        <translation>Le matériau suivant, moins résistant, de la bibliothèque pour ce qui est sélectionné ; les masses suivent.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Turn what is selected: pull a ring, or type an angle.</source>
        <translation>Tourner la sélection : tirer un anneau, ou taper un angle.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>Unpinned.</source>
        <translation>Libéré.</translation>
    </message>
    <message>
        <location filename="design_rows.cpp"/>
        <source>W&amp;eld…</source>
        <translation>&amp;Souder…</translation>
    </message>
    <message>
        <location filename="detail.cpp"/>
        <source>light</source>
        <translation>légère</translation>
    </message>
    <message>
        <location filename="detail.cpp"/>
        <source>moderate</source>
        <translation>modérée</translation>
    </message>
    <message>
        <location filename="detail.cpp"/>
        <source>severe</source>
        <translation>forte</translation>
    </message>
    <message>
        <location filename="detail.cpp"/>
        <source>tears</source>
        <translation>se déchire</translation>
    </message>
    <message>
        <location filename="dialogs.cpp"/>
        <source>Plots</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <location filename="dialogs.cpp"/>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <location filename="difference_dialog.cpp"/>
        <source>%1 and %2: distance of their particles</source>
        <translation>%1 et %2 : distance de leurs particules</translation>
    </message>
    <message>
        <location filename="difference_dialog.cpp"/>
        <source>%1 s: %2 root mean square, %3 at most (particle %4)</source>
        <translation>%1 s : moyenne quadratique %2, au plus %3 (particule %4)</translation>
    </message>
    <message>
        <location filename="difference_dialog.cpp"/>
        <source>Coloured: the particle that is farthest off. Plain: the root mean square of all %1. Click to look at that time.</source>
        <translation>En couleur : la particule la plus éloignée. Simple : la moyenne quadratique des %1. Cliquer pour regarder ce moment.</translation>
    </message>
    <message>
        <location filename="difference_dialog.cpp"/>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <location filename="difference_dialog.cpp"/>
        <source>The two have no particle in common: they are of other designs.</source>
        <translation>Les deux n’ont aucune particule en commun : elles sont d’autres modèles.</translation>
    </message>
    <message>
        <location filename="display_check.cpp"/>
        <source>Ripstop cannot open its window: %1</source>
        <translation>Ripstop ne peut pas ouvrir sa fenêtre : %1</translation>
    </message>
    <message>
        <location filename="display_check.cpp"/>
        <source>Start it on a desktop, or as "xvfb-run -a ripstop" where there is none; with LIBGL_ALWAYS_SOFTWARE=1 it draws without a graphics card. ripstop-cli needs no window.</source>
        <translation>Lancez-le sur un bureau, ou par « xvfb-run -a ripstop » là où il n’y en a pas ; avec LIBGL_ALWAYS_SOFTWARE=1, il dessine sans carte graphique. ripstop-cli n’a pas besoin de fenêtre.</translation>
    </message>
    <message>
        <location filename="display_check.cpp"/>
        <source>the platform "%1" has no OpenGL %2.%3, which the view in three dimensions needs. %4</source>
        <translation>la plateforme « %1 » n’a pas OpenGL %2.%3, dont la vue en trois dimensions a besoin. %4</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Click a step to go back to it, or forward again.</source>
        <translation>Cliquer une étape pour y revenir, ou y retourner.</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Everything that the scene is made of: parts, materials, groups, controls, colliders. The tab History goes back to any step.</source>
        <translation>Tout ce dont la scène est faite : pièces, matériaux, groupes, commandes, obstacles. L’onglet Historique revient à n’importe quelle étape.</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Loads</source>
        <translation>Charges</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Measure it</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Outline</source>
        <translation>Arborescence</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Problems (%1)</source>
        <translation>Problèmes (%1)</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Strain, energy, forces and probes as they happen. Problems of the design stand beside, each with a click to what it is about.</source>
        <translation>Déformation, énergie, forces et sondes en direct. Les problèmes du modèle sont à côté, chacun à un clic de ce qu’il concerne.</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>The design as it was opened</source>
        <translation>Le modèle tel qu’il a été ouvert</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>The values of what is selected, one thing or thousands. Type with units (12 cm, 25 g), drag a label sideways, or change a value while the simulation runs.</source>
        <translation>Les valeurs de la sélection, une chose ou des milliers. Taper avec des unités (12 cm, 25 g), faire glisser un libellé de côté, ou changer une valeur pendant que la simulation tourne.</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <location filename="dock_table.cpp"/>
        <source>Tuning</source>
        <translation>Mise au point</translation>
    </message>
    <message>
        <location filename="document.cpp"/>
        <source>untitled</source>
        <translation>sans titre</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>(new material)</source>
        <translation>(nouveau matériau)</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>(new part)</source>
        <translation>(nouvelle pièce)</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>A click on a panel puts the particle there, and not in the plane.</source>
        <translation>Un clic sur un panneau y met la particule, et non dans le plan.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Click from particle to particle, or where one is to be. The last one again, or Esc, ends the line.</source>
        <translation>Cliquer de particule en particule, ou là où il en faut une. De nouveau la dernière, ou Échap, termine la ligne.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Click the three corners. Esc begins again.</source>
        <translation>Cliquer les trois coins. Échap recommence.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Click where they are to be: in the plane, on fabric. A right drag turns the view.</source>
        <translation>Cliquer là où elles doivent être : dans le plan, sur le tissu. Glisser du bouton droit tourne la vue.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Draw links</source>
        <translation>Dessiner des liaisons</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Draw panels</source>
        <translation>Dessiner des panneaux</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Draw particles</source>
        <translation>Dessiner des particules</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Facing plane</source>
        <translation>Plan face à la vue</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Front plane</source>
        <translation>Plan de face</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Level plane</source>
        <translation>Plan horizontal</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Of new links and panels.</source>
        <translation>Des nouvelles liaisons et des nouveaux panneaux.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>On fabric</source>
        <translation>Sur le tissu</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Rods</source>
        <translation>Tiges</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Rods keep their length, lines only do not grow longer, springs pull with a force.</source>
        <translation>Les tiges gardent leur longueur, les lignes ne s’allongent pas, les ressorts tirent avec une force.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Side plane</source>
        <translation>Plan de profil</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Springs</source>
        <translation>Ressorts</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Where new particles go. Links and panels go to the part of their first particle.</source>
        <translation>Où vont les nouvelles particules. Liaisons et panneaux vont dans la pièce de leur première particule.</translation>
    </message>
    <message>
        <location filename="draw_bar.cpp"/>
        <source>Where places off the fabric lie: in a plane through the particle that was clicked last, or through the origin.</source>
        <translation>Où se trouvent les points hors du tissu : dans un plan par la dernière particule cliquée, ou par l’origine.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>A rope runs between two particles: select these two.</source>
        <translation>Un cordage court entre deux particules : sélectionner ces deux-là.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>All to one needs exactly one particle that is no corner of a panel, as a tow point is: select it together with those that it holds.</source>
        <translation>Toutes à une seule demande exactement une particule qui ne soit sommet d’aucun panneau, comme un point d’attache : sélectionnez-la avec celles qu’elle tient.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Each with each of more than %1 particles are too many links. Select fewer, or choose another way.</source>
        <translation>Chacune à chacune de plus de %1 particules fait trop de liaisons. En sélectionner moins, ou choisir une autre façon.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Fill</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Rigidity particles</source>
        <translation>Particules de rigidité</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Rope</source>
        <translation>Cordage</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Select the particles along the spar first.</source>
        <translation>Sélectionner d’abord les particules le long du longeron.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Select the particles that are to become stiff first.</source>
        <translation>Sélectionner d’abord les particules qui doivent devenir raides.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Select three or more particles around the hole first.</source>
        <translation>Sélectionner d’abord au moins trois particules autour du trou.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>Select two or more particles first.</source>
        <translation>Sélectionner d’abord au moins deux particules.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>There are panels on all of these particles already.</source>
        <translation>Il y a déjà des panneaux sur toutes ces particules.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>These particles are linked already, or lie in one place. Nothing is added.</source>
        <translation>Ces particules sont déjà liées, ou sont au même endroit. Rien n’est ajouté.</translation>
    </message>
    <message>
        <location filename="draw_operations.cpp"/>
        <source>These particles are linked already, or lie in one place. Take more links.</source>
        <translation>Ces particules sont déjà liées, ou sont au même endroit. Prendre plus de liaisons.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>&amp;Fill with panels…</source>
        <translation>&amp;Remplir de panneaux…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>&amp;Links</source>
        <translation>&amp;Liaisons</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>&amp;Particles</source>
        <translation>&amp;Particules</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>&amp;Rope…</source>
        <translation>&amp;Cordage…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>&amp;Spar…</source>
        <translation>L&amp;ongeron…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>A rope or line of many links between two selected particles.</source>
        <translation>Un cordage ou une ligne de plusieurs liaisons entre deux particules sélectionnées.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>A stiff spar along the selected particles.</source>
        <translation>Un longeron raide le long des particules sélectionnées.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Click from particle to particle, or where one is to be: rods, lines, springs, ropes of many segments.</source>
        <translation>Cliquer de particule en particule, ou là où il en faut une : tiges, lignes, ressorts, cordages à plusieurs segments.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Click the three corners of a panel.</source>
        <translation>Cliquer les trois coins d’un panneau.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Click where particles are to be: in a plane, on fabric.</source>
        <translation>Cliquer là où doivent être les particules : dans un plan, sur le tissu.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Close the hole that the selected particles surround.</source>
        <translation>Fermer le trou que les particules sélectionnées entourent.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>D&amp;raw</source>
        <translation>&amp;Dessin</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Drag over fabric to make it stronger or weaker, stiffer or softer, or to turn its grain: patches, reinforcements, worn places.</source>
        <translation>Tirer sur le tissu pour le rendre plus ou moins résistant, plus raide ou plus souple, ou pour tourner son droit-fil : pièces, renforts, endroits usés.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>In which ways the selection, or the design, gives way without a link growing longer, and the rods that would stop it.</source>
        <translation>De quelles façons la sélection, ou le modèle, cède sans qu’une liaison s’allonge, et les tiges qui l’empêcheraient.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>L&amp;ink selected…</source>
        <translation>Lier la &amp;sélection…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Make the radius of the brush larger.</source>
        <translation>Agrandir le rayon du pinceau.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Make the radius of the brush smaller.</source>
        <translation>Réduire le rayon du pinceau.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Narrower brush</source>
        <translation>Pinceau plus étroit</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>P&amp;anels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Paint with a &amp;brush</source>
        <translation>Peindre au &amp;pinceau</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Particles on both sides of the selected ones, tied to each, so that they keep their shape.</source>
        <translation>Des particules de part et d’autre de celles sélectionnées, attachées à chacune, pour qu’elles gardent leur forme.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Ri&amp;gidity particles…</source>
        <translation>Particules de ri&amp;gidité…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Tie the selected particles to each other, in a line, a ring, or each with each.</source>
        <translation>Attacher les particules sélectionnées les unes aux autres, en ligne, en anneau, ou chacune à chacune.</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>What gives &amp;way…</source>
        <translation>Ce &amp;qui cède…</translation>
    </message>
    <message>
        <location filename="draw_rows.cpp"/>
        <source>Wider brush</source>
        <translation>Pinceau plus large</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>
%1 m long</source>
        <translation>
%1 m de long</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>A panel. The next one begins with the next click.</source>
        <translation>Un panneau. Le suivant commence au prochain clic.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>A particle at %1.</source>
        <translation>Une particule en %1.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Click the other corners of the panel.</source>
        <translation>Cliquer les autres coins du panneau.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Click where the link ends; click the last particle again to stop.</source>
        <translation>Cliquer là où finit la liaison ; recliquer la dernière particule pour arrêter.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Draw a link</source>
        <translation>Dessiner une liaison</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Draw a panel</source>
        <translation>Dessiner un panneau</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Draw a particle</source>
        <translation>Dessiner une particule</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>Ended.</source>
        <translation>Terminé.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>The plane is seen on edge here: turn the view, or choose another plane.</source>
        <translation>Le plan est vu de chant ici : tourner la vue, ou choisir un autre plan.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>There is a particle here already.</source>
        <translation>Il y a déjà une particule ici.</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>cloth</source>
        <translation>toile</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>cord</source>
        <translation>cordelette</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <location filename="draw_tool.cpp"/>
        <source>on a particle</source>
        <translation>sur une particule</translation>
    </message>
    <message>
        <location filename="edit.cpp"/>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>&amp;Find in outline</source>
        <translation>Rec&amp;hercher dans l’arborescence</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Make the last edit again that was taken back.</source>
        <translation>Refaire la dernière modification annulée.</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Pre&amp;ferences…</source>
        <translation>Pré&amp;férences…</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Remove what is selected, and all that hangs on it.</source>
        <translation>Supprimer la sélection et tout ce qui y est attaché.</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Search the outline by name.</source>
        <translation>Chercher par nom dans l’arborescence.</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Take back the last edit.</source>
        <translation>Annuler la dernière modification.</translation>
    </message>
    <message>
        <location filename="edit_rows.cpp"/>
        <source>Theme, language and memory, on one page.</source>
        <translation>Thème, langue et mémoire, sur une page.</translation>
    </message>
    <message>
        <location filename="edit_words.cpp"/>
        <source>Set %1 of %2</source>
        <translation>Régler %1 de %2</translation>
    </message>
    <message>
        <location filename="edit_words.cpp"/>
        <source>Set %1 of %2 to %3</source>
        <translation>Régler %1 de %2 à %3</translation>
    </message>
    <message>
        <location filename="edit_words.cpp"/>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <location filename="edit_words.cpp"/>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>%1 has panels that carry the pull of its fabric and %2 threads that carry it as well: remove the threads, or have threads carry it.</source>
        <translation>%1 a des panneaux qui portent la traction de son tissu et %2 fils qui la portent aussi : supprimez les fils, ou faites-la porter par les fils.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Material %1 has panels stiffer than %2 N/m, which no step can solve and no fabric is: check the unit.</source>
        <translation>Le matériau %1 a des panneaux plus raides que %2 N/m, ce qu’aucun pas ne peut résoudre et qu’aucun tissu n’est : vérifiez l’unité.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Material %1 would get energy out of being strained: its Poisson's ratio must be below %2, the root of warp over weft stiffness.</source>
        <translation>Le matériau %1 gagnerait de l’énergie à être déformé : son coefficient de Poisson doit être sous %2, la racine du rapport des raideurs de chaîne et de trame.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panel %1 of %2 has no area at rest, and its part has panels carry the pull: change its rest lengths, or remove it.</source>
        <translation>Le panneau %1 de %2 n’a pas d’aire au repos, et sa pièce fait porter la traction par les panneaux : changez ses longueurs à vide, ou supprimez-le.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 are to carry its pull and have no material: they carry nothing.</source>
        <translation>Les panneaux de %1 doivent porter sa traction et n’ont pas de matériau : ils ne portent rien.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 are to carry its pull, and %2 has no membrane stiffness: they carry nothing.</source>
        <translation>Les panneaux de %1 doivent porter sa traction, et %2 n’a pas de raideur de membrane : ils ne portent rien.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 do not tear across the warp of %2, which tears by strength and has no weft strength: type it.</source>
        <translation>Les panneaux de %1 ne se déchirent pas en travers de la chaîne de %2, qui cède par résistance et n’a pas de résistance en trame : saisissez-la.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 do not tear along the warp of %2, which tears by strength and has no warp strength: type it.</source>
        <translation>Les panneaux de %1 ne se déchirent pas dans le sens de la chaîne de %2, qui cède par résistance et n’a pas de résistance en chaîne : saisissez-la.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 do not tear: %2 tears by length or force, which are of links. Choose tension, strength or strain.</source>
        <translation>Les panneaux de %1 ne se déchirent pas : %2 cède par longueur ou par force, qui sont celles des liaisons. Choisissez tension, résistance ou déformation.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Panels of %1 do not tear: %2 tears by strength, and has none along its warp or across it. Type its warp and weft strength.</source>
        <translation>Les panneaux de %1 ne se déchirent pas : %2 cède par résistance et n’en a ni en chaîne ni en trame. Saisissez ses résistances en chaîne et en trame.</translation>
    </message>
    <message>
        <location filename="elastic_check.cpp"/>
        <source>Tears in panels of %1 go on by its strengths: %2 tears by energy and has no tear strength. Type it, or choose strength.</source>
        <translation>Les déchirures des panneaux de %1 avancent selon ses résistances : %2 cède par énergie et n’a pas de résistance à la déchirure. Saisissez-la, ou choisissez strength.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>%1 is no number of particles, links or panels.</source>
        <translation>%1 n’est pas un nombre de particules, de liaisons ou de panneaux.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>At %1 %2 the formula gives %3, and %4 %5.</source>
        <translation>À %1 %2 la formule donne %3, et %4 %5.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>At %1 %2 the formula gives no finite number: check what it divides by, and of what it takes the root or the logarithm.</source>
        <translation>Pour %1 %2, la formule ne donne pas de nombre fini : vérifiez par quoi elle divise, et de quoi elle prend la racine ou le logarithme.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>Map of %1</source>
        <translation>Carte de « %1 »</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>The formula asks for "%1"; it can ask for %2.</source>
        <translation>La formule demande « %1 » ; elle peut demander %2.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>The formula asks for grey, and there is no picture: name one.</source>
        <translation>La formule demande grey, et il n’y a pas d’image : nommez-en une.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>The formula asks for the value of link %1, which has none: its material never tears. Choose what it tears by, or leave out value.</source>
        <translation>La formule demande la valeur (value) de la liaison %1, qui n’en a pas : son matériau ne se déchire jamais. Choisissez selon quoi il se déchire, ou omettez value.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>The formula is empty; write one of %1.</source>
        <translation>La formule est vide ; en écrire une avec %1.</translation>
    </message>
    <message>
        <location filename="element_map.cpp"/>
        <source>There is no %1 to map.</source>
        <translation>Il n’y a rien de la sorte « %1 » à fixer.</translation>
    </message>
    <message>
        <location filename="empty_hint.cpp"/>
        <source>This scene is empty: it has no ground either.

Insert brings in a whole kite, glider, parachute or cloth.
File, Import makes fabric of a mesh (Ctrl+Shift+I).
Draw, Links draws one particle after the other (D).</source>
        <translation>Cette scène est vide : elle n’a pas de sol non plus.

Insertion amène un cerf-volant, un deltaplane, un parachute ou une toile.
Fichier, Importer fait du tissu d’un maillage (Ctrl+Maj+I).
Dessin, Liaisons dessine une particule après l’autre (D).</translation>
    </message>
    <message>
        <location filename="end_check.cpp"/>
        <source>Particle %1 is %2 m away from the origin at the end, farther than %3 m, where weight would be another one: look for what drives it away.</source>
        <translation>La particule %1 est à %2 m de l’origine à la fin, plus loin que %3 m, où la pesanteur serait une autre : chercher ce qui l’éloigne.</translation>
    </message>
    <message>
        <location filename="end_check.cpp"/>
        <source>The energies are not finite at the end: look for stiffnesses and masses that are far too large.</source>
        <translation>Les énergies ne sont pas finies à la fin : chercher des raideurs et des masses bien trop grandes.</translation>
    </message>
    <message>
        <location filename="end_check.cpp"/>
        <source>The largest strain of a panel is %1 at the end, and no material bears %2: look for what pulls it out of its place.</source>
        <translation>La plus grande déformation d’un panneau est de %1 à la fin, et aucun matériau ne supporte %2 : chercher ce qui l’arrache de sa place.</translation>
    </message>
    <message>
        <location filename="end_check.cpp"/>
        <source>The strain of link %1 is %2 at the end, and no material bears %3: look for what pulls it out of its place, like a collider that it is in.</source>
        <translation>La déformation de la liaison %1 est de %2 à la fin, et aucun matériau ne supporte %3 : chercher ce qui l’arrache de sa place, comme un obstacle dans lequel il se trouve.</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 leaves %2</source>
        <translation>%1 quitte %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 lines go slack, that of link %2 first</source>
        <translation>%1 lignes se détendent, d'abord celle de la liaison %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 lines go taut, that of link %2 first</source>
        <translation>%1 lignes se tendent, d'abord celle de la liaison %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 places tore, the first is %2</source>
        <translation>déchirure en %1 endroits, d’abord : %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 s: %2</source>
        <translation>%1 s : %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 tore</source>
        <translation>déchirure : %1</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1 touches %2</source>
        <translation>%1 touche %2</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1, and %2 more in this step</source>
        <translation>%1, et %2 de plus dans ce pas</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1, in %2, which peaks at %3</source>
        <translation>%1, dans %2, dont le sommet est de %3</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>%1, in gust %2 of %3, which peaks at %4</source>
        <translation>%1, dans la rafale %2 de %3, dont le sommet est de %4</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>a control was moved</source>
        <translation>une commande a été déplacée</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>something was done by hand</source>
        <translation>quelque chose a été fait à la main</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>the design was edited</source>
        <translation>le modèle a été modifié</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>the line of link %1 goes slack</source>
        <translation>la ligne de la liaison %1 se détend</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>the line of link %1 goes taut</source>
        <translation>la ligne de la liaison %1 se tend</translation>
    </message>
    <message>
        <location filename="event_words.cpp"/>
        <source>the simulation could not go on</source>
        <translation>la simulation n'a pas pu continuer</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 frames of %2 × %3 pixels, about %4.</source>
        <translation>%1 images de %2 × %3 pixels, environ %4.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 frames of %2 × %3 pixels.</source>
        <translation>%1 images de %2 × %3 pixels.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 frames, about %2.</source>
        <translation>%1 images, environ %2.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 is there and will be replaced.</source>
        <translation>%1 est là et sera remplacé.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 of these files are there and will be replaced.</source>
        <translation>%1 de ces fichiers sont là et seront remplacés.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>%1, and the materials in %2</source>
        <translation>%1, et les matériaux dans %2</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>A row for each link that broke: when, where, at which strain and force.</source>
        <translation>Un rang pour chaque liaison rompue : quand, où, à quelle déformation et quelle force.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Bundle of the whole run, ZIP</source>
        <translation>Dossier de toute la simulation, ZIP</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Control track of this run, CSV</source>
        <translation>Piste des commandes de cette simulation, CSV</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Films of this kind have an even number of pixels in each direction: the last column or row is left out.</source>
        <translation>Les films de cette sorte ont un nombre pair de pixels dans chaque sens : la dernière colonne ou ligne est laissée de côté.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>For a paper or a colleague: ripstop-cli run flies it again and compares every step.</source>
        <translation>Pour un article ou un collègue : ripstop-cli run la refait et compare chaque pas.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>In it are the scene, what was done by hand, the recording, the probes as a table and a figure, a picture of the view, and the command lines that make all of it again.</source>
        <translation>Il contient la scène, ce qui a été fait à la main, l’enregistrement, les sondes en tableau et en figure, une image de la vue et les lignes de commande qui refont le tout.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Links that broke in the run on the screen: %1, the first at %2 s. In the design, the tears reach %3 m from there; they released %4 J.</source>
        <translation>Liaisons rompues dans la simulation à l’écran : %1, la première à %2 s. Dans le modèle, les déchirures s’étendent jusqu’à %3 m de là ; elles ont libéré %4 J.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>No control and no hand has moved anything in this run.</source>
        <translation>Aucune commande et aucune main n’a rien bougé dans cette simulation.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Nothing has torn in the run on the screen: the table will be empty.</source>
        <translation>Rien ne s’est déchiré dans la simulation à l’écran : le tableau sera vide.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Table of what has torn, CSV</source>
        <translation>Tableau des déchirures, CSV</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>The shape at %1 s, when this was opened, about %2.</source>
        <translation>La forme à %1 s, à l’ouverture de ce dialogue, environ %2.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>What the pilot and your hands did in this run: %1 commands, %2 moves of the hand.</source>
        <translation>Ce que le pilote et vos mains ont fait dans cette simulation : %1 commandes, %2 gestes de la main.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>Writes %1.</source>
        <translation>Écrit %1.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>ripstop-cli run --controls does it again, in this or another design.</source>
        <translation>ripstop-cli run --controls la refait, dans ce modèle ou un autre.</translation>
    </message>
    <message>
        <location filename="export_choice.cpp"/>
        <source>the folder %1</source>
        <translation>le dossier %1</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source> per s</source>
        <translation> par s</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>&amp;Legend and compass</source>
        <translation>&amp;Légende et boussole</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>&amp;Probes that are plotted</source>
        <translation>&amp;Sondes tracées</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>&amp;Speed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>&amp;To</source>
        <translation>&amp;À</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Choose the file</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Do again what the pilot and your hands did</source>
        <translation>Refaire ce que le pilote et vos mains ont fait</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Export as</source>
        <translation>Exporter sous</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>F&amp;light</source>
        <translation>&amp;Vol</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>F&amp;rom</source>
        <translation>&amp;De</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Fi&amp;le</source>
        <translation>F&amp;ichier</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Frames per second: of simulated time for meshes and tables, of the film for films.</source>
        <translation>Images par seconde : de temps simulé pour les maillages et tableaux, de film pour les films.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Give the file a name before its ending.</source>
        <translation>Donnez au fichier un nom avant son extension.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>How fast the film shows the flight; 0.1 is ten times slower than it is.</source>
        <translation>À quelle vitesse le film montre le vol ; 0,1 est dix fois plus lent qu’en vrai.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>It is taken from the recording, as it was flown.</source>
        <translation>C’est pris de l’enregistrement, tel que cela a volé.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>No flight is recorded, so the scene is simulated anew from its start.</source>
        <translation>Aucun vol n’est enregistré : la scène est simulée à nouveau depuis son départ.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Pi&amp;ns</source>
        <translation>É&amp;pingles</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>R&amp;ate</source>
        <translation>&amp;Cadence</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Si&amp;ze</source>
        <translation>Tai&amp;lle</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Simulated anew from the start of the scene</source>
        <translation>Simulé de nouveau depuis le début de la scène</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>T&amp;ime</source>
        <translation>T&amp;emps</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>The marks of particles that are held in place.</source>
        <translation>Les marques des particules qui sont tenues en place.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>The run as it was recorded</source>
        <translation>La simulation telle qu’elle a été enregistrée</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>The scene is simulated anew from its start.</source>
        <translation>La scène est simulée de nouveau depuis son début.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>The series ends before it begins: make To later than From.</source>
        <translation>La série finit avant de commencer : choisir À après De.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>There is no folder %1; choose another.</source>
        <translation>Il n’y a pas de dossier %1 ; en choisir un autre.</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Transparent &amp;background</source>
        <translation>&amp;Fond transparent</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <location filename="export_dialog.cpp"/>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>%1 and %2 more exist already. Replace them?</source>
        <translation>%1 et %2 autres existent déjà. Les remplacer ?</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 existe déjà. Le remplacer ?</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>Cancelled; nothing was kept.</source>
        <translation>Annulé ; rien n’a été gardé.</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>Replace what is there?</source>
        <translation>Remplacer ce qui est là ?</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>There is nothing on the screen to export; see the list of problems.</source>
        <translation>Il n’y a rien à exporter à l’écran ; voir la liste des problèmes.</translation>
    </message>
    <message>
        <location filename="export_dialog_work.cpp"/>
        <source>the picture could not be saved</source>
        <translation>l’image n’a pas pu être enregistrée</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>%1 Nothing was written.</source>
        <translation>%1 Rien n’a été écrit.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>%1 What was written ends there.</source>
        <translation>%1 Ce qui est écrit finit là.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>%1 has no known ending: %2.</source>
        <translation>%1 n’a pas de fin connue : %2.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>%1 is a series; for one moment %2.</source>
        <translation>%1 est une série ; pour un seul instant %2.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>It was cancelled; nothing was written.</source>
        <translation>C’est annulé ; rien n’a été écrit.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>It was cancelled; what was written has been removed.</source>
        <translation>C’est annulé ; ce qui était écrit a été retiré.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>The end of the range must not lie before its start.</source>
        <translation>La fin de l’intervalle ne doit pas précéder son début.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>The number of frames per second must be above 0.</source>
        <translation>Le nombre d’images par seconde doit être supérieur à 0.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>The range starts at %1, but the run begins only at %2.</source>
        <translation>L’intervalle commence à %1, mais la simulation ne commence qu’à %2.</translation>
    </message>
    <message>
        <location filename="export_run.cpp"/>
        <source>The range starts at %1, but the run ends at %2.</source>
        <translation>L’intervalle commence à %1, mais la simulation finit à %2.</translation>
    </message>
    <message>
        <location filename="fabric_air.cpp"/>
        <source>air on fabric</source>
        <translation>l’air sur la toile</translation>
    </message>
    <message>
        <location filename="fabric_check.cpp"/>
        <source>%1 of %2 lies on the same three corners as panel %3: both pull and catch the wind there. Remove one.</source>
        <translation>%1 de %2 a les trois mêmes coins que le panneau %3 : les deux y tirent et prennent le vent. En supprimer un.</translation>
    </message>
    <message>
        <location filename="fabric_check.cpp"/>
        <source>Material %1 has an areal density of %2 kg/m^2, and fabrics have 0.02 to 2: where grams are meant, type %2 g/m^2, which is %3 kg/m^2.</source>
        <translation>Le matériau %1 a une masse surfacique de %2 kg/m^2, et les tissus ont de 0,02 à 2 : si ce sont des grammes, taper %2 g/m^2, soit %3 kg/m^2.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>%1 threads carry the pull of fabric that panels carry as well.</source>
        <translation>%1 fils portent la traction d’un tissu que des panneaux portent aussi.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>1 thread carries the pull of fabric that panels carry as well.</source>
        <translation>1 fil porte la traction d’un tissu que des panneaux portent aussi.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>All of it lies in one upright plane, to the last digit, and without a wind nothing moves it aside: it stays there. A wind of 0.1 m/s across it, or a little speed of one particle, lets it swing and fold.</source>
        <translation>Tout se trouve dans un même plan vertical, au dernier chiffre près, et sans vent rien ne l’en écarte : il y reste. Un vent de 0,1 m/s en travers, ou un peu de vitesse à une particule, le laisse se balancer et se plier.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>All panels of a fabric have one grain, which each counts from its own side ab, so that warps lie up to %1 degrees apart.</source>
        <translation>Tous les panneaux d’un tissu ont le même droit-fil, que chacun compte depuis son propre côté ab, si bien que les chaînes s’écartent de jusqu’à %1 degrés.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>Make threads of its sides</source>
        <translation>Faire des fils de ses côtés</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>Remove the threads</source>
        <translation>Supprimer les fils</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>The fabric of %1 parts pulls by threads and has none, so that nothing holds it together.</source>
        <translation>Le tissu de %1 pièces tire par des fils et n’en a pas, si bien que rien ne le tient.</translation>
    </message>
    <message>
        <location filename="fabric_findings.cpp"/>
        <source>The fabric of 1 part pulls by threads and has none, so that nothing holds it together.</source>
        <translation>Le tissu d’une pièce tire par des fils et n’en a pas, si bien que rien ne le tient.</translation>
    </message>
    <message>
        <location filename="fabric_picture.cpp"/>
        <source>Material %1 is drawn without its picture: %2</source>
        <translation>Le matériau %1 est dessiné sans son image : %2</translation>
    </message>
    <message>
        <location filename="fan_tool.cpp"/>
        <source>%1 m/s · wheel: strength · Ctrl + wheel: spread %2°</source>
        <translation>%1 m/s · molette : force · Ctrl + molette : ouverture %2°</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>%1 rows, %2 to %3 s</source>
        <translation>%1 lignes, de %2 à %3 s</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>A name is needed.</source>
        <translation>Il faut un nom.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Choose a colour</source>
        <translation>Choisir une couleur</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Choose a colour.</source>
        <translation>Choisir une couleur.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Choose a file.</source>
        <translation>Choisir un fichier.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>No key is called so; try Left, A or Ctrl+Up.</source>
        <translation>Aucune touche ne s’appelle ainsi ; essayer Left, A ou Ctrl+Up.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Read a measured wind from a table: time and speed, with a direction, or with three components.</source>
        <translation>Lire un vent mesuré dans un tableau : temps et vitesse, avec une direction, ou trois composantes.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>Rows are numbers with commas between them and a semicolon after each row; %1.</source>
        <translation>Les rangs sont des nombres séparés par des virgules, avec un point-virgule après chaque rang ; %1.</translation>
    </message>
    <message>
        <location filename="field.cpp"/>
        <source>The %1 %2.</source>
        <translation>« %1 » %2.</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 added rows</source>
        <translation>%1 rangs ajoutés</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 changed rows</source>
        <translation>%1 rangs modifiés</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 moved</source>
        <translation>%1 déplacées</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 of cloth</source>
        <translation>%1 de toile</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 of line</source>
        <translation>%1 de ligne</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 painted rows</source>
        <translation>%1 rangs peints</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 removed rows</source>
        <translation>%1 rangs supprimés</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 substeps of %2</source>
        <translation>%1 sous-pas de %2</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1 wide, %2 high, %3 deep</source>
        <translation>largeur %1, hauteur %2, profondeur %3</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>%1: of %2 by now, which stays until another is chosen.</source>
        <translation>%1 : désormais en %2, qui reste tant qu’aucun autre n’est choisi.</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>Lets go of what %1 others point at.</source>
        <translation>Lâche ce que désignent %1 autres.</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>Span %1</source>
        <translation>Envergure %1</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>Takes back what was done by hand: %1. To keep it, detach the part instead.</source>
        <translation>Défait ce qui a été fait à la main : %1. Pour le garder, détacher plutôt la pièce.</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>aspect ratio %1</source>
        <translation>allongement %1</translation>
    </message>
    <message>
        <location filename="figures_text.cpp"/>
        <source>steps of %1</source>
        <translation>pas de %1</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;Export…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;New scene</source>
        <translation>&amp;Nouvelle scène</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>A kite, glider, parachute, cloth or rope from its dimensions.</source>
        <translation>Un cerf-volant, un deltaplane, un parachute, une toile ou un cordage à partir de ses dimensions.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>An empty scene, to draw or import into.</source>
        <translation>Une scène vide, pour dessiner ou importer.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Compare &amp;with…</source>
        <translation>Comparer a&amp;vec…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Keep the design as one to begin new ones from.</source>
        <translation>Garder cette scène comme point de départ de nouvelles.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Leave Ripstop.</source>
        <translation>Quitter Ripstop.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Look at a run that was saved, compare with it, or go on from it.</source>
        <translation>Regarder une simulation enregistrée, la comparer, ou continuer à partir d’elle.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Make fabric of a mesh: OBJ, STL, PLY, OFF, glTF, Collada, VTP or VTU.</source>
        <translation>Faire du tissu d’un maillage : OBJ, STL, PLY, OFF, glTF, Collada, VTP ou VTU.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Meshes for Blender, series for ParaView, tables of the probes and of what has torn.</source>
        <translation>Maillages pour Blender, séries pour ParaView, tableaux des sondes et des déchirures.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>New from &amp;builder…</source>
        <translation>Nouveau à partir d’un &amp;générateur…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Open a scene file.</source>
        <translation>Ouvrir un fichier de scène.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Open reco&amp;rding…</source>
        <translation>Ouvrir un enre&amp;gistrement…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>S&amp;tart page</source>
        <translation>Page d'&amp;accueil</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Sa&amp;ve recording…</source>
        <translation>E&amp;nregistrer la simulation…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Samples, recent files and builders.</source>
        <translation>Exemples, fichiers récents et générateurs.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save &amp;film…</source>
        <translation>Enregistrer un &amp;film…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save &amp;picture…</source>
        <translation>Enregistrer une i&amp;mage…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save as &amp;template…</source>
        <translation>Enregistrer &amp;comme gabarit…</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save the run that the timeline shows, every step of it.</source>
        <translation>Enregistrer la simulation que montre la chronologie, chacun de ses pas.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save the scene in another file.</source>
        <translation>Enregistrer la scène dans un autre fichier.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>Save the scene in its file.</source>
        <translation>Enregistrer la scène dans son fichier.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>The 3D view as PNG, JPEG, SVG or PDF, large enough for a paper, on sky, white or nothing.</source>
        <translation>La vue 3D en PNG, JPEG, SVG ou PDF, assez grande pour un article, sur ciel, sur blanc ou sans fond.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>The flight of the timeline as a film, MP4, WebM or GIF, seen as in the 3D view.</source>
        <translation>Le vol de la chronologie en film, MP4, WebM ou GIF, tel que le montre la vue 3D.</translation>
    </message>
    <message>
        <location filename="file_rows.cpp"/>
        <source>What the open design and another one, or the saved one, differ in.</source>
        <translation>En quoi le modèle ouvert diffère d’un autre, ou de celui qui est enregistré.</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source> Your changes are then lost.</source>
        <translation> Vos modifications sont alors perdues.</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>%1 cannot be written: choose a folder that you may write to, and the ending .png, .jpg, .svg or .pdf.</source>
        <translation>Impossible d’écrire %1 : choisissez un dossier où vous pouvez écrire et l’extension .png, .jpg, .svg ou .pdf.</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>%1 has changes that are not saved. Save them first?</source>
        <translation>%1 a des modifications non enregistrées. Les enregistrer d’abord ?</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>&amp;Keep mine</source>
        <translation>&amp;Garder le mien</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>&amp;Open again</source>
        <translation>&amp;Rouvrir</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>A study flies the design as it is saved. Save %1 now?</source>
        <translation>Une étude fait voler le modèle tel qu’il est enregistré. Enregistrer %1 maintenant ?</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Another program has written %1 since you opened it. Replace what it wrote?</source>
        <translation>Un autre programme a écrit %1 depuis que vous l’avez ouvert. Remplacer ce qu’il a écrit ?</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Another program has written %1. Open it again?%2</source>
        <translation>Un autre programme a écrit %1. L’ouvrir de nouveau ?%2</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Cannot open the scene</source>
        <translation>Impossible d’ouvrir la scène</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Cannot open the template</source>
        <translation>Impossible d’ouvrir le gabarit</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Cannot save the picture</source>
        <translation>Impossible d’enregistrer l’image</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Cannot save the scene</source>
        <translation>Impossible d’enregistrer la scène</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Cannot save the template</source>
        <translation>Impossible d’enregistrer le gabarit</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Changed on the disk</source>
        <translation>Modifié sur le disque</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Exported %1</source>
        <translation>%1 exporté</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Name of the template:</source>
        <translation>Nom du gabarit :</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Pictures (*.png *.jpg *.svg *.pdf)</source>
        <translation>Images (*.png *.jpg *.svg *.pdf)</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Ripstop scenes (*.ripstop.json);;All files (*)</source>
        <translation>Scènes Ripstop (*.ripstop.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Save as template</source>
        <translation>Enregistrer comme gabarit</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Save the design?</source>
        <translation>Enregistrer le modèle ?</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Save the scene as</source>
        <translation>Enregistrer la scène sous</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Save the view as a picture</source>
        <translation>Enregistrer la vue comme image</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Saved the template %1</source>
        <translation>Gabarit %1 enregistré</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Scenes, studies and recordings (*.ripstop.json *.ripstop-study.json *.ripstop-run)</source>
        <translation>Scènes, études et enregistrements (*.ripstop.json *.ripstop-study.json *.ripstop-run)</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>There is a template %1. Replace it?</source>
        <translation>Il existe un gabarit %1. Le remplacer ?</translation>
    </message>
    <message>
        <location filename="files.cpp"/>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>%1 was not written; ffmpeg says: %2</source>
        <translation>%1 n’a pas été écrit ; ffmpeg dit : %2</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>A picture of this size cannot be drawn here; choose a smaller one.</source>
        <translation>Une image de cette taille ne peut pas être dessinée ici ; en choisir une plus petite.</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>Film, MP4</source>
        <translation>Film, MP4</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>Film, WebM</source>
        <translation>Film, WebM</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>For texts and slides; 256 colours, large. Made by ffmpeg.</source>
        <translation>Pour textes et diapositives ; 256 couleurs, volumineux. Fait par ffmpeg.</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>H.264, which everything plays. Made by ffmpeg.</source>
        <translation>H.264, que tout lit. Fait par ffmpeg.</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>Moving picture, GIF</source>
        <translation>Image animée, GIF</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>One picture for each frame, exact; for other programs and for papers.</source>
        <translation>Une image exacte pour chaque instant ; pour d’autres programmes et pour des articles.</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>Pictures, PNG</source>
        <translation>Images, PNG</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>The program ffmpeg, which makes films, is not installed. Install it (Debian: apt install ffmpeg), or choose pictures.</source>
        <translation>Le programme ffmpeg, qui fait les films, n’est pas installé. L’installer (Debian : apt install ffmpeg), ou choisir des images.</translation>
    </message>
    <message>
        <location filename="film.cpp"/>
        <source>VP9 for web pages; keeps a transparent background. Made by ffmpeg.</source>
        <translation>VP9 pour les pages web ; garde un fond transparent. Fait par ffmpeg.</translation>
    </message>
    <message>
        <location filename="film_look.cpp"/>
        <source>none</source>
        <comment>value</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>Compare no more</source>
        <translation>Ne plus comparer</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>How the flights are shown in the view</source>
        <translation>Comment les vols sont montrés dans la vue</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>Probe of the curves</source>
        <translation>Sonde des courbes</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>ghosts over each other</source>
        <translation>fantômes superposés</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>ghosts side by side</source>
        <translation>fantômes côte à côte</translation>
    </message>
    <message>
        <location filename="flight_curves.cpp"/>
        <source>no ghosts</source>
        <translation>sans fantômes</translation>
    </message>
    <message>
        <location filename="flutter_check.cpp"/>
        <source>The fabric of %1 lies in one plane with the wind and stays there, as nothing moves it aside: it does not flutter. Turn the wind by a degree, or give it gusts.</source>
        <translation>Le tissu de %1 est dans un même plan que le vent et y reste, car rien ne l’en écarte : il ne flotte pas. Tournez le vent d’un degré, ou donnez-lui des rafales.</translation>
    </message>
    <message>
        <location filename="fold_button.cpp"/>
        <source>%1 more fields do nothing now</source>
        <translation>%1 autres champs sans effet ici</translation>
    </message>
    <message>
        <location filename="fold_button.cpp"/>
        <source>1 more field does nothing now</source>
        <translation>1 autre champ sans effet ici</translation>
    </message>
    <message>
        <location filename="fold_button.cpp"/>
        <source>Hide what does nothing now</source>
        <translation>Masquer ce qui est sans effet</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>"%1" is no other probe; names are written with _ for blanks</source>
        <translation>« %1 » n’est pas une autre sonde ; les noms s’écrivent avec _ pour les blancs</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>a ")" is missing at its end</source>
        <translation>il manque une « ) » à la fin</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>a choice is written condition ? value : other value</source>
        <translation>un choix s’écrit condition ? valeur : autre valeur</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>a sign such as * is missing before "%1" at character %2</source>
        <translation>il manque un signe comme * avant « %1 », au caractère %2</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it adds, or takes a function of, things of different units</source>
        <translation>elle additionne des choses d’unités différentes, ou en prend une fonction</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it cannot be read</source>
        <translation>elle ne peut pas être lue</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it ends where a number or a name has to follow</source>
        <translation>elle s’arrête là où un nombre ou un nom doit suivre</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it gives no finite number, as 1/0 does; check what it divides by</source>
        <translation>elle ne donne pas de nombre fini, comme 1/0 ; vérifiez par quoi elle divise</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it is empty; write one like line_tension / weight</source>
        <translation>elle est vide ; en écrire une comme line_tension / weight</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>it, or a name in it, is too long</source>
        <translation>elle est trop longue, ou un nom qui s’y trouve</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>no number or name stands before "%1" at character %2</source>
        <translation>aucun nombre ni nom ne précède « %1 », au caractère %2</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>texts in quotation marks have no place in a formula</source>
        <translation>des textes entre guillemets n’ont pas leur place dans une formule</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the ")" at character %1 comes too early or has no "(" before it</source>
        <translation>la « ) » au caractère %1 vient trop tôt ou n’a pas de « ( » avant elle</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the comma at character %1 is out of place; decimals have a point</source>
        <translation>la virgule au caractère %1 n’est pas à sa place ; les décimales s’écrivent avec un point</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the function "%1" has no brackets behind it: %1(...)</source>
        <translation>la fonction « %1 » n’a pas de parenthèses après elle : %1(...)</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the function "%1" has too few values in its brackets</source>
        <translation>la fonction « %1 » a trop peu de valeurs entre ses parenthèses</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the function "%1" has too many values in its brackets</source>
        <translation>la fonction « %1 » a trop de valeurs entre ses parenthèses</translation>
    </message>
    <message>
        <location filename="formula.cpp"/>
        <source>the sign at character %1 means nothing in a formula</source>
        <translation>le signe au caractère %1 ne veut rien dire dans une formule</translation>
    </message>
    <message>
        <location filename="frame_source.cpp"/>
        <source>The recording ends at %1.</source>
        <translation>L’enregistrement finit à %1.</translation>
    </message>
    <message>
        <location filename="frame_source.cpp"/>
        <source>The simulation stopped: %1</source>
        <translation>La simulation s’est arrêtée : %1</translation>
    </message>
    <message>
        <location filename="frame_spool.cpp"/>
        <source>the shapes of the series cannot be read again</source>
        <translation>les formes de la série ne peuvent pas être relues</translation>
    </message>
    <message>
        <location filename="frame_spool.cpp"/>
        <source>there is no room for the shapes of the series</source>
        <translation>il n’y a pas de place pour les formes de la série</translation>
    </message>
    <message>
        <location filename="gap_check.cpp"/>
        <source>Collider %1 is %2 m wide and the links of %4 are %3 m long: it fits between particles, which are what touches; take shorter links, or a larger collider.</source>
        <translation>L’obstacle %1 fait %2 m de large et les liaisons de %4 font %3 m de long : il passe entre les particules, seules à toucher ; prendre des liaisons plus courtes ou un obstacle plus grand.</translation>
    </message>
    <message>
        <location filename="gap_check.cpp"/>
        <source>Collider %1 is %2 m wide and the panels of %4 have sides of %3 m: it fits between particles, which are what touches; make the mesh finer, or the collider larger.</source>
        <translation>L’obstacle %1 fait %2 m de large et les panneaux de %4 ont des côtés de %3 m : il passe entre les particules, seules à toucher ; affiner le maillage ou agrandir l’obstacle.</translation>
    </message>
    <message>
        <location filename="gltf.cpp"/>
        <source>The animation would have %1 MB, and a glTF file holds 4096 at most; choose fewer frames, or a point cache (.pc2).</source>
        <translation>L’animation ferait %1 Mo, et un fichier glTF en contient 4096 au plus ; choisir moins d’images, ou un cache de points (.pc2).</translation>
    </message>
    <message>
        <location filename="gltf.cpp"/>
        <source>The glTF text cannot be written.</source>
        <translation>Le texte glTF ne peut pas être écrit.</translation>
    </message>
    <message>
        <location filename="gltf.cpp"/>
        <source>There is neither fabric nor a line at this moment to make a mesh of.</source>
        <translation>Il n’y a à cet instant ni tissu ni ligne dont faire un maillage.</translation>
    </message>
    <message>
        <location filename="goal_chart.cpp"/>
        <source>alone</source>
        <translation>seule</translation>
    </message>
    <message>
        <location filename="goal_chart.cpp"/>
        <source>flight</source>
        <translation>vol</translation>
    </message>
    <message>
        <location filename="goal_chart.cpp"/>
        <source>share of the variance</source>
        <translation>part de la variance</translation>
    </message>
    <message>
        <location filename="goal_chart.cpp"/>
        <source>with its interactions</source>
        <translation>avec ses interactions</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>&amp;Limit something…</source>
        <translation>&amp;Limiter quelque chose…</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>&amp;Want something…</source>
        <translation>&amp;Ajouter un objectif…</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>A measure that may be at most or has to be at least some value in a good design.</source>
        <translation>Une mesure qui, dans un bon modèle, ne dépasse pas une valeur ou l’atteint au moins.</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Another measure that is wanted small, large or at a value; with two the best are a front.</source>
        <translation>Une autre mesure que l’on veut petite, grande ou à une valeur donnée ; avec deux, les meilleurs forment un front.</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Largest</source>
        <translation>Le plus grand</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Limit this no more</source>
        <translation>Ne plus limiter ceci</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Nearest to</source>
        <translation>Le plus proche de</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Nothing may tear</source>
        <translation>Rien ne doit se déchirer</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Smallest</source>
        <translation>Le plus petit</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>The accuracy is held</source>
        <translation>La précision est tenue</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>The limit</source>
        <translation>La limite</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>The value that is wanted</source>
        <translation>La valeur voulue</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Want this no more</source>
        <translation>Retirer cet objectif</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>What is wanted</source>
        <translation>Ce qui est voulu</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>What of its values</source>
        <translation>Ce que l’on prend de ses valeurs</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>Which side is limited</source>
        <translation>Le côté limité</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>at the end</source>
        <translation>à la fin</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>largest</source>
        <translation>maximum</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>least</source>
        <translation>minimum</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>percentile</source>
        <translation>percentile</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>root mean square</source>
        <translation>moyenne quadratique</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>time of the largest</source>
        <translation>instant du maximum</translation>
    </message>
    <message>
        <location filename="goal_form.cpp"/>
        <source>time of the least</source>
        <translation>instant du minimum</translation>
    </message>
    <message>
        <location filename="grab_tool.cpp"/>
        <source>%1, all that the time step allows</source>
        <translation>%1, tout ce que le pas de temps permet</translation>
    </message>
    <message>
        <location filename="grab_tool.cpp"/>
        <source>%1, when it runs</source>
        <translation>%1, en marche</translation>
    </message>
    <message>
        <location filename="grab_tool.cpp"/>
        <source>P pins</source>
        <translation>P fixe</translation>
    </message>
    <message>
        <location filename="grab_tool.cpp"/>
        <source>pinned, P lets go</source>
        <translation>fixé, P libère</translation>
    </message>
    <message>
        <location filename="grab_tool.cpp"/>
        <source>the most it may</source>
        <translation>le plus qu’il peut</translation>
    </message>
    <message>
        <location filename="group.cpp"/>
        <source>Add to %1</source>
        <translation>Ajouter à %1</translation>
    </message>
    <message>
        <location filename="group.cpp"/>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <location filename="group.cpp"/>
        <source>Remove from %1</source>
        <translation>Retirer de %1</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>&amp;Remove from group</source>
        <translation>Retire&amp;r du groupe</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>A&amp;dd to group</source>
        <translation>A&amp;jouter au groupe</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>By gro&amp;up</source>
        <translation>Par gro&amp;upe</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Group selection</source>
        <translation>Grouper la sélection</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Make the selected elements members of a group.</source>
        <translation>Faire des éléments sélectionnés des membres d’un groupe.</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Name of the group of %1:</source>
        <translation>Nom du groupe de %1 :</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>No groups yet</source>
        <translation>Pas encore de groupes</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>None of them belongs to the group.</source>
        <translation>Aucun d’eux n’appartient au groupe.</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Select particles, links or panels first.</source>
        <translation>Sélectionner d’abord des particules, des liaisons ou des panneaux.</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Select the members of a group.</source>
        <translation>Sélectionner les membres d’un groupe.</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>Take the selected elements out of a group.</source>
        <translation>Retirer les éléments sélectionnés d’un groupe.</translation>
    </message>
    <message>
        <location filename="group_menus.cpp"/>
        <source>They all belong to the group already.</source>
        <translation>Ils appartiennent déjà tous au groupe.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>%1 From %2 to %3 %4.</source>
        <translation>%1 De %2 à %3 %4.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>All the way through</source>
        <translation>De part en part</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Drag fabric, lines, controls, colliders. Wheel: nearer or farther. P: pin.</source>
        <translation>Tirer le tissu, les lignes, les commandes, les obstacles. Molette : plus près ou plus loin. P : fixer.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Draw across links and fabric. Cuts belong to the run: Reset (Ctrl+R) takes them back. A right drag turns the view.</source>
        <translation>Tracer à travers les liaisons et le tissu. Les coupes font partie du vol : Réinitialiser (Ctrl+R) les annule. Glisser du bouton droit tourne la vue.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Fan</source>
        <translation>Ventilateur</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Grab</source>
        <translation>Saisir</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Half the angle of the jet. A narrow one reaches farther.</source>
        <translation>La moitié de l’angle du jet. Un jet étroit porte plus loin.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Hold the button and aim. Wheel: strength, with Ctrl: spread.</source>
        <translation>Tenir le bouton et viser. Molette : force, avec Ctrl : ouverture.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>How stiff the spring is between the cursor and what it holds. Empty, it follows from the weight and the size of the design. A time step that is too long for it makes it softer; the view says so.</source>
        <translation>Raideur du ressort entre le pointeur et ce qu’il tient. Vide, elle suit du poids et de la taille du modèle. Un pas de temps trop long pour elle la rend plus douce ; la vue le dit.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Let go of all that was pinned by hand in this run.</source>
        <translation>Lâcher tout ce qui a été fixé à la main dans cette simulation.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Of the air in the nozzle; it slows down as the jet widens.</source>
        <translation>De l’air dans la buse ; il ralentit à mesure que le jet s’élargit.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Off, the knife goes through the first fabric under it; on, through all that lies behind as well.</source>
        <translation>Décoché, le couteau traverse le premier tissu sous lui ; coché, aussi tout ce qui est derrière.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Paused: nothing moves until it runs (Space). </source>
        <translation>En pause : rien ne bouge avant le lancement (Espace). </translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Pull out pins</source>
        <translation>Retirer les épingles</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>Spread</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>The most that the hand pulls with, however far it goes. Empty, it is five times the weight of all that is free, and 5 N or more.</source>
        <translation>La plus grande force de la main, aussi loin qu’elle aille. Vide, c’est cinq fois le poids de tout ce qui est libre, et au moins 5 N.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>The number %1.</source>
        <translation>Le nombre %1.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>The number must be from %1 to %2 %3.</source>
        <translation>Le nombre doit être de %1 à %2 %3.</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>at most</source>
        <translation>au plus</translation>
    </message>
    <message>
        <location filename="hand_bar.cpp"/>
        <source>automatic %1</source>
        <translation>automatique %1</translation>
    </message>
    <message>
        <location filename="hand_pull.cpp"/>
        <source>hand</source>
        <translation>la main</translation>
    </message>
    <message>
        <location filename="hand_rows.cpp"/>
        <source>a hand does not "%1".</source>
        <translation>une main ne fait pas « %1 ».</translation>
    </message>
    <message>
        <location filename="hand_rows.cpp"/>
        <source>a hand does not "%1"; did you mean "%2"?</source>
        <translation>une main ne fait pas « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <location filename="hand_rows.cpp"/>
        <source>what follows %1 must be %2.</source>
        <translation>ce qui suit %1 doit être : %2.</translation>
    </message>
    <message>
        <location filename="hand_rows.cpp"/>
        <source>what follows %1 must be finite numbers.</source>
        <translation>ce qui suit %1 doit être des nombres finis.</translation>
    </message>
    <message>
        <location filename="handle_drag.cpp"/>
        <source>typed: %1</source>
        <translation>tapé : %1</translation>
    </message>
    <message>
        <location filename="hdf5.cpp"/>
        <source>%1 is an HDF5 file, which this program was built without; export .pvd or .csv, or build it with libhdf5-dev.</source>
        <translation>%1 est un fichier HDF5, sans quoi ce programme a été construit ; exportez en .pvd ou .csv, ou construisez-le avec libhdf5-dev.</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>The picture %1 cannot be read (%2); save it as a grey PNG of 8 or 16 bits, or choose another file.</source>
        <translation>L’image %1 ne peut pas être lue (%2) ; l’enregistrer en PNG gris de 8 ou 16 bits, ou choisir un autre fichier.</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it ends too early</source>
        <translation>elle finit trop tôt</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it ends too early or has a value that is too large</source>
        <translation>elle finit trop tôt ou a une valeur trop grande</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it has too few bytes for %1 x %2 points; fewer points, or a PGM, would do</source>
        <translation>il a trop peu d’octets pour %1 x %2 points ; moins de points, ou un PGM, conviendraient</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it is %1 x %2 points, and 2 x 2 to 8192 x 8192 are possible</source>
        <translation>elle a %1 x %2 points, et de 2 x 2 à 8192 x 8192 sont possibles</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it is damaged</source>
        <translation>elle est abîmée</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>it is neither a PNG nor a PGM</source>
        <translation>ce n’est ni un PNG ni un PGM</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>its kind of colour is not known</source>
        <translation>sa sorte de couleur n’est pas connue</translation>
    </message>
    <message>
        <location filename="height_picture.cpp"/>
        <source>its largest value is not 1 to 65535</source>
        <translation>sa plus grande valeur n’est pas de 1 à 65535</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;About Ripstop</source>
        <translation>À &amp;propos de Ripstop</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Find an action…</source>
        <translation>&amp;Trouver une action…</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Keys…</source>
        <translation>&amp;Raccourcis clavier…</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&amp;Verification…</source>
        <translation>Véri&amp;fication…</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>&lt;h3&gt;Ripstop %1&lt;/h3&gt;&lt;p&gt;An editor and simulator for fabric that flies: kites, hang gliders, parachutes, cloth.&lt;/p&gt;&lt;p&gt;Every number on the screen can be made again by &lt;tt&gt;ripstop-cli&lt;/tt&gt;, bit for bit.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, VTK, Eigen, oneTBB, RapidJSON, nlohmann/json, CLI11, muParser, assimp, tinygltf, zstd and QCustomPlot.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Ripstop %1&lt;/h3&gt;&lt;p&gt;Un éditeur et simulateur de tissu qui vole : cerfs-volants, deltaplanes, parachutes, toiles.&lt;/p&gt;&lt;p&gt;Chaque nombre à l’écran peut être recalculé par &lt;tt&gt;ripstop-cli&lt;/tt&gt;, au bit près.&lt;/p&gt;&lt;p&gt;Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure. Construit avec Qt, VTK, Eigen, oneTBB, RapidJSON, nlohmann/json, CLI11, muParser, assimp, tinygltf, zstd et QCustomPlot.&lt;/p&gt;</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>About Ripstop</source>
        <translation>À propos de Ripstop</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>All keys, to see and to change, and those of the controls of this scene.</source>
        <translation>Toutes les touches, à consulter et à changer, et celles des commandes de cette scène.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>Manual about &amp;this</source>
        <translation>Manuel à &amp;ce sujet</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>Run the cases whose answer is known, and see what comes out.</source>
        <translation>Exécuter les cas dont la réponse est connue, et voir ce qui en sort.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>The book: tutorials, editor, materials, tuning, studies, physics.</source>
        <translation>Le livre : tutoriels, éditeur, matériaux, réglages, études, physique.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>The page of the manual about the property, panel or dialog under the mouse.</source>
        <translation>La page du manuel sur la propriété, le panneau ou la fenêtre sous la souris.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>Type to find anything that the menus can do.</source>
        <translation>Taper pour trouver tout ce que les menus savent faire.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>Version and licence.</source>
        <translation>Version et licence.</translation>
    </message>
    <message>
        <location filename="help_rows.cpp"/>
        <source>What the parts of the window are for, in a minute.</source>
        <translation>À quoi servent les parties de la fenêtre, en une minute.</translation>
    </message>
    <message>
        <location filename="hinge_check.cpp"/>
        <source>At particle #%1 a spar of %2 turns by %3 degrees, and nothing else is tied there: it moves as on a hinge, since spars go on into each other up to 60 degrees. Bend it in smaller angles, or brace it.</source>
        <translation>À la particule %1, un longeron de %2 tourne de %3 degrés et rien d’autre n’y est attaché : il bouge comme sur une charnière, car les longerons ne se prolongent que jusqu’à 60 degrés. Courbez-le par angles plus petits, ou haubanez-le.</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>%1 is one thing, not several.</source>
        <translation>« %1 » désigne une seule chose, pas plusieurs.</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>%1 must be a %2; there is none called "%3".</source>
        <translation>« %1 » attend : %2 ; rien de tel ne s’appelle « %3 ».</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>Choose or pick %1.</source>
        <translation>Choisir ou prendre : %1.</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>None</source>
        <translation>Sans</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>Pick in the view or the outline</source>
        <translation>Prendre dans la vue ou l’arborescence</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>all that are plotted</source>
        <translation>toutes celles qui sont tracées</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>none</source>
        <translation>sans</translation>
    </message>
    <message>
        <location filename="id_field.cpp"/>
        <source>whole scene</source>
        <translation>toute la scène</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>%1 lines, %2 long together</source>
        <translation>%1 lignes, longues de %2 ensemble</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>%1 rods</source>
        <translation>%1 tiges</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>%1 springs</source>
        <translation>%1 ressorts</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>1 line, %1 long</source>
        <translation>1 ligne, longue de %1</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>1 rod</source>
        <translation>1 tige</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>1 spring</source>
        <translation>1 ressort</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Another file…</source>
        <translation>Autre fichier…</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Choose a line to see in the picture where the first ones are.</source>
        <translation>Choisir une ligne pour voir dans l’image où sont les premiers.</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Fabric without its picture</source>
        <translation>Tissu sans son image</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Import a mesh</source>
        <translation>Importer un maillage</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Maillages (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Nothing is wrong with this mesh.</source>
        <translation>Ce maillage n’a aucun défaut.</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>OBJ, STL, PLY, OFF, glTF, GLB, Collada, VTP or VTU.</source>
        <translation>OBJ, STL, PLY, OFF, glTF, GLB, Collada, VTP ou VTU.</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Pictures that lie within the file will be written beside it: %1.</source>
        <translation>Les images contenues dans le fichier seront écrites à côté : %1.</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>There is nothing to show.</source>
        <translation>Il n’y a rien à montrer.</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>What was found in the mesh</source>
        <translation>Ce qui a été trouvé dans le maillage</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <location filename="import_dialog.cpp"/>
        <source>no links</source>
        <translation>aucune liaison</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>%1 (of this scene)</source>
        <translation>%1 (de cette scène)</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>A fabric that one can buy, or a material of this scene.</source>
        <translation>Un tissu du commerce, ou un matériau de cette scène.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Across faces</source>
        <translation>À travers les faces</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Along edges</source>
        <translation>Le long des arêtes</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>As the file says</source>
        <translation>Comme le dit le fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Bend links: from each particle to the next but one. The bending stiffness of a material does the same at every fineness of the mesh.</source>
        <translation>Liaisons de flexion : de chaque particule à la deuxième suivante. La rigidité en flexion d’un matériau fait de même à toute finesse du maillage.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Each triangle gives a third of its mass to each of its corners.</source>
        <translation>Chaque triangle donne un tiers de sa masse à chacun de ses coins.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>From the way in which the texture of the mesh goes up; without a texture, from upright, or from x on what lies level. Of panels only: threads run along the edges of the mesh.</source>
        <translation>Depuis le sens dans lequel la texture du maillage monte ; sans texture, depuis la verticale, ou depuis x sur ce qui est à plat. Des panneaux seulement : les fils suivent les arêtes du maillage.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Join vertices within</source>
        <translation>Joindre les sommets à moins de</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Longest side</source>
        <translation>Plus grand côté</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Makes as many materials as the file has, with their names and colours and all the numbers of this one.</source>
        <translation>Fait autant de matériaux que le fichier en a, avec leurs noms et couleurs et tous les nombres de celui-ci.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Makes the front of every face its back. Air meets both sides alike, but a canopy holds its air behind the back.</source>
        <translation>Fait de l’endroit de chaque face son envers. L’air rencontre les deux côtés de la même façon, mais une voilure tient son air derrière l’envers.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Mass per area</source>
        <translation>Masse surfacique</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Most mesh programs have z up. In Ripstop, y is up.</source>
        <translation>La plupart des logiciels de maillage ont z vers le haut. Dans Ripstop, c’est y.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>No links</source>
        <translation>Aucune liaison</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>OBJ, STL, PLY and OFF do not say what one unit is; look at the size that results.</source>
        <translation>OBJ, STL, PLY et OFF ne disent pas ce qu’est une unité ; regarder la taille obtenue.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>One for each object</source>
        <translation>Une pour chaque objet</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>One for each of %1 in the file</source>
        <translation>Un pour chacun des %1 du fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>One for each of %1 objects</source>
        <translation>Une pour chacun des %1 objets</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>One for each of the file</source>
        <translation>Un pour chacun du fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>One part</source>
        <translation>Une pièce</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Over two edges</source>
        <translation>Par-dessus deux arêtes</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Panels are elastic triangles with warp, weft and shear: they wrinkle as cloth does, and the mesh makes no difference. Threads are links along edges and across faces: three times as fast, and true along the edges of the mesh only.</source>
        <translation>Les panneaux sont des triangles élastiques avec chaîne, trame et cisaillement : ils plissent comme le tissu, et le maillage n’y change rien. Les fils sont des liaisons le long des arêtes et en travers des faces : trois fois plus rapides, et justes seulement le long des arêtes du maillage.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Pull carried by</source>
        <translation>Traction portée par</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Scale to a size</source>
        <translation>Mettre à une taille</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Shear links: both diagonals of quads, and between the corners across the edge of two triangles. Triangles resist shear without them.</source>
        <translation>Liaisons de cisaillement : les deux diagonales des quadrilatères, et entre les coins de part et d’autre de l’arête de deux triangles. Les triangles résistent au cisaillement sans elles.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Structural links: the threads of the fabric. Rods are stable however stiff the fabric is; springs can need many substeps.</source>
        <translation>Liaisons de structure : les fils du tissu. Les tiges sont stables aussi raide que soit le tissu ; les ressorts peuvent demander beaucoup de sous-pas.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>The mesh is scaled until the longest side of the box around it is this long.</source>
        <translation>Le maillage est mis à l’échelle jusqu’à ce que le plus grand côté de sa boîte ait cette longueur.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Threads</source>
        <translation>Fils</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Turn the fabric over</source>
        <translation>Retourner le tissu</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Unit of the file</source>
        <translation>Unité du fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Up in the file</source>
        <translation>Haut dans le fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Vertices nearer to each other than this become one particle, so that a sail does not burst at its seams.</source>
        <translation>Les sommets plus proches que cela deviennent une seule particule, pour qu’une voile n’éclate pas à ses coutures.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Warp turned by</source>
        <translation>Chaîne tournée de</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>What the part will be called.</source>
        <translation>Comment la pièce s’appellera.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Whether each object of the file becomes a part of its own. In one part, objects become groups, and fabric is joined where they touch.</source>
        <translation>Si chaque objet du fichier devient une pièce à part. Dans une seule pièce, les objets deviennent des groupes, et le tissu est joint là où ils se touchent.</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>With the name and colour of that in the file</source>
        <translation>Avec le nom et la couleur de celui du fichier</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>Y, as in Ripstop</source>
        <translation>Y, comme dans Ripstop</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>joins %1 vertices</source>
        <translation>joint %1 sommets</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>joins 1 vertex</source>
        <translation>joint 1 sommet</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>joins none</source>
        <translation>n’en joint aucun</translation>
    </message>
    <message>
        <location filename="import_form.cpp"/>
        <source>mesh</source>
        <translation>maillage</translation>
    </message>
    <message>
        <location filename="import_work.cpp"/>
        <source>There is not enough memory for this mesh.</source>
        <translation>La mémoire ne suffit pas pour ce maillage.</translation>
    </message>
    <message>
        <location filename="insert.cpp"/>
        <source>Insert %1</source>
        <translation>Insérer %1</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>%1 keeps its %2 and %3 as they are, with all that was changed by hand.</source>
        <translation>%1 garde telles quelles ses %2 et %3, avec tout ce qui a été changé à la main.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>&amp;Detach from builder…</source>
        <translation>&amp;Détacher du générateur…</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>&amp;Insert</source>
        <translation>&amp;Insertion</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Add a control, with which keys or a track move what is selected.</source>
        <translation>Ajouter une commande, par laquelle des touches ou une piste déplacent la sélection.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Add a material, for panels and links.</source>
        <translation>Ajouter un matériau, pour panneaux et liaisons.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Add a plot of probes over time.</source>
        <translation>Ajouter un graphe de sondes en fonction du temps.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Add a probe, which measures what is selected while it flies.</source>
        <translation>Ajouter une sonde, qui mesure la sélection pendant le vol.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Add a wind: the same everywhere, growing with the height, in gusts or as a jet.</source>
        <translation>Ajouter un vent : partout le même, croissant avec la hauteur, en rafales ou en jet.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Build the selected part again with other parameters; it keeps its place and what was tuned.</source>
        <translation>Reconstruire la pièce sélectionnée avec d’autres paramètres ; elle garde sa place et ce qui a été réglé.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Change &amp;parameters…</source>
        <translation>Changer les &amp;paramètres…</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Detach</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Detach from builder</source>
        <translation>Détacher du générateur</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>It loses its %1 parameters (%2…): they can no longer be changed, and the mesh no finer or coarser.</source>
        <translation>Elle perd ses %1 paramètres (%2…) : ils ne peuvent plus être changés, ni le maillage affiné ou grossi.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Keep the selected part as it is, to be shaped by hand only; says what is lost.</source>
        <translation>Garder la pièce sélectionnée telle quelle, à façonner seulement à la main ; dit ce qui est perdu.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Nothing of a builder is selected.</source>
        <translation>Rien d’un générateur n’est sélectionné.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Nothing of a builder is selected: parts that were drawn, imported or detached have no parameters.</source>
        <translation>Rien d’un générateur n’est sélectionné : les pièces dessinées, importées ou détachées n’ont pas de paramètres.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Select one part only.</source>
        <translation>Ne sélectionner qu’une pièce.</translation>
    </message>
    <message>
        <location filename="insert_rows.cpp"/>
        <source>Undo attaches it again.</source>
        <translation>Annuler la rattache.</translation>
    </message>
    <message>
        <location filename="inspector.cpp"/>
        <source>%1: select it in the view or in the outline. Escape stops this.</source>
        <translation>%1 : le sélectionner dans la vue ou l’arborescence. Échap arrête.</translation>
    </message>
    <message>
        <location filename="inspector.cpp"/>
        <source>Find a property</source>
        <translation>Trouver une propriété</translation>
    </message>
    <message>
        <location filename="inspector.cpp"/>
        <source>How the scene is run. Select something to edit it.</source>
        <translation>Comment la scène est simulée. Sélectionner quelque chose pour le modifier.</translation>
    </message>
    <message>
        <location filename="inspector.cpp"/>
        <source>No property is about "%1".</source>
        <translation>Aucune propriété ne parle de « %1 ».</translation>
    </message>
    <message>
        <location filename="inspector.cpp"/>
        <source>Shows the rows whose name or help has these words.</source>
        <translation>Montre les lignes dont le nom ou l’aide contient ces mots.</translation>
    </message>
    <message>
        <location filename="kept_work.cpp"/>
        <source>Cannot open what was left behind</source>
        <translation>Impossible d’ouvrir ce qui est resté</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>"%1" has this key, and would lose it.</source>
        <translation>« %1 » a cette touche, et la perdrait.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>&amp;Set</source>
        <translation>&amp;Attribuer</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>&amp;Usual</source>
        <translation>&amp;Habituelle</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>0 to 9, −, .</source>
        <translation>0 à 9, −, , ou .</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>All &amp;usual</source>
        <translation>Toutes &amp;habituelles</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Choose an action to change its key:</source>
        <translation>Choisir une action pour changer sa touche :</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Controls of this scene</source>
        <translation>Commandes de cette scène</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Ctrl + left drag</source>
        <translation>Ctrl + glisser à gauche</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Does</source>
        <translation>Effet</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Esc, right button</source>
        <translation>Échap, bouton droit</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Every action gets the key that it had at first.</source>
        <translation>Chaque action reprend la touche qu’elle avait au départ.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Gamepad, axis %1</source>
        <translation>Manette, axe %1</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>In the 3D view</source>
        <translation>Dans la vue 3D</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Keep to an axis</source>
        <translation>Rester sur un axe</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Key for "%1":</source>
        <translation>Touche pour « %1 » :</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Keys</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Left drag</source>
        <translation>Glisser à gauche</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Left drag, with box or lasso</source>
        <translation>Glisser à gauche, au rectangle ou lasso</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Less and more, %1 m each time.</source>
        <translation>Moins et plus, %1 m à chaque fois.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Metres, degrees or a factor. Enter takes it.</source>
        <translation>Mètres, degrés ou un facteur. Entrée l’applique.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Middle or Shift + left drag</source>
        <translation>Glisser au milieu ou Maj + gauche</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Press the keys, then Set.</source>
        <translation>Appuyer sur les touches, puis Attribuer.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Pulls at fabric and lines, carries colliders, moves what controls move.</source>
        <translation>Tire sur le tissu et les lignes, porte des obstacles, déplace ce que les commandes déplacent.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Right drag, with box or lasso</source>
        <translation>Glisser à droite, au rectangle ou lasso</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Search a key or what it does</source>
        <translation>Chercher une touche ou ce qu’elle fait</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Select what lies inside</source>
        <translation>Sélectionner ce qui est dedans</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Snap</source>
        <translation>Aimanter</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Take back</source>
        <translation>Annuler le geste</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>The horizon stays level.</source>
        <translation>L’horizon reste de niveau.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>The key that it had at first.</source>
        <translation>La touche qu’elle avait au départ.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>The same key again lets it go.</source>
        <translation>La même touche le relâche.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>To a grid, to particles, to 15°, to tenths.</source>
        <translation>À une grille, à des particules, à 15°, à des dixièmes.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Towards the cursor.</source>
        <translation>Vers le pointeur.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Turn</source>
        <comment>the view</comment>
        <translation>Tourner</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Type the amount</source>
        <translation>Taper la quantité</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Up to %1 m either way.</source>
        <translation>Jusqu’à %1 m de part et d’autre.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>While a handle is pulled</source>
        <translation>Pendant qu’une poignée est tirée</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>With Shift, add to the selection; with Ctrl, take away.</source>
        <translation>Avec Maj, ajouter à la sélection ; avec Ctrl, retirer.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>With Shift, add; with Ctrl, take away; Escape gives up.</source>
        <translation>Avec Maj, ajouter ; avec Ctrl, retirer ; Échap abandonne.</translation>
    </message>
    <message>
        <location filename="keys_dialog.cpp"/>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <location filename="language_rows.cpp"/>
        <source>&amp;System</source>
        <translation>&amp;Système</translation>
    </message>
    <message>
        <location filename="language_rows.cpp"/>
        <source>Lan&amp;guage</source>
        <translation>Lan&amp;gue</translation>
    </message>
    <message>
        <location filename="language_rows.cpp"/>
        <source>The language of the desktop.</source>
        <translation>La langue du bureau.</translation>
    </message>
    <message>
        <location filename="language_rows.cpp"/>
        <source>The window in English, at once.</source>
        <translation>La fenêtre en anglais, tout de suite.</translation>
    </message>
    <message>
        <location filename="language_rows.cpp"/>
        <source>The window in French, at once.</source>
        <translation>La fenêtre en français, tout de suite.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>1, breaks</source>
        <translation>1, rupture</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Choose what a material tears by, and its limit or its strengths.</source>
        <translation>Choisissez par quoi un matériau se déchire, et sa limite ou ses résistances.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Click the colours to type their range. The largest value of the moment stands below; click that to select what has it. An arrow at an end of the colours: some values lie beyond.</source>
        <translation>Cliquez sur les couleurs pour saisir leur intervalle. La plus grande valeur du moment figure dessous ; cliquez dessus pour sélectionner ce qui la porte. Une flèche au bout des couleurs : des valeurs sont au-delà.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Draw particles, or insert a design.</source>
        <translation>Dessinez des particules, ou insérez un modèle.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Every factor is 1. Paint with the brush, or type another one for what is selected.</source>
        <translation>Tous les facteurs valent 1. Peignez avec le pinceau, ou saisissez-en un autre pour la sélection.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Fabric has a stress where panels carry its pull, and where threads have a width.</source>
        <translation>Le tissu a une contrainte là où des panneaux portent sa traction, et là où ses fils ont une largeur.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Fabric stress</source>
        <translation>Contrainte du tissu</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Give materials a line strength, a warp strength or a breaking moment.</source>
        <translation>Donnez aux matériaux une résistance de la ligne, une résistance en chaîne ou un moment de rupture.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Of tear limit</source>
        <translation>De la limite de déchirure</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Panel load</source>
        <translation>Charge des panneaux</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Panels that carry the pull of their fabric have it: let the fabric of a part pull by panels.</source>
        <translation>Les panneaux qui portent la traction de leur tissu en ont : faites porter la traction d’une pièce par ses panneaux.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Stiffness factor</source>
        <translation>Facteur de raideur</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Strain</source>
        <translation>Déformation</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Strain is that of links, and of panels that carry the pull of their fabric.</source>
        <translation>La déformation est celle des liaisons, et des panneaux qui portent la traction de leur tissu.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Strength factor</source>
        <translation>Facteur de résistance</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Tension</source>
        <translation>Tension</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Tension is that of links. What panels carry is their fabric stress.</source>
        <translation>La tension est celle des liaisons. Ce que portent les panneaux est la contrainte du tissu.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>The air pushes panels: draw some between particles.</source>
        <translation>L’air pousse les panneaux : dessinez-en entre des particules.</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>Wrinkles</source>
        <translation>Plis</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>all as their materials</source>
        <translation>tous comme leurs matériaux</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no elastic panels</source>
        <translation>pas de panneaux élastiques</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no fabric of known width</source>
        <translation>pas de tissu de largeur connue</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no links here</source>
        <translation>aucune liaison ici</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no panels here</source>
        <translation>aucun panneau ici</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no particles here</source>
        <translation>aucune particule ici</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>no strength here</source>
        <translation>aucune résistance ici</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>nothing tears here</source>
        <translation>rien ne se déchire ici</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>peak %1</source>
        <translation>pic %1</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>slack</source>
        <translation>lâche</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>taut</source>
        <translation>tendu</translation>
    </message>
    <message>
        <location filename="legend.cpp"/>
        <source>wrinkled</source>
        <translation>plissé</translation>
    </message>
    <message>
        <location filename="line_drag.cpp"/>
        <source>line drag</source>
        <translation>la traînée des lignes</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>%1 It came in a blow, of which the time steps took much: without that it would be about %2 higher.</source>
        <translation>%1 Elle est venue d’un choc dont les pas de temps ont pris une bonne part : sans cela elle serait plus haute d’environ %2.</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>%1. %2: torn</source>
        <translation>%1. %2 : rompu</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>%1. It can bear %2.</source>
        <translation>%1. Supporte %2.</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Bending moment of the spar beside this link</source>
        <translation>Moment de flexion du longeron à côté de cette liaison</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Can bear</source>
        <translation>Supporte</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Load over strength: 1 breaks.</source>
        <translation>Charge sur résistance : rupture à 1.</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Pull along it</source>
        <translation>Traction le long de la liaison</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Pull of the thread over the width of cloth that it stands for</source>
        <translation>Traction du fil sur la largeur de toile qu’il représente</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Pull per width of the threads, warp or weft, that are nearer to their strength</source>
        <translation>Traction par largeur des fils, de chaîne ou de trame, les plus proches de leur résistance</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <location filename="load_list.cpp"/>
        <source>What it tears at, or else the strength of the material times its joint efficiency; over the safety factor of the scene.</source>
        <translation>Ce qui le rompt, ou sinon la résistance du matériau fois sa tenue des coutures et nœuds ; sur le coefficient de sécurité de la scène.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>%1 What has broken stands first, in the order in which it did; a click on it goes to that moment where it is recorded.</source>
        <translation>%1 Ce qui s’est rompu vient d’abord, dans l’ordre des ruptures ; un clic mène à ce moment s’il est enregistré.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>%1 places have broken: the list has those that broke first, and the worst of the others.</source>
        <translation>%1 endroits se sont rompus : la liste a ceux qui se sont rompus d’abord, et les pires des autres.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>A recording keeps no list of the worst of its run: fly the design to have one.</source>
        <translation>Un enregistrement ne garde pas la liste des pires de son vol : faites voler le modèle pour en avoir une.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Click a place to select it and bring it to the middle of the view.</source>
        <translation>Cliquer un endroit pour le sélectionner et l’amener au milieu de la vue.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Let it tear</source>
        <translation>Laisser déchirer</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Let it tear by its strength</source>
        <translation>Laisser déchirer à sa résistance</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Lets these materials tear by strength: cloth, lines and spars then break where their margin is 1.</source>
        <translation>Laisse ces matériaux se déchirer à leur résistance : tissu, lignes et espars rompent alors où leur marge vaut 1.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Loads of a canopy that opens are a third to two fifths below measured ones. %1</source>
        <translation>Les charges d’une voilure qui s’ouvre sont d’un tiers à deux cinquièmes inférieures à celles qu’on mesure. %1</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Never tears: %1. %2</source>
        <translation>Ne se déchire jamais : %1. %2</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>No material here has a strength for what it carries, so that nothing can be said to be near to breaking. Take a material of the library, or type a line strength, a warp and weft strength, or a breaking moment in the inspector.</source>
        <translation>Aucun matériau n’a ici de résistance pour ce qu’il porte, si bien que rien ne peut être dit près de rompre. Prendre un matériau de la bibliothèque, ou saisir dans l’inspecteur une résistance de la ligne, des résistances en chaîne et en trame, ou un moment de rupture.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Not judged, without a strength: %1</source>
        <translation>Non jugés, sans résistance : %1</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Nothing bears a load yet: run the scene.</source>
        <translation>Rien ne porte encore de charge : lancer la simulation.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Of the last run</source>
        <translation>Du dernier vol</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Select the materials</source>
        <translation>Sélectionner les matériaux</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Select these materials, so that the inspector shows their strengths.</source>
        <translation>Sélectionner ces matériaux, pour que l’inspecteur montre leurs résistances.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Take a safety factor</source>
        <translation>Prendre un coefficient de sécurité</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Take a safety factor of %1</source>
        <translation>Prendre un coefficient de sécurité de %1</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>The air in a canopy lacks what makes the opening shock, so that a real one may tear where this one holds. Margins count every strength as so many times lower; flights and tears stay as they are.</source>
        <translation>Il manque à l’air d’une voilure ce qui fait le choc à l’ouverture, de sorte qu’une vraie peut se déchirer là où celle-ci tient. Les marges comptent chaque résistance comme autant de fois plus faible ; vols et déchirures restent ce qu’ils sont.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>The worst of the run is the launch, %1 after the start: what is let go at rest is jerked.</source>
        <translation>Le pire du vol est le lancer, %1 après le début : ce qui est lâché au repos subit une secousse.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>There is no material here whose strength could be compared with a load. Insert a material of the library and give it to lines, cloth or spars.</source>
        <translation>Il n’y a ici aucun matériau dont la résistance puisse être comparée à une charge. Insérer un matériau de la bibliothèque et le donner à des lignes, des toiles ou des longerons.</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Worst now</source>
        <translation>À l’instant</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Worst of the run</source>
        <translation>Pires du vol</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Worst places now</source>
        <translation>Pires endroits maintenant</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>Worst places of the run</source>
        <translation>Pires endroits de la simulation</translation>
    </message>
    <message>
        <location filename="load_panel.cpp"/>
        <source>what has no material</source>
        <translation>ce qui n’a pas de matériau</translation>
    </message>
    <message>
        <location filename="main.cpp"/>
        <source>no item of the scene is called "%1", and it is no condition: %2</source>
        <translation>aucun élément de la scène ne s’appelle « %1 », et ce n’est pas une condition : %2</translation>
    </message>
    <message>
        <location filename="main_window.cpp"/>
        <source>%1[*] – Ripstop</source>
        <translation>%1[*] – Ripstop</translation>
    </message>
    <message>
        <location filename="main_window.cpp"/>
        <source>Main</source>
        <translation>Principale</translation>
    </message>
    <message>
        <location filename="main_window.cpp"/>
        <source>Several files were dropped, and none was opened: drop one alone.</source>
        <translation>Plusieurs fichiers ont été déposés, et aucun n’a été ouvert : en déposer un seul.</translation>
    </message>
    <message>
        <location filename="manifest.cpp"/>
        <source>is no manifest of a bundle</source>
        <translation>n’est pas le manifeste d’un dossier de simulation</translation>
    </message>
    <message>
        <location filename="manifest.cpp"/>
        <source>lacks something that a manifest has</source>
        <translation>n’a pas tout ce qu’a un manifeste</translation>
    </message>
    <message>
        <location filename="manifest.cpp"/>
        <source>was written by a later version of Ripstop; use that</source>
        <translation>a été écrit par une version plus récente de Ripstop ; l’utiliser</translation>
    </message>
    <message>
        <location filename="manual.cpp"/>
        <source>Nothing here opens the manual; open %1 in a browser.</source>
        <translation>Rien ici n’ouvre le manuel ; ouvrez %1 dans un navigateur.</translation>
    </message>
    <message>
        <location filename="manual.cpp"/>
        <source>The manual is not installed here; the page is %1.md of Ripstop's source.</source>
        <translation>Le manuel n’est pas installé ici ; la page est %1.md dans la source de Ripstop.</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>%1: %2 to %3</source>
        <translation>%1 : %2 à %3</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>&amp;Formula</source>
        <translation>&amp;Formule</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>&amp;Number</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>&amp;Picture</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Choose a picture</source>
        <translation>Choisir une image</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Each selected element gets the number that the formula gives where it lies: x, y and z in metres, u and v across and up the picture on the fabric, value what it has now, grey the picture below at u and v, 0 for black and 1 for white.</source>
        <translation>Chaque élément sélectionné reçoit le nombre que la formule donne là où il se trouve : x, y et z en mètres, u et v à travers et le long de l’image sur le tissu, value ce qu’il a maintenant, grey l’image ci-dessous en u et v, 0 pour le noir et 1 pour le blanc.</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Map by a formula</source>
        <translation>Carte par une formule</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Pictures (*.png *.pgm)</source>
        <translation>Images (*.png *.pgm)</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>Select particles, links or panels to map.</source>
        <translation>Sélectionnez des particules, des liaisons ou des panneaux.</translation>
    </message>
    <message>
        <location filename="map_dialog.cpp"/>
        <source>none</source>
        <comment>picture</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 cannot be in %2; it is measured in %3.</source>
        <translation>%1 ne peut pas être en %2 ; l’unité est %3.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 must be one of %2.</source>
        <translation>%1 doit être l’un de %2.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 needs a number as its value and a text as its unit.</source>
        <translation>%1 demande un nombre comme valeur (value) et un texte comme unité (unit).</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 needs an object with value, unit, standing and source.</source>
        <translation>%1 demande un objet avec value, unit, standing et source.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 needs its source: who says so, or how it was found.</source>
        <translation>%1 demande sa source : qui le dit, ou comment on l’a trouvé.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 needs its standing, one of %2.</source>
        <translation>%1 demande son statut (standing), l’un de %2.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1 needs its unit, %2 or one that measures the same.</source>
        <translation>%1 demande son unité, %2 ou une autre de même nature.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1, line %2, column %3: This is not JSON; look for a comma, a quotation mark or a bracket that is missing or too much there.</source>
        <translation>%1, ligne %2, colonne %3 : ce n’est pas du JSON ; il y manque une virgule, un guillemet ou une parenthèse, ou il y en a en trop.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1, material %2: %3</source>
        <translation>%1, matériau %2 : %3</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: A number in it is too large to be read.</source>
        <translation>%1 : un nombre y est trop grand pour être lu.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: It needs "materials", a list of them.</source>
        <translation>%1 : il manque « materials », leur liste.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: Its version is not %2; a newer Ripstop may read it.</source>
        <translation>%1 : sa version n’est pas %2 ; un Ripstop plus récent le lira peut-être.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: Material %2 of the list has no name.</source>
        <translation>%1 : le matériau %2 de la liste n’a pas de nom.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: The source "%2" must be a text.</source>
        <translation>%1 : la source « %2 » doit être un texte.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: This is no file of materials; those begin with "format": "%2".</source>
        <translation>%1 : ce n’est pas un fichier de matériaux ; ceux-ci commencent par "format": "%2".</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>%1: Two materials are called %2; give one another name.</source>
        <translation>%1 : deux matériaux s’appellent %2 ; renommer l’un d’eux.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>Each point of the curve is a pair of numbers, load and strain.</source>
        <translation>Chaque point de la courbe est une paire de nombres, charge et déformation.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>It needs "numbers", an object with at least one of them.</source>
        <translation>Il manque « numbers », un objet avec au moins un nombre.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>Loads and strains of the curve must rise from point to point.</source>
        <translation>Charges et déformations de la courbe doivent croître de point en point.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>The curve needs a loadUnit like %1 and a strainUnit like %2.</source>
        <translation>La courbe demande un loadUnit comme %1 et un strainUnit comme %2.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>The curve needs points: pairs of load and strain.</source>
        <translation>La courbe demande des points : des paires de charge et de déformation.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>The kind must be one of %1.</source>
        <translation>La nature (kind) doit être l’une de %1.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>The yarn must be one of %1, or left out.</source>
        <translation>Le fil (yarn) doit être l’un de %1, ou absent.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>There is no number "%1"; did you mean "%2"?</source>
        <translation>Il n’y a pas de nombre « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>There is no number "%1"; there are %2.</source>
        <translation>Il n’y a pas de nombre « %1 » ; il y a %2.</translation>
    </message>
    <message>
        <location filename="material_file.cpp"/>
        <source>kind, label, short, note and yarn must be texts.</source>
        <translation>kind, label, short, note et yarn doivent être des textes.</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>%1 (own)</source>
        <translation>%1 (personnel)</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>%1 is of %2 now: %3.</source>
        <translation>%1 est maintenant en %2 : %3.</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>%1: %2, %3</source>
        <translation>%1 : %2, %3</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Heavier</source>
        <translation>Plus lourd</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Lighter</source>
        <translation>Plus léger</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Particles keep their mass, because the density of before or of the preset is not known.</source>
        <translation>Les particules gardent leur masse, car la masse surfacique ou linéique d’avant, ou celle du préréglage, n’est pas connue.</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Select a material, or cloth, lines or spars that are made of one.</source>
        <translation>Sélectionnez un matériau, ou du tissu, des lignes ou des longerons qui en sont faits.</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Softer</source>
        <translation>Plus souple</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Stiffer</source>
        <translation>Plus raide</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Stronger</source>
        <translation>Plus résistant</translation>
    </message>
    <message>
        <location filename="material_step.cpp"/>
        <source>Weaker</source>
        <translation>Moins résistant</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>%1 %2 %3, standard error %4 (%5 %); %6 points from %7 to %8 %9</source>
        <translation>%1 %2 %3, erreur type %4 (%5 %) ; %6 points de %7 à %8 %9</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>All points of the range have the same elongation.</source>
        <translation>Tous les points de l’intervalle ont le même allongement.</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>The force does not rise in this range; choose another one.</source>
        <translation>La force ne croît pas dans cet intervalle ; en choisir un autre.</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>The force falls from the first row on; a test begins where it is slack.</source>
        <translation>La force décroît dès la première ligne ; un essai commence à l’état lâche.</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>The force is never above 0: are the columns in the other order?</source>
        <translation>La force n’est jamais au-dessus de 0 : les colonnes sont-elles dans l’autre ordre ?</translation>
    </message>
    <message>
        <location filename="material_test.cpp"/>
        <source>There are %1 points between %2 and %3 %4; a fit needs three or more.</source>
        <translation>Il y a %1 points entre %2 et %3 %4 ; il en faut au moins trois pour un ajustement.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>%1 cannot be read, or is larger than 20 MB.</source>
        <translation>%1 est illisible ou dépasse 20 Mo.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>%1: it %2.</source>
        <translation>%1 : valeur qui %2.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>%1: it must be above 0.</source>
        <translation>%1 : doit être supérieur à 0.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Called</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Length</source>
        <translation>&amp;Longueur</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Pulled</source>
        <translation>&amp;Traction</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Save as own material</source>
        <translation>&amp;Enregistrer comme matériau personnel</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Unit of force</source>
        <translation>&amp;Unité de force</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>&amp;to elongation</source>
        <translation>&amp;à l’allongement</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>A table with a column for the force and one for the elongation, and a header: force (N),elongation (mm)</source>
        <translation>Un tableau avec une colonne pour la force et une pour l’allongement, et un en-tête : force (N),elongation (mm)</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Across the warp</source>
        <translation>En travers de la chaîne</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Along the warp</source>
        <translation>Dans le sens de la chaîne</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Broke at %1 N and %2</source>
        <translation>Rupture à %1 N et %2</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Choose a &amp;file…</source>
        <translation>Choisir un &amp;fichier…</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Deflection (mm)</source>
        <translation>Flèche (mm)</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Did not break: largest force %1 N, at %2</source>
        <translation>Pas de rupture : plus grande force %1 N, à %2</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>F&amp;it from elongation</source>
        <translation>A&amp;juster de l’allongement</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Force (N)</source>
        <translation>Force (N)</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Line, pulled</source>
        <translation>Ligne, tirée</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Material from a test</source>
        <translation>Matériau d’après un essai</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Or draw a rectangle over the plot.</source>
        <translation>Ou tracer un rectangle sur le graphique.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Residual %1 N</source>
        <translation>Résidu %1 N</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Rod on two supports, pressed in the middle</source>
        <translation>Tige sur deux appuis, chargée au milieu</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>S&amp;pecimen</source>
        <translation>É&amp;prouvette</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Strain (%)</source>
        <translation>Déformation (%)</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Strip of cloth, pulled</source>
        <translation>Bande de tissu, tirée</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation>Tableaux (*.csv *.txt *.tsv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Test of a material</source>
        <translation>Essai d’un matériau</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>The range: it %1.</source>
        <translation>L’intervalle : valeur qui %1.</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>Unit of &amp;elongation</source>
        <translation>Unité d’&amp;allongement</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>name of the material</source>
        <translation>nom du matériau</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>of the header, as in “elongation (mm)”</source>
        <translation>celle de l’en-tête, comme « elongation (mm) »</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>of the header, as in “force (N)”</source>
        <translation>celle de l’en-tête, comme « force (N) »</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>where 10 % of the largest force is</source>
        <translation>où la force est à 10 % de la plus grande</translation>
    </message>
    <message>
        <location filename="material_test_dialog.cpp"/>
        <source>where 60 % of the largest force is</source>
        <translation>où la force est à 60 % de la plus grande</translation>
    </message>
    <message>
        <location filename="measure.cpp"/>
        <source>Measure %1</source>
        <translation>Mesurer %1</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>%1 is measured on %2: select that first.</source>
        <translation>« %1 » se mesure sur : %2 ; le sélectionner d’abord.</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Air</source>
        <translation>A&amp;ir</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Between particles</source>
        <translation>&amp;Entre particules</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Links and fabric</source>
        <translation>&amp;Liaisons et tissu</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Place and motion</source>
        <translation>&amp;Place et mouvement</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <location filename="measure_rows.cpp"/>
        <source>&amp;Whole scene</source>
        <translation>&amp;Toute la scène</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Play</source>
        <translation>&amp;Lancer</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir : %1</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler : %1</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>New from te&amp;mplate</source>
        <translation>Nouveau à partir d’un &amp;modèle</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>No scene has been opened or saved yet.</source>
        <translation>Aucune scène n’a encore été ouverte ni enregistrée.</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>None yet: File, Save as template</source>
        <translation>Aucun pour l’instant : Fichier, Enregistrer comme gabarit</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Nothing has been changed yet.</source>
        <translation>Rien n’a encore été modifié.</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Nothing has been undone.</source>
        <translation>Rien n’a été annulé.</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Panels and &amp;docks</source>
        <translation>Pa&amp;nneaux de la fenêtre</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Select something first: in the view, in the outline or with the menu Select.</source>
        <translation>Sélectionnez d’abord quelque chose : dans la vue, dans l’arborescence ou par le menu Sélectionner.</translation>
    </message>
    <message>
        <location filename="menus.cpp"/>
        <source>Show the &amp;folder</source>
        <translation>Afficher le &amp;dossier</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 cannot be opened; check that you may read it.</source>
        <translation>Le maillage %1 ne peut pas être ouvert ; vérifier que vous pouvez le lire.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 cannot be read (%2).</source>
        <translation>Le maillage %1 ne peut pas être lu (%2).</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 cannot be read to its end; check the disk.</source>
        <translation>Le maillage %1 ne peut pas être lu jusqu’au bout ; vérifier le disque.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 does not exist; check the name and the folder.</source>
        <translation>Le maillage %1 n’existe pas ; vérifier le nom et le dossier.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 has a vertex that is not finite (the one at place %2); save it again.</source>
        <translation>Le maillage %1 a un sommet non fini (celui de rang %2) ; l’enregistrer de nouveau.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 has no face with an area; choose a file with a surface.</source>
        <translation>Le maillage %1 n’a aucune face avec une aire ; choisir un fichier avec une surface.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 has no faces; choose a file with a surface.</source>
        <translation>Le maillage %1 n’a pas de faces ; choisir un fichier avec une surface.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 is a folder; choose a file in it.</source>
        <translation>Le maillage %1 est un dossier ; y choisir un fichier.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 is empty; save it again.</source>
        <translation>Le maillage %1 est vide ; l’enregistrer de nouveau.</translation>
    </message>
    <message>
        <location filename="mesh_file.cpp"/>
        <source>The mesh %1 is larger than 1 GiB; make it coarser in a mesh program first.</source>
        <translation>Le maillage %1 dépasse 1 Gio ; le rendre d’abord plus grossier dans un logiciel de maillage.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>%1: if its file has a wrong unit, scale it to a size.</source>
        <translation>%1 : si l’unité du fichier est fausse, le mettre à une taille.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>%1: if its file is in %2, it is %3 m.</source>
        <translation>%1 : si son fichier est en %2, il fait %3 m.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>%1: if that is wrong, scale it to a size.</source>
        <translation>%1 : si c’est faux, le mettre à une taille.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>All faces of the mesh lie in one point; choose another file.</source>
        <translation>Toutes les faces du maillage sont en un point ; choisir un autre fichier.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The material %1 has no mass per area; give one above 0 kg/m^2, or choose a preset.</source>
        <translation>Le matériau %1 n’a pas de masse surfacique ; en donner une au-dessus de 0 kg/m^2, ou choisir un préréglage.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The mesh has too many triangles; make it coarser in a mesh program.</source>
        <translation>Le maillage a trop de triangles ; le rendre plus grossier dans un logiciel de maillage.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The mesh is %1 m large, and hardly any fabric is</source>
        <translation>Le maillage fait %1 m, ce que presque aucun tissu ne fait</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The mesh is only %1 m large</source>
        <translation>Le maillage ne fait que %1 m</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The mesh is scaled to %1 m: hardly any fabric has such a size.</source>
        <translation>Le maillage est mis à %1 m : presque aucun tissu n’a cette taille.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The mesh would be more than 1000 km wide; choose a smaller unit.</source>
        <translation>Le maillage ferait plus de 1000 km de large ; choisir une unité plus petite.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The scale of the mesh must be above 0.</source>
        <translation>L’échelle du maillage doit être au-dessus de 0.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The texture turns the warp by %1 degrees from the edges of the mesh, and threads run along these: the cloth will be stiffer than it is so cut. Have panels carry its pull.</source>
        <translation>La texture tourne la chaîne de %1 degrés par rapport aux arêtes du maillage, que suivent les fils : le tissu sera plus raide qu’il ne l’est, coupé ainsi. Faites porter sa traction par des panneaux.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>The weld tolerance must be 0 or more, and smaller than the mesh.</source>
        <translation>La tolérance de soudure doit être 0 ou plus, et plus petite que le maillage.</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <location filename="mesh_import.cpp"/>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <location filename="mesh_preview.cpp"/>
        <source>Drag or use the arrow keys to turn, the wheel to zoom; a double click shows all. Blue is the front of the fabric, ochre its back.</source>
        <translation>Glisser ou utiliser les flèches pour tourner, la molette pour zoomer ; un double-clic montre tout. Le bleu est l’endroit du tissu, l’ocre son envers.</translation>
    </message>
    <message>
        <location filename="mesh_preview.cpp"/>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 and the files that it names are larger than 1 GiB; make it coarser in a mesh program first.</source>
        <translation>Le maillage %1 et les fichiers qu’il nomme dépassent 1 Gio ; le rendre d’abord plus grossier dans un logiciel de maillage.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 asks for more memory than a file of its size may need; it is damaged, or has to be saved in another format.</source>
        <translation>Le maillage %1 demande plus de mémoire qu’un fichier de sa taille n’en peut nécessiter ; il est endommagé, ou doit être enregistré dans un autre format.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 cannot be read (%2). The file may be cut off or of another format; save it again, or choose another file.</source>
        <translation>Le maillage %1 ne peut pas être lu (%2). Le fichier est peut-être tronqué ou d’un autre format ; l’enregistrer de nouveau, ou choisir un autre fichier.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 cannot be read, as the program %2 could not be started (%3).</source>
        <translation>Le maillage %1 ne peut pas être lu, car le programme %2 n’a pas pu être démarré (%3).</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 cannot be read, as the program %2 is not beside this one; install it there, or save the mesh as OBJ, PLY or OFF.</source>
        <translation>Le maillage %1 ne peut pas être lu, car le programme %2 n’est pas à côté de celui-ci ; l’y installer, ou enregistrer le maillage en OBJ, PLY ou OFF.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 has no known format; choose an OBJ, STL, PLY, OFF, glTF, GLB, Collada (.dae), VTP or VTU file.</source>
        <translation>Le maillage %1 n’a pas de format connu ; choisissez un fichier OBJ, STL, PLY, OFF, glTF, GLB, Collada (.dae), VTP ou VTU.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 is damaged: the library that reads its format crashed on it. Save it again in a mesh program, as OBJ or PLY for example.</source>
        <translation>Le maillage %1 est endommagé : la bibliothèque qui lit son format s’est arrêtée dessus. L’enregistrer de nouveau dans un logiciel de maillage, en OBJ ou PLY par exemple.</translation>
    </message>
    <message>
        <location filename="mesh_process.cpp"/>
        <source>The mesh %1 takes longer to read than a file of its size may; it is damaged, or has to be saved in another format.</source>
        <translation>La lecture du maillage %1 prend plus de temps qu’un fichier de sa taille n’en devrait demander ; il est endommagé, ou doit être enregistré dans un autre format.</translation>
    </message>
    <message>
        <location filename="mesh_repair.cpp"/>
        <source>No face of the mesh has an area; lower the weld tolerance, or check the mesh in a mesh program.</source>
        <translation>Aucune face du maillage n’a d’aire ; baisser la tolérance de soudure, ou vérifier le maillage dans un logiciel de maillage.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 closed pieces were inside out: turned over.</source>
        <translation>%1 morceaux fermés étaient à l’envers : retournés.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 edges belong to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there.</source>
        <translation>%1 arêtes appartiennent à plus de deux faces : gardées. C’est juste là où une quille ou une nervure rencontre une voile ; le tissu n’y résiste pas à la flexion.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 edges belong to one face only: the rim of the fabric, in %2 rims.</source>
        <translation>%1 arêtes n’appartiennent qu’à une face : le bord du tissu, en %2 bords.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 edges belong to one face only: the rim of the fabric.</source>
        <translation>%1 arêtes n’appartiennent qu’à une face : le bord du tissu.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 edges have no outside: the surface turns over itself like a Moebius strip.</source>
        <translation>%1 arêtes n’ont pas d’extérieur : la surface se retourne comme un ruban de Möbius.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 faces have no area: left out.</source>
        <translation>%1 faces n’ont pas d’aire : omises.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 faces have the corners of another one: left out.</source>
        <translation>%1 faces ont les coins d’une autre : omises.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 faces were wound against their neighbours: turned over.</source>
        <translation>%1 faces étaient orientées contre leurs voisines : retournées.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 lines and single points of the file were left out.</source>
        <translation>%1 lignes et points isolés du fichier ont été omis.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 polygons of more than three corners became triangles.</source>
        <translation>%1 polygones de plus de trois coins sont devenus des triangles.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 vertices belong to no face: left out.</source>
        <translation>%1 sommets n’appartiennent à aucune face : omis.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 vertices lie on a seam of the texture: a picture is printed by the first of their texture points. The warp follows each face.</source>
        <translation>%1 sommets se trouvent sur une couture de la texture : une image est imprimée d’après le premier de leurs points de texture. La chaîne suit chaque face.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 vertices lie on another one: joined.</source>
        <translation>%1 sommets sont sur un autre : joints.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%1 vertices lie on sides of faces: joined to them.</source>
        <translation>%1 sommets se trouvent sur des côtés de faces : joints à ceux-ci.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%2 files of colours or pictures that the mesh names, %1 the first, were not found: the fabric goes without.</source>
        <translation>%2 fichiers de couleurs ou d’images que le maillage nomme, %1 le premier, n’ont pas été trouvés : le tissu s’en passe.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%2 objects, %1 the first, have no face with an area: left out.</source>
        <translation>%2 objets, dont %1 le premier, n’ont aucune face d’aire non nulle : écartés.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>%2 polygons are not flat: corners lie up to %1 mm off their planes. The triangles that they became fold them along diagonals.</source>
        <translation>%2 polygones ne sont pas plans : des coins sont jusqu’à %1 mm de leur plan. Les triangles qu’ils sont devenus les plient le long de diagonales.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 closed piece was inside out: turned over.</source>
        <translation>1 morceau fermé était à l’envers : retourné.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 edge belongs to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there.</source>
        <translation>1 arête appartient à plus de deux faces : gardée. C’est juste là où une quille ou une nervure rencontre une voile ; le tissu n’y résiste pas à la flexion.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 edge belongs to one face only: the rim of the fabric.</source>
        <translation>1 arête n’appartient qu’à une face : le bord du tissu.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 edge has no outside: the surface turns over itself like a Moebius strip.</source>
        <translation>1 arête n’a pas d’extérieur : la surface se retourne comme un ruban de Möbius.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 face has no area: left out.</source>
        <translation>1 face n’a pas d’aire : omise.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 face has the corners of another one: left out.</source>
        <translation>1 face a les coins d’une autre : omise.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 face was wound against its neighbours: turned over.</source>
        <translation>1 face était orientée contre ses voisines : retournée.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 file of colours or pictures that the mesh names, %1, was not found: the fabric goes without.</source>
        <translation>Un fichier de couleurs ou d’images que le maillage nomme, %1, n’a pas été trouvé : le tissu s’en passe.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 line or single point of the file was left out.</source>
        <translation>1 ligne ou point isolé du fichier a été omis.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 object, %1, has no face with an area: left out.</source>
        <translation>1 objet, %1, n’a aucune face d’aire non nulle : écarté.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 polygon is not flat: a corner lies %1 mm off its plane. The triangles that it became fold it along a diagonal.</source>
        <translation>1 polygone n’est pas plan : un coin est à %1 mm de son plan. Les triangles qu’il est devenu le plient le long d’une diagonale.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 polygon of more than three corners became triangles.</source>
        <translation>1 polygone de plus de trois coins est devenu des triangles.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 vertex belongs to no face: left out.</source>
        <translation>1 sommet n’appartient à aucune face : omis.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 vertex lies on a seam of the texture: a picture is printed by the first of its texture points. The warp follows each face.</source>
        <translation>1 sommet se trouve sur une couture de la texture : une image est imprimée d’après le premier de ses points de texture. La chaîne suit chaque face.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 vertex lies on a side of a face: joined to it.</source>
        <translation>1 sommet se trouve sur le côté d’une face : joint à celui-ci.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>1 vertex lies on another one: joined.</source>
        <translation>1 sommet est sur un autre : joint.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>The mesh is %1 pieces that nothing joins. A larger weld tolerance may join those of one part; parts of their own stay apart.</source>
        <translation>Le maillage est en %1 morceaux que rien ne joint. Une plus grande tolérance de soudure peut joindre ceux d’une même pièce ; les pièces à part restent séparées.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>The mesh is larger than 30 m or smaller than 5 cm: check its unit.</source>
        <translation>Le maillage fait plus de 30 m ou moins de 5 cm : vérifier son unité.</translation>
    </message>
    <message>
        <location filename="mesh_report.cpp"/>
        <source>The mesh is one piece.</source>
        <translation>Le maillage est d’un seul tenant.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>%1 has no density from which a step could be made: choose a material of the library for it first.</source>
        <translation>%1 n’a pas de masse surfacique ou linéique d’où partir : choisissez-lui d’abord un matériau de la bibliothèque.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>%1 has no stiffness from which a step could be made: choose a material of the library for it first.</source>
        <translation>%1 n’a pas de raideur d’où partir : choisissez-lui d’abord un matériau de la bibliothèque.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>%1 has no strength from which a step could be made: choose a material of the library for it first.</source>
        <translation>%1 n’a pas de résistance d’où partir : choisissez-lui d’abord un matériau de la bibliothèque.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Heavier: %1</source>
        <translation>Plus lourd : %1</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Lighter: %1</source>
        <translation>Plus léger : %1</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Softer: %1</source>
        <translation>Plus souple : %1</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Stiffer: %1</source>
        <translation>Plus raide : %1</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Stronger: %1</source>
        <translation>Plus résistant : %1</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing heavier than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de plus lourd que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing lighter than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de plus léger que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing softer than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de plus souple que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing stiffer than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de plus raide que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing stronger than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de plus résistant que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>The library has nothing weaker than %1 that is known as well.</source>
        <translation>La bibliothèque n’a rien de moins résistant que %1 qui soit aussi bien connu.</translation>
    </message>
    <message>
        <location filename="neighbours.cpp"/>
        <source>Weaker: %1</source>
        <translation>Moins résistant : %1</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 links of %2 begin more than twice or less than half as long as their rest lengths, link %3 with %4 m for %5 m: they pull or push hard from the first moment. Give them the lengths that they have without load.</source>
        <translation>%1 liaisons de %2 mesurent au départ plus du double ou moins de la moitié de leur longueur au repos, la liaison %3 %4 m au lieu de %5 m : elles tirent ou poussent fort dès le premier instant. Donnez-leur les longueurs qu’elles ont sans charge.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 links of %2 never stretch, and the fixed particles at their ends are off from their lengths, at link %3 by %4 %: what they pull is not known. Give them these lengths, or a stiffness.</source>
        <translation>%1 liaisons de %2 ne s’allongent jamais, et l’écart des particules fixes à leurs bouts diffère de leur longueur, à la liaison %3 de %4 % : leur traction reste inconnue. Donnez-leur ces longueurs, ou une raideur.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 of %2 begins %3 m long, and its rest length is %4 m: it pulls or pushes hard from the first moment. Give it the length that it has without load.</source>
        <translation>%1 de %2 mesure %3 m au départ, et sa longueur au repos est de %4 m : elle tire ou pousse fort dès le premier instant. Donnez-lui la longueur qu’elle a sans charge.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 of %2 has no links and will fly by itself.</source>
        <translation>%1 de %2 n’a pas de liaisons et volera seule.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 of %2 joins two particles that are joined already.</source>
        <translation>%1 de %2 joint deux particules déjà jointes.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>%1 of %2 never stretches, and the fixed particles at its ends are %3 % off from its length: what it pulls is not known. Give it that length, or a stiffness.</source>
        <translation>%1 de %2 ne s’allonge jamais, et l’écart des particules fixes à ses bouts diffère de sa longueur de %3 % : sa traction reste inconnue. Donnez-lui cette longueur, ou une raideur.</translation>
    </message>
    <message>
        <location filename="network_check.cpp"/>
        <source>The fabric of %1 pulls by threads and has none, so that nothing holds it together: have panels carry its pull (carrier=panels), or make threads of the sides of its panels (ripstop-cli convert --fabric threads).</source>
        <translation>Le tissu de %1 tire par des fils et n’en a pas, si bien que rien ne le tient : faites porter sa traction par les panneaux (carrier=panels), ou faites des fils des côtés de ses panneaux (ripstop-cli convert --fabric threads).</translation>
    </message>
    <message>
        <location filename="new_file.cpp"/>
        <source>%1 cannot be written: %2; choose another folder.</source>
        <translation>%1 ne peut pas être écrit : %2 ; choisir un autre dossier.</translation>
    </message>
    <message>
        <location filename="new_file.cpp"/>
        <source>%1 cannot be written: there is no folder %2; make it or choose another.</source>
        <translation>%1 ne peut pas être écrit : le dossier %2 n’existe pas ; le créer ou en choisir un autre.</translation>
    </message>
    <message>
        <location filename="new_file.cpp"/>
        <source>%1 was not saved: %2; make room or choose another folder.</source>
        <translation>%1 n’a pas été enregistré : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <location filename="new_file.cpp"/>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <location filename="number_field.cpp"/>
        <source>%1 %2; or change it by *1.1, +5 % or +0.2.</source>
        <translation>« %1 » %2 ; ou le changer par *1,1, +5 % ou +0,2.</translation>
    </message>
    <message>
        <location filename="number_field.cpp"/>
        <source>Drag sideways to change the value.</source>
        <translation>Faire glisser de côté pour changer la valeur.</translation>
    </message>
    <message>
        <location filename="number_field.cpp"/>
        <source>from material</source>
        <translation>du matériau</translation>
    </message>
    <message>
        <location filename="number_field.cpp"/>
        <source>from material (%1)</source>
        <translation>du matériau (%1)</translation>
    </message>
    <message>
        <location filename="number_table.cpp"/>
        <source>%1, line %2: "%3" is no number.</source>
        <translation>%1, ligne %2 : « %3 » n’est pas un nombre.</translation>
    </message>
    <message>
        <location filename="number_table.cpp"/>
        <source>%1, line %2: %3 has a decimal comma, and other cells have a decimal point; write all decimals alike.</source>
        <translation>%1, ligne %2 : %3 a une virgule décimale, et d’autres cellules un point décimal ; écrivez toutes les décimales de la même façon.</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>"%1" is a number with a decimal comma</source>
        <translation>« %1 » est un nombre à virgule décimale</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>"%1" is not a corner of a face</source>
        <translation>« %1 » n’est pas un coin de face</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>"%1" is not an end of a line</source>
        <translation>« %1 » n’est pas un bout de ligne</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>An OBJ has decimal points; save it again with those, or replace the commas.</source>
        <translation>Un OBJ a des points décimaux ; enregistrez-le de nouveau avec ceux-ci, ou remplacez les virgules.</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>Delete it in the file, or write it as a line (l); a program for meshes finds faces without area, too.</source>
        <translation>Supprimez-la dans le fichier, ou écrivez-la comme une ligne (l) ; un programme de maillages trouve aussi les faces sans aire.</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>The mesh %1, line %2: %3. %4</source>
        <translation>Le maillage %1, ligne %2 : %3. %4</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>Vertices count from 1, over all objects of the file; save it again from where it was made, with all vertices.</source>
        <translation>Les sommets comptent à partir de 1, sur tous les objets du fichier ; enregistrez-le de nouveau depuis son programme d’origine, avec tous les sommets.</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a face names vertex %1 of %2</source>
        <translation>une face nomme le sommet %1 sur %2</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a face needs three corners</source>
        <translation>une face demande trois coins</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a line names vertex %1 of %2</source>
        <translation>une ligne nomme le sommet %1 sur %2</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a texture point needs two finite numbers</source>
        <translation>un point de texture demande deux nombres finis</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a vertex is not finite</source>
        <translation>une coordonnée d’un sommet n’est pas un nombre fini</translation>
    </message>
    <message>
        <location filename="obj_file.cpp"/>
        <source>a vertex needs three numbers</source>
        <translation>un sommet demande trois nombres</translation>
    </message>
    <message>
        <location filename="off_file.cpp"/>
        <source>The mesh %1, line %2: %3. The file may be cut off; save it again.</source>
        <translation>Le maillage %1, ligne %2 : %3. Le fichier est peut-être tronqué ; l’enregistrer de nouveau.</translation>
    </message>
    <message>
        <location filename="off_file.cpp"/>
        <source>face %1 of %2 needs a count and as many vertices of the file</source>
        <translation>la face %1 sur %2 demande un nombre et autant de sommets du fichier</translation>
    </message>
    <message>
        <location filename="off_file.cpp"/>
        <source>the numbers of vertices and faces are missing</source>
        <translation>les nombres de sommets et de faces manquent</translation>
    </message>
    <message>
        <location filename="off_file.cpp"/>
        <source>vertex %1 of %2 needs three numbers</source>
        <translation>le sommet %1 sur %2 demande trois nombres</translation>
    </message>
    <message>
        <location filename="opened_study.cpp"/>
        <source>%1 measures the probe %2, and the scene has: %3.</source>
        <translation>%1 mesure la sonde %2, et la scène a : %3.</translation>
    </message>
    <message>
        <location filename="opened_study.cpp"/>
        <source>%1: %2: %3</source>
        <translation>%1 : %2 : %3</translation>
    </message>
    <message>
        <location filename="opened_study.cpp"/>
        <source>%1: the variable %2 sets controls, which are files; give it "values".</source>
        <translation>%1 : la variable %2 fixe des commandes, qui sont des fichiers ; donnez-lui des "values".</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>All that is selected lies on the plane and is its own mirror image. Choose another plane or a smaller tolerance.</source>
        <translation>Toute la sélection est sur le plan et est sa propre image. Choisir un autre plan ou une tolérance plus petite.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>No link is selected. Select the links that are to be split.</source>
        <translation>Aucune liaison n’est sélectionnée. Sélectionner les liaisons à diviser.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>No particle is selected. Select particles, links or panels first.</source>
        <translation>Aucune particule n’est sélectionnée. Sélectionner d’abord des particules, des liaisons ou des panneaux.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>No two of the selected particles are that near to each other. Select more, or weld over a longer distance.</source>
        <translation>Il n’y a pas deux particules sélectionnées aussi proches. En sélectionner plus, ou souder sur une plus grande distance.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>Nothing is selected that could be smoothed. Select fabric or lines, with more than their border and ends.</source>
        <translation>Rien de sélectionné ne peut être lissé. Sélectionner du tissu ou des lignes, avec plus que leur bord et leurs bouts.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>Nothing is selected that has a place. Select particles, links, panels or a part first.</source>
        <translation>Rien de sélectionné n’a de place. Sélectionner d’abord des particules, des liaisons, des panneaux ou une pièce.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>Nothing is selected. Select fabric or its part first.</source>
        <translation>Rien n’est sélectionné. Sélectionner d’abord du tissu ou sa pièce.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>The angle is 0, so that all would lie in one place. 360 is a full ring.</source>
        <translation>L’angle est 0, et tout serait au même endroit. 360 est un tour complet.</translation>
    </message>
    <message>
        <location filename="operation.cpp"/>
        <source>The step is 0, so that all would lie in one place. Give it a length.</source>
        <translation>Le pas est 0, et tout serait au même endroit. Lui donner une longueur.</translation>
    </message>
    <message>
        <location filename="operation_dialog.cpp"/>
        <source>Adds %1.</source>
        <translation>Ajoute %1.</translation>
    </message>
    <message>
        <location filename="operation_dialog.cpp"/>
        <source>Changes %1.</source>
        <translation>Change %1.</translation>
    </message>
    <message>
        <location filename="operation_dialog.cpp"/>
        <source>Removes %1.</source>
        <translation>Supprime %1.</translation>
    </message>
    <message>
        <location filename="operation_dialog.cpp"/>
        <source>They weigh %1, before %2.</source>
        <translation>Elles pèsent %1, avant %2.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--after needs a time in seconds, not "%1"</source>
        <translation>--after demande un temps en secondes, et non « %1 »</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--backdrop is one of %1</source>
        <translation>--backdrop est l’un de %1</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--color-by is one of %1</source>
        <translation>--color-by vaut l’un de %1</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--frames needs a number of pictures, not "%1"</source>
        <translation>--frames demande un nombre d’images, et non « %1 »</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--language is system, en or fr, not "%1"</source>
        <translation>--language vaut system, en ou fr, et non « %1 »</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--picture-width needs a number of pixels from 16 to %1, not "%2"</source>
        <translation>--picture-width demande un nombre de pixels de 16 à %1, et non « %2 »</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--size needs a size like 1280x800, not "%1"</source>
        <translation>--size demande une taille comme 1280x800, et non « %1 »</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>--theme is one of %1</source>
        <translation>--theme vaut l’un de %1</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Bring a panel to the front: tuning, table, problems, ...; more than once.</source>
        <translation>Amener un panneau au premier plan : tuning, table, problems, ... ; plusieurs fois possible.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Colour by one of %1.</source>
        <translation>Colorer selon l’un de : %1.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Colours: desktop, light or dark; as chosen in the View menu.</source>
        <translation>Couleurs : desktop, light ou dark ; comme choisi dans le menu Affichage.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Do this as from a menu, once the window is there: "insert bridle".</source>
        <translation>Faire ceci comme depuis un menu, une fois la fenêtre là : "insert bridle".</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Fill the picture with the item of this name.</source>
        <translation>Remplir l’image de l’objet de ce nom.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Language of the window: system, en or fr; as chosen in the View menu.</source>
        <translation>Langue de la fenêtre : system, en ou fr ; celle du menu Affichage sinon.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Legend and compass in a picture of the view.</source>
        <translation>Légende et boussole dans une image de la vue.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Marks of fixed particles in a picture of the view.</source>
        <translation>Marques des particules fixées dans une image de la vue.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Only the 3D view, without legend and compass.</source>
        <translation>La vue 3D seule, sans légende ni boussole.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Ripstop, an editor and simulator for fabric that flies.

ripstop-cli does the same work without a window.</source>
        <translation>Ripstop, un éditeur et simulateur de tissu qui vole.

ripstop-cli fait le même travail sans fenêtre.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Save a picture of the window as FILE (PNG), or of the view (also SVG, PDF), and quit.</source>
        <translation>Enregistrer une image de la fenêtre dans FILE (PNG), ou de la vue (aussi SVG, PDF), et quitter.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Scene to open (*.ripstop.json), recording to look back at (*.ripstop-run), or mesh to import (*.obj, *.stl, ...).</source>
        <translation>Scène à ouvrir (*.ripstop.json), enregistrement à revoir (*.ripstop-run), ou maillage à importer (*.obj, *.stl, ...).</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Select the item of this name, or what meets this condition: "mass &lt; 1 g".</source>
        <translation>Sélectionner l’objet de ce nom, ou ce qui remplit cette condition : "mass &lt; 1 g".</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Size of the window (1280x800).</source>
        <translation>Taille de la fenêtre (1280x800).</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Start the simulation at once.</source>
        <translation>Lancer la simulation tout de suite.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Take N pictures at equal steps up to that time; %1 in FILE becomes the number.</source>
        <translation>Prendre N images à pas égaux jusqu’à ce temps ; %1 dans FILE devient le numéro.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Take the picture after this much simulated time (0).</source>
        <translation>Prendre l’image après ce temps simulé (0).</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>What lies behind things in a picture of the view: scenery, white or transparent.</source>
        <translation>Ce qui se trouve derrière les objets dans une image de la vue : scenery, white ou transparent.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>Width of a picture of the view alone, for papers: 3000.</source>
        <translation>Largeur d’une image de la vue seule, pour les articles : 3000.</translation>
    </message>
    <message>
        <location filename="options.cpp"/>
        <source>one scene at a time; "%1" is one too many</source>
        <translation>une scène à la fois ; « %1 » est de trop</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>measure</source>
        <translation>mesurer mesure</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>screenshot image snapshot</source>
        <translation>capture écran instantané screenshot</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>stability errors warnings</source>
        <translation>stabilité erreurs avertissements</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>video movie animation</source>
        <translation>vidéo animation</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>zoom frame all reset camera</source>
        <translation>zoom cadrer tout recadrer caméra</translation>
    </message>
    <message>
        <location filename="other_words.cpp"/>
        <source>zoom frame selected focus</source>
        <translation>zoom cadrer sélection focus</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Add %1</source>
        <translation>Ajouter : %1</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Add a material, collider, wind, control, probe or group.</source>
        <translation>Ajouter un matériau, un obstacle, un vent, une commande, une sonde ou un groupe.</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Add item</source>
        <translation>Ajouter un objet</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Delete %1, and with it what hangs on it: %2?</source>
        <translation>Supprimer %1, et avec ce qui y est attaché : %2 ?</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Delete %1? What is made of it, %2, has then neither stiffness nor strength of its own.</source>
        <translation>Supprimer %1 ? Ce qui en est fait, %2, n’aura alors plus ni raideur ni résistance propres.</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Search names, or #17</source>
        <translation>Chercher un nom, ou #17</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Search the outline</source>
        <translation>Chercher dans l’arborescence</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Select what is made of it</source>
        <translation>Sélectionner ce qui en est fait</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Select what it refers to</source>
        <translation>Sélectionner ce qu’il désigne</translation>
    </message>
    <message>
        <location filename="outline.cpp"/>
        <source>Shows only what has this in its name. #17 and Enter selects what has the id 17; Enter alone selects all that is found.</source>
        <translation>Ne montre que ce qui a ceci dans son nom. #17 et Entrée sélectionne ce qui a l’id 17 ; Entrée seule sélectionne tout ce qui est trouvé.</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>%1 %2, id %3</source>
        <translation>%1 %2, id %3</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>Hidden; click to show it in the view.</source>
        <translation>Caché ; cliquer pour le montrer dans la vue.</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>Hide %1</source>
        <translation>Cacher %1</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>Show %1</source>
        <translation>Montrer %1</translation>
    </message>
    <message>
        <location filename="outline_model.cpp"/>
        <source>Shown in the view; click to hide it.</source>
        <translation>Montré dans la vue ; cliquer pour le cacher.</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>%1 is a folder or a device; name a file.</source>
        <translation>%1 est un dossier ou un périphérique ; nommer un fichier.</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>%1 was not written: %2; make room or choose another folder.</source>
        <translation>%1 n’a pas été écrit : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>The folder %1 cannot be made: %2; choose another target.</source>
        <translation>Le dossier %1 ne peut pas être créé : %2 ; choisir une autre cible.</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>a file has that name</source>
        <translation>un fichier porte ce nom</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>it is a folder or a device</source>
        <translation>c’est un dossier ou un périphérique</translation>
    </message>
    <message>
        <location filename="output_files.cpp"/>
        <source>the disk does not answer</source>
        <translation>le disque ne répond pas</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>&amp;What it is</source>
        <translation>N&amp;ature</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>As %1 in %2</source>
        <translation>Sous le nom %1 dans %2</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>Its name needs a letter from a to z or a digit.</source>
        <translation>Son nom demande une lettre de a à z ou un chiffre.</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>S&amp;ource</source>
        <translation>S&amp;ource</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>Save as own material</source>
        <translation>Enregistrer comme matériau personnel</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>Spar</source>
        <translation>Longeron</translation>
    </message>
    <message>
        <location filename="own_material_dialog.cpp"/>
        <source>who says so, or how it was found</source>
        <translation>qui le dit, ou comment on l’a trouvé</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 ne peut pas être lu : %2.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>%1 is no file: materials cannot be read from it.</source>
        <translation>%1 n’est pas un fichier : on ne peut pas y lire de matériaux.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>%1 is not saved, to lose nothing of a file that cannot be read. %2</source>
        <translation>%1 n’est pas enregistré, pour ne rien perdre d’un fichier illisible. %2</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>%1 is not saved: %2.</source>
        <translation>%1 n’est pas enregistré : %2.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>%1, material %2: A material of that name comes with Ripstop; give yours another one.</source>
        <translation>%1, matériau %2 : Ripstop fournit un matériau de ce nom ; donner un autre nom au vôtre.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>A material called %1 comes with Ripstop; choose another name.</source>
        <translation>Ripstop fournit un matériau nommé %1 ; choisir un autre nom.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>The material has no number that could be kept.</source>
        <translation>Le matériau n’a aucun nombre à garder.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>The material needs a name.</source>
        <translation>Le matériau a besoin d’un nom.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>There is an own material called %1 already; choose another name, or have it replaced.</source>
        <translation>Il y a déjà un matériau personnel nommé %1 ; choisir un autre nom, ou le faire remplacer.</translation>
    </message>
    <message>
        <location filename="own_materials.cpp"/>
        <source>There is no place for own materials: set XDG_DATA_HOME or HOME, or name a file.</source>
        <translation>Il n’y a pas de place pour des matériaux personnels : définir XDG_DATA_HOME ou HOME, ou nommer un fichier.</translation>
    </message>
    <message>
        <location filename="packed.cpp"/>
        <source>it is no compressed data</source>
        <translation>ce ne sont pas des données compressées</translation>
    </message>
    <message>
        <location filename="packed.cpp"/>
        <source>it is too short</source>
        <translation>c’est trop court</translation>
    </message>
    <message>
        <location filename="packed_pictures.cpp"/>
        <source>%1 has come since the mesh was read, with something else in it; import the mesh again.</source>
        <translation>%1 est arrivé depuis la lecture du maillage, avec un autre contenu ; importez de nouveau le maillage.</translation>
    </message>
    <message>
        <location filename="palette.cpp"/>
        <source>%1 (on)</source>
        <translation>%1 (activé)</translation>
    </message>
    <message>
        <location filename="palette.cpp"/>
        <source>Find an action</source>
        <translation>Trouver une action</translation>
    </message>
    <message>
        <location filename="palette.cpp"/>
        <source>No action has all of these words in its name, its menu or its help. Try fewer words, or others. Presets of materials are found while a material is selected.</source>
        <translation>Aucune action n’a tous ces mots dans son nom, son menu ou son aide. Essayez moins de mots, ou d’autres. Les préréglages de matériaux se trouvent quand un matériau est sélectionné.</translation>
    </message>
    <message>
        <location filename="palette.cpp"/>
        <source>Type what you want to do: mirror, pin, wind…</source>
        <translation>Taper ce que vous voulez faire : symétrie, fixer, vent…</translation>
    </message>
    <message>
        <location filename="panel_fabric.cpp"/>
        <source>%1 has threads and no panels that could carry their pull: draw panels over them first.</source>
        <translation>%1 a des fils et pas de panneaux qui pourraient porter leur traction : dessinez d’abord des panneaux dessus.</translation>
    </message>
    <message>
        <location filename="panel_fabric.cpp"/>
        <source>Panel %1 of %2 has no material and would carry nothing: give it that of the fabric first.</source>
        <translation>Le panneau %1 de %2 n’a pas de matériau et ne porterait rien : donnez-lui d’abord celui du tissu.</translation>
    </message>
    <message>
        <location filename="panel_fabric.cpp"/>
        <source>Panels of %1 would carry nothing, as their material %2 has no membrane stiffness: give it one first, in N/m, or the numbers of a fabric of the library.</source>
        <translation>Les panneaux de %1 ne porteraient rien, car leur matériau %2 n’a pas de raideur de membrane : donnez-lui-en d’abord une, en N/m, ou les nombres d’un tissu de la bibliothèque.</translation>
    </message>
    <message>
        <location filename="panel_fabric.cpp"/>
        <source>There is no fabric of threads here: no link has the role thread or bias and a width. Choose a part that has such links.</source>
        <translation>Il n’y a pas ici de tissu de fils : aucune liaison n’a le rôle fil ou biais et une largeur. Choisissez une pièce qui a de telles liaisons.</translation>
    </message>
    <message>
        <location filename="panel_fabric.cpp"/>
        <source>Threads to panels</source>
        <translation>Fils en panneaux</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>%1 must be %2 from %3.</source>
        <translation>« %1 » doit être %2 de %3.</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>%1 to %2%3</source>
        <translation>%1 à %2%3</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>%1; at first %2%3.</source>
        <translation>%1 ; au départ %2%3.</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>At first %1.</source>
        <translation>Au départ %1.</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>On the command line: %1</source>
        <translation>En ligne de commande : %1</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <location filename="parameter_field.cpp"/>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <location filename="parameter_form.cpp"/>
        <source>Does nothing now: it counts where %1 is not “%2”.</source>
        <translation>N’agit pas maintenant : compte là où %1 n’est pas « %2 ».</translation>
    </message>
    <message>
        <location filename="parameter_form.cpp"/>
        <source>Does nothing now: it counts where %1 is “%2”.</source>
        <translation>N’agit pas maintenant : compte là où %1 est « %2 ».</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>"%1" is a %2, not a %3</source>
        <translation>« %1 » est de la sorte %2, et non %3</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>"%1" is no path; write ITEM.PROPERTY, like settings.timeStep</source>
        <translation>« %1 » n’est pas un chemin ; écrire ÉLÉMENT.PROPRIÉTÉ, comme settings.timeStep</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>"%1" sets nothing; write PATH=VALUE, like settings.timeStep=0.002</source>
        <translation>« %1 » ne règle rien ; écrire CHEMIN=VALEUR, comme settings.timeStep=0.002</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>%1; did you mean "%2"?</source>
        <translation>%1 ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>%1; there is %2</source>
        <translation>%1 ; il y a %2</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>a %1 has no property "%2"</source>
        <translation>il n’y a pas, pour la sorte %1, de propriété « %2 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>no %1 is called "%2"</source>
        <translation>rien de la sorte %1 ne s’appelle « %2 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>no item is called "%1"</source>
        <translation>aucun élément ne s’appelle « %1 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>nothing in the scene has the id "%1"</source>
        <translation>rien dans la scène n’a l’id « %1 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>part "%1" has particles, links and panels, not "%2"</source>
        <translation>la pièce « %1 » a des particules, des liaisons et des panneaux, et non « %2 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>settings have no property "%1"</source>
        <translation>les réglages n’ont pas de propriété « %1 »</translation>
    </message>
    <message>
        <location filename="path.cpp"/>
        <source>the scene has no %1</source>
        <translation>la scène n’a rien de la sorte %1</translation>
    </message>
    <message>
        <location filename="percentile_chart.cpp"/>
        <source>25 to 75 %</source>
        <translation>de 25 à 75 %</translation>
    </message>
    <message>
        <location filename="percentile_chart.cpp"/>
        <source>5 to 95 %</source>
        <translation>de 5 à 95 %</translation>
    </message>
    <message>
        <location filename="percentile_chart.cpp"/>
        <source>ended early</source>
        <translation>arrêté tôt</translation>
    </message>
    <message>
        <location filename="percentile_chart.cpp"/>
        <source>median</source>
        <translation>médiane</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>%1 cm wide at 300 dots per inch.</source>
        <translation>%1 cm de large à 300 points par pouce.</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>&amp;Background:</source>
        <translation>&amp;Fond :</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>&amp;Kind:</source>
        <translation>T&amp;ype :</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>&amp;Pins</source>
        <translation>É&amp;pingles</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>&amp;Size:</source>
        <translation>&amp;Taille :</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>As in the window</source>
        <translation>Comme dans la fenêtre</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Choose the &amp;file…</source>
        <translation>&amp;Choisir le fichier…</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>For a page (3000 pixels wide)</source>
        <translation>Pour une page (3000 pixels de large)</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Four times as large</source>
        <translation>Quatre fois plus grande</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>JPEG has no transparency: the background will be white.</source>
        <translation>JPEG ne connaît pas la transparence : le fond sera blanc.</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>JPEG: pixels, small</source>
        <translation>JPEG : pixels, fichier léger</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Own size</source>
        <translation>Taille choisie</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>PDF: a page, with text</source>
        <translation>PDF : une page, avec du texte</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>PNG: pixels, may be transparent</source>
        <translation>PNG : pixels, transparence possible</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Picture of the view</source>
        <translation>Image de la vue</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>SVG: legend and compass as text</source>
        <translation>SVG : légende et boussole en texte</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Sky and ground</source>
        <translation>Ciel et sol</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>Twice as large</source>
        <translation>Deux fois plus grande</translation>
    </message>
    <message>
        <location filename="picture_dialog.cpp"/>
        <source>White paper, with shadows</source>
        <translation>Papier blanc, avec les ombres</translation>
    </message>
    <message>
        <location filename="picture_file.cpp"/>
        <source>%1 cannot be read: check the path.</source>
        <translation>%1 ne peut pas être lu : vérifier le chemin.</translation>
    </message>
    <message>
        <location filename="picture_file.cpp"/>
        <source>%1 has %2 x %3 pixels: make it smaller, of 64 million at most.</source>
        <translation>%1 a %2 x %3 pixels : réduisez-la à 64 millions au plus.</translation>
    </message>
    <message>
        <location filename="picture_file.cpp"/>
        <source>%1 has more than 256 MiB: make it smaller.</source>
        <translation>%1 a plus de 256 Mio : réduisez-la.</translation>
    </message>
    <message>
        <location filename="picture_file.cpp"/>
        <source>%1 is cut off or damaged: save or copy the picture again.</source>
        <translation>%1 est tronquée ou endommagée : enregistrez ou copiez l’image de nouveau.</translation>
    </message>
    <message>
        <location filename="picture_file.cpp"/>
        <source>%1 is neither a PNG nor a JPEG: save the picture as one of these.</source>
        <translation>%1 n’est ni un PNG ni un JPEG : enregistrer l’image sous l’un de ces formats.</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>A line through what is selected needs two particles in different places. Select one more, or choose x, y or z.</source>
        <translation>Une droite par la sélection demande deux particules à des endroits différents. En sélectionner une de plus, ou choisir x, y ou z.</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>A plane through what is selected needs three particles that are not in one line. Select one more, or choose x, y or z.</source>
        <translation>Un plan par la sélection demande trois particules non alignées. En sélectionner une de plus, ou choisir x, y ou z.</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>Let go</source>
        <translation>Lâcher</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>Pin</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <location filename="pin.cpp"/>
        <source>Unpin</source>
        <translation>Libérer</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>%1 must be a number of metres, not "%2".</source>
        <translation>%1 doit être un nombre de mètres, et non « %2 ».</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>A second wind adds to the first. On at first where the design has neither ground nor wind.</source>
        <translation>Un second vent s’ajoute au premier. Coché au départ si le modèle n’a ni sol ni vent.</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Beside what is there</source>
        <translation>À côté de ce qui est là</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Builders put their designs over the origin, at the height that they fly or hang at. Afterwards G moves what was inserted.</source>
        <translation>Les générateurs mettent leurs modèles au-dessus de l’origine, à la hauteur où ils volent ou pendent. Ensuite G déplace ce qui a été inséré.</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>In the middle of the view</source>
        <translation>Au milieu de la vue</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Its controls and probes</source>
        <translation>Ses commandes et ses sondes</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Its ground, wind and settings</source>
        <translation>Son sol, son vent et ses réglages</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Keys that steer it and what is measured of it.</source>
        <translation>Les touches qui le pilotent et ce qui en est mesuré.</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Moved by</source>
        <translation>Déplacé de</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Moved by, %1</source>
        <translation>Déplacé de, %1</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Place</source>
        <translation>Placer</translation>
    </message>
    <message>
        <location filename="place_form.cpp"/>
        <source>Where the builder has it</source>
        <translation>Là où le générateur le met</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>%1 has no column that is called %2; its first line names the variables of the study.</source>
        <translation>%1 n’a pas de colonne appelée %2 ; sa première ligne nomme les variables de l’étude.</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>%1 has no points; its first line names the variables.</source>
        <translation>%1 n’a pas de points ; sa première ligne nomme les variables.</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>%1: row %2 has no value for %3.</source>
        <translation>%1 : la ligne %2 n’a pas de valeur pour %3.</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>A plan of Sobol' has up to %1 variables, and this study %2; take latin_hypercube.</source>
        <translation>Un plan de Sobol a jusqu’à %1 variables, et cette étude %2 ; prendre latin_hypercube.</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>A plan of sensitivity has up to %1 variables, and this study %2.</source>
        <translation>Un plan de sensibilité a au plus %1 variables, et cette étude en a %2.</translation>
    </message>
    <message>
        <location filename="plan.cpp"/>
        <source>The plan has %1 points; a study has up to %2.</source>
        <translation>Le plan a %1 points ; une étude en a jusqu’à %2.</translation>
    </message>
    <message>
        <location filename="plot_arrangement.cpp"/>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <location filename="plot_arrangement.cpp"/>
        <source>Keep %1</source>
        <translation>Garder %1</translation>
    </message>
    <message>
        <location filename="plot_bands.cpp"/>
        <source>Error bands</source>
        <translation>Bandes d’erreur</translation>
    </message>
    <message>
        <location filename="plot_bands.cpp"/>
        <source>It may be off by %1, as the certificate has it.</source>
        <translation>Peut s’écarter de %1, d’après le certificat.</translation>
    </message>
    <message>
        <location filename="plot_bands.cpp"/>
        <source>Run &gt; Certify finds how far the values of this design may be off.</source>
        <translation>Simulation &gt; Certifier trouve de combien les valeurs de ce modèle peuvent s’écarter.</translation>
    </message>
    <message>
        <location filename="plot_bands.cpp"/>
        <source>The certificate is of another run: the design has been edited since, or the run was steered or touched.</source>
        <translation>Le certificat est celui d’une autre simulation : le modèle a été modifié depuis, ou la simulation a été pilotée ou touchée.</translation>
    </message>
    <message>
        <location filename="plot_bands.cpp"/>
        <source>The shade around a curve is how far its values may be off, by the certificate of this run. It ends where the run is no longer the one that was certified.</source>
        <translation>L’ombre autour d’une courbe dit de combien ses valeurs peuvent s’écarter, d’après le certificat de cette simulation. Elle finit là où la simulation n’est plus celle qui a été certifiée.</translation>
    </message>
    <message>
        <location filename="plot_list.cpp"/>
        <source>Do not plot %1</source>
        <translation>Ne pas tracer %1</translation>
    </message>
    <message>
        <location filename="plot_list.cpp"/>
        <source>Plot %1</source>
        <translation>Tracer %1</translation>
    </message>
    <message>
        <location filename="plot_list.cpp"/>
        <source>at %1 s</source>
        <translation>à %1 s</translation>
    </message>
    <message>
        <location filename="plot_list.cpp"/>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>%1 cannot be written.</source>
        <translation>%1 ne peut pas être écrit.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 ne peut pas être écrit : %2.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Add a plot</source>
        <translation>Ajouter un graphique</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Another panel, with curves of its own. The scene keeps it.</source>
        <translation>Un panneau de plus, avec ses propres courbes. La scène le garde.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Clear earlier runs</source>
        <translation>Effacer les simulations précédentes</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Copy the picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Copy the table</source>
        <translation>Copier le tableau</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Curves against</source>
        <translation>Courbes en fonction de</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Follow the run</source>
        <translation>Suivre la simulation</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>It is saved with the scene and comes back with it.</source>
        <translation>Il est enregistré avec la scène et revient avec elle.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Keep this plot in the scene</source>
        <translation>Garder ce graphique dans la scène</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Keep this range of values</source>
        <translation>Garder cet intervalle de valeurs</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Logarithmic values</source>
        <translation>Valeurs logarithmiques</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Name:</source>
        <translation>Nom :</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Off, the axis fits the curves. Needs curves of one unit.</source>
        <translation>Sinon, l'axe s'ajuste aux courbes. Il faut des courbes d'une même unité.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Off, the latest half minute is shown.</source>
        <translation>Décoché, la dernière demi-minute est montrée.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Off, the plot has all probes that are ticked for plots without their own.</source>
        <translation>Sinon, le graphique a toutes les sondes cochées pour les graphiques sans sondes propres.</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>PNG (*.png);;SVG (*.svg);;PDF (*.pdf)</source>
        <translation>PNG (*.png);;SVG (*.svg);;PDF (*.pdf)</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Probes of its own</source>
        <translation>Sondes propres</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Remove this plot</source>
        <translation>Retirer ce graphique</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Rename the plot</source>
        <translation>Renommer le graphique</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Rename the plot…</source>
        <translation>Renommer le graphique…</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Save picture…</source>
        <translation>Enregistrer l’image…</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Save the curves</source>
        <translation>Enregistrer les courbes</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Show the whole run</source>
        <translation>Montrer toute la simulation</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>Spectra</source>
        <translation>Spectres</translation>
    </message>
    <message>
        <location filename="plot_menu.cpp"/>
        <source>There is no value to write: what is plotted has read nothing.</source>
        <translation>Il n’y a aucune valeur à écrire : ce qui est tracé n’a rien mesuré.</translation>
    </message>
    <message>
        <location filename="plot_panel.cpp"/>
        <source>No probes. Add one in the outline to plot it.</source>
        <translation>Aucune sonde. En ajouter une dans l’arborescence pour la tracer.</translation>
    </message>
    <message>
        <location filename="plot_panel.cpp"/>
        <source>Tick a probe to plot it.</source>
        <translation>Cocher une sonde pour tracer sa courbe.</translation>
    </message>
    <message>
        <location filename="plot_panel.cpp"/>
        <source>run %1</source>
        <translation>simulation %1</translation>
    </message>
    <message>
        <location filename="plot_past.cpp"/>
        <source>%1, known from %2 on</source>
        <translation>%1, connu depuis %2</translation>
    </message>
    <message>
        <location filename="plot_played.cpp"/>
        <source>Reading the recording…</source>
        <translation>Lecture de l’enregistrement…</translation>
    </message>
    <message>
        <location filename="plot_played.cpp"/>
        <source>What these probes read is not in the recording.</source>
        <translation>Ce que mesurent ces sondes n’est pas dans l’enregistrement.</translation>
    </message>
    <message>
        <location filename="plot_view.cpp"/>
        <source>Choose the probe that the curves are against: right click.</source>
        <translation>Choisissez la sonde en abscisse des courbes : clic droit.</translation>
    </message>
    <message>
        <location filename="plot_view.cpp"/>
        <source>Remove this plot from the scene. Undo brings it back.</source>
        <translation>Retirer ce graphique de la scène. Annuler le ramène.</translation>
    </message>
    <message>
        <location filename="plot_view.cpp"/>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <location filename="plot_view.cpp"/>
        <source>frequency</source>
        <translation>fréquence</translation>
    </message>
    <message>
        <location filename="ply_file.cpp"/>
        <source>%1 %2 of %3 is not there</source>
        <translation>%1 %2 sur %3 manque</translation>
    </message>
    <message>
        <location filename="ply_file.cpp"/>
        <source>The import was cancelled.</source>
        <translation>L’importation a été annulée.</translation>
    </message>
    <message>
        <location filename="ply_file.cpp"/>
        <source>The mesh %1 cannot be read: %2. The file may be cut off; save it again.</source>
        <translation>Le maillage %1 ne peut pas être lu : %2. Le fichier est peut-être tronqué ; l’enregistrer de nouveau.</translation>
    </message>
    <message>
        <location filename="ply_file.cpp"/>
        <source>face %1 names vertex %2, and there are %3</source>
        <translation>la face %1 nomme le sommet %2, et il y en a %3</translation>
    </message>
    <message>
        <location filename="ply_file.cpp"/>
        <source>its header cannot be understood</source>
        <translation>son en-tête n’est pas compréhensible</translation>
    </message>
    <message>
        <location filename="point_scene.cpp"/>
        <source>Set %1</source>
        <translation>Régler %1</translation>
    </message>
    <message>
        <location filename="point_scene.cpp"/>
        <source>a component of %1 %2</source>
        <translation>une composante de %1 %2</translation>
    </message>
    <message>
        <location filename="point_scene.cpp"/>
        <source>the builder %1 has no parameter "%2"; did you mean "%3"?</source>
        <translation>le constructeur %1 n’a pas de paramètre « %2 » ; serait-ce « %3 » ?</translation>
    </message>
    <message>
        <location filename="point_scene.cpp"/>
        <source>the builder %1 has no parameter "%2"; ripstop-cli builders %3 lists them</source>
        <translation>le constructeur %1 n’a pas de paramètre « %2 » ; ripstop-cli builders %3 les énumère</translation>
    </message>
    <message>
        <location filename="point_scene.cpp"/>
        <source>the part "%1" was not made by a builder</source>
        <translation>la pièce « %1 » n’a pas été faite par un constructeur</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>Points of the study</source>
        <translation>Points de l’étude</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>held</source>
        <translation>a tenu</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>not flown</source>
        <translation>pas volé</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>outcome</source>
        <translation>issue</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <location filename="point_table.cpp"/>
        <source>tore</source>
        <translation>déchiré</translation>
    </message>
    <message>
        <location filename="polar_chart.cpp"/>
        <source>Angle of attack (degrees)</source>
        <translation>Angle d’attaque (degrés)</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>&amp;Coefficient</source>
        <translation>&amp;Coefficient</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>&amp;Material</source>
        <translation>&amp;Matériau</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>Drag coefficient</source>
        <translation>Coefficient de traînée</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>Lift coefficient</source>
        <translation>Coefficient de portance</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>Normal force coefficient</source>
        <translation>Coefficient de force normale</translation>
    </message>
    <message>
        <location filename="polar_dialog.cpp"/>
        <source>Polar of an air law</source>
        <translation>Polaire d’une loi d’air</translation>
    </message>
    <message>
        <location filename="pose.cpp"/>
        <source>Split</source>
        <translation>Fendre</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>&amp;Adopt pose</source>
        <translation>&amp;Adopter la pose</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Adds %1 where the mesh has parted.</source>
        <translation>Ajoute %1 là où le maillage s’est ouvert.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Adopt pose</source>
        <translation>Adopter la pose</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>As fast as they are now</source>
        <translation>À la vitesse qu’elles ont maintenant</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>At rest</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Keep them: links stay as stretched as they are</source>
        <translation>Les garder : les liaisons restent étirées comme elles le sont</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Leaves %1 where a hand has put them.</source>
        <translation>Laisse %1 là où une main les a mis.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Making the design…</source>
        <translation>Création du modèle…</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Moves %1.</source>
        <translation>Déplace %1.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Particles &amp;start</source>
        <translation>Les particules &amp;partent</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Pins %1 that a hand has pinned.</source>
        <translation>Fixe %1 qu’une main a fixées.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Rebind them: links have no strain in the new design</source>
        <translation>Les recaler : les liaisons sont sans déformation dans le nouveau modèle</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Removes %1 that are torn or cut.</source>
        <translation>Supprime %1, déchirés ou coupés.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>Rest &amp;lengths</source>
        <translation>&amp;Longueurs au repos</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>The next run goes on as this one would.</source>
        <translation>La prochaine simulation continue comme celle-ci l’aurait fait.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>The next run starts with this motion in links that are free of load.</source>
        <translation>La prochaine simulation part avec ce mouvement et des liaisons sans charge.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>The shape is the new unloaded shape: under load it gives way a little more.</source>
        <translation>Cette forme est la nouvelle forme sans charge : sous charge elle cède un peu plus.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>What hangs still now hangs still in the new design: its links carry the same loads.</source>
        <translation>Ce qui pend immobile le reste dans le nouveau modèle : ses liaisons portent les mêmes charges.</translation>
    </message>
    <message>
        <location filename="pose_dialog.cpp"/>
        <source>What the run has come to after %1 s becomes the design. Undo brings the old one back.</source>
        <translation>Ce que la simulation est devenue après %1 s devient le modèle. Annuler ramène l’ancien.</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>&amp;Language:</source>
        <translation>&amp;Langue :</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>&amp;Memory for recordings:</source>
        <translation>&amp;Mémoire des enregistrements :</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>&amp;Theme:</source>
        <translation>&amp;Thème :</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>Each run keeps up to this much of itself in memory; older moments go to a temporary file.</source>
        <translation>Chaque vol garde en mémoire jusqu’à cette quantité de lui-même ; les moments plus anciens vont dans un fichier temporaire.</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>Memory counts from the next run on.</source>
        <translation>La mémoire compte à partir de la prochaine simulation.</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <location filename="preferences_dialog.cpp"/>
        <source>nothing is recorded</source>
        <translation>rien n’est enregistré</translation>
    </message>
    <message>
        <location filename="preset.cpp"/>
        <source>E t of %1 N/m is more than the yarn in it can hold, %2 N/m at this weight; look at the units</source>
        <translation>E t de %1 N/m dépasse ce que son fil peut donner, %2 N/m à ce poids ; vérifier les unités</translation>
    </message>
    <message>
        <location filename="preset.cpp"/>
        <source>Poisson's ratio %1 is too large: with E t of %2 N/m along the warp and %3 N/m across it, it must be below %4</source>
        <translation>Le coefficient de Poisson %1 est trop grand : avec E t de %2 N/m dans le sens de la chaîne et %3 N/m en travers, il doit être inférieur à %4</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>%1 does nothing now: %2. %3</source>
        <translation>%1 est sans effet actuellement : %2. %3</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>&amp;Save as own material…</source>
        <translation>&amp;Enregistrer comme matériau personnel…</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Films</source>
        <translation>Films</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Own materials cannot be read</source>
        <translation>Matériaux personnels illisibles</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Spars</source>
        <translation>Longerons</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Take the numbers of a fabric, a line or a spar that one can buy.</source>
        <translation>Prendre les nombres d’un tissu, d’une ligne ou d’un longeron du commerce.</translation>
    </message>
    <message>
        <location filename="preset_chooser.cpp"/>
        <source>Where its numbers are from</source>
        <translation>D’où viennent ses nombres</translation>
    </message>
    <message>
        <location filename="presets.cpp"/>
        <source>Preset %1</source>
        <translation>Préréglage %1</translation>
    </message>
    <message>
        <location filename="presets.cpp"/>
        <source>There is no preset "%1"; did you mean "%2"?</source>
        <translation>Il n’y a pas de préréglage « %1 » ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <location filename="presets.cpp"/>
        <source>There is no preset "%1"; ripstop-cli presets lists them.</source>
        <translation>Il n’y a pas de préréglage « %1 » ; ripstop-cli presets les énumère.</translation>
    </message>
    <message>
        <location filename="probe_labels.cpp"/>
        <source>and %1 more in Plots</source>
        <translation>et %1 autres dans Courbes</translation>
    </message>
    <message>
        <location filename="problem_list.cpp"/>
        <source>Click a problem to select what causes it.</source>
        <translation>Cliquer un problème pour sélectionner ce qui le cause.</translation>
    </message>
    <message>
        <location filename="problem_list.cpp"/>
        <source>Error: %1</source>
        <translation>Erreur : %1</translation>
    </message>
    <message>
        <location filename="problem_list.cpp"/>
        <source>No problems</source>
        <translation>Aucun problème</translation>
    </message>
    <message>
        <location filename="problem_list.cpp"/>
        <source>Warning: %1</source>
        <translation>Avertissement : %1</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, %2 links</source>
        <translation>%1, %2 liaisons</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, %2 panels</source>
        <translation>%1, %2 panneaux</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, %2 particles</source>
        <translation>%1, %2 particules</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, link %2</source>
        <translation>%1, liaison %2</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, panel %2</source>
        <translation>%1, panneau %2</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1, particle %2</source>
        <translation>%1, particule %2</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1: %2 %3 -&gt; %4</source>
        <translation>%1 : %2 %3 -&gt; %4</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1: %2 %3 -&gt; %4 %5</source>
        <translation>%1 : %2 %3 -&gt; %4 %5</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1: %2 changed</source>
        <translation>%1 : %2 a changé</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1: %2 x %3</source>
        <translation>%1 : %2 x %3</translation>
    </message>
    <message>
        <location filename="property_difference.cpp"/>
        <source>%1: moved by up to %2</source>
        <translation>%1 : déplacement jusqu’à %2</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>%1&lt;br&gt;The default is %2.</source>
        <translation>%1&lt;br&gt;La valeur par défaut est %2.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>&lt;b&gt;Does nothing now:&lt;/b&gt; %1.&lt;br&gt;%2</source>
        <translation>&lt;b&gt;Sans effet pour l’instant :&lt;/b&gt; %1.&lt;br&gt;%2</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>&lt;b&gt;Does nothing now:&lt;/b&gt; %1.&lt;br&gt;Press: %2.</source>
        <translation>&lt;b&gt;Sans effet actuellement :&lt;/b&gt; %1.&lt;br&gt;Appuyer : %2.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Above %1</source>
        <translation>Au-dessus de %1</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Also with a unit (25 g, 2*15 cm), or *1.1, +5 %, +0.2; drag the label sideways.</source>
        <translation>Aussi avec une unité (25 g, 2*15 cm), ou *1,1, +5 %, +0,2 ; faire glisser le libellé de côté.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Back to the default</source>
        <translation>Revenir à la valeur par défaut</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Back to the default.</source>
        <translation>Revenir à la valeur par défaut.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Copy path, for --set</source>
        <translation>Copier le chemin, pour --set</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Fields that do nothing in the design as it is. Their names say why, and some can be made to count.</source>
        <translation>Des champs sans effet dans le modèle tel qu’il est. Leurs noms disent pourquoi, et certains peuvent être rendus utiles.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>From %1</source>
        <translation>À partir de %1</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>How it is computed (%1 fields)</source>
        <translation>Comment c’est calculé (%1 champs)</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Keep a slider for this in the tuning panel (Ctrl+T).</source>
        <translation>Garder un curseur pour ceci dans le panneau de mise au point (Ctrl+T).</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Make %1 count</source>
        <translation>Faire compter : %1</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Range: %1 to %2</source>
        <translation>Plage : %1 à %2</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Reset %1</source>
        <translation>Ramener %1</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Slider for %1</source>
        <translation>Curseur pour %1</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Slider in the tuning panel</source>
        <translation>Curseur dans le panneau de mise au point</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Study this…</source>
        <translation>Étudier ceci…</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Takes effect on reset</source>
        <translation>Prend effet à la réinitialisation</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Time step, solver and accuracy. The automatic solver chooses what fits.</source>
        <translation>Pas de temps, solveur et précision. Le solveur automatique choisit ce qui convient.</translation>
    </message>
    <message>
        <location filename="property_form.cpp"/>
        <source>Unit: %1</source>
        <translation>Unité : %1</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>&amp;Follow the values</source>
        <translation>&amp;Suivre les valeurs</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>&amp;Highest</source>
        <translation>&amp;Plus haute</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>&amp;Keep this range</source>
        <translation>&amp;Garder cet intervalle</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>&amp;Lowest</source>
        <translation>P&amp;lus basse</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>Range of colours</source>
        <translation>Intervalle des couleurs</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>The colours reach as far as the values of the moment, but for the largest 2 %.</source>
        <translation>Les couleurs vont jusqu’aux valeurs du moment, sauf les 2 % les plus grandes.</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>The highest %1.</source>
        <translation>La plus haute %1.</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>The highest has to be above the lowest.</source>
        <translation>La plus haute doit être au-dessus de la plus basse.</translation>
    </message>
    <message>
        <location filename="range_editor.cpp"/>
        <source>The lowest %1.</source>
        <translation>La plus basse %1.</translation>
    </message>
    <message>
        <location filename="read_bundle.cpp"/>
        <source>%1 has no %2 in it, which its manifest names; get it again.</source>
        <translation>%1 ne contient pas %2, que son manifeste nomme ; l’obtenir de nouveau.</translation>
    </message>
    <message>
        <location filename="read_bundle.cpp"/>
        <source>%1 is no bundle of Ripstop: it has no %2.</source>
        <translation>%1 n’est pas un dossier de simulation de Ripstop : il n’a pas de %2.</translation>
    </message>
    <message>
        <location filename="rebuild.cpp"/>
        <source>Change parameters of %1</source>
        <translation>Changer les paramètres de %1</translation>
    </message>
    <message>
        <location filename="recording.cpp"/>
        <source>The recording is damaged at this frame; choose another one.</source>
        <translation>L’enregistrement est abîmé à cette image ; en choisir une autre.</translation>
    </message>
    <message>
        <location filename="recording.cpp"/>
        <source>The run stopped before that: %1</source>
        <translation>La simulation s’est arrêtée avant : %1</translation>
    </message>
    <message>
        <location filename="recording_data.cpp"/>
        <source>A stretch of the recording is damaged; choose another time.</source>
        <translation>Un tronçon de l’enregistrement est abîmé ; choisir un autre instant.</translation>
    </message>
    <message>
        <location filename="recording_data.cpp"/>
        <source>The recording does not fit its design: it is damaged.</source>
        <translation>L’enregistrement ne va pas avec son modèle : il est abîmé.</translation>
    </message>
    <message>
        <location filename="recording_data.cpp"/>
        <source>The recording ends here, as %1.</source>
        <translation>L’enregistrement finit ici, car %1.</translation>
    </message>
    <message>
        <location filename="recording_data.cpp"/>
        <source>There is nothing in the recording.</source>
        <translation>Il n’y a rien dans l’enregistrement.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 %2 after %3 s of simulated time; what comes before is shown.</source>
        <translation>%1 %2 après %3 s de temps simulé ; ce qui précède est montré.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 %2 before its first frame; there is nothing to show.</source>
        <translation>%1 %2 avant sa première image ; il n’y a rien à montrer.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 can no longer be read; open it again.</source>
        <translation>%1 ne peut plus être lu ; l’ouvrir de nouveau.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 cannot be opened; check that you may read it.</source>
        <translation>%1 ne peut pas être ouvert ; vérifier que vous pouvez le lire.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 holds no frame.</source>
        <translation>%1 ne contient aucune image.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 is no file; name a recording (*.ripstop-run).</source>
        <translation>%1 n’est pas un fichier ; nommer un enregistrement (*.ripstop-run).</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 is not a recording of Ripstop (*.ripstop-run).</source>
        <translation>%1 n’est pas un enregistrement de Ripstop (*.ripstop-run).</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 was not written: no step was made.</source>
        <translation>%1 n’a pas été écrit : aucun pas n’a été fait.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>%1 was written by a later version of Ripstop; open it with that.</source>
        <translation>%1 a été écrit par une version plus récente de Ripstop ; l’ouvrir avec elle.</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>asks for more memory than its bytes may need</source>
        <translation>demande plus de mémoire que ses octets n’en peuvent nécessiter</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>has a scene that cannot be read (%1)</source>
        <translation>a une scène qui ne peut pas être lue (%1)</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>is cut off</source>
        <translation>est tronqué</translation>
    </message>
    <message>
        <location filename="recording_file.cpp"/>
        <source>is damaged</source>
        <translation>est abîmé</translation>
    </message>
    <message>
        <location filename="recordings.cpp"/>
        <source>%1 s of %2</source>
        <translation>%1 s de %2</translation>
    </message>
    <message>
        <location filename="recordings.cpp"/>
        <source>Play goes on from %1 s with the design as it is now, as a run of its own.</source>
        <translation>La lecture reprend à %1 s avec le modèle tel qu’il est maintenant, comme une simulation à part.</translation>
    </message>
    <message>
        <location filename="recordings.cpp"/>
        <source>Run %1</source>
        <translation>Simulation %1</translation>
    </message>
    <message>
        <location filename="reinforcement.cpp"/>
        <source>patch_radius: patches of %1 m cover no panel of this mesh; it takes %2 m, or a finer mesh.</source>
        <translation>patch_radius : des renforts de %1 m ne couvrent aucun panneau de ce maillage ; il faut %2 m, ou un maillage plus fin.</translation>
    </message>
    <message>
        <location filename="remedies.cpp"/>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Air as at sea level</source>
        <translation>Air du niveau de la mer</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Automatic solver</source>
        <translation>Solveur automatique</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Empty its axial, membrane and shear stiffness</source>
        <translation>Vider ses raideurs axiale, de membrane et de cisaillement</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Empty the physical stiffness</source>
        <translation>Vider la raideur physique</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Give its links widths from the mesh</source>
        <translation>Donner à ses liaisons les largeurs du maillage</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Have its links take the material's</source>
        <translation>Faire prendre à ses liaisons celle du matériau</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Have its panels carry the pull</source>
        <translation>Faire porter la traction à ses panneaux</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Have its strengths be the limits</source>
        <translation>Prendre ses résistances pour limites</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Let in the air of sea level</source>
        <translation>Laisser entrer l’air du niveau de la mer</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make it a rod</source>
        <translation>En faire une tige</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make it a spring</source>
        <translation>En faire un ressort</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make rods</source>
        <translation>En faire des tiges</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make rods of its links</source>
        <translation>Faire de ses liaisons des tiges</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make springs</source>
        <translation>En faire des ressorts</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Make springs of its links</source>
        <translation>Faire de ses liaisons des ressorts</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>No link of this material runs across its panels, so that none resists shear: have its panels carry the pull.</source>
        <translation>Aucune liaison de ce matériau ne traverse ses panneaux, si bien qu’aucune ne résiste au cisaillement : faites porter la traction à ses panneaux.</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>No link of this material runs along a side of a panel, so that none is a thread: have its panels carry the pull.</source>
        <translation>Aucune liaison de ce matériau ne longe le côté d’un panneau, si bien qu’aucune n’est un fil : faites porter la traction à ses panneaux.</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Take the material's numbers</source>
        <translation>Prendre les nombres du matériau</translation>
    </message>
    <message>
        <location filename="remedy.cpp"/>
        <source>Tear by strength</source>
        <translation>Déchirer selon la résistance</translation>
    </message>
    <message>
        <location filename="replay.cpp"/>
        <source>The run cannot be computed to its end here: %1</source>
        <translation>La simulation ne peut pas être calculée ici jusqu’à sa fin : %1</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>%1 of %2 is then gone for good.</source>
        <translation>%1 du %2 est alors perdu pour de bon.</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>%1, which is newer</source>
        <translation>%1, qui est plus récent</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>&amp;Delete…</source>
        <translation>&amp;Supprimer…</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>&amp;Later</source>
        <translation>&amp;Plus tard</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>(never saved)</source>
        <translation>(jamais enregistré)</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Ask again at the next start.</source>
        <translation>Demander de nouveau au prochain démarrage.</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Delete unsaved work</source>
        <translation>Supprimer le travail non enregistré</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Kept</source>
        <translation>Gardé</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Later state of</source>
        <translation>État plus récent de</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Ripstop ended before this was saved. Open it to go on where it was; the file that it belongs to stays as it is until you save.</source>
        <translation>Ripstop s’est terminé avant que ceci soit enregistré. L’ouvrir pour continuer là où c’était ; le fichier correspondant reste tel quel jusqu’à l’enregistrement.</translation>
    </message>
    <message>
        <location filename="rescue_dialog.cpp"/>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut pas être écrit : %2</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>%1 of %2 do not hold; %3 run.</source>
        <translation>%1 sur %2 ne tiennent pas ; %3 exécutés.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>%1 of %2 run.</source>
        <translation>%1 sur %2 exécutés.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>%1 of %2 run; all hold.</source>
        <translation>%1 sur %2 exécutés ; tous tiennent.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>%1 rows, not yet run.</source>
        <translation>%1 rangs, pas encore exécutés.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>&amp;Copy</source>
        <translation>Co&amp;pier</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>&amp;Run</source>
        <comment>the cases</comment>
        <translation>E&amp;xécuter</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>&amp;Save as CSV…</source>
        <translation>&amp;Enregistrer en CSV…</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>All %1 hold.</source>
        <translation>Les %1 tiennent.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Copy the table, for a spreadsheet.</source>
        <translation>Copier le tableau, pour un tableur.</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Filter by any word of a row, or by section</source>
        <translation>Filtrer par un mot d’un rang, ou par section</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Only what &amp;fails</source>
        <translation>Seulement les é&amp;checs</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Save the table</source>
        <translation>Enregistrer le tableau</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Section</source>
        <translation>Section</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>Verification</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>fails</source>
        <translation>échoue</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>holds</source>
        <translation>tient</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>✓ holds</source>
        <translation>✓ tient</translation>
    </message>
    <message>
        <location filename="result_page.cpp"/>
        <source>✗ fails</source>
        <translation>✗ échoue</translation>
    </message>
    <message>
        <location filename="rigidity.cpp"/>
        <source>%1 particles are too many to look at together. Select at most %2, such as the frame without the sail.</source>
        <translation>%1 particules sont trop pour être examinées ensemble. En sélectionner au plus %2, comme l’armature sans la voile.</translation>
    </message>
    <message>
        <location filename="rigidity.cpp"/>
        <source>Add braces</source>
        <translation>Ajouter des contreventements</translation>
    </message>
    <message>
        <location filename="rigidity.cpp"/>
        <source>Nothing is selected that links could hold. Select particles, links or a part.</source>
        <translation>Rien de sélectionné ne pourrait être tenu par des liaisons. Sélectionner des particules, des liaisons ou une pièce.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>%1 motions of the whole are free</source>
        <translation>%1 mouvements de l’ensemble sont libres</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>%1 of the links redundant</source>
        <translation>%1 des liaisons redondantes</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>%1. %2 moves most, %3 in all</source>
        <translation>%1. %2 bouge le plus, %3 en tout</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>&amp;Add these rods</source>
        <translation>&amp;Ajouter ces tiges</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>&amp;Look at the selection</source>
        <translation>&amp;Examiner la sélection</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>&amp;Move it in the view</source>
        <translation>&amp;L’animer dans la vue</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>&amp;Select what moves</source>
        <translation>&amp;Sélectionner ce qui bouge</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>.
Links count as if they resisted both ways, and small motions only.</source>
        <translation>.
Les liaisons comptent comme si elles résistaient dans les deux sens, et pour de petits mouvements seulement.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>Each takes one way away; there is no smaller set. One step of undo.</source>
        <translation>Chacune ôte un mouvement ; il n’y a pas d’ensemble plus petit. Une seule étape à annuler.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>It gives way in %1 ways.</source>
        <translation>Il cède de %1 façons.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>It gives way in 1 way.</source>
        <translation>Il cède d’une façon.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>It is rigid.</source>
        <translation>C’est rigide.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>Length (m)</source>
        <translation>Longueur (m)</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>No rod between these particles can stop them: what is flat gives way across its plane. Draw, Rigidity particles puts something beside the plane.</source>
        <translation>Aucune tige entre ces particules ne peut les arrêter : ce qui est plat cède en travers de son plan. Dessiner, Particules de rigidité met quelque chose à côté du plan.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>No rod is missing.</source>
        <translation>Il ne manque aucune tige.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>Rigidity</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>The fewest rods that stop them all:</source>
        <translation>Le moins de tiges qui les arrêtent toutes :</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>These rods stop %1 of them. The others are across the plane: Draw, Rigidity particles puts something beside it.</source>
        <translation>Ces tiges en arrêtent %1. Les autres sont en travers du plan : Dessiner, Particules de rigidité met quelque chose à côté.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>What is selected now, in place of what was.</source>
        <translation>Ce qui est sélectionné maintenant, à la place de ce qui l’était.</translation>
    </message>
    <message>
        <location filename="rigidity_dialog.cpp"/>
        <source>held by pins</source>
        <translation>tenu par des points fixés</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1 % of the steps missed the wanted accuracy, worst at %2 s in elastic panels by a factor of %3</source>
        <translation>%1 % des pas ont manqué la précision voulue, au pire à %2 s dans des panneaux élastiques, d’un facteur %3</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1 % of the steps missed the wanted accuracy, worst at %2 s in link %3 by a factor of %4</source>
        <translation>%1 % des pas ont manqué la précision voulue, au pire à %2 s dans la liaison %3, d’un facteur %4</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1 Lines that never stretch lose it as they get tight, however short the step is: give them a stiffness.</source>
        <translation>%1 Les lignes qui ne s’allongent jamais la perdent en se tendant, si court que soit le pas : donnez-leur une raideur.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1 Take a shorter time step, or more substeps.</source>
        <translation>%1 Prenez un pas de temps plus court, ou plus de sous-pas.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1 Take the integrator BDF2, which damps far less, or a shorter time step.</source>
        <translation>%1 Prenez l’intégrateur BDF2, qui amortit bien moins, ou un pas de temps plus court.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1. After %2 s it was kept; a shorter time step may keep it throughout.</source>
        <translation>%1. Après %2 s, elle a été tenue ; un pas de temps plus court peut la tenir tout du long.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1. Pulls in links are off by %2 % in the last one, where %3 % are wanted: the design is not as stiff as it says. %4</source>
        <translation>%1. Au dernier, les tractions dans les liaisons s’écartent de %2 %, où %3 % sont voulus : le modèle n’est pas aussi raide qu’il le dit. %4</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>%1. Rods that never stretch are %2 % too long in the last one, where %3 % are wanted. %4</source>
        <translation>%1. Au dernier, des tiges qui ne s’étirent jamais sont trop longues de %2 %, où %3 % sont voulus. %4</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>Breaks in steps that missed the wanted accuracy: %1, the first at %2 s. Whether that load breaks it is not sure; a shorter time step tells.</source>
        <translation>Ruptures dans des pas qui ont manqué la précision voulue : %1, la première à %2 s. Il n’est pas sûr qu’une telle charge rompe vraiment ; un pas de temps plus court le dira.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>No step could be told how true it was: the motion runs away. Take a shorter time step, or smaller loads.</source>
        <translation>Pour aucun pas on n’a pu dire s’il était juste : le mouvement s’emballe. Prenez un pas de temps plus court, ou des charges plus petites.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>Take a shorter time step.</source>
        <translation>Prendre un pas de temps plus court.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>Take the automatic solver.</source>
        <translation>Prendre le solveur automatique.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>The motion dies away by the time steps: in ten seconds they took %1 % of its energy, most of what it lost.</source>
        <translation>Le mouvement s’éteint par les pas de temps : en dix secondes, ils ont pris %1 % de son énergie, la plus grande part de ce qu’il a perdu.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>The time steps damp the motion by %1 % of critical: much of it swings faster than the %2 Hz that they tell truly, and comes out weaker, or dies away.</source>
        <translation>Les pas de temps amortissent le mouvement de %1 % de l’amortissement critique : une bonne part oscille plus vite que les %2 Hz qu’ils rendent fidèlement, et en sort affaiblie, ou s’éteint.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>The worst load of the run, in link %1 at %2 s, came in a blow of which the time steps took much of the energy: without that it would be about %3 % higher. Take a shorter time step.</source>
        <translation>La plus grande charge du vol, dans la liaison %1 à %2 s, est venue d’un choc dont les pas de temps ont pris une bonne part de l’énergie : sans cela elle serait plus haute d’environ %3 %. Prenez un pas de temps plus court.</translation>
    </message>
    <message>
        <location filename="run_accuracy.cpp"/>
        <source>The worst load of the run, in panel %1 at %2 s, came in a blow of which the time steps took much of the energy: without that it would be about %3 % higher. Take a shorter time step.</source>
        <translation>La plus grande charge du vol, dans le panneau %1 à %2 s, est venue d’un choc dont les pas de temps ont pris une bonne part de l’énergie : sans cela elle serait plus haute d’environ %3 %. Prenez un pas de temps plus court.</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>%1 is of another design than the one that is open. Open that design, too? The runs that are not saved are then lost.</source>
        <translation>%1 est d’un autre modèle que celui qui est ouvert. Ouvrir aussi ce modèle ? Les simulations non enregistrées sont alors perdues.</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>&amp;Open its design</source>
        <translation>&amp;Ouvrir son modèle</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>A recording of another design</source>
        <translation>Un enregistrement d’un autre modèle</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Cannot open the recording</source>
        <translation>Impossible d’ouvrir l’enregistrement</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Each run keeps up to this much of itself in memory (MB); older moments go to a temporary file. 0 records nothing. It holds from the next run on.</source>
        <translation>Chaque simulation garde jusqu’à cette part d’elle-même en mémoire (Mo) ; les moments plus anciens vont dans un fichier temporaire. 0 n’enregistre rien. Vaut à partir de la prochaine simulation.</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Memory for recordings</source>
        <translation>Mémoire des enregistrements</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Nothing is recorded yet: run the simulation first (Space).</source>
        <translation>Rien n’est encore enregistré : lancer d’abord la simulation (Espace).</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Only &amp;compare</source>
        <translation>Seulement &amp;comparer</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Open a recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Opened %1</source>
        <translation>%1 ouvert</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Recordings (*.ripstop-run);;All files (*)</source>
        <translation>Enregistrements (*.ripstop-run);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Save the recording</source>
        <translation>Enregistrer la simulation</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>Saving %1…</source>
        <translation>Enregistrement de %1…</translation>
    </message>
    <message>
        <location filename="run_files.cpp"/>
        <source>The recording is damaged</source>
        <translation>L’enregistrement est endommagé</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>&amp;Cut</source>
        <translation>&amp;Couper</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>&amp;Fan</source>
        <translation>&amp;Ventilateur</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>&amp;Grab</source>
        <translation>&amp;Saisir</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>&amp;Step</source>
        <translation>&amp;Avancer d’un pas</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Back to the design; controls return to zero.</source>
        <translation>Revenir au modèle ; les commandes reviennent à zéro.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Blow with the mouse: hold the left button. The wheel makes it blow harder, with Ctrl wider.</source>
        <translation>Souffler avec la souris : tenir le bouton gauche. La molette souffle plus fort, avec Ctrl plus large.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Certif&amp;y…</source>
        <translation>Certif&amp;ier…</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Draw a stroke across links and fabric: they part where it runs.</source>
        <translation>Tracer un trait à travers liaisons et tissu : ils se séparent là où il passe.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Fly the design three times, to tell which digits of its probes hold.</source>
        <translation>Faire voler le modèle trois fois, pour dire lesquels des chiffres de ses sondes sont justes.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Make the shape of the run the design. Undo brings the old design back.</source>
        <translation>Faire de la forme simulée le modèle. Annuler ramène l’ancien.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Nothing is pinned by hand: grab it and press P.</source>
        <translation>Rien n’est fixé à la main : saisir et appuyer sur P.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>One time step.</source>
        <translation>Un pas de temps.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Pull &amp;out pins</source>
        <translation>Retirer les épin&amp;gles</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Pull at fabric and lines, carry colliders, move controls: drag them. The wheel moves the hand nearer or farther, P pins what it holds. Ctrl and a drag does this with any tool.</source>
        <translation>Tirer sur le tissu et les lignes, porter des obstacles, déplacer des commandes : les faire glisser. La molette approche ou éloigne la main, P fixe ce qu’elle tient. Ctrl et glisser fait de même avec tout outil.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Run the simulation, or hold it.</source>
        <translation>Lancer la simulation, ou la suspendre.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>Run until all hangs still, then pause.</source>
        <translation>Simuler jusqu’à ce que tout pende immobile, puis suspendre.</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>S&amp;ettle…</source>
        <translation>&amp;Mettre au repos…</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>The design stands at its start; run it first (Space).</source>
        <translation>Le modèle est à son départ ; le lancer d’abord (Espace).</translation>
    </message>
    <message>
        <location filename="run_rows.cpp"/>
        <source>What is shown is no run of the design as it is now: mend its problems, or wait for the next step.</source>
        <translation>Ce qui est montré n’est pas une simulation du modèle tel qu’il est : corriger ses problèmes, ou attendre le pas suivant.</translation>
    </message>
    <message>
        <location filename="scattered_warps.cpp"/>
        <source>Turn warps one way</source>
        <translation>Tourner les chaînes dans un seul sens</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1 (%2 particles, %3 links, %4 panels)</source>
        <translation>%1 (%2 particules, %3 liaisons, %4 panneaux)</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1 added: %2</source>
        <translation>%1 en plus : %2</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1 particles, %2 links, %3 panels, %4</source>
        <translation>%1 particules, %2 liaisons, %3 panneaux, %4</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1 removed: %2</source>
        <translation>%1 en moins : %2</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1: %2 added %3, removed %4</source>
        <translation>%1 : %2 en plus %3, en moins %4</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>%1: changed by hand besides, %2 -&gt; %3 elements</source>
        <translation>%1 : modifié à la main en outre, %2 -&gt; %3 éléments</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>What this version does not know of the two files differs</source>
        <translation>Ce que cette version ne connaît pas des deux fichiers diffère</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>built</source>
        <translation>construit</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>links</source>
        <translation>liaisons</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>panels</source>
        <translation>panneaux</translation>
    </message>
    <message>
        <location filename="scene_difference.cpp"/>
        <source>particles</source>
        <translation>particules</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>%1 is too large for the memory of this computer.</source>
        <translation>%1 est trop grand pour la mémoire de cet ordinateur.</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>%1 was not saved: %2 of %3 %4; correct it first.</source>
        <translation>%1 n’a pas été enregistré : %2 de %3 %4 ; le corriger d’abord.</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>%1 was not saved: not enough memory to write the scene.</source>
        <translation>%1 n’a pas été enregistré : pas assez de mémoire pour écrire la scène.</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>%1 was not saved: parameter %2 of %3 is not a finite number; correct it first.</source>
        <translation>%1 n’a pas été enregistré : le paramètre %2 de %3 n’est pas un nombre fini ; le corriger d’abord.</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>%1, line 1: the file is empty; choose another or restore it from a copy.</source>
        <translation>%1, ligne 1 : le fichier est vide ; en choisir un autre ou le restaurer d’une copie.</translation>
    </message>
    <message>
        <location filename="scene_file.cpp"/>
        <source>is not a scene: a scene file starts with '{'; choose a file that ends in %1</source>
        <translation>n’est pas une scène : un fichier de scène commence par « { » ; choisir un fichier qui finit par %1</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;All</source>
        <translation>&amp;Tout</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Bias</source>
        <translation>&amp;Biais</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Box</source>
        <translation>&amp;Rectangle</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Free particles</source>
        <translation>Particules l&amp;ibres</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Grow</source>
        <translation>&amp;Agrandir</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Invert</source>
        <translation>&amp;Inverser</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Pointer</source>
        <translation>P&amp;ointeur</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Rods</source>
        <translation>&amp;Tiges</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Select</source>
        <translation>&amp;Sélectionner</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Shrink</source>
        <translation>R&amp;éduire</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Springs</source>
        <translation>&amp;Ressorts</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Threads</source>
        <translation>Fil&amp;s</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>&amp;Turn into</source>
        <translation>&amp;Convertir en</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>A click takes what is under it, Shift adds, Ctrl takes away; a drag turns the view. Escape comes back to this.</source>
        <translation>Un clic prend ce qui est dessous, Maj ajoute, Ctrl retire ; glisser tourne la vue. Échap revient à cet outil.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Add all that hangs together with the selection by links and panels.</source>
        <translation>Ajouter tout ce qui tient à la sélection par des liaisons et des panneaux.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Add one ring: the neighbours of particles, the links and panels that touch the selected ones.</source>
        <translation>Ajouter un anneau : les voisines des particules, les liaisons et panneaux qui touchent la sélection.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All elements of these kinds in the same parts.</source>
        <translation>Tous les éléments de ces genres dans les mêmes pièces.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links and panels of the materials of the selected ones.</source>
        <translation>Toutes les liaisons et tous les panneaux des matériaux de la sélection.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links of the role of the selected ones: line, thread or bias.</source>
        <translation>Toutes les liaisons du rôle de celles sélectionnées : ligne, fil ou biais.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links that keep their length.</source>
        <translation>Toutes les liaisons qui gardent leur longueur.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links that pull with a force.</source>
        <translation>Toutes les liaisons qui tirent avec une force.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links that run along the threads of a fabric.</source>
        <translation>Toutes les liaisons qui suivent les fils d’un tissu.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links that stand for a line or a spar by itself.</source>
        <translation>Toutes les liaisons qui sont une ligne ou un longeron à elles seules.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All links that stand for the shear of a fabric.</source>
        <translation>Toutes les liaisons qui rendent le cisaillement d’un tissu.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All members of the groups that the selected ones belong to.</source>
        <translation>Tous les membres des groupes auxquels appartient la sélection.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All panels.</source>
        <translation>Tous les panneaux.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All particles that are free along a line or in a plane only.</source>
        <translation>Toutes les particules libres seulement le long d’une ligne ou dans un plan.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All particles that are held in place.</source>
        <translation>Toutes les particules tenues en place.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All particles that can move.</source>
        <translation>Toutes les particules qui peuvent bouger.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All particles.</source>
        <translation>Toutes les particules.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All springs and rods.</source>
        <translation>Tous les ressorts et toutes les tiges.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All springs where a spring is selected, all rods, pinned particles, free particles, panels.</source>
        <translation>Tous les ressorts si un ressort est sélectionné, toutes les tiges, particules fixées, particules libres, panneaux.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>All with the mass, the rest length or the area of the selected ones, within 1 %.</source>
        <translation>Tout ce qui a la masse, la longueur au repos ou l’aire de la sélection, à 1 % près.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Box and lasso also take what is hidden behind fabric and colliders, and the knife cuts it.</source>
        <translation>Rectangle et lasso prennent aussi ce qui est caché derrière tissu et obstacles, et le couteau le coupe.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>By &amp;property…</source>
        <translation>Par pro&amp;priété…</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>By &amp;type</source>
        <translation>Par t&amp;ype</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Clicks, box and lasso take links.</source>
        <translation>Clic, rectangle et lasso prennent les liaisons.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Clicks, box and lasso take panels.</source>
        <translation>Clic, rectangle et lasso prennent les panneaux.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Clicks, box and lasso take particles; with links and panels off also those without a dot.</source>
        <translation>Clic, rectangle et lasso prennent les particules ; liaisons et panneaux décochés, aussi celles sans point.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Co&amp;nnected</source>
        <translation>&amp;Connexe</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Drag a box around what to select; Shift adds, Ctrl takes away; a right drag turns the view.</source>
        <translation>Tirer un rectangle autour de ce qui est à sélectionner ; Maj ajoute, Ctrl retire ; glisser à droite tourne la vue.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Draw a line around what to select; Shift adds, Ctrl takes away; a right drag turns the view.</source>
        <translation>Entourer d’un trait ce qui est à sélectionner ; Maj ajoute, Ctrl retire ; glisser à droite tourne la vue.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Edge o&amp;f fabric</source>
        <translation>Bor&amp;d du tissu</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Follow the selected links or particles both ways: along a line, along a thread, around an edge. Of two particles on an edge, the stretch between them.</source>
        <translation>Suivre les liaisons ou particules sélectionnés dans les deux sens : le long d’une ligne, d’un fil, autour d’un bord. De deux particules sur un bord, le tronçon entre elles.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Give the selected elements a name, as a group.</source>
        <translation>Donner un nom aux éléments sélectionnés, comme groupe.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Group sele&amp;ction…</source>
        <translation>Grouper la sé&amp;lection…</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>L&amp;oop or line</source>
        <translation>B&amp;oucle ou ligne</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Li&amp;nes and spars</source>
        <translation>Li&amp;gnes et longerons</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Mouse ta&amp;kes</source>
        <translation>La souris pren&amp;d</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Non&amp;e</source>
        <translation>Rie&amp;n</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Nothing goes on from here: take a link or a particle of an edge.</source>
        <translation>Rien ne continue d’ici : prenez une liaison ou une particule d’un bord.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>P&amp;inned particles</source>
        <translation>Particules &amp;fixées</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Particles on &amp;guides</source>
        <translation>Particules sur &amp;guides</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;group</source>
        <translation>Même &amp;groupe</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;material</source>
        <translation>Même &amp;matériau</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;part</source>
        <translation>Même &amp;pièce</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;role</source>
        <translation>Même &amp;rôle</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;size</source>
        <translation>Même t&amp;aille</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Same &amp;type</source>
        <translation>Même &amp;type</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Select all others of the same kinds: the other particles, where particles are selected.</source>
        <translation>Sélectionner toutes les autres choses des mêmes genres : les autres particules, là où des particules sont sélectionnées.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Select all particles, links and panels.</source>
        <translation>Sélectionner toutes les particules, liaisons et panneaux.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Select by what things are: strain &gt; 5 %, mass &lt; 1 g, material = ripstop.</source>
        <translation>Sélectionner par ce que sont les choses : strain &gt; 5 %, mass &lt; 1 g, material = ripstop.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Select nothing; the inspector then shows the settings.</source>
        <translation>Ne rien sélectionner ; l’inspecteur montre alors les réglages.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Select t&amp;hrough</source>
        <translation>Sélectionner à tra&amp;vers</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Si&amp;milar</source>
        <translation>&amp;Semblables</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>Take one ring away: whatever has a neighbour that is not selected.</source>
        <translation>Ôter un anneau : tout ce qui a un voisin non sélectionné.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>The edge of the selected panels, or of all fabric.</source>
        <translation>Le bord des panneaux sélectionnés, ou de tout le tissu.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>The links between the selected.</source>
        <translation>Les liaisons entre ce qui est sélectionné.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>The panels between the selected.</source>
        <translation>Les panneaux entre ce qui est sélectionné.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>The particles at the ends of the selected links and the corners of the selected panels.</source>
        <translation>Les particules aux bouts des liaisons sélectionnées et aux coins des panneaux sélectionnés.</translation>
    </message>
    <message>
        <location filename="select_rows.cpp"/>
        <source>There is none of that here; the selection stays.</source>
        <translation>Il n’y en a pas ici ; la sélection reste.</translation>
    </message>
    <message>
        <location filename="series.cpp"/>
        <source>The scene has no probes, so there is nothing to put into %1; add a probe first.</source>
        <translation>La scène n’a pas de sondes, il n’y a donc rien à mettre dans %1 ; ajouter d’abord une sonde.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>%1 s of %2 s; the fastest particle has %3 m/s, all motion %4 J.</source>
        <translation>%1 s sur %2 s ; la particule la plus rapide a %3 m/s, tout le mouvement %4 J.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>&amp;Adopt pose…</source>
        <translation>Adop&amp;ter la pose…</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>&amp;For at most</source>
        <translation>&amp;Pendant au plus</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>&amp;Settle</source>
        <translation>&amp;Mettre au repos</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>&amp;Shorten the way (kinetic damping)</source>
        <translation>&amp;Raccourcir le chemin (amortissement cinétique)</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Makes the shape that the run has come to the design.</source>
        <translation>Fait de la forme obtenue le modèle.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Not still after %1 s: in the last half swing the fastest particle had %2 m/s. Try kinetic damping, viscosity, a higher speed or more time.</source>
        <translation>Pas immobile après %1 s : dans la dernière demi-oscillation, la particule la plus rapide avait %2 m/s. Essayez l’amortissement cinétique, la viscosité, une vitesse plus grande ou plus de temps.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Runs as fast as it can until all hangs still, then pauses.</source>
        <translation>Va aussi vite que possible jusqu’à ce que tout pende immobile, puis suspend.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Settle</source>
        <translation>Mettre au repos</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Still after %1 s: nothing has moved faster than %2 m/s for half a swing.</source>
        <translation>Immobile après %1 s : rien n’a dépassé %2 m/s pendant une demi-oscillation.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Stopped before it was still.</source>
        <translation>Arrêté avant l’immobilité.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Stops all motion whenever its energy has passed a peak. It ends where it would without, in much less time; the way there is not what the real thing would do.</source>
        <translation>Arrête tout mouvement dès que son énergie a passé un maximum. Finit au même endroit que sans, en bien moins de temps ; le chemin n’est pas celui que suivrait l’objet réel.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>The wind blows on meanwhile: what flies never settles, what hangs or stands does.</source>
        <translation>Le vent continue de souffler : ce qui vole ne s’immobilise jamais, ce qui pend ou se tient debout, si.</translation>
    </message>
    <message>
        <location filename="settle_dialog.cpp"/>
        <source>Un&amp;til all is slower than</source>
        <translation>&amp;Jusqu’à ce que tout soit plus lent que</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Choose a mesh</source>
        <translation>Choisir un maillage</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Choose a picture for the fabric</source>
        <translation>Choisir une image pour le tissu</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Choose a picture of heights</source>
        <translation>Choisir une image de hauteurs</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Meshes (*.obj *.stl *.ply *.gltf *.glb *.dae *.off *.vtp *.vtu);;All files (*)</source>
        <translation>Maillages (*.obj *.stl *.ply *.gltf *.glb *.dae *.off *.vtp *.vtu);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Images (*.png *.jpg *.jpeg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="shape_file.cpp"/>
        <source>Pictures (*.png *.pgm);;All files (*)</source>
        <translation>Images (*.png *.pgm);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="shape_files.cpp"/>
        <source>The %1 %2 does not exist; put it there, or choose another file.</source>
        <translation>%2 (%1) n’existe pas ; l’y mettre, ou choisir un autre fichier.</translation>
    </message>
    <message>
        <location filename="shape_files.cpp"/>
        <source>The %1 %2 is not a file; choose another.</source>
        <translation>%2 (%1) n’est pas un fichier ; en choisir un autre.</translation>
    </message>
    <message>
        <location filename="shape_files.cpp"/>
        <source>picture</source>
        <translation>image</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>"%1" is no %2, it %3.</source>
        <translation>« %1 » ne convient pas : %2 %3.</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>%1 cells</source>
        <translation>%1 cellules</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>%1 columns</source>
        <translation>%1 colonnes</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>%1 lines</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>1 cell</source>
        <translation>1 cellule</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>1 column</source>
        <translation>1 colonne</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>1 line</source>
        <translation>1 ligne</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>1 row</source>
        <translation>1 rang</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>An id stays as it is.</source>
        <translation>Un id reste tel quel.</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>Line %1 has %2 and there are %3 to take them; begin further left.</source>
        <translation>La ligne %1 a %2 et il y a %3 pour les recevoir ; commencer plus à gauche.</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>Line %1, %2: %3</source>
        <translation>Ligne %1, %2 : %3</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>There are %1 to paste and %2 to take them; begin further up.</source>
        <translation>Il y a %1 à coller et %2 pour les recevoir ; commencer plus haut.</translation>
    </message>
    <message>
        <location filename="sheet.cpp"/>
        <source>What is there was removed.</source>
        <translation>Ce qui est là a été supprimé.</translation>
    </message>
    <message>
        <location filename="sheet_model.cpp"/>
        <source>The number by which files and paths name the thing.</source>
        <translation>Le numéro par lequel fichiers et chemins nomment la chose.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>%1 of %2 rows</source>
        <translation>%1 sur %2 rangs</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>%1 rows</source>
        <translation>%1 rangs</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Copy	Ctrl+C</source>
        <translation>Copier	Ctrl+C</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Filter: mass &lt; 1 g and not pinned</source>
        <translation>Filtre : mass &lt; 1 g and not pinned</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Mark the cell where the text is to begin.</source>
        <translation>Marquer la cellule où le texte doit commencer.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Only s&amp;elected</source>
        <translation>Seulement la s&amp;élection</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Only the rows of what is selected in the design.</source>
        <translation>Seulement les rangs de ce qui est sélectionné dans le modèle.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Only the rows that meet a condition, as in Select by property: mass &lt; 1 g, strain &gt; 5 %, material = ripstop.</source>
        <translation>Seulement les rangs qui remplissent une condition, comme dans Sélectionner par propriété : mass &lt; 1 g, strain &gt; 5 %, material = ripstop.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>Paste	Ctrl+V</source>
        <translation>Coller	Ctrl+V</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>That is too much for the clipboard; mark fewer cells.</source>
        <translation>C’est trop pour le presse-papiers ; marquer moins de cellules.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>The clipboard holds no text to paste.</source>
        <translation>Le presse-papiers ne contient pas de texte à coller.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>The design at its start, not the run.</source>
        <translation>Le modèle à son départ, pas la simulation.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>The run is read by probes, by the colours of the view, and in the status bar with the mouse on a thing.</source>
        <translation>La simulation se lit aux sondes, aux couleurs de la vue et dans la barre d’état, la souris sur une chose.</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>What the rows are</source>
        <translation>Ce que sont les rangs</translation>
    </message>
    <message>
        <location filename="sheet_panel.cpp"/>
        <source>What the rows are. Lines are the links with the role line.</source>
        <translation>Ce que sont les rangs. Les lignes sont les liaisons de rôle ligne.</translation>
    </message>
    <message>
        <location filename="shown_break.cpp"/>
        <source>The moment at which it broke, %1, is not recorded: the view has the place in its middle as it is now.</source>
        <translation>Le moment de la rupture, %1, n’est pas enregistré : la vue a l’endroit en son milieu, tel qu’il est maintenant.</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>has a range that %1</source>
        <translation>a un intervalle qui %1</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>is no id</source>
        <translation>n’est pas un id</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>is no property that can be tuned</source>
        <translation>n’est pas une propriété qui se règle</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must be sliders such as material.stiffness #17 1 1000 log; "%1" %2</source>
        <translation>doit être des curseurs comme material.stiffness #17 1 1000 log ; « %1 » %2</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must begin above 0 to be logarithmic</source>
        <translation>doit commencer au-dessus de 0 pour être logarithmique</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must begin at %1 or above</source>
        <translation>doit commencer à %1 ou au-dessus</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must end at %1 or below</source>
        <translation>doit finir à %1 ou au-dessous</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must have finite ends</source>
        <translation>doit avoir des extrémités finies</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>must rise from left to right</source>
        <translation>doit croître de gauche à droite</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>names nothing</source>
        <translation>ne nomme rien</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>names too many things</source>
        <translation>nomme trop de choses</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>needs no range</source>
        <translation>n’a pas besoin d’intervalle</translation>
    </message>
    <message>
        <location filename="slider.cpp"/>
        <source>needs two numbers as its range</source>
        <translation>demande deux nombres comme intervalle</translation>
    </message>
    <message>
        <location filename="slider_shelf.cpp"/>
        <source>A slider moves at most %1 things; tune the material that they share.</source>
        <translation>Un curseur déplace au plus %1 choses ; régler le matériau qu’elles partagent.</translation>
    </message>
    <message>
        <location filename="smooth.cpp"/>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <location filename="solid.cpp"/>
        <source>Collider %1 needs a height above 0: correct the second number of its size.</source>
        <translation>L’obstacle %1 demande une hauteur au-dessus de 0 : corriger le deuxième nombre de sa taille.</translation>
    </message>
    <message>
        <location filename="solid.cpp"/>
        <source>Collider %1 needs a normal that is not zero.</source>
        <translation>L’obstacle %1 demande une normale non nulle.</translation>
    </message>
    <message>
        <location filename="solid.cpp"/>
        <source>Collider %1 needs edges above 0: correct its size.</source>
        <translation>L’obstacle %1 demande des arêtes au-dessus de 0 : corriger sa taille.</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 links, springs among them that are too stiff for the substep, are solved together; %2</source>
        <translation>%1 liaisons, dont des ressorts trop raides pour le sous-pas, sont résolues ensemble ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 panels carry the pull of the fabric and are solved together with all rods; %2</source>
        <translation>%1 panneaux portent la traction du tissu et sont résolus ensemble avec toutes les tiges ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved directly, since their load is far heavier than what holds it; %2</source>
        <translation>%1 tiges sont résolues directement, car leur charge est bien plus lourde que ce qui la tient ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved directly, since their load would need %2 substeps; %3</source>
        <translation>%1 tiges sont résolues directement, car leur charge demanderait %2 sous-pas ; %3</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved directly, which costs little for what they join; %2</source>
        <translation>%1 tiges sont résolues directement, ce qui coûte peu pour ce qu’elles relient ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved together, as %2 needs it; %3</source>
        <translation>%1 tiges sont résolues ensemble, comme %2 le demande ; %3</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved together, since spars among them bend; %2</source>
        <translation>%1 tiges sont résolues ensemble, car des longerons parmi elles fléchissent ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved together, since sweeps would need %2 substeps; %3</source>
        <translation>%1 tiges sont résolues ensemble, car des balayages demanderaient %2 sous-pas ; %3</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved together, since the air loads their fabric by more than sweeps hold; %2</source>
        <translation>%1 tiges sont résolues ensemble, car l’air charge la voile qu’elles tiennent plus que des balayages ne peuvent retenir ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 rods are solved together, since they are too stiff for sweeps; %2</source>
        <translation>%1 tiges sont résolues ensemble, car elles sont trop raides pour des balayages ; %2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1 substeps of bdf2</source>
        <translation>%1 sous-pas de bdf2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1; %2 needs at least %3</source>
        <translation>%1 ; %2 en demande au moins %3</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>%1; %2 would need %3, and no more are taken</source>
        <translation>%1 ; %2 en demanderait %3, et il n’en est pas pris plus</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>1 substep of bdf2</source>
        <translation>1 sous-pas de bdf2</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>small steps: %1 substeps of one sweep to begin with, for a strain of %2 %</source>
        <translation>petits pas : %1 sous-pas d’un balayage pour commencer, pour une déformation de %2 %</translation>
    </message>
    <message>
        <location filename="solver_plan.cpp"/>
        <source>there are no rods</source>
        <translation>il n’y a pas de tiges</translation>
    </message>
    <message>
        <location filename="spill_file.cpp"/>
        <source>a temporary file cannot be read: %1</source>
        <translation>un fichier temporaire ne peut pas être lu : %1</translation>
    </message>
    <message>
        <location filename="spill_file.cpp"/>
        <source>no temporary file can be made in %1: %2</source>
        <translation>aucun fichier temporaire ne peut être créé dans %1 : %2</translation>
    </message>
    <message>
        <location filename="spill_file.cpp"/>
        <source>the folder for temporary files cannot take more: %1</source>
        <translation>le dossier des fichiers temporaires est plein : %1</translation>
    </message>
    <message>
        <location filename="spill_file.cpp"/>
        <source>there is no folder for temporary files; set TMPDIR to one</source>
        <translation>il n’y a pas de dossier pour les fichiers temporaires ; en donner un dans TMPDIR</translation>
    </message>
    <message>
        <location filename="split.cpp"/>
        <source>Split links</source>
        <translation>Diviser les liaisons</translation>
    </message>
    <message>
        <location filename="spread_mass.cpp"/>
        <source>No link lies among what is selected, so it has no length. Select both ends of a line.</source>
        <translation>Aucune liaison n’est dans la sélection, qui n’a donc pas de longueur. Sélectionner les deux bouts d’une ligne.</translation>
    </message>
    <message>
        <location filename="spread_mass.cpp"/>
        <source>No panel lies among what is selected, so it has no area. Select all corners of some fabric.</source>
        <translation>Aucun panneau n’est dans la sélection, qui n’a donc pas d’aire. Sélectionner tous les coins d’un tissu.</translation>
    </message>
    <message>
        <location filename="spread_mass.cpp"/>
        <source>No particle is selected. Select what is to have the mass.</source>
        <translation>Aucune particule n’est sélectionnée. Sélectionner ce qui doit avoir la masse.</translation>
    </message>
    <message>
        <location filename="spread_mass.cpp"/>
        <source>Set mass</source>
        <translation>Donner une masse</translation>
    </message>
    <message>
        <location filename="spread_mass.cpp"/>
        <source>What is selected has no mass yet, so there is no proportion to keep. Share the mass out evenly.</source>
        <translation>La sélection n’a pas encore de masse, et il n’y a pas de proportion à garder. Répartir la masse également.</translation>
    </message>
    <message>
        <location filename="spring_force.h"/>
        <source>springs</source>
        <translation>les ressorts</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 free particles have no mass.</source>
        <translation>%1 particules libres n’ont pas de masse.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 links</source>
        <translation>%1 liaisons</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 links are beyond the tear limit at the start: the first step tears them, or throws their ends together.</source>
        <translation>%1 liaisons dépassent leur limite de rupture au départ : le premier pas les rompt, ou rejette leurs bouts l’un vers l’autre.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 links are longer or shorter at the start than at rest by more than %2 %, up to %3 %.</source>
        <translation>%1 liaisons sont plus longues ou plus courtes au départ qu’au repos de plus de %2 %, jusqu’à %3 %.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 links are too stiff for these sweeps, which make them up to %2 times as soft as they say.</source>
        <translation>%1 liaisons sont trop raides pour ces balayages, qui les rendent jusqu’à %2 fois plus souples qu’elles ne le disent.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 links join particles that are joined already, so that they are as stiff as two.</source>
        <translation>%1 liaisons joignent des particules déjà jointes, qui sont donc deux fois plus raides.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 particles hang on no link and no panel.</source>
        <translation>%1 particules ne tiennent à aucune liaison ni aucun panneau.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>%1 particles need a shorter substep than %2 s, down to %3 s.</source>
        <translation>%1 particules demandent un sous-pas plus court que %2 s, jusqu’à %3 s.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 free particle has no mass.</source>
        <translation>1 particule libre n’a pas de masse.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 link</source>
        <translation>1 liaison</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 link is beyond the tear limit at the start: the first step tears it, or throws its ends together.</source>
        <translation>1 liaison dépasse sa limite de rupture au départ : le premier pas la rompt, ou rejette ses bouts l’un vers l’autre.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 link is longer or shorter at the start than at rest by more than %1 %, up to %2 %.</source>
        <translation>1 liaison est plus longue ou plus courte au départ qu’au repos de plus de %1 %, jusqu’à %2 %.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 link is too stiff for these sweeps, which make it up to %1 times as soft as it says.</source>
        <translation>1 liaison est trop raide pour ces balayages, qui la rendent jusqu’à %1 fois plus souple qu’elle ne le dit.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 link joins particles that are joined already, so that they are as stiff as two.</source>
        <translation>1 liaison joint des particules déjà jointes, qui sont donc deux fois plus raides.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 particle hangs on no link and no panel.</source>
        <translation>1 particule ne tient à aucune liaison ni aucun panneau.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>1 particle needs a shorter substep than %1 s, down to %2 s.</source>
        <translation>1 particule demande un sous-pas plus court que %1 s, jusqu’à %2 s.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>A pull has to pass %1 to cross the network, and %2 sweeps in %3 take it past %4 in each time step.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau, et %2 balayages en %3 la portent au-delà de %4 à chaque pas de temps.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>A pull has to pass %1 to cross the network, and %2 sweeps in %3 take it past %4 in each time step: it will look elastic.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau, et %2 balayages en %3 la portent au-delà de %4 à chaque pas de temps : il paraîtra élastique.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>A pull has to pass %1 to cross the network; the direct solver takes it there at once.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau ; le solveur direct l’y porte d’un coup.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>A pull has to pass %1 to cross the network; this solver takes it far in each sweep.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau ; ce solveur la porte loin à chaque balayage.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Choose the automatic solver</source>
        <translation>Choisir le solveur automatique</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Double links</source>
        <translation>Liaisons doubles</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Give %1 g each</source>
        <translation>Donner %1 g à chacune</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Links are as long at the start as at rest, or slack.</source>
        <translation>Les liaisons sont aussi longues au départ qu’au repos, ou lâches.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Links are at most %1 % longer or shorter at the start than at rest.</source>
        <translation>Les liaisons sont au départ plus longues ou plus courtes qu’au repos de %1 % au plus.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Loose particles</source>
        <translation>Particules seules</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Make %1 sweeps</source>
        <translation>Faire %1 balayages</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Masses</source>
        <translation>Masses</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Remove the double links</source>
        <translation>Supprimer les liaisons doubles</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Remove the loose particles</source>
        <translation>Supprimer les particules seules</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Rest as they start</source>
        <translation>Au repos comme elles démarrent</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Sweeps keep the stiffness of links to about %1 %.</source>
        <translation>Les balayages respectent la raideur des liaisons à environ %1 % près.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Take %1 substeps</source>
        <translation>Prendre %1 sous-pas</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Tearing</source>
        <translation>Déchirure</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>The ends of a rod differ in mass by a factor of up to %1, and sweeps lift a heavy end by a light one only slowly: even the masses out, or choose the automatic solver.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1, et les balayages ne soulèvent que lentement un bout lourd par un bout léger : égaliser les masses, ou choisir le solveur automatique.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>The ends of a rod differ in mass by a factor of up to %1, which this solver can follow.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1, ce que ce solveur peut suivre.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>The ends of a rod differ in mass by a factor of up to %1.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>The substep is %1 s and may be up to %2 s for %3.</source>
        <translation>Le sous-pas est de %1 s et peut aller jusqu’à %2 s pour %3.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>The time step is %1 s. Substeps may be up to %2 s for %3, and the automatic solver keeps to it.</source>
        <translation>Le pas de temps est de %1 s. Les sous-pas peuvent aller jusqu’à %2 s pour %3, et le solveur automatique s’y tient.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>This solver takes what it needs to keep the stiffness of links to %1 %; the bar of the run shows what it reaches.</source>
        <translation>Ce solveur prend ce qu’il faut pour respecter la raideur des liaisons à %1 % près ; la barre de la simulation montre ce qu’il atteint.</translation>
    </message>
    <message>
        <location filename="stability.cpp"/>
        <source>Time step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <location filename="stability_list.cpp"/>
        <source>Good: %1</source>
        <translation>Bon : %1</translation>
    </message>
    <message>
        <location filename="stability_list.cpp"/>
        <source>How near the design is to what its solver can follow. Click a row to select what it is about.</source>
        <translation>À quel point le modèle est proche de ce que son solveur peut suivre. Cliquer une ligne pour sélectionner ce qu’elle concerne.</translation>
    </message>
    <message>
        <location filename="stability_list.cpp"/>
        <source>Poor: %1</source>
        <translation>Mauvais : %1</translation>
    </message>
    <message>
        <location filename="stability_list.cpp"/>
        <source>Repairs it as one step that can be undone.</source>
        <translation>Corrige en une étape qui peut être annulée.</translation>
    </message>
    <message>
        <location filename="stability_list.cpp"/>
        <source>Stability</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <location filename="start_check.cpp"/>
        <source>%1 The thickness of %2, %3 m, counts.</source>
        <translation>%1 L’épaisseur de %2, %3 m, compte.</translation>
    </message>
    <message>
        <location filename="start_check.cpp"/>
        <source>%1 particles of %2 begin inside %3, by up to %4 m: contact puts them outside in the first step, which stretches what they are tied to and makes energy out of nothing. Move %2 or %3.</source>
        <translation>%1 particules de %2 commencent dans %3, jusqu’à %4 m : le contact les met dehors au premier pas, ce qui étire ce à quoi elles tiennent et crée de l’énergie à partir de rien. Déplacer %2 ou %3.</translation>
    </message>
    <message>
        <location filename="start_check.cpp"/>
        <source>1 particle of %1 begins inside %2, by %3 m: contact puts it outside in the first step, which stretches what it is tied to and makes energy out of nothing. Move %1 or %2.</source>
        <translation>1 particule de %1 commence dans %2, de %3 m : le contact la met dehors au premier pas, ce qui étire ce à quoi elle tient et crée de l’énergie à partir de rien. Déplacer %1 ou %2.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>%1 is gone.</source>
        <translation>%1 n’existe plus.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>A gust tears a big delta. Tune the joint efficiency of its border until it holds.</source>
        <translation>Une rafale déchire un grand delta. Réglez la tenue des coutures du bord.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>A ripstop kite rides gusts. Tune the strength of its line until it snaps.</source>
        <translation>Du ripstop dans les rafales. Réglez la résistance de la ligne jusqu’à ce qu’elle rompe.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>A scene from a file</source>
        <translation>Une scène depuis un fichier</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>A slit runs across ripstop. Tune the strength of the cloth, and when it runs.</source>
        <translation>Une fente court à travers le ripstop. Réglez la résistance de la toile, et quand elle court.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>An empty scene, to draw or import into</source>
        <translation>Une scène vide, pour dessiner ou importer</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Begin with</source>
        <translation>Pour commencer</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Cloth flutters in 8 m/s of wind. Tune the wind, and how much the cloth weighs.</source>
        <translation>Une toile flotte dans un vent de 8 m/s. Réglez le vent et le poids de la toile.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Dacron on aluminium, and you steer. Tune how stiff its tubes are.</source>
        <translation>Du Dacron sur de l’aluminium, et vous pilotez. Réglez la raideur des tubes.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Fabric from a mesh: OBJ, STL, PLY, OFF, glTF, Collada, VTP or VTU</source>
        <translation>Du tissu d’un maillage : OBJ, STL, PLY, OFF, glTF, Collada, VTP ou VTU</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Fabric that flies: kites, hang gliders, parachutes, cloth.</source>
        <translation>Du tissu qui vole : cerfs-volants, deltaplanes, parachutes, toiles.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Files that you open will be listed here.</source>
        <translation>Les fichiers que vous ouvrez seront listés ici.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Folded nylon fills with air. Tune the strength of the cords that brake it.</source>
        <translation>Du nylon plié se remplit d’air. Réglez la résistance des suspentes qui le freinent.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>More samples</source>
        <translation>Autres exemples</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>New here? Take the tour</source>
        <translation>Première fois ? La visite guidée</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>New scene</source>
        <translation>Nouvelle scène</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>Ripstop</source>
        <translation>Ripstop</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>The folder "scenes" with the samples is not beside the program. The designs can still be built, at the left.</source>
        <translation>Le dossier « scenes » avec les exemples n’est pas à côté du programme. Les modèles peuvent être construits quand même, à gauche.</translation>
    </message>
    <message>
        <location filename="start_page.cpp"/>
        <source>What the parts of the window are for, in a minute</source>
        <translation>À quoi servent les parties de la fenêtre, en une minute</translation>
    </message>
    <message>
        <location filename="status_line.cpp"/>
        <source>Selected: %1</source>
        <translation>Sélection : %1</translation>
    </message>
    <message>
        <location filename="step_check.cpp"/>
        <source>The bending at particle %1 asks for %2 substeps, where %3 would do for most of what bends: cells there are narrow, or links short, and each step takes as many times as long. Make them like the others, join them, or leave out the bending stiffness.</source>
        <translation>La flexion à la particule %1 demande %2 sous-pas, alors que %3 suffiraient à la plupart de ce qui fléchit : les mailles y sont étroites, ou les liens courts, et chaque pas dure autant de fois plus longtemps. Rendez-les semblables aux autres, réunissez-les, ou laissez la raideur de flexion à zéro.</translation>
    </message>
    <message>
        <location filename="step_check.cpp"/>
        <source>The bending at particle %1 needs substeps of %2 s, and the automatic solver takes no more than %3 of them in a time step: it will run away. Lower the flexural rigidity, join small cells, or shorten the time step.</source>
        <translation>La flexion à la particule %1 demande des sous-pas de %2 s, et le solveur automatique n’en prend pas plus de %3 dans un pas de temps : elle va s’emballer. Réduisez la rigidité en flexion, réunissez les petites mailles ou raccourcissez le pas de temps.</translation>
    </message>
    <message>
        <location filename="step_check.cpp"/>
        <source>The integrator bdf2 makes what single sweeps leave over grow, so that rods swing up: choose the automatic solver, or another integrator.</source>
        <translation>L’intégrateur bdf2 fait croître ce que laissent des balayages uniques, si bien que les tiges s’agitent de plus en plus : choisissez le solveur automatique ou un autre intégrateur.</translation>
    </message>
    <message>
        <location filename="step_check.cpp"/>
        <source>The substep of %1 s is above the %2 s that particle %3 may need for %4: shorten the time step, add substeps, or lower stiffness and damping.</source>
        <translation>Le sous-pas de %1 s dépasse les %2 s dont la particule %3 peut avoir besoin pour %4 : raccourcissez le pas de temps, ajoutez des sous-pas, ou diminuez la raideur et l’amortissement.</translation>
    </message>
    <message>
        <location filename="step_limits.cpp"/>
        <source>springs and bending</source>
        <translation>les ressorts et la flexion</translation>
    </message>
    <message>
        <location filename="strip_widths.cpp"/>
        <source>No link of this material lies along a panel, so that none gets a width: draw panels between its links first.</source>
        <translation>Aucune liaison de ce matériau ne longe un panneau, si bien qu’aucune ne reçoit de largeur : dessinez d’abord des panneaux entre ses liaisons.</translation>
    </message>
    <message>
        <location filename="strip_widths.cpp"/>
        <source>Widths from the mesh</source>
        <translation>Largeurs du maillage</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>(line %1, column %2) %3</source>
        <translation>(ligne %1, colonne %2) %3</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has %1, and this Ripstop was built without NLopt, which polishes; leave it out</source>
        <translation>contient %1, et ce Ripstop a été compilé sans NLopt, qui fait l’affinage ; retirez-le</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has %1, which does not lead upwards, or not from above 0 where its scale is log</source>
        <translation>a %1, qui ne monte pas, ou pas d’au-dessus de 0 alors que son échelle est log</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has %1, which is neither a number nor a text</source>
        <translation>a %1, qui n’est ni un nombre ni un texte</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has %1, whose low, mode and high do not rise</source>
        <translation>a %1, dont low, mode et high ne montent pas</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has a plan that goes through values, and the variable %1 has none; give it "values", or "from", "to" and "count"</source>
        <translation>a un plan qui parcourt des valeurs, et la variable %1 n’en a pas ; lui donner « values », ou « from », « to » et « count »</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has a plan that optimises, and no objectives; say what is wanted</source>
        <translation>a un plan qui optimise, et aucun objectif (objectives) ; dites ce qui est voulu</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has several objectives, which the method nsga2 is for, without polish</source>
        <translation>a plusieurs objectifs, pour lesquels il y a la méthode nsga2, sans polish</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>has two variables that are called %1</source>
        <translation>a deux variables appelées %1</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>is no study</source>
        <translation>n’est pas une étude</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>is no study: line %1, column %2 %3</source>
        <translation>n’est pas une étude : ligne %1, colonne %2 %3</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>keeps the best flights, and has no objectives; say what is wanted</source>
        <translation>garde les meilleurs vols et n’a pas d’objectifs ; dites ce qui est voulu</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>sets %1 a second time, and one value alone can be flown; leave it out of all but one variable</source>
        <translation>fixe %1 une seconde fois, alors qu’une seule valeur peut voler ; ne laissez ce chemin que dans une variable</translation>
    </message>
    <message>
        <location filename="study.cpp"/>
        <source>was written by another version of Ripstop; use that</source>
        <translation>a été écrit par une autre version de Ripstop ; utiliser celle-ci</translation>
    </message>
    <message>
        <location filename="study_database.cpp"/>
        <source>%1 is not written: this Ripstop was built without SQLite.</source>
        <translation>%1 n’est pas écrit : ce Ripstop a été compilé sans SQLite.</translation>
    </message>
    <message>
        <location filename="study_database.cpp"/>
        <source>%1 is there and is no database of SQLite; it is left as it is.</source>
        <translation>%1 existe et n’est pas une base de données SQLite ; il est laissé tel quel.</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1 = "%2"; it is one of %3</source>
        <translation>a %1 = « %2 » ; c’est l’un de %3</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which is neither true nor false</source>
        <translation>a %1, qui n’est ni true ni false</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which is no list in brackets</source>
        <translation>a %1, qui n’est pas une liste entre crochets</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which is no number from %2 to %3</source>
        <translation>a %1, qui n’est pas un nombre de %2 à %3</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which is no object in braces</source>
        <translation>a %1, qui n’est pas un objet entre accolades</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which is no text in quotation marks</source>
        <translation>a %1, qui n’est pas un texte entre guillemets</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has %1, which means nothing to this version</source>
        <translation>a %1, qui ne dit rien à cette version</translation>
    </message>
    <message>
        <location filename="study_fields.h"/>
        <source>has no %1</source>
        <translation>n’a pas de %1</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>A flight lasts longer than 0 s.</source>
        <translation>Un vol dure plus de 0 s.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>All are kept</source>
        <translation>Tous sont gardés</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Along the tear line</source>
        <translation>Le long de la ligne de déchirure</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Another seed draws other points.</source>
        <translation>Une autre graine tire d’autres points.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>At random</source>
        <translation>Au hasard</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Each flight</source>
        <translation>Chaque vol</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Every combination</source>
        <translation>Toutes les combinaisons</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Flights of a generation, at once</source>
        <translation>Vols d’une génération, menés à la fois</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Flights of the last stage, one after the other, from the best so far</source>
        <translation>Vols de la dernière étape, l’un après l’autre, à partir du meilleur jusque-là</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Generations</source>
        <translation>Générations</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Generations of</source>
        <translation>Générations de</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>How many of the best are kept</source>
        <translation>Combien des meilleurs sont gardés</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Latin hypercube</source>
        <translation>Hypercube latin</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>None is kept</source>
        <translation>Aucun n’est gardé</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Number of points</source>
        <translation>Nombre de points</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Of the best</source>
        <translation>Des meilleurs</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Of those that tore or ended early</source>
        <translation>De ceux déchirés ou arrêtés tôt</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>One at a time</source>
        <translation>Une à la fois</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Right-click the name of a property, in the inspector or beside a slider, and choose Study this.</source>
        <translation>Clic droit sur le nom d’une propriété, dans l’inspecteur ou près d’un curseur, puis Étudier ceci.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Rows of a file</source>
        <translation>Lignes d’un fichier</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Sobol' sequence</source>
        <translation>Suite de Sobol</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Study this on another property adds it.</source>
        <translation>Étudier ceci sur une autre propriété l’ajoute.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>The time %1.</source>
        <translation>La durée %1.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Those that fulfil all limits and come nearest to what is wanted; a flight that is overtaken loses its recording.</source>
        <translation>Ceux qui respectent toutes les limites et s’approchent le plus de ce qui est voulu ; un vol dépassé perd son enregistrement.</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Towards the best</source>
        <translation>Vers le meilleur</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Which flights are kept with all of their frames</source>
        <translation>Les vols gardés avec toutes leurs images</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>Which variable matters</source>
        <translation>Quelle variable compte</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>or until something tears</source>
        <translation>ou jusqu’à une déchirure</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>then from the best</source>
        <translation>puis à partir du meilleur</translation>
    </message>
    <message>
        <location filename="study_form.cpp"/>
        <source>with seed</source>
        <translation>avec la graine</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 flown along the tear line</source>
        <translation>%1 volés le long de la ligne</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 missed the wanted accuracy.</source>
        <translation>%1 ont manqué la précision voulue.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 of %2 flown</source>
        <translation>%1 sur %2 volés</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 of %2 flown again</source>
        <translation>%1 sur %2 revolés</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 of the %2 best recorded</source>
        <translation>%1 des %2 meilleurs enregistrés</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>%1 of up to %2 flown</source>
        <translation>%1 volés sur %2 au plus</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>&amp;Fly</source>
        <translation>&amp;Voler</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>&amp;New</source>
        <translation>&amp;Nouvelle</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>&amp;Open a study…</source>
        <translation>&amp;Ouvrir une étude…</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>A new study of the open design; this one stays in its file.</source>
        <translation>Une nouvelle étude du modèle ouvert ; celle-ci reste dans son fichier.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>A study flies the design many times with other values and shows what came of it as a map: for which stiffness and which strength does it hold?

Right-click the name of a property, in the inspector or beside a slider, and choose Study this.</source>
        <translation>Une étude fait voler le modèle de nombreuses fois avec d’autres valeurs et montre le résultat sur une carte : pour quelle raideur et quelle résistance tient-il ?

Clic droit sur le nom d’une propriété, dans l’inspecteur ou près d’un curseur, puis Étudier ceci.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Cannot open the study</source>
        <translation>Impossible d’ouvrir l’étude</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Flown by another build, %1: %2. They stay, and are flown anew.</source>
        <translation>Volés par une autre version, %1 : %2. Ils restent, et sont refaits.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Flying it again…</source>
        <translation>Nouveau vol…</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Flying the best again for their recordings…</source>
        <translation>Nouveau vol des meilleurs pour leurs enregistrements…</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Flying them again…</source>
        <translation>Nouveaux vols…</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>It flies %1, which is not the design that is open.</source>
        <translation>Elle fait voler %1, qui n’est pas le modèle ouvert.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>New study</source>
        <translation>Nouvelle étude</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Nothing varies yet: choose Study this on a property.</source>
        <translation>Rien ne varie encore : choisir Étudier ceci sur une propriété.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Open a study</source>
        <translation>Ouvrir une étude</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Open the file of another study.</source>
        <translation>Ouvrir le fichier d’une autre étude.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Opening…</source>
        <translation>Ouverture…</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Something tore in %1, %2 ended early.</source>
        <translation>Déchirure dans %1, %2 arrêtés tôt.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>Studies (*.ripstop-study.json);;All files (*)</source>
        <translation>Études (*.ripstop-study.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>The map is that of the study before you changed it; Fly adds the rest.</source>
        <translation>La carte est celle de l’étude avant sa modification ; Voler ajoute le reste.</translation>
    </message>
    <message>
        <location filename="study_panel.cpp"/>
        <source>The study %1.</source>
        <translation>L’étude %1.</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>%1 flights again, all the same to the bit.</source>
        <translation>%1 vols refaits, tous identiques au bit près.</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>%1 of %2 flights came to another state than the study has: the study is of another version or machine.</source>
        <translation>%1 vols sur %2 sont arrivés à un autre état que celui de l’étude : elle est d’une autre version ou d’une autre machine.</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>%1: flown again, and it came to another state than the study has: the study is of another version or machine.</source>
        <translation>%1 : revolé, et arrivé à un autre état que celui de l’étude : elle est d’une autre version ou d’une autre machine.</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>%1: flown again, the same to the bit. The timeline has it.</source>
        <translation>%1 : revolé, identique au bit près. La chronologie l’a.</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>The design has the values of the study now: %1</source>
        <translation>Le modèle a maintenant les valeurs de l’étude : %1</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>The open design cannot take it. %1</source>
        <translation>Le modèle ouvert ne peut pas les prendre. %1</translation>
    </message>
    <message>
        <location filename="study_panel_flights.cpp"/>
        <source>Values of a study</source>
        <translation>Valeurs d’une étude</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>%1 flights are selected.</source>
        <translation>%1 vols sont sélectionnés.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Apply</source>
        <translation>&amp;Appliquer</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Compare</source>
        <translation>&amp;Comparer</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Compare %1</source>
        <translation>&amp;Comparer %1</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Curves (SVG, PDF, PNG, CSV)…</source>
        <translation>&amp;Courbes (SVG, PDF, PNG, CSV)…</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Picture (SVG, PDF, PNG)…</source>
        <translation>&amp;Image (SVG, PDF, PNG)…</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Table (CSV)…</source>
        <translation>&amp;Tableau (CSV)…</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>&amp;Watch</source>
        <translation>&amp;Regarder</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>(none)</source>
        <translation>(aucune)</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Best so far</source>
        <translation>Meilleur jusque-là</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Click a flight to watch it or to take its values.</source>
        <translation>Cliquer sur un vol pour le regarder ou prendre ses valeurs.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Ended early at %1: %2</source>
        <translation>Arrêté tôt, à %1 : %2</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Fly it again with all of its frames, to the moment when it tears or to its end, and compare its hash with that of the study.</source>
        <translation>Le refaire voler avec toutes ses images, jusqu’au moment où il se déchire ou jusqu’à sa fin, et comparer son empreinte à celle de l’étude.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Fly shows here what comes of it, a cell for each flight.

Then a click on one opens that flight or takes its values.</source>
        <translation>Voler montre ici ce qui en résulte, une case par vol.

Un clic sur l’une d’elles ouvre ensuite ce vol ou reprend ses valeurs.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Fly the selected flights again in the background, and show the curves of a probe over each other and the flights as ghosts in the view. Ctrl or Shift and click, or a rubber band, selects several.</source>
        <translation>Refaire voler les vols sélectionnés en arrière-plan, et montrer les courbes d’une sonde superposées et les vols en fantômes dans la vue. Ctrl ou Maj et clic, ou un rectangle tiré, en sélectionne plusieurs.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Give the open design the values of this flight, as one step.</source>
        <translation>Donner au modèle ouvert les valeurs de ce vol, en une seule étape.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Held.</source>
        <translation>A tenu.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Parallel axes</source>
        <translation>Axes parallèles</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Percentiles</source>
        <translation>Centiles</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Save the table or the picture</source>
        <translation>Enregistrer le tableau ou l'image</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Scatter matrix</source>
        <translation>Matrice de nuages</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>The value at which the map is cut</source>
        <translation>La valeur où la carte est coupée</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Tore at %1, at a load of %2.</source>
        <translation>Déchiré à %1, sous une charge de %2.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Variable to the right</source>
        <translation>Variable vers la droite</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>Variable upwards</source>
        <translation>Variable vers le haut</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>What is shown</source>
        <translation>Ce qui est montré</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>What matters</source>
        <translation>Ce qui compte</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>not flown yet.</source>
        <translation>pas encore volé.</translation>
    </message>
    <message>
        <location filename="study_view.cpp"/>
        <source>over</source>
        <translation>selon</translation>
    </message>
    <message>
        <location filename="study_view_files.cpp"/>
        <source>Pictures (*.svg *.pdf *.png)</source>
        <translation>Images (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <location filename="study_view_files.cpp"/>
        <source>Pictures (*.svg *.pdf *.png);;Tables (*.csv)</source>
        <translation>Images (*.svg *.pdf *.png);;Tableaux (*.csv)</translation>
    </message>
    <message>
        <location filename="suggested_variable.cpp"/>
        <source>%1 cannot be varied: it is no number, vector, switch or choice that is there.</source>
        <translation>%1 ne peut pas varier : ce n’est ni un nombre, ni un vecteur, ni un interrupteur, ni un choix qui soit là.</translation>
    </message>
    <message>
        <location filename="suggested_variable.cpp"/>
        <source>There is nothing of which %1 could be varied.</source>
        <translation>Il n’y a rien dont %1 pourrait varier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>0.5 oz</source>
        <translation>0,5 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>0.75 oz</source>
        <translation>0,75 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 adds probes that tell where the energy comes from and where it goes, and a plot of them.</source>
        <translation>1 ajoute des sondes qui disent d’où vient l’énergie et où elle va, et une courbe de celles-ci.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 adds rods between second neighbours.</source>
        <translation>1 ajoute des tiges entre deuxièmes voisines.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 adds two rigidity particles, before and behind the frame, tied to every node.</source>
        <translation>1 ajoute deux particules de rigidité, devant et derrière l’armature, attachées à chaque nœud.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 flies the wing with the vortex law, which finds lift slope and induced drag from its shape; 0 with the plate law and the lift slope above; the keel has that law in any case.</source>
        <translation>1 fait voler l’aile avec la loi tourbillonnaire, qui tire de sa forme la pente de portance et la traînée induite ; 0 avec la loi de la plaque et la pente ci-dessus ; la quille a cette dernière dans tous les cas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 flies with the vortex law, which finds lift slope and induced drag from the shape of the wing; 0 with the plate law and the lift slope above.</source>
        <translation>1 fait voler avec la loi tourbillonnaire, qui tire de la forme de l’aile la pente de portance et la traînée induite ; 0 avec la loi de la plaque et la pente ci-dessus.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 gives all particles but the payload the same mass, as the paper on kites did; 0 weighs cloth, lines and hoop where they are.</source>
        <translation>1 donne à toutes les particules sauf la charge la même masse, comme l’article sur les cerfs-volants ; 0 pèse la toile, les suspentes et le cerceau là où ils sont.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 gives all particles of the kite the same mass, as the paper on kites did; 0 weighs cloth and spars where they are.</source>
        <translation>1 donne à toutes les particules du cerf-volant la même masse, comme l’article sur les cerfs-volants ; 0 pèse la toile et les longerons là où ils sont.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 has panels carry the fabric's pull instead of springs: with warp, weft, shear and wrinkles, and the same on every mesh.</source>
        <translation>1 fait porter la traction du tissu par les panneaux au lieu de ressorts : avec chaîne, trame, cisaillement et plis, et de même sur tout maillage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 has panels carry the pull, with the stretch that was measured; with 0 threads do, which never stretch.</source>
        <translation>1 fait porter la traction par les panneaux, avec l’allongement mesuré ; avec 0 ce sont des fils, qui ne s’allongent jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 holds one end so that the rod swings, 0 lets it fall to the ground.</source>
        <translation>1 tient un bout et la tige balance, 0 la laisse tomber au sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 holds the skirt open with a rigid hoop where there is no canopy pressure, 0 leaves it to the air.</source>
        <translation>1 tient la jupe ouverte par un cerceau rigide quand la voilure n’a pas de pression, 0 la laisse à l’air.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 holds the upper corners, 0 lets it fall to the ground.</source>
        <translation>1 tient les coins hauts, 0 la laisse tomber au sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 in</source>
        <translation>1 po</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 kg on a rod of 1 m, let go at 30 degrees: it swings once in 2.041 s.</source>
        <translation>1 kg sur une tige de 1 m, lâché à 30 degrés : il bat une fois en 2,041 s.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 pins the second particle as well, so that the first segment keeps its direction.</source>
        <translation>1 fixe aussi la deuxième particule, et le premier segment garde sa direction.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 resists tension only like a rope, 0 compression too like a chain of sticks.</source>
        <translation>1 ne résiste qu’à la traction comme un cordage, 0 à la compression aussi comme une chaîne de bâtons.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1 starts with the sheet lying level, 0 hanging.</source>
        <translation>1 démarre avec la toile à plat, 0 suspendue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1.5 oz</source>
        <translation>1,5 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>1/2 in</source>
        <translation>1/2 po</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>10 kg under a cross of 1.1 oz nylon sink at 4.9 m/s; a frame stands for the air that holds the arms apart. Tune the porosity of square and arms, 0 to 0.2: the more air the cloth lets through, the faster it sinks.</source>
        <translation>10 kg sous une croix de nylon de 1,1 oz descendent à 4,9 m/s ; un cadre remplace l’air qui tient les bras écartés. Réglez la porosité du carré et des bras (square, arms), de 0 à 0,2 : plus la toile laisse passer d’air, plus il descend vite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>5 kg hang from three rows of lines. A table has the lengths, row by row from the riser up.</source>
        <translation>5 kg pendent à trois rangées de brins. Un tableau en a les longueurs, rangée par rangée depuis l’élévateur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>550 cord</source>
        <translation>corde 550</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>6 m/s with the gusts of light turbulence after Dryden, on a delta of 0.75 oz. Another seed gives other gusts. Tune the line strength of the line: the jerk of the launch pulls with 120 N, gusts with 50 N, and it breaks at 450 N.</source>
        <translation>6 m/s avec les rafales d’une turbulence légère d’après Dryden, sur un delta de 0,75 oz. Une autre graine donne d’autres rafales. Réglez la résistance de la ligne : la secousse du lancement tire avec 120 N, les rafales avec 50 N, et elle rompt à 450 N.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>65 kg swing on a line of 100 g. Each segment carries 65 000 times its own mass.</source>
        <translation>65 kg balancent sur une ligne de 100 g. Chaque segment porte 65 000 fois sa propre masse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>7020 II</source>
        <translation>7020 II</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>7020 III</source>
        <translation>7020 III</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>9/16 in</source>
        <translation>9/16 po</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A bob at the free end, over and above the rope's own mass.</source>
        <translation>Un poids au bout libre, en plus de la masse du cordage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A bowed kite of 0.75 oz ripstop. Down pulls the hand back against the wind, Up gives way, Left and Right walk sideways. Tune the membrane stiffness of sail and trim, 2 to 100 kN/m: a sail that stretches flies lower and pulls less.</source>
        <translation>Un cerf-volant bombé en ripstop de 0,75 oz. Bas tire la main en arrière contre le vent, Haut cède, Gauche et Droite marchent de côté. Réglez la raideur de membrane de sail et trim, de 2 à 100 kN/m : une voile qui s’étire vole plus bas et tire moins.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A box on the ground that cloth lies on and lines bend round.</source>
        <translation>Une boîte au sol où la toile se pose et que les lignes contournent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A canopy of 1.1 oz nylon in folds is thrown down at 20 m/s. Air fills it through its mouth and holds it open without a hoop. Tune the line strength of the suspension line: each bears 26 N as the canopy opens, 11 N as it sinks, and breaks at 445 N, at its knots at 267 N. The dock Loads lists what is nearest to breaking.</source>
        <translation>Une voilure pliée en nylon de 1,1 oz est lancée vers le bas à 20 m/s. L’air la remplit par sa bouche et la tient ouverte sans cerceau. Réglez la résistance de ligne des suspentes : chacune porte 26 N à l’ouverture, 11 N en descente, et rompt à 445 N, à ses nœuds à 267 N. Le panneau Charges liste ce qui est le plus près de rompre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A canopy of F-111, which lets next to no air through, is thrown down in folds at 20 m/s. Air fills it through its mouth and holds it open without a hoop. Tune the porosity of odd and even gores, 0 to 0.1: cloth that leaks opens later and sinks faster.</source>
        <translation>Une voilure de F-111, qui ne laisse presque pas passer d’air, est lancée pliée vers le bas à 20 m/s. L’air la remplit par sa bouche et la tient ouverte sans cerceau. Réglez la porosité des fuseaux impairs et pairs (odd gores, even gores), de 0 à 0,1 : une toile qui fuit s’ouvre plus tard et descend plus vite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A curtain of 2 m hangs by rings that are free along a rail. The last ring is drawn to the left by itself, at 0.2 m/s.</source>
        <translation>Un rideau de 2 m pend à des anneaux libres le long d’un rail. Le dernier anneau est tiré de lui-même vers la gauche, à 0,2 m/s.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A cut from the middle of the lower edge upwards, over the height; tears start there.</source>
        <translation>Une coupe du milieu du bord bas vers le haut, rapportée à la hauteur ; les déchirures y commencent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A cylinder on the ground, upright or lying, that cloth drapes over.</source>
        <translation>Un cylindre au sol, debout ou couché, sur lequel un tissu se drape.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A delta of 5 m and 0.5 oz in a gusty wind. At 15.3 s, after a lull, a gust of 15 m/s snaps its line tight: it pulls with 1.1 kN, and the old pocket along the leading edge, taken to bear 0.06 of the cloth's strength, tears at 320 N/m. Tune the joint efficiency of the border, 0.05 to 0.2; or give sail and border 0.75 oz, which also takes their tear rule and efficiency: with strength and 0.06 again it holds, with a fifth to spare.</source>
        <translation>Un delta de 5 m en 0,5 oz dans un vent de rafales. À 15,3 s, après une accalmie, une rafale de 15 m/s tend sa ligne d’un coup : elle tire à 1,1 kN, et le vieux fourreau du bord d’attaque, censé garder 0,06 de la résistance de la toile, se déchire à 320 N/m. Réglez la tenue des coutures de « border », de 0,05 à 0,2 ; ou donnez à « sail » et « border » le 0,75 oz, qui leur prend aussi leur règle de rupture et leur tenue des coutures : avec « résistance » et de nouveau 0,06, il tient, avec un cinquième de marge.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A delta wing with a keel, on a line from a hand.</source>
        <translation>Une aile delta avec une quille, sur une ligne tenue à la main.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A flag of 1.2 m x 0.8 m in 8 m/s of wind bends a fibre glass pole of 12 mm.</source>
        <translation>Un drapeau de 1,2 m x 0,8 m dans un vent de 8 m/s fait plier un mât de fibre de verre de 12 mm.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A flag tied to a pole that stands on the ground and may bend.</source>
        <translation>Un drapeau attaché à un mât planté au sol qui peut plier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A flag with a picture of its own: a PNG beside the scene, named by the material of the flag. Tune where it lies: its width, 0 to 1.2 m, and its turn.</source>
        <translation>Un drapeau qui a sa propre image : un PNG à côté de la scène, nommé par le matériau du drapeau. Réglez sa place : sa largeur, de 0 à 1,2 m, et sa rotation.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A flexible wing with a pilot who steers by shifting weight.</source>
        <translation>Une aile souple avec un pilote qui dirige en déportant son poids.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A front passes</source>
        <translation>Un front passe</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A hanging sheet is let go and folds on the ground. Its layers stay 12 mm apart.</source>
        <translation>Une toile suspendue est lâchée et se plie au sol. Ses couches restent à 12 mm l’une de l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A kite of 0.75 oz ripstop on fibreglass tubes of 6 mm. Down pulls the hand back against the wind, Up gives way, Left and Right walk sideways. Tune the wind, 3 to 12 m/s, and the line strength of the line, 1 to 10 N: it breaks where the pull is more.</source>
        <translation>Un cerf-volant en ripstop de 0,75 oz sur des tubes de fibre de verre de 6 mm. Bas tire la main en arrière contre le vent, Haut cède, Gauche et Droite marchent de côté. Réglez le vent, de 3 à 12 m/s, et la résistance de la ligne, de 1 à 10 N : elle rompt quand la traction est plus forte.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A line of EA = 100 kN and 10 m hangs 65 kg. It bounces, is calmed by its own damping, and comes to rest 64 mm longer, M g L / (EA).</source>
        <translation>Une ligne de EA = 100 kN et de 10 m porte 65 kg. Elle rebondit, son propre amortissement la calme, et elle s’arrête 64 mm plus longue, M g L / (EA).</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A line resists tension only, a strut compression only, a batten both.</source>
        <translation>Une ligne ne résiste qu’à la traction, un étai qu’à la compression, une latte aux deux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A link or an elastic panel tears above this, in metres, as a strain, in newtons or in newtons per metre as the rule says.</source>
        <translation>Une liaison ou un panneau élastique cède au-delà, en mètres, en déformation, en newtons ou en newtons par mètre comme le dit la règle.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A loose sheet falls on three boxes, one of them on its edge. Particles keep 4 mm from the boxes and 8 mm from the sheet itself.</source>
        <translation>Une toile libre tombe sur trois boîtes, dont une sur son arête. Les particules restent à 4 mm des boîtes et à 8 mm de la toile même.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A loose sheet falls over a lying cylinder and hangs down on both sides. Friction holds it.</source>
        <translation>Un tissu libre tombe sur un cylindre couché et pend des deux côtés. Le frottement le retient.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A loose sheet of 0.75 oz ripstop falls over a ball and stays on it. Ball and ground are solved together with the cloth, so that it is as stiff as it says. Tune the friction of the ball, 0 to 0.6: on a smooth one it slides off.</source>
        <translation>Une toile libre de ripstop de 0,75 oz tombe sur une boule et y reste. La boule et le sol sont résolus avec la toile, qui est donc aussi raide qu’il est dit. Réglez le frottement de la boule, de 0 à 0,6 : d’une boule lisse, elle glisse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A mesh for each frame; tears part it.</source>
        <translation>Un maillage par image ; les déchirures le séparent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A new one</source>
        <translation>Un nouveau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A number made of what other probes read, by their names with _ for blanks: line_tension / weight.</source>
        <translation>Un nombre fait de ce que lisent d’autres sondes, par leurs noms avec _ pour les blancs : line_tension / weight.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A number made of what other probes read.</source>
        <translation>Un nombre fait de ce que lisent d’autres sondes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A particle faster than this counts as diverged, and the run stops.</source>
        <translation>Une particule plus rapide que cela compte comme divergente, et la simulation s’arrête.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A particle on the right of nose and tail, for roll and angle of attack.</source>
        <translation>Une particule à droite du nez et de la queue, pour le roulis et l’angle d’attaque.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A plane without end, a sphere, a box, a cylinder, hills or a relief from a picture, or a mesh from a file.</source>
        <translation>Un plan sans fin, une sphère, une boîte, un cylindre, des collines ou un relief tiré d’une image, ou un maillage tiré d’un fichier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A point of the plane, the centre of the sphere, the box or the cylinder, the middle of the foot of a height field, or the origin of the mesh.</source>
        <translation>Un point du plan, le centre de la sphère, de la boîte ou du cylindre, le milieu du pied d’un champ de hauteurs, ou l’origine du maillage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A rope or line between the two selected particles, with new particles along it.</source>
        <translation>Un cordage ou une ligne entre les deux particules sélectionnées, avec de nouvelles particules en chemin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A round canopy with suspension lines and a payload.</source>
        <translation>Une voilure ronde avec des suspentes et une charge.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A row for each frame; units stand in the header.</source>
        <translation>Un rang pour chaque image ; les unités sont dans l’en-tête.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A row for each row of lines, a column for each level from the riser up, in metres. Paste it from a spreadsheet; it takes the place of rows, levels and height.</source>
        <translation>Un rang pour chaque rangée de brins, une colonne pour chaque étage à partir de l’élévateur, en mètres. À coller depuis un tableur ; il prend la place des rangées, des étages et de la hauteur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A row of rods, hung by one end or by both.</source>
        <translation>Une file de tiges, suspendue par un bout ou par les deux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet of 6 m falls on generated hills, a height field of 256 x 256 points.</source>
        <translation>Une toile de 6 m tombe sur des collines engendrées, un champ de hauteurs de 256 x 256 points.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet of cloth, hung by corners or an edge.</source>
        <translation>Une toile, suspendue par des coins ou un bord.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet of masses and springs, held by two corners, hangs down over a sphere. The arrow keys move a corner. Tune the stiffness of the springs, 20 to 1000 N/m: soft ones sag.</source>
        <translation>Une toile de masses et de ressorts, tenue par deux coins, retombe sur une sphère. Les touches fléchées déplacent un coin. Réglez la raideur des ressorts, 20 à 1000 N/m : les mous s’affaissent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet over a bowed frame, a bridle of four legs and a tail.</source>
        <translation>Une toile sur une armature arquée, une bride à quatre brins et une queue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet with a slit is drawn apart at 0.05 m/s. Springs tear at a strain of 0.3, and the panels beside them are gone.</source>
        <translation>Une toile avec une fente est étirée à 0,05 m/s. Les ressorts rompent à une déformation de 0,3, et les panneaux à côté d’eux disparaissent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sheet with a slit is drawn apart at 0.05 m/s. The mesh splits where a spring tears, one in each step, and every panel stays whole on its side.</source>
        <translation>Une toile avec une fente est étirée à 0,05 m/s. Le maillage se fend là où un ressort rompt, un à chaque pas, et chaque panneau reste entier de son côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A sphere on the ground that cloth drapes over.</source>
        <translation>Une sphère au sol sur laquelle la toile se drape.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A spring pulls with a force, a rod keeps its length as a constraint.</source>
        <translation>Un ressort tire avec une force, une tige garde sa longueur comme contrainte.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A square of cloth with four arms, or without, over a payload.</source>
        <translation>Un carré de toile à quatre bras, ou sans, au-dessus d’une charge.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A strip of five threads of 100 N/m is drawn at 0.05 m/s. They break at a strain of 0.3: after 3 s, at 0.75 N, one link in each step.</source>
        <translation>Une bande de cinq fils de 100 N/m est étirée à 0,05 m/s. Ils rompent à une déformation de 0,3 : après 3 s, à 0,75 N, une liaison à chaque pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A wing of 14 m2 and aspect ratio 7.2 of laminate and tubes of 62 mm with the vortex law, at the mass and the drag of a modern hang glider. It glides at 11, such wings reach 13.4 (USHPA-4), and the plate law half of it. The keys shift the pilot. Tune the flexural rigidity of the tube, 500 to 20 000 N m2: with soft leading edges it swings up and down.</source>
        <translation>Une aile de 14 m2 et d’allongement 7,2, en laminé sur des tubes de 62 mm, avec la loi tourbillonnaire, à la masse et à la traînée d’un deltaplane moderne. Elle plane à 11, de telles ailes atteignent 13,4 (USHPA-4), et la loi des plaques la moitié. Les touches déplacent le pilote. Réglez la rigidité de flexion du tube, de 500 à 20 000 N m2 : avec des bords d’attaque souples, elle ondule de haut en bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>A worn sail</source>
        <translation>Une voile usée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>About the vertical.</source>
        <translation>Autour de la verticale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Above that of the air around.</source>
        <translation>Au-dessus de celle de l’air autour.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Acceleration of everything that falls; y is up.</source>
        <translation>Accélération de tout ce qui tombe ; y est vers le haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Across</source>
        <translation>En largeur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Across x</source>
        <translation>En travers de x</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Across y</source>
        <translation>En travers de y</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Across z</source>
        <translation>En travers de z</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Added mass</source>
        <translation>Masse ajoutée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Adds the other half of what is selected. What lies on the plane belongs to both halves, panels are turned round, and copies join the groups of their originals.</source>
        <translation>Ajoute l’autre moitié de la sélection. Ce qui est sur le plan appartient aux deux moitiés, les panneaux sont retournés, et les copies rejoignent les groupes de leurs originaux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Against</source>
        <translation>Selon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air density</source>
        <translation>Masse volumique de l’air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air force</source>
        <translation>Force de l’air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air force across the relative wind, upwards.</source>
        <translation>Force de l’air en travers du vent relatif, vers le haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air force along the relative wind.</source>
        <translation>Force de l’air le long du vent relatif.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air in the canopy</source>
        <translation>Air dans la voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Air law</source>
        <translation>Loi d’air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Airspeed</source>
        <translation>Vitesse air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Airspeed in trim; it says where along the keel the pilot hangs.</source>
        <translation>Vitesse air à l’équilibre ; elle dit où le long de la quille pend le pilote.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>All into one</source>
        <translation>Toutes en une</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>All that is measured, as arrays for ParaView and Python.</source>
        <translation>Tout ce qui est mesuré, en tableaux pour ParaView et Python.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>All to one</source>
        <translation>Toutes à une seule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along a line</source>
        <translation>Le long d’une ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along itself</source>
        <translation>Le long de soi</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along the pole.</source>
        <translation>Le long du mât.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along x, as seen from the front from left to right.</source>
        <translation>Le long de x, vu de face de gauche à droite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along y.</source>
        <translation>Le long de y.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Along z.</source>
        <translation>Le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Altitude</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 6061-T6 tube 28.6 x 1.24 mm</source>
        <translation>Tube aluminium 6061-T6 28,6 x 1,24 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 6061-T6 tube 38.1 x 0.89 mm</source>
        <translation>Tube aluminium 6061-T6 38,1 x 0,89 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 6061-T6 tube 41.3 x 1.24 mm</source>
        <translation>Tube aluminium 6061-T6 41,3 x 1,24 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 7075-T6 tube 42 x 0.9 mm</source>
        <translation>Tube d’aluminium 7075-T6 42 x 0,9 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 7075-T6 tube 50 x 0.9 mm</source>
        <translation>Tube aluminium 7075-T6 50 x 0,9 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 7075-T6 tube 52 x 0.9 mm</source>
        <translation>Tube aluminium 7075-T6 52 x 0,9 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aluminium 7075-T6 tube 62 x 1.0 mm</source>
        <translation>Tube aluminium 7075-T6 62 x 1,0 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>An index and a folder of VTP files with all that is measured.</source>
        <translation>Un index et un dossier de fichiers VTP avec tout ce qui est mesuré.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle at which a section of a wing with the vortex law meets the air when it has lost half of its circulation; 15 for a wing, 10 to 12 for a thin sail.</source>
        <translation>Angle auquel un profil d’une aile à loi tourbillonnaire rencontre l’air quand il a perdu la moitié de sa circulation ; 15 pour une aile, 10 à 12 pour une voile mince.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle between the warp of real cloth and the arm that it is cut for; 45 is a bias cut.</source>
        <translation>Angle entre la chaîne d’une vraie toile et le bras pour lequel elle est coupée ; 45 est une coupe en biais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle between the warp of real cloth and the middle of its gore; 45 is a bias cut.</source>
        <translation>Angle entre la chaîne d’une vraie toile et le milieu de son fuseau ; 45 est une coupe en biais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle between the warp of real cloth and the trailing edge, mirrored at the keel; at 90 it runs along the keel.</source>
        <translation>Angle entre la chaîne d’une vraie toile et le bord de fuite, en miroir de part et d’autre de la quille ; à 90 elle suit la quille.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle by which the picture is turned on the cloth, counter-clockwise about its middle.</source>
        <translation>Angle dont l’image est tournée sur le tissu, dans le sens inverse des aiguilles d’une montre, autour de son milieu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle from the side ab of each panel, towards c, at which the warp of the cloth runs, where panels carry the pull of the fabric; for one direction on the cloth map it by a formula, or paint it.</source>
        <translation>Angle, depuis le côté ab de chaque panneau vers c, que suit la chaîne du tissu, là où les panneaux portent la traction du tissu ; pour une seule direction sur le tissu, le donner par une carte ou le peindre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle of attack</source>
        <translation>Angle d’attaque</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angle of the line above the horizon at the start.</source>
        <translation>Angle de la ligne au-dessus de l’horizon au départ.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Angles about x, then y, then z; planes and spheres do not use it.</source>
        <translation>Angles autour de x, puis y, puis z ; plans et sphères ne les utilisent pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Animation, glTF</source>
        <translation>Animation, glTF</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Animation, glTF as text</source>
        <translation>Animation, glTF en texte</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Another number, other hills.</source>
        <translation>Un autre nombre, d’autres collines.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Arch of the sail between keel and leading edge, over its local half width.</source>
        <translation>Flèche de la voile entre la quille et le bord d’attaque, rapportée à sa demi-largeur locale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Area that its panels are meant to have; empty sets no target.</source>
        <translation>Aire que ses panneaux doivent avoir ; vide ne vise rien.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Areal density</source>
        <translation>Masse surfacique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Arms</source>
        <translation>Bras</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>As in the paper: 152 particles of equal mass, 458 rods, 55 iterations of averaging, 100 Hz. It stands in 3 m/s of wind; the rods where the line pulls are half as long again as they should be.</source>
        <translation>Comme dans l’article : 152 particules de même masse, 458 tiges, 55 itérations de moyennes, 100 Hz. Il tient dans un vent de 3 m/s ; les tiges là où la ligne tire sont une fois et demie trop longues.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>As in the paper: 49 particles, 198 rods, 55 iterations of averaging, 100 Hz. The keys shift the pilot. It comes down at more than 40 degrees, since averaging does not keep momentum.</source>
        <translation>Comme dans l’article : 49 particules, 198 tiges, 55 itérations de moyennes, 100 Hz. Les touches déplacent le pilote. Il descend à plus de 40 degrés, car les moyennes ne conservent pas la quantité de mouvement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>As in the paper: six rings, a hoop, 55 iterations of averaging, 100 Hz. It sinks twice as fast as it should, since averaging does not keep momentum; take averaged_jacobi as the rod solver to see the difference.</source>
        <translation>Comme dans l’article : six anneaux, un cerceau, 55 itérations de moyennes, 100 Hz. Il descend deux fois trop vite, car les moyennes ne conservent pas la quantité de mouvement ; prendre averaged_jacobi comme solveur des tiges pour voir la différence.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Aspect of cells</source>
        <translation>Allongement des mailles</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>At the first</source>
        <translation>À la première</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Auto</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Automatic rate</source>
        <translation>Vitesse automatique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Averaged Jacobi</source>
        <translation>Jacobi moyenné</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Axial stiffness</source>
        <translation>Rigidité axiale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Axial stiffness EA of the rope, its tension per strain; 0 never stretches.</source>
        <translation>Rigidité axiale EA du cordage, sa tension par déformation ; 0 ne s’allonge jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Axis that the ring runs about.</source>
        <translation>Axe autour duquel court l’anneau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>B of a fabric, its bending moment per width and curvature: panels of this material that share a side resist folding there; 0 lets them fold freely.</source>
        <translation>B d’un tissu, son moment de flexion par largeur et par courbure : les panneaux de ce matériau qui ont un côté commun résistent au pli ; 0 les laisse plier librement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>BDF2</source>
        <translation>BDF2</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Balance</source>
        <translation>Bilan</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bays across.</source>
        <translation>Travées en largeur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bays down.</source>
        <translation>Travées en hauteur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bays of spars in a plane, braced or stiffened by rigidity particles.</source>
        <translation>Des travées de longerons dans un plan, contreventées ou raidies par des particules de rigidité.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bend</source>
        <translation>Flexion</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending</source>
        <translation>Flexion</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending moment</source>
        <translation>Moment de flexion</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending moment at which a spar snaps, or yields for good; spars snap by it where the material tears by strength, and else it is noted for margins.</source>
        <translation>Moment de flexion auquel un longeron casse ou se plie pour de bon ; les longerons y cassent si le matériau cède par résistance, sinon il est noté pour les marges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending stiffness</source>
        <translation>Rigidité en flexion</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending stiffness of the fabric, its moment per width and curvature; garments have 1e-5 to 1e-4.</source>
        <translation>Rigidité en flexion du tissu, son moment par largeur et par courbure ; les vêtements ont 1e-5 à 1e-4.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bending test</source>
        <translation>Essai de flexion</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Between strips, with a ramp in it.</source>
        <translation>Entre les bandes, avec une rampe dedans.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Between the chord, from tail to nose, and the relative wind, in the plane across the span.</source>
        <translation>Entre la corde, de la queue au nez, et le vent relatif, dans le plan perpendiculaire à l’envergure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Between the ground and the underside.</source>
        <translation>Entre le sol et le dessous.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bias</source>
        <translation>Biais</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Billow</source>
        <translation>Creux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Black denim, 11 oz</source>
        <translation>Denim noir, 11 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Border</source>
        <translation>Bord</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Both edges</source>
        <translation>Les deux bords</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Both sides</source>
        <translation>Des deux côtés</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bow</source>
        <translation>Arc</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Boxes</source>
        <translation>Boîtes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Boxes on the ground in a ring below the sheet, each turned another way.</source>
        <translation>Boîtes au sol en cercle sous la toile, chacune tournée autrement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Braces</source>
        <translation>Contreventements</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Braces in each bay: 0 none, 1 one, leaning to and fro, 2 crossed.</source>
        <translation>Contreventements dans chaque travée : 0 aucun, 1 un seul, penché tour à tour, 2 croisés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Breaking by strength</source>
        <translation>Rupture par la résistance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Breaking moment</source>
        <translation>Moment de rupture</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bridle</source>
        <translation>Bride</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Bridle cascade</source>
        <translation>Cascade de brides</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Builder</source>
        <translation>Générateur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Builder that made this part; empty when drawn by hand.</source>
        <translation>Générateur qui a fait cette pièce ; vide si elle est dessinée à la main.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>By area (kg/m²)</source>
        <translation>Par aire (kg/m²)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>By how much of the first each gust is stronger than the one before: 0.25 has peaks of 1, 1.25, 1.5 and so on.</source>
        <translation>De quelle part de la première chaque rafale dépasse la précédente : 0,25 donne des sommets de 1, 1,25, 1,5 et ainsi de suite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>By length (kg/m)</source>
        <translation>Par longueur (kg/m)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cable nets and trusses</source>
        <translation>Filets de câbles et treillis</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cables</source>
        <translation>Câbles</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Camber</source>
        <translation>Cambrure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Camber position</source>
        <translation>Position de la cambrure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopies</source>
        <translation>Voilures</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopy</source>
        <translation>Voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopy pressure</source>
        <translation>Pression de voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopy pressure coefficient, 1.68 for round canopies: the air fills the canopy and holds it open, without a hoop, and the drag is what comes of it; 0 has each panel meet the wind by itself.</source>
        <translation>Coefficient de pression de voilure, 1,68 pour les voilures rondes : l’air remplit la voilure et la tient ouverte, sans cerceau, et la traînée est ce qui en sort ; 0 laisse chaque panneau rencontrer le vent seul.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopy pressure coefficient: the air fills the canopy and holds it open, without a frame, and the drag is what comes of it; 0 has each panel meet the wind by itself.</source>
        <translation>Coefficient de pression de voilure : l’air remplit la voilure et la tient ouverte, sans cadre, et la traînée est ce qui en sort ; 0 laisse chaque panneau rencontrer le vent seul.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Canopy volume</source>
        <translation>Volume de voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon rod 2 mm</source>
        <translation>Jonc de carbone 2 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon rod 3 mm</source>
        <translation>Jonc de carbone 3 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon rod 4 mm</source>
        <translation>Jonc de carbone 4 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon tube 4/2.5 mm</source>
        <translation>Tube carbone 4/2,5 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon tube 6/4 mm, pultruded</source>
        <translation>Tube carbone 6/4 mm, pultrudé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon tube 8/6 mm, pultruded</source>
        <translation>Tube carbone 8/6 mm, pultrudé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Carbon tube 8/6.5 mm, wrapped</source>
        <translation>Tube carbone 8/6,5 mm, enroulé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cascade</source>
        <translation>Cascade</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells</source>
        <translation>Mailles</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells across a strip.</source>
        <translation>Mailles en largeur d’une bande.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells across.</source>
        <translation>Mailles en largeur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells across; an odd number is made even, so that the spine has its nodes.</source>
        <translation>Mailles en largeur ; un nombre impair est rendu pair, pour que l’épine ait ses nœuds.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells along each side of the square in the middle.</source>
        <translation>Mailles le long de chaque côté du carré central.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells down.</source>
        <translation>Mailles en hauteur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells from the edge of the table to the tip.</source>
        <translation>Mailles du bord de la table au bout.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells from the leading to the trailing edge.</source>
        <translation>Mailles du bord d’attaque au bord de fuite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells from the pole to the free edge.</source>
        <translation>Mailles du mât au bord libre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cells from the upper to the lower edge.</source>
        <translation>Mailles du bord haut au bord bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Centre of pressure x</source>
        <translation>Centre de poussée x</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Centre of pressure y</source>
        <translation>Centre de poussée y</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Centre of pressure z</source>
        <translation>Centre de poussée z</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Change of the commanded value per key press.</source>
        <translation>Changement de la valeur demandée à chaque appui.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Chord</source>
        <translation>Corde</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Clamped</source>
        <translation>Encastrée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Clamped edge</source>
        <translation>Bord encastré</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Clearance</source>
        <translation>Garde au sol</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Closes the hole that the selected particles surround with panels.</source>
        <translation>Ferme de panneaux le trou que les particules sélectionnées entourent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth</source>
        <translation>Toile</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth falls in a wind, wraps a sphere and swings. The plot shows where its energy comes from and where it goes; the residual is what the solver made of it.</source>
        <translation>Une étoffe tombe dans le vent, enveloppe une sphère et se balance. La courbe montre d’où vient son énergie et où elle va ; le résidu est ce que le solveur en a fait.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth of the canopy; ideal cloth never stretches and is as heavy and porous as is said below, a real one is carried by panels, wrinkles and does not push.</source>
        <translation>Toile de la voilure ; une toile idéale ne s’étire jamais et a le poids et la porosité dits plus bas, une vraie est portée par des panneaux, fait des plis et ne pousse pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth of the flag; ideal cloth is a sheet of springs, as stiff and heavy as said below, a real one is carried by panels and wrinkles.</source>
        <translation>Tissu du drapeau ; un tissu idéal est une nappe de ressorts, aussi raide et lourde qu’indiqué plus bas, un vrai est porté par des panneaux et fait des plis.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth of the sail; ideal cloth never stretches and weighs what is said above, a real one is carried by panels and wrinkles.</source>
        <translation>Toile de la voile ; une toile idéale ne s’étire jamais et pèse ce qui est dit plus haut, une vraie est portée par des panneaux et fait des plis.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth of the sail; ideal cloth never stretches and weighs what is said below, a real one is carried by panels and wrinkles.</source>
        <translation>Toile de la voile ; une toile idéale ne s’étire jamais et pèse ce qui est dit plus bas, une vraie est portée par des panneaux et fait des plis.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth over a cylinder</source>
        <translation>Tissu sur un cylindre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth that doubles real cloth where it is pulled at a point: at nose, tips and corners, and where lines are tied.</source>
        <translation>Toile qui double une vraie toile là où elle est tirée en un point : au nez, aux bouts et aux coins, et là où des lignes sont attachées.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cloth under pressure</source>
        <translation>Toile sous pression</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coefficient of friction of what slides on it.</source>
        <translation>Coefficient de frottement de ce qui glisse dessus.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coefficient of the air's force along the fabric.</source>
        <translation>Coefficient de la force de l’air le long du tissu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coefficient of the force across the panel; 4 is the paper's, 2 a flat plate's, 1.17 a disc's head on; of the linear law it is the slope at small angles.</source>
        <translation>Coefficient de la force perpendiculaire au panneau ; 4 est celui de l’article, 2 celui d’une plaque plane, 1,17 celui d’un disque de face ; pour la loi linéaire c’est la pente aux petits angles.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coefficient of the force along the panel, both sides together; about 0.02 for cloth.</source>
        <translation>Coefficient de la force le long du panneau, les deux côtés ensemble ; environ 0,02 pour une toile.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coefficient of the linear law head on, 1.17 for a square plate; empty takes the normal force's.</source>
        <translation>Coefficient de la loi linéaire de face, 1,17 pour une plaque carrée ; vide, celui de la force normale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Colour in the view, as #rrggbb.</source>
        <translation>Couleur dans la vue, sous la forme #rrvvbb.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Compliance</source>
        <translation>Souplesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Compression</source>
        <translation>Compression</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Conservation and invariance</source>
        <translation>Conservation et invariance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Contender Nylite 90, spinnaker nylon</source>
        <translation>Contender Nylite 90, nylon de spinnaker</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Copies what is selected again and again, each copy a step further.</source>
        <translation>Copie la sélection encore et encore, chaque copie un pas plus loin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Copies what is selected around an axis: gores of a canopy, spokes.</source>
        <translation>Copie la sélection autour d’un axe : fuseaux d’une voilure, rayons.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cord</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Corner a</source>
        <translation>Coin a</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Corner b</source>
        <translation>Coin b</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Corner c</source>
        <translation>Coin c</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Corners</source>
        <translation>Coins</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coulomb coefficient of fabric on fabric.</source>
        <translation>Coefficient de Coulomb du tissu sur le tissu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Coulomb coefficient; only the response contact uses it.</source>
        <translation>Coefficient de Coulomb ; seule la réponse contact l’utilise.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Counts</source>
        <translation>Décomptes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cousin Technoline 1110</source>
        <translation>Cousin Technoline 1110</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cousin Vectraline 12470</source>
        <translation>Cousin Vectraline 12470</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cousin Vectraline 16330</source>
        <translation>Cousin Vectraline 16330</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cross</source>
        <translation>Croisement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cross parachute</source>
        <translation>Parachute cruciforme</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cross tube, control frame, wires and fittings, shared by the nodes of the frame; where the cloth is real, whose weight and that of the tubes come to it.</source>
        <translation>Transversale, trapèze, câbles et accastillage, répartis sur les nœuds de la structure ; pour une vraie toile, dont le poids et celui des tubes s’y ajoutent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Crossed</source>
        <translation>Croisés</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cruciform or square parachute</source>
        <translation>Parachute cruciforme ou carré</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cruciform parachute</source>
        <translation>Parachute cruciforme</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Curtain</source>
        <translation>Rideau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Curves over time for a paper, a panel for each unit; sharp at any size.</source>
        <translation>Courbes dans le temps pour un article, un cadre par unité ; nettes à toute taille.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>D 1 mm</source>
        <translation>D 1 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>D 100 daN</source>
        <translation>D 100 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>D 150 daN</source>
        <translation>D 150 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>D 2 mm</source>
        <translation>D 2 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>D 50 daN</source>
        <translation>D 50 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>DSL110</source>
        <translation>DSL110</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>DSL350</source>
        <translation>DSL350</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>DSL600</source>
        <translation>DSL600</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>DSL70</source>
        <translation>DSL70</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dacron 162</source>
        <translation>Dacron 162</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dacron 210</source>
        <translation>Dacron 210</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dacron glider</source>
        <translation>Deltaplane en Dacron</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dacron of surf-kite leading edges</source>
        <translation>Dacron de bords d’attaque de kitesurf</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dacron sailcloth, medium firm</source>
        <translation>Toile à voile Dacron, apprêt moyen</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Damping and step limits</source>
        <translation>Amortissement et limites de pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Damping time</source>
        <translation>Temps d’amortissement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Defaults of a new scene</source>
        <translation>Réglages d’une scène nouvelle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Delta kite</source>
        <translation>Cerf-volant delta</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Delta kite (ideal, the paper's)</source>
        <translation>Cerf-volant delta (idéal, celui de l’article)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Density</source>
        <translation>Masse surfacique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Depth of the bow across over the width; it keeps the kite upright.</source>
        <translation>Flèche de l’arc en largeur, rapportée à la largeur ; il garde le cerf-volant droit.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Diameter of the hole in the crown, laid out flat, with lines across it; 5 to 10 % of the nominal diameter are usual and half of it is the most, 0 has none.</source>
        <translation>Diamètre de l’ouverture au sommet, étalée à plat, traversée de suspentes ; 5 à 10 % du diamètre nominal sont usuels et la moitié est le maximum, 0 n’en fait pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Diamond kite</source>
        <translation>Cerf-volant losange</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dihedral</source>
        <translation>Dièdre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direct</source>
        <translation>Direct</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direction of a positive value.</source>
        <translation>Direction d’une valeur positive.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direction of the line that the particle is free along, or the direction across the plane that it is free in.</source>
        <translation>Direction de la ligne le long de laquelle la particule est libre, ou perpendiculaire au plan où elle l’est.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direction of the line, or across the plane: an axis of the world, or the line or plane that fits what is selected best, as through two or three particles.</source>
        <translation>Direction de la ligne, ou perpendiculaire au plan : un axe du monde, ou la ligne ou le plan qui convient le mieux à la sélection, comme par deux ou trois particules.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direction that is turned round: x swaps left and right, y up and down, z front and back.</source>
        <translation>Direction qui est retournée : x échange gauche et droite, y haut et bas, z devant et derrière.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Direction that the plane faces; only planes use it.</source>
        <translation>Direction à laquelle le plan fait face ; seuls les plans l’utilisent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Discrete gust</source>
        <translation>Rafale isolée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance from one generated hill to the next, over the width of the field.</source>
        <translation>Distance d’une colline engendrée à la suivante, rapportée à la largeur du champ.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance of the first row from the last.</source>
        <translation>Distance de la première rangée à la dernière.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance of the outermost points of a row.</source>
        <translation>Distance des points extrêmes d’une rangée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance that fabric keeps from the surface, half the thickness of the fabric or more; it rounds edges.</source>
        <translation>Distance que le tissu garde de la surface, la moitié de l’épaisseur du tissu ou plus ; elle arrondit les arêtes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance that particles of this part keep from its own panels and from those of other parts with self-contact; 0 lets fabric pass through fabric.</source>
        <translation>Distance que les particules de cette pièce gardent de ses propres panneaux et de ceux d’autres pièces qui ont un contact avec soi ; 0 laisse le tissu traverser le tissu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Distance that the sheet keeps from itself and from sphere and boxes; 0 lets it pass through itself.</source>
        <translation>Distance que la toile garde d’elle-même et de la sphère et des boîtes ; 0 la laisse se traverser.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dominico 30D</source>
        <translation>Dominico 30D</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dominico N20D</source>
        <translation>Dominico N20D</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag</source>
        <translation>Traînée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag area</source>
        <translation>Aire de traînée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag coefficient CD0 on the area of the cloth; 0.60 to 0.85 for cross parachutes.</source>
        <translation>Coefficient de traînée CD0 sur l’aire de la toile ; 0,60 à 0,85 pour les parachutes cruciformes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag coefficient CD0 on the nominal area; 0.75 to 0.80 for flat circular canopies.</source>
        <translation>Coefficient de traînée CD0 sur l’aire nominale ; 0,75 à 0,80 pour les voilures circulaires plates.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag coefficient of links across the wind; 1 to 1.1 for lines.</source>
        <translation>Coefficient de traînée des liaisons en travers du vent ; 1 à 1,1 pour des lignes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag coefficient of sail and spars edge on, as skin friction of the sail.</source>
        <translation>Coefficient de traînée de la voile et des longerons de chant, comme frottement pariétal de la voile.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag coefficient of sail, wires, frame and pilot together, spread over the sail as skin friction.</source>
        <translation>Coefficient de traînée de la voile, des câbles, de l’armature et du pilote ensemble, répartie sur la voile comme frottement pariétal.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drag over the dynamic pressure of the relative wind.</source>
        <translation>Traînée sur la pression dynamique du vent relatif.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Drawn in the view.</source>
        <translation>Dessiné dans la vue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Droop</source>
        <translation>Tombée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dyneema braid 1 mm</source>
        <translation>Tresse Dyneema 1 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dyneema braid 2 mm</source>
        <translation>Tresse Dyneema 2 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dyneema kite line 100 daN</source>
        <translation>Ligne de cerf-volant Dyneema 100 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dyneema kite line 150 daN</source>
        <translation>Ligne de cerf-volant Dyneema 150 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Dyneema kite line 50 daN</source>
        <translation>Ligne de cerf-volant Dyneema 50 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>E t of a fabric across its warp, where panels carry its pull; empty takes the membrane stiffness.</source>
        <translation>E t d’un tissu en travers de sa chaîne, là où les panneaux portent sa traction ; vide prend la raideur de membrane.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>E t of a fabric along its threads, its tension per width and strain: links with the role thread get theirs from it and from their width, and so do elastic panels along their warp; empty leaves it to stiffness and compliance.</source>
        <translation>E t d’un tissu le long de ses fils, sa tension par largeur et déformation : les liaisons au rôle de fil tirent la leur de lui et de leur largeur, et les panneaux élastiques aussi le long de leur chaîne ; vide laisse faire la raideur et la souplesse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>EA of a line or spar, its tension per strain: a link of this length L gets EA / L, whatever the stiffness and compliance above say; empty leaves it to them.</source>
        <translation>EA d’une ligne ou d’un longeron, sa tension par déformation : une liaison de cette longueur L reçoit EA / L, quoi que disent la raideur et la souplesse ci-dessus ; vide, ce sont elles qui comptent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>EI of a spar, its bending moment per curvature: links of this material that go on into each other resist turning there, and stay as bent as they are built; 0 lets them hinge freely.</source>
        <translation>EI d’un longeron, son moment de flexion par courbure : les liaisons de ce matériau qui se prolongent résistent à tourner l’une sur l’autre, et restent courbées comme construites ; 0 en fait des charnières libres.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Each particle (kg)</source>
        <translation>Chaque particule (kg)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Each with each</source>
        <translation>Chacune à chacune</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Eddy's kite: a spine and a bowed cross spar, a bridle and a tail.</source>
        <translation>Le cerf-volant d’Eddy : une épine et une traverse arquée, une bride et une queue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Edges of a box, or width, height and depth of a height field; the second number is the height of a cylinder, whose axis is its own y.</source>
        <translation>Arêtes d’une boîte, ou largeur, hauteur et profondeur d’un champ de hauteurs ; le deuxième nombre est la hauteur d’un cylindre, dont l’axe est son propre y.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Elastic energy</source>
        <translation>Énergie élastique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Elastic panels</source>
        <translation>Panneaux élastiques</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Elastic sheet</source>
        <translation>Feuille élastique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Elastica</source>
        <translation>Élastique plane</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Elevation</source>
        <translation>Élévation</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>End mass</source>
        <translation>Masse au bout</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ends</source>
        <translation>Bouts</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Energy balance</source>
        <translation>Bilan d’énergie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Energy change</source>
        <translation>Variation d’énergie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Energy change that no work explains: what the solver has made (above 0) or lost.</source>
        <translation>Variation d’énergie qu’aucun travail n’explique : ce que le solveur a créé (au-dessus de 0) ou perdu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Energy residual</source>
        <translation>Résidu d’énergie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Equal masses</source>
        <translation>Masses égales</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Every 6 s a gust of 3 s blows on top of a wind of 6 m/s: of 3, 6, 9, 12 and 15 m/s and so on, after 5 s. A delta of 0.75 oz rides them on a line that bears 130 N, 117 at its knots: the fifth parts it. Tune the line strength of the line, 100 to 200 N, or velocity, duration and growth of the gust.</source>
        <translation>Toutes les 6 s, une rafale de 3 s s’ajoute à un vent de 6 m/s : de 3, 6, 9, 12 et 15 m/s et ainsi de suite, après 5 s. Un delta de 0,75 oz les affronte sur une ligne qui tient 130 N, 117 à ses nœuds : la cinquième la rompt. Réglez la résistance de la ligne, de 100 à 200 N, ou la vitesse, la durée et la croissance de la rafale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Every row</source>
        <translation>Chaque rangée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Explicit Euler</source>
        <translation>Euler explicite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Exponent</source>
        <translation>Exposant</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Exponent of the power law; 1/7 over open land, 0.1 over water.</source>
        <translation>Exposant de la loi de puissance ; 1/7 en terrain dégagé, 0,1 sur l’eau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>F-111 class parachute nylon, new</source>
        <translation>Nylon de parachute type F-111, neuf</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fabric at tears</source>
        <translation>Tissu aux déchirures</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fabric pulls by</source>
        <translation>Traction portée par</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass rod 3 mm</source>
        <translation>Jonc en fibre de verre 3 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass rod 5 mm</source>
        <translation>Jonc en fibre de verre 5 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass tube 10 mm</source>
        <translation>Tube de fibre de verre 10 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass tube 6 mm</source>
        <translation>Tube de fibre de verre 6 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass tube 8 mm</source>
        <translation>Tube de fibre de verre 8 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fibreglass tube 9 mm</source>
        <translation>Tube de fibre de verre 9 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Figure of the probes, SVG</source>
        <translation>Figure des sondes, SVG</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fill efficiency</source>
        <translation>Rendement de gonflage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fill with panels</source>
        <translation>Remplir de panneaux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fills the fabric with air through its mouth, up to this pressure over the dynamic pressure of the wind that meets the mouth; 1.68 for round parachutes, 0 leaves each panel to meet the wind by itself.</source>
        <translation>Remplit le tissu d’air par sa bouche, jusqu’à cette pression rapportée à la pression dynamique du vent qui rencontre la bouche ; 1,68 pour les parachutes ronds, 0 laisse chaque panneau rencontrer le vent seul.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>First corner.</source>
        <translation>Premier coin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fittings</source>
        <translation>Accastillage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flag</source>
        <translation>Drapeau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flag on a pole</source>
        <translation>Drapeau sur un mât</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flat</source>
        <translation>À plat</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flexural rigidity</source>
        <translation>Rigidité de flexion EI</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flexural rigidity EI of a spar, its bending moment per curvature; a kite spar has 1 to 10, a rope nothing.</source>
        <translation>Rigidité de flexion EI d’un longeron, son moment de flexion par courbure ; un longeron de cerf-volant a 1 à 10, un cordage rien.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flexural rigidity EI of the pole; 0 does not bend, a fibre glass rod of 12 mm has 40.</source>
        <translation>Rigidité de flexion EI du mât ; 0 ne plie pas, un jonc de fibre de verre de 12 mm a 40.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flexural rigidity EI, bending moment per curvature; a kite spar has 1 to 10.</source>
        <translation>Rigidité de flexion EI, moment de flexion par courbure ; un longeron de cerf-volant a 1 à 10.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Flight</source>
        <translation>Vol</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force of a spring per metre of stretch.</source>
        <translation>Force d’un ressort par mètre d’allongement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force of a spring per metre of stretch; empty takes the material's.</source>
        <translation>Force d’un ressort par mètre d’allongement ; vide, celle du matériau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force of a spring per metre per second of stretching.</source>
        <translation>Force d’un ressort par mètre par seconde d’allongement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force of a spring per metre per second of stretching; empty takes the material's.</source>
        <translation>Force d’un ressort par mètre par seconde d’allongement ; vide, celle du matériau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Force that makes a tear in the fabric go on, as the tongue test has it; tears in elastic panels go on by it where the material tears by energy, and else it is noted.</source>
        <translation>Force qui fait avancer une déchirure du tissu, selon l’essai de languette ; les déchirures des panneaux élastiques avancent par elle si le matériau cède par énergie, sinon elle est notée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Formula</source>
        <translation>Formule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Four particles in a row stay straight because two rigidity particles are tied to each of them. Remove one of the two and watch it fold.</source>
        <translation>Quatre particules en file restent droites parce que deux particules de rigidité sont attachées à chacune. En supprimer une des deux, et la regarder plier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Four particles in a row, kept straight by two more.</source>
        <translation>Quatre particules en file, tenues droites par deux autres.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Frame</source>
        <translation>Armature</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Frame mass</source>
        <translation>Masse de l’armature</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Frame of spars</source>
        <translation>Armature de longerons</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Frequency</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From a particle.</source>
        <translation>Depuis une particule.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From cap to cap.</source>
        <translation>D’un bout à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From corner to corner across.</source>
        <translation>D’un coin à l’autre en largeur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From end to end.</source>
        <translation>D’un bout à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From hill to hill, over the width of the field.</source>
        <translation>De colline en colline, rapportée à la largeur du champ.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From side to side.</source>
        <translation>D’un côté à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the beginning of a gust to that of the next; 0 has one gust only.</source>
        <translation>Du début d’une rafale à celui de la suivante ; 0 n’en a qu’une seule.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the canopy to the payload; made longer where it would not reach.</source>
        <translation>De la voilure à la charge ; allongée là où elle n’atteindrait pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the first to the last; a full turn puts none on the first.</source>
        <translation>Du premier au dernier ; un tour complet n’en met aucun sur le premier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the leading to the trailing edge.</source>
        <translation>Du bord d’attaque au bord de fuite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the lowest valley to the highest top.</source>
        <translation>De la vallée la plus basse au sommet le plus haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the middle of the particles.</source>
        <translation>Depuis le milieu des particules.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the pole to the free edge.</source>
        <translation>Du mât au bord libre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the riser to the wing, where no table says so.</source>
        <translation>De l’élévateur à l’aile, là où aucun tableau ne le dit.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the skirt to the payload; 0.8 to 1 nominal diameter is usual.</source>
        <translation>Du bord de la voilure à la charge ; 0,8 à 1 diamètre nominal est habituel.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the top edge to the bottom edge.</source>
        <translation>Du bord haut au bord bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the tow point to the hand.</source>
        <translation>Du point d’attache à la main.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From the upper to the lower edge.</source>
        <translation>Du bord haut au bord bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From tip to tip.</source>
        <translation>D’un bout d’aile à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>From tip to tip; about twice the chord gives the usual nose angle of 90 degrees.</source>
        <translation>D’un bout d’aile à l’autre ; environ deux fois la corde donne l’angle de nez habituel de 90 degrés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Front legs</source>
        <translation>Brins avant</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Fullness</source>
        <translation>Ampleur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>G t of a fabric, its shear force per width and angle: links with the role bias and elastic panels get theirs from it; empty leaves links to stiffness and compliance, and gives panels that of a sheet without threads.</source>
        <translation>G t d’un tissu, sa force de cisaillement par largeur et angle : les liaisons au rôle de biais et les panneaux élastiques tirent la leur de lui ; vide laisse les liaisons à la raideur et à la souplesse, et donne aux panneaux celle d’une feuille sans fils.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 10</source>
        <translation>GRP 10</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 3</source>
        <translation>GRP 3</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 5</source>
        <translation>GRP 5</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 6</source>
        <translation>GRP 6</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 8</source>
        <translation>GRP 8</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>GRP 9</source>
        <translation>GRP 9</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gap</source>
        <translation>Écart</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gauss Seidel</source>
        <translation>Gauss-Seidel</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gives every number that the link does not set itself.</source>
        <translation>Donne tout nombre que la liaison ne fixe pas elle-même.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gives mass to the selected particles.</source>
        <translation>Donne une masse aux particules sélectionnées.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gives the colour and the law of its air load.</source>
        <translation>Donne la couleur et la loi de la charge d’air.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Glide ratio</source>
        <translation>Finesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Glider over hills</source>
        <translation>Deltaplane sur des collines</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Glider with induced flow</source>
        <translation>Deltaplane à écoulement induit</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gores, and suspension lines.</source>
        <translation>Fuseaux, et suspentes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Grey interlock knit</source>
        <translation>Maille interlock grise</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Grey picture of a height field (PNG, PGM) or mesh (OBJ, STL, PLY and others), beside the scene file; a height field without one gets generated hills.</source>
        <translation>Image grise d’un champ de hauteurs (PNG, PGM) ou maillage (OBJ, STL, PLY et autres), à côté du fichier de scène ; un champ de hauteurs sans fichier reçoit des collines engendrées.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Guide axis</source>
        <translation>Axe du guide</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Guides</source>
        <translation>Guides</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gustiness</source>
        <translation>Force des rafales</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Half the angle by which a jet widens; 12 is that of a free jet.</source>
        <translation>La moitié de l’angle dont un jet s’élargit ; 12 est celui d’un jet libre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hand height</source>
        <translation>Hauteur de la main</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hang</source>
        <translation>Suspension</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hang glider</source>
        <translation>Deltaplane</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hang glider (ideal, the paper's)</source>
        <translation>Deltaplane (idéal, celui de l’article)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hang gliders</source>
        <translation>Deltaplanes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hanging rods</source>
        <translation>Tiges suspendues</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Has the panels of the selected parts carry the pull of their fabric, with warp, weft, shear and wrinkles, in place of threads. Lines, spars and hems stay, and the panels keep the cut that the threads had.</source>
        <translation>Fait porter la traction du tissu par les panneaux des pièces sélectionnées, avec chaîne, trame, cisaillement et plis, à la place des fils. Les lignes, les longerons et les ourlets restent, et les panneaux gardent la coupe qu’avaient les fils.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Head-on drag</source>
        <translation>Traînée de face</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Heavy load</source>
        <translation>Lourde charge</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height at which the logarithmic profile starts; 0.0002 on the sea, 0.03 over grass, 0.1 over farmland, 0.5 to 1 over suburbs.</source>
        <translation>Hauteur à laquelle commence le profil logarithmique ; 0,0002 en mer, 0,03 sur l’herbe, 0,1 sur des cultures, 0,5 à 1 en banlieue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height field</source>
        <translation>Champ de hauteurs</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the hand over the ground.</source>
        <translation>Hauteur de la main au-dessus du sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the nose at the start; the density of the air does not follow it, settings.airDensity sets it: 0.909 kg/m^3 at 3000 m in the standard atmosphere.</source>
        <translation>Hauteur du nez au départ ; la masse volumique de l’air ne la suit pas, settings.airDensity la fixe : 0,909 kg/m^3 à 3000 m dans l’atmosphère normalisée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the payload at the start; the density of the air does not follow it, settings.airDensity sets it: 0.736 kg/m^3 at 5000 m in the standard atmosphere.</source>
        <translation>Hauteur de la charge au départ ; la masse volumique de l’air ne la suit pas, settings.airDensity la fixe : 0,736 kg/m^3 à 5000 m dans l’atmosphère normalisée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the pole; at least that of the flag and a little.</source>
        <translation>Hauteur du mât ; au moins celle du drapeau et un peu plus.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the top edge over the ground.</source>
        <translation>Hauteur du bord haut au-dessus du sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height of the wing over the ground.</source>
        <translation>Hauteur de l’aile au-dessus du sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Height over y = 0 at which a profile has its velocity, or for which gusts are made.</source>
        <translation>Hauteur au-dessus de y = 0 à laquelle un profil a sa vitesse, ou pour laquelle les rafales sont faites.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Held</source>
        <translation>Tenue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Held in place, whatever pulls on it.</source>
        <translation>Tenue en place, quoi qui tire dessus.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hem</source>
        <translation>Ourlet</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>High strain</source>
        <translation>Déformation haute</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Highest value</source>
        <translation>Valeur la plus haute</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hill length</source>
        <translation>Longueur des collines</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hills</source>
        <translation>Collines</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Holds the selected particles: a ring on a rail is free along a line, a foot on a floor in a plane. The guide takes up all force across it and gives no friction.</source>
        <translation>Tient les particules sélectionnées : un anneau sur un rail est libre le long d’une ligne, un pied sur un sol dans un plan. Le guide reprend toute force en travers et ne frotte pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hoop</source>
        <translation>Cerceau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Hoop mass</source>
        <translation>Masse du cerceau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How deep the fabric is arched between the nose and the tail, over their distance.</source>
        <translation>Le creux du tissu entre le nez et la queue, rapporté à leur distance.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How each particle is held: free along a line or in a plane through its place, without friction; in its place; or not at all.</source>
        <translation>Comment chaque particule est tenue : libre le long d’une ligne ou dans un plan par sa place, sans frottement ; en place ; ou pas du tout.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far a link is stretched now, or what stretches most of an elastic panel.</source>
        <translation>De combien une liaison est étirée à présent, ou ce qui s’étire le plus d’un panneau élastique.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the arms hang below level when the canopy is full.</source>
        <translation>De combien les bras pendent sous l’horizontale quand la voilure est gonflée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the nose is above the tail.</source>
        <translation>De combien le nez est au-dessus de la queue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the picture is moved to the right, of its own width.</source>
        <translation>De combien l’image est déplacée vers la droite, en part de sa largeur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the picture is moved up, of its own height.</source>
        <translation>De combien l’image est déplacée vers le haut, en part de sa hauteur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the pilot can shift either way.</source>
        <translation>De combien le pilote peut se déporter de part et d’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the pilot hangs below the keel.</source>
        <translation>De combien le pilote pend sous la quille.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the right side is below the left one.</source>
        <translation>De combien le côté droit est sous le gauche.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the rigidity particles stand off the rod; near ones stiffen less.</source>
        <translation>De combien les particules de rigidité s’écartent de la tige ; proches, elles raidissent moins.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the tow point hangs below the sail, over the height of the kite; a long one lets the kite climb, and lean over and sweep to and fro.</source>
        <translation>De combien le point d’attache pend sous la voile, rapporté à la hauteur du cerf-volant ; une bride longue le laisse monter, et se pencher et balayer de côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the tow point hangs below the wing; a third to a half of the half span is usual.</source>
        <translation>De combien le point d’attache pend sous l’aile ; d’un tiers à la moitié de la demi-envergure est habituel.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How far the trailing edge may sink below where it is cut before they hold it.</source>
        <translation>De combien le bord de fuite peut descendre au-dessous de sa coupe avant qu’ils ne le retiennent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How fast a particle moves now.</source>
        <translation>À quelle vitesse une particule se déplace maintenant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How fast the centre of mass falls.</source>
        <translation>À quelle vitesse tombe le centre de masse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How fast the particle starts.</source>
        <translation>À quelle vitesse la particule démarre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How fast the value follows its command in simulated time.</source>
        <translation>À quelle vitesse la valeur suit sa consigne en temps simulé.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How fast the value moves by itself until it reaches the limit; 0 waits for keys.</source>
        <translation>À quelle vitesse la valeur avance seule jusqu’à atteindre la limite ; 0 attend les touches.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How hard a link pulls now; below 0 it pushes.</source>
        <translation>Avec quelle force une liaison tire maintenant ; au-dessous de 0 elle pousse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How hard the air pushes a panel now, per area.</source>
        <translation>Avec quelle force l’air pousse un panneau maintenant, par unité d’aire.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How high the centre of mass is.</source>
        <translation>À quelle hauteur est le centre de masse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How large a panel is now.</source>
        <translation>Quelle aire un panneau a maintenant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How long a gust lasts: it grows for half of that, and falls again.</source>
        <translation>Durée d’une rafale : elle croît pendant la moitié, puis retombe.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How long a link is now.</source>
        <translation>Quelle longueur une liaison a maintenant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many ends are pinned.</source>
        <translation>Combien de bouts sont fixés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many have torn, and elastic panels among them.</source>
        <translation>Combien ont cédé, panneaux élastiques compris.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many there are in the end, with the one that is there.</source>
        <translation>Combien il y en a à la fin, avec celui qui est là.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many times as long as wide the cells of the fabric beside a thread are, whose diagonals resist stretching along it by the square of that: the thread takes so much off its own stiffness.</source>
        <translation>Combien de fois plus longues que larges sont les mailles du tissu au bord d’un fil, dont les diagonales résistent à l’étirement par le carré de ce rapport : le fil le retranche de sa propre raideur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many times as stiff the link is as its material makes it: above 1 where it is reinforced, below where it is worn; a stiffness of its own is taken as it is, and bending is not touched.</source>
        <translation>Combien de fois la liaison est plus raide que ne le fait son matériau : plus de 1 là où elle est renforcée, moins là où elle est usée ; une raideur propre est prise telle quelle, et la flexion n’est pas touchée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many times as stiff the panel is in its plane as its material makes it, where panels carry the pull of the fabric: above 1 where cloth lies double, below where it is worn.</source>
        <translation>Combien de fois le panneau est plus raide dans son plan que ne le fait son matériau, là où les panneaux portent la traction du tissu : plus de 1 là où le tissu est doublé, moins là où il est usé.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many times as strong the link is as its material makes it, for tears, snapping spars and margins: below 1 where it is worn or sewn; a tear limit of its own is taken as it is.</source>
        <translation>Combien de fois la liaison est plus résistante que ne le fait son matériau, pour les déchirures, les espars qui cassent et les marges : moins de 1 là où elle est usée ou cousue ; une limite de déchirure propre est prise telle quelle.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How many times as strong the panel is as its material makes it, for tears and margins, where panels carry the pull of the fabric: below 1 where it is worn or sewn.</source>
        <translation>Combien de fois le panneau est plus résistant que ne le fait son matériau, pour les déchirures et les marges, là où les panneaux portent la traction du tissu : moins de 1 là où il est usé ou cousu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How much less the tips meet the wind than the root; gives pitch stability to a swept wing.</source>
        <translation>De combien les bouts rencontrent moins le vent que l’emplanture ; donne sa stabilité en tangage à une aile en flèche.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How much less the tips meet the wind than the root; the pull of the line balances the nose-up turn that it gives.</source>
        <translation>De combien les bouts rencontrent moins le vent que l’emplanture ; la traction de la ligne équilibre le couple cabreur qui en vient.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How much longer the rope is than the way between its ends; less than 0 is under tension.</source>
        <translation>De combien le cordage est plus long que le chemin entre ses bouts ; moins de 0 est sous tension.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How much of the run is in sight, up to now; 0 shows all of it.</source>
        <translation>Durée visible de la simulation, jusqu'à maintenant ; 0 la montre en entier.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>How wind pushes a panel: the paper's law grows with the square of the head-on wind, the linear law fits plates at small angles too, lift and drag are read from a table, and the vortex law finds the circulation around a whole wing.</source>
        <translation>Comment le vent pousse un panneau : la loi de l’article croît avec le carré du vent de face, la loi linéaire convient aux plaques aux petits angles aussi, portance et traînée sont lues dans un tableau, et la loi tourbillonnaire trouve la circulation autour de toute une aile.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Icarex</source>
        <translation>Icarex</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Icarex P31, polyester</source>
        <translation>Icarex P31, polyester</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ideal</source>
        <translation>Idéal</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Implicit Euler</source>
        <translation>Euler implicite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In a line</source>
        <translation>En ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In a plane</source>
        <translation>Dans un plan</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In a ring</source>
        <translation>En anneau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In place</source>
        <translation>En place</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In sight</source>
        <translation>Durée visible</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In springs, rods that give and bends.</source>
        <translation>Dans les ressorts, les tiges souples et les flexions.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>In their middle</source>
        <translation>En leur milieu</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Inertia and weight.</source>
        <translation>Inertie et poids.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Integrator</source>
        <translation>Intégrateur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Integrators</source>
        <translation>Intégrateurs</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Interval</source>
        <translation>Intervalle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Jet</source>
        <translation>Jet</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Jet set</source>
        <translation>Jet set</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Joint efficiency</source>
        <translation>Tenue des coutures et nœuds</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Keel</source>
        <translation>Quille</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Keel depth</source>
        <translation>Profondeur de quille</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Keel length</source>
        <translation>Longueur de quille</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kevlar 3</source>
        <translation>Kevlar 3</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kevlar 6</source>
        <translation>Kevlar 6</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kevlar cord 1/4 in</source>
        <translation>Cordelette Kevlar 1/4 in</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kevlar cord 1/8 in</source>
        <translation>Cordelette Kevlar 1/8 in</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Key less</source>
        <translation>Touche moins</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Key more</source>
        <translation>Touche plus</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Key that lowers the value by one step, for example Left.</source>
        <translation>Touche qui baisse la valeur d’un pas, par exemple Left.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Key that raises the value by one step, for example Right.</source>
        <translation>Touche qui monte la valeur d’un pas, par exemple Right.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kinetic energy</source>
        <translation>Énergie cinétique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kinetic, potential and elastic.</source>
        <translation>Cinétique, potentielle et élastique.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kite cloth of E t = 40 kN/m, G t = 1.2 kN/m: its panels carry the pull, with warp, weft and shear, and wrinkle instead of pushing.</source>
        <translation>Toile de cerf-volant de E t = 40 kN/m, G t = 1,2 kN/m : ses panneaux portent la traction, avec chaîne, trame et cisaillement, et plissent au lieu de pousser.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kite in gusts</source>
        <translation>Cerf-volant dans les rafales</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Kites</source>
        <translation>Cerfs-volants</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC120</source>
        <translation>LTC120</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC160</source>
        <translation>LTC160</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC200</source>
        <translation>LTC200</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC25</source>
        <translation>LTC25</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC350</source>
        <translation>LTC350</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC400</source>
        <translation>LTC400</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC45</source>
        <translation>LTC45</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC65</source>
        <translation>LTC65</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>LTC80</source>
        <translation>LTC80</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Laplacian</source>
        <translation>Laplacienne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Largest error of the pulls in links and elastic panels that a step may leave, against what their stiffness says; the automatic solver takes what that needs, and every run says where it was missed.</source>
        <translation>Plus grande erreur des tractions dans les liaisons et les panneaux élastiques qu’un pas peut laisser, par rapport à ce que dit leur raideur ; le solveur automatique prend ce qu’il faut, et chaque simulation dit où elle a été manquée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Largest principal tension of elastic panels, the mean by their area at rest.</source>
        <translation>Plus grande tension principale des panneaux élastiques, moyenne selon leur aire au repos.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Largest strain that the automatic solver allows in rods without compliance, where it stands for the accuracy; smaller is stiffer and slower.</source>
        <translation>Plus grande déformation que le solveur automatique admet dans les tiges sans souplesse, où elle tient lieu de précision ; plus petite, c’est plus raide et plus lent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Largest value either way.</source>
        <translation>Plus grande valeur de part et d’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lattice segments per side of the keel, at most half of those of the wing.</source>
        <translation>Segments du treillis par côté de la quille, au plus la moitié de ceux de l’aile.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lattice segments per side of the sail, which has their square of panels; one of real cloth has some more, in strips from the nose.</source>
        <translation>Segments du treillis par côté de la voile, qui a leur carré de panneaux ; une voile de toile réelle en a un peu plus, en laizes qui partent du nez.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lattice segments per side of the wing, which has their square of panels; a sail of real cloth has about as many, in strips from the nose.</source>
        <translation>Segments du treillis par côté de l’aile, qui a leur carré de panneaux ; une voile de toile réelle en a à peu près autant, en laizes qui partent du nez.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Launch</source>
        <translation>Départ</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Laws of the air</source>
        <translation>Lois de l’air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Least side</source>
        <translation>Côté minimal</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Left edge</source>
        <translation>Bord gauche</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length from the nose to the trailing edge.</source>
        <translation>Longueur du nez au bord de fuite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of an arm over the width; 0 is a square canopy without arms.</source>
        <translation>Longueur d’un bras, rapportée à la largeur ; 0 est une voilure carrée sans bras.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of line that it is meant to have, by the rest lengths of its links with the role line; empty sets no target.</source>
        <translation>Longueur de ligne visée, d’après les longueurs au repos de ses liaisons de rôle ligne ; vide ne vise rien.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the cross spar; Eddy's is as wide as it is high.</source>
        <translation>Longueur de la traverse ; celui d’Eddy est aussi large que haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the keel from the nose to the trailing edge.</source>
        <translation>Longueur de la quille du nez au bord de fuite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the side from a to b without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.</source>
        <translation>Longueur du côté de a à b sans charge, là où les panneaux portent la traction du tissu ; 0 prend la distance de ses coins dans la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the side from b to c without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.</source>
        <translation>Longueur du côté de b à c sans charge, là où les panneaux portent la traction du tissu ; 0 prend la distance de ses coins dans la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the side from c to a without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.</source>
        <translation>Longueur du côté de c à a sans charge, là où les panneaux portent la traction du tissu ; 0 prend la distance de ses coins dans la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length of the spine.</source>
        <translation>Longueur de l’épine.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Length without load.</source>
        <translation>Longueur sans charge.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Levels</source>
        <translation>Étages</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Levels of lines from the riser to the wing, each with twice the lines of the one below; the table takes their place.</source>
        <translation>Étages de brins de l’élévateur à l’aile, chacun avec deux fois les brins de celui du dessous ; le tableau prend leur place.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift</source>
        <translation>Portance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift and drag</source>
        <translation>Portance et traînée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift drag</source>
        <translation>Portance et traînée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift from the shape</source>
        <translation>Portance selon la forme</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift over drag.</source>
        <translation>Portance sur traînée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift slope</source>
        <translation>Pente de portance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lift to drag</source>
        <translation>Portance sur traînée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line (pulls only)</source>
        <translation>Ligne (traction seule)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line density</source>
        <translation>Masse linéique de ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line diameter</source>
        <translation>Diamètre de ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line drag</source>
        <translation>Traînée de ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line length</source>
        <translation>Longueur de ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line segments</source>
        <translation>Segments de suspente</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Line strength</source>
        <translation>Résistance de la ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Linear density</source>
        <translation>Masse linéique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Linear normal</source>
        <translation>Normale linéaire</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lines from the king post to the trailing edge of each half of real cloth: slack in flight, they hold it up in a dive, where it would flap down and take the nose with it.</source>
        <translation>Rappels du mât au bord de fuite de chaque moitié en vraie toile : lâches en vol, ils le retiennent en piqué, où il s’abaisserait et entraînerait le nez.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lines only do not grow longer, rods also not shorter, springs pull with a force.</source>
        <translation>Les lignes ne s’allongent pas, les tiges ne raccourcissent pas non plus, les ressorts tirent avec une force.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Links along the sides of the new panels where there are none yet: fabric has its strength from them.</source>
        <translation>Des liaisons le long des côtés des nouveaux panneaux là où il n’y en a pas : le tissu en tire sa résistance.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Links and panels of this material are drawn.</source>
        <translation>Les liaisons et panneaux de ce matériau sont dessinés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Links from end to end.</source>
        <translation>Liaisons d’un bout à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Links that each one becomes.</source>
        <translation>Liaisons que devient chacune.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros DSL110</source>
        <translation>Liros DSL110</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros DSL350</source>
        <translation>Liros DSL350</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros DSL600</source>
        <translation>Liros DSL600</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros DSL70</source>
        <translation>Liros DSL70</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC120</source>
        <translation>Liros LTC120</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC160</source>
        <translation>Liros LTC160</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC200</source>
        <translation>Liros LTC200</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC25</source>
        <translation>Liros LTC25</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC350</source>
        <translation>Liros LTC350</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC400</source>
        <translation>Liros LTC400</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC45</source>
        <translation>Liros LTC45</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC65</source>
        <translation>Liros LTC65</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros LTC80</source>
        <translation>Liros LTC80</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros NTSL200</source>
        <translation>Liros NTSL200</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL090</source>
        <translation>Liros TSL090</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL140</source>
        <translation>Liros TSL140</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL190</source>
        <translation>Liros TSL190</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL280</source>
        <translation>Liros TSL280</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL380</source>
        <translation>Liros TSL380</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Liros TSL500</source>
        <translation>Liros TSL500</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Load and lines</source>
        <translation>Charge et suspentes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Load over strength, of the link or panel that is nearest to breaking: 1 breaks. Strength is that of the material times its joint efficiency over the safety factor of the scene.</source>
        <translation>Charge sur résistance, de la liaison ou du panneau le plus proche de rompre : rupture à 1. La résistance est celle du matériau, fois sa tenue des coutures et nœuds, sur le coefficient de sécurité de la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Log law</source>
        <translation>Loi logarithmique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lower end of the axis of values, in the unit of the curves; empty fits what is in sight.</source>
        <translation>Bas de l'axe des valeurs, dans l'unité des courbes ; vide, il s'ajuste à ce qui est visible.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Lowest value</source>
        <translation>Valeur la plus basse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Luff lines</source>
        <translation>Rappels de bord de fuite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Luff slack</source>
        <translation>Mou des rappels</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-44378 type I, low permeability nylon</source>
        <translation>MIL-C-44378 type I, nylon à faible perméabilité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-498 type D nylon</source>
        <translation>MIL-C-498 type D, nylon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-498 type G nylon</source>
        <translation>MIL-C-498 type G, nylon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-7020 type I, 1.1 oz ripstop nylon</source>
        <translation>MIL-C-7020 type I, nylon ripstop 1,1 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-7020 type II, 1.6 oz twill nylon</source>
        <translation>MIL-C-7020 type II, nylon sergé 1,6 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>MIL-C-7020 type III, 1.6 oz ripstop nylon</source>
        <translation>MIL-C-7020 type III, nylon ripstop 1,6 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Makes a stiff spar along the selected particles: rods that resist bending, with their mass. Links that are on its way become its own.</source>
        <translation>Fait un longeron raide le long des particules sélectionnées : des tiges qui résistent à la flexion, avec leur masse. Les liaisons sur son chemin deviennent les siennes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Makes one particle of several, with the mass of all. Links and panels that fall together become one.</source>
        <translation>Fait une particule de plusieurs, avec la masse de toutes. Les liaisons et panneaux qui se superposent n’en font qu’un.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Makes several links of each, with new particles between them. The line stays as long, as stiff and as strong; panels beside it are split too.</source>
        <translation>Fait plusieurs liaisons de chacune, avec de nouvelles particules entre elles. La ligne reste aussi longue, aussi raide et aussi solide ; les panneaux à côté sont divisés aussi.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Margins count every strength as so many times lower, so that with 2 a margin of 1 is half of what breaks; flights and tears do not depend on it.</source>
        <translation>Les marges comptent chaque résistance tant de fois plus faible : avec 2, une marge de 1 est la moitié de ce qui rompt ; ni le vol ni les déchirures n’en dépendent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass in the unit that the line above says. It takes the place of the mass that is there.</source>
        <translation>Masse dans l’unité que dit la ligne ci-dessus. Elle prend la place de la masse présente.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of a line per length.</source>
        <translation>Masse d’une suspente par longueur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of a spar or brace per length; a carbon tube of 6 mm has 0.02.</source>
        <translation>Masse d’un longeron ou d’un contreventement par longueur ; un tube de carbone de 6 mm a 0,02.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of each new particle, where the linear density of the material does not say it.</source>
        <translation>Masse de chaque nouvelle particule, là où la masse linéique du matériau ne la dit pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the air per volume; 1.225 at sea level, 0 is a vacuum.</source>
        <translation>Masse de l’air par volume ; 1,225 au niveau de la mer, 0 est le vide.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the air that moves with a canopy over that in a hemisphere on its mouth; only with canopy pressure.</source>
        <translation>Masse de l’air qui se déplace avec une voilure, rapportée à celle d’un hémisphère sur sa bouche ; seulement avec une pression de voilure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the fabric per area that its particles were given; setting another one weighs them anew, and where it was empty it only notes.</source>
        <translation>Masse du tissu par aire donnée à ses particules ; en fixer une autre les repèse, et là où elle était vide elle ne fait que noter.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the fabric per area; 0.0373 is parachute nylon MIL-C-7020 type I.</source>
        <translation>Masse du tissu par aire ; 0,0373 est le nylon de parachute MIL-C-7020 type I.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the fabric per area; 0.045 is ripstop nylon for kites.</source>
        <translation>Masse du tissu par aire ; 0,045 est le nylon ripstop des cerfs-volants.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the fabric per area; 0.11 is knitted polyester for flags.</source>
        <translation>Masse du tissu par aire ; 0,11 est le polyester tricoté des drapeaux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the fabric per area; 0.25 is a knit, 0.045 a kite fabric.</source>
        <translation>Masse du tissu par aire ; 0,25 est une maille tricotée, 0,045 un tissu de cerf-volant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the hoop.</source>
        <translation>Masse du cerceau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the line or spar per length that its particles were given; setting another one weighs them anew, and where it was empty it only notes.</source>
        <translation>Masse de la ligne ou du longeron par longueur donnée à ses particules ; en fixer une autre les repèse, et là où elle était vide elle ne fait que noter.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the line per length.</source>
        <translation>Masse de la ligne par longueur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the pole per length.</source>
        <translation>Masse du mât par longueur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the rope per length.</source>
        <translation>Masse du cordage par longueur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the tail per length.</source>
        <translation>Masse de la queue par longueur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass of the two particles that hold the canopy open.</source>
        <translation>Masse des deux particules qui tiennent la voilure ouverte.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass per length; 0.005 is a line of 2.5 mm. A material that is there and says its own keeps that.</source>
        <translation>Masse par longueur ; 0,005 est une ligne de 2,5 mm. Un matériau présent qui dit la sienne la garde.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass per length; a carbon tube of 6 mm has 0.02.</source>
        <translation>Masse par longueur ; un tube de carbone de 6 mm a 0,02.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass that hangs below.</source>
        <translation>Masse qui pend dessous.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mass that hangs from the riser.</source>
        <translation>Masse qui pend à l’élévateur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Max strain</source>
        <translation>Déformation max</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Max tension</source>
        <translation>Tension max</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mean glide ratio</source>
        <translation>Finesse moyenne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mean strain</source>
        <translation>Déformation moyenne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mean stress</source>
        <translation>Contrainte moyenne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mean width of the tail and its ribbons, which the wind drags.</source>
        <translation>Largeur moyenne de la queue et de ses rubans, que le vent freine.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Measuring</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Members</source>
        <translation>Membres</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Membrane</source>
        <translation>Membrane</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Membrane stiffness</source>
        <translation>Rigidité de membrane</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Membrane stiffness E t of the fabric along its threads; above 0 it replaces the stiffness, and the sheet stretches alike at every resolution.</source>
        <translation>Rigidité de membrane E t du tissu le long de ses fils ; au-dessus de 0 elle remplace la raideur, et la toile s’étire de même à toute résolution.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh with strains and loads, VTP</source>
        <translation>Maillage avec déformations et charges, VTP</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh, Collada</source>
        <translation>Maillage, Collada</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh, PLY</source>
        <translation>Maillage, PLY</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh, STL</source>
        <translation>Maillage, STL</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mesh, Wavefront OBJ</source>
        <translation>Maillage, Wavefront OBJ</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Metres per unit of the mesh file; only meshes use it.</source>
        <translation>Mètres par unité du fichier de maillage ; seuls les maillages l’utilisent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Middle of the nozzle of a jet.</source>
        <translation>Milieu de la buse d’un jet.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>More of them smooth longer waves.</source>
        <translation>Plus il y en a, plus les ondes lissées sont longues.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Most links and elastic panels that tear in one time step, the most overloaded first, so that a tear runs on from its tip; 0 sets no limit.</source>
        <translation>Nombre maximal de liaisons et de panneaux élastiques qui cèdent en un pas de temps, les plus surchargés d’abord, pour qu’une déchirure se propage par sa pointe ; 0 ne pose pas de limite.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Most side</source>
        <translation>Côté maximal</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mouth</source>
        <translation>Bouche</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Moves its targets, or shifts their weight inside the rods that hold them.</source>
        <translation>Déplace ses cibles, ou déporte leur poids à l’intérieur des tiges qui les tiennent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Moves the plane along its direction.</source>
        <translation>Déplace le plan le long de sa direction.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Mylar 25</source>
        <translation>Mylar 25</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>NTSL200</source>
        <translation>NTSL200</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Never</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nominal diameter D0: that of the canopy laid out flat.</source>
        <translation>Diamètre nominal D0 : celui de la voilure étalée à plat.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal force</source>
        <translation>Force normale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal force coefficient of the fabric in the wind.</source>
        <translation>Coefficient de force normale du tissu dans le vent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal force coefficient per sine of the angle of attack; 2 pi A / (2 + sqrt(A^2 + 8)) for a delta of aspect ratio A, less for a loose sail.</source>
        <translation>Coefficient de force normale par sinus de l’angle d’attaque ; 2 pi A / (2 + sqrt(A^2 + 8)) pour un delta d’allongement A, moins pour une voile lâche.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal force coefficient per sine of the angle of attack; 2 pi A / (2 + sqrt(A^2 + 8)) for a taut delta of aspect ratio A, 3.1 fits the first, slack Rogallo wings.</source>
        <translation>Coefficient de force normale par sinus de l’angle d’attaque ; 2 pi A / (2 + sqrt(A^2 + 8)) pour un delta tendu d’allongement A, 3,1 convient aux premières ailes Rogallo, lâches.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Normal force coefficient per sine of the angle of attack; 2.5 for a plate as wide as it is high.</source>
        <translation>Coefficient de force normale par sinus de l’angle d’attaque ; 2,5 pour une plaque aussi large que haute.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Not at all</source>
        <translation>Pas du tout</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Number that picks the generated hills; the same number gives the same hills.</source>
        <translation>Nombre qui choisit les collines engendrées ; le même nombre donne les mêmes collines.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Number that the gusts follow from; the same seed gives the same gusts.</source>
        <translation>Nombre dont découlent les rafales ; la même graine donne les mêmes rafales.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nylite 90</source>
        <translation>Nylite 90</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nylon cord MIL-C-5040 I</source>
        <translation>Cordelette nylon MIL-C-5040 I</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nylon cord MIL-C-5040 III (550)</source>
        <translation>Cordelette nylon MIL-C-5040 III (550)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Nylon parachute</source>
        <translation>Parachute en nylon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of a link, its length over that at rest less one; the largest where there are several.</source>
        <translation>D’une liaison, sa longueur sur celle au repos moins un ; la plus grande s’il y en a plusieurs.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of a link; the largest where there are several.</source>
        <translation>D’une liaison ; la plus grande s’il y en a plusieurs.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all links together, as they are stretched.</source>
        <translation>De toutes les liaisons ensemble, étirées comme elles le sont.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all panels and lines together.</source>
        <translation>De tous les panneaux et lignes ensemble.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all panels together, as they are stretched.</source>
        <translation>De tous les panneaux ensemble, étirés comme ils le sont.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all six particles together.</source>
        <translation>Des six particules ensemble.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all springs; takes speed from stretching only.</source>
        <translation>De tous les ressorts ; ne prend de la vitesse qu’à l’allongement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all that can move, its length.</source>
        <translation>De tout ce qui peut bouger, sa norme.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of all that moves.</source>
        <translation>De tout ce qui bouge.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of each new particle.</source>
        <translation>De chaque nouvelle particule.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of spars, where two links meet; the largest where there are several places.</source>
        <translation>Des espars, où deux liaisons se rejoignent ; le plus grand s’il y a plusieurs endroits.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of structural springs: the tension of the fabric per strain.</source>
        <translation>Des ressorts de structure : la tension du tissu par déformation.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of structural springs: the tension of the fabric per strain; light knits have 25 to 130.</source>
        <translation>Des ressorts de structure : la tension du tissu par déformation ; les mailles légères ont 25 à 130.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the air at the centre of mass, over the ground, with its gusts.</source>
        <translation>De l’air au centre de masse, par rapport au sol, rafales comprises.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the air under the canopy.</source>
        <translation>De l’air sous la voilure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the axis from the vertical; 90 lays it along z.</source>
        <translation>De l’axe par rapport à la verticale ; 90 le couche le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass over the ground.</source>
        <translation>Du centre de masse par rapport au sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass through the air there.</source>
        <translation>Du centre de masse à travers l’air qui s’y trouve.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass, along x.</source>
        <translation>Du centre de masse, le long de x.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass, along z.</source>
        <translation>Du centre de masse, le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass, over the last time step.</source>
        <translation>Du centre de masse, sur le dernier pas de temps.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the centre of mass, upwards.</source>
        <translation>Du centre de masse, vers le haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the cylinder.</source>
        <translation>Du cylindre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the field along x.</source>
        <translation>Du champ le long de x.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the field along z.</source>
        <translation>Du champ le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the line from a particle, above the horizon.</source>
        <translation>De la ligne depuis une particule, au-dessus de l’horizon.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the plane that fits the particles best.</source>
        <translation>Du plan qui convient le mieux aux particules.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the ramps, below level.</source>
        <translation>Des rampes, sous l’horizontale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the rope at the start, from straight down.</source>
        <translation>Du cordage au départ, à partir de la verticale vers le bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the sphere.</source>
        <translation>De la sphère.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the tail; 0 leaves it out.</source>
        <translation>De la queue ; 0 l’omet.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of the whole rope.</source>
        <translation>De tout le cordage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Of weight, zero at the origin.</source>
        <translation>Du poids, nulle à l’origine.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>One</source>
        <translation>Un</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>One file of arrays over all frames, with all that is measured and the probes.</source>
        <translation>Un fichier de tableaux sur toutes les images, avec tout ce qui est mesuré et les sondes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>One file with a morph target for each frame and the colours of the fabrics. Blender and web pages.</source>
        <translation>Un fichier avec une cible de morphing par image et les couleurs des tissus. Blender et pages web.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>One side</source>
        <translation>D’un côté</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>One sided</source>
        <translation>D’un seul sens</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Onset</source>
        <translation>Début</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Other probe</source>
        <translation>Autre sonde</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Overhang of a strip over its bending length; with 2 strips come to 41.5 degrees.</source>
        <translation>Porte-à-faux d’une bande, rapporté à sa longueur de flexion ; avec 2 les bandes arrivent à 41,5 degrés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>PA 6.6</source>
        <translation>PA 6.6</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>PES 50 daN</source>
        <translation>PES 50 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>PET film 25 µm (Mylar)</source>
        <translation>Film PET 25 µm (Mylar)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Panels push as a board does instead of wrinkling, where they carry the pull of the fabric.</source>
        <translation>Les panneaux poussent comme une planche au lieu de plisser, là où ils portent la traction du tissu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Panels with normals and texture points, and lines. Blender and most others.</source>
        <translation>Panneaux avec normales et points de texture, et lignes. Blender et la plupart des autres.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Panels with normals, texture points and colours, and lines.</source>
        <translation>Panneaux avec normales, points de texture et couleurs, et lignes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Paper</source>
        <translation>Article</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Paper Jacobi</source>
        <translation>Jacobi de l’article</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Parachute</source>
        <translation>Parachute</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Parachute opening</source>
        <translation>Ouverture de parachute</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Parachutes</source>
        <translation>Parachutes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Paraglider ripstop, coated PA 6.6</source>
        <translation>Ripstop de parapente, PA 6.6 enduit</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particle at one end.</source>
        <translation>Particule à un bout.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particle at the other end.</source>
        <translation>Particule à l’autre bout.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particle that a distance or an elevation is measured from; the tail, where the target is the nose.</source>
        <translation>Particule à partir de laquelle une distance ou une élévation est mesurée ; la queue, si la cible est le nez.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particle, link, part or group that is measured; empty is the whole scene.</source>
        <translation>Particule, liaison, pièce ou groupe mesuré ; vide, c’est toute la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles as near to the plane as this are put on it and belong to both halves.</source>
        <translation>Les particules aussi proches du plan que cela y sont mises et appartiennent aux deux moitiés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles nearer to each other than this become one.</source>
        <translation>Les particules plus proches que cela l’une de l’autre n’en font plus qu’une.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles on both sides of the selected ones, with a rod to each, so that they keep their shape together (Beaudry, Egli, Patenaude 2005). Tools, Rigidity shows what still gives way.</source>
        <translation>Des particules de part et d’autre de celles sélectionnées, avec une tige vers chacune, pour qu’elles gardent ensemble leur forme (Beaudry, Egli, Patenaude 2005). Outils, Rigidité montre ce qui cède encore.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles that the control acts on, and colliders that it moves.</source>
        <translation>Particules sur lesquelles agit la commande, et obstacles qu’elle déplace.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles with velocities, panels, all links with strain and tension.</source>
        <translation>Particules avec vitesses, panneaux, toutes les liaisons avec déformation et tension.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Particles, links and panels that belong to the group.</source>
        <translation>Particules, liaisons et panneaux qui appartiennent au groupe.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Parts that each time step is cut into, the cheapest way to stiffer rods; the automatic solver takes this many or more, and a quarter of them where the automatic integrator takes bdf2.</source>
        <translation>Parties en lesquelles chaque pas de temps est coupé, le moyen le moins cher d’avoir des tiges plus raides ; le solveur automatique en prend autant ou plus, et le quart là où l’intégrateur automatique prend bdf2.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Passes over all rods in each substep; more is stiffer and slower; the direct solver stops as soon as it has converged, and small steps and the automatic solver make one.</source>
        <translation>Passes sur toutes les tiges dans chaque sous-pas ; plus, c’est plus raide et plus lent ; le solveur direct s’arrête dès qu’il a convergé, et les petits pas comme le solveur automatique n’en font qu’un.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Patch</source>
        <translation>Renfort</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Patch radius</source>
        <translation>Rayon des renforts</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Payload</source>
        <translation>Charge utile</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pendulum</source>
        <translation>Pendule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Picture printed on fabric of this material (PNG or JPEG), beside the scene file.</source>
        <translation>Image imprimée sur le tissu de ce matériau (PNG ou JPEG), à côté du fichier de la scène.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Picture to the right</source>
        <translation>Image vers la droite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Picture turn</source>
        <translation>Rotation de l’image</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Picture upwards</source>
        <translation>Image vers le haut</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Picture width</source>
        <translation>Largeur de l’image</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pilot and harness.</source>
        <translation>Pilote et harnais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pilot depth</source>
        <translation>Profondeur du pilote</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pilot mass</source>
        <translation>Masse du pilote</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pink ribbon brown</source>
        <translation>Pink ribbon brown</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pinned</source>
        <translation>Fixée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pitch</source>
        <translation>Tangage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Plotted</source>
        <translation>Tracé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Point cache, MDD</source>
        <translation>Cache de points, MDD</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Point cache, PC2</source>
        <translation>Cache de points, PC2</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Points along each side of generated hills.</source>
        <translation>Points le long de chaque côté des collines engendrées.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Points along each side.</source>
        <translation>Points le long de chaque côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Poisson's ratio</source>
        <translation>Coefficient de Poisson</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pole</source>
        <translation>Mât</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pole density</source>
        <translation>Masse linéique du mât</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pole flag</source>
        <translation>Drapeau sur mât</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Polyester kite line 50 daN</source>
        <translation>Ligne de cerf-volant polyester 50 daN</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ponte Roma knit</source>
        <translation>Maille Ponte Roma</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porcher Skytex 21</source>
        <translation>Porcher Skytex 21</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porcher Skytex 27</source>
        <translation>Porcher Skytex 27</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porcher Skytex 29</source>
        <translation>Porcher Skytex 29</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porcher Skytex 32</source>
        <translation>Porcher Skytex 32</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porcher Skytex 38</source>
        <translation>Porcher Skytex 38</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porosity</source>
        <translation>Porosité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Porosity of ideal cloth; about 0.03 for parachute nylon. Real cloth has its own.</source>
        <translation>Porosité d’une toile idéale ; environ 0,03 pour un nylon de parachute. Une vraie toile a la sienne.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Position z</source>
        <translation>Position z</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Potential energy</source>
        <translation>Énergie potentielle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Power law</source>
        <translation>Loi de puissance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Printed flag</source>
        <translation>Drapeau imprimé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Probe whose readings go across when the curves are against a probe.</source>
        <translation>Sonde dont les valeurs vont en abscisse quand les courbes sont tracées selon une sonde.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Probes whose curves it has; empty has all that are plotted.</source>
        <translation>Sondes dont il porte les courbes ; vide, toutes celles qui sont tracées.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull of a rod per rate of strain over its pull per strain, Kelvin and Voigt's retardation time: what stretches it at w radians per second has the loss factor w times this, and rods that never stretch take none.</source>
        <translation>Traction d’une tige par vitesse de déformation sur sa traction par déformation, le temps de retard de Kelvin et Voigt : ce qui l’allonge à w radians par seconde a le facteur de perte w fois ce temps, et les tiges qui ne s’allongent jamais n’en prennent pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull of the warp threads of elastic panels per width, the mean by their area at rest.</source>
        <translation>Traction des fils de chaîne des panneaux élastiques par largeur, moyenne selon leur aire au repos.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull of the weft threads of elastic panels per width, the mean by their area at rest.</source>
        <translation>Traction des fils de trame des panneaux élastiques par largeur, moyenne selon leur aire au repos.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull per width at which a strip of the fabric breaks across its warp, without seams; elastic panels tear by it where the material tears by strength, and else it is noted for margins.</source>
        <translation>Traction par largeur à laquelle une bande du tissu casse en travers de la chaîne, sans couture ; les panneaux élastiques s’y déchirent si le matériau cède par résistance, sinon elle est notée pour les marges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull per width at which a strip of the fabric breaks along its warp, without seams; elastic panels tear by it where the material tears by strength, and else it is noted for margins.</source>
        <translation>Traction par largeur à laquelle une bande du tissu casse dans le sens de la chaîne, sans couture ; les panneaux élastiques s’y déchirent si le matériau cède par résistance, sinon elle est notée pour les marges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Pull per width of fabric, the largest of all directions and places: of elastic panels their principal tension, of threads their tension over their width.</source>
        <translation>Traction par largeur de tissu, la plus grande de toutes les directions et de tous les endroits : des panneaux élastiques leur tension principale, des fils leur tension sur leur largeur.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>RK4</source>
        <translation>RK4</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Radius of a sphere below the sheet; 0 leaves it out.</source>
        <translation>Rayon d’une sphère sous la toile ; 0 l’omet.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Radius of the nozzle of a jet.</source>
        <translation>Rayon de la buse d’un jet.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Radius of the patches; they cover the panels whose middle lies within it.</source>
        <translation>Rayon des renforts ; ils couvrent les panneaux dont le milieu s’y trouve.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Radius of the sphere or the cylinder; other shapes do not use it.</source>
        <translation>Rayon de la sphère ou du cylindre ; les autres formes ne l’utilisent pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rail</source>
        <translation>Rail</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ramp of edits</source>
        <translation>Rampe des modifications</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rate</source>
        <translation>Vitesse de réponse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rate at which every velocity decays, over and above the drag of the panels.</source>
        <translation>Taux auquel toute vitesse décroît, en plus de la traînée des panneaux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Reaction</source>
        <translation>Réaction</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rear legs</source>
        <translation>Brins arrière</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rebind</source>
        <translation>Recaler</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rectangular kite</source>
        <translation>Cerf-volant rectangulaire</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Reference height</source>
        <translation>Hauteur de référence</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Reflex</source>
        <translation>Réflexe</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Reinforcement</source>
        <translation>Renforcement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Repeats</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Resists</source>
        <translation>Résiste à</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Resists pushing</source>
        <translation>Résiste à la poussée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Response</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rest length</source>
        <translation>Longueur au repos</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rest length ab</source>
        <translation>Longueur à vide ab</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rest length bc</source>
        <translation>Longueur à vide bc</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rest length ca</source>
        <translation>Longueur à vide ca</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rest lengths of links: rebind them to the new distances, so that the design stays free of load, or keep them.</source>
        <translation>Longueurs au repos des liaisons : les recaler sur les nouvelles distances, pour que le modèle reste sans charge, ou les garder.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Restitution</source>
        <translation>Restitution</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rib knit</source>
        <translation>Maille à côtes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Right side</source>
        <translation>Côté droit</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rings</source>
        <translation>Anneaux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rings of fabric from the apex to the skirt.</source>
        <translation>Anneaux de tissu de l’apex au bord d’attaque.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop 0.5 oz</source>
        <translation>Ripstop 0,5 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop 0.75 oz, kite cloth</source>
        <translation>Ripstop 0,75 oz, toile de cerf-volant</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop 1.5 oz</source>
        <translation>Ripstop 1,5 oz</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop kite</source>
        <translation>Cerf-volant en ripstop</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop over a ball</source>
        <translation>Ripstop sur une boule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ripstop with a slit is drawn apart at 0.1 m/s. Its panels carry the pull and tear by the strength of the material, 8 kN/m; the mesh parts, and every panel stays whole on its side.</source>
        <translation>De la toile ripstop fendue est étirée à 0,1 m/s. Ses panneaux portent la traction et se déchirent à la résistance du matériau, 8 kN/m ; le maillage se fend, et chaque panneau reste entier de son côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rise of the cross spar from the spine to its tips; the bow keeps the kite upright.</source>
        <translation>Relèvement de la traverse de l’épine vers les bouts ; l’arc garde le cerf-volant droit.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rise of the leading edges to the tips; keeps the kite upright.</source>
        <translation>Relèvement des bords d’attaque vers les bouts ; garde le cerf-volant droit.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rise of the leading edges to the tips; rolls the wing level when it slips.</source>
        <translation>Relèvement des bords d’attaque vers les bouts ; remet l’aile à plat quand elle glisse.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rise of the rear end of the keel over its length; gives pitch stability.</source>
        <translation>Relèvement de l’arrière de la quille, rapporté à sa longueur ; donne la stabilité en tangage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rise of the trailing edge at the keel over the chord; turns the nose up like washout.</source>
        <translation>Relèvement du bord de fuite à la quille, rapporté à la corde ; cabre comme le vrillage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rising gusts</source>
        <translation>Rafales croissantes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rod</source>
        <translation>Tige</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rod solver</source>
        <translation>Solveur des tiges</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rods from end to end.</source>
        <translation>Tiges d’un bout à l’autre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Roll</source>
        <translation>Roulis</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rolling ground to soar along and to land on.</source>
        <translation>Un terrain vallonné le long duquel planer et où se poser.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ropes</source>
        <translation>Cordages</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Round parachute (ideal, the paper's)</source>
        <translation>Parachute rond (idéal, celui de l’article)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows</source>
        <translation>Rangées</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows of angle of attack in degrees from 0 to 90, lift coefficient and drag coefficient, for the law lift_drag.</source>
        <translation>Rangs d’angle d’attaque en degrés de 0 à 90, de coefficient de portance et de coefficient de traînée, pour la loi lift_drag.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows of cloth from the cross spar to the nose, and to the tail; an odd number is made even.</source>
        <translation>Rangées de toile de la traverse au nez, et à la queue ; un nombre impair est rendu pair.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows of lines along the chord, A, B, C and so on; the table takes their place.</source>
        <translation>Rangées de brins le long de la corde, A, B, C et ainsi de suite ; le tableau prend leur place.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows of lines that fork from a riser to the points of a wing, with lengths from a table.</source>
        <translation>Des rangées de brins qui se ramifient d’un élévateur vers les points d’une aile, aux longueurs d’un tableau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rows of time in s and of velocity along x, y and z in m/s: straight from row to row, and before the first and after the last as there.</source>
        <translation>Lignes de temps en s et de vitesse selon x, y et z en m/s : droit d’une ligne à l’autre, et avant la première et après la dernière comme là.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Royal Target cotton</source>
        <translation>Coton Royal Target</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rule that restores the lengths of rods; the automatic one takes what the wanted accuracy needs: small steps, or all rods together where they are stiff or carry heavy loads, and springs with them that are too stiff for the substep; averaged Jacobi conserves momentum, the paper's does not.</source>
        <translation>Règle qui rend leurs longueurs aux tiges ; l’automatique prend ce que demande la précision voulue : de petits pas, ou toutes les tiges ensemble là où elles sont raides ou portent de lourdes charges, et avec elles les ressorts trop raides pour le sous-pas ; le Jacobi moyenné conserve la quantité de mouvement, celui de l’article non.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Rule that turns forces into motion; the automatic one takes bdf2 where all rods stretch, are damped and are solved together, and otherwise semi_implicit_euler; implicit_euler and bdf2 hold springs of any stiffness, and bdf2 keeps swings where large steps damp them, rk4 is the most exact for what has no rods.</source>
        <translation>Règle qui change les forces en mouvement ; l’automatique prend bdf2 là où toutes les tiges s’allongent, sont amorties et sont résolues ensemble, et sinon semi_implicit_euler ; implicit_euler et bdf2 tiennent des ressorts de toute raideur, bdf2 garde les balancements là où de grands pas les amortissent, rk4 est le plus exact pour ce qui n’a pas de tiges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Safety factor</source>
        <translation>Coefficient de sécurité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sail and frame together, shared equally by all particles but the pilot; where the cloth is ideal.</source>
        <translation>Voile et structure ensemble, réparties également sur toutes les particules sauf le pilote ; pour une toile idéale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sailcloth laminate, film on polyester scrim</source>
        <translation>Laminé à voile, film sur trame polyester</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Second corner.</source>
        <translation>Deuxième coin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sectors</source>
        <translation>Secteurs</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Segments of each suspension line.</source>
        <translation>Segments de chaque suspente.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Segments of the line.</source>
        <translation>Segments de la ligne.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Segments of the tail.</source>
        <translation>Segments de la queue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Self-contact</source>
        <translation>Contact avec soi</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Self-friction</source>
        <translation>Frottement avec soi</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Semi implicit Euler</source>
        <translation>Euler semi-implicite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sequence of OBJ files</source>
        <translation>Suite de fichiers OBJ</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sequence of PLY files</source>
        <translation>Suite de fichiers PLY</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sequence of STL files</source>
        <translation>Suite de fichiers STL</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Series for ParaView, PVD and VTP</source>
        <translation>Série pour ParaView, PVD et VTP</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Series for Python, HDF5</source>
        <translation>Série pour Python, HDF5</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Set-up</source>
        <translation>Montage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shapes in the wind</source>
        <translation>Formes dans le vent</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of its strengths that what is made of it keeps, as fabric does at seams and a line at knots: about 0.8 for lap seams, 0.9 for sewn loops, 0.35 to 0.6 for knots; all of it tears at that share where the material tears by strength, and else it is noted for margins.</source>
        <translation>Part de ses résistances que garde ce qui en est fait, comme le tissu aux coutures et une ligne aux nœuds : environ 0.8 pour les coutures rabattues, 0.9 pour les boucles cousues, 0.35 à 0.6 pour les nœuds ; tout cède à cette part si le matériau cède par résistance, sinon elle est notée pour les marges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of the area of elastic panels that is wrinkled or slack.</source>
        <translation>Part de l’aire des panneaux élastiques qui est plissée ou détendue.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of the chord along which the keel is sewn to a sail of real cloth, from the trailing edge on; its segments follow from those of the wing, and spars weigh where they are, so that the kite is the same at any number of segments. 0 has as many segments as said above.</source>
        <translation>Part de la corde sur laquelle la quille est cousue à une voile de toile réelle, depuis le bord de fuite ; ses segments suivent ceux de l’aile, et les longerons pèsent là où ils sont, si bien que le cerf-volant est le même avec n’importe quel nombre de segments. 0 lui donne autant de segments que dit plus haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of the impact speed that a bounce gives back; only the response contact uses it.</source>
        <translation>Part de la vitesse d’impact qu’un rebond rend ; seule la réponse contact l’utilise.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of the speed that what hits it keeps; 0 does not bounce.</source>
        <translation>Part de la vitesse que garde ce qui le heurte ; 0 ne rebondit pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Share of the way to the middle of its neighbours that a particle goes in one pass.</source>
        <translation>Part du chemin vers le milieu de ses voisines qu’une particule fait en une passe.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shear stiffness</source>
        <translation>Rigidité de cisaillement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sheet on boxes</source>
        <translation>Toile sur des boîtes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sheet on terrain</source>
        <translation>Toile sur un terrain</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shift</source>
        <translation>Déport</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shown</source>
        <translation>Montré</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shown in plots and tables.</source>
        <translation>Montré dans les courbes et les tableaux.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shown in plots that name no probes of their own.</source>
        <translation>Montré dans les graphiques qui ne nomment pas leurs propres sondes.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shown in the outline and used in paths.</source>
        <translation>Montré dans l’arborescence et utilisé dans les chemins.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Shown over the plot.</source>
        <translation>Montré au-dessus du graphique.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Side of the square, and width of the arms.</source>
        <translation>Côté du carré, et largeur des bras.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Silicone-coated nylon</source>
        <translation>Nylon siliconé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Simulated time of one step; shorter is more exact and slower.</source>
        <translation>Temps simulé d’un pas ; plus court, c’est plus exact et plus lent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sink rate</source>
        <translation>Taux de chute</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sinks this fast at the start.</source>
        <translation>Descend à cette vitesse au départ.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Size and mass</source>
        <translation>Taille et masse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skin friction</source>
        <translation>Frottement pariétal</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skyshark P100</source>
        <translation>Skyshark P100</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skyshark P400</source>
        <translation>Skyshark P400</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skyshark P90</source>
        <translation>Skyshark P90</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skytex 21</source>
        <translation>Skytex 21</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skytex 27</source>
        <translation>Skytex 27</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skytex 29</source>
        <translation>Skytex 29</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skytex 32</source>
        <translation>Skytex 32</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Skytex 38</source>
        <translation>Skytex 38</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Slack</source>
        <translation>Mou</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Slide</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Slit</source>
        <translation>Fente</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Small steps</source>
        <translation>Petits pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Softness of sweeps</source>
        <translation>Mollesse des balayages</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Solver passes</source>
        <translation>Passes du solveur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Span</source>
        <translation>Envergure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Spars in leading edges and keel, and the ring at the tow point.</source>
        <translation>Longerons des bords d’attaque et de la quille, et anneau au point d’attache.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Spars of the frame; ideal ones never stretch, real ones bend.</source>
        <translation>Longerons de l’armature ; idéaux, ils ne s’étirent jamais, les vrais fléchissent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Spars, and the ring at the tow point.</source>
        <translation>Longerons, et anneau au point d’attache.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Speed at which air fills a canopy, over that of the wind times the square root of mouth over cloth area; 0.07 for round parachutes, only with canopy pressure.</source>
        <translation>Vitesse à laquelle l’air remplit une voilure, rapportée à celle du vent fois la racine de l’aire de la bouche sur celle de la toile ; 0,07 pour les parachutes ronds, seulement avec une pression de voilure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Speed limit</source>
        <translation>Vitesse limite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Speed of the air that leaks through the cloth over the speed sqrt(2 dp / rho) that its pressure could give; about 0.03 for parachute nylon, 0 is tight.</source>
        <translation>Vitesse de l’air qui fuit à travers la toile, rapportée à la vitesse sqrt(2 dp / rho) que sa pression pourrait donner ; environ 0,03 pour le nylon de parachute, 0 est étanche.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Speed of the wind, across the sheet when it is hung by corners and along it when by an edge.</source>
        <translation>Vitesse du vent, en travers de la toile si elle pend par des coins et le long d’elle si c’est par un bord.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Speed of the wind.</source>
        <translation>Vitesse du vent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Split sheet</source>
        <translation>Toile fendue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Spring</source>
        <translation>Ressort</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stall</source>
        <translation>Décrochage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stays</source>
        <translation>Reste</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Steel 2.4</source>
        <translation>acier 2,4</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Steel cable 3/32 in, 7 x 7</source>
        <translation>Câble d’acier 3/32 in, 7 x 7</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Step from one to the next.</source>
        <translation>Pas de l’un au suivant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Steps per second</source>
        <translation>Pas par seconde</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stiffened</source>
        <translation>Raidie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stiffened rod</source>
        <translation>Tige raidie</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stiffness of bend springs over that of structural ones.</source>
        <translation>Raideur des ressorts de flexion, rapportée à celle des ressorts de structure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stiffness of shear springs over that of structural ones.</source>
        <translation>Raideur des ressorts de cisaillement, rapportée à celle des ressorts de structure.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stiffness of shear springs over that of structural ones; of the membrane, shear stiffness over membrane stiffness.</source>
        <translation>Raideur des ressorts de cisaillement, rapportée à celle des ressorts de structure ; avec la membrane, rigidité de cisaillement sur rigidité de membrane.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Strain at which a spring tears; 0 never.</source>
        <translation>Déformation à laquelle un ressort rompt ; 0 jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Strain by which a fabric that is pulled along its warp gets narrower over the strain along it, where panels carry its pull; 0.1 to 0.2 for tight coated cloth.</source>
        <translation>Déformation dont un tissu tiré le long de sa chaîne rétrécit, sur la déformation le long d’elle, là où les panneaux portent sa traction ; 0,1 à 0,2 pour un tissu enduit serré.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stretch of a rod per newton, 0 never stretches; empty takes the material's.</source>
        <translation>Allongement d’une tige par newton, 0 ne s’allonge jamais ; vide, celui du matériau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stretch of a rod per newton; 0 never stretches.</source>
        <translation>Allongement d’une tige par newton ; 0 ne s’allonge jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Stretched line</source>
        <translation>Ligne étirée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Strips and frames of cloth</source>
        <translation>Bandes et cadres de toile</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Strips of fabric that droop over the edge of a table.</source>
        <translation>Des bandes de tissu qui tombent du bord d’une table.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Strips of three measured fabrics, with their own stretch and bending, reach twice their bending length (B / (density g))^(1/3) over the edge and droop to 41.5 degrees, the slope of the ramps. Peirce 1930.</source>
        <translation>Des bandes de trois tissus mesurés, avec leur allongement et leur flexion, dépassent le bord de deux fois leur longueur de flexion (B / (densité g))^(1/3) et s’affaissent à 41,5 degrés, la pente des rampes. Peirce 1930.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Substeps</source>
        <translation>Sous-pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Sweat knit</source>
        <translation>Maille molleton</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Swimwear</source>
        <translation>Maillot de bain</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL140</source>
        <translation>TSL140</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL190</source>
        <translation>TSL190</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL280</source>
        <translation>TSL280</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL380</source>
        <translation>TSL380</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL500</source>
        <translation>TSL500</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>TSL90</source>
        <translation>TSL90</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Table of the probes, CSV</source>
        <translation>Tableau des sondes, CSV</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tail</source>
        <translation>Queue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tail density</source>
        <translation>Masse linéique de queue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tail length</source>
        <translation>Longueur de queue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tail segments</source>
        <translation>Segments de queue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tail width</source>
        <translation>Largeur de queue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Takes bumps and creases out of the selected fabric and lines.</source>
        <translation>Ôte les bosses et les plis du tissu et des lignes sélectionnés.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tape</source>
        <translation>Sangle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Target area</source>
        <translation>Aire visée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Target length</source>
        <translation>Longueur visée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Taubin</source>
        <translation>Taubin</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Taubin's keeps the size; the Laplacian one shrinks and draws tight.</source>
        <translation>Celle de Taubin garde la taille ; la laplacienne rétrécit et tend.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tear</source>
        <translation>Déchirure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tear limit</source>
        <translation>Limite de rupture</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tear strength</source>
        <translation>Résistance à la déchirure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tear test</source>
        <translation>Essai de déchirure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tearing sheet</source>
        <translation>Toile qui se déchire</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tears by</source>
        <translation>Rompt par</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tears per step</source>
        <translation>Ruptures par pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Teijin D2, canopy of surf kites</source>
        <translation>Teijin D2, voilure de kitesurf</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tension at which a line breaks, without knots; lines and spars tear by it where the material tears by strength, and else it is noted for margins.</source>
        <translation>Tension à laquelle une ligne casse, sans nœud ; lignes et longerons y rompent si le matériau cède par résistance, sinon elle est notée pour les marges.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Test</source>
        <translation>Essai</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Texture u</source>
        <translation>Texture u</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Texture v</source>
        <translation>Texture v</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>That of links at the ends, where there are any, or a new one.</source>
        <translation>Celui des liaisons aux bouts, s’il y en a, ou un nouveau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>That of links at these particles, where there are any, or a new one.</source>
        <translation>Celui des liaisons de ces particules, s’il y en a, ou un nouveau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>That of panels at these particles, where there are any, or a new one.</source>
        <translation>Celui des panneaux de ces particules, s’il y en a, ou un nouveau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>That of the neighbours</source>
        <translation>Celui des voisines</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The Dacron glider flies over generated hills of 40 m, a height field of 256 x 256 points, and lands on them when it is low. Tune the altitude of the hills, the y of the size of the ground.</source>
        <translation>Le deltaplane en Dacron survole des collines engendrées de 40 m, un champ de hauteurs de 256 x 256 points, et s’y pose quand il est bas. Réglez la hauteur des collines, le y de la taille du sol.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The delta of The last gust in 0.75 oz ripstop, with an old crease: along it 5 % of the cloth's strength is left, painted on the panels. At 15.3 s a gust after a lull tears the sail along the crease, from its middle to the trailing edge. Colour the fabric by strength factor to see the crease, and paint it stronger with the brush (U): with 12 % it holds.</source>
        <translation>Le delta de « La dernière rafale » en ripstop de 0,75 oz, avec un vieux pli : il y reste 5 % de la résistance de la toile, peints sur les panneaux. À 15,3 s, une rafale après une accalmie déchire la voile le long du pli, de son milieu jusqu’au bord de fuite. Colorez la toile par le facteur de résistance pour voir le pli, et peignez-le plus fort au pinceau (U) : avec 12 %, elle tient.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The delta of what one can buy: 0.75 oz ripstop, fibreglass tubes of 6 mm and a line of 450 N, 405 at its knots. Tune the membrane stiffness of sail, border and keel cloth, 20 to 90 kN/m, and watch the strain (Alt+2).</source>
        <translation>Le delta de ce qui s’achète : ripstop de 0,75 oz, tubes de fibre de verre de 6 mm et une ligne de 450 N, 405 à ses nœuds. Réglez la raideur de membrane de la voile, du bord et de la toile de quille, de 20 à 90 kN/m, et regardez la déformation (Alt+2).</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The glider of what one can buy: Dacron of 210 g/m2 on aluminium tubes of 50 mm. The keys shift the pilot. Tune the flexural rigidity of the tube, 500 to 6000 N m2: soft leading edges give way outside of the cross tube, the sail billows, and it glides less far.</source>
        <translation>Le deltaplane de ce qui s’achète : Dacron de 210 g/m2 sur des tubes d’aluminium de 50 mm. Les touches déplacent le pilote. Réglez la rigidité de flexion du tube, de 500 à 6000 N m2 : des bords d’attaque souples cèdent au-delà de la transversale, la voile se gonfle, et il plane moins loin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The largest of all links and of all threads of elastic panels.</source>
        <translation>Le plus grand de toutes les liaisons et de tous les fils des panneaux élastiques.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The largest of all links.</source>
        <translation>La plus grande de toutes les liaisons.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The last gust</source>
        <translation>La dernière rafale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The link breaks above this, in metres, as a strain or in newtons as its material's tear rule says, and in newtons where that is of tension or strength; empty takes the material's.</source>
        <translation>La liaison rompt au-delà, en mètres, en déformation ou en newtons selon la règle de rupture de son matériau, et en newtons si celle-ci est de tension ou de résistance ; vide, celle du matériau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The mean of all links that have not torn.</source>
        <translation>La moyenne de toutes les liaisons non rompues.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The other side</source>
        <translation>De l’autre côté</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The panels alone, for printing and CAD; the format knows no unit: metres.</source>
        <translation>Les panneaux seuls, pour l’impression et la CAO ; le format ne connaît pas d’unité : mètres.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The panels of each frame.</source>
        <translation>Les panneaux de chaque image.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's hang glider</source>
        <translation>Le deltaplane de l’article</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's kite</source>
        <translation>Le cerf-volant de l’article</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's network of rods that never stretch. Down pulls the hand back against the wind, Up gives way, Left and Right walk sideways.</source>
        <translation>Le réseau de l’article, de tiges qui ne s’étirent jamais. Bas tire la main en arrière contre le vent, Haut cède, Gauche et Droite marchent de côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's network of rods that never stretch. The payload sinks at sqrt(2 m g / (rho CD0 S0)).</source>
        <translation>Le réseau de l’article, de tiges qui ne s’étirent jamais. La charge descend à sqrt(2 m g / (rho CD0 S0)).</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's network of rods that never stretch. Up dives, Down slows, Left and Right roll: the keys shift the pilot's weight inside the control rods. The pilot hangs where the wing trims at the wanted speed, and the flight starts in that trim.</source>
        <translation>Le réseau de l’article, de tiges qui ne s’étirent jamais. Haut pique, Bas ralentit, Gauche et Droite inclinent : les touches déportent le poids du pilote à l’intérieur des tiges de commande. Le pilote pend là où l’aile s’équilibre à la vitesse voulue, et le vol commence dans cet équilibre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The paper's parachute</source>
        <translation>Le parachute de l’article</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The same as text, for looking into it.</source>
        <translation>La même en texte, pour regarder dedans.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The same everywhere, growing with height by a power law or a logarithm, gusts after Dryden that the other winds carry past, a jet from a nozzle, single gusts of a known size, or as measured; the winds of a scene add up.</source>
        <translation>Le même partout, croissant avec la hauteur selon une loi de puissance ou un logarithme, des rafales selon Dryden que les autres vents emportent, le jet d’une buse, des rafales isolées de taille connue, ou tel qu’on l’a mesuré ; les vents d’une scène s’ajoutent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>The wind is a table of speeds and directions, passing_front.csv, made up: 6 m/s, a lull, then up to 15 m/s from 50 degrees to the right. The kite swings round to where it blows. Tune the line strength of the line, 1 to 20 N; or give the wind a table of your own.</source>
        <translation>Le vent est un tableau de vitesses et de directions, passing_front.csv, inventé : 6 m/s, une accalmie, puis jusqu’à 15 m/s venant de 50 degrés à droite. Le cerf-volant suit le vent. Réglez la résistance de la ligne, de 1 à 20 N ; ou donnez au vent un tableau à vous.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Thickness of a line, which the wind drags.</source>
        <translation>Épaisseur d’une suspente, que le vent freine.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Thickness of links as lines in the wind; 0 gives them no drag.</source>
        <translation>Épaisseur des liaisons comme lignes dans le vent ; 0 ne leur donne pas de traînée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Thickness of the line, which the wind drags.</source>
        <translation>Épaisseur de la ligne, que le vent freine.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Third corner.</source>
        <translation>Troisième coin.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Those within the distance</source>
        <translation>Celles à cette distance</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Thread</source>
        <translation>Fil</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Through all in a line, on to the first again, every one with every other, or all to the one that is no corner of a panel: bridle lines to a tow point.</source>
        <translation>À travers toutes en ligne, en revenant à la première, chacune avec chaque autre, ou toutes à celle qui n’est sommet d’aucun panneau : des lignes de bride à un point d’attache.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Through what is selected</source>
        <translation>Par la sélection</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tied</source>
        <translation>Fixation</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Ties the selected particles to each other. The new links are at rest as they are; particles that are linked already stay so.</source>
        <translation>Attache les particules sélectionnées les unes aux autres. Les nouvelles liaisons sont au repos telles quelles ; les particules déjà liées le restent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Time in which links and elastic panels take over a stiffness, damping, rest length or tear limit that is edited in flight, and longer where that would throw what they hold; 0 takes it over at once.</source>
        <translation>Temps que mettent les liaisons et les panneaux élastiques à prendre une raideur, un amortissement, une longueur au repos ou une limite de déchirure modifiés en vol, et plus long là où cela projetterait ce qu’ils tiennent ; 0 les prend aussitôt.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Time steps for each second of the clock, lately: only while it runs in the window, and nothing in files.</source>
        <translation>Pas de temps par seconde d'horloge, dernièrement : seulement pendant la simulation dans la fenêtre, et rien dans les fichiers.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Times in s and places in m that the collider moves through, as 0: 0 1 0; 2.5: 3 1 0; empty stays at its position.</source>
        <translation>Temps en s et lieux en m par lesquels passe l’obstacle, comme 0: 0 1 0; 2.5: 3 1 0 ; vide, il reste à sa position.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Torn links</source>
        <translation>Liaisons rompues</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Torn sheet</source>
        <translation>Toile déchirée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Total as it is spread (kg)</source>
        <translation>Total selon la répartition (kg)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Total energy</source>
        <translation>Énergie totale</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Total energy less that of the start: what air, hands and the solver have brought or taken.</source>
        <translation>Énergie totale moins celle du départ : ce que l’air, les mains et le solveur ont apporté ou pris.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Total evenly (kg)</source>
        <translation>Total également (kg)</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tow point</source>
        <translation>Point d’attache</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tubes in the leading edges and, below real cloth, in the keel; ideal ones never stretch, real ones bend.</source>
        <translation>Tubes des bords d’attaque et, sous une vraie toile, de la quille ; les idéaux ne s’étirent jamais, les vrais fléchissent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tubular nylon 1 in, MIL-W-5625</source>
        <translation>Sangle tubulaire nylon 1 in, MIL-W-5625</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tubular nylon 1/2 in, MIL-W-5625</source>
        <translation>Sangle tubulaire nylon 1/2 in, MIL-W-5625</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Tubular nylon 9/16 in, MIL-W-5625</source>
        <translation>Sangle tubulaire nylon 9/16 in, MIL-W-5625</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Turn</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Twenty rods that only pull, let go at 60 degrees. Tune the viscosity of the settings, 0 to 2 /s, and watch how long it swings.</source>
        <translation>Vingt barres qui ne font que tirer, lâchées à 60 degrés. Réglez la viscosité des paramètres, 0 à 2 /s, et regardez combien de temps la chaîne se balance.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Two corners</source>
        <translation>Deux coins</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Uniform</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Upper end of the axis of values, in the unit of the curves; empty fits what is in sight.</source>
        <translation>Haut de l'axe des valeurs, dans l'unité des courbes ; vide, il s'ajuste à ce qui est visible.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Values stand on a logarithmic axis; those at or below 0 are left out.</source>
        <translation>Les valeurs sont sur un axe logarithmique ; celles à 0 ou en dessous sont omises.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Vanish</source>
        <translation>Disparaître</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocities</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity Verlet</source>
        <translation>Verlet en vitesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity of the air: everywhere, at the reference height, in the nozzle, or at the peak of a discrete gust; gusts after Dryden and measured winds have none of their own.</source>
        <translation>Vitesse de l’air : partout, à la hauteur de référence, dans la buse, ou au sommet d’une rafale isolée ; les rafales selon Dryden et les vents mesurés n’en ont pas en propre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity x</source>
        <translation>Vitesse x</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity y</source>
        <translation>Vitesse y</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Velocity z</source>
        <translation>Vitesse z</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Vent diameter</source>
        <translation>Diamètre de la cheminée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Verlet</source>
        <translation>Verlet</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Viscosity</source>
        <translation>Viscosité</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Vortex</source>
        <translation>Tourbillonnaire</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wanted strain</source>
        <translation>Déformation voulue</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Warp strength</source>
        <translation>Résistance en chaîne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Warp stress</source>
        <translation>Contrainte en chaîne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Washout</source>
        <translation>Vrillage</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Way</source>
        <translation>Façon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Way over height lost, now.</source>
        <translation>Chemin sur hauteur perdue, maintenant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Way over height lost, since the start.</source>
        <translation>Chemin sur hauteur perdue, depuis le départ.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Weft stiffness</source>
        <translation>Rigidité de trame</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Weft strength</source>
        <translation>Résistance en trame</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Weft stress</source>
        <translation>Contrainte en trame</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Weight shift</source>
        <translation>Déport de poids</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What 95 of 100 links that have not torn stay below.</source>
        <translation>Ce sous quoi restent 95 liaisons non rompues sur 100.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What a reader of this scene should know.</source>
        <translation>Ce qu’un lecteur de cette scène devrait savoir.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What breaks a link: its length (m), its strain, or the force in it (N); what tears an elastic panel: the strain of its threads; or, of fabric, the tension of its threads per width (N/m); or what the strengths below say of panels and lines; or the same, and for a tear in panels that goes on the energy that its tear strength tells; or nothing.</source>
        <translation>Ce qui rompt une liaison : sa longueur (m), sa déformation ou la force en elle (N) ; ce qui déchire un panneau élastique : la déformation de ses fils ; ou, d’un tissu, la tension de ses fils par largeur (N/m) ; ou ce que les résistances ci-dessous disent des panneaux et des lignes ; ou de même, et pour une déchirure de panneaux qui avance l’énergie que dit sa résistance à la déchirure ; ou rien.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What carries the pull of the fabric: threads are links, panels are elastic triangles with warp, weft and shear, which wrinkle instead of pushing and give the same answer on every mesh; links that are there carry as well.</source>
        <translation>Ce qui porte la traction du tissu : les fils sont des liaisons, les panneaux des triangles élastiques avec chaîne, trame et cisaillement, qui plissent au lieu de pousser et donnent la même réponse sur tout maillage ; les liaisons présentes portent aussi.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What dampers and viscosity have taken, at most 0.</source>
        <translation>Ce que les amortisseurs et la viscosité ont pris, au plus 0.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What hands and controls have brought or taken.</source>
        <translation>Ce que les mains et les commandes ont apporté ou pris.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What holds the pinned particles against links, panels, air and weight.</source>
        <translation>Ce qui tient les particules fixées contre liaisons, panneaux, air et poids.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What holds the sheet: 0 two corners, 1 the left edge like a flag, 2 nothing, 3 the left and the right edge, of which the right one can be drawn away, 4 the left edge clamped, 5 rings along a rail, of which the last one can be drawn.</source>
        <translation>Ce qui tient la toile : 0 deux coins, 1 le bord gauche comme un drapeau, 2 rien, 3 les bords gauche et droit, dont le droit peut être tiré, 4 le bord gauche encastré, 5 des anneaux le long d’un rail, dont le dernier peut être tiré.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What impacts and friction have taken; what moves may bring some.</source>
        <translation>Ce que les chocs et le frottement ont pris ; ce qui bouge peut en apporter.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What is left of the motion of a particle that touches: nothing, the part along the surface, or a bounce with friction.</source>
        <translation>Ce qui reste du mouvement d’une particule qui touche : rien, la partie le long de la surface, ou un rebond avec frottement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What is measured.</source>
        <translation>Ce qui est mesuré.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What is sewn along the edges of square and arms of real cloth; a hem is the cloth itself, turned in twice over 1 cm.</source>
        <translation>Ce qui est cousu le long des bords du carré et des bras d’une vraie toile ; un ourlet est la toile elle-même, repliée deux fois sur 1 cm.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What is sewn into the skirt, the rim of a vent and onto the seams between the gores of real cloth; a hem is the cloth itself, turned in twice over 1 cm.</source>
        <translation>Ce qui est cousu dans la jupe, au bord d’une cheminée et sur les coutures entre les fuseaux d’une vraie toile ; un ourlet est la toile elle-même, repliée deux fois sur 1 cm.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What it is meant to weigh; the totals show the difference, and empty sets no target.</source>
        <translation>Ce que cela doit peser ; les totaux montrent la différence, et vide ne vise rien.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What panels do that tear or are beside a link that does: they vanish, or the mesh splits, so that each panel stays whole on its side.</source>
        <translation>Ce que font les panneaux qui se déchirent ou sont à côté d’une liaison qui rompt : ils disparaissent, ou le maillage se fend, et chaque panneau reste entier de son côté.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the air has brought (above 0) or taken.</source>
        <translation>Ce que l’air a apporté (au-dessus de 0) ou pris.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the amount is and how it is shared out. Links and panels count that lie among what is selected.</source>
        <translation>Ce qu’est la quantité et comment elle se répartit. Comptent les liaisons et panneaux qui sont dans la sélection.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the axis runs through.</source>
        <translation>Ce par quoi passe l’axe.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the curves are drawn against: time, what another probe reads, or frequency, as spectra.</source>
        <translation>Ce selon quoi les courbes sont tracées : le temps, ce que lit une autre sonde, ou la fréquence, en spectres.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the edge of fabric does. Ends of lines stay.</source>
        <translation>Ce que fait le bord du tissu. Les bouts de lignes restent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the line is made of; an ideal one never stretches.</source>
        <translation>Matériau de la ligne ; idéal, il ne s’étire jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the lines are made of; ideal ones never stretch.</source>
        <translation>En quoi sont les lignes ; des lignes idéales ne s’allongent jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the link stands for where its material has a physical stiffness: a line or spar by itself, threads of a fabric, or its resistance to shear.</source>
        <translation>Ce que représente la liaison là où son matériau a une rigidité physique : une ligne ou un longeron à elle seule, des fils d’un tissu, ou sa résistance au cisaillement.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the particle cannot leave: a line or a plane through where it is, which takes up every force across it and gives no friction.</source>
        <translation>Ce que la particule ne peut quitter : une ligne ou un plan par sa place, qui reprend toute force en travers et ne frotte pas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the rope is made of; an ideal one is as stiff and heavy as said below.</source>
        <translation>Cordage ; un cordage idéal est aussi raide et lourd qu’indiqué plus bas.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the sheet is made of; ideal cloth is as stiff and heavy as said below, a real one is carried by panels and wrinkles.</source>
        <translation>Tissu de la nappe ; un tissu idéal est aussi raide et lourd qu’indiqué plus bas, un vrai est porté par des panneaux et fait des plis.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What the suspension lines are made of; ideal ones never stretch.</source>
        <translation>Matériau des suspentes ; les idéaux ne s’étirent jamais.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What this scene is, in one line.</source>
        <translation>Ce qu’est cette scène, en une ligne.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>What torn links held and took along, at most 0.</source>
        <translation>Ce que les liens déchirés tenaient et ont emporté, au plus 0.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>When the first gust begins.</source>
        <translation>Quand commence la première rafale.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where it is now, across; of links and panels their middle.</source>
        <translation>Où c’est maintenant, en largeur ; pour liaisons et panneaux, leur milieu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where it is now, along z; of links and panels their middle.</source>
        <translation>Où c’est maintenant, le long de z ; pour liaisons et panneaux, leur milieu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where it is now, up; of links and panels their middle.</source>
        <translation>Où c’est maintenant, en hauteur ; pour liaisons et panneaux, leur milieu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the air force acts: the mean of the panels by the force on each, along x.</source>
        <translation>Où agit la force de l’air : la moyenne des panneaux pondérée par la force sur chacun, le long de x.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the air force acts: the mean of the panels by the force on each, along z.</source>
        <translation>Où agit la force de l’air : la moyenne des panneaux pondérée par la force sur chacun, le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the air force acts: the mean of the panels by the force on each, upwards.</source>
        <translation>Où agit la force de l’air : la moyenne des panneaux pondérée par la force sur chacun, vers le haut.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the centre of mass is, along x.</source>
        <translation>Où est le centre de masse, le long de x.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the centre of mass is, along z.</source>
        <translation>Où est le centre de masse, le long de z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the cross spar crosses the spine, from 0 at the nose to 1.</source>
        <translation>Où la traverse croise l’épine, de 0 au nez à 1.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the fabric is arched deepest between the nose and the tail, from the nose, over their distance.</source>
        <translation>Où le tissu est le plus creux entre le nez et la queue, depuis le nez, rapporté à leur distance.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the hoist is tied to the pole.</source>
        <translation>Où le guindant est attaché au mât.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the nose points, from +x towards +z.</source>
        <translation>Où pointe le nez, de +x vers +z.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the one particle is.</source>
        <translation>Où est cette particule.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the particle lies across the picture printed on the fabric, 0 to 1.</source>
        <translation>Où se trouve la particule en travers de l’image imprimée sur le tissu, de 0 à 1.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the particle lies up the picture printed on the fabric, 0 to 1.</source>
        <translation>Où se trouve la particule en hauteur dans l’image imprimée sur le tissu, de 0 à 1.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the particle starts.</source>
        <translation>Où la particule démarre.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the plane stands: at the origin, on the side of least or most x, y or z of what is selected, or in its middle.</source>
        <translation>Où se tient le plan : à l’origine, du côté du plus petit ou du plus grand x, y ou z de la sélection, ou en son milieu.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the tow point lies below the wing, from 0 at the nose to 1; a little ahead of the centroid of the sail, which is where this law has the centre of pressure; real deltas have both further forward.</source>
        <translation>Où se trouve le point d’attache sous l’aile, de 0 au nez à 1 ; un peu en avant du centroïde de la voile, où cette loi place le centre de poussée ; les vrais deltas ont les deux plus en avant.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the tow point lies, from 0 at the leading edge to 1; a little ahead of the middle, where the centroid of the sail is.</source>
        <translation>Où se trouve le point d’attache, de 0 au bord d’attaque à 1 ; un peu en avant du milieu, où est le centroïde de la voile.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the tow point lies, from 0 at the nose to 1; a little ahead of the centroid of the sail, which is at (1 + cross) / 3.</source>
        <translation>Où se trouve le point d’attache, de 0 au nez à 1 ; un peu en avant du centroïde de la voile, qui est à (1 + croisement) / 3.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the two front legs of the bridle are tied, from 0 at the leading edge to 1.</source>
        <translation>Où sont attachés les deux brins avant de la bride, de 0 au bord d’attaque à 1.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Where the two rear legs are tied.</source>
        <translation>Où sont attachés les deux brins arrière.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Which</source>
        <translation>Lesquelles</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Which of the selected particles become one.</source>
        <translation>Lesquelles des particules sélectionnées n’en font plus qu’une.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>White dots on black</source>
        <translation>White dots on black</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Width of one picture on the cloth, its height as it is tall; it repeats, and 0 lays one over u and v of the mesh.</source>
        <translation>Largeur d’une image sur le tissu, sa hauteur suivant ses proportions ; elle se répète, et 0 en pose une seule sur les u et v du maillage.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Width of the mouth at the start over the nominal diameter, the cloth in folds, with canopy pressure only; 0 starts in the shape of a full canopy. The wind brings the pressure.</source>
        <translation>Largeur de la bouche au départ, rapportée au diamètre nominal, la toile en plis, avec une pression de voilure seulement ; 0 démarre dans la forme d’une voilure gonflée. La pression vient avec le vent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Width of the open mouth over the nominal diameter; 0.67 to 0.70 for flat circular canopies.</source>
        <translation>Largeur de la bouche ouverte, rapportée au diamètre nominal ; 0,67 à 0,70 pour les voilures circulaires plates.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Width of the strip of fabric that a thread or bias stands for; with 0 it takes the material's stiffness or compliance as it is.</source>
        <translation>Largeur de la bande de tissu que représente un fil ou un biais ; avec 0, il prend telle quelle la raideur ou la souplesse du matériau.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wind at 20 ft whose gusts blow as well; 7.7 is light turbulence, 15.4 moderate.</source>
        <translation>Vent à 20 pieds dont les rafales soufflent aussi ; 7,7 est une turbulence légère, 15,4 modérée.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wind at 20 ft whose gusts these are; 7.7 is light turbulence, 15.4 moderate, 23.2 severe.</source>
        <translation>Vent à 20 pieds dont ce sont les rafales ; 7,7 est une turbulence légère, 15,4 modérée, 23,2 forte.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wind of 8 m/s along a flag of 1.5 m x 1 m. It flutters because waves on it run slower than the wind.</source>
        <translation>Un vent de 8 m/s le long d’un drapeau de 1,5 m x 1 m. Il bat parce que les ondes y courent moins vite que le vent.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wind speed</source>
        <translation>Vitesse du vent</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wing mass</source>
        <translation>Masse de l’aile</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wings</source>
        <translation>Ailes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>With its mesh as OBJ beside it, for Blender's Mesh Cache (Time Mode: Frame).</source>
        <translation>Avec son maillage en OBJ à côté, pour le Mesh Cache de Blender (Time Mode: Frame).</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>With its mesh as OBJ beside it, for Blender, LightWave and Maya.</source>
        <translation>Avec son maillage en OBJ à côté, pour Blender, LightWave et Maya.</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wooden dowel 6 mm</source>
        <translation>Tourillon de bois 6 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wooden dowel 8 mm</source>
        <translation>Tourillon de bois 8 mm</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Work of air</source>
        <translation>Travail de l’air</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Work of contact</source>
        <translation>Travail du contact</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Work of damping</source>
        <translation>Travail de l’amortissement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Work of hands</source>
        <translation>Travail des mains</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Work of tearing</source>
        <translation>Travail de la déchirure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>Wrinkled share</source>
        <translation>Part plissée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>a canopy</source>
        <translation>une voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>a line has none</source>
        <translation>une ligne n’en a pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>collider</source>
        <translation>obstacle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>control</source>
        <translation>commande</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>each of its links has its own</source>
        <translation>chacune de ses liaisons a la sienne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>each of its rods has its own</source>
        <translation>chacune de ses tiges a la sienne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>each of its springs has its own</source>
        <translation>chacun de ses ressorts a la sienne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>group</source>
        <translation>groupe</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>gusts after Dryden and measured winds have none of their own</source>
        <translation>les rafales selon Dryden et les vents mesurés n’en ont pas en propre</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>it has no guide</source>
        <translation>elle n’a pas de guide</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>it has no membrane stiffness</source>
        <translation>il n’a pas de raideur de membrane</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>it has no picture</source>
        <translation>il n’a pas d’image</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its axial, membrane or shear stiffness counts instead</source>
        <translation>sa rigidité axiale, de membrane ou de cisaillement compte à la place</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its links are all rods, which take the compliance</source>
        <translation>ses liaisons sont toutes des tiges, qui prennent la souplesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its links are all springs, which have a damping of their own</source>
        <translation>ses liaisons sont toutes des ressorts, qui ont leur propre amortissement</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its links are all springs, which take the stiffness</source>
        <translation>ses liaisons sont toutes des ressorts, qui prennent la raideur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its material never tears</source>
        <translation>son matériau ne se rompt jamais</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>its strengths are the limits</source>
        <translation>ses résistances sont les limites</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>laminate</source>
        <translation>laminé</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>links or panels, or parts and groups with some</source>
        <translation>des liaisons ou des panneaux, ou des pièces et groupes qui en ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>links, or parts and groups with some</source>
        <translation>des liaisons, ou des pièces et groupes qui en ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>material</source>
        <translation>matériau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link is a rod</source>
        <translation>aucune liaison n’est une tige</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link is made of it</source>
        <translation>aucune liaison n’en est faite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link is made of it, and no panel of it carries the pull of a fabric</source>
        <translation>aucune liaison n’en est faite, et aucun de ses panneaux ne porte la traction d’un tissu</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link of it has the role line</source>
        <translation>aucune liaison n’y a le rôle ligne</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link of it is a bias with a width, and no panel of it is elastic</source>
        <translation>aucune de ses liaisons n’est un biais avec une largeur, et aucun de ses panneaux n’est élastique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no link of it is a thread with a width, and no panel of it is elastic</source>
        <translation>aucune de ses liaisons n’est un fil avec une largeur, et aucun de ses panneaux n’est élastique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no material tears</source>
        <translation>aucun matériau ne se rompt</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no panel is made of it</source>
        <translation>aucun panneau n’en est fait</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no panel is made of it, and its links are all lines</source>
        <translation>aucun panneau n’en est fait, et ses liaisons sont toutes des lignes</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no panel of it carries the pull of a fabric</source>
        <translation>aucun de ses panneaux ne porte la traction d’un tissu</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>no part has a fabric that panels carry</source>
        <translation>aucune pièce n’a de tissu porté par des panneaux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only a discrete gust has it</source>
        <translation>seule une rafale isolée l’a</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only a discrete gust that comes again has it</source>
        <translation>seule une rafale isolée qui revient l’a</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only a measured wind has them</source>
        <translation>seul un vent mesuré les a</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only generated hills, a height field without a file, have it</source>
        <translation>seules les collines engendrées, un champ de hauteurs sans fichier, l’ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only gusts after Dryden have it</source>
        <translation>seules les rafales selon Dryden l’ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only height fields and meshes come from files</source>
        <translation>seuls champs de hauteurs et maillages viennent de fichiers</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only jets have it</source>
        <translation>seuls les jets l’ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only meshes are scaled</source>
        <translation>seuls les maillages sont mis à l’échelle</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only planes have one</source>
        <translation>seuls les plans en ont une</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only roll and angle of attack need a third particle</source>
        <translation>seuls le roulis et l’angle d’attaque demandent une troisième particule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only round shapes have one</source>
        <translation>seules les formes rondes en ont un</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only the automatic solver aims at a strain</source>
        <translation>seul le solveur automatique vise une déformation</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only the logarithmic law has one</source>
        <translation>seule la loi logarithmique en a une</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only the power law has one</source>
        <translation>seule la loi de puissance en a un</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>only the response contact bounces and rubs</source>
        <translation>seule la réponse contact rebondit et frotte</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>panel</source>
        <translation>panneau</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>panels, or parts and groups with some</source>
        <translation>des panneaux, ou des pièces et groupes qui en ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>particle</source>
        <translation>particule</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>particles, or parts and groups with some</source>
        <translation>des particules, ou des pièces et groupes qui en ont</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>planes and spheres do not turn</source>
        <translation>plans et sphères ne tournent pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>plot</source>
        <translation>graphique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>probe</source>
        <translation>sonde</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>rigidity particles hold all its links in shape</source>
        <translation>des particules de rigidité tiennent toutes ses liaisons en forme</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>rod 2</source>
        <translation>jonc 2</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>rod 3</source>
        <translation>jonc 3</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>rod 4</source>
        <translation>jonc 4</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>settings</source>
        <translation>réglages</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>silnylon</source>
        <translation>silnylon</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the air density is 0</source>
        <translation>la masse volumique de l’air est 0</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the air law does not ask for it</source>
        <translation>la loi d’air ne le demande pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the curves are not against a probe</source>
        <translation>les courbes ne sont pas tracées selon une sonde</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the curves are not against time</source>
        <translation>les courbes ne sont pas tracées selon le temps</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the line diameter is 0</source>
        <translation>le diamètre de ligne est 0</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the link has a stiffness of its own</source>
        <translation>la liaison a sa propre raideur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the link is a rod, which has a compliance</source>
        <translation>la liaison est une tige, qui a une souplesse</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the link is a spring, which has a stiffness</source>
        <translation>la liaison est un ressort, qui a une raideur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the link is no thread with a width</source>
        <translation>le lien n’est pas un fil avec une largeur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the material never tears; choose what it tears by</source>
        <translation>le matériau ne se rompt jamais ; choisir par quoi il rompt</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the paper's solver takes every rod as stiff</source>
        <translation>le solveur de l’article prend toute tige pour raide</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the part has no canopy pressure</source>
        <translation>la pièce n’a pas de pression de voilure</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the part has no panels</source>
        <translation>la pièce n’a pas de panneaux</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the part has no self-contact</source>
        <translation>la pièce n’a pas de contact avec soi</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the particle is pinned</source>
        <translation>la particule est fixée</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the path says where it is</source>
        <translation>le trajet dit où il est</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the quantity is measured, not made of others</source>
        <translation>la grandeur est mesurée, et non faite d’autres</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the quantity is not measured from somewhere</source>
        <translation>la grandeur ne se mesure pas depuis quelque part</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the quantity is that of the whole scene</source>
        <translation>la grandeur est celle de toute la scène</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>the whole scene</source>
        <translation>toute la scène</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>there are no links, and no panel is elastic</source>
        <translation>il n’y a pas de liaisons, et aucun panneau n’est élastique</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>there is nothing for the air to act on</source>
        <translation>l’air n’a rien sur quoi agir</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>this shape has none</source>
        <translation>cette forme n’en a pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>this solver makes one sweep in each substep; give it more substeps</source>
        <translation>ce solveur fait un balayage par sous-pas ; lui donner plus de sous-pas</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>this wind does not depend on the height</source>
        <translation>ce vent ne dépend pas de la hauteur</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>three particles: nose, tail and one on the right</source>
        <translation>trois particules : nez, queue et une à droite</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>two particles</source>
        <translation>deux particules</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>wood 6</source>
        <translation>bois 6</translation>
    </message>
    <message>
        <location filename="tables"/>
        <source>wood 8</source>
        <translation>bois 8</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>%1 missing (%2)</source>
        <translation>%1 manquants (%2)</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>%1 too much (%2)</source>
        <translation>%1 de trop (%2)</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>Length of line</source>
        <translation>Longueur de ligne</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>Spread the difference over the particles, in proportion to their masses, so that they weigh what they should.</source>
        <translation>Répartir la différence sur les particules, en proportion de leurs masses, pour qu’elles pèsent ce qu’elles doivent.</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>Target mass</source>
        <translation>Masse visée</translation>
    </message>
    <message>
        <location filename="target_rows.cpp"/>
        <source>on target</source>
        <translation>atteint</translation>
    </message>
    <message>
        <location filename="targets.cpp"/>
        <source>Bring mass to target</source>
        <translation>Amener la masse à la cible</translation>
    </message>
    <message>
        <location filename="targets.cpp"/>
        <source>No target mass is set.</source>
        <translation>Aucune masse cible n’est donnée.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Lines of %1 do not tear: %2 tears by its tension per width, and a line has no width. Choose force.</source>
        <translation>Les lignes de %1 ne rompent pas : %2 cède par sa tension par largeur, et une ligne n’a pas de largeur. Choisissez force.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Lines of %1 do not tear: %2 tears by strength and has no line strength. Type it, or choose another rule.</source>
        <translation>Les lignes de %1 ne rompent pas : %2 cède par résistance et n’a pas de résistance de ligne. Saisissez-la, ou choisissez une autre règle.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Spars of %1 do not snap: %2 has a breaking moment and no flexural rigidity, so that nothing resists bending. Type it.</source>
        <translation>Les longerons de %1 ne cassent pas : %2 a un moment de rupture et pas de rigidité en flexion, si bien que rien ne résiste à la flexion. Saisissez-la.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Spars of %1 do not snap: %2 tears by strength and has no breaking moment. Type it, or choose another rule.</source>
        <translation>Les longerons de %1 ne cassent pas : %2 cède par résistance et n’a pas de moment de rupture. Saisissez-le, ou choisissez une autre règle.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Threads of %1 do not tear: %2 tears by its tension per width, and some have no width. Type it, or choose force.</source>
        <translation>Les fils de %1 ne rompent pas : %2 cède par sa tension par largeur, et certains n’ont pas de largeur. Saisissez-la, ou choisissez force.</translation>
    </message>
    <message>
        <location filename="tear_check.cpp"/>
        <source>Threads of %1 do not tear: %2 tears by strength, and a thread does not say whether it is warp or weft. Have panels carry the pull, or choose tension.</source>
        <translation>Les fils de %1 ne rompent pas : %2 cède par résistance, et un fil ne dit pas s’il est de chaîne ou de trame. Faites porter la traction par les panneaux, ou choisissez tension.</translation>
    </message>
    <message>
        <location filename="temporary_folder.cpp"/>
        <source>No folder can be made beside %1: %2; make room or choose another folder.</source>
        <translation>Aucun dossier ne peut être créé à côté de %1 : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1 has %2 rows of numbers; a fit needs three or more.</source>
        <translation>%1 a %2 lignes de nombres ; il en faut au moins trois pour un ajustement.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1 has no header: begin it with a line like "force (N),elongation (mm)", or give both units of columns in this order.</source>
        <translation>%1 n’a pas d’en-tête : commencer par une ligne comme « force (N),elongation (mm) », ou donner les deux unités des colonnes dans cet ordre.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1 has no rows.</source>
        <translation>%1 n’a aucune ligne.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1 lines have an empty cell and are left out, the first of them line %2.</source>
        <translation>%1 lignes ont une cellule vide et sont omises, dont la première est la ligne %2.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1, line %2: It has %3 cells instead of %4; decimals are written with a point.</source>
        <translation>%1, ligne %2 : %3 cellules au lieu de %4 ; les décimales s’écrivent avec un point.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1, line %2: The elongation goes back. A test is one pull, from slack until it ends or breaks; leave out the way back.</source>
        <translation>%1, ligne %2 : l’allongement revient en arrière. Un essai est une seule traction, du lâche à la fin ou à la rupture ; supprimer le retour.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1, line %2: The header names no column for the %3; write "force (N),elongation (mm)" for example.</source>
        <translation>%1, ligne %2 : l’en-tête ne nomme pas de colonne pour : %3 ; écrire par exemple « force (N),elongation (mm) ».</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1: The unit of the deflection is not told: write "deflection (mm)" in the header, or give it.</source>
        <translation>%1 : l’unité de la flèche n’est pas dite : écrire « deflection (mm) » dans l’en-tête, ou la donner.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1: The unit of the elongation is not told: write "elongation (mm)" or "strain (%)" in the header, or give it.</source>
        <translation>%1 : l’unité de l’allongement n’est pas dite : écrire « elongation (mm) » ou « strain (%) » dans l’en-tête, ou la donner.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>%1: The unit of the force is not told: write "force (N)" in the header, or give it.</source>
        <translation>%1 : l’unité de la force n’est pas dite : écrire « force (N) » dans l’en-tête, ou la donner.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>Line %1 has an empty cell and is left out.</source>
        <translation>La ligne %1 a une cellule vide et est omise.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>The size of the specimen must be told: its length, and of a strip its width, above 0.</source>
        <translation>La taille de l’éprouvette doit être dite : sa longueur et, pour une bande, sa largeur, supérieures à 0.</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>elongation</source>
        <translation>allongement</translation>
    </message>
    <message>
        <location filename="test_table.cpp"/>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>All panels at the places and in the sizes that they had at first.</source>
        <translation>Tous les panneaux aux places et dans les tailles qu’ils avaient au début.</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>Dark text on a light ground.</source>
        <translation>Texte sombre sur fond clair.</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>Light or dark, as the desktop is.</source>
        <translation>Clair ou sombre, comme le bureau.</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>Light text on a dark ground.</source>
        <translation>Texte clair sur fond sombre.</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>Reset la&amp;yout</source>
        <translation>Rétablir la disposi&amp;tion</translation>
    </message>
    <message>
        <location filename="theme_rows.cpp"/>
        <source>T&amp;heme</source>
        <translation>T&amp;hème</translation>
    </message>
    <message>
        <location filename="thread_check.cpp"/>
        <source>All panels of %1 have the grain %2 degrees, which each counts from its own side ab, so that warps lie up to %3 degrees apart. For one direction on the cloth map the grain by a formula, paint it with the brush, or import the mesh with the warp turned.</source>
        <translation>Tous les panneaux de %1 ont un droit-fil de %2 degrés, que chacun compte depuis son propre côté ab, si bien que les chaînes s’écartent de jusqu’à %3 degrés. Pour une seule direction sur le tissu, donnez le droit-fil par une carte, peignez-le au pinceau, ou importez le maillage avec la chaîne tournée.</translation>
    </message>
    <message>
        <location filename="thread_check.cpp"/>
        <source>Threads of %1 pull with %2 at most, with less along lines that zigzag, and resist shear with up to %3, where %4 has %5 and %6: they are true along warp and weft of a grid of quads, and this mesh is another. Have panels carry the pull.</source>
        <translation>Les fils de %1 tirent avec %2 au plus, avec moins le long de lignes en zigzag, et résistent au cisaillement avec jusqu’à %3, alors que %4 a %5 et %6 : ils sont justes le long de la chaîne et de la trame d’une grille de quadrilatères, et ce maillage en est un autre. Faites porter la traction par les panneaux.</translation>
    </message>
    <message>
        <location filename="thread_check.cpp"/>
        <source>Threads of %1 pull with %2 at most, with less along lines that zigzag, where %3 has %4: they are true along warp and weft of a grid of quads, and this mesh is another. Have panels carry the pull.</source>
        <translation>Les fils de %1 tirent avec %2 au plus, avec moins le long de lignes en zigzag, alors que %3 a %4 : ils sont justes le long de la chaîne et de la trame d’une grille de quadrilatères, et ce maillage en est un autre. Faites porter la traction par les panneaux.</translation>
    </message>
    <message>
        <location filename="thread_check.cpp"/>
        <source>Threads of %1 pull with the membrane stiffness of %2, %3, whichever way they run; its weft stiffness of %4 is not used. Have panels carry the pull, which know warp and weft.</source>
        <translation>Les fils de %1 tirent avec la raideur de membrane de %2, %3, quel que soit leur sens ; sa raideur de trame de %4 n’est pas utilisée. Faites porter la traction par les panneaux, qui connaissent chaîne et trame.</translation>
    </message>
    <message>
        <location filename="thread_check.cpp"/>
        <source>Threads of %1 pull with up to %2 along cells that are %3 times as long as wide, instead of the membrane stiffness of %4, %5: their diagonals alone are stiffer. Make the cells squarer, or have panels carry the pull.</source>
        <translation>Les fils de %1 tirent jusqu’à %2 le long de mailles %3 fois plus longues que larges, au lieu de la raideur de membrane de %4, %5 : leurs diagonales seules sont plus raides. Rendez les mailles plus carrées, ou faites porter la traction par les panneaux.</translation>
    </message>
    <message>
        <location filename="time_left.cpp"/>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <location filename="time_left.cpp"/>
        <source>About %1 left.</source>
        <translation>Encore %1 environ.</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source> · full</source>
        <translation> · plein</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>%1 · frame %2 of %3</source>
        <translation>%1 · image %2 sur %3</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>%1, from %2</source>
        <translation>%1, à partir de %2</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>&amp;No ghost</source>
        <translation>&amp;Aucun fantôme</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>&amp;No loop</source>
        <translation>Sans &amp;boucle</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>&amp;Plot the difference</source>
        <translation>&amp;Tracer la différence</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>&amp;Remove a bookmark</source>
        <translation>&amp;Retirer un repère</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>&amp;Rename…</source>
        <translation>Reno&amp;mmer…</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>A frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>A frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Back to the event before: a tear, an edit, a hand, a control</source>
        <translation>Revenir à l’événement précédent : une déchirure, une modification, une main, une commande</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Back to the run as it stands now</source>
        <translation>Revenir à la simulation telle qu’elle est maintenant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Begin a new run at this moment, from the exact state and with the design as it is now. The run that is shown is kept.</source>
        <translation>Commencer une nouvelle simulation à ce moment, à partir de l’état exact et avec le modèle tel qu’il est maintenant. Celle qui est montrée est gardée.</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Bookmark</source>
        <translation>Repère</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Bookmark this moment</source>
        <translation>Poser un repère à cet instant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Bookmark this moment, or go to one that has a bookmark</source>
        <translation>Poser un repère à cet instant, ou aller à un repère</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Continue from here</source>
        <translation>Continuer d’ici</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>From &amp;here on</source>
        <translation>À partir d'&amp;ici</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>In memory: %1, on disk: %2</source>
        <translation>En mémoire : %1, sur le disque : %2</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Name of the bookmark:</source>
        <translation>Nom du repère :</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Name of the run:</source>
        <translation>Nom de la simulation :</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Next event</source>
        <translation>Événement suivant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>No run yet</source>
        <translation>Pas encore de simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>On to the next event</source>
        <translation>Aller à l’événement suivant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>One frame back; Shift and the left key in the timeline go ten</source>
        <translation>Une image en arrière ; Maj et la touche gauche dans la chronologie en font dix</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>One frame on</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Play a range again and again</source>
        <translation>Rejouer une plage encore et encore</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Previous event</source>
        <translation>Événement précédent</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Re&amp;move this run</source>
        <translation>&amp;Supprimer cette simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Rename or remove the run</source>
        <translation>Renommer ou supprimer la simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Rename the run</source>
        <translation>Renommer la simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Show another run at the same time as a ghost</source>
        <translation>Montrer une autre simulation en même temps comme un fantôme</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>The runs that are kept</source>
        <translation>Les simulations gardées</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>There is no other run yet: reset and play again, continue from here, or open a recording</source>
        <translation>Il n’y a pas encore d’autre simulation : réinitialiser et relancer, continuer d’ici, ou ouvrir un enregistrement</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>This run</source>
        <translation>Cette simulation</translation>
    </message>
    <message>
        <location filename="timeline.cpp"/>
        <source>Up &amp;to here</source>
        <translation>&amp;Jusqu’ici</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>&amp;Continue from here</source>
        <translation>&amp;Continuer d’ici</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>&amp;Next event</source>
        <translation>É&amp;vénement suivant</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>&amp;Play back</source>
        <translation>&amp;Rejouer</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>&amp;Show the timeline</source>
        <translation>&amp;Montrer la chronologie</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>A frame &amp;back</source>
        <translation>Une image en a&amp;rrière</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>A frame &amp;on</source>
        <translation>Une image en a&amp;vant</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Back to the &amp;run</source>
        <translation>Revenir à la si&amp;mulation</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Back to the bookmark before.</source>
        <translation>Revenir au repère précédent.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Back to the tear, edit, hand or control before.</source>
        <translation>Revenir à la déchirure, la modification, la main ou la commande précédente.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Begin a new run at this moment, with the design as it is now. The run that is shown is kept.</source>
        <translation>Commencer une nouvelle simulation à ce moment, avec le modèle tel qu’il est maintenant. Celle qui est montrée est gardée.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Book&amp;mark this moment…</source>
        <translation>&amp;Poser un repère ici…</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>C&amp;ompare with…</source>
        <translation>C&amp;omparer avec…</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Forget the run that is shown; the design stays as it is.</source>
        <translation>Oublier la simulation montrée ; le modèle reste tel quel.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Give the run that is shown another name.</source>
        <translation>Donner un autre nom à la simulation montrée.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Give this moment a name, to find it again.</source>
        <translation>Donner un nom à ce moment, pour le retrouver.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>How much of a run stays in memory before it goes to the disk.</source>
        <translation>Combien d’une simulation reste en mémoire avant d’aller sur le disque.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Look at the frame before.</source>
        <translation>Regarder l’image précédente.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Look at the next frame.</source>
        <translation>Regarder l’image suivante.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Look back at runs: every moment is kept.</source>
        <translation>Revoir les simulations : chaque moment est gardé.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Loop &amp;from here on</source>
        <translation>Boucle à partir d’&amp;ici</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Loop up &amp;to here</source>
        <translation>Boucle &amp;jusqu’ici</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>M&amp;emory for recordings…</source>
        <translation>Mémoire des &amp;enregistrements…</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Next boo&amp;kmark</source>
        <translation>Repère &amp;suivant</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>No &amp;loop</source>
        <translation>Sans bouc&amp;le</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>On to the next bookmark.</source>
        <translation>Aller au repère suivant.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>On to the next tear, edit, hand or control.</source>
        <translation>Aller à la déchirure, la modification, la main ou la commande suivante.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Play the recording back from where you look, or hold it.</source>
        <translation>Rejouer l’enregistrement à partir de ce moment, ou le suspendre.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Playback ends where the run does.</source>
        <translation>La lecture s’arrête où la simulation finit.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Playback repeats what follows this moment.</source>
        <translation>La lecture répète ce qui suit cet instant.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Playback repeats what was before this moment.</source>
        <translation>La lecture répète ce qui précède cet instant.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Pre&amp;vious event</source>
        <translation>Événement &amp;précédent</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Previous bookm&amp;ark</source>
        <translation>Repère préc&amp;édent</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Remove this run</source>
        <translation>Supprimer cette simulation</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Rename the r&amp;un…</source>
        <translation>Reno&amp;mmer la simulation…</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Show another run at the same time as a ghost, and plot how far the two are apart.</source>
        <translation>Montrer une autre simulation au même instant, comme un fantôme, et tracer l’écart entre les deux.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Show the run as it stands now.</source>
        <translation>Montrer la simulation telle qu’elle est maintenant.</translation>
    </message>
    <message>
        <location filename="timeline_rows.cpp"/>
        <source>Ti&amp;meline</source>
        <translation>&amp;Chronologie</translation>
    </message>
    <message>
        <location filename="timeline_strip.cpp"/>
        <source>%1 s: bookmark “%2”</source>
        <translation>%1 s : repère « %2 »</translation>
    </message>
    <message>
        <location filename="timeline_strip.cpp"/>
        <source>Drag to look back. Left and right: a frame, with Shift ten. Page up and down: events. Wheel: zoom.</source>
        <translation>Glisser pour regarder en arrière. Gauche et droite : une image, avec Maj dix. Page préc. et suiv. : événements. Molette : zoom.</translation>
    </message>
    <message>
        <location filename="timeline_strip.cpp"/>
        <source>Nothing is recorded yet. Play (Space), and every moment is kept here to look back at.</source>
        <translation>Rien n’est encore enregistré. Lancer (Espace), et chaque moment est gardé ici pour être revu.</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>&amp;Polar of an air law</source>
        <translation>&amp;Polaire d’une loi d’air</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>&amp;Table of numbers</source>
        <translation>&amp;Tableau des nombres</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>Find a propert&amp;y</source>
        <translation>Trouver une propri&amp;été</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>Material from a &amp;test…</source>
        <translation>Matériau d’après un &amp;essai…</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>Particles, links, lines, panels and materials as a spreadsheet.</source>
        <translation>Particules, liaisons, lignes, panneaux et matériaux comme dans un tableur.</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>Search the inspector for a property by its name or its help.</source>
        <translation>Chercher une propriété dans l’inspecteur par son nom ou son aide.</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>Stiffness and strength of an own material from a table of force and elongation (CSV).</source>
        <translation>Raideur et résistance d’un matériau à soi, d’après un tableau de force et d’allongement (CSV).</translation>
    </message>
    <message>
        <location filename="tool_rows.cpp"/>
        <source>What the air law of a material does to a flat plate, beside published curves.</source>
        <translation>Ce que la loi d’air d’un matériau fait à une plaque plane, à côté de courbes publiées.</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>%1 as it comes</source>
        <translation>%1, tel quel</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>%1 of links</source>
        <translation>%1 de liaisons</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>%1 on guides</source>
        <translation>%1 sur des guides</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>%1 pinned</source>
        <translation>%1 fixées</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>Built by %1</source>
        <translation>Construit par %1</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>Centre of gravity %1, inertia %2</source>
        <translation>Centre de gravité %1, inertie %2</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>Change it with Insert &gt; Change parameters.</source>
        <translation>Pour le changer : Insertion &gt; Changer les paramètres.</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>Used by %1</source>
        <translation>Utilisé par %1</translation>
    </message>
    <message>
        <location filename="totals.cpp"/>
        <source>Used by nothing yet</source>
        <translation>Pas encore utilisé</translation>
    </message>
    <message>
        <location filename="tour.cpp"/>
        <source>&amp;Back</source>
        <comment>to the stop before</comment>
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <location filename="tour.cpp"/>
        <source>&amp;Done</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <location filename="tour.cpp"/>
        <source>&amp;End the tour</source>
        <translation>&amp;Quitter la visite</translation>
    </message>
    <message>
        <location filename="tour.cpp"/>
        <source>&amp;Next</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <location filename="transform.cpp"/>
        <source>%1 colliders</source>
        <translation>%1 obstacles</translation>
    </message>
    <message>
        <location filename="transform.cpp"/>
        <source>%1 particles</source>
        <translation>%1 particules</translation>
    </message>
    <message>
        <location filename="transform.cpp"/>
        <source>1 collider</source>
        <translation>1 obstacle</translation>
    </message>
    <message>
        <location filename="transform.cpp"/>
        <source>1 particle</source>
        <translation>1 particule</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>A particle…</source>
        <translation>Une particule…</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Angle about %1, in degrees. Enter applies it.</source>
        <translation>Angle autour de %1, en degrés. Entrée l’applique.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Centre of mass</source>
        <translation>Centre de masse</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Ctrl: grid</source>
        <translation>Ctrl : grille</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Ctrl: particle</source>
        <translation>Ctrl : particule</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Factor along %1; 1 changes nothing. Enter applies it.</source>
        <translation>Facteur le long de %1 ; 1 ne change rien. Entrée l’applique.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>How far along %1, in metres. Enter applies it.</source>
        <translation>Distance le long de %1, en mètres. Entrée l’applique.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Keep lengths</source>
        <translation>Garder les longueurs</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Median</source>
        <translation>Point médian</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Middle of the box</source>
        <translation>Milieu de la boîte</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Own axes</source>
        <translation>Axes propres</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Rebind lengths</source>
        <translation>Recaler les longueurs</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Rest lengths</source>
        <translation>Longueurs au repos</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>View axes</source>
        <translation>Axes de la vue</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>What a drag snaps to while Ctrl is held.</source>
        <translation>Sur quoi le geste s’aimante tant que Ctrl est tenu.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>What becomes of the rest lengths of links: they stay, so that what is pulled apart is under load, or they become the new distances, so that the design is free of load.</source>
        <translation>Ce que deviennent les longueurs au repos des liaisons : elles restent, et ce qui est étiré est sous charge ; ou elles deviennent les nouvelles distances, et le modèle est sans charge.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>What it turns and scales about: it stays where it is. "A particle…" waits for a click on one.</source>
        <translation>Ce autour de quoi l’on tourne et met à l’échelle : ce point reste en place. « Une particule… » attend un clic sur l’une d’elles.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>What x, y and z are: the axes of the world; the selection's own, x along it and z across it; or right, up and towards you in the view.</source>
        <translation>Ce que sont x, y et z : les axes du monde ; ceux de la sélection, x le long et z en travers ; ou à droite, en haut et vers vous dans la vue.</translation>
    </message>
    <message>
        <location filename="transform_bar.cpp"/>
        <source>World axes</source>
        <translation>Axes du monde</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>A run is shown. Reset (Ctrl+R) goes back to the design.</source>
        <translation>Une simulation est montrée. Réinitialiser (Ctrl+R) revient au modèle.</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>Click the particle that is to stay where it is.</source>
        <translation>Cliquer la particule qui doit rester en place.</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>Rotate %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>Scale %1</source>
        <translation>Mettre à l’échelle %1</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>The simulation is back at its start, where the design is shaped.</source>
        <translation>La simulation est revenue à son départ, où le modèle est façonné.</translation>
    </message>
    <message>
        <location filename="transform_tool.cpp"/>
        <source>There is no particle here. Click the one that is to stay.</source>
        <translation>Il n’y a pas de particule ici. Cliquer celle qui doit rester.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>%1 substeps</source>
        <translation>%1 sous-pas</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>1 substep</source>
        <translation>1 sous-pas</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Back to the design: the run is thrown away, controls return to zero.</source>
        <translation>Revenir au modèle : la simulation est jetée, les commandes reviennent à zéro.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Beside what the design has, the steps have damped its motion of the last ten seconds by %1 % of critical.</source>
        <translation>En plus de l’amortissement du modèle, les pas ont amorti son mouvement des dix dernières secondes de %1 % de l’amortissement critique.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Edit: what you see is the design. Play starts from here.</source>
        <translation>Édition : ce que vous voyez est le modèle. Lancer part d’ici.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Error of the pulls in links in the last step, against what their stiffness says: %1 %, wanted %2 %. Largest strain of rods that never stretch: %3 %, wanted %4 %.</source>
        <translation>Erreur des tractions dans les liaisons au dernier pas, par rapport à ce que dit leur raideur : %1 %, voulu %2 %. Plus grande déformation des tiges qui ne s’étirent jamais : %3 %, voulu %4 %.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>One time step, then pause. Repeats while it is held down.</source>
        <translation>Un pas de temps, puis pause. Se répète tant qu’il est tenu.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Parts that each time step is cut into</source>
        <translation>Parties en lesquelles chaque pas de temps est coupé</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Parts that the automatic solver cuts each time step into, lately. It began so: %1.</source>
        <translation>Parties en lesquelles le solveur automatique coupe chaque pas de temps, dernièrement. Il a commencé ainsi : %1.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Past</source>
        <translation>Passé</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Past: what you see is a moment of a recording. Continue from here begins a new run at it; Live goes back to the run.</source>
        <translation>Passé : ce que vous voyez est un instant d’un enregistrement. Continuer d’ici y commence une nouvelle simulation ; Direct revient à la simulation.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Pause: the recording stands still.</source>
        <translation>Pause : l’enregistrement s’arrête.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Pause: the run stands still and can be played on.</source>
        <translation>Pause : la simulation est suspendue et peut être reprise.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Play</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Play the recording back from where you look (Shift+Space). The Space key leaves it and goes on with the run.</source>
        <translation>Rejouer l’enregistrement à partir d’ici (Maj+Espace). La touche Espace le quitte et continue la simulation.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Play: run the simulation from where it stands.</source>
        <translation>Lancer : faire tourner la simulation d’où elle en est.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Run: what you see is the simulation. Reset returns to the design; properties can be edited in both.</source>
        <translation>Simulation : ce que vous voyez est la simulation. Réinitialiser revient au modèle ; les propriétés peuvent être modifiées dans les deux.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Simulated seconds per second of the clock, also of a recording that is played back</source>
        <translation>Secondes simulées par seconde d’horloge, aussi pour un enregistrement rejoué</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Simulated seconds per second of the clock, lately</source>
        <translation>Secondes simulées par seconde d’horloge, dernièrement</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Simulated seconds per second of the clock, lately: this machine cannot reach the %1 that is asked for.</source>
        <translation>Secondes simulées par seconde d’horloge, dernièrement : cette machine n’atteint pas les %1 demandées.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Simulated time since the start</source>
        <translation>Temps simulé depuis le départ</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>Swings of up to %1 Hz keep their frequency within 1 % at this step, and their height from one to the next; faster ones come out with another frequency, or die away. A shorter time step tells them.</source>
        <translation>À ce pas, les oscillations jusqu’à %1 Hz gardent leur fréquence à 1 % près, et leur hauteur de l’une à la suivante ; les plus rapides sortent à une autre fréquence, ou s’éteignent. Un pas de temps plus court les rend.</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>as fast as possible</source>
        <translation>aussi vite que possible</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>error %1 %</source>
        <translation>erreur %1 %</translation>
    </message>
    <message>
        <location filename="transport.cpp"/>
        <source>more than 100</source>
        <translation>plus de 100</translation>
    </message>
    <message>
        <location filename="tuning.cpp"/>
        <source>%1 slider</source>
        <translation>Curseur de %1</translation>
    </message>
    <message>
        <location filename="tuning.cpp"/>
        <source>Drag to tune %1 while it flies.</source>
        <translation>Faire glisser pour régler %1 pendant le vol.</translation>
    </message>
    <message numerus="yes">
        <location filename="tuning_panel.cpp"/>
        <source>%n differ(s) from %1</source>
        <translation>
            <numerusform>%n diffère de %1</numerusform>
            <numerusform>%n diffèrent de %1</numerusform>
        </translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>&amp;Keep</source>
        <translation>&amp;Retenir</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Add the &amp;usual ones</source>
        <translation>Ajouter les &amp;habituels</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Make the present values those that Reset goes back to. They are in the scene already: each drag was an edit, and saving writes them.</source>
        <translation>Faire des valeurs actuelles celles auxquelles Ramener revient. Elles sont déjà dans la scène : chaque geste était une modification, et enregistrer les écrit.</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>No sliders yet. Press the slider sign beside a property in the inspector, or Ctrl+T in its field: the slider stays here, whatever is selected, and acts while the design flies.</source>
        <translation>Pas encore de curseurs. Appuyer sur le signe de curseur à côté d’une propriété dans l’inspecteur, ou Ctrl+T dans son champ : le curseur reste ici, quoi qui soit sélectionné, et agit pendant que le modèle vole.</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Rese&amp;t</source>
        <translation>Ra&amp;mener</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Reset sliders</source>
        <translation>Ramener les curseurs</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Tuning set A</source>
        <translation>Jeu de réglages A</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Tuning set B</source>
        <translation>Jeu de réglages B</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>Two sets of values, to compare: what you tune belongs to the one that is pressed. Ctrl+Shift+T switches.</source>
        <translation>Deux jeux de valeurs, à comparer : ce que l’on règle appartient à celui qui est enfoncé. Ctrl+Maj+T bascule.</translation>
    </message>
    <message>
        <location filename="tuning_panel.cpp"/>
        <source>as %1</source>
        <translation>comme %1</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>%1 %2: %3</source>
        <translation>%1 %2 : %3</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>%1: the range %2.</source>
        <translation>%1 : la plage %2.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Does nothing now: %1.</source>
        <translation>Sans effet pour l’instant : %1.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>E t of the weft</source>
        <translation>E t de la trame</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Equal ways of the slider are equal factors, not equal differences.</source>
        <translation>Des trajets égaux du curseur sont des facteurs égaux, et non des différences égales.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Left end</source>
        <translation>Extrémité gauche</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Left end of the slider; type another one. A logarithmic slider that begins below 1 gives 0 there.</source>
        <translation>Extrémité gauche du curseur ; en taper une autre. Un curseur logarithmique qui commence sous 1 y donne 0.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Of %1.</source>
        <translation>De %1.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Remove slider for %1</source>
        <translation>Retirer le curseur pour %1</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Right end</source>
        <translation>Extrémité droite</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Right end of the slider; type another one.</source>
        <translation>Extrémité droite du curseur ; en taper une autre.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Take this slider away. The value stays as it is.</source>
        <translation>Retirer ce curseur. La valeur reste telle quelle.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>Takes effect on reset.</source>
        <translation>Prend effet à la réinitialisation.</translation>
    </message>
    <message>
        <location filename="tuning_row.cpp"/>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>&amp;Keep slider values</source>
        <translation>Retenir les va&amp;leurs des curseurs</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>&amp;Run</source>
        <translation>Si&amp;mulation</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Add the &amp;usual sliders</source>
        <translation>Ajouter les curseurs &amp;usuels</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>All sliders back to the values they had when they were added or last kept.</source>
        <translation>Tous les curseurs reviennent aux valeurs qu’ils avaient à leur ajout ou à la dernière retenue.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Fly the design many times with other values, and see for which of them it holds.</source>
        <translation>Faire voler le modèle de nombreuses fois avec d’autres valeurs, et voir pour lesquelles il tient.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Go to the other set of slider values, to compare the two.</source>
        <translation>Passer à l’autre jeu de valeurs des curseurs, pour comparer les deux.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Make the present values those that resetting the sliders goes back to.</source>
        <translation>Faire des valeurs actuelles celles auxquelles les curseurs reviennent.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Open a study…</source>
        <translation>Ouvrir une étude…</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Re&amp;set sliders</source>
        <translation>Ramener les cur&amp;seurs</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>See the map of a study that was saved, or fly what is missing of it.</source>
        <translation>Voir la carte d’une étude enregistrée, ou faire voler ce qui y manque.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Show the sliders that tune the design while it flies.</source>
        <translation>Montrer les curseurs qui règlent le modèle pendant qu’il vole.</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Sl&amp;iders</source>
        <translation>C&amp;urseurs</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Stu&amp;dy</source>
        <translation>É&amp;tude</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Switch &amp;A and B</source>
        <translation>&amp;Basculer entre A et B</translation>
    </message>
    <message>
        <location filename="tuning_rows.cpp"/>
        <source>Wind, E t, G t, EA, EI and strength of what materials are, stiffness, damping and tear limit of what they are not, and the settings of the solver, as far as they have an effect here. Of what is selected only, if it is made of something.</source>
        <translation>Vent, E t, G t, EA, EI et résistance des matériaux réels, raideur, amortissement et limite de déchirure des autres, et réglages du solveur, dans la mesure où ils ont un effet ici. De ce qui est sélectionné seulement, si cela est fait de quelque chose.</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be a number in %1</source>
        <translation>doit être un nombre en %1</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be a number without a unit</source>
        <translation>doit être un nombre sans unité</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be a sum of numbers in one kind of unit</source>
        <translation>doit être une somme de nombres d’une même sorte d’unité</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be a sum of numbers in one kind of unit, such as %1</source>
        <translation>doit être une somme de nombres d’une même sorte d’unité, comme %1</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be in %1</source>
        <translation>doit être en %1</translation>
    </message>
    <message>
        <location filename="typed_number.cpp"/>
        <source>must be written with %1 or %2, as the comma may mean either</source>
        <translation>doit s’écrire avec %1 ou %2, car la virgule peut signifier l’un ou l’autre</translation>
    </message>
    <message>
        <location filename="typed_parameters.cpp"/>
        <source>"%1" sets nothing; write KEY=VALUE, like span=2.4.</source>
        <translation>« %1 » ne règle rien ; écrire CLÉ=VALEUR, comme span=2.4.</translation>
    </message>
    <message>
        <location filename="typed_parameters.cpp"/>
        <source>%1 %2, not "%3".</source>
        <translation>%1 %2, et non « %3 ».</translation>
    </message>
    <message>
        <location filename="typed_parameters.cpp"/>
        <source>%1 is given twice.</source>
        <translation>%1 est donné deux fois.</translation>
    </message>
    <message>
        <location filename="typed_parameters.cpp"/>
        <source>%1 must be one of %2, not "%3".</source>
        <translation>%1 doit être l’un de %2, et non « %3 ».</translation>
    </message>
    <message>
        <location filename="typed_parameters.cpp"/>
        <source>%1: cannot read the file %2.</source>
        <translation>%1 : le fichier %2 ne peut pas être lu.</translation>
    </message>
    <message>
        <location filename="unknown.cpp"/>
        <source>%1 and others, %2 in all</source>
        <translation>%1 et d’autres, %2 en tout</translation>
    </message>
    <message>
        <location filename="unknown.cpp"/>
        <source>%1: this version does not know the key "%2"; it is kept as it is and does nothing.</source>
        <translation>%1 : cette version ne connaît pas la clé « %2 » ; elle est gardée telle quelle et ne fait rien.</translation>
    </message>
    <message>
        <location filename="unknown.cpp"/>
        <source>%1: this version does not know the key "%2"; it is kept as it is and does nothing. Did you mean "%3"?</source>
        <translation>%1 : cette version ne connaît pas la clé « %2 » ; elle est gardée telle quelle et ne fait rien. Vouliez-vous dire « %3 » ?</translation>
    </message>
    <message>
        <location filename="unknown.cpp"/>
        <source>Item %1 is of the type %2, which this version does not know; it is kept as it is and does nothing.</source>
        <translation>Élément %1 : sa sorte, %2, est inconnue de cette version ; il est gardé et ne fait rien.</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>%1.%2 %3, not "%4"</source>
        <translation>%1.%2 %3, et non « %4 »</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a colour as #rrggbb</source>
        <translation>doit être une couleur comme #rrvvbb</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a finite number</source>
        <translation>doit être un nombre fini</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a list of ids</source>
        <translation>doit être une liste d’ids</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a number</source>
        <translation>doit être un nombre</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a text</source>
        <translation>doit être un texte</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be a whole number</source>
        <translation>doit être un nombre entier</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be above %1</source>
        <translation>doit être au-dessus de %1</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be an id</source>
        <translation>doit être un id</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be at least %1</source>
        <translation>doit être au moins %1</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be at most %1</source>
        <translation>doit être au plus %1</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be finite numbers (row %1)</source>
        <translation>doit être des nombres finis (rang %1)</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be nothing</source>
        <translation>doit être vide</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be one of %1</source>
        <translation>doit être l’un de %1</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be rows of numbers</source>
        <translation>doit être des rangs de nombres</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be three finite numbers</source>
        <translation>doit être trois nombres finis</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be three numbers</source>
        <translation>doit être trois nombres</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must be true or false</source>
        <translation>doit être vrai ou faux</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must have %1 numbers in each row (row %2)</source>
        <translation>doit avoir %1 nombres dans chaque rang (rang %2)</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must have angles that rise from row to row, between 0 and 90 (row %1)</source>
        <translation>doit avoir des angles qui croissent de rang en rang, entre 0 et 90 (rang %1)</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must have drag of at least 0 (row %1)</source>
        <translation>doit avoir une traînée d’au moins 0 (rang %1)</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>must have times that rise from row to row (row %1)</source>
        <translation>doit avoir des temps qui croissent d’une ligne à l’autre (ligne %1)</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>needs a row</source>
        <translation>demande un rang</translation>
    </message>
    <message>
        <location filename="value.cpp"/>
        <source>needs a value</source>
        <translation>demande une valeur</translation>
    </message>
    <message>
        <location filename="value_bar.cpp"/>
        <source>%1 m of at most %2 m either way; told to go to %3 m</source>
        <translation>%1 m sur %2 m au plus de part et d’autre ; consigne %3 m</translation>
    </message>
    <message numerus="yes">
        <location filename="variable_row.cpp"/>
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>At least one value is needed.</source>
        <translation>Il faut au moins une valeur.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Drawn from the distribution in the file.</source>
        <translation>Tirée de la distribution du fichier.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Even factors from value to value instead of even differences.</source>
        <translation>Des facteurs égaux d’une valeur à l’autre au lieu de différences égales.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Even factors have to begin above 0.</source>
        <translation>Des facteurs égaux doivent commencer au-dessus de 0.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>How many values, both ends included.</source>
        <translation>Combien de valeurs, les deux bouts compris.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Sets %1</source>
        <translation>Règle %1</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>The second number has to be larger than the first.</source>
        <translation>Le second nombre doit être plus grand que le premier.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Values, with a semicolon between two.</source>
        <translation>Des valeurs, séparées par un point-virgule.</translation>
    </message>
    <message>
        <location filename="variable_row.cpp"/>
        <source>Vary it no more.</source>
        <translation>Ne plus la faire varier.</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>&amp;Measured data</source>
        <translation>&amp;Données mesurées</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Case</source>
        <translation>Cas</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Cases whose answer is known from theory or a publication. The same engine that flies your scene must find it, within the tolerance that stands beside it.</source>
        <translation>Des cas dont la réponse est connue par la théorie ou une publication. Le moteur qui fait voler votre scène doit la trouver, à la tolérance indiquée à côté.</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Expected</source>
        <translation>Attendu</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Got</source>
        <translation>Obtenu</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Got / published</source>
        <translation>Obtenu / publié</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Known &amp;answers</source>
        <translation>&amp;Réponses connues</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Published</source>
        <translation>Publié</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Published by</source>
        <translation>Publié par</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Simulated as</source>
        <translation>Simulé comme</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <location filename="verification_dialog.cpp"/>
        <source>What designs of the builders do beside what was measured of real ones. Nothing is tuned: a ratio far from one says what the present laws cannot do.</source>
        <translation>Ce que font les modèles des générateurs à côté de ce qui a été mesuré sur de vrais. Rien n’est ajusté : un rapport loin de un dit ce que les lois actuelles ne savent pas faire.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Arrows</source>
        <translation>&amp;Flèches</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Back</source>
        <translation>De de&amp;rrière</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Corner</source>
        <translation>De trois &amp;quarts</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Fit</source>
        <translation>Tout voi&amp;r</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Left</source>
        <translation>De &amp;gauche</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Look from</source>
        <translation>&amp;Regarder de</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;None</source>
        <translation>A&amp;ucune</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Tension</source>
        <translation>&amp;Tension</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Top</source>
        <translation>De &amp;dessus</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>&amp;Velocity</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Botto&amp;m</source>
        <translation>De desso&amp;us</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by &amp;material</source>
        <translation>Colorer par &amp;matériau</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by &amp;strain</source>
        <translation>Colorer par dé&amp;formation</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by fabric stress</source>
        <translation>Colorer par contrainte du tissu</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by grain</source>
        <translation>Colorer par droit-fil</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by margin</source>
        <translation>Colorer par marge</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by panel loa&amp;d</source>
        <translation>Colorer par c&amp;harge des panneaux</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by s&amp;peed</source>
        <translation>Colorer par vit&amp;esse</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by stiffness factor</source>
        <translation>Colorer par facteur de raideur</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by strength factor</source>
        <translation>Colorer par facteur de résistance</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by t&amp;ension</source>
        <translation>Colorer par t&amp;ension</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by tea&amp;r limit</source>
        <translation>Colorer par &amp;limite de rupture</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Colour by wrinkles</source>
        <translation>Colorer par plis</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw a dot at each particle.</source>
        <translation>Dessiner un point à chaque particule.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw an arrow for the wind.</source>
        <translation>Dessiner une flèche pour le vent.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw arrows for the wind all around the design.</source>
        <translation>Dessiner des flèches de vent tout autour du modèle.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw springs, rods and lines.</source>
        <translation>Dessiner les ressorts, les tiges et les lignes.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw the fabric.</source>
        <translation>Dessiner le tissu.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw the links that stand for fabric on it, as wires; those that show a quantity always are.</source>
        <translation>Dessiner en fils, sur le tissu, les liens qui en tiennent lieu ; ceux qui montrent une grandeur le sont toujours.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw the warp of elastic panels as short strokes.</source>
        <translation>Dessiner la chaîne des panneaux élastiques par de petits traits.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw the ways that the selected particles have come in the last five seconds; of those that probes look at when none is selected.</source>
        <translation>Tracer le chemin des particules sélectionnées pendant les cinq dernières secondes ; sans sélection, de celles que regardent les sondes.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Draw who holds the line of a kite and who hangs below a glider or a parachute, 1.75 m tall.</source>
        <translation>Dessiner qui tient la ligne d’un cerf-volant et qui est suspendu sous une aile ou un parachute, à l’échelle d’une taille de 1,75 m.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>F&amp;ollow</source>
        <translation>Sui&amp;vre</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Fit sele&amp;ction</source>
        <translation>Cadrer la &amp;sélection</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Fro&amp;nt</source>
        <translation>De &amp;face</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How far links and elastic panels are stretched.</source>
        <translation>De combien les liaisons et les panneaux élastiques sont étirés.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How far the warp of elastic panels is turned from the way that the picture on the fabric goes up.</source>
        <translation>De combien la chaîne des panneaux élastiques est tournée par rapport au haut de l’image imprimée sur le tissu.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How fast each particle moves, and where to.</source>
        <translation>À quelle vitesse chaque particule se déplace, et vers où.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How fast particles move.</source>
        <translation>À quelle vitesse les particules se déplacent.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How hard each link pulls at its ends.</source>
        <translation>Avec quelle force chaque liaison tire à ses bouts.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How hard links pull.</source>
        <translation>Avec quelle force les liaisons tirent.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How hard the air pushes each panel.</source>
        <translation>Avec quelle force l’air pousse chaque panneau.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How hard the air pushes panels, per area.</source>
        <translation>Avec quelle force l’air pousse les panneaux, par unité d’aire.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How hard the fabric pulls per width: the largest tension of elastic panels, that of threads over the width that they stand for.</source>
        <translation>Traction du tissu par largeur : la plus grande tension des panneaux élastiques, celle des fils sur la largeur qu’ils représentent.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How many times as stiff elements are as their materials: reinforced and worn places.</source>
        <translation>Combien de fois les éléments sont plus raides que leurs matériaux : endroits renforcés ou usés.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How many times as strong elements are as their materials: reinforced and worn places.</source>
        <translation>Combien de fois les éléments sont plus résistants que leurs matériaux : endroits renforcés ou usés.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>How much of what it tears at each link bears.</source>
        <translation>Quelle part de sa limite de rupture porte chaque liaison.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Let short streaks drift with the wind, gusts included; they stand while the run is held.</source>
        <translation>Laisser de courtes traînées dériver avec le vent, rafales comprises ; elles s’arrêtent avec la simulation.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Load over strength of lines, cloth and spars: 1 breaks.</source>
        <translation>Charge sur résistance des lignes, toiles et longerons : rupture à 1.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from a corner above.</source>
        <translation>Regarder depuis un coin, d’en haut.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from above.</source>
        <translation>Regarder d’en haut.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from behind.</source>
        <translation>Regarder de derrière.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from below.</source>
        <translation>Regarder d’en bas.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from the front.</source>
        <translation>Regarder de face.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from the left.</source>
        <translation>Regarder depuis la gauche.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Look from the right.</source>
        <translation>Regarder depuis la droite.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Mark the centre of gravity of what is selected, or of the whole design, with its mass.</source>
        <translation>Marquer le centre de gravité de la sélection, ou de tout le modèle, avec sa masse.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>No arrows on particles, panels and links.</source>
        <translation>Aucune flèche sur les particules, panneaux et liaisons.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Nothing moves in the view but what is simulated: no streaks drift with the wind.</source>
        <translation>Rien ne bouge dans la vue que ce qui est simulé : aucune traînée ne dérive avec le vent.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>O&amp;rthographic</source>
        <translation>&amp;Orthographique</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Panel &amp;load</source>
        <translation>&amp;Charge des panneaux</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>R&amp;ight</source>
        <translation>De droi&amp;te</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Range of colours…</source>
        <translation>Intervalle des couleurs…</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Range up to the peak</source>
        <translation>Intervalle jusqu’au pic</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Reduce motion</source>
        <translation>Réduire les animations</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Sho&amp;w</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show &amp;wind</source>
        <translation>Montrer le ven&amp;t</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show centre of &amp;gravity</source>
        <translation>Montrer le centre de grav&amp;ité</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show grain</source>
        <translation>Montrer le droit-fil</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show lin&amp;ks</source>
        <translation>Montrer les &amp;liaisons</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show mesh</source>
        <translation>Afficher le maillage</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show p&amp;anels</source>
        <translation>Montrer les p&amp;anneaux</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show partic&amp;les</source>
        <translation>Montrer les &amp;particules</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show people</source>
        <translation>Afficher les personnes</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show the design as a ghost</source>
        <translation>Montrer le modèle en fantôme</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show the whole scene.</source>
        <translation>Montrer toute la scène.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show trails</source>
        <translation>Montrer les traînées</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show what &amp;probes read</source>
        <translation>Montrer ce que lisent les &amp;sondes</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show what is selected, or the whole scene when nothing is.</source>
        <translation>Montrer la sélection, ou toute la scène si rien n’est sélectionné.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show wind fiel&amp;d</source>
        <translation>Montrer le &amp;champ de vent</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Show wind streaks</source>
        <translation>Afficher les traînées de vent</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>The camera goes with the fabric.</source>
        <translation>La caméra accompagne le tissu.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>The colours of the materials.</source>
        <translation>Les couleurs des matériaux.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>The colours reach as far as the largest value. Without it 2 % of the values may lie beyond, so that a few of them do not make the rest look alike; the legend has an arrow then.</source>
        <translation>Les couleurs vont jusqu’à la plus grande valeur. Sinon 2 % des valeurs peuvent être au-delà, pour que quelques-unes ne donnent pas le même aspect à tout le reste ; la légende a alors une flèche.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>The shape as it was designed, beside what has become of it; where nothing is pinned it goes along.</source>
        <translation>La forme telle qu'elle a été dessinée, à côté de ce qu'elle est devenue ; là où rien n'est épinglé, elle suit le mouvement.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Type the values at the ends of the colours, or let them follow. A click on the colours does the same.</source>
        <translation>Saisir les valeurs aux deux bouts des couleurs, ou les laisser suivre. Un clic sur les couleurs fait de même.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Which elastic panels are slack, wrinkled or taut.</source>
        <translation>Quels panneaux élastiques sont lâches, plissés ou tendus.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Without perspective: parallels stay parallel.</source>
        <translation>Sans perspective : les parallèles restent parallèles.</translation>
    </message>
    <message>
        <location filename="view_rows.cpp"/>
        <source>Write the values of probes beside what they look at.</source>
        <translation>Écrire les valeurs des sondes à côté de ce qu’elles regardent.</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>a rod joins it to a particle of %1 times another mass; add substeps or bring the masses closer</source>
        <translation>une tige la joint à une particule de masse %1 fois différente ; ajouter des sous-pas ou rapprocher les masses</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>explicit Euler gains energy from springs at any time step; choose another integrator or add damping</source>
        <translation>Euler explicite gagne de l’énergie des ressorts à tout pas de temps ; choisir un autre intégrateur ou ajouter de l’amortissement</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>likely because %1 particles began inside obstacles, by up to %2 m; move them or the obstacles</source>
        <translation>sans doute parce que %1 particules ont commencé dans des obstacles, jusqu’à %2 m ; les déplacer, ou les obstacles</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>likely because a particle began inside an obstacle, by %1 m; move it or the obstacle</source>
        <translation>sans doute parce qu’une particule a commencé dans un obstacle, de %1 m ; la déplacer, ou l’obstacle</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>particle %1 left the range of numbers at %2 s: %3</source>
        <translation>la particule %1 a quitté le domaine des nombres à %2 s : %3</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>particle %1 reached %2 m/s, above the limit of %3 m/s, at %4 s: %5</source>
        <translation>la particule %1 a atteint %2 m/s, au-dessus de la limite de %3 m/s, à %4 s : %5</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>something pushes it harder than the time step resolves; shorten the time step or look at the forces there</source>
        <translation>quelque chose la pousse plus fort que le pas de temps ne le résout ; raccourcir le pas de temps ou regarder les forces à cet endroit</translation>
    </message>
    <message>
        <location filename="watchdog.cpp"/>
        <source>the substep of %1 s is above the %2 s that its springs allow; shorten the time step, add substeps, or lower stiffness and damping</source>
        <translation>le sous-pas de %1 s dépasse les %2 s que permettent ses ressorts ; raccourcir le pas de temps, ajouter des sous-pas, ou baisser raideur et amortissement</translation>
    </message>
    <message>
        <location filename="weigh.cpp"/>
        <source>Particle %1 weighs less than the densities of its materials say, of all panels and lines that end there: have them weigh it first, as ripstop-cli weigh does, or empty the density of the material.</source>
        <translation>La particule %1 pèse moins que ne le disent les masses surfaciques et linéiques de ses matériaux, pour tous les panneaux et lignes qui s’y terminent : faites-la d’abord peser par eux, comme le fait ripstop-cli weigh, ou videz celles du matériau.</translation>
    </message>
    <message>
        <location filename="weigh.cpp"/>
        <source>Weigh</source>
        <translation>Peser</translation>
    </message>
    <message>
        <location filename="weight.cpp"/>
        <source>weight</source>
        <translation>le poids</translation>
    </message>
    <message>
        <location filename="weight_check.cpp"/>
        <source>%1 of %2, of %3 kg, weighs %4 N, and the %5 links that hold it break at %6 N together at best: make it lighter, or the links stronger or more.</source>
        <translation>%1 de %2, de %3 kg, pèse %4 N, et les %5 liaisons qui la tiennent rompent ensemble à %6 N au mieux : allégez-la, ou mettez des liaisons plus fortes ou plus nombreuses.</translation>
    </message>
    <message>
        <location filename="weight_check.cpp"/>
        <source>%1 of %2, of %3 kg, weighs %4 N, and the link that holds it breaks at %5 N: make it lighter, or the link stronger.</source>
        <translation>%1 de %2, de %3 kg, pèse %4 N, et la liaison qui la tient rompt à %5 N : allégez-la, ou renforcez la liaison.</translation>
    </message>
    <message>
        <location filename="weld.cpp"/>
        <source>Weld</source>
        <translation>Souder</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>%1 cannot be opened: %2.</source>
        <translation>%1 ne peut pas être ouvert : %2.</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>%1 does not exist; check the path.</source>
        <translation>%1 n’existe pas ; vérifier le chemin.</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>%1 is a folder; name a file in it.</source>
        <translation>%1 est un dossier ; nommer un fichier dedans.</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>%1 is larger than 4 GiB, too large for this program.</source>
        <translation>%1 dépasse 4 Gio, trop pour ce programme.</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>%1, line 1: the file %2.</source>
        <translation>%1, ligne 1 : le fichier %2.</translation>
    </message>
    <message>
        <location filename="whole_file.cpp"/>
        <source>unknown error</source>
        <translation>erreur inconnue</translation>
    </message>
    <message>
        <location filename="wind_file.cpp"/>
        <source>Read a measured wind</source>
        <translation>Lire un vent mesuré</translation>
    </message>
    <message>
        <location filename="wind_file.cpp"/>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tableaux (*.csv *.tsv *.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="wind_record.cpp"/>
        <source>%1, line %2: "%3" is no unit for the %4; write %5.</source>
        <translation>%1, ligne %2 : « %3 » n’est pas une unité pour %4 ; écrivez %5.</translation>
    </message>
    <message>
        <location filename="wind_record.cpp"/>
        <source>%1, line %2: Begin with a line that names the columns, like "time (s),speed (m/s),direction (deg)"; without one there are two, time and speed, or four, time, x, y and z.</source>
        <translation>%1, ligne %2 : Commencez par une ligne qui nomme les colonnes, comme « time (s),speed (m/s),direction (deg) » ; sans elle il y en a deux, temps et vitesse, ou quatre, temps, x, y et z.</translation>
    </message>
    <message>
        <location filename="wind_record.cpp"/>
        <source>%1, line %2: Its time does not come after that of the row before; times are seconds that rise.</source>
        <translation>%1, ligne %2 : Son temps ne vient pas après celui de la ligne précédente ; les temps sont des secondes qui croissent.</translation>
    </message>
    <message>
        <location filename="wind_record.cpp"/>
        <source>%1, line %2: The header names no column for the %3; write "time (s),speed (m/s)" for example.</source>
        <translation>%1, ligne %2 : L’en-tête ne nomme aucune colonne pour %3 ; écrivez par exemple « time (s),speed (m/s) ».</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>Drag to turn, wheel to zoom, middle drag to move. Click selects; box and lasso are at the upper left. Keys G, R and S move, turn and scale what is selected.</source>
        <translation>Glisser pour tourner, molette pour zoomer, glisser au milieu pour déplacer. Un clic sélectionne ; rectangle et lasso sont en haut à gauche. Les touches G, R et S déplacent, tournent et mettent à l’échelle la sélection.</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>Everything else</source>
        <translation>Tout le reste</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>Fly it</source>
        <translation>Faire voler</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>New from builder begins with a whole kite, glider or parachute; Import makes fabric of a mesh; Export is for Blender and ParaView. F3 finds any action, F1 opens the manual where it tells of what is under the mouse.</source>
        <translation>Nouveau à partir d’un constructeur commence par un cerf-volant, une aile ou un parachute entier ; Importer fait du tissu d’un maillage ; Exporter sert à Blender et ParaView. F3 trouve toute action, F1 ouvre le manuel là où il parle de ce qui est sous la souris.</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>Space plays and pauses, the full stop does one step, Ctrl+R goes back to the design. Keys of the controls steer; they stand under Controls.</source>
        <translation>Espace lance et suspend, le point fait un pas, Ctrl+R revient au modèle. Les touches des commandes pilotent ; elles sont sous Commandes.</translation>
    </message>
    <message>
        <location filename="window_tour.cpp"/>
        <source>The design, and its flight</source>
        <translation>Le modèle, et son vol</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln collider(s)</source>
        <translation>
            <numerusform>%Ln obstacle</numerusform>
            <numerusform>%Ln obstacles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln control(s)</source>
        <translation>
            <numerusform>%Ln commande</numerusform>
            <numerusform>%Ln commandes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln group(s)</source>
        <translation>
            <numerusform>%Ln groupe</numerusform>
            <numerusform>%Ln groupes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln link(s)</source>
        <translation>
            <numerusform>%Ln liaison</numerusform>
            <numerusform>%Ln liaisons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln material(s)</source>
        <translation>
            <numerusform>%Ln matériau</numerusform>
            <numerusform>%Ln matériaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln panel(s)</source>
        <translation>
            <numerusform>%Ln panneau</numerusform>
            <numerusform>%Ln panneaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln pièce</numerusform>
            <numerusform>%Ln pièces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln particle(s)</source>
        <translation>
            <numerusform>%Ln particule</numerusform>
            <numerusform>%Ln particules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln plot(s)</source>
        <translation>
            <numerusform>%Ln graphique</numerusform>
            <numerusform>%Ln graphiques</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln probe(s)</source>
        <translation>
            <numerusform>%Ln sonde</numerusform>
            <numerusform>%Ln sondes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln setting(s)</source>
        <translation>
            <numerusform>%Ln réglage</numerusform>
            <numerusform>%Ln réglages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <location filename="words.cpp"/>
        <source>%Ln wind(s)</source>
        <translation>
            <numerusform>%Ln vent</numerusform>
            <numerusform>%Ln vents</numerusform>
        </translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Collider</source>
        <translation>Obstacle</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Colliders</source>
        <translation>Obstacles</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Control</source>
        <translation>Commande</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Controls</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Links</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Materials</source>
        <translation>Matériaux</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Particle</source>
        <translation>Particule</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Particles</source>
        <translation>Particules</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Plot</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Probes</source>
        <translation>Sondes</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <location filename="words.cpp"/>
        <source>Winds</source>
        <translation>Vents</translation>
    </message>
    <message>
        <location filename="work_dialog.cpp"/>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>%1 cannot be copied into the bundle: %2.</source>
        <translation>%1 ne peut pas être copié dans le dossier de la simulation : %2.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>%1 is a file; name a new folder, or a file that ends with .zip.</source>
        <translation>%1 est un fichier ; nommer un nouveau dossier, ou un fichier qui finit par .zip.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>%1 is a folder with other things in it; name a new one.</source>
        <translation>%1 est un dossier qui contient autre chose ; en nommer un nouveau.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>%1 is a folder; name a file.</source>
        <translation>%1 est un dossier ; nommer un fichier.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>%1 was not written: %2; choose another folder.</source>
        <translation>%1 n’a pas été écrit : %2 ; choisir un autre dossier.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>Name the bundle: a new folder, or a file that ends with .zip.</source>
        <translation>Nommer le dossier de la simulation : un nouveau dossier, ou un fichier qui finit par .zip.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>Nothing was flown: a bundle needs one time step at least.</source>
        <translation>Rien n’a été simulé : un dossier de la simulation demande un pas de temps au moins.</translation>
    </message>
    <message>
        <location filename="write_bundle.cpp"/>
        <source>The run cannot be kept whole: %1</source>
        <translation>La simulation ne peut pas être gardée entière : %1</translation>
    </message>
    <message>
        <location filename="zip_file.cpp"/>
        <source>%1 cannot be unpacked: %2; it is damaged or cut off, get it again.</source>
        <translation>%1 ne peut pas être décompressé : %2 ; il est abîmé ou tronqué, l’obtenir de nouveau.</translation>
    </message>
    <message>
        <location filename="zip_file.cpp"/>
        <source>%1 leads out of it</source>
        <translation>%1 en sort</translation>
    </message>
    <message>
        <location filename="zip_file.cpp"/>
        <source>%1 was not unpacked: there is far more in it than its size allows for; get it from whom you trust, and unpack it by hand.</source>
        <translation>%1 n’a pas été décompressé : il contient bien plus que sa taille ne le laisse attendre ; l’obtenir d’une source de confiance, et le décompresser à la main.</translation>
    </message>
    <message>
        <location filename="zip_file.cpp"/>
        <source>there is no room for what is unpacked</source>
        <translation>il n’y a pas de place pour ce qui est décompressé</translation>
    </message>
</context>
</TS>
