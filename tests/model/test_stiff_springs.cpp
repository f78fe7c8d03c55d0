// Springs of any stiffness, with what a new scene gets: those that the substep is too long for are
// solved together with rods, and hang what they hold as their stiffness says.
#include "builders/network.h"
#include "check/check.h"
#include "check/step_limits.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QtTest>

namespace ripstop::test_stiff_springs {

namespace {

constexpr double gravity = 9.80665; // m/s^2
constexpr double grain = 0.001;     // kg, of a particle of the chain
constexpr double load = 1.0;        // kg, at its end

// 1 m of equal springs, pinned above, with the load below. Viscosity lets it come to rest.
Scene chain(int springs, double axialStiffness)
{
    Scene scene;
    scene.settings.viscosity = 5.0;
    Material cord{"cord"};
    cord.stiffness = axialStiffness * springs;
    const Id material = addItem(scene, cord);
    Network network(scene, "chain");
    Id above = network.particle({0.0, 0.0, 0.0}, grain);
    network.row(above).pinned = true;
    for (int i = 1; i <= springs; ++i) {
        const double mass = i == springs ? load + grain : grain;
        const Id below = network.particle({0.0, -double(i) / springs, 0.0}, mass);
        network.spring(above, below, material);
        above = below;
    }
    network.finish({}, {});
    return scene;
}

// m, of the chain at rest: each spring holds what hangs below it.
double stretchOf(int springs, double axialStiffness)
{
    double sum = 0.0;
    for (int i = 0; i < springs; ++i)
        sum += gravity * (load + (springs - i) * grain) / (axialStiffness * springs);
    return sum;
}

double lowest(const Simulation& simulation) { return simulation.state().position.back().y(); }

Id cordOf(const Scene& scene) { return scene.items.front().id; }

SetValues cordStiffness(const Scene& scene, double stiffness)
{
    return {findProperty(Kind::Material, "stiffness"), {cordOf(scene)}, {stiffness}};
}

// m/s, of the load.
double fastestIn(Simulation& simulation, double seconds)
{
    double fastest = 0.0;
    const double end = simulation.state().time + seconds;
    while (simulation.state().time < end && simulation.step())
        fastest = std::max(fastest, simulation.state().velocity.back().norm());
    return fastest;
}

} // namespace

class TestStiffSprings : public QObject
{
    Q_OBJECT

private slots:
    void hangAsTheirStiffnessSays_data()
    {
        QTest::addColumn<double>("axialStiffness");
        for (const double stiffness : {1e3, 1e4, 1e6, 1e8})
            QTest::addRow("EA = %g N", stiffness) << stiffness;
    }
    void hangAsTheirStiffnessSays()
    {
        QFETCH(double, axialStiffness);
        const Scene scene = chain(30, axialStiffness);
        Simulation simulation(*compile(scene));
        QCOMPARE(simulation.system().springsAsRods, std::size_t(30));
        QVERIFY(simulation.runUntil(6.0));
        const double stretch = -1.0 - lowest(simulation);
        const double expected = stretchOf(30, axialStiffness);
        QVERIFY2(std::abs(stretch - expected) < 0.01 * expected,
                 qPrintable(QString("%1 m instead of %2 m").arg(stretch).arg(expected)));
        QVERIFY(problemsOf(scene).empty());
    }

    // Soft ones stay forces, of which semi-implicit Euler loses no energy: the swing of 1 kg on
    // 100 N/m is as high after ten seconds as at first.
    void softOnesStayForces()
    {
        Scene scene = chain(1, 100.0);
        scene.settings.viscosity = 0.0;
        scene.settings.airDensity = 0.0;
        Simulation simulation(*compile(scene));
        QCOMPARE(simulation.system().springsAsRods, std::size_t(0));
        QVERIFY(simulation.runUntil(10.0));
        double highest = -2.0;
        while (simulation.state().time < 11.0) {
            QVERIFY(simulation.step());
            highest = std::max(highest, lowest(simulation));
        }
        QVERIFY2(std::abs(highest + 1.0) < 0.001, qPrintable(QString::number(highest)));
    }

    // A single spring between a pin and a mass m is a force while h < sqrt(2 m / k), by the bound
    // of Gershgorin, with a twentieth to spare.
    void changesOverAtTheLimitOfTheSubstep()
    {
        const double substep = Settings().timeStep / Settings().substeps;
        const double atLimit = 2.0 * (load + grain) / (1.05 * 1.05 * substep * substep);
        const auto isTogether = [](const Scene& scene) {
            return springsAreTogether(scene, ElementIndex(scene));
        };
        QVERIFY(!isTogether(chain(1, 0.999 * atLimit)));
        QVERIFY(isTogether(chain(1, 1.001 * atLimit)));
    }

    // Who names an integrator of forces gets forces, and is told what they need.
    void namedIntegratorsKeepThemForces()
    {
        Scene scene = chain(30, 1e6);
        for (const Integrator integrator :
             {Integrator::SemiImplicitEuler, Integrator::VelocityVerlet, Integrator::RungeKutta4}) {
            scene.settings.integrator = integrator;
            QCOMPARE((*compile(scene))->springsAsRods, std::size_t(0));
            QVERIFY(!problemsOf(scene).empty());
        }
        scene.settings.integrator = Integrator::ImplicitEuler;
        QCOMPARE((*compile(scene))->springsAsRods, std::size_t(30));
        scene.settings.solver = Solver::SmallSteps;
        QCOMPARE((*compile(scene))->springsAsRods, std::size_t(0));
        QVERIFY(!problemsOf(scene).empty());
    }

    // A damper alone has nothing that a rod could give way by.
    void dampersStayForces()
    {
        Scene scene = chain(3, 1e6);
        Link& damper = std::get<Part>(scene.items.back().item).links[1];
        damper.stiffness = 0.0;
        damper.damping = 0.1;
        const auto system = *compile(scene);
        QCOMPARE(system->springsAsRods, std::size_t(2));
        QCOMPARE(system->springs.size(), std::size_t(1));
    }

    // Kelvin and Voigt's solid either way: the rod has 1 / k and nu / k.
    void becomeRodsOfTheSameLaw()
    {
        Scene scene = chain(2, 1e6);
        Link& spring = std::get<Part>(scene.items.back().item).links[0];
        spring.damping = 50.0;
        spring.resists = Resists::Tension;
        spring.tearLimit = 0.3;
        std::get<Material>(scene.items.front().item).tearRule = TearRule::Strain;
        const auto system = *compile(scene);
        const LinkPlace& link = system->links[0];
        QCOMPARE(int(link.kind), int(LinkKind::Rod));
        const Rod& rod = system->rods[std::size_t(link.index)];
        QCOMPARE(rod.compliance, 1.0 / 2e6);
        QCOMPARE(rod.dampingTime, 50.0 / 2e6);
        QCOMPARE(int(rod.resists), int(Resists::Tension));
        QCOMPARE(rod.tear, (TearLimit{TearRule::Strain, 0.3}));
        const Spring again = asSpring(rod);
        QCOMPARE(again.stiffness, 2e6);
        QVERIFY(std::abs(again.damping - 50.0) < 1e-12);
    }

    // Pulled by a slider in flight from what a force can do to what it cannot, and back: the load
    // moves no faster than twice the steepest of the ramp.
    void editsInFlightThrowNothing()
    {
        LiveSystem live(chain(10, 20.0));
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        QCOMPARE(simulation.system().springsAsRods, std::size_t(0));
        QVERIFY(simulation.runUntil(3.0));
        live.apply({Message("test"), {cordStiffness(live.scene(), 1e7)}});
        simulation.load(std::get<Update>(live.update(2, 1)));
        QCOMPARE(simulation.system().springsAsRods, std::size_t(10));
        QVERIFY(!simulation.state().ramps.empty());
        const double up = fastestIn(simulation, 4.0);
        const double stiff = stretchOf(10, 1e6);
        const double way = stretchOf(10, 20.0) - stiff;
        const double steepest = 1.5 * way / live.scene().settings.rampTime;
        QVERIFY2(up < 2.0 * steepest, qPrintable(QString::number(up)));
        QVERIFY(std::abs(-1.0 - lowest(simulation) - stiff) < 0.01 * stiff);

        live.apply({Message("test"), {cordStiffness(live.scene(), 200.0)}});
        simulation.load(std::get<Update>(live.update(3, 1)));
        QCOMPARE(simulation.system().springsAsRods, std::size_t(0));
        QVERIFY(fastestIn(simulation, 4.0) < 2.0 * steepest);
        QVERIFY(!simulation.trouble());
    }

    // A number of one of them makes a new system, the same as that of a compile.
    void editsAreAsCompiled()
    {
        LiveSystem live(chain(4, 1e6));
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        const Id link = std::get<Part>(live.scene().items.back().item).links[2].id;
        for (const double stiffness : {5e7, 0.0, 1e3}) {
            live.apply({Message("test"),
                        {SetValues{findProperty(Kind::Link, "stiffness"), {link}, {stiffness}}}});
            simulation.load(std::get<Update>(live.update(2, 1)));
            QVERIFY(simulation.system() == **compile(live.scene(), 2, 1));
        }
    }
};

const RegisteredTest registered("test_stiff_springs", runWithCore<TestStiffSprings>);

} // namespace ripstop::test_stiff_springs
#include "test_stiff_springs.moc"
