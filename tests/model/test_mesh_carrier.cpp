// What carries the pull of an imported mesh where nobody chose, and that it is as stiff as its
// cloth: whatever faces it has, wherever they meet, however the texture lies on them.
#include "author/stability.h"
#include "base/angle.h"
#include "check/check.h"
#include "compile/compile.h"
#include "derived/flat_panel.h"
#include "measure/diagnostics.h"
#include "model/meshes.h"
#include "registered_test.h"
#include "select/element_map.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_mesh_carrier {

namespace {

// Kite cloth with no choice made, as the dialog has it when it opens.
MeshFabric untouchedFabric()
{
    MeshFabric fabric;
    fabric.material = materialFrom(**findPreset("ripstop_075"));
    return fabric;
}

// A strip of 0.1 m x 0.4 m that hangs down from y = 0, cells of 1/40 m, as quads or as triangles;
// its texture is turned, so that the warp lies at `grain` rad to its length.
std::string hungStrip(double grain, bool quads)
{
    std::string text;
    for (int row = 0; row <= 16; ++row)
        for (int column = 0; column <= 4; ++column) {
            const double x = column / 40.0, y = -row / 40.0;
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\nvt "
                    + std::to_string(x * std::cos(grain) - y * std::sin(grain)) + " "
                    + std::to_string(x * std::sin(grain) + y * std::cos(grain)) + "\n";
        }
    const auto corner = [](int row, int column) {
        const std::string at = std::to_string(5 * row + column + 1);
        return " " + at + "/" + at;
    };
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 4; ++column) {
            const std::string a = corner(row, column), b = corner(row + 1, column);
            const std::string c = corner(row + 1, column + 1), d = corner(row, column + 1);
            text += quads ? "f" + a + b + c + d + "\n" : "f" + a + b + c + "\nf" + a + c + d + "\n";
        }
    return text;
}

// The warp of each panel, 1 long.
std::vector<Vec3> warpsOn(const Part& part)
{
    std::vector<Vec3> warps;
    for (const Panel& panel : part.panels) {
        const auto at = [&](Id id) { return findRow(part.particles, id)->position; };
        const Vec3 a = at(panel.a), b = at(panel.b), c = at(panel.c);
        const auto shares = *warpShares(panel, a, b, c);
        warps.push_back(shares[0] * (b - a) + shares[1] * (c - a));
    }
    return warps;
}

bool allRunAlong(const Part& part, const Vec3& way)
{
    return std::ranges::all_of(warpsOn(part), [&](const Vec3& warp) {
        return warp.cross(way.normalized()).norm() < 1e-9;
    });
}

} // namespace

class TestMeshCarrier : public QObject
{
    Q_OBJECT

private slots:
    // Threads run along the edges, wherever the texture has its warp, and are too stiff where that
    // lies across.
    void threadsOffTheWarpAreTold_data()
    {
        QTest::addColumn<double>("grain"); // degrees
        QTest::addColumn<double>("off");   // degrees
        QTest::newRow("along") << 0.0 << 0.0;
        QTest::newRow("nearly across") << 85.0 << 5.0;
        QTest::newRow("turned") << 30.0 << 30.0;
        QTest::newRow("on the bias") << 45.0 << 45.0;
    }
    void threadsOffTheWarpAreTold()
    {
        QFETCH(double, grain);
        QFETCH(double, off);
        const PreparedMesh mesh = preparedOf(meshOf(hungStrip(grain * degrees, true).c_str()));
        MeshFabric fabric = untouchedFabric();
        fabric.carrier = FabricKind::Threads;
        const MeshImport made = importOf(mesh, fabric);
        QVERIFY2(std::abs(made.warpsOff - off) < 0.01,
                 qPrintable(QString::number(made.warpsOff))); // the mesh has six digits
        QCOMPARE(threadsComplaint(made).has_value(), off > 10.0);
        fabric.carrier = FabricKind::Panels;
        QVERIFY(!threadsComplaint(importOf(mesh, fabric)));
    }

    void panelsCarryUnlessLinksAreAskedFor()
    {
        MeshFabric fabric = untouchedFabric();
        const PreparedMesh mesh = preparedOf(meshOf(cubeOfQuads));
        const auto made = [&] { return firstPart(sceneOf(mesh, fabric)); };
        QCOMPARE(made().carrier, FabricKind::Panels);
        QVERIFY(made().links.empty());
        fabric.bend = LinkStyle::Springs; // which carry no pull within the fabric
        QCOMPARE(made().carrier, FabricKind::Panels);
        fabric.shear = LinkStyle::None;
        QCOMPARE(made().carrier, FabricKind::Panels);
        fabric.shear = LinkStyle::Springs;
        QCOMPARE(made().carrier, FabricKind::Threads);
        QCOMPARE(countOf(made(), LinkRole::Thread), 12u);
        fabric.carrier = FabricKind::Panels; // both, as somebody wants it
        QCOMPARE(made().carrier, FabricKind::Panels);
        QCOMPARE(countOf(made(), LinkRole::Bias), 12u);
        fabric = untouchedFabric();
        fabric.material.membraneStiffness.reset(); // threads of it do not stretch
        QCOMPARE(made().carrier, FabricKind::Threads);
        QVERIFY(problemsOf(sceneOf(mesh, fabric)).empty());
    }

    // Two squares side by side, each with a texture of its own, of which the right one lies at 45
    // degrees: the warp of each panel goes up its own, also where they meet.
    void warpFollowsEachFace()
    {
        const PreparedMesh mesh =
            preparedOf(meshOf("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
                              "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0\nvt 6 1\nvt 5 2\nvt 4 1\n"
                              "f 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n"));
        QCOMPARE(mesh.report.count(MeshFault::TextureSeams), 2u);
        const Part part = firstPart(sceneOf(mesh, untouchedFabric()));
        QCOMPARE(part.panels.size(), 4u);
        const std::vector<Vec3> warps = warpsOn(part);
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 warp = warps[i];
            const Vec3 wanted = i < 2 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 1.0, 0.0).normalized();
            QVERIFY(warp.cross(wanted).norm() < 1e-9);
        }
    }

    // However uneven the triangles are, an angle is one direction on the cloth: of the import, of a
    // map, and of the repair where each panel was given the same number, which counts from its own
    // side. It turns from upright against the clock, as seen from the front.
    void anAngleIsOneDirection()
    {
        const PreparedMesh mesh = preparedOf(meshOf(unevenSheet(6).c_str()));
        MeshFabric fabric = untouchedFabric();
        QVERIFY(allRunAlong(firstPart(sceneOf(mesh, fabric)), Vec3::UnitY()));
        fabric.grain = 30.0;
        Scene scene = sceneOf(mesh, fabric);
        QVERIFY(allRunAlong(firstPart(scene), Vec3(-0.5, std::sqrt(0.75), 0.0)));
        QVERIFY(problemsOf(scene).empty());

        std::vector<Id> panels;
        for (const Panel& panel : firstPart(scene).panels)
            panels.push_back(panel.id);
        const Property& grain = propertyOf<&Panel::grain>();
        (void)apply(scene, mapped(scene, grain, panels, "value - 75")->edit);
        QVERIFY(allRunAlong(firstPart(scene), Vec3(1.0, 1.0, 0.0)));
        (void)apply(scene, mapped(scene, grain, panels, "405")->edit); // once round
        QVERIFY(allRunAlong(firstPart(scene), Vec3(-1.0, 1.0, 0.0)));

        (void)apply(scene, {{}, {SetValues{&grain, panels, {45.0}}}});
        QVERIFY(!allRunAlong(firstPart(scene), Vec3(-1.0, 1.0, 0.0)));
        const auto scattered = [](const std::vector<Finding>& findings) {
            const auto found = std::ranges::find(findings, "scattered warps", &Finding::sort);
            return found == findings.end() ? nullptr : &*found;
        };
        const std::vector<Finding> problems = problemsOf(scene), findings = stabilityOf(scene);
        QVERIFY(scattered(problems) && scattered(findings) && scattered(findings)->repair);
        (void)apply(scene, *scattered(findings)->repair);
        QVERIFY(allRunAlong(firstPart(scene), Vec3(-1.0, 1.0, 0.0)));
        QVERIFY(!scattered(problemsOf(scene)));
    }

    // What hangs on a side is sewn to it: a coarse half above a fine one, drawn by 500 N/m, has no
    // panel that bears more. Open between the corners that both share, one bears twice that.
    void coarseMeetsFine()
    {
        std::string text;
        auto half = [&text, count = 0](int cells, double bottom, double top) mutable {
            for (int i = 0; i <= cells; ++i)
                for (const double y : {bottom, top})
                    text +=
                        "v " + std::to_string(double(i) / cells) + " " + std::to_string(y) + " 0\n";
            for (int i = 0; i < cells; ++i) {
                const int a = count + 2 * i + 1;
                text += "f " + std::to_string(a) + " " + std::to_string(a + 2) + " "
                        + std::to_string(a + 3) + " " + std::to_string(a + 1) + "\n";
            }
            count += 2 * (cells + 1);
        };
        half(4, 0.0, 0.25);
        half(8, -0.125, 0.0);
        MeshFabric fabric = untouchedFabric();
        fabric.material.poissonRatio = 0.0; // held ends bear no more
        Scene scene = sceneOf(preparedOf(meshOf(text.c_str())), fabric);
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item))
                for (Particle& particle : part->particles) {
                    const Vec3& place = particle.position;
                    particle.pinned = place.y() > 0.25 - 1e-9;
                    const bool isCorner = place.x() < 1e-9 || place.x() > 1.0 - 1e-9;
                    if (place.y() < -0.125 + 1e-9)
                        particle.mass += 500.0 / standardGravity / (isCorner ? 16.0 : 8.0);
                }
        scene.settings.viscosity = 5.0;
        const auto system = compile(scene);
        QVERIFY(bool(system));
        Simulation simulation(*system);
        QVERIFY(simulation.runUntil(3.0));
        double most = 0.0;
        for (const PanelPull& pull : panelPulls(**system, simulation.state()))
            most = std::max(most, pull.tension);
        QVERIFY2(std::abs(most / 500.0 - 1.0) < 0.02, qPrintable(QString::number(most)));
    }

    // A mesh as it comes, of kite cloth as it comes, flown as a new scene is: a strip under a load
    // stretches by W / (b E), where for cloth cut at an angle a to the warp (Jones, Mechanics of
    // Composite Materials, 1999, equation 2.97)
    //
    //     1 / E = cos^4 a / E1 + (1 / G - 2 nu / E1) sin^2 a cos^2 a + sin^4 a / E2,
    //
    // whatever faces it is made of. Threads along its edges would know nothing of a.
    void stretchesAsItIsCut_data()
    {
        QTest::addColumn<double>("grain"); // degrees
        QTest::addColumn<bool>("quads");
        for (const double grain : {0.0, 45.0, 90.0})
            for (const bool quads : {false, true})
                QTest::addRow("%g degrees, %s", grain, quads ? "quads" : "triangles")
                    << grain << quads;
    }

    void stretchesAsItIsCut()
    {
        QFETCH(double, grain);
        QFETCH(bool, quads);
        const double angle = grain * std::numbers::pi / 180.0;
        const MeshFabric fabric = untouchedFabric();
        Scene scene = sceneOf(preparedOf(meshOf(hungStrip(angle, quads).c_str())), fabric);
        const double load = 0.2; // kg, for strains that are small
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item))
                for (Particle& particle : part->particles) {
                    const Vec3& place = particle.position;
                    particle.pinned = place.y() > -1e-9;
                    const bool isCorner = place.x() < 1e-9 || place.x() > 0.1 - 1e-9;
                    if (place.y() < -0.4 + 1e-9)
                        particle.mass += load / (isCorner ? 8.0 : 4.0);
                }
        scene.settings.viscosity = 5.0;
        const auto system = compile(scene);
        QVERIFY(bool(system));
        Simulation simulation(*system);
        QVERIFY(simulation.runUntil(4.0));
        // rows well away from both ends, which do not let the strip become narrower
        const auto heightOf = [](const auto& places, int row) {
            double sum = 0.0;
            for (int column = 0; column <= 4; ++column)
                sum += places[std::size_t(5 * row + column)].y();
            return sum / 5.0;
        };
        const auto lengthOf = [&](const auto& places) {
            return heightOf(places, 6) - heightOf(places, 10);
        };
        const double before = lengthOf((*system)->start.position);
        const double strain = lengthOf(simulation.state().position) / before - 1.0;
        const Material& cloth = fabric.material;
        const double warp = *cloth.membraneStiffness;
        const double weft = cloth.weftStiffness.value_or(warp);
        const double c2 = std::cos(angle) * std::cos(angle), s2 = 1.0 - c2;
        const double softness =
            c2 * c2 / warp
            + (1.0 / *cloth.shearStiffness - 2.0 * cloth.poissonRatio / warp) * s2 * c2
            + s2 * s2 / weft;
        const double below = 0.5 * 0.1 * 0.4 * *cloth.arealDensity; // kg, of the strip itself
        const double wanted = (load + below) * standardGravity / 0.1 * softness;
        QVERIFY2(std::abs(strain / wanted - 1.0) < 0.01,
                 qPrintable(QStringLiteral("%1 %, not %2 %").arg(100 * strain).arg(100 * wanted)));
    }
};

const RegisteredTest registered("test_mesh_carrier", runWithCore<TestMeshCarrier>);

} // namespace ripstop::test_mesh_carrier
#include "test_mesh_carrier.moc"
