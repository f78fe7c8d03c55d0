// What the threads of a mesh pull with: grids of quads are the fabric of their material, wherever
// they lie; triangles and shaken grids are not, and are told.
//
// Stages: known answers of lattices; then what is told of imported meshes.
#include "check/check.h"
#include "derived/lattice_stiffness.h"
#include "model/meshes.h"
#include "registered_test.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_lattice_stiffness {

namespace {

constexpr double stiff = 4e4; // N/m, E t
constexpr double shear = 1e3; // N/m, G t

MeshFabric cloth(bool hasShear = true)
{
    MeshFabric fabric = plainFabric();
    fabric.material.membraneStiffness = stiff;
    fabric.material.shearStiffness = hasShear ? std::optional(shear) : std::nullopt;
    return fabric;
}

LatticeStiffness stiffnessOf(const Scene& scene)
{
    std::map<Id, const Material*> materials;
    for (const Entry& entry : scene.items)
        if (const Material* material = std::get_if<Material>(&entry.item))
            materials[entry.id] = material;
    return latticeStiffness(firstPart(scene), materials).begin()->second;
}

// Moved to `to` by each point, with the lengths of where it lies then.
PolygonMesh moved(PolygonMesh mesh, const std::function<Vec3(const Vec3&)>& to)
{
    for (Vec3& point : mesh.points)
        point = to(point);
    return mesh;
}

bool isNear(double got, double expected) { return std::abs(got / expected - 1.0) < 1e-9; }

std::vector<std::string> toldOf(const Scene& scene)
{
    std::vector<std::string> told;
    for (const Finding& problem : problemsOf(scene))
        told.push_back(problem.message.english());
    return told;
}

} // namespace

class TestLatticeStiffness : public QObject
{
    Q_OBJECT

private slots:
    // A grid of quads pulls and shears as its material says: turned in its plane and out of it,
    // with cells of 2 : 1, or rolled up.
    void grids_data()
    {
        QTest::addColumn<int>("way");
        QTest::newRow("as it is") << 0;
        QTest::newRow("turned") << 1;
        QTest::newRow("cells of 2 : 1") << 2;
    }

    void grids()
    {
        QFETCH(int, way);
        const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 2.0, 3.0).normalized());
        const PolygonMesh mesh = moved(meshOf(sheet(6, 0.1, true).c_str()), [&](const Vec3& p) {
            return way == 1 ? Vec3(turn * p) : way == 2 ? Vec3(2.0 * p.x(), p.y(), p.z()) : p;
        });
        const Scene scene = sceneOf(preparedOf(mesh), cloth());
        const LatticeStiffness given = stiffnessOf(scene);
        QVERIFY(isNear(given.along, stiff));
        QVERIFY(isNear(given.shear, shear));
        QVERIFY(toldOf(scene).empty());
    }

    // Equilateral triangles of threads E: C11 = 9/8 E and C12 = G = 3/8 E, so that a strip pulls
    // with E and shear is resisted with 3/8 E, whatever the material says. Squares that are cut
    // once have threads at 0, 45 and 90 degrees: C11 = 5/4 E, C12 = G = E / 4, 6/5 E in a strip.
    void triangles()
    {
        const PolygonMesh right = meshOf(sheet(6, 0.1, false).c_str());
        const PolygonMesh equal = moved(right, [](const Vec3& p) {
            return Vec3(p.x() - 0.5 * p.y(), 0.5 * std::numbers::sqrt3 * p.y(), p.z());
        });
        LatticeStiffness given = stiffnessOf(sceneOf(preparedOf(equal), cloth(false)));
        QVERIFY(isNear(given.along, stiff));
        QVERIFY(isNear(given.shear, 0.375 * stiff));
        given = stiffnessOf(sceneOf(preparedOf(right), cloth(false)));
        QVERIFY(isNear(given.along, 1.2 * stiff));
        QVERIFY(isNear(given.shear, 0.25 * stiff));
    }

    // Threads that zigzag between quads resist shear in part with what they pull with, and pull
    // with less: a shake by d turns them by about d, and adds about E d^2.
    void shaken()
    {
        int i = 0;
        const PolygonMesh mesh = moved(meshOf(sheet(6, 0.1, true).c_str()), [&](const Vec3& p) {
            ++i;
            return Vec3(p + 0.02 * Vec3(std::sin(7.0 * i), std::sin(11.0 * i), 0.0));
        });
        const LatticeStiffness given = stiffnessOf(sceneOf(preparedOf(mesh), cloth()));
        QVERIFY(given.along < stiff);
        QVERIFY(given.shear > 1.5 * shear && given.shear < 0.1 * stiff);
    }

    void isTold()
    {
        const PolygonMesh mesh = meshOf(sheet(6, 0.1, false).c_str());
        const auto told = toldOf(sceneOf(preparedOf(mesh), cloth()));
        QCOMPARE(told.size(), std::size_t(1));
        const QString text = QString::fromStdString(told[0]);
        QVERIFY2(text.contains("N/m at most, with less along lines that zigzag"), qPrintable(text));
        QVERIFY2(text.contains("has 4e+04 N/m and 1e+03 N/m"), qPrintable(text));
        QVERIFY2(text.contains("Have panels carry the pull."), qPrintable(text));
        MeshFabric panels = cloth();
        panels.carrier = FabricKind::Panels;
        QVERIFY(toldOf(sceneOf(preparedOf(mesh), panels)).empty());
    }

    // What is not there is passed over: the list of errors has it.
    void dangling()
    {
        Scene scene = sceneOf(preparedOf(meshOf(sheet(2, 0.1, true).c_str())), cloth());
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item)) {
                part->panels[0].a = Id{9999};
                part->links[3].to = Id{9999};
                part->particles.pop_back();
            }
        QVERIFY(hasErrors(problemsOf(scene)));
    }
};

const RegisteredTest registered("test_lattice_stiffness", runPlain<TestLatticeStiffness>);

} // namespace ripstop::test_lattice_stiffness
#include "test_lattice_stiffness.moc"
