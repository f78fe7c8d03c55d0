// What lines and spars bear when they break in a jerk: by default what they hold, and no more than
// the accuracy above it, however long the steps are.
#include "builders/builder.h"
#include "builders/network.h"
#include "compile/compile.h"
#include "model/first_item.h"
#include "registered_test.h"
#include "run/tear_report.h"
#include "simulation/simulation.h"

#include <QtTest>

namespace ripstop::test_break_loads {

namespace {

// As a new user builds it: a rope of Dyneema of 1 mm with a weight of 0.5 kg, which falls from
// above its upper end until the rope stops it, with some 170 N.
Scene rope(double segments)
{
    const Builder& builder = *findBuilder("rope");
    return *build(
        builder,
        newDesign(builder,
                  {{"cord", 1.0}, {"angle", 110.0}, {"end_mass", 0.5}, {"segments", segments}}));
}

// A spar that is clamped at one end, with a load at the other that is not yet held by anything.
//   breaking  N m
//   load      N, under gravity
Scene cantilever(double reach, double breaking, double load)
{
    constexpr int links = 8;
    constexpr double density = 0.05; // kg/m
    Scene scene;
    const Id id = takeId(scene);
    Material material;
    material.name = "tube";
    material.axialStiffness = 1e6;
    material.flexuralRigidity = 20.0;
    material.tearRule = TearRule::Strength;
    material.breakingMoment = breaking;
    scene.items.push_back({id, material});
    Part part;
    part.name = "spar";
    const double cell = reach / links;
    for (int i = -1; i <= links; ++i) {
        Particle particle;
        particle.id = takeId(scene);
        particle.position = {i * cell, 0.0, 0.0};
        particle.pinned = i <= 0;
        particle.mass = density * cell + (i == links ? load / standardGravity : 0.0);
        part.particles.push_back(particle);
        if (i < 0)
            continue;
        Link link;
        link.id = takeId(scene);
        link.from = part.particles[std::size_t(i)].id;
        link.to = particle.id;
        link.material = id;
        link.restLength = cell;
        part.links.push_back(link);
    }
    scene.items.push_back({takeId(scene), part});
    return scene;
}

// Steps until something breaks, for a second at the most.
bool flyToTheBreak(Simulation& simulation)
{
    while (simulation.state().tears.empty())
        if (!simulation.step() || simulation.state().time > 1.0)
            return false;
    return true;
}

} // namespace

class TestBreakLoads : public QObject
{
    Q_OBJECT

private slots:
    void linesBreakAtWhatTheyHold_data()
    {
        QTest::addColumn<double>("rate"); // Hz
        QTest::addColumn<double>("segments");
        QTest::addColumn<bool>("splits"); // the mesh, which is judged at the ends of steps
        for (const double rate : {120.0, 240.0, 1000.0})
            for (const double segments : {1.0, 20.0})
                for (const bool splits : {false, true})
                    QTest::addRow("%g links at %g Hz%s", segments, rate, splits ? ", split" : "")
                        << rate << segments << splits;
    }

    void linesBreakAtWhatTheyHold()
    {
        QFETCH(const double, rate);
        QFETCH(const double, segments);
        QFETCH(const bool, splits);
        for (const double strength : {60.0, 100.0, 140.0}) {
            Scene scene = rope(segments);
            scene.settings.timeStep = 1.0 / rate;
            scene.settings.tearMesh = splits ? TearMesh::Split : TearMesh::Vanish;
            Material& cord = firstOf<Material>(scene);
            cord.lineStrength = strength;
            cord.jointEfficiency = 1.0;
            Simulation simulation(*compile(scene));
            QVERIFY(flyToTheBreak(simulation));
            const State& state = simulation.state();
            QCOMPARE(state.tears.size(), 1u);
            const double force = state.tears[0].force;
            QVERIFY2(force > strength && force < (1.0 + 0.01 * scene.settings.accuracy) * strength,
                     qPrintable(QString("%1 of %2 N").arg(force).arg(strength)));
        }
    }

    // A spar on which a load comes at once swings to twice of what it bears at rest, and is beyond
    // its moment halfway there.
    void sparsSnapAtWhatTheyBear_data()
    {
        QTest::addColumn<double>("rate"); // Hz
        for (const double rate : {60.0, 120.0, 240.0, 1000.0})
            QTest::addRow("at %g Hz", rate) << rate;
    }

    void sparsSnapAtWhatTheyBear()
    {
        QFETCH(const double, rate);
        constexpr double breaking = 3.0; // N m
        constexpr double reach = 0.5;    // m
        Scene scene = cantilever(reach, breaking, 0.9 * breaking / reach);
        scene.settings.timeStep = 1.0 / rate;
        Simulation simulation(*compile(scene));
        QVERIFY(flyToTheBreak(simulation));
        const Tear tear = simulation.frame()->tears[0];
        QVERIFY(isSnap(tear));
        QVERIFY2(tear.force > breaking
                     && tear.force < (1.0 + 0.01 * scene.settings.accuracy) * breaking,
                 qPrintable(QString("%1 of %2 N m").arg(tear.force).arg(breaking)));
    }

    // The steps after it are as long as those before.
    void itIsOneStepThatIsFiner()
    {
        Scene scene = rope(20.0);
        firstOf<Material>(scene).lineStrength = 100.0;
        Simulation simulation(*compile(scene));
        int before = 0;
        while (simulation.state().tears.empty()) {
            before = simulation.state().substeps;
            QVERIFY(simulation.step() && simulation.state().time < 1.0);
        }
        QCOMPARE(simulation.state().substeps, before);
        const std::int64_t substep = simulation.state().substep;
        for (int i = 0; i < 20; ++i)
            QVERIFY(simulation.step());
        QVERIFY(simulation.state().substep - substep < 20 * 16);
    }

    // Finer steps would not help a line whose strength has fallen below what it bears.
    void strengthThatIsTakenAwayCostsNothing()
    {
        Scene scene = rope(20.0);
        const Builder& builder = *findBuilder("rope");
        scene =
            *build(builder, newDesign(builder, {{"cord", 1.0}, {"angle", 0.0}, {"end_mass", 0.5}}));
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(1.0));
        firstOf<Material>(scene).lineStrength = 2.0; // N, of 5 N
        simulation.load(*compile(scene, 2));
        std::int64_t before = 0;
        while (simulation.state().tears.empty()) {
            QVERIFY(simulation.state().time < 2.0);
            before = simulation.state().substep;
            QVERIFY(simulation.step());
        }
        QVERIFY2(simulation.state().substep - before <= 16,
                 qPrintable(QString::number(simulation.state().substep - before)));
    }
};

const RegisteredTest registered("test_break_loads", runPlain<TestBreakLoads>);

} // namespace ripstop::test_break_loads
#include "test_break_loads.moc"
