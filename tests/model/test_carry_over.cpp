// A running state carried into an edited system.
//
// Stages: edits that change nothing or only the order; particles that are added, removed or pinned
// in motion; tears and panels that must stay gone; inputs; and the time for a long row of new
// particles.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/carry_over.h"
#include "measure/diagnostics.h"

#include <QtTest>

#include <algorithm>

namespace ripstop::test_carry_over {

namespace {

// A rope of `count` particles with keys from 100, links from 200, hung from the first one. The
// particles stand in the system in the order that `reversed` says.
System rope(int count, bool reversed = false)
{
    System system = emptySystem(1.0 / 240.0);
    system.gravity = {0.0, -standardGravity, 0.0};
    for (int n = 0; n < count; ++n) {
        const int i = reversed ? count - 1 - n : n;
        if (i == 0)
            addPin(system, Vec3::Zero(), 0.01);
        else
            addParticle(system, {0.1 * i, 0.0, 0.0}, 0.01);
        system.key.push_back(Key(100 + i));
    }
    const auto place = [&](int i) { return reversed ? count - 1 - i : i; };
    for (int i = 1; i < count; ++i) {
        system.links.push_back({Key(200 + i), LinkKind::Rod, i - 1, place(i - 1), place(i)});
        addRod(system, place(i - 1), place(i), 0.1).tear = {TearRule::Force, 1e6};
    }
    finish(system);
    return system;
}

std::size_t indexOf(const System& system, int key)
{
    return std::size_t(std::find(system.key.begin(), system.key.end(), Key(key))
                       - system.key.begin());
}

std::uint8_t& tornOf(const System& system, State& state, int key)
{
    const auto link = std::find_if(system.links.begin(), system.links.end(),
                                   [&](const LinkPlace& l) { return l.key == Key(key); });
    return (link->kind == LinkKind::Rod ? state.rodTorn
                                        : state.springTorn)[std::size_t(link->index)];
}

} // namespace

class TestCarryOver : public QObject
{
    Q_OBJECT

private slots:
    // Another integrator goes on with the same motion, though it looks back to other things.
    void goesOnByAnotherIntegrator_data()
    {
        QTest::addColumn<Integrator>("before");
        QTest::addColumn<Integrator>("after");
        for (const Integrator before :
             {Integrator::SemiImplicitEuler, Integrator::Verlet, Integrator::VelocityVerlet})
            QTest::addRow("%s to bdf2", choiceNames<Integrator>[std::size_t(before)].data())
                << before << Integrator::Bdf2;
        QTest::newRow("bdf2 to verlet") << Integrator::Bdf2 << Integrator::Verlet;
    }

    void goesOnByAnotherIntegrator()
    {
        QFETCH(Integrator, before);
        QFETCH(Integrator, after);
        for (const int substeps : {1, 2}) {
            System from = rope(2);
            from.solver = Solver::Direct;
            from.substeps = 1;
            from.integrator = before;
            System to = from;
            to.integrator = after;
            to.substeps = substeps;
            const State swinging = run(from, 30);
            const double speed = swinging.velocity[1].norm(); // m/s, of 1.2
            const State later = run(to, carryOver(from, swinging, to), 1);
            // a step of a fall at most, on the way along the arc
            const double most = standardGravity * to.timeStep;
            QVERIFY2(isNear(later.velocity[1].norm(), speed, 1.01 * most),
                     told(later.velocity[1].norm(), speed));
        }
    }

    // An edit that changes nothing changes nothing, to the bit.
    void sameSystem()
    {
        for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::Verlet}) {
            System first = rope(10);
            first.integrator = integrator;
            const System second = first;
            const State half = run(first, 100);
            const State carried = carryOver(first, half, second);
            QCOMPARE(carried.time, half.time);
            QCOMPARE(carried.step, half.step);
            QCOMPARE(stateHash(run(second, carried, 100)), stateHash(run(first, half, 100)));
        }
    }

    // Particles are known by their keys, not by their places.
    void otherOrder()
    {
        const System first = rope(10);
        const System second = rope(10, true);
        State half = run(first, 100);
        half.rodTension.assign(half.rodTension.size(), 3.0);
        tornOf(first, half, 204) = 1;
        State carried = carryOver(first, half, second);
        for (int key = 100; key < 110; ++key) {
            QCOMPARE(carried.position[indexOf(second, key)], half.position[indexOf(first, key)]);
            QCOMPARE(carried.velocity[indexOf(second, key)], half.velocity[indexOf(first, key)]);
        }
        for (int key = 201; key < 210; ++key)
            QCOMPARE(int(tornOf(second, carried, key)), key == 204 ? 1 : 0);
    }

    // What has been added moves along with what it hangs on, wherever the motion has got to.
    void addedParticlesFollow_data()
    {
        QTest::addColumn<bool>("reversed");
        QTest::newRow("in order") << false;
        QTest::newRow("against the order") << true;
    }
    void addedParticlesFollow()
    {
        QFETCH(bool, reversed);
        const System first = rope(5);
        const System second = rope(9, reversed);
        const State half = run(first, 60);
        const State carried = carryOver(first, half, second);
        const Vec3 moved = half.position[4] - first.start.position[4];
        QVERIFY(moved.norm() > 0.01);
        for (int key = 105; key < 109; ++key) {
            const std::size_t i = indexOf(second, key);
            QVERIFY(isNear(carried.position[i], second.start.position[i] + moved, 1e-15));
            QCOMPARE(carried.velocity[i], half.velocity[4]);
        }
        for (const double strain : strains(second, carried)) // no jerk
            QVERIFY2(std::abs(strain) < 1e-2, told(strain, 0.0));
    }

    void strangersStartAtHome_data()
    {
        QTest::addColumn<Integrator>("integrator");
        for (const Integrator integrator :
             {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler, Integrator::Verlet,
              Integrator::VelocityVerlet})
            QTest::newRow(choiceNames<Integrator>[std::size_t(integrator)].data()) << integrator;
    }

    // A particle that is tied to nothing that moves starts where its author put it, as fast as its
    // author wants it, although the others have been on their way for long.
    void strangersStartAtHome()
    {
        QFETCH(Integrator, integrator);
        System first = rope(3);
        first.integrator = integrator;
        System second = first;
        second.start = State{};
        second.start.position = first.start.position;
        second.start.velocity = first.start.velocity;
        addParticle(second, {7.0, 8.0, 9.0}, 1.0, {1.0, 0.0, 2.0});
        second.key.push_back(Key(900));
        finish(second);
        const State carried = carryOver(first, run(first, 60), second);
        QCOMPARE(carried.position[3], Vec3(7.0, 8.0, 9.0));
        QCOMPARE(carried.velocity[3], Vec3(1.0, 0.0, 2.0));
        const Vec3 later = run(second, carried, 240).position[3];
        QVERIFY2(isNear(later, Vec3(8.0, 8.0 - 0.5 * standardGravity, 11.0), 0.03),
                 told(later, Vec3(8.0, 8.0 - 0.5 * standardGravity, 11.0)));
    }

    void removedParticles()
    {
        const System first = rope(8);
        const System second = rope(5);
        const State half = run(first, 60);
        const State carried = carryOver(first, half, second);
        QCOMPARE(carried.position.size(), std::size_t(5));
        QCOMPARE(carried.rodTorn.size(), std::size_t(4));
        QCOMPARE(carried.position[4], half.position[4]);
        QVERIFY(run(second, carried, 100).position[4].allFinite());
    }

    // Torn links stay torn through any edit, and their panels gone; a link that has been turned
    // from a rod into a spring is still the same link.
    void tornStaysTorn()
    {
        System first = rope(6);
        State half = run(first, 30);
        tornOf(first, half, 203) = 1;
        half.tears.push_back({0.1, Key(203), 0.2, 1.0, 5.0, Vec3::Zero()});

        System second = emptySystem(1.0 / 240.0);
        second.gravity = first.gravity;
        second.key = first.key;
        second.mass = first.mass;
        second.inverseMass = first.inverseMass;
        second.start.position = first.start.position;
        for (int i = 1; i < 6; ++i) {
            second.links.push_back({Key(200 + i), LinkKind::Spring, i - 1, i - 1, i});
            addSpring(second, i - 1, i, 0.1, 100.0, 0.1);
        }
        finish(second);
        State carried = carryOver(first, half, second);
        for (int key = 201; key < 206; ++key)
            QCOMPARE(int(tornOf(second, carried, key)), key == 203 ? 1 : 0);
        QCOMPARE(carried.tears.size(), std::size_t(1));
        carried = run(second, carried, 240);
        QVERIFY2(carried.position[4].y() < -2.0, "the torn-off end falls");
        QVERIFY2(carried.position[2].y() > -0.5, "the other end hangs");
        QCOMPARE(carried.tears.size(), std::size_t(1));
    }

    void panelsStayGone()
    {
        System first = emptySystem(0.01);
        for (int i = 0; i < 5; ++i)
            addParticle(first, {0.1 * i, 0.1 * (i % 2), 0.0}, 0.1);
        System second = first;
        for (const int i : {0, 1, 2})
            addPanel(first, i, i + 1, i + 2, AirLaw::Paper, 1.0);
        first.panelKey = {Key(31), Key(32), Key(33)};
        for (const int i : {2, 0})
            addPanel(second, i, i + 1, i + 2, AirLaw::Paper, 1.0);
        second.panelKey = {Key(33), Key(31)};
        finish(first);
        finish(second);
        first.start.panelGone = {1, 0, 0};
        const State carried = carryOver(first, first.start, second);
        QCOMPARE(carried.panelGone, (std::vector<std::uint8_t>{0, 1}));
    }

    // Panels that nobody gave a key are told apart by their place.
    void panelsWithoutKeys()
    {
        System system = emptySystem(0.01);
        for (int i = 0; i < 5; ++i)
            addParticle(system, {0.1 * i, 0.1 * (i % 2), 0.0}, 0.1);
        for (const int i : {0, 1, 2})
            addPanel(system, i, i + 1, i + 2, AirLaw::Paper, 1.0);
        finish(system);
        system.start.panelGone = {0, 1, 0};
        QCOMPARE(carryOver(system, system.start, system).panelGone,
                 (std::vector<std::uint8_t>{0, 1, 0}));
    }

    // Pinned while it moves, a particle stops where it is, at once: no velocity is left for the
    // air or the dampers to feel. Let go again, it starts from rest.
    void pinnedOnTheWay()
    {
        System first = emptySystem(0.01, Integrator::Verlet);
        addParticle(first, Vec3::Zero(), 1.0, {2.0, 0.0, 0.0});
        System second = first;
        second.inverseMass[0] = 0.0;
        finish(first);
        finish(second);
        const State half = run(first, 50);
        const State pinned = carryOver(first, half, second);
        QCOMPARE(pinned.velocity[0], Vec3(Vec3::Zero()));
        QCOMPARE(pinned.drift[0], Vec3(Vec3::Zero()));
        QVERIFY(isNear(pinned.position[0], Vec3(1.0, 0.0, 0.0), 1e-12));
        const State freed = carryOver(second, run(second, pinned, 50), first);
        const State end = run(first, freed, 50);
        QVERIFY2(isNear(end.position[0], Vec3(1.0, 0.0, 0.0), 1e-12),
                 told(end.position[0], Vec3(1.0, 0.0, 0.0)));
    }

    // Inputs keep where they are and where they were told to go, by key.
    void inputs()
    {
        System first = rope(3);
        first.inputs = {{Key(1), ControlKind::Move, {1.0, 0.0, 0.0}, 1.0, 0.5, 0.0, {0}},
                        {Key(2), ControlKind::Move, {0.0, 1.0, 0.0}, 1.0, 0.5, 0.0, {0}}};
        System second = first;
        std::swap(second.inputs[0], second.inputs[1]);
        finish(first);
        finish(second);
        State state = first.start;
        state.inputCommand = {0.4, 0.0};
        state = run(first, state, 48);
        const State carried = carryOver(first, state, second);
        QCOMPARE(carried.inputCommand, (std::vector<double>{0.0, 0.4}));
        QCOMPARE(carried.inputValue, (std::vector<double>{0.0, state.inputValue[0]}));
        QVERIFY(isNear(carried.inputValue[1], 0.1, 1e-12));
    }

    // Thousands of new particles in a row, listed from the far end, are placed in no time.
    void longRow()
    {
        const System first = rope(3);
        const System second = rope(50000, true);
        const State carried = carryOver(first, run(first, 30), second);
        QVERIFY(carried.position[0].y() < 0.0);
    }
};

const RegisteredTest registered("test_carry_over", runPlain<TestCarryOver>);

} // namespace ripstop::test_carry_over
#include "test_carry_over.moc"
