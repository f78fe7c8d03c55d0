// Distances, normals and ways into solid shapes (validation B6 to B8), and the files of shapes.
//
// Stages: boxes and spheres, from outside, inside and at edges, and crossed in one step; height
// fields on planes, saddles and ridges; meshes, closed and open; at the end the files that shapes
// are read from, and what is said of flawed ones.
#include "model/systems.h"
#include "registered_test.h"
#include "shapes/shape_files.h"

#include <QtTest>

#include <QFile>
#include <QTemporaryDir>

#include <Eigen/Geometry>

#include <limits>
#include <map>
#include <numbers>

namespace ripstop::test_shapes {

namespace {

const Vec3 half(0.5, 1.0, 1.5); // m

// A grid of heights of a function of x and z on a field of `size`.
template <typename Height>
HeightGrid gridOf(int columns, int rows, const Vec3& size, Height height)
{
    HeightGrid grid{columns, rows, {}};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            grid.height.push_back(height(size.x() * (double(column) / (columns - 1) - 0.5),
                                         size.z() * (double(row) / (rows - 1) - 0.5)));
    return grid;
}

// A sphere of radius 1 as a mesh of 20 x 4^n triangles: an icosahedron whose sides are halved.
TriangleTree ballMesh(int halvings)
{
    const double g = std::numbers::phi;
    std::vector<Vec3> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g}) {
            points.push_back(Vec3(0.0, a, b).normalized());
            points.push_back(Vec3(a, b, 0.0).normalized());
            points.push_back(Vec3(b, 0.0, a).normalized());
        }
    std::vector<std::array<int, 3>> triangles;
    const double edge = 2.0 / std::sqrt(1.0 + g * g);
    const auto joined = [&](int i, int j) {
        return (points[std::size_t(i)] - points[std::size_t(j)]).norm() < 1.01 * edge;
    };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k)
                if (joined(i, j) && joined(j, k) && joined(i, k)) {
                    const Vec3 &a = points[std::size_t(i)], &b = points[std::size_t(j)],
                               &c = points[std::size_t(k)];
                    const bool outwards = (b - a).cross(c - a).dot(a) > 0.0;
                    triangles.push_back({i, outwards ? j : k, outwards ? k : j});
                }
    for (int n = 0; n < halvings; ++n) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int i, int j) {
            const auto [found, isNew] = middles.emplace(std::minmax(i, j), int(points.size()));
            if (isNew)
                points.push_back((points[std::size_t(i)] + points[std::size_t(j)]).normalized());
            return found->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::array<int, 3>& part :
                 {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
                finer.push_back(part);
        }
        triangles = std::move(finer);
    }
    return {points, triangles};
}

TriangleTree squareMesh() // open, 2 m wide, at y = 0
{
    return {{{-1.0, 0.0, -1.0}, {1.0, 0.0, -1.0}, {1.0, 0.0, 1.0}, {-1.0, 0.0, 1.0}},
            {{0, 2, 1}, {0, 3, 2}}};
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

} // namespace

class TestShapes : public QObject
{
    Q_OBJECT

private slots:
    // B6: from 26 directions the nearest place is on a face, an edge or a corner, and the distance
    // is |max(|p| - half, 0)|.
    void boxOutside()
    {
        std::array<int, 4> found{};
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const Vec3 side(x, y, z);
                    const int axes = std::abs(x) + std::abs(y) + std::abs(z);
                    if (axes == 0)
                        continue;
                    const Vec3 point = side.cwiseProduct(half + Vec3::Constant(0.3));
                    const Nearest near = nearestOnBox(half, point);
                    QVERIFY(isNear(near.distance, 0.3 * std::sqrt(double(axes)), 1e-15));
                    QVERIFY(isNear(near.normal, side.normalized(), 1e-15));
                    ++found[std::size_t(axes)];
                }
        QCOMPARE(found, (std::array{0, 6, 12, 8}));
    }

    // B6: from inside, the nearest of six faces.
    void boxInside()
    {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                Vec3 point(0.01, -0.02, 0.03);
                point[axis] = side * (half[axis] - 0.1);
                const Nearest near = nearestOnBox(half, point);
                QVERIFY(isNear(near.distance, -0.1, 1e-15));
                QVERIFY(isNear(near.normal, side * Vec3::Unit(axis), 0.0));
                const auto touch = touchBox(half, 0.0, point, point);
                QVERIFY(touch && isNear(touch->surface[axis], side * half[axis], 1e-15));
            }
        QCOMPARE(nearestOnBox(half, Vec3::Zero()).distance, -0.5);
    }

    // B6: what falls on the edge of a box with a margin meets a quarter of a cylinder.
    void boxEdge()
    {
        const double margin = 0.1;
        const Vec3 normal = Vec3(1.0, 1.0, 0.0).normalized();
        const Vec3 edge(half.x(), half.y(), 0.2);
        const auto touch = touchBox(half, margin, edge + 0.2 * normal, edge + 0.04 * normal);
        QVERIFY(touch);
        QVERIFY(isNear(touch->normal, normal, 1e-14));
        QVERIFY(isNear(touch->surface, edge + margin * normal, 1e-14));
        QVERIFY(!touchBox(half, margin, edge + 0.2 * normal, edge + 0.101 * normal));
    }

    // B8: a plate of 1 cm, crossed in one step, from every side; and one that is only passed by.
    void thinBox()
    {
        const Vec3 plate(1.0, 0.005, 1.0);
        for (const double side : {-1.0, 1.0})
            for (const double depth : {0.001, 0.005, 0.009, 0.0101, 0.17, 10.0}) {
                const Vec3 from(0.3, side * 0.02, 0.1), to(0.31, side * (0.005 - depth), 0.1);
                const auto touch = touchBox(plate, 0.0, from, to);
                QVERIFY(touch);
                QVERIFY(isNear(touch->normal, Vec3(0.0, side, 0.0), 0.0));
                QVERIFY(isNear(touch->surface, Vec3(0.31, side * 0.005, 0.1), 1e-15));
            }
        QVERIFY(!touchBox(plate, 0.0, {1.1, 0.02, 0.0}, {1.05, -0.02, 0.0}));
        QVERIFY(!touchBox(plate, 0.0, {0.0, 0.02, 0.0}, {0.5, 0.0051, 0.0}));
    }

    void thinSphere()
    {
        for (const double x : {0.0, 0.02, 0.049}) {
            const auto touch = touchSphere(0.05, {x, 0.5, 0.0}, {x, -0.5, 0.0});
            QVERIFY(touch);
            const Vec3 entry(x, std::sqrt(0.0025 - x * x), 0.0);
            QVERIFY(isNear(touch->normal, entry / 0.05, 1e-12));
            QVERIFY((touch->surface - entry).dot(touch->normal) > -1e-12);
        }
        QVERIFY(!touchSphere(0.05, {0.0501, 0.5, 0.0}, {0.0501, -0.5, 0.0}));
        QVERIFY(!touchSphere(0.05, {0.0, 0.5, 0.0}, {0.0, 0.06, 0.0}));
    }

    // B7: on a plane and on a saddle, height and normal are exact everywhere.
    void bilinear()
    {
        const Vec3 size(8.0, 1.0, 6.0);
        const auto plane =
            gridOf(5, 7, size, [](double x, double z) { return 0.25 * x - 0.5 * z + 3.0; });
        const auto saddle = gridOf(9, 4, size, [](double x, double z) { return 0.1 * x * z; });
        Dice dice(7);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 p(dice(-4.0, 4.0), 0.0, dice(-3.0, 3.0));
            const Ground flat = groundAt(plane, size, p);
            QVERIFY(isNear(flat.height, 0.25 * p.x() - 0.5 * p.z() + 3.0, 1e-13));
            QVERIFY(isNear(flat.normal, Vec3(-0.25, 1.0, 0.5).normalized(), 1e-13));
            const Ground bent = groundAt(saddle, size, p);
            QVERIFY(isNear(bent.height, 0.1 * p.x() * p.z(), 1e-13));
            QVERIFY(isNear(bent.normal, Vec3(-0.1 * p.z(), 1.0, -0.1 * p.x()).normalized(), 1e-12));
        }
    }

    // A ridge of one cell, thinner than the way of one step, holds.
    void thinRidge()
    {
        const Vec3 size(10.0, 1.0, 10.0);
        const auto ridge =
            gridOf(101, 101, size, [](double x, double) { return std::abs(x) < 0.01 ? 1.0 : 0.0; });
        const auto touch = touchGround(ridge, size, 0.0, {-0.5, 0.5, 0.0}, {0.5, 0.5, 0.0});
        QVERIFY(touch);
        QVERIFY(touch->normal.x() < -0.9);
        QVERIFY(touch->surface.x() < 0.0
                || touch->surface.y() >= groundAt(ridge, size, touch->surface).height - 1e-6);
    }

    void hillsAreTheSame()
    {
        const HeightGrid one = generatedHills(256, 1, 0.25);
        QCOMPARE(one.columns, 256);
        QCOMPARE(one.rows, 256);
        QVERIFY(one == generatedHills(256, 1, 0.25));
        QVERIFY(!(one == generatedHills(256, 2, 0.25)));
        const auto [low, high] = std::minmax_element(one.height.begin(), one.height.end());
        QCOMPARE(*low, 0.0);
        QCOMPARE(*high, 1.0);
        double steepest = 0.0; // smooth: no cell has more than a tenth of the height
        for (std::size_t i = 1; i < one.height.size(); ++i)
            if (i % 256 != 0)
                steepest = std::max(steepest, std::abs(one.height[i] - one.height[i - 1]));
        QVERIFY2(steepest < 0.1, told(steepest, 0.1));
    }

    // B5: nearest places on the mesh of a unit sphere are at radius 1, within what the mesh has.
    void meshIsASphere()
    {
        const TriangleTree ball = ballMesh(3);
        QCOMPARE(ball.faces().size(), std::size_t(1280));
        QVERIFY(ball.isClosed());
        Dice dice(3);
        for (int i = 0; i < 500; ++i) {
            const Vec3 p = dice.vector(2.0);
            const auto near = ball.nearest(p, 10.0);
            QVERIFY(near);
            QVERIFY2(isNear(near->place.norm(), 1.0, 0.01), told(near->place.norm(), 1.0));
            QVERIFY((p - near->place).dot(near->normal) * (p.norm() - 1.0) > 0.0
                    || std::abs(p.norm() - 1.0) < 0.01);
            double least = 100.0; // as without the tree
            for (const auto& face : ball.faces())
                for (const int corner : face.corner)
                    least = std::min(least, (p - ball.points()[std::size_t(corner)]).norm());
            QVERIFY(near->distance <= least);
            QVERIFY(!ball.nearest(p, near->distance));
        }
    }

    // Every way from far outside to the middle meets the mesh, also through edges and corners.
    void nothingSlipsThrough()
    {
        const TriangleTree ball = ballMesh(2);
        for (const Vec3& corner : ball.points())
            QVERIFY(ball.firstHit(3.0 * corner, 0.1 * corner));
        for (const auto& face : ball.faces())
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 middle = 0.5
                                    * (ball.points()[std::size_t(face.corner[k])]
                                       + ball.points()[std::size_t(face.corner[(k + 1) % 3])]);
                const auto hit = ball.firstHit(3.0 * middle, Vec3::Zero());
                QVERIFY(hit && isNear(hit->share, 2.0 / 3.0, 1e-9));
            }
        QVERIFY(!ball.firstHit({2.0, 1.01, 0.0}, {-2.0, 1.01, 0.0}));
    }

    // An open mesh holds from both sides, however far the way goes.
    void openMesh()
    {
        const TriangleTree square = squareMesh();
        QVERIFY(!square.isClosed());
        const double gap = 0.01;
        for (const double side : {-1.0, 1.0})
            for (const double depth : {0.0, 0.009, 5.0}) {
                const auto touch = touchMesh(square, gap, {0.2, side * 0.5, 0.1},
                                             {0.2, -side * depth, 0.1}, false);
                QVERIFY(touch);
                QVERIFY(isNear(touch->normal, Vec3(0.0, side, 0.0), 1e-12));
                QVERIFY(isNear(touch->surface, Vec3(0.2, side * gap, 0.1), 1e-12));
            }
        QVERIFY(!touchMesh(square, gap, {1.2, 0.5, 0.0}, {1.2, -0.5, 0.0}, false));
    }

    // What an edit has put into a closed mesh comes out by the nearest way.
    void insideMesh()
    {
        const TriangleTree ball = ballMesh(3);
        const Vec3 deep(0.0, 0.0, 0.7);
        QVERIFY(!touchMesh(ball, 0.0, deep, deep, false));
        const auto touch = touchMesh(ball, 0.01, deep, deep, true);
        QVERIFY(touch);
        QVERIFY2(isNear(touch->surface.norm(), 1.01, 0.01), told(touch->surface.norm(), 1.01));
        QVERIFY(!touchMesh(ball, 0.01, {0.0, 0.0, 1.2}, {0.0, 0.0, 1.2}, true));
    }

    void pictures()
    {
        QTemporaryDir folder;
        const auto path = [&](const char* name) { return folder.filePath(name); };
        write(path("text.pgm"), "P2\n# a comment\n3 2\n4\n0 1 2\n3 4 0\n");
        write(path("one.pgm"), QByteArray("P5 2 2 255\n") + QByteArray("\x00\xff\x33\x66", 4));
        write(path("two.pgm"),
              QByteArray("P5 2 2 65535\n") + QByteArray("\x00\x00\xff\xff\x33\x33\x00\x01", 8));
        const auto read = [&](const char* name) {
            return heightsFromFile(path(name).toStdString());
        };
        const auto text = read("text.pgm");
        QVERIFY2(text, text ? "" : text.message().english().c_str());
        QCOMPARE((*text)->columns, 3);
        QCOMPARE((*text)->height, (std::vector{0.0, 0.25, 0.5, 0.75, 1.0, 0.0}));
        QCOMPARE((*read("one.pgm"))->height, (std::vector{0.0, 1.0, 0.2, 0.4}));
        QCOMPARE((*read("two.pgm"))->height, (std::vector{0.0, 1.0, 0.2, 1.0 / 65535.0}));
        QCOMPARE(read("one.pgm")->get(), read("one.pgm")->get()); // is read once
        // 2 x 2 points: 0 255 51 102 of 8 bits, 0 65535 13107 1 of 16
        write(path("one.png"),
              QByteArray::fromHex("89504e470d0a1a0a0000000d494844520000000200000002080000000057"
                                  "dd52f80000000e49444154789c6360f8cf609c060004ce01991975d5e200"
                                  "00000049454e44ae426082"));
        write(path("two.png"),
              QByteArray::fromHex("89504e470d0a1a0a0000000d4948445200000002000000021000000000074d"
                                  "8ebb0000001249444154789c636060f8ff9fc1d8988111000e630266d7d168"
                                  "2c0000000049454e44ae426082"));
        for (const char* name : {"one.png", "two.png"}) {
            const auto png = read(name);
            QVERIFY2(png, png ? "" : png.message().english().c_str());
        }
        QCOMPARE((*read("one.png"))->height, (*read("one.pgm"))->height);
        QCOMPARE((*read("two.png"))->height, (*read("two.pgm"))->height);
    }

    void flawedFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        QTest::newRow("no picture") << "none.png" << QByteArray() << "does not exist";
        QTest::newRow("not a picture") << "a.png" << QByteArray("hello") << "neither";
        QTest::newRow("short PGM") << "b.pgm" << QByteArray("P5 9 9 255\nabc") << "too early";
        QTest::newRow("endless PGM") << "c.pgm" << QByteArray("P5 999999 999999 255\n") << "999999";
        QTest::newRow("PGM of text without numbers") << "d.pgm" << QByteArray("P2 x") << "points";
        QTest::newRow("cut PNG") << "e.png"
                                 << QByteArray::fromHex("89504e470d0a1a0a0000000d4948445200")
                                 << "cannot be read";
        QTest::newRow("no mesh") << "none.obj" << QByteArray() << "does not exist";
        QTest::newRow("not a mesh") << "f.stl" << QByteArray("nothing of a mesh") << "mesh";
        QTest::newRow("a mesh without triangles")
            << "g.obj" << QByteArray("v 0 0 0\nv 1 0 0\n") << "mesh";
    }

    // A sentence that names the file and what to do.
    void flawedFiles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, says);
        QTemporaryDir folder;
        const QString path = folder.filePath(name);
        if (!bytes.isEmpty())
            write(path, bytes);
        const std::string file = path.toStdString();
        const bool isPicture = name.endsWith("png") || name.endsWith("pgm");
        const auto picture = heightsFromFile(file);
        const auto mesh = meshFromFile(file);
        QVERIFY(isPicture ? !picture : !mesh);
        const QString message =
            QString::fromStdString((isPicture ? picture.message() : mesh.message()).english());
        QVERIFY2(message.contains(path) && message.contains(says) && message.endsWith('.'),
                 qPrintable(message));
        QVERIFY2(message.contains("choose"), qPrintable(message));
    }

    void meshFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("OBJ, quads") << "cube.obj" << QByteArray(R"(
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)");
        // corners written anew for each triangle are joined
        QByteArray stl = "solid tetrahedron\n";
        const char* corner[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
        for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
            stl += "facet normal 0 0 0\nouter loop\n";
            for (const int i : {a, b, c})
                stl += QByteArray("vertex ") + corner[i] + "\n";
            stl += "endloop\nendfacet\n";
        }
        QTest::newRow("STL") << "tetrahedron.stl" << stl + "endsolid\n";
    }

    void meshFiles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QTemporaryDir folder;
        write(folder.filePath(name), bytes);
        const auto mesh = meshFromFile(folder.filePath(name).toStdString());
        QVERIFY2(mesh, mesh ? "" : mesh.message().english().c_str());
        QVERIFY((*mesh)->isClosed());
        QCOMPARE((*mesh)->faces().size(), std::size_t(name.endsWith("obj") ? 12 : 4));
        QVERIFY(isNear((*mesh)->low(), Vec3::Zero(), 1e-7));
        QVERIFY(isNear((*mesh)->high(), Vec3::Ones(), 1e-7));
    }
};

const RegisteredTest registered("test_shapes", runPlain<TestShapes>);

} // namespace ripstop::test_shapes
#include "test_shapes.moc"
