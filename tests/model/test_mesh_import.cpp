// Meshes brought in: what fabric comes out, and where it is.
//
// Stages: a cube and loose triangles become fabric; masses, styles of links and shear; the
// stiffness of triangular fabric against theory; then objects and materials of the file, the edit
// and its undo, refusals, cancelling, and the time for a large mesh. What carries the pull by
// default is in test_mesh_carrier.cpp.
#include "check/check.h"
#include "model/cli_call.h"
#include "model/meshes.h"
#include "registered_test.h"
#include "shapes/mesh_file.h"

#include <QElapsedTimer>
#include <QtTest>

namespace ripstop::test_mesh_import {

class TestMeshImport : public QObject, MeshFolder
{
    Q_OBJECT

private slots:
    // --- the network of a cube ------------------------------------------------------------------

    void cubeOfQuadsBecomesFabric()
    {
        const PreparedMesh mesh = preparedOf(fileOf("cube.obj", cubeOfQuads));
        const Scene scene = sceneOf(mesh);
        const Part& part = firstPart(scene);
        QCOMPARE(part.particles.size(), 8u);
        QCOMPARE(part.panels.size(), 12u);
        QCOMPARE(countOf(part, LinkRole::Thread), 12u); // edges of squares
        QCOMPARE(countOf(part, LinkRole::Bias), 12u);   // two diagonals of each side
        QCOMPARE(part.links.size(), 24u);
        for (const Link& link : part.links) {
            QCOMPARE(link.kind, LinkKind::Rod);
            const bool isThread = link.role == LinkRole::Thread;
            // half a square from either side; biasWidth() of a unit square is sqrt 2
            QVERIFY(std::abs(link.width - (isThread ? 1.0 : std::sqrt(2.0))) < 1e-12);
            QVERIFY(std::abs(link.restLength - (isThread ? 1.0 : std::sqrt(2.0))) < 1e-12);
        }
        QVERIFY(problemsOf(scene).empty());
        QCOMPARE(mesh.report.count(MeshFault::SplitPolygons), 6u);
        QCOMPARE(mesh.report.count(MeshFault::DuplicateVertices), 0u);
        QCOMPARE(mesh.report.count(MeshFault::OpenEdges), 0u);
        QCOMPARE(mesh.report.count(MeshFault::FlippedFaces), 0u);
        QCOMPARE(mesh.report.count(MeshFault::InsideOutShells), 0u);
    }

    // Cells of 3 x 1 and 2 x 1 beside each other: the thread between them stands for half of both,
    // so that the square of its aspect is (1.5 / 9 + 1 / 4) / (1.5 + 1).
    void cellsThatAreNotSquare()
    {
        const PreparedMesh mesh =
            preparedOf(fileOf("cells.obj", "v 0 0 0\nv 3 0 0\nv 5 0 0\nv 0 1 0\nv 3 1 0\nv 5 1 0\n"
                                           "f 1 2 5 4\nf 2 3 6 5\n"));
        const Scene scene = sceneOf(mesh);
        const Part& part = firstPart(scene);
        QCOMPARE(countOf(part, LinkRole::Thread), 7u);
        std::vector<double> along, across;
        for (const Link& link : part.links)
            if (link.role == LinkRole::Thread)
                (link.restLength > 1.5 ? along : across).push_back(link.cellAspect);
        std::ranges::sort(along);
        std::ranges::sort(across);
        const std::vector<double> lengths{2.0, 2.0, 3.0, 3.0};
        const std::vector<double> heights{1.0 / 3.0, std::sqrt((1.5 / 9.0 + 0.25) / 2.5), 0.5};
        for (std::size_t i = 0; i < along.size(); ++i)
            QVERIFY(std::abs(along[i] - lengths[i]) < 1e-12);
        for (std::size_t i = 0; i < across.size(); ++i)
            QVERIFY(std::abs(across[i] - heights[i]) < 1e-12);
        MeshFabric bare = plainFabric(); // nothing but threads, which no diagonal helps
        bare.shear = LinkStyle::None;
        for (const Scene alone = sceneOf(mesh, bare); const Link& link : firstPart(alone).links)
            QCOMPARE(link.cellAspect, 1.0);
    }

    void looseTrianglesOfAnStlAreJoined()
    {
        const PolygonMesh read = fileOf("cube.stl", cubeAsStl());
        QCOMPARE(read.points.size(), 36u);
        const PreparedMesh mesh = preparedOf(read);
        QCOMPARE(mesh.report.count(MeshFault::DuplicateVertices), 28u);
        const Part& part = firstPart(sceneOf(mesh));
        QCOMPARE(part.particles.size(), 8u);
        QCOMPARE(part.panels.size(), 12u);
        QCOMPARE(part.links.size(), 18u); // triangles resist shear without more
        double widths = 0.0;              // each triangle stands at its three edges
        for (const Link& link : part.links)
            widths += link.width * link.restLength;
        QVERIFY(std::abs(widths - 3.0 * 6.0) < 1e-9);
    }

    // What the window says beside the size of the fabric, the command line does: a bridle of 1 m up
    // and 3 m to the right beside a square of 1 m.
    void commandLineTellsOfLines()
    {
        const QString mesh = write("bridle.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\n"
                                                 "v 3 2 0\nf 1 2 3 4\nl 4 5 6\n");
        const QString scene = m_folder.filePath("bridle.ripstop.json");
        const Outcome made = call({"import", mesh, "-o", scene});
        QVERIFY(made.out.contains("1 x 1 x 0 m (width, height, depth), 2 lines of 4 m together, "));
        const QJsonObject first = call({"import", mesh, "--json", "-o", scene})
                                      .json()["meshes"]
                                      .toArray()
                                      .first()
                                      .toObject();
        QCOMPARE(first["lines"].toObject()["count"].toInt(), 2);
        QCOMPARE(first["lines"].toObject()["length"].toDouble(), 4.0);
    }

    // As everywhere: 24 inches are 0.6096 m, and a bare number is in the unit of the help.
    void commandLineTakesUnits()
    {
        const QString mesh = write("inches.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
        const auto imported = [&](const QStringList& options) {
            const QString scene = m_folder.filePath("inches.ripstop.json");
            return call(QStringList{"import", mesh, "-o", scene} + options);
        };
        QVERIFY(imported({"--size", "24 in"}).out.contains("0.6096 x 0.3048 x 0 m"));
        QVERIFY(imported({"--size", "3"}).out.contains("3 x 1.5 x 0 m"));
        QVERIFY(imported({"--density", "50 g/m^2"}).out.contains("2 m^2, 0.1 kg"));
        const Outcome wrong = imported({"--size", "3 kg"});
        QCOMPARE(wrong.exitCode, 2);
        QVERIFY(wrong.error.contains("--size: must be a number from 1e-06 to 1e+06 m, not 3 kg"));
    }

    // Lines of the file: the legs of a bridle and the line below it, drawn as an object of their
    // own whose ends lie on corners of the sail, and a spreader between two corners that no face
    // has. They become links that pull only, 1 g/m; a line along the edge of a face is a thread
    // already, and one that is told twice is one link.
    void linesBecomeLinks()
    {
        const char* const kite = "o sail\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                 "f 1 2 3 4\nf 2 5 6 3\nl 1 2\nl 1 5\n"
                                 "o bridle\nv 1 0 0\nv 1 1 0\nv 1 0.5 -2\nv 1 0.5 -5\n"
                                 "l 7/1 9 8/2\nl 9 10\nl -1 -2\nl 7 8\np 9\n";
        const PolygonMesh read = meshOf(kite);
        QCOMPARE(read.strayElements, 2u); // l 1 2, and the point
        const PreparedMesh mesh = preparedOf(read);
        QCOMPARE(mesh.report.count(MeshFault::StrayElements), 3u); // l 7 8 lies on an edge as well
        QCOMPARE(linesOf(mesh).count, 4u); // two legs, the line, the spreader
        QVERIFY(std::abs(linesOf(mesh).length - (2.0 * std::hypot(0.5, 2.0) + 3.0 + 2.0)) < 1e-12);
        QCOMPARE(mesh.size, Vec3(2.0, 1.0, 0.0)); // of the sail alone
        for (const FabricKind carrier : {FabricKind::Threads, FabricKind::Panels}) {
            MeshFabric fabric = plainFabric(0.5);
            fabric.material.membraneStiffness = 1e4;
            fabric.material.shearStiffness = 1e3;
            fabric.carrier = carrier;
            const Scene scene = sceneOf(mesh, fabric);
            const Part& part = firstPart(scene);
            QCOMPARE(part.particles.size(), 8u);
            std::vector<double> lengths;
            double mass = 0.0;
            for (const Link& link : part.links)
                if (link.role == LinkRole::Line) {
                    QCOMPARE(link.resists, Resists::Tension);
                    QCOMPARE(findItem<Material>(scene, link.material)->name, std::string("lines"));
                    lengths.push_back(link.restLength);
                }
            for (const Particle& particle : part.particles)
                mass += particle.mass;
            std::ranges::sort(lengths);
            const double leg = std::hypot(0.5, 2.0);
            const std::vector<double> expected{2.0, leg, leg, 3.0};
            QCOMPARE(lengths.size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                QVERIFY(std::abs(lengths[i] - expected[i]) < 1e-12);
            QVERIFY(std::abs(mass - 2.0 * 0.5 - 1e-3 * (5.0 + 2.0 * leg)) < 1e-12);
            QVERIFY(!hasErrors(problemsOf(scene)));
        }
        // objects that become parts of their own have no lines between them, and are told so
        MeshShape apart;
        apart.parts = MeshParts::PerObject;
        const PreparedMesh pieces = preparedOf(read, apart);
        QCOMPARE(pieces.surfaces.size(), 1u);
        QVERIFY(pieces.surfaces[0].mesh.lines.empty());
        QCOMPARE(linesOf(pieces).count, 0u);
        QCOMPARE(pieces.report.count(MeshFault::StrayElements), 2u + 6u);
    }

    void massIsThatOfTheArea()
    {
        const MeshImport made = importOf(preparedOf(meshOf(cubeOfQuads)), plainFabric(0.25));
        QVERIFY(std::abs(made.area - 6.0) < 1e-12);
        QVERIFY(std::abs(made.mass - 1.5) < 1e-12);
        QCOMPARE(made.particles, 8u);
        QCOMPARE(made.rods, 24u);
        QCOMPARE(made.springs, 0u);
        QCOMPARE(made.panels, 12u);
    }

    void styles()
    {
        MeshFabric fabric = plainFabric();
        fabric.structural = LinkStyle::Springs;
        fabric.shear = LinkStyle::None;
        fabric.bend = LinkStyle::Springs;
        // 4 x 4 squares: 2 (4 x 5) edges; over two edges 3 in each of 5 rows and 5 columns
        const Scene scene = sceneOf(preparedOf(meshOf(sheet(4, 0.25, true).c_str())), fabric);
        const Part& part = firstPart(scene);
        QCOMPARE(countOf(part, LinkRole::Thread), 40u);
        QCOMPARE(countOf(part, LinkRole::Bias), 0u);
        QCOMPARE(countOf(part, LinkRole::Line), 30u);
        for (const Link& link : part.links) {
            QCOMPARE(link.kind, LinkKind::Spring);
            if (link.role == LinkRole::Line)
                QVERIFY(std::abs(link.restLength - 0.5) < 1e-9);
        }
    }

    void shearAcrossTriangles()
    {
        MeshFabric fabric = plainFabric();
        fabric.shear = LinkStyle::Rods;
        const char* const kite = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
        const Part& part = firstPart(sceneOf(preparedOf(meshOf(kite)), fabric));
        QCOMPARE(countOf(part, LinkRole::Thread), 5u);
        QCOMPARE(countOf(part, LinkRole::Bias), 1u);
        const Link& across = part.links.back();
        QVERIFY(std::abs(across.restLength - std::sqrt(2.0)) < 1e-12);
        QVERIFY(std::abs(across.width - 8.0 / 3.0 / std::sqrt(2.0)) < 1e-12);
    }

    // A lattice of equilateral triangles of side a has threads as wide as two heights of them:
    // sqrt(3) / 2 a, with which its modulus is that of the fabric (Van Gelder 1998).
    void widthOfAThread()
    {
        const char* const pair = "v 0 0 0\nv 2 0 0\nv 1 1.7320508075688772 0\n"
                                 "v 1 -1.7320508075688772 0\nf 1 2 3\nf 2 1 4\n";
        const Part& part = firstPart(sceneOf(preparedOf(meshOf(pair))));
        QVERIFY(std::abs(part.links.front().width - std::sqrt(3.0)) < 1e-9);
    }

    // The energy of links in a sheet of equilateral triangles that is strained evenly, per area, is
    // that of a sheet with the modulus E t and Poisson's ratio 1/3, and for shear links
    // G t g^2 / 2. Half of each link at an inner particle is that particle's, whose area is
    // sqrt(3) / 2 a^2.
    void triangularFabricIsAsStiffAsItsNumbers()
    {
        const double a = 0.1;
        const double h = 0.5 * std::sqrt(3.0) * a;
        const int n = 6;
        std::string text;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                text += "v " + std::to_string(a * (i + 0.5 * j)) + " "
                        + QString::number(h * j, 'g', 17).toStdString() + " 0\n";
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const int at = j * (n + 1) + i + 1;
                const auto face = [](int p, int q, int r) {
                    return "f " + std::to_string(p) + " " + std::to_string(q) + " "
                           + std::to_string(r) + "\n";
                };
                text += face(at, at + 1, at + n + 1) + face(at + 1, at + n + 2, at + n + 1);
            }
        MeshFabric fabric = plainFabric();
        fabric.shear = LinkStyle::Rods;
        const Part part = firstPart(sceneOf(preparedOf(meshOf(text.c_str())), fabric));
        const Particle& inner = part.particles[std::size_t((n / 2) * (n + 1) + n / 2)];

        // twice the energy per area of all links of a role that have stiffness w / L
        const auto energy = [&](LinkRole role, const Eigen::Matrix3d& strain) {
            double sum = 0.0;
            for (const Link& link : part.links) {
                if (link.role != role || (link.from != inner.id && link.to != inner.id))
                    continue;
                const Vec3 along = (findRow(part.particles, link.to)->position
                                    - findRow(part.particles, link.from)->position);
                const double stretch = along.dot(strain * along) / along.norm();
                sum += 0.5 * link.width / link.restLength * stretch * stretch;
            }
            return sum / (h * a);
        };
        // drawn by 1 along x under no load across, a sheet of modulus 1 gets narrower by 1/3
        Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();
        drawn(0, 0) = 1.0;
        drawn(1, 1) = -1.0 / 3.0;
        QVERIFY(std::abs(energy(LinkRole::Thread, drawn) - 1.0) < 1e-6);
        Eigen::Matrix3d sheared = Eigen::Matrix3d::Zero();
        sheared(0, 1) = sheared(1, 0) = 0.5; // g = 1
        QVERIFY(std::abs(energy(LinkRole::Thread, sheared) - 3.0 / 8.0) < 1e-6);
        QVERIFY(std::abs(energy(LinkRole::Bias, sheared) - 1.0) < 1e-6);
    }

    // --- parts, groups, materials
    // ------------------------------------------------------------------

    void objectsBecomePartsOrGroups()
    {
        const QByteArray two =
            QByteArray(cubeOfQuads) + "o flag\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 9 10 11\n";
        const PolygonMesh mesh = meshOf(two.constData());
        MeshShape shape;
        const Scene one = sceneOf(preparedOf(mesh, shape));
        int groups = 0;
        for (const Entry& entry : one.items)
            if (const Group* group = std::get_if<Group>(&entry.item)) {
                QCOMPARE(group->members.size(), group->name == "cube" ? 12u : 1u);
                ++groups;
            }
        QCOMPARE(groups, 2);

        shape.parts = MeshParts::PerObject;
        MeshFabric fabric = plainFabric();
        fabric.carrier = FabricKind::Panels; // threads of triangles are told of
        const Scene many = sceneOf(preparedOf(mesh, shape), fabric);
        std::vector<std::string> names;
        forEachPart(many, [&](Id, const Part& part) { names.push_back(part.name); });
        QCOMPARE(names, (std::vector<std::string>{"cube", "flag"}));
        QVERIFY(problemsOf(many).empty());
    }

    // Groups of a file without objects, or with one, are what objects are; where there are several,
    // each stays whole, and so does one that has a single group.
    void groupsOfTheOnlyObject_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("between");
        QTest::addColumn<QStringList>("objects");
        QTest::newRow("no object")
            << QByteArray("g left\n") << QByteArray("g right\n") << QStringList{"left", "right"};
        QTest::newRow("one object") << QByteArray("o A\ng left\n") << QByteArray("g right\n")
                                    << QStringList{"left", "right"};
        QTest::newRow("one group")
            << QByteArray("o A\ng left\n") << QByteArray() << QStringList{"A"};
        QTest::newRow("a group later")
            << QByteArray("o A\n") << QByteArray("g right\n") << QStringList{"A", "right"};
        QTest::newRow("two objects")
            << QByteArray("o A\ng left\n") << QByteArray("o B\ng right\n") << QStringList{"A", "B"};
    }
    void groupsOfTheOnlyObject()
    {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, between);
        QFETCH(QStringList, objects);
        const QByteArray text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n" + before
                                + "f 1 2 3 4\n" + between + "f 2 5 6 3\n";
        const PolygonMesh mesh = meshOf(text.constData());
        QStringList read;
        for (const std::string& name : mesh.objects)
            read << QString::fromStdString(name);
        QCOMPARE(read, objects);
        QCOMPARE(mesh.object, (std::vector<int>{0, int(objects.size()) - 1}));
    }

    // What is wrong in an OBJ is named with its own remedy.
    void flawsHaveRemedies_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* text, const char* says) {
            QTest::newRow(name) << QByteArray(text) << QString(says);
        };
        row("decimal commas", "v 0,0 0,0 0,0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
            "line 1: \"0,0\" is a number with a decimal comma. An OBJ has decimal points");
        row("of texture", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0,5\nf 1 2 3\n",
            "line 4: \"0,5\" is a number with a decimal comma");
        row("a face of two corners", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n",
            "line 4: a face needs three corners. Delete it");
        row("a vertex too high", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
            "line 4: a face names vertex 9 of 3. Vertices count from 1");
    }
    void flawsHaveRemedies()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        const auto refused = readPolygonFile(write("flaw.obj", text).toStdString());
        QVERIFY(!refused);
        const QString message = QString::fromStdString(refused.message().english());
        QVERIFY2(message.contains(says) && !message.contains("cut off"), qPrintable(message));
    }

    // An object whose faces have no area is left out and named, and the others come in; where all
    // are so, the mesh is refused.
    void objectsWithoutAreaAreLeftOut()
    {
        const QByteArray line = "o batten\nv 5 0 0\nv 6 0 0\nv 7 0 0\n";
        const QByteArray both = QByteArray(cubeOfQuads) + line + "f 9 10 11\n";
        MeshShape shape;
        shape.parts = MeshParts::PerObject;
        const PreparedMesh mesh = preparedOf(meshOf(both.constData()), shape);
        const Scene scene = sceneOf(mesh);
        std::size_t parts = 0;
        forEachPart(scene, [&](Id, const Part&) { ++parts; });
        QCOMPARE(parts, 1u);
        QCOMPARE(mesh.report.count(MeshFault::EmptyObjects), 1u);
        const std::vector<MeshFinding> findings = mesh.report.findings();
        QVERIFY(std::ranges::any_of(findings, [](const MeshFinding& finding) {
            return finding.text().english().find("batten") != std::string::npos;
        }));
        const PolygonMesh flat = meshOf((line + "f 1 2 3\no boom\nf 3 2 1\n").constData());
        QVERIFY(!prepared(flat, shape));
    }

    // Red and blue panels: two materials with their colours, or one for all.
    void materialsOfTheFile()
    {
        PolygonMesh mesh = meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"
                                  "usemtl blue\nf 1 3 4\nusemtl unused\n");
        readMtl("newmtl red\nKd spectral red.rfl\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n", mesh);
        const PreparedMesh ready = preparedOf(mesh);
        const auto materialsOf = [](const Scene& scene) {
            std::vector<Material> materials;
            for (const Entry& entry : scene.items)
                if (const Material* material = std::get_if<Material>(&entry.item))
                    materials.push_back(*material);
            return materials;
        };
        QCOMPARE(materialsOf(sceneOf(ready)).size(), 1u);
        MeshFabric fabric = plainFabric();
        fabric.isPerFileMaterial = true;
        fabric.carrier = FabricKind::Panels; // threads of triangles are told of
        const Scene scene = sceneOf(ready, fabric);
        const std::vector<Material> materials = materialsOf(scene);
        QCOMPARE(materials.size(), 2u);
        QCOMPARE(materials[0].name, "red");
        QCOMPARE(materials[0].color, "#ff0000");
        QCOMPARE(materials[1].color, "#0000ff");
        QCOMPARE(materials[1].membraneStiffness, fabric.material.membraneStiffness);
        const Part part = firstPart(scene);
        QCOMPARE(nameOf(*findItem(scene, part.panels[0].material)), "red");
        QCOMPARE(nameOf(*findItem(scene, part.panels[1].material)), "blue");
        QVERIFY(problemsOf(scene).empty());

        PolygonMesh lone = meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\n");
        readMtl("newmtl red\nKd 1 0 0\n", lone);
        const Material made = materialsOf(sceneOf(preparedOf(lone), fabric)).at(0);
        QCOMPARE(made.name, "red");
        QCOMPARE(made.color, "#ff0000");
    }

    void theEditIsOneStepAndBack()
    {
        Scene scene;
        const Scene empty = scene;
        const MeshImport made = importOf(preparedOf(meshOf(cubeOfQuads)), plainFabric(), scene);
        const Edit inverse = apply(scene, made.edit);
        QVERIFY(findItem<Part>(scene, made.parts.front()));
        const Scene imported = scene;
        (void)apply(scene, inverse);
        QCOMPARE(scene.items.size(), empty.items.size());
        // a second import finds the names taken
        Scene twice = imported;
        (void)apply(twice, importOf(preparedOf(meshOf(cubeOfQuads)), plainFabric(), twice).edit);
        std::vector<std::string> names;
        forEachPart(twice, [&](Id, const Part& part) { names.push_back(part.name); });
        QCOMPARE(names, (std::vector<std::string>{"sail", "sail 2"}));
    }

    void aMaterialNeedsAMass()
    {
        MeshFabric fabric = plainFabric();
        fabric.material.arealDensity.reset();
        const Result<MeshImport> refused =
            fabricOf(preparedOf(meshOf(cubeOfQuads)), fabric, "sail", {});
        QVERIFY(!refused);
        QVERIFY(refused.message().english().find("kg/m^2") != std::string::npos);
    }

    void cancelling()
    {
        const std::string text = sheet(120, 0.01, false);
        for (int stops = 0; stops < 4; ++stops) {
            int calls = 0;
            const Progress progress = [&](double share) {
                return share >= 0.0 && share <= 1.0 && calls++ < stops;
            };
            const PolygonMesh mesh = meshOf(text.c_str());
            QVERIFY(!prepared(mesh, {}, progress));
            calls = 0;
            QVERIFY(!fabricOf(preparedOf(mesh), plainFabric(), "sail", {}, progress));
        }
    }

    // 200 000 triangles in seconds, from file to edit.
    void largeMeshesAreQuick()
    {
        const int n = 316; // 2 x 316^2 = 199 712
        const QString file = write("large.obj", QByteArray::fromStdString(sheet(n, 0.01, false)));
        QElapsedTimer timer;
        timer.start();
        const Result<PolygonMesh> read = readPolygonFile(file.toStdString());
        QVERIFY(read);
        const MeshImport made = importOf(preparedOf(*read));
        QCOMPARE(made.panels, std::size_t(2 * n * n));
        QCOMPARE(made.particles, std::size_t((n + 1) * (n + 1)));
        QCOMPARE(made.rods, std::size_t(n * n + 2 * n * (n + 1)));
        qInfo("199 712 triangles in %lld ms", timer.elapsed());
    }
};

const RegisteredTest registered("test_mesh_import", runWithCore<TestMeshImport>);

} // namespace ripstop::test_mesh_import
#include "test_mesh_import.moc"
