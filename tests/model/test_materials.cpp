// Physical numbers of materials: links follow from them, whatever the mesh.
//
// Stages: the stiffness of one link by hand, and numbers of its own that win; then sheets at
// several resolutions (material_sheets.h), which have to weigh, stretch and sag alike; and a rope
// that hangs.
#include "model/material_sheets.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "derived/link_stiffness.h"
#include "io/scene_file.h"
#include "materials/presets.h"
#include "measure/diagnostics.h"
#include "scene/path.h"
#include "scene/weigh.h"
#include "simulation/simulation.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop::test_materials {

class TestMaterials : public QObject
{
    Q_OBJECT

private slots:
    // k = EA / L, and Y w / L without shear; G D^2 / (2 p q) on a diagonal
    void stiffnessOfOneLink()
    {
        Material m;
        m.stiffness = 7.0;
        m.compliance = 0.3;
        QCOMPARE(springStiffness(m, {LinkRole::Line}, 2.0), 7.0);
        QCOMPARE(rodCompliance(m, {LinkRole::Thread, 0.1}, 2.0), 0.3);
        m.axialStiffness = 1e4;
        m.membraneStiffness = 600.0;
        QCOMPARE(springStiffness(m, {LinkRole::Line}, 2.0), 5000.0);
        QCOMPARE(rodCompliance(m, {LinkRole::Line}, 2.0), 2e-4);
        QCOMPARE(springStiffness(m, {LinkRole::Thread, 0.1}, 0.2), 300.0);
        QCOMPARE(springStiffness(m, {LinkRole::Bias, 0.1}, 0.2), 7.0); // no shear stiffness
        m.shearStiffness = 50.0;
        QCOMPARE(springStiffness(m, {LinkRole::Bias, biasWidth(0.3, 0.4)}, 0.5),
                 50.0 * 0.25 / (2.0 * 0.12));
        // nothing to divide by
        QCOMPARE(springStiffness(m, {LinkRole::Thread, 0.0}, 0.2), 7.0);
        QCOMPARE(springStiffness(m, {LinkRole::Line}, 0.0), 7.0);
        QCOMPARE(rodCompliance(m, {LinkRole::Line}, 0.0), 0.3);
    }

    // Y = c - G r^2 along cells r times as long as wide, and E t = c - G^2 / c as for square ones;
    // where G r^2 is above c, what the diagonals pull is left
    void stiffnessAlongCellsThatAreNotSquare()
    {
        Material m;
        QVERIFY(!fabricModulus(m, 1.0));
        m.membraneStiffness = 600.0;
        m.shearStiffness = 50.0;
        const double c = 0.5 * (600.0 + std::sqrt(600.0 * 600.0 + 4.0 * 50.0 * 50.0));
        const auto near = [](double value, double expected) {
            return std::abs(value - expected) <= 1e-12 * expected;
        };
        QVERIFY(near(springStiffness(m, {LinkRole::Thread, 0.1, 3.0}, 0.2),
                     (c - 9.0 * 50.0) * 0.1 / 0.2));
        QVERIFY(near(springStiffness(m, {LinkRole::Thread, 0.1, 0.5}, 0.2),
                     (c - 0.25 * 50.0) * 0.1 / 0.2));
        for (const double aspect : {0.3, 1.0, 3.0})
            QVERIFY(near(*fabricModulus(m, aspect), 600.0));
        QVERIFY(*fabricModulus(m, 4.0) > 16.0 * 50.0 - 50.0 * 50.0 / c);
        QVERIFY(std::isfinite(rodCompliance(m, {LinkRole::Thread, 0.1, 4.0}, 0.2)));
    }

    void tellsWhereDiagonalsAreTooStiff()
    {
        const auto warnings = [](int columns, int rows) {
            Scene scene = *build(*findBuilder("cloth"), {{"columns", columns},
                                                         {"rows", rows},
                                                         {"membrane", 1000},
                                                         {"shear", 0.3},
                                                         {"sphere", 0}});
            return std::ranges::count_if(problemsOf(scene), [](const Finding& finding) {
                return finding.message.english().find("diagonals alone") != std::string::npos;
            });
        };
        QCOMPARE(warnings(10, 10), 0);
        QCOMPARE(warnings(10, 18), 0); // 1.8^2 * 0.3 is below c / E t = 1.08
        QCOMPARE(warnings(10, 30), 1);
        QCOMPARE(warnings(30, 10), 1);
    }

    // Sail Dacron is softer along its weft, ripstop is alike both ways.
    void tellsWhereThreadsKnowNoWeft()
    {
        const auto warnings = [](std::optional<double> weft) {
            Scene scene = *build(*findBuilder("cloth"), sheet(4, 2, 0.3));
            for (Entry& entry : scene.items)
                if (Material* material = std::get_if<Material>(&entry.item))
                    material->weftStiffness = weft;
            return std::ranges::count_if(problemsOf(scene), [](const Finding& finding) {
                return finding.message.english().find("weft stiffness of") != std::string::npos;
            });
        };
        QCOMPARE(warnings(std::nullopt), 0);
        QCOMPARE(warnings(membrane), 0);
        QCOMPARE(warnings(0.65 * membrane), 1);
        QCOMPARE(warnings(1.5 * membrane), 1);
    }

    void whatALinkSaysItselfWins()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(2, 2, 0.3));
        partOf(scene).links[0].stiffness = 3.0;
        const auto compiled = compile(scene, 1, 1);
        QCOMPARE((*compiled)->springs[std::size_t((*compiled)->links[0].index)].stiffness, 3.0);
        QVERIFY((*compiled)->springs[std::size_t((*compiled)->links[1].index)].stiffness > 100.0);
    }

    void weighsTheSame_data() { addResolutions(); }
    void weighsTheSame()
    {
        QFETCH(int, cells);
        const auto compiled = compile(*build(*findBuilder("cloth"), sheet(cells, 2, 0.3)), 1, 1);
        const auto& mass = (*compiled)->mass;
        NEAR(std::accumulate(mass.begin(), mass.end(), 0.0), density, 1e-12);
    }

    // A strip that is strained by e along and by -nu e across, nu = C12 / C11, C12 = G,
    // C11 - C12^2 / C11 = E t, is at rest: no force but at the ends, and there E t W e.
    void stripPulledEvenly_data() { addResolutions(); }
    void stripPulledEvenly()
    {
        QFETCH(int, cells);
        const double shear = 0.3; // G / (E t)
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 2, shear));
        scene.settings.integrator =
            Integrator::SemiImplicitEuler; // forces say at once what they are
        const auto compiled = compile(scene, 1, 1);
        const System& system = **compiled;
        State state = system.start;
        const double e = 1e-6;
        const double nu = shear / (0.5 * (1.0 + std::sqrt(1.0 + 4.0 * shear * shear)));
        for (auto& x : state.position)
            x = Vec3(x.x() * (1.0 + e), x.y(), x.z() * (1.0 - nu * e));
        std::vector<Vec3> force(system.mass.size(), Vec3::Zero());
        const std::vector<double> tension = tensions(system, state);
        for (std::size_t i = 0; i < system.links.size(); ++i) {
            const auto a = std::size_t(system.links[i].a);
            const auto b = std::size_t(system.links[i].b);
            const Vec3 along = Vec3(state.position[b] - state.position[a]).normalized();
            force[a] += tension[i] * along;
            force[b] -= tension[i] * along;
        }
        double pull = 0.0;
        for (std::size_t i = 0; i < force.size(); ++i) {
            if (i % std::size_t(cells + 1) == 0)
                pull += force[i].x();
            else if (i % std::size_t(cells + 1) != std::size_t(cells))
                QVERIFY(force[i].norm() < 1e-4 * membrane * e / cells);
        }
        NEAR(pull, membrane * e, 1e-4);
    }

    // F = E t W strain. Held ends keep the strip from becoming narrower, which makes it stiffer by
    // less than nu^2 = 0.0025.
    void stripBetweenGrips_data() { addResolutions(); }
    void stripBetweenGrips()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 3, 0.05));
        scene.settings.gravity = Vec3::Zero();
        scene.settings.viscosity = 60.0;
        for (Particle& particle : partOf(scene).particles)
            particle.position.x() *= 1.01;
        const auto compiled = compile(scene, 1, 1);
        const State state = settled(scene, 0.3);
        const std::vector<double> tension = tensions(**compiled, state);
        double pull = 0.0;
        for (std::size_t i = 0; i < tension.size(); ++i) {
            const LinkPlace& link = (*compiled)->links[i];
            const Vec3 along =
                Vec3(state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)]);
            if (link.a % (cells + 1) == 0 || link.b % (cells + 1) == 0)
                pull += tension[i] * std::abs(along.x()) / along.norm();
        }
        NEAR(pull, membrane * 0.01, 0.01);
    }

    // Level between two edges it hangs as a parabola of sag s: the tension per width is
    // T = w W^2 / (8 s) = E t 8 s^2 / (3 W^2), so s^3 = 3 w W^4 / (64 E t), w = density g.
    void sagsTheSame_data() { addResolutions(); }
    void sagsTheSame()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 3, 0.05));
        scene.settings.viscosity = 20.0;
        scene.settings.airDensity = 0.0;
        const State state = settled(scene, 2.0);
        const std::size_t middle = std::size_t((cells + 1) * (cells / 2) + cells / 2);
        const double sag = 2.0 - state.position[middle].y();
        NEAR(sag, std::cbrt(3.0 * density * gravity / (64.0 * membrane)), 0.03);
    }

    // T-R2: a rope of mass M grows by M g L / (2 EA) of its own weight. With half a share of mass
    // at the lower end that holds exactly at any number of segments.
    void hangingRope_data()
    {
        QTest::addColumn<int>("segments");
        QTest::addColumn<bool>("springs");
        for (const int segments : {5, 20, 80})
            for (const bool springs : {true, false})
                QTest::addRow("%d %s", segments, springs ? "springs" : "rods")
                    << segments << springs;
    }
    void hangingRope()
    {
        QFETCH(int, segments);
        QFETCH(bool, springs);
        Scene scene = *build(*findBuilder("rope"), {{"segments", segments},
                                                    {"length", 10},
                                                    {"density", 0.1},
                                                    {"axial", 1e4},
                                                    {"angle", 0}});
        scene.settings.viscosity = 50.0;
        scene.settings.airDensity = 0.0;
        scene.settings.substeps = 20;
        scene.settings.solver = Solver::Direct;
        if (springs)
            for (Link& link : partOf(scene).links)
                link.kind = LinkKind::Spring;
        const State state = settled(scene, 1.0);
        // the rope's ends come first
        const double length = (state.position[0] - state.position[1]).norm();
        NEAR(length - 10.0, 4.903325e-3, 1e-3);
    }
};

const RegisteredTest registered("test_materials", runPlain<TestMaterials>);

} // namespace ripstop::test_materials
#include "test_materials.moc"
