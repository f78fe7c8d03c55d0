// Meshes of VTK: a square sail of two triangles with a bridle below it, as PolyData and as
// UnstructuredGrid, with texture points, masses and materials; Ripstop's own files; and files that
// are cut, wrong or ask for too much, each of which ends in a sentence.
#include "model/cli_call.h"
#include "model/meshes.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_vtk_meshes {

namespace {

// Corners of a square at z = 0, and the end of a bridle 1 m before the middle. Lines go along an
// edge, which is the fabric's own, and from two corners to the bridle's end.
const char* const points = "0 0 0  1 0 0  1 1 0  0 1 0  0.5 0.5 1";
const char* const texture = "0 0  1 0  1 1  0 1  0 0";
const char* const masses = "0.1 0.2 0.3 0.4 0.5";

QByteArray array(const char* type, const char* name, int components, const QByteArray& values)
{
    return QByteArray("<DataArray type=\"") + type + "\" Name=\"" + name
           + "\" NumberOfComponents=\"" + QByteArray::number(components) + "\" format=\"ascii\">"
           + values + "</DataArray>\n";
}

QByteArray pointData()
{
    return "<PointData TCoords=\"somewhere\">" + array("Float32", "somewhere", 2, texture)
           + array("Float64", "Mass (kg)", 1, masses) + "</PointData>\n<Points>"
           + array("Float64", "Points", 3, points) + "</Points>\n";
}

QByteArray polyData()
{
    return "<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
           "<Piece NumberOfPoints=\"5\" NumberOfVerts=\"0\" NumberOfLines=\"2\" "
           "NumberOfStrips=\"0\" NumberOfPolys=\"2\">\n"
           + pointData() + "<CellData>" + array("Int32", "material", 1, "0 0 7 9")
           + "</CellData>\n<Lines>" + array("Int64", "connectivity", 1, "0 1  0 4 2")
           + array("Int64", "offsets", 1, "2 5") + "</Lines>\n<Polys>"
           + array("Int64", "connectivity", 1, "0 1 2  0 2 3") + array("Int64", "offsets", 1, "3 6")
           + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

// The same as a quad, with the corners by rows; and a tetrahedron, which is no fabric.
QByteArray grid()
{
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n"
           "<Piece NumberOfPoints=\"5\" NumberOfCells=\"4\">\n"
           + pointData() + "<Cells>"
           + array("Int64", "connectivity", 1, "0 1 3 2  0 4  4 2  0 1 2 4")
           + array("Int64", "offsets", 1, "4 6 8 12") + array("UInt8", "types", 1, "8 3 3 10")
           + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace

class TestVtkMeshes : public QObject, MeshFolder
{
    Q_OBJECT

private slots:
    void polygonsLinesAndArrays()
    {
        const PolygonMesh mesh = *readPolygonFile(write("sail.vtp", polyData()).toStdString());
        QCOMPARE(mesh.points.size(), 5u);
        QCOMPARE(mesh.points[4], Vec3(0.5, 0.5, 1.0));
        QCOMPARE(mesh.corners, (std::vector<int>{0, 1, 2, 0, 2, 3}));
        QCOMPARE(mesh.texture[2], (PolygonMesh::TexturePoint{1.0, 1.0}));
        QCOMPARE(mesh.lines, (std::vector<std::array<int, 2>>{{0, 4}, {4, 2}}));
        QCOMPARE(mesh.strayElements, 1u); // the line along the edge
        QCOMPARE(mesh.mass, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
        QCOMPARE(mesh.materials.size(), 2u);
        QCOMPARE(mesh.materials[1].name, std::string("material 9"));
        QCOMPARE(mesh.material, (std::vector<int>{0, 1}));
    }

    void gridOfCells()
    {
        const PolygonMesh mesh = *readPolygonFile(write("sail.vtu", grid()).toStdString());
        QCOMPARE(mesh.corners, (std::vector<int>{0, 1, 2, 3}));
        QCOMPARE(mesh.faceCount(), 1u);
        QCOMPARE(mesh.lines.size(), 2u);
        QCOMPARE(mesh.strayElements, 1u); // the tetrahedron
    }

    // The bridle is two links that only pull, and the masses are those of the file, whatever the
    // fabric weighs.
    void becomesFabric()
    {
        const QString scene = write("sail.ripstop.json", "");
        for (const bool threads : {false, true}) {
            QStringList import{
                "import", write("sail.vtp", polyData()), "--preset", "skytex_27", "-o", scene,
                "--json"};
            if (threads)
                import << "--fabric"
                       << "threads";
            const Outcome outcome = call(import);
            QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
            const QJsonObject info = call({"info", scene, "--json"}).json();
            QCOMPARE(info["particles"].toInt(), 5);
            QCOMPARE(info["panels"].toInt(), 2);
            QCOMPARE(info["mass"].toDouble(), 1.5);
            // the bridle, and the sides of two triangles
            QCOMPARE(info["links"].toInt(), threads ? 2 + 5 : 2);
        }
    }

    void ownFilesComeBack()
    {
        const QString vtp = write("kite.vtp", "");
        QCOMPARE(call({"export", scene("delta_kite"), "-o", vtp}).exitCode, 0);
        const PolygonMesh mesh = *readPolygonFile(vtp.toStdString());
        QCOMPARE(mesh.points.size(), 152u);
        QCOMPARE(mesh.faceCount(), 221u);
        QVERIFY(!mesh.lines.empty()); // bridle and line
    }

    // A woven sheet with springs over two cells, which bend it, comes back as fabric without lines,
    // whatever the format.
    void sheetsComeBackWithoutLines_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::newRow("VTP") << "vtp";
        QTest::newRow("OBJ") << "obj";
        QTest::newRow("glTF") << "glb";
    }
    void sheetsComeBackWithoutLines()
    {
        QFETCH(QString, ending);
        const QString sheet = write("sheet.ripstop.json", "");
        const QString mesh = write("sheet." + ending, "");
        QCOMPARE(call({"build", "cloth", "cloth=ideal", "columns=10", "rows=10", "sphere=0", "-o",
                       sheet})
                     .exitCode,
                 0);
        QCOMPARE(call({"export", sheet, "-o", mesh}).exitCode, 0);
        const Outcome outcome = call({"import", mesh, "-o", sheet, "--json"});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const QJsonObject read = outcome.json()["meshes"].toArray().first().toObject();
        QCOMPARE(read["lines"].toObject()["count"].toInt(), 0);
    }

    void badFilesEndInASentence_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("says");
        const QByteArray whole = polyData();
        const auto changed = [&](const char* from, const char* to) {
            return QByteArray(whole).replace(from, to);
        };
        QTest::newRow("cut off") << whole.left(700) << "line ";
        QTest::newRow("no XML") << QByteArray("v 0 0 0\n") << "cannot be read";
        QTest::newRow("another type") << grid() << "cannot be read";
        QTest::newRow("a point that is not there")
            << changed("0 1 2  0 2 3", "0 1 2  0 2 99") << "has point 99 of 5";
        QTest::newRow("a point below 0") << changed("0 1 2  0 2 3", "0 1 2  0 2 -7") << "point -7";
        QTest::newRow("too few values") << changed("1 1 0  0 1 0", "1 1") << "cannot be read";
        QTest::newRow("more points than memory")
            << changed("NumberOfPoints=\"5\"", "NumberOfPoints=\"90000000000\"") << "";
        QTest::newRow("no faces") << changed("NumberOfPolys=\"2\"", "NumberOfPolys=\"0\"") << "";
        QTest::newRow("nothing") << QByteArray("<VTKFile type=\"PolyData\"></VTKFile>") << "";
    }

    void badFilesEndInASentence()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, says);
        const QString file = write("bad.vtp", content);
        const auto mesh = readPolygonFile(file.toStdString());
        QVERIFY(!mesh);
        const QString why = QString::fromStdString(mesh.message().english());
        QVERIFY2(why.contains("bad.vtp") && why.contains(says) && why.endsWith('.'),
                 qPrintable(why));
    }

    // Own files, compressed, with a byte changed anywhere: read or refused, and never believed.
    void scrambledFiles()
    {
        const QString vtp = write("kite.vtp", "");
        QCOMPARE(call({"export", scene("delta_kite"), "-o", vtp}).exitCode, 0);
        QFile file(vtp);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        for (int i = 0; i < 40; ++i) {
            QByteArray scrambled = whole;
            const qsizetype at = (whole.size() * i) / 40;
            scrambled[at] = char(scrambled[at] ^ (1 << i % 8));
            const auto mesh = readPolygonFile(write("scrambled.vtp", scrambled).toStdString());
            if (mesh) {
                for (const int corner : mesh->corners)
                    QVERIFY(corner >= 0 && std::size_t(corner) < mesh->points.size());
            } else {
                QVERIFY(mesh.message().english().ends_with("."));
            }
        }
    }
};

const RegisteredTest registered("test_vtk_meshes", runPlain<TestVtkMeshes>);

} // namespace ripstop::test_vtk_meshes
#include "test_vtk_meshes.moc"
