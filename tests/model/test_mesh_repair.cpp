// Meshes that are not as they should be: what is reported, what is repaired, and what scale, axes
// and polygons become.
//
// Stages: faults are made one by one and have to be reported; then orientation of closed,
// one-sided and hollow pieces; scale and axes; tolerance, turning over, and texture.
#include "model/meshes.h"
#include "registered_test.h"
#include "shapes/mesh_file.h"

#include <QtTest>

namespace ripstop::test_mesh_repair {

class TestMeshRepair : public QObject, MeshFolder
{
    Q_OBJECT

private slots:
    // --- the report
    // -------------------------------------------------------------------------------

    void faults_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("triangles");
        const QByteArray cube = cubeOfQuads;
        const QByteArray square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        const auto row = [](const char* name, const QByteArray& text, MeshFault fault, int count,
                            int triangles) {
            QTest::newRow(name) << text << int(fault) << count << triangles;
        };
        row("two vertices that no face has", cube + "v 5 5 5\nv 6 6 6\n", MeshFault::LooseVertices,
            2, 12);
        row("a square with a vertex twice",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n",
            MeshFault::DuplicateVertices, 2, 2);
        row("a coarse square beside two fine ones",
            square + "v 1 0.5 0\nv 2 0 0\nv 2 0.5 0\nv 2 1 0\nf 2 6 7 5\nf 5 7 8 3\n",
            MeshFault::HangingVertices, 1, 7);
        const QByteArray sail = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 0 1\nv 1 0 1\nv 2 0 1\n"
                                "f 1 2 5 4\nf 2 3 6 5\n";
        row("a keel along two squares of a sail", sail + "v 0 -1 0\nv 2 -1 0\nf 1 3 8 7\n",
            MeshFault::HangingVertices, 1, 7);
        row("a keel of two squares within a sail",
            sail + "v 1 0 0.5\nv 1 -1 0\nv 1 -1 0.5\nv 1 -1 1\nf 2 7 9 8\nf 7 5 10 9\n",
            MeshFault::HangingVertices, 1, 10);
        row("a face of one line", square + "v 2 0 0\nv 3 0 0\nf 2 5 6\n",
            MeshFault::DegenerateFaces, 1, 2);
        row("a face with a corner twice", square + "f 1 2 2\n", MeshFault::DegenerateFaces, 1, 2);
        row("a face twice, once from behind", square + "f 1 4 3 2\n", MeshFault::DuplicateFaces, 1,
            2);
        row("a fin on an edge", square + "v 0 0 1\nv 1 0 1\nf 1 2 6 5\nv 0 0 -1\nf 1 2 7\n",
            MeshFault::NonManifoldEdges, 1, 5);
        row("one side of the cube from within", QByteArray(cube).replace("f 5 6 7 8", "f 5 8 7 6"),
            MeshFault::FlippedFaces, 1, 12);
        row("a square apart", cube + "v 5 0 0\nv 6 0 0\nv 6 1 0\nf 9 10 11\n",
            MeshFault::SeveralShells, 2, 13);
        row("a cube without a side", QByteArray(cube).replace("f 5 6 7 8\n", ""),
            MeshFault::OpenEdges, 4, 10);
        row("polygons", square, MeshFault::SplitPolygons, 1, 2);
        row("a square with a corner that is lifted",
            "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n", MeshFault::WarpedPolygons, 1, 2);
        row("a seam of the texture",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n"
            "f 1/1 2/2 3/3\nf 1/1 3/4 4/2\nf 2 5 3\n",
            MeshFault::TextureSeams, 1, 3);
        row("lines", square + "l 1 2 3\nl 2 4\n", MeshFault::StrayElements, 2, 2);
        row("a square of a thousand metres", "v 0 0 0\nv 1000 0 0\nv 1000 1000 0\nf 1 2 3\n",
            MeshFault::OddSize, 1, 1);
    }

    void faults()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, fault);
        QFETCH(int, count);
        QFETCH(int, triangles);
        const PreparedMesh mesh = preparedOf(meshOf(text.constData()));
        QCOMPARE(int(mesh.report.count(MeshFault(fault))), count);
        QCOMPARE(int(mesh.surfaces.front().triangles.size()), triangles);
        const auto findings = mesh.report.findings();
        const auto found = std::ranges::find(findings, MeshFault(fault), &MeshFinding::fault);
        QVERIFY(found != findings.end());
        QVERIFY(found->text().english().find('%') == std::string::npos);
        QVERIFY(MeshFault(fault) == MeshFault::OddSize
                || MeshFault(fault) == MeshFault::StrayElements || !found->places.empty());
    }

    // Corners at +d and -d in turn lie d from the plane in their middle. What is flat but for the
    // last digits of a file is not told; of several objects the farthest corner counts.
    void warpedPolygonsSayHowFar_data()
    {
        QTest::addColumn<double>("offset"); // m, of every second corner to either side
        QTest::addColumn<QString>("told");
        QTest::newRow("flat") << 0.0 << "";
        QTest::newRow("nearly flat") << 5e-4 << "";
        QTest::newRow("warped") << 0.05
                                << "2 polygons are not flat: corners lie up to 50 mm off their "
                                   "planes. The triangles that they became fold them along "
                                   "diagonals.";
    }
    void warpedPolygonsSayHowFar()
    {
        QFETCH(double, offset);
        QFETCH(QString, told);
        QByteArray text;
        int first = 1;
        for (const double d : {0.5 * offset, offset}) {
            text += "o square" + QByteArray::number(first) + '\n';
            for (const auto& [x, y, z] : {std::tuple(0, 0, d), std::tuple(1, 0, -d),
                                          std::tuple(1, 1, d), std::tuple(0, 1, -d)})
                text += "v " + QByteArray::number(x + 2 * first) + ' ' + QByteArray::number(y) + ' '
                        + QByteArray::number(z) + '\n';
            text += "f";
            for (int i = 0; i < 4; ++i)
                text += ' ' + QByteArray::number(first + i);
            text += '\n';
            first += 4;
        }
        MeshShape shape;
        shape.parts = MeshParts::PerObject;
        const auto mesh = prepared(meshOf(text.constData()), shape);
        QVERIFY(mesh);
        const auto findings = mesh->report.findings();
        const auto found =
            std::ranges::find(findings, MeshFault::WarpedPolygons, &MeshFinding::fault);
        QCOMPARE(found == findings.end() ? QString()
                                         : QString::fromStdString(found->text().english()),
                 told);
        QCOMPARE(mesh->report.count(MeshFault::SplitPolygons), 2u);
    }

    // Fabric larger than 30 m or smaller than 5 cm is told of, with the unit that would make it a
    // thing to fly: metres before centimetres before millimetres.
    void oddSizesNameTheLikelyUnit_data()
    {
        QTest::addColumn<double>("side"); // units of the file
        QTest::addColumn<double>("unit"); // m, chosen
        QTest::addColumn<QString>("told");
        QTest::newRow("100 cm read as metres")
            << 100.0 << 1.0
            << "The mesh is 100 m large, and hardly any fabric is: if its file is in centimetres, "
               "it is 1 m.";
        QTest::newRow("2500 mm read as metres")
            << 2500.0 << 1.0
            << "The mesh is 2500 m large, and hardly any fabric is: if its file is in millimetres, "
               "it is 2.5 m.";
        QTest::newRow("3 m read as millimetres")
            << 3.0 << 1e-3
            << "The mesh is only 0.003 m large: if its file is in metres, it is 3 m.";
        QTest::newRow("no unit helps")
            << 0.01 << 1.0
            << "The mesh is only 0.01 m large: if that is wrong, scale it to a size.";
        QTest::newRow("a large kite") << 29.0 << 1.0 << "";
        QTest::newRow("a small one") << 6.0 << 1e-2 << "";
    }

    void oddSizesNameTheLikelyUnit()
    {
        QFETCH(double, side);
        QFETCH(double, unit);
        QFETCH(QString, told);
        PolygonMesh mesh = meshOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        for (Vec3& point : mesh.points)
            point *= side;
        MeshShape shape;
        shape.scale = unit;
        const auto said = [&] {
            const auto findings = prepared(mesh, shape)->report.findings();
            const auto found = std::ranges::find(findings, MeshFault::OddSize, &MeshFinding::fault);
            return found == findings.end() ? QString()
                                           : QString::fromStdString(found->text().english());
        };
        QCOMPARE(said(), told);
        if (told.isEmpty())
            return;
        mesh.unit = unit; // no other one can be chosen then
        QVERIFY(said().endsWith("if its file has a wrong unit, scale it to a size."));
        shape.size = 60.0; // m, by choice
        QCOMPARE(said(), QString("The mesh is scaled to 60 m: hardly any fabric has such a size."));
    }

    // However rounding has it, what hangs on a side makes no sliver: a coarse square beside two
    // fine ones, in any position, and a triangle whose side is longer than it is high.
    void hangingPointsMakeNoSlivers()
    {
        const char* const meshes[]{"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0.3 0\nv 2 0 0\n"
                                   "v 2 0.3 0\nv 2 1 0\nf 1 2 3 4\nf 2 6 7 5\nf 5 7 8 3\n",
                                   "v 0 0 0\nv 3 0 0\nv 1.4 1 0\nv 1.1 0 0\nv 0 -1 0\nv 3 -1 0\n"
                                   "f 1 2 3\nf 1 5 4\nf 4 5 6 2\n"};
        for (const char* const text : meshes)
            for (int i = 0; i < 200; ++i) {
                PolygonMesh mesh = meshOf(text);
                const Eigen::AngleAxisd turn(0.1 * i, Vec3(1.0, 0.3 * i, 2.0).normalized());
                for (Vec3& point : mesh.points)
                    point = turn * point + Vec3(0.01 * i, 0.0, 1.0);
                mesh.points[4].z() += 1e-6 * std::sin(double(i)); // within the weld tolerance
                const PreparedMesh ready = preparedOf(mesh);
                QCOMPARE(ready.report.count(MeshFault::HangingVertices), 1u);
                const RepairedMesh& surface = ready.surfaces.front();
                for (const auto& [a, b, c] : surface.triangles) {
                    const auto& at = surface.mesh.points;
                    const Vec3& from = at[std::size_t(a)];
                    const double area =
                        0.5 * (at[std::size_t(b)] - from).cross(at[std::size_t(c)] - from).norm();
                    QVERIFY2(area > 0.1, qPrintable(QString::number(area)));
                }
            }
    }

    void closedPiecesPointOutwards()
    {
        const PreparedMesh mesh = preparedOf(fileOf("inside.stl", cubeAsStl(true)));
        QCOMPARE(mesh.report.count(MeshFault::InsideOutShells), 1u);
        QCOMPARE(mesh.report.count(MeshFault::FlippedFaces), 0u);
        double volume = 0.0;
        for (const auto& [a, b, c] : mesh.surfaces.front().triangles) {
            const auto& at = mesh.surfaces.front().mesh.points;
            volume += at[std::size_t(a)].dot(at[std::size_t(b)].cross(at[std::size_t(c)])) / 6.0;
        }
        QVERIFY(std::abs(volume - 1.0) < 1e-12);
    }

    void moebiusStripHasNoOutside()
    {
        std::string text;
        const int n = 12;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * M_PI * i / n;
            for (const double out : {-0.3, 0.3}) {
                const double r = 1.0 + out * std::cos(0.5 * angle);
                text += "v " + std::to_string(r * std::cos(angle)) + " "
                        + std::to_string(out * std::sin(0.5 * angle)) + " "
                        + std::to_string(r * std::sin(angle)) + "\n";
            }
        }
        for (int i = 0; i < n; ++i) {
            const int a = 2 * i + 1;
            const bool isLast = i == n - 1;
            const int c = isLast ? 2 : a + 2; // the ends meet the other way round
            const int d = isLast ? 1 : a + 3;
            text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(d)
                    + " " + std::to_string(c) + "\n";
        }
        const PreparedMesh mesh = preparedOf(meshOf(text.c_str()));
        QCOMPARE(mesh.report.count(MeshFault::OneSidedEdges), 1u);
    }

    // --- geometry
    // -----------------------------------------------------------------------------------

    void hollowPolygonsKeepTheirArea()
    {
        // an L of three unit squares, an arrow head of area 1, and a comb
        const PreparedMesh ell = preparedOf(
            meshOf("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n"));
        QCOMPARE(ell.surfaces.front().triangles.size(), 4u);
        QVERIFY(std::abs(areaOfTriangles(ell.surfaces.front()) - 3.0) < 1e-12);
        // corners (0,0), (2,-1), (0.5,0), (2,1)... by the shoelace formula: 2 (0.5 x 1) = 1.5 - 0
        const PreparedMesh arrow =
            preparedOf(meshOf("v 0 0 0\nv -1 -1 0\nv 2 0 0\nv -1 1 0\nf 1 2 3 4\n"));
        QVERIFY(std::abs(areaOfTriangles(arrow.surfaces.front()) - 2.0) < 1e-12);
        QCOMPARE(arrow.surfaces.front().triangles.size(), 2u);
    }

    void scaleAndAxes_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<int>("up");
        QTest::addColumn<double>("wanted");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("depth");
        // the box of the file: 2 along x, 3 along y, 5 along z
        QTest::newRow("metres, y up") << 1.0 << 1 << 0.0 << 2.0 << 3.0 << 5.0;
        QTest::newRow("millimetres, z up") << 1e-3 << 2 << 0.0 << 2e-3 << 5e-3 << 3e-3;
        QTest::newRow("inches, x up")
            << 0.0254 << 0 << 0.0 << 3 * 0.0254 << 2 * 0.0254 << 5 * 0.0254;
        QTest::newRow("a wanted size") << 1.0 << 1 << 1.0 << 0.4 << 0.6 << 1.0;
    }

    void scaleAndAxes()
    {
        QFETCH(double, scale);
        QFETCH(int, up);
        QFETCH(double, wanted);
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, depth);
        const PolygonMesh mesh =
            meshOf("v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 2 3 5\nf 1 2 3 4\nf 2 5 3\n");
        MeshShape shape;
        shape.scale = scale;
        shape.up = UpAxis(up);
        if (wanted > 0.0)
            shape.size = wanted;
        const PreparedMesh result = preparedOf(mesh, shape);
        QVERIFY((result.size - Vec3(width, height, depth)).norm() < 1e-12);
    }

    // What points up in the file points up in the scene, and left and right are not swapped.
    void axesKeepHandedness()
    {
        for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
            MeshShape shape;
            shape.up = up;
            const PreparedMesh cube = preparedOf(meshOf(cubeOfQuads), shape);
            QCOMPARE(cube.report.count(MeshFault::InsideOutShells), 0u);
        }
        MeshShape shape;
        shape.up = UpAxis::Z;
        const PreparedMesh tall = preparedOf(meshOf("v 0 0 0\nv 1 0 0\nv 0 0 7\nf 1 2 3\n"), shape);
        const auto& points = tall.surfaces.front().mesh.points;
        QVERIFY((points[2] - Vec3(0.0, 7.0, 0.0)).norm() < 1e-12);
    }

    void weldTolerance()
    {
        const PolygonMesh mesh = meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.001 0 0\nv 1.001 1 0\n"
                                        "v 0 1 0\nf 1 2 3\nf 4 5 6\n");
        MeshShape shape;
        shape.weldTolerance = 0.0005;
        QCOMPARE(preparedOf(mesh, shape).report.count(MeshFault::DuplicateVertices), 0u);
        shape.weldTolerance = 0.002;
        const PreparedMesh joined = preparedOf(mesh, shape);
        QCOMPARE(joined.report.count(MeshFault::DuplicateVertices), 2u);
        QCOMPARE(joined.surfaces.front().mesh.points.size(), 4u);
        shape.weldTolerance = 0.0; // what is equal is joined even so
        QCOMPARE(
            preparedOf(fileOf("zero.stl", cubeAsStl()), shape).surfaces.front().mesh.points.size(),
            8u);
    }

    void flippedOver()
    {
        const char* const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        const auto normal = [](const PreparedMesh& mesh) {
            return doubleArea(mesh.surfaces.front().triangles.front(),
                              mesh.surfaces.front().mesh.points);
        };
        MeshShape shape;
        QVERIFY(normal(preparedOf(meshOf(triangle), shape)).z() > 0.0);
        shape.isFlipped = true;
        QVERIFY(normal(preparedOf(meshOf(triangle), shape)).z() < 0.0);
    }

    void textureIsKept()
    {
        const Part& part = firstPart(sceneOf(preparedOf(meshOf(sheet(4, 0.5, true).c_str()))));
        for (const Particle& particle : part.particles) {
            QVERIFY(std::abs(particle.textureU - particle.position.x() / 2.0) < 1e-6);
            QVERIFY(std::abs(particle.textureV - particle.position.y() / 2.0) < 1e-6);
        }
    }
};

const RegisteredTest registered("test_mesh_repair", runWithCore<TestMeshRepair>);

} // namespace ripstop::test_mesh_repair
#include "test_mesh_repair.moc"
