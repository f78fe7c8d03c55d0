<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Sentences that the engine composes, with gaps for what stands in them. Written by hand: the editor
     recognises a sentence by its pattern (app/language/sentences.h); one without a pattern stays English. -->
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>sentences</name>
    <!-- words that stand in gaps -->
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Particle %1</source>
        <translation>Particule %1</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Liaison %1</translation>
    </message>
    <message>
        <source>Panel %1</source>
        <translation>Panneau %1</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Pièce %1</translation>
    </message>
    <message>
        <source>Material %1</source>
        <translation>Matériau %1</translation>
    </message>
    <message>
        <source>Collider %1</source>
        <translation>Obstacle %1</translation>
    </message>
    <message>
        <source>Wind %1</source>
        <translation>Vent %1</translation>
    </message>
    <message>
        <source>Control %1</source>
        <translation>Commande %1</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>Sonde %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Groupe %1</translation>
    </message>
    <message>
        <source>particle</source>
        <translation>particule</translation>
    </message>
    <message>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>panneau</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>material</source>
        <translation>matériau</translation>
    </message>
    <message>
        <source>collider</source>
        <translation>obstacle</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <source>control</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>sonde</translation>
    </message>
    <message>
        <source>group</source>
        <translation>groupe</translation>
    </message>
    <message>
        <source>1 substep</source>
        <translation>1 sous-pas</translation>
    </message>
    <message>
        <source>%1 substeps</source>
        <translation>%1 sous-pas</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 liaison</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 liaisons</translation>
    </message>
    <message>
        <source>1 particle</source>
        <translation>1 particule</translation>
    </message>
    <message>
        <source>%1 particles</source>
        <translation>%1 particules</translation>
    </message>
    <message>
        <source>1 collider</source>
        <translation>1 obstacle</translation>
    </message>
    <message>
        <source>%1 colliders</source>
        <translation>%1 obstacles</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 ligne</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <source>1 row</source>
        <translation>1 rang</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 rangs</translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 cellule</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 cellules</translation>
    </message>
    <message>
        <source>1 column</source>
        <translation>1 colonne</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 colonnes</translation>
    </message>
    <message>
        <source>%1 particles and %2 colliders</source>
        <translation>%1 particules et %2 obstacles</translation>
    </message>
    <!-- numbers and values that are typed -->
    <message>
        <source>must be a finite number</source>
        <translation>doit être un nombre fini</translation>
    </message>
    <message>
        <source>must be above %1</source>
        <translation>doit être au-dessus de %1</translation>
    </message>
    <message>
        <source>must be at least %1</source>
        <translation>doit être au moins %1</translation>
    </message>
    <message>
        <source>must be at most %1</source>
        <translation>doit être au plus %1</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>doit être vrai ou faux</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>doit être un nombre entier</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>doit être un nombre</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>doit être un texte</translation>
    </message>
    <message>
        <source>must be three numbers</source>
        <translation>doit être trois nombres</translation>
    </message>
    <message>
        <source>must be three finite numbers</source>
        <translation>doit être trois nombres finis</translation>
    </message>
    <message>
        <source>must be an id</source>
        <translation>doit être un id</translation>
    </message>
    <message>
        <source>must be a list of ids</source>
        <translation>doit être une liste d’ids</translation>
    </message>
    <message>
        <source>must be rows of numbers</source>
        <translation>doit être des rangs de nombres</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>doit être l’un de %1</translation>
    </message>
    <message>
        <source>must be a colour as #rrggbb</source>
        <translation>doit être une couleur comme #rrvvbb</translation>
    </message>
    <message>
        <source>must be a number without a unit</source>
        <translation>doit être un nombre sans unité</translation>
    </message>
    <message>
        <source>must be a number in %1</source>
        <translation>doit être un nombre en %1</translation>
    </message>
    <message>
        <source>must be in %1</source>
        <translation>doit être en %1</translation>
    </message>
    <message>
        <source>must be a sum of numbers in one kind of unit, such as %1</source>
        <translation>doit être une somme de nombres d’une même sorte d’unité, comme %1</translation>
    </message>
    <message>
        <source>must be a sum of numbers in one kind of unit</source>
        <translation>doit être une somme de nombres d’une même sorte d’unité</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>needs a value</source>
        <translation>demande une valeur</translation>
    </message>
    <message>
        <source>needs a row</source>
        <translation>demande un rang</translation>
    </message>
    <message>
        <source>must have %1 numbers in each row (row %2)</source>
        <translation>doit avoir %1 nombres dans chaque rang (rang %2)</translation>
    </message>
    <message>
        <source>must be finite numbers (row %1)</source>
        <translation>doit être des nombres finis (rang %1)</translation>
    </message>
    <message>
        <source>must have angles that rise from row to row, between 0 and 90 (row %1)</source>
        <translation>doit avoir des angles qui croissent de rang en rang, entre 0 et 90 (rang %1)</translation>
    </message>
    <message>
        <source>must have drag of at least 0 (row %1)</source>
        <translation>doit avoir une traînée d’au moins 0 (rang %1)</translation>
    </message>
    <message>
        <source>must be times and places as 0: 0 1 0; 2.5: 3 1 0 (%1 is not)</source>
        <translation>doit être des temps et des lieux comme 0: 0 1 0; 2.5: 3 1 0 (%1 n’en est pas)</translation>
    </message>
    <message>
        <source>must have times that ascend (%1 is not later than the row before)</source>
        <translation>doit avoir des temps croissants (%1 n’est pas après le rang d’avant)</translation>
    </message>
    <message>
        <source>%1.%2 %3, not "%4"</source>
        <translation>%1.%2 %3, et non « %4 »</translation>
    </message>
    <message>
        <source>must have finite ends</source>
        <translation>doit avoir des extrémités finies</translation>
    </message>
    <message>
        <source>must rise from left to right</source>
        <translation>doit croître de gauche à droite</translation>
    </message>
    <message>
        <source>must begin above 0 to be logarithmic</source>
        <translation>doit commencer au-dessus de 0 pour être logarithmique</translation>
    </message>
    <message>
        <source>must begin at %1 or above</source>
        <translation>doit commencer à %1 ou au-dessus</translation>
    </message>
    <message>
        <source>must end at %1 or below</source>
        <translation>doit finir à %1 ou au-dessous</translation>
    </message>
    <!-- what keeps a scene from running -->
    <message>
        <source>The scene has no particles: insert a part or import a mesh.</source>
        <translation>La scène n’a pas de particules : insérer une pièce ou importer un maillage.</translation>
    </message>
    <message>
        <source>The id %1 is used twice; give one of the two another id.</source>
        <translation>L’id %1 sert deux fois ; donner un autre id à l’un des deux.</translation>
    </message>
    <message>
        <source>%1: %2 points at %3, which does not exist; choose another or remove it.</source>
        <translation>%1 : %2 désigne %3, qui n’existe pas ; en choisir un autre ou le retirer.</translation>
    </message>
    <message>
        <source>%1: %2 points at %3, which is a %4.</source>
        <translation>%1 : %2 désigne %3, qui est de la sorte : %4.</translation>
    </message>
    <message>
        <source>%1 needs two different particles as its ends; remove it.</source>
        <translation>%1 : il faut deux particules différentes à ses bouts ; la supprimer.</translation>
    </message>
    <message>
        <source>%1 needs three different particles as its corners; remove it.</source>
        <translation>%1 : il faut trois particules différentes à ses coins ; le supprimer.</translation>
    </message>
    <message>
        <source>%1 of %2 is free and has no mass: give it a mass or pin it.</source>
        <translation>%1 de %2 est libre et sans masse : lui donner une masse ou la fixer.</translation>
    </message>
    <message>
        <source>Wind %1 needs a roughness that is below its reference height.</source>
        <translation>Le vent %1 demande une rugosité inférieure à sa hauteur de référence.</translation>
    </message>
    <message>
        <source>Control %1 needs an axis that is not zero.</source>
        <translation>La commande %1 demande un axe non nul.</translation>
    </message>
    <message>
        <source>Control %1 shifts weights, and a collider has none: make it move, or remove the collider from its targets.</source>
        <translation>La commande %1 déporte des poids, et un obstacle n’en a pas : la faire déplacer, ou retirer l’obstacle de ses cibles.</translation>
    </message>
    <message>
        <source>Control %1 has no targets and does nothing.</source>
        <translation>La commande %1 n’a pas de cible et ne fait rien.</translation>
    </message>
    <message>
        <source>Probe %1 needs a target and a particle to measure from.</source>
        <translation>La sonde %1 demande une cible et une particule de référence.</translation>
    </message>
    <message>
        <source>%1 of %2 joins two particles that are joined already.</source>
        <translation>%1 de %2 joint deux particules déjà jointes.</translation>
    </message>
    <message>
        <source>%1 of %2 has no links and will fly by itself.</source>
        <translation>%1 de %2 n’a pas de liaisons et volera seule.</translation>
    </message>
    <message>
        <source>The substep of %1 s is above the %2 s that springs and bending at particle %3 may need: shorten the time step, add substeps, or lower stiffness and damping.</source>
        <translation>Le sous-pas de %1 s dépasse les %2 s que peuvent demander ressorts et flexion à la particule %3 : raccourcir le pas de temps, ajouter des sous-pas, ou baisser raideur et amortissement.</translation>
    </message>
    <message>
        <source>Part %1 %2, or set its canopyPressure to 0.</source>
        <translation>La pièce %1 %2, ou mettre sa pression de voilure à 0.</translation>
    </message>
    <message>
        <source>has canopy pressure and no panels to hold the air: add panels</source>
        <translation>a une pression de voilure et pas de panneaux pour tenir l’air : ajouter des panneaux</translation>
    </message>
    <message>
        <source>has canopy pressure, and panel %1 has a corner that is not a particle of this part: join the two parts</source>
        <translation>a une pression de voilure, et le panneau %1 a un coin qui n’est pas une particule de cette pièce : joindre les deux pièces</translation>
    </message>
    <message>
        <source>has canopy pressure, and more than two panels meet between particles %1 and %2: remove all but two of them</source>
        <translation>a une pression de voilure, et plus de deux panneaux se rejoignent entre les particules %1 et %2 : n’en garder que deux</translation>
    </message>
    <message>
        <source>has canopy pressure and fabric with one side only, like a twisted ribbon: remove a panel of the twist</source>
        <translation>a une pression de voilure et un tissu à une seule face, comme un ruban tordu : supprimer un panneau de la torsion</translation>
    </message>
    <message>
        <source>has canopy pressure and closed fabric that no air can enter: leave a mouth open</source>
        <translation>a une pression de voilure et un tissu fermé où l’air ne peut entrer : laisser une bouche ouverte</translation>
    </message>
    <message>
        <source>has canopy pressure and lies flat where the run starts, so that neither side is the inside: give it a hollow</source>
        <translation>a une pression de voilure et démarre à plat, sans intérieur d’aucun côté : lui donner un creux</translation>
    </message>
    <message>
        <source>Collider %1: its path %2.</source>
        <translation>Obstacle %1 : son trajet %2.</translation>
    </message>
    <message>
        <source>Collider %1 needs a normal that is not zero.</source>
        <translation>L’obstacle %1 demande une normale non nulle.</translation>
    </message>
    <message>
        <source>Collider %1 needs edges above 0: correct its size.</source>
        <translation>L’obstacle %1 demande des arêtes au-dessus de 0 : corriger sa taille.</translation>
    </message>
    <message>
        <source>Collider %1 needs a height above 0: correct the second number of its size.</source>
        <translation>L’obstacle %1 demande une hauteur au-dessus de 0 : corriger le deuxième nombre de sa taille.</translation>
    </message>
    <message>
        <source>Collider %1: It needs a width and a depth above 0 and a height of at least 0: correct its size.</source>
        <translation>Obstacle %1 : il faut une largeur et une profondeur au-dessus de 0 et une hauteur d’au moins 0 : corriger sa taille.</translation>
    </message>
    <message>
        <source>Collider %1: It needs a mesh: set its file to an OBJ, STL or PLY.</source>
        <translation>Obstacle %1 : il lui faut un maillage : donner comme fichier un OBJ, STL ou PLY.</translation>
    </message>
    <message>
        <source>Collider %1 is %2 m wide and the panels have edges of %3 m: it fits between particles, which are what touches; make the mesh finer or the collider larger.</source>
        <translation>L’obstacle %1 fait %2 m de large et les panneaux ont des arêtes de %3 m : il passe entre les particules, seules à toucher ; affiner le maillage ou agrandir l’obstacle.</translation>
    </message>
    <message>
        <source>Particle %1 weighs less than the density of its material says: empty the material's areal and linear density first.</source>
        <translation>La particule %1 pèse moins que ne le dit la densité de son matériau : vider d’abord la masse surfacique et linéique du matériau.</translation>
    </message>
    <message>
        <source>Probe %1 needs a third particle, on the right.</source>
        <translation>La sonde %1 demande une troisième particule, à droite.</translation>
    </message>
    <message>
        <source>The formula of probe %1 cannot be worked out: %2.</source>
        <translation>La formule de la sonde %1 ne peut pas être calculée : %2.</translation>
    </message>
    <message>
        <source>Plot %1 needs the probe that its curves are against.</source>
        <translation>Le graphique %1 demande la sonde en abscisse de ses courbes.</translation>
    </message>
    <message>
        <source>Plot %1 shows no values: its lowest has to be below its highest.</source>
        <translation>Le graphique %1 ne montre aucune valeur : sa plus basse doit être sous sa plus haute.</translation>
    </message>
    <message>
        <source>the curves are not against a probe</source>
        <translation>les courbes ne sont pas tracées selon une sonde</translation>
    </message>
    <message>
        <source>the curves are not against time</source>
        <translation>les courbes ne sont pas tracées selon le temps</translation>
    </message>
    <message>
        <source>Keep %1</source>
        <translation>Garder %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>the quantity is not measured from somewhere</source>
        <translation>la grandeur ne se mesure pas depuis quelque part</translation>
    </message>
    <message>
        <source>only roll and angle of attack need a third particle</source>
        <translation>seuls le roulis et l’angle d’attaque demandent une troisième particule</translation>
    </message>
    <message>
        <source>the quantity is measured, not made of others</source>
        <translation>la grandeur est mesurée, et non faite d’autres</translation>
    </message>
    <message>
        <source>the quantity is that of the whole scene</source>
        <translation>la grandeur est celle de toute la scène</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>Mesurer %1</translation>
    </message>
    <message>
        <source>it is empty; write one like line_tension / weight</source>
        <translation>elle est vide ; en écrire une comme line_tension / weight</translation>
    </message>
    <message>
        <source>it adds, or takes a function of, things of different units</source>
        <translation>elle additionne des choses d’unités différentes, ou en prend une fonction</translation>
    </message>
    <message>
        <source>"%1" is no other probe; names are written with _ for blanks</source>
        <translation>« %1 » n’est pas une autre sonde ; les noms s’écrivent avec _ pour les blancs</translation>
    </message>
    <!-- stability -->
    <message>
        <source>Time step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>Masses</source>
        <translation>Masses</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Tearing</source>
        <translation>Rupture</translation>
    </message>
    <message>
        <source>Double links</source>
        <translation>Liaisons doubles</translation>
    </message>
    <message>
        <source>Loose particles</source>
        <translation>Particules seules</translation>
    </message>
    <message>
        <source>The substep is %1 s and may be up to %2 s for the springs and the bending; the automatic solver keeps to it.</source>
        <translation>Le sous-pas est de %1 s et peut aller jusqu’à %2 s pour les ressorts et la flexion ; le solveur automatique s’y tient.</translation>
    </message>
    <message>
        <source>The substep is %1 s and may be up to %2 s for the springs and the bending.</source>
        <translation>Le sous-pas est de %1 s et peut aller jusqu’à %2 s pour les ressorts et la flexion.</translation>
    </message>
    <message>
        <source>1 particle needs a shorter substep than %1 s, down to %2 s.</source>
        <translation>1 particule demande un sous-pas plus court que %1 s, jusqu’à %2 s.</translation>
    </message>
    <message>
        <source>%1 particles need a shorter substep than %2 s, down to %3 s.</source>
        <translation>%1 particules demandent un sous-pas plus court que %2 s, jusqu’à %3 s.</translation>
    </message>
    <message>
        <source>Take %1 substeps</source>
        <translation>Prendre %1 sous-pas</translation>
    </message>
    <message>
        <source>The ends of a rod differ in mass by a factor of up to %1, which this solver can follow.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1, ce que ce solveur peut suivre.</translation>
    </message>
    <message>
        <source>The ends of a rod differ in mass by a factor of up to %1, and sweeps lift a heavy end by a light one only slowly: even the masses out, or choose the automatic solver.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1, et les balayages ne soulèvent que lentement un bout lourd par un bout léger : égaliser les masses, ou choisir le solveur automatique.</translation>
    </message>
    <message>
        <source>The ends of a rod differ in mass by a factor of up to %1.</source>
        <translation>Les bouts d’une tige diffèrent en masse d’un facteur allant jusqu’à %1.</translation>
    </message>
    <message>
        <source>Choose the automatic solver</source>
        <translation>Choisir le solveur automatique</translation>
    </message>
    <message>
        <source>A pull has to pass %1 to cross the network; the direct solver takes it there at once.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau ; le solveur direct l’y porte d’un coup.</translation>
    </message>
    <message>
        <source>A pull has to pass %1 to cross the network; this solver takes it far in each sweep.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau ; ce solveur la porte loin à chaque balayage.</translation>
    </message>
    <message>
        <source>A pull has to pass %1 to cross the network, and %2 sweeps in %3 take it past %4 in each time step: it will look elastic.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau, et %2 balayages en %3 la portent au-delà de %4 à chaque pas de temps : il paraîtra élastique.</translation>
    </message>
    <message>
        <source>A pull has to pass %1 to cross the network, and %2 sweeps in %3 take it past %4 in each time step.</source>
        <translation>Une traction doit passer %1 pour traverser le réseau, et %2 balayages en %3 la portent au-delà de %4 à chaque pas de temps.</translation>
    </message>
    <message>
        <source>Make %1 sweeps</source>
        <translation>Faire %1 balayages</translation>
    </message>
    <message>
        <source>1 link is longer at the start than at rest by more than %1 %, up to %2 %.</source>
        <translation>1 liaison est plus longue au départ qu’au repos de plus de %1 %, jusqu’à %2 %.</translation>
    </message>
    <message>
        <source>%1 links are longer at the start than at rest by more than %2 %, up to %3 %.</source>
        <translation>%1 liaisons sont plus longues au départ qu’au repos de plus de %2 %, jusqu’à %3 %.</translation>
    </message>
    <message>
        <source>Rest as they start</source>
        <translation>Au repos comme elles démarrent</translation>
    </message>
    <message>
        <source>No link is longer at the start than at rest.</source>
        <translation>Aucune liaison n’est plus longue au départ qu’au repos.</translation>
    </message>
    <message>
        <source>Links are at most %1 % longer at the start than at rest.</source>
        <translation>Les liaisons sont au plus %1 % plus longues au départ qu’au repos.</translation>
    </message>
    <message>
        <source>1 link is beyond the tear limit at the start and will tear in the first step.</source>
        <translation>1 liaison dépasse la limite de rupture au départ et rompra au premier pas.</translation>
    </message>
    <message>
        <source>%1 links are beyond the tear limit at the start and will tear in the first step.</source>
        <translation>%1 liaisons dépassent la limite de rupture au départ et rompront au premier pas.</translation>
    </message>
    <message>
        <source>1 free particle has no mass.</source>
        <translation>1 particule libre n’a pas de masse.</translation>
    </message>
    <message>
        <source>%1 free particles have no mass.</source>
        <translation>%1 particules libres n’ont pas de masse.</translation>
    </message>
    <message>
        <source>Give %1 g each</source>
        <translation>Donner %1 g à chacune</translation>
    </message>
    <message>
        <source>1 link joins particles that are joined already, so that they are as stiff as two.</source>
        <translation>1 liaison joint des particules déjà jointes, qui sont donc deux fois plus raides.</translation>
    </message>
    <message>
        <source>%1 links join particles that are joined already, so that they are as stiff as two.</source>
        <translation>%1 liaisons joignent des particules déjà jointes, qui sont donc deux fois plus raides.</translation>
    </message>
    <message>
        <source>Remove the double links</source>
        <translation>Supprimer les liaisons doubles</translation>
    </message>
    <message>
        <source>1 particle hangs on no link and no panel.</source>
        <translation>1 particule ne tient à aucune liaison ni aucun panneau.</translation>
    </message>
    <message>
        <source>%1 particles hang on no link and no panel.</source>
        <translation>%1 particules ne tiennent à aucune liaison ni aucun panneau.</translation>
    </message>
    <message>
        <source>Remove the loose particles</source>
        <translation>Supprimer les particules seules</translation>
    </message>
    <!-- why a run stopped, and how the solver began -->
    <message>
        <source>particle %1 reached %2 m/s, above the limit of %3 m/s, at %4 s: %5</source>
        <translation>la particule %1 a atteint %2 m/s, au-dessus de la limite de %3 m/s, à %4 s : %5</translation>
    </message>
    <message>
        <source>particle %1 left the range of numbers at %2 s: %3</source>
        <translation>la particule %1 a quitté le domaine des nombres à %2 s : %3</translation>
    </message>
    <message>
        <source>the substep of %1 s is above the %2 s that its springs allow; shorten the time step, add substeps, or lower stiffness and damping</source>
        <translation>le sous-pas de %1 s dépasse les %2 s que permettent ses ressorts ; raccourcir le pas de temps, ajouter des sous-pas, ou baisser raideur et amortissement</translation>
    </message>
    <message>
        <source>explicit Euler gains energy from springs at any time step; choose another integrator or add damping</source>
        <translation>Euler explicite gagne de l’énergie des ressorts à tout pas de temps ; choisir un autre intégrateur ou ajouter de l’amortissement</translation>
    </message>
    <message>
        <source>a rod joins it to a particle of %1 times another mass; add substeps or bring the masses closer</source>
        <translation>une tige la joint à une particule de masse %1 fois différente ; ajouter des sous-pas ou rapprocher les masses</translation>
    </message>
    <message>
        <source>something pushes it harder than the time step resolves; shorten the time step or look at the forces there</source>
        <translation>quelque chose la pousse plus fort que le pas de temps ne le résout ; raccourcir le pas de temps ou regarder les forces à cet endroit</translation>
    </message>
    <message>
        <source>there are no rods</source>
        <translation>il n’y a pas de tiges</translation>
    </message>
    <message>
        <source>there are no rods; bending needs at least %1</source>
        <translation>il n’y a pas de tiges ; la flexion demande au moins %1</translation>
    </message>
    <message>
        <source>%1 rods are solved directly, since they hold fabric that is small enough for it; %2</source>
        <translation>%1 tiges sont résolues directement, car la voile qu’elles tiennent est assez petite pour cela ; %2</translation>
    </message>
    <message>
        <source>%1 rods are solved directly, since their load would need %2 substeps; %3</source>
        <translation>%1 tiges sont résolues directement, car leur charge demanderait %2 sous-pas ; %3</translation>
    </message>
    <message>
        <source>%1 rods are solved directly, since their load is far heavier than what holds it; %2</source>
        <translation>%1 tiges sont résolues directement, car leur charge est bien plus lourde que ce qui la tient ; %2</translation>
    </message>
    <message>
        <source>small steps: %1 substeps of one sweep to begin with, for a strain of %2 %</source>
        <translation>petits pas : %1 sous-pas d’un balayage pour commencer, pour une déformation de %2 %</translation>
    </message>
    <message>
        <source>small steps: %1 substeps of one sweep to begin with, for a strain of %2 %; bending needs at least %3</source>
        <translation>petits pas : %1 sous-pas d’un balayage pour commencer, pour une déformation de %2 % ; la flexion en demande au moins %3</translation>
    </message>
    <!-- why a value does nothing -->
    <message>
        <source>only the automatic solver aims at a strain</source>
        <translation>seul le solveur automatique vise une déformation</translation>
    </message>
    <message>
        <source>this solver makes one sweep in each substep; give it more substeps</source>
        <translation>ce solveur fait un balayage par sous-pas ; lui donner plus de sous-pas</translation>
    </message>
    <message>
        <source>no link is a rod, and springs need no solver</source>
        <translation>aucune liaison n’est une tige, et les ressorts n’ont pas besoin de solveur</translation>
    </message>
    <message>
        <source>there is nothing for the air to act on</source>
        <translation>l’air n’a rien sur quoi agir</translation>
    </message>
    <message>
        <source>no material tears</source>
        <translation>aucun matériau ne se rompt</translation>
    </message>
    <message>
        <source>the part has no canopy pressure</source>
        <translation>la pièce n’a pas de pression de voilure</translation>
    </message>
    <message>
        <source>the part has no self-contact</source>
        <translation>la pièce n’a pas de contact avec soi</translation>
    </message>
    <message>
        <source>the path says where it is</source>
        <translation>le trajet dit où il est</translation>
    </message>
    <message>
        <source>only planes have one</source>
        <translation>seuls les plans en ont une</translation>
    </message>
    <message>
        <source>only round shapes have one</source>
        <translation>seules les formes rondes en ont un</translation>
    </message>
    <message>
        <source>this shape has none</source>
        <translation>cette forme n’en a pas</translation>
    </message>
    <message>
        <source>planes and spheres do not turn</source>
        <translation>plans et sphères ne tournent pas</translation>
    </message>
    <message>
        <source>only height fields and meshes come from files</source>
        <translation>seuls champs de hauteurs et maillages viennent de fichiers</translation>
    </message>
    <message>
        <source>only meshes are scaled</source>
        <translation>seuls les maillages sont mis à l’échelle</translation>
    </message>
    <message>
        <source>only generated hills, a height field without a file, have it</source>
        <translation>seules les collines engendrées, un champ de hauteurs sans fichier, l’ont</translation>
    </message>
    <message>
        <source>only the response contact bounces and rubs</source>
        <translation>seule la réponse contact rebondit et frotte</translation>
    </message>
    <message>
        <source>the air density is 0</source>
        <translation>la densité de l’air est 0</translation>
    </message>
    <message>
        <source>gusts have none of their own</source>
        <translation>les rafales n’en ont pas en propre</translation>
    </message>
    <message>
        <source>this wind does not depend on the height</source>
        <translation>ce vent ne dépend pas de la hauteur</translation>
    </message>
    <message>
        <source>only the power law has one</source>
        <translation>seule la loi de puissance en a un</translation>
    </message>
    <message>
        <source>only the logarithmic law has one</source>
        <translation>seule la loi logarithmique en a une</translation>
    </message>
    <message>
        <source>only gusts have it</source>
        <translation>seules les rafales l’ont</translation>
    </message>
    <message>
        <source>only jets have it</source>
        <translation>seuls les jets l’ont</translation>
    </message>
    <message>
        <source>the link is a rod, which has a compliance</source>
        <translation>la liaison est une tige, qui a une souplesse</translation>
    </message>
    <message>
        <source>a line has none</source>
        <translation>une ligne n’en a pas</translation>
    </message>
    <message>
        <source>the link is a spring, which has a stiffness</source>
        <translation>la liaison est un ressort, qui a une raideur</translation>
    </message>
    <message>
        <source>the paper's solver takes every rod as stiff</source>
        <translation>le solveur de l’article prend toute tige pour raide</translation>
    </message>
    <message>
        <source>its material never tears</source>
        <translation>son matériau ne se rompt jamais</translation>
    </message>
    <message>
        <source>its links are all rods, which take the compliance</source>
        <translation>ses liaisons sont toutes des tiges, qui prennent la souplesse</translation>
    </message>
    <message>
        <source>no link is made of it</source>
        <translation>aucune liaison n’en est faite</translation>
    </message>
    <message>
        <source>each of its springs has its own</source>
        <translation>chacun de ses ressorts a la sienne</translation>
    </message>
    <message>
        <source>its axial, membrane or shear stiffness counts instead</source>
        <translation>sa rigidité axiale, de membrane ou de cisaillement compte à la place</translation>
    </message>
    <message>
        <source>its links are all springs, which take the stiffness</source>
        <translation>ses liaisons sont toutes des ressorts, qui prennent la raideur</translation>
    </message>
    <message>
        <source>each of its rods has its own</source>
        <translation>chacune de ses tiges a la sienne</translation>
    </message>
    <message>
        <source>no link of it has the role line</source>
        <translation>aucune liaison n’y a le rôle ligne</translation>
    </message>
    <message>
        <source>no link of it is a thread with a width</source>
        <translation>aucune liaison n’y est un fil avec une largeur</translation>
    </message>
    <message>
        <source>no link of it is a bias with a width</source>
        <translation>aucune liaison n’y est un biais avec une largeur</translation>
    </message>
    <message>
        <source>no panel is made of it</source>
        <translation>aucun panneau n’en est fait</translation>
    </message>
    <message>
        <source>the material never tears; choose what it tears by</source>
        <translation>le matériau ne se rompt jamais ; choisir par quoi il rompt</translation>
    </message>
    <message>
        <source>each of its links has its own</source>
        <translation>chacune de ses liaisons a la sienne</translation>
    </message>
    <message>
        <source>the line diameter is 0</source>
        <translation>le diamètre de ligne est 0</translation>
    </message>
    <message>
        <source>the air law does not ask for it</source>
        <translation>la loi d’air ne le demande pas</translation>
    </message>
    <message>
        <source>the particle is pinned</source>
        <translation>la particule est fixée</translation>
    </message>
    <!-- conditions -->
    <message>
        <source>At character %1: %2.</source>
        <translation>Au caractère %1 : %2.</translation>
    </message>
    <message>
        <source>At character %1: %2</source>
        <translation>Au caractère %1 : %2</translation>
    </message>
    <message>
        <source>nothing has a %1; did you mean %2?</source>
        <translation>rien n’a de %1 ; vouliez-vous dire %2 ?</translation>
    </message>
    <message>
        <source>nothing has a %1; say for example mass, restLength, material or strain</source>
        <translation>rien n’a de %1 ; dire par exemple mass, restLength, material ou strain</translation>
    </message>
    <message>
        <source>%1 has three numbers; say %2.x, %3.y or %4.z</source>
        <translation>%1 a trois nombres ; dire %2.x, %3.y ou %4.z</translation>
    </message>
    <message>
        <source>%1 has no x, y or z; say %2</source>
        <translation>%1 n’a ni x, ni y, ni z ; dire %2</translation>
    </message>
    <message>
        <source>%1 is a list and cannot be compared; choose another property</source>
        <translation>%1 est une liste et ne se compare pas ; choisir une autre propriété</translation>
    </message>
    <message>
        <source>%1 is a number; go on with &lt;, &gt; or = and a value</source>
        <translation>%1 est un nombre ; continuer avec &lt;, &gt; ou = et une valeur</translation>
    </message>
    <message>
        <source>a number is missing; write one, as in %1 &gt; 1</source>
        <translation>il manque un nombre ; en écrire un, comme dans %1 &gt; 1</translation>
    </message>
    <message>
        <source>%1 is not a number; write one, as in %2 &gt; 1</source>
        <translation>%1 n’est pas un nombre ; en écrire un, comme dans %2 &gt; 1</translation>
    </message>
    <message>
        <source>%1 is not a unit of %2; %3</source>
        <translation>%1 n’est pas une unité de %2 ; %3</translation>
    </message>
    <message>
        <source>go on with = and a value, as in %1 = %2</source>
        <translation>continuer avec = et une valeur, comme dans %1 = %2</translation>
    </message>
    <message>
        <source>%1 is not a number; compare it with = or !=</source>
        <translation>%1 n’est pas un nombre ; le comparer avec = ou !=</translation>
    </message>
    <message>
        <source>go on with = and the name of a %1</source>
        <translation>continuer avec = et le nom de : %1</translation>
    </message>
    <message>
        <source>"not" goes with a switch, as in not pinned; elsewhere compare with !=</source>
        <translation>« not » va avec un interrupteur, comme not pinned ; ailleurs, comparer avec !=</translation>
    </message>
    <message>
        <source>a property is missing; begin with one, as in mass &lt; 1 g</source>
        <translation>il manque une propriété ; commencer par une, comme dans mass &lt; 1 g</translation>
    </message>
    <message>
        <source>a value is missing after %1</source>
        <translation>il manque une valeur après %1</translation>
    </message>
    <message>
        <source>expected &lt;, &gt;, =, != or "and", not "%1"</source>
        <translation>attendu &lt;, &gt;, =, != ou « and », et non « %1 »</translation>
    </message>
    <!-- operations -->
    <message>
        <source>Nothing is selected that has a place. Select particles, links, panels or a part first.</source>
        <translation>Rien de sélectionné n’a de place. Sélectionner d’abord des particules, des liaisons, des panneaux ou une pièce.</translation>
    </message>
    <message>
        <source>All that is selected lies on the plane and is its own mirror image. Choose another plane or a smaller tolerance.</source>
        <translation>Toute la sélection est sur le plan et est sa propre image. Choisir un autre plan ou une tolérance plus petite.</translation>
    </message>
    <message>
        <source>The step is 0, so that all would lie in one place. Give it a length.</source>
        <translation>Le pas est 0, et tout serait au même endroit. Lui donner une longueur.</translation>
    </message>
    <message>
        <source>The angle is 0, so that all would lie in one place. 360 is a full ring.</source>
        <translation>L’angle est 0, et tout serait au même endroit. 360 est un tour complet.</translation>
    </message>
    <message>
        <source>No two of the selected particles are that near to each other. Select more, or weld over a longer distance.</source>
        <translation>Il n’y a pas deux particules sélectionnées aussi proches. En sélectionner plus, ou souder sur une plus grande distance.</translation>
    </message>
    <message>
        <source>No link is selected. Select the links that are to be split.</source>
        <translation>Aucune liaison n’est sélectionnée. Sélectionner les liaisons à diviser.</translation>
    </message>
    <message>
        <source>Select two or more particles first.</source>
        <translation>Sélectionner d’abord au moins deux particules.</translation>
    </message>
    <message>
        <source>Select the particles along the spar first.</source>
        <translation>Sélectionner d’abord les particules le long du longeron.</translation>
    </message>
    <message>
        <source>Select three or more particles around the hole first.</source>
        <translation>Sélectionner d’abord au moins trois particules autour du trou.</translation>
    </message>
    <message>
        <source>Select the particles that are to become stiff first.</source>
        <translation>Sélectionner d’abord les particules qui doivent devenir raides.</translation>
    </message>
    <message>
        <source>Each with each of more than %1 particles are too many links. Select fewer, or choose another way.</source>
        <translation>Chacune à chacune de plus de %1 particules fait trop de liaisons. En sélectionner moins, ou choisir une autre façon.</translation>
    </message>
    <message>
        <source>These particles are linked already, or lie in one place. Nothing is added.</source>
        <translation>Ces particules sont déjà liées, ou sont au même endroit. Rien n’est ajouté.</translation>
    </message>
    <message>
        <source>A rope runs between two particles: select these two.</source>
        <translation>Une corde court entre deux particules : sélectionner ces deux-là.</translation>
    </message>
    <message>
        <source>These particles are linked already, or lie in one place. Take more links.</source>
        <translation>Ces particules sont déjà liées, ou sont au même endroit. Prendre plus de liaisons.</translation>
    </message>
    <message>
        <source>There are panels on all of these particles already.</source>
        <translation>Il y a déjà des panneaux sur toutes ces particules.</translation>
    </message>
    <message>
        <source>No particle is selected. Select what is to have the mass.</source>
        <translation>Aucune particule n’est sélectionnée. Sélectionner ce qui doit avoir la masse.</translation>
    </message>
    <message>
        <source>What is selected has no mass yet, so there is no proportion to keep. Share the mass out evenly.</source>
        <translation>La sélection n’a pas encore de masse, et il n’y a pas de proportion à garder. Répartir la masse également.</translation>
    </message>
    <message>
        <source>No link lies among what is selected, so it has no length. Select both ends of a line.</source>
        <translation>Aucune liaison n’est dans la sélection, qui n’a donc pas de longueur. Sélectionner les deux bouts d’une ligne.</translation>
    </message>
    <message>
        <source>No panel lies among what is selected, so it has no area. Select all corners of some fabric.</source>
        <translation>Aucun panneau n’est dans la sélection, qui n’a donc pas d’aire. Sélectionner tous les coins d’un tissu.</translation>
    </message>
    <message>
        <source>Nothing is selected that links could hold. Select particles, links or a part.</source>
        <translation>Rien de sélectionné ne pourrait être tenu par des liaisons. Sélectionner des particules, des liaisons ou une pièce.</translation>
    </message>
    <message>
        <source>%1 particles are too many to look at together. Select at most %2, such as the frame without the sail.</source>
        <translation>%1 particules sont trop pour être examinées ensemble. En sélectionner au plus %2, comme l’armature sans la voile.</translation>
    </message>
    <!-- the table -->
    <message>
        <source>An id stays as it is.</source>
        <translation>Un id reste tel quel.</translation>
    </message>
    <message>
        <source>There are %1 to paste and %2 to take them; begin further up.</source>
        <translation>Il y a %1 à coller et %2 pour les recevoir ; commencer plus haut.</translation>
    </message>
    <message>
        <source>Line %1 has %2 and there are %3 to take them; begin further left.</source>
        <translation>La ligne %1 a %2 et il y a %3 pour les recevoir ; commencer plus à gauche.</translation>
    </message>
    <!-- steps of the history -->
    <message>
        <source>Set %1</source>
        <translation>Régler %1</translation>
    </message>
    <message>
        <source>Add to %1</source>
        <translation>Ajouter à %1</translation>
    </message>
    <message>
        <source>Remove from %1</source>
        <translation>Retirer de %1</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>Insérer %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Array in a row</source>
        <translation>Répétition linéaire</translation>
    </message>
    <message>
        <source>Array in a ring</source>
        <translation>Répétition circulaire</translation>
    </message>
    <message>
        <source>Weld</source>
        <translation>Souder</translation>
    </message>
    <message>
        <source>Set mass</source>
        <translation>Donner une masse</translation>
    </message>
    <message>
        <source>Split links</source>
        <translation>Diviser les liaisons</translation>
    </message>
    <message>
        <source>Add braces</source>
        <translation>Ajouter des contreventements</translation>
    </message>
    <message>
        <source>Adopt pose</source>
        <translation>Adopter la pose</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Libérer</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Répartir</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Aplatir</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Mettre à l’échelle %1</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <source>Fill with panels</source>
        <translation>Remplir de panneaux</translation>
    </message>
    <message>
        <source>Rigidity particles</source>
        <translation>Particules de rigidité</translation>
    </message>
    <message>
        <source>Change parameters of %1</source>
        <translation>Changer les paramètres de %1</translation>
    </message>
    <message>
        <source>Detach from builder</source>
        <translation>Détacher du générateur</translation>
    </message>
    <!-- meshes -->
    <message>
        <source>All faces of the mesh lie in one point; choose another file.</source>
        <translation>Toutes les faces du maillage sont en un point ; choisir un autre fichier.</translation>
    </message>
    <message>
        <source>The scale of the mesh must be above 0.</source>
        <translation>L’échelle du maillage doit être au-dessus de 0.</translation>
    </message>
    <message>
        <source>The mesh would be more than 1000 km wide; choose a smaller unit.</source>
        <translation>Le maillage ferait plus de 1000 km de large ; choisir une unité plus petite.</translation>
    </message>
    <message>
        <source>The weld tolerance must be 0 or more, and smaller than the mesh.</source>
        <translation>La tolérance de soudure doit être 0 ou plus, et plus petite que le maillage.</translation>
    </message>
    <message>
        <source>The material %1 has no mass per area; give one above 0 kg/m^2, or choose a preset.</source>
        <translation>Le matériau %1 n’a pas de masse surfacique ; en donner une au-dessus de 0 kg/m^2, ou choisir un préréglage.</translation>
    </message>
    <message>
        <source>The mesh has too many triangles; make it coarser in a mesh program.</source>
        <translation>Le maillage a trop de triangles ; le rendre plus grossier dans un logiciel de maillage.</translation>
    </message>
    <message>
        <source>The import was cancelled.</source>
        <translation>L’importation a été annulée.</translation>
    </message>
    <message>
        <source>No face of the mesh has an area; lower the weld tolerance, or check the mesh in a mesh program.</source>
        <translation>Aucune face du maillage n’a d’aire ; baisser la tolérance de soudure, ou vérifier le maillage dans un logiciel de maillage.</translation>
    </message>
    <message>
        <source>1 vertex belongs to no face: left out.</source>
        <translation>1 sommet n’appartient à aucune face : omis.</translation>
    </message>
    <message>
        <source>%1 vertices belong to no face: left out.</source>
        <translation>%1 sommets n’appartiennent à aucune face : omis.</translation>
    </message>
    <message>
        <source>1 vertex lies on another one: joined.</source>
        <translation>1 sommet est sur un autre : joint.</translation>
    </message>
    <message>
        <source>%1 vertices lie on another one: joined.</source>
        <translation>%1 sommets sont sur un autre : joints.</translation>
    </message>
    <message>
        <source>1 face has no area: left out.</source>
        <translation>1 face n’a pas d’aire : omise.</translation>
    </message>
    <message>
        <source>%1 faces have no area: left out.</source>
        <translation>%1 faces n’ont pas d’aire : omises.</translation>
    </message>
    <message>
        <source>1 face has the corners of another one: left out.</source>
        <translation>1 face a les coins d’une autre : omise.</translation>
    </message>
    <message>
        <source>%1 faces have the corners of another one: left out.</source>
        <translation>%1 faces ont les coins d’une autre : omises.</translation>
    </message>
    <message>
        <source>1 edge belongs to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there.</source>
        <translation>1 arête appartient à plus de deux faces : gardée. C’est juste là où une quille ou une nervure rencontre une voile ; le tissu n’y résiste pas à la flexion.</translation>
    </message>
    <message>
        <source>%1 edges belong to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there.</source>
        <translation>%1 arêtes appartiennent à plus de deux faces : gardées. C’est juste là où une quille ou une nervure rencontre une voile ; le tissu n’y résiste pas à la flexion.</translation>
    </message>
    <message>
        <source>1 face was wound against its neighbours: turned over.</source>
        <translation>1 face était orientée contre ses voisines : retournée.</translation>
    </message>
    <message>
        <source>%1 faces were wound against their neighbours: turned over.</source>
        <translation>%1 faces étaient orientées contre leurs voisines : retournées.</translation>
    </message>
    <message>
        <source>1 closed piece was inside out: turned over.</source>
        <translation>1 morceau fermé était à l’envers : retourné.</translation>
    </message>
    <message>
        <source>%1 closed pieces were inside out: turned over.</source>
        <translation>%1 morceaux fermés étaient à l’envers : retournés.</translation>
    </message>
    <message>
        <source>1 edge has no outside: the surface turns over itself like a Moebius strip.</source>
        <translation>1 arête n’a pas d’extérieur : la surface se retourne comme un ruban de Möbius.</translation>
    </message>
    <message>
        <source>%1 edges have no outside: the surface turns over itself like a Moebius strip.</source>
        <translation>%1 arêtes n’ont pas d’extérieur : la surface se retourne comme un ruban de Möbius.</translation>
    </message>
    <message>
        <source>The mesh is one piece.</source>
        <translation>Le maillage est d’un seul tenant.</translation>
    </message>
    <message>
        <source>The mesh is %1 pieces that nothing joins. A larger weld tolerance may join them.</source>
        <translation>Le maillage est en %1 morceaux que rien ne joint. Une plus grande tolérance de soudure peut les joindre.</translation>
    </message>
    <message>
        <source>1 edge belongs to one face only: the rim of the fabric.</source>
        <translation>1 arête n’appartient qu’à une face : le bord du tissu.</translation>
    </message>
    <message>
        <source>%1 edges belong to one face only: the rim of the fabric.</source>
        <translation>%1 arêtes n’appartiennent qu’à une face : le bord du tissu.</translation>
    </message>
    <message>
        <source>%1 edges belong to one face only: the rim of the fabric, in %2 rims.</source>
        <translation>%1 arêtes n’appartiennent qu’à une face : le bord du tissu, en %2 bords.</translation>
    </message>
    <message>
        <source>1 polygon of more than three corners became triangles.</source>
        <translation>1 polygone de plus de trois coins est devenu des triangles.</translation>
    </message>
    <message>
        <source>%1 polygons of more than three corners became triangles.</source>
        <translation>%1 polygones de plus de trois coins sont devenus des triangles.</translation>
    </message>
    <message>
        <source>1 vertex lies on a seam of the texture: the first of its texture points was kept.</source>
        <translation>1 sommet est sur une couture de la texture : le premier de ses points de texture a été gardé.</translation>
    </message>
    <message>
        <source>%1 vertices lie on a seam of the texture: the first of their texture points was kept.</source>
        <translation>%1 sommets sont sur une couture de la texture : le premier de leurs points de texture a été gardé.</translation>
    </message>
    <message>
        <source>1 line or single point of the file was left out.</source>
        <translation>1 ligne ou point isolé du fichier a été omis.</translation>
    </message>
    <message>
        <source>%1 lines and single points of the file were left out.</source>
        <translation>%1 lignes et points isolés du fichier ont été omis.</translation>
    </message>
    <message>
        <source>The mesh is larger than 200 m or smaller than 2 cm: check its unit.</source>
        <translation>Le maillage fait plus de 200 m ou moins de 2 cm : vérifier son unité.</translation>
    </message>
    <message>
        <source>The mesh %1 does not exist; check the name and the folder.</source>
        <translation>Le maillage %1 n’existe pas ; vérifier le nom et le dossier.</translation>
    </message>
    <message>
        <source>The mesh %1 is a folder; choose a file in it.</source>
        <translation>Le maillage %1 est un dossier ; y choisir un fichier.</translation>
    </message>
    <message>
        <source>The mesh %1 has no known format; choose an OBJ, STL, PLY, OFF, glTF, GLB or Collada (.dae) file.</source>
        <translation>Le maillage %1 n’a pas de format connu ; choisir un fichier OBJ, STL, PLY, OFF, glTF, GLB ou Collada (.dae).</translation>
    </message>
    <message>
        <source>The mesh %1 is empty; save it again.</source>
        <translation>Le maillage %1 est vide ; l’enregistrer de nouveau.</translation>
    </message>
    <message>
        <source>The mesh %1 is larger than 1 GiB; make it coarser in a mesh program first.</source>
        <translation>Le maillage %1 dépasse 1 Gio ; le rendre d’abord plus grossier dans un logiciel de maillage.</translation>
    </message>
    <message>
        <source>The mesh %1 cannot be opened; check that you may read it.</source>
        <translation>Le maillage %1 ne peut pas être ouvert ; vérifier que vous pouvez le lire.</translation>
    </message>
    <message>
        <source>The mesh %1 cannot be read to its end; check the disk.</source>
        <translation>Le maillage %1 ne peut pas être lu jusqu’au bout ; vérifier le disque.</translation>
    </message>
    <message>
        <source>The mesh %1 has no faces; choose a file with a surface.</source>
        <translation>Le maillage %1 n’a pas de faces ; choisir un fichier avec une surface.</translation>
    </message>
    <message>
        <source>The mesh %1 has no face with an area; choose a file with a surface.</source>
        <translation>Le maillage %1 n’a aucune face avec une aire ; choisir un fichier avec une surface.</translation>
    </message>
    <!-- of files -->
    <message>
        <source>it is a folder or a device</source>
        <translation>c’est un dossier ou un périphérique</translation>
    </message>
    <message>
        <source>a file has that name</source>
        <translation>un fichier porte ce nom</translation>
    </message>
    <message>
        <source>there is no room for the shapes of the series</source>
        <translation>il n’y a pas de place pour les formes de la série</translation>
    </message>
    <message>
        <source>the shapes of the series cannot be read again</source>
        <translation>les formes de la série ne peuvent pas être relues</translation>
    </message>
    <message>
        <source>%1 was not written: %2; make room or choose another folder.</source>
        <translation>%1 n’a pas été écrit : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 was not written: %2; choose another folder.</source>
        <translation>%1 n’a pas été écrit : %2 ; choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 was not saved: %2; make room or choose another folder.</source>
        <translation>%1 n’a pas été enregistré : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 cannot be written: there is no folder %2; make it or choose another.</source>
        <translation>%1 ne peut pas être écrit : le dossier %2 n’existe pas ; le créer ou en choisir un autre.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; choose another folder.</source>
        <translation>%1 ne peut pas être écrit : %2 ; choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 is not complete: %2; make room or choose another folder.</source>
        <translation>%1 n’est pas complet : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 is a folder or a device; name a file.</source>
        <translation>%1 est un dossier ou un périphérique ; nommer un fichier.</translation>
    </message>
    <message>
        <source>%1 is a folder; name a file in it.</source>
        <translation>%1 est un dossier ; nommer un fichier dedans.</translation>
    </message>
    <message>
        <source>%1 is a folder; name a file.</source>
        <translation>%1 est un dossier ; nommer un fichier.</translation>
    </message>
    <message>
        <source>%1 does not exist; check the path.</source>
        <translation>%1 n’existe pas ; vérifier le chemin.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2; choose another target.</source>
        <translation>Le dossier %1 ne peut pas être créé : %2 ; choisir une autre cible.</translation>
    </message>
    <message>
        <source>There is neither fabric nor a line at this moment to make a mesh of.</source>
        <translation>Il n’y a à cet instant ni tissu ni ligne dont faire un maillage.</translation>
    </message>
    <message>
        <source>The scene has neither fabric nor lines, so there is nothing to show.</source>
        <translation>La scène n’a ni tissu ni lignes, il n’y a donc rien à montrer.</translation>
    </message>
    <message>
        <source>The mesh cannot be written: %1</source>
        <translation>Le maillage ne peut pas être écrit : %1</translation>
    </message>
    <message>
        <source>The panels of the design change after %1 s, and this format knows one mesh only; choose a sequence of files.</source>
        <translation>Les panneaux du modèle changent après %1 s, et ce format ne connaît qu’un maillage ; choisir une suite de fichiers.</translation>
    </message>
    <message>
        <source>The lines of the design change after %1 s, and this format knows one mesh only; choose a sequence of files.</source>
        <translation>Les lignes du modèle changent après %1 s, et ce format ne connaît qu’un maillage ; choisir une suite de fichiers.</translation>
    </message>
    <message>
        <source>The scene has no probes, so there is nothing to draw in %1; add a probe first.</source>
        <translation>La scène n’a pas de sondes, il n’y a donc rien à tracer dans %1 ; ajouter d’abord une sonde.</translation>
    </message>
    <message>
        <source>The scene has no probes, so there is nothing to put into %1; add a probe first.</source>
        <translation>La scène n’a pas de sondes, il n’y a donc rien à mettre dans %1 ; ajouter d’abord une sonde.</translation>
    </message>
    <message>
        <source>The animation would have %1 MB, and a glTF file holds 4096 at most; choose fewer frames, or a point cache (.pc2).</source>
        <translation>L’animation ferait %1 Mo, et un fichier glTF en contient 4096 au plus ; choisir moins d’images, ou un cache de points (.pc2).</translation>
    </message>
    <message>
        <source>The export was cancelled; nothing was written.</source>
        <translation>L’export a été annulé ; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>The number of frames per second must be above 0.</source>
        <translation>Le nombre d’images par seconde doit être supérieur à 0.</translation>
    </message>
    <message>
        <source>The end of the range must not lie before its start.</source>
        <translation>La fin de l’intervalle ne doit pas précéder son début.</translation>
    </message>
    <message>
        <source>The range starts at %1, but the run begins only at %2.</source>
        <translation>L’intervalle commence à %1, mais la simulation ne commence qu’à %2.</translation>
    </message>
    <message>
        <source>The range starts at %1, but the run ends at %2.</source>
        <translation>L’intervalle commence à %1, mais la simulation finit à %2.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>%1 can no longer be read; open it again.</source>
        <translation>%1 ne peut plus être lu ; l’ouvrir de nouveau.</translation>
    </message>
    <message>
        <source>%1 is no file; name a recording (*.ripstop-run).</source>
        <translation>%1 n’est pas un fichier ; nommer un enregistrement (*.ripstop-run).</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that you may read it.</source>
        <translation>%1 ne peut pas être ouvert ; vérifier que vous pouvez le lire.</translation>
    </message>
    <message>
        <source>%1 was written by a later version of Ripstop; open it with that.</source>
        <translation>%1 a été écrit par une version plus récente de Ripstop ; l’ouvrir avec elle.</translation>
    </message>
    <message>
        <source>%1 is not a recording of Ripstop (*.ripstop-run).</source>
        <translation>%1 n’est pas un enregistrement de Ripstop (*.ripstop-run).</translation>
    </message>
    <message>
        <source>One of the recordings holds no frame.</source>
        <translation>L’un des enregistrements ne contient aucune image.</translation>
    </message>
    <message>
        <source>The recordings have no time in common.</source>
        <translation>Les enregistrements n’ont aucun instant en commun.</translation>
    </message>
    <message>
        <source>The recording is damaged at this frame; choose another one.</source>
        <translation>L’enregistrement est abîmé à cette image ; en choisir une autre.</translation>
    </message>
    <message>
        <source>The recording does not fit its design: it is damaged.</source>
        <translation>L’enregistrement ne va pas avec son modèle : il est abîmé.</translation>
    </message>
    <message>
        <source>A stretch of the recording is damaged; choose another time.</source>
        <translation>Un tronçon de l’enregistrement est abîmé ; choisir un autre instant.</translation>
    </message>
    <message>
        <source>There is nothing in the recording.</source>
        <translation>Il n’y a rien dans l’enregistrement.</translation>
    </message>
    <message>
        <source>The run stopped before that: %1</source>
        <translation>La simulation s’est arrêtée avant : %1</translation>
    </message>
    <message>
        <source>The recording ends here, as %1.</source>
        <translation>L’enregistrement finit ici, car %1.</translation>
    </message>
    <message>
        <source>there is no folder for temporary files; set TMPDIR to one</source>
        <translation>il n’y a pas de dossier pour les fichiers temporaires ; en donner un dans TMPDIR</translation>
    </message>
    <message>
        <source>no temporary file can be made in %1: %2</source>
        <translation>aucun fichier temporaire ne peut être créé dans %1 : %2</translation>
    </message>
    <message>
        <source>the folder for temporary files cannot take more: %1</source>
        <translation>le dossier des fichiers temporaires est plein : %1</translation>
    </message>
    <message>
        <source>a temporary file cannot be read: %1</source>
        <translation>un fichier temporaire ne peut pas être lu : %1</translation>
    </message>
    <message>
        <source>Name the bundle: a new folder, or a file that ends with .zip.</source>
        <translation>Nommer le dossier de la simulation : un nouveau dossier, ou un fichier qui finit par .zip.</translation>
    </message>
    <message>
        <source>%1 is a file; name a new folder, or a file that ends with .zip.</source>
        <translation>%1 est un fichier ; nommer un nouveau dossier, ou un fichier qui finit par .zip.</translation>
    </message>
    <message>
        <source>%1 is a folder with other things in it; name a new one.</source>
        <translation>%1 est un dossier qui contient autre chose ; en nommer un nouveau.</translation>
    </message>
    <message>
        <source>No folder can be made beside %1: %2; make room or choose another folder.</source>
        <translation>Aucun dossier ne peut être créé à côté de %1 : %2 ; faire de la place ou choisir un autre dossier.</translation>
    </message>
    <message>
        <source>%1 cannot be copied into the bundle: %2.</source>
        <translation>%1 ne peut pas être copié dans le dossier de la simulation : %2.</translation>
    </message>
    <message>
        <source>Nothing was flown: a bundle needs one time step at least.</source>
        <translation>Rien n’a été simulé : un dossier de la simulation demande un pas de temps au moins.</translation>
    </message>
    <message>
        <source>The run cannot be kept whole: %1</source>
        <translation>La simulation ne peut pas être gardée entière : %1</translation>
    </message>
</context>
</TS>
