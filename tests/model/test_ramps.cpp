// Edits in flight: links take over what is typed within the time that the author has set, so that
// nothing is thrown, and with the same bits however the edit comes.
#include "builders/network.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "measure/diagnostics.h"
#include "registered_test.h"

#include "edited_flight.h"
#include "first_item.h"
#include "sample_scenes.h"

#include <QtTest>

#include <map>

namespace ripstop::test_ramps {

namespace {

// A mass of 1 kg on a single link of 1 m, 1 cm longer than that: the pull of gravity at 1 kN/m.
Scene hanging(LinkKind kind)
{
    Scene scene;
    scene.settings.timeStep = 0.001;
    scene.settings.substeps = 1;
    scene.settings.solver = Solver::Direct;
    scene.settings.viscosity = 5.0;
    Material line{"line"};
    line.stiffness = 1000.0;
    line.compliance = 0.001;
    const Id material = addItem(scene, line);
    Network network(scene, "line");
    const Id top = network.particle({0.0, 0.0, 0.0}, 1.0);
    const Id load = network.particle({0.0, -1.00980665, 0.0}, 1.0);
    if (kind == LinkKind::Rod)
        network.rod(top, load, material);
    else
        network.spring(top, load, material);
    network.row(top).pinned = true;
    const Id part = network.finish({}, {});
    std::get<Part>(*findItem(scene, part)).links[0].restLength = 1.0;
    return scene;
}

double compliance(const Simulation& simulation) { return simulation.system().rods[0].compliance; }

// Sets a number of all materials.
Scene withAll(Scene scene, double Material::*number, double value)
{
    for (Entry& entry : scene.items)
        if (auto* material = std::get_if<Material>(&entry.item))
            material->*number = value;
    return scene;
}

Id mainMaterial(const Scene& scene) // that most links are made of
{
    std::map<Id, int> links;
    for (const Link& link : partOf(scene).links)
        ++links[link.material];
    return std::ranges::max_element(links, {}, [](const auto& one) { return one.second; })->first;
}

} // namespace

class TestRamps : public QObject
{
    Q_OBJECT

private slots:
    // s^2 (3 - 2 s) of the way after the share s of the time: 5/32 after a quarter, half after a
    // half; then exactly what was typed.
    void numbersGoOver()
    {
        Scene scene = hanging(LinkKind::Rod);
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.2);
        firstOf<Material>(scene).compliance = 0.0002;
        edit(simulation, scene);
        QCOMPARE(compliance(simulation), 0.001);
        runFor(simulation, 0.025);
        QVERIFY(std::abs(compliance(simulation) - (0.001 - 0.0008 * 5.0 / 32.0)) < 1e-9);
        runFor(simulation, 0.025);
        QVERIFY(std::abs(compliance(simulation) - 0.0006) < 1e-9);
        runFor(simulation, 0.051);
        QCOMPARE(compliance(simulation), 0.0002);
        QVERIFY(simulation.state().ramps.empty());
    }

    // The load follows without a swing: its way is the change of the stretch, 9.80665 N times that
    // of the compliance, and no more.
    void loadsAreNotThrown_data()
    {
        QTest::addColumn<bool>("isRod");
        QTest::newRow("rod") << true;
        QTest::newRow("spring") << false;
    }
    void loadsAreNotThrown()
    {
        QFETCH(bool, isRod);
        Scene scene = hanging(isRod ? LinkKind::Rod : LinkKind::Spring);
        scene.settings.rampTime = 1.0;
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.2);
        firstOf<Material>(scene).compliance = 0.0001;
        firstOf<Material>(scene).stiffness = 10000.0;
        edit(simulation, scene);
        double highest = -2.0, fastest = 0.0;
        while (simulation.state().time < 2.0) {
            QVERIFY(simulation.step());
            highest = std::max(highest, simulation.state().position[1].y());
            fastest = std::max(fastest, simulation.state().velocity[1].norm());
        }
        const double end = -1.0 - 9.80665 * 0.0001;
        QVERIFY2(std::abs(simulation.state().position[1].y() - end) < 1e-6,
                 qPrintable(QString::number(simulation.state().position[1].y(), 'g', 12)));
        QVERIFY(highest < end + 0.0002);
        QVERIFY2(fastest < 2.0 * 1.5 * 9.80665 * 0.0009, // twice the steepest of the ramp
                 qPrintable(QString::number(fastest)));
    }

    // What a user did: softer by a slider, and back by a typed 0.
    void kitesAreNotThrown()
    {
        const Scene stiff = sample("delta_kite");
        const Scene soft = withAll(stiff, &Material::compliance, 0.01);
        Simulation simulation(*compile(stiff));
        double fastest = 0.0;
        const auto fly = [&](double seconds) {
            const double end = simulation.state().time + seconds;
            while (simulation.state().time < end) {
                QVERIFY(simulation.step());
                for (const PaddedVec3& velocity : simulation.state().velocity)
                    fastest = std::max(fastest, velocity.norm());
            }
        };
        fly(1.0);
        edit(simulation, soft);
        fly(1.0);
        edit(simulation, stiff);
        QVERIFY(simulation.state().ramps[0].lasts > 1.0); // its line has metres to go
        fly(4.0);
        QVERIFY2(fastest < 10.0, qPrintable(QString::number(fastest))); // in a wind of 6 m/s
        const auto frame = simulation.frame();
        double strain = 0.0;
        for (const double one : frame->strain)
            strain = std::max(strain, std::abs(one));
        QVERIFY2(strain < 0.01, qPrintable(QString::number(strain)));
    }

    // A limit comes down slowly, and what is overloaded then tears; another rule counts at once.
    void limitsGoOverAndRulesCount()
    {
        Scene scene = hanging(LinkKind::Rod);
        firstOf<Material>(scene).tearRule = TearRule::Force;
        firstOf<Material>(scene).tearLimit = 100.0;
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.2);
        firstOf<Material>(scene).tearLimit = 5.0;
        edit(simulation, scene);
        runFor(simulation, 0.05);
        QVERIFY(std::abs(simulation.system().rods[0].tear.limit - 52.5) < 1e-6);
        QVERIFY(simulation.state().tears.empty());
        runFor(simulation, 0.06);
        QCOMPARE(simulation.state().tears.size(), std::size_t(1));

        Scene other = hanging(LinkKind::Rod);
        Simulation strained(*compile(other));
        runFor(strained, 0.2);
        firstOf<Material>(other).tearRule = TearRule::Strain;
        firstOf<Material>(other).tearLimit = 0.5;
        edit(strained, other);
        QCOMPARE(strained.system().rods[0].tear.limit, 0.5);
        runFor(strained, 0.2);
        QVERIFY(strained.state().tears.empty());
    }

    // One that comes in between begins where the first has come to; an edit of something else
    // leaves it alone.
    void editsMayComeInBetween()
    {
        Scene scene = hanging(LinkKind::Rod);
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.2);
        firstOf<Material>(scene).compliance = 0.0002;
        edit(simulation, scene);
        runFor(simulation, 0.05);
        scene.settings.viscosity = 6.0;
        edit(simulation, scene);
        QVERIFY(std::abs(compliance(simulation) - 0.0006) < 1e-9);
        QCOMPARE(simulation.state().ramps.size(), std::size_t(1));
        firstOf<Material>(scene).compliance = 0.0016;
        edit(simulation, scene);
        QVERIFY(std::abs(compliance(simulation) - 0.0006) < 1e-9);
        runFor(simulation, 0.05);
        QVERIFY(std::abs(compliance(simulation) - 0.0011) < 1e-9);
        runFor(simulation, 0.06);
        QCOMPARE(compliance(simulation), 0.0016);
    }

    // A slider that is pulled faster than steps are made sends many edits between two of them. They
    // are taken over as one, to the same bits as one after the other; in a torn mesh as well.
    void editsThatComeTogetherAreOne()
    {
        for (const char* name : {"delta_kite", "split_sheet"}) {
            LiveSystem live(sample(name));
            Simulation together(std::get<Update>(live.update(1, 1)).system);
            Simulation apart(*compile(live.scene(), 1, 1));
            for (Simulation* simulation : {&together, &apart})
                runFor(*simulation, 1.0);
            std::vector<Update> updates;
            std::uint64_t generation = 1;
            const auto type = [&](const char* key, double value) {
                live.apply({Message("test"),
                            {SetValues{findProperty(Kind::Material, key),
                                       {mainMaterial(live.scene())},
                                       {value}}}});
                updates.push_back(std::get<Update>(live.update(++generation, 1)));
                QVERIFY(updates.back().patch);
            };
            for (const double value : {1e-6, 3e-6, 2e-6})
                type("compliance", value);
            type("stiffness", 150.0);
            type("tearLimit", 0.9);
            for (const Update& update : updates)
                apart.load(update);
            together.load(updates);
            QVERIFY(!together.state().ramps.empty());
            QCOMPARE(differingField(together.system(), apart.system()), std::string_view());
            for (int step = 0; step < 40; ++step)
                for (Simulation* simulation : {&together, &apart})
                    QVERIFY(simulation->step());
            QCOMPARE(stateHash(together.state()), stateHash(apart.state()));
        }
    }

    void countsAtOnceWhereNothingMovesYetOrNoTimeIsGiven()
    {
        Scene scene = hanging(LinkKind::Rod);
        Simulation simulation(*compile(scene));
        firstOf<Material>(scene).compliance = 0.0002;
        edit(simulation, scene);
        QCOMPARE(compliance(simulation), 0.0002);
        QVERIFY(simulation.state().ramps.empty());
        runFor(simulation, 0.1);
        scene.settings.rampTime = 0.0;
        firstOf<Material>(scene).compliance = 0.0004;
        edit(simulation, scene);
        QCOMPARE(compliance(simulation), 0.0004);
    }

    // A new run begins with what was typed.
    void endsWithTheRun()
    {
        Scene scene = hanging(LinkKind::Rod);
        LiveSystem live(scene);
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        runFor(simulation, 0.2);
        const Property* property = findProperty(Kind::Material, "compliance");
        Id material = noId;
        for (const Entry& entry : scene.items)
            if (std::holds_alternative<Material>(entry.item))
                material = entry.id;
        live.apply({Message("test"), {SetValues{property, {material}, {0.0002}}}});
        simulation.load(std::get<Update>(live.update(2, 1)));
        runFor(simulation, 0.05);
        QCOMPARE(simulation.state().ramps.size(), std::size_t(1));
        const Update again = std::get<Update>(live.update(3, 2));
        simulation.load(again);
        QVERIFY(simulation.state().ramps.empty());
        QCOMPARE(compliance(simulation), 0.0002);
        QCOMPARE(differingField(simulation.system(), **compile(live.scene(), 3, 2)),
                 std::string_view());
    }

    // With springs between pins nothing moves: what the hand brings is (k1 - k0) d^2 / 2.
    void ledgerShowsWhatTheHandBrought()
    {
        Scene scene = hanging(LinkKind::Spring);
        for (Entry& entry : scene.items)
            if (auto* part = std::get_if<Part>(&entry.item))
                for (Particle& particle : part->particles)
                    particle.pinned = true;
        addProbe(scene, "hands", Quantity::WorkOfHands, noId);
        addProbe(scene, "left over", Quantity::EnergyResidual, noId);
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.01);
        firstOf<Material>(scene).stiffness = 3000.0;
        edit(simulation, scene);
        runFor(simulation, 0.2);
        const double brought = 0.5 * 2000.0 * 0.00980665 * 0.00980665;
        QVERIFY(std::abs(probe(simulation, "hands") - brought) < 1e-6 * brought);
        QVERIFY(std::abs(probe(simulation, "left over")) < 1e-9 * brought);
    }

    void isRecorded()
    {
        const Scene scene = sample("delta_kite");
        checkEditIsRecorded(scene, withAll(scene, &Material::compliance, 1e-4),
                            [](const State& state) { return !state.ramps.empty(); });
    }

    // In a torn mesh as well, whose system is derived from the one that is patched.
    void goesOverInATornMesh()
    {
        Scene scene = sample("split_sheet");
        Simulation simulation(*compile(scene));
        while (simulation.state().splits.empty() && simulation.state().time < 5.0)
            QVERIFY(simulation.step());
        QVERIFY(!simulation.state().splits.empty());
        Scene softer = scene;
        for (Entry& entry : softer.items)
            if (auto* material = std::get_if<Material>(&entry.item)) {
                material->stiffness *= 0.5;
                material->compliance = 2.0 * material->compliance + 1e-6;
            }
        edit(simulation, softer);
        const State middle = simulation.state();
        QVERIFY(!middle.ramps.empty());
        const auto compiled = *compile(softer, simulation.system().generation, 1);
        Simulation other(compiled, middle);
        for (int step = 0; step < 60; ++step) {
            QVERIFY(simulation.step());
            QVERIFY(other.step());
        }
        QCOMPARE(stateHash(other.state()), stateHash(simulation.state()));
        QVERIFY(simulation.state().ramps.empty());
    }
};

const RegisteredTest registered("test_ramps", runWithCore<TestRamps>);

} // namespace ripstop::test_ramps
#include "test_ramps.moc"
