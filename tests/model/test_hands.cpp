// What hands do to a run: pulls, pins, fans and colliders that are carried.
//
// Stages: pulls against springs and statics, their limit and momentum; stiff hands and hands at
// nothing; pins, fans and carried colliders; then bits at any number of threads, and edits while
// something is held.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "forces/hand_pull.h"
#include "forces/panel_load.h"
#include "io/control_track.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>

#include <QTemporaryDir>
#include <QtTest>

#include <numbers>

namespace ripstop::test_hands {

namespace {

HandPull pullAt(Key particle, const Vec3& to, double stiffness)
{
    HandPull pull;
    pull.grip.particle = {particle, 0, 0};
    pull.to = to;
    pull.stiffness = stiffness;
    pull.damping = 0.0;
    pull.most = 1e9;
    return pull;
}

System oneParticle(double mass, double timeStep, Integrator integrator)
{
    System system = emptySystem(timeStep, integrator);
    addParticle(system, {0.1, 0.0, 0.0}, mass);
    finish(system);
    return system;
}

std::shared_ptr<const System> shared(System system)
{
    return std::make_shared<const System>(std::move(system));
}

Scene cloth() { return *build(*findBuilder("cloth"), {{"columns", 12.0}, {"rows", 12.0}}); }

Vec3 positionOf(const Simulation& simulation, Key key)
{
    const auto& keys = simulation.system().key;
    const auto found = std::find(keys.begin(), keys.end(), key) - keys.begin();
    return simulation.state().position[std::size_t(found)];
}

} // namespace

class TestHands : public QObject
{
    Q_OBJECT

private slots:
    void integrators_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("semi-implicit Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("Verlet") << Integrator::Verlet;
        QTest::newRow("velocity Verlet") << Integrator::VelocityVerlet;
    }

    // A free particle on an undamped hand swings with the period 2 pi sqrt(m / k).
    void swings_data() { integrators_data(); }
    void swings()
    {
        QFETCH(Integrator, integrator);
        const double mass = 0.02, stiffness = 5.0, h = 1e-4;
        const System system = oneParticle(mass, h, integrator);
        State state = system.start;
        state.hands.pull = pullAt(system.key[0], Vec3::Zero(), stiffness);
        Stepper stepper;
        std::vector<double> crossings; // s, downwards through zero
        double before = state.position[0].x();
        while (crossings.size() < 4 && state.time < 5.0) {
            stepper.step(system, state);
            const double now = state.position[0].x();
            if (before > 0.0 && now <= 0.0)
                crossings.push_back(state.time - h * now / (now - before));
            before = now;
        }
        QCOMPARE(crossings.size(), std::size_t(4));
        const double period = (crossings.back() - crossings.front()) / 3.0;
        const double expected = 2.0 * std::numbers::pi * std::sqrt(mass / stiffness);
        QVERIFY2(isNear(period, expected, 1e-5 * expected), told(period, expected));
    }

    // A weight that hangs from a hand hangs m g / k below it, and the hand feels m g; also one that
    // hangs in a rod below the particle in the hand.
    void hangs_data() { integrators_data(); }
    void hangs()
    {
        QFETCH(Integrator, integrator);
        System system = heavySystem(1e-3, integrator);
        addParticle(system, Vec3::Zero(), 0.01);
        addParticle(system, {0.0, -0.5, 0.0}, 0.04);
        addRod(system, 0, 1, 0.5);
        finish(system);
        State state = system.start;
        state.hands.pull = pullAt(system.key[0], Vec3::Zero(), 20.0);
        state.hands.pull->damping = 1.0;
        state = run(system, state, 20000);
        const double weight = 0.05 * standardGravity;
        QVERIFY2(isNear(-state.position[0].y(), weight / 20.0, 1e-6),
                 told(-state.position[0].y(), weight / 20.0));
        const HandForce force = handForce(system, state, *state.hands.pull,
                                          findGrip(system, state.hands.pull->grip), 1e-3);
        QVERIFY2(isNear(force.force, Vec3(0.0, weight, 0.0), 1e-5),
                 told(force.force, Vec3(0.0, weight, 0.0)));
    }

    // A hand pulls no harder than it may: a free particle then speeds up evenly.
    void isClamped()
    {
        const double mass = 0.5, most = 3.0;
        const System system = oneParticle(mass, 1e-3, Integrator::SemiImplicitEuler);
        State state = system.start;
        state.hands.pull = pullAt(system.key[0], {1e6, 0.0, 0.0}, 100.0);
        state.hands.pull->most = most;
        state = run(system, state, 1000);
        QVERIFY2(isNear(state.velocity[0], Vec3(most / mass, 0.0, 0.0), 1e-9),
                 told(state.velocity[0], Vec3(most / mass, 0.0, 0.0)));
    }

    // What a hand gives is what the fabric gets: the momentum of a net of springs and rods changes
    // by the force times the time, its angular momentum by the torque of a pull at the point.
    void momentum()
    {
        Dice dice(5);
        const double h = 1e-3;
        System system = emptySystem(h);
        for (int i = 0; i < 6; ++i)
            addParticle(system, dice.vector(1.0), dice(0.1, 0.3), dice.vector(0.5));
        for (int i = 0; i < 6; ++i)
            addSpring(system, i, (i + 1) % 6, 0.8, 40.0, 0.1);
        addRod(system, 0, 3, distance(system, 0, 3));
        finish(system);
        State state = system.start;
        HandPull pull = pullAt(0, {0.3, 0.4, -0.2}, 30.0);
        pull.damping = 0.7;
        pull.grip = {{system.key[1], system.key[2], system.key[4]}, {0.2, 0.5, 0.3}};
        state.hands.pull = pull;
        const HeldGrip held = findGrip(system, pull.grip);
        Stepper stepper;
        Vec3 given = Vec3::Zero();
        const Vec3 first = ripstop::momentum(system, state);
        for (int i = 0; i < 400; ++i) {
            given += h * handForce(system, state, pull, held, h).force;
            stepper.step(system, state);
        }
        QVERIFY(given.norm() > 0.1);
        const Vec3 gained = ripstop::momentum(system, state) - first;
        QVERIFY2(isNear(gained, given, 1e-11), told(gained, given));

        // the torque of the shares is that of the force at the point
        std::vector<PaddedVec3> pushed(state.position.size(), PaddedVec3());
        addHandPull(system, state, held, h, pushed);
        const HandForce force = handForce(system, state, pull, held, h);
        Vec3 torque = Vec3::Zero();
        for (std::size_t i = 0; i < pushed.size(); ++i)
            torque += state.position[i].cross(Vec3(system.mass[i] * pushed[i]));
        QVERIFY2(isNear(torque, force.point.cross(force.force), 1e-12),
                 told(torque, force.point.cross(force.force)));
    }

    // However stiff a hand is asked to be, on however light a particle among stiff springs, the
    // steps stay stable.
    void stiffHandsAreStable_data()
    {
        QTest::addColumn<double>("mass");      // kg
        QTest::addColumn<double>("stiffness"); // N/m, of the springs beside it
        QTest::addColumn<double>("damping");   // 1, of the hand
        QTest::newRow("alone") << 1e-3 << 0.0 << 1.0;
        QTest::newRow("alone, undamped") << 1e-3 << 0.0 << 0.0;
        QTest::newRow("alone, overdamped") << 1e-3 << 0.0 << 50.0;
        QTest::newRow("very light") << 1e-7 << 0.0 << 1.0;
        // (w h)^2 of the springs is 2 K h^2 / m = 2, half of the limit
        QTest::newRow("among springs") << 1e-3 << 500.0 << 1.0;
        QTest::newRow("among springs, undamped") << 1e-3 << 500.0 << 0.0;
    }
    void stiffHandsAreStable()
    {
        QFETCH(double, mass);
        QFETCH(double, stiffness);
        QFETCH(double, damping);
        System system = emptySystem(1e-3);
        for (int i = 0; i < 5; ++i)
            addParticle(system, {0.1 * i, 0.0, 0.0}, mass);
        for (int i = 0; i + 1 < 5 && stiffness > 0.0; ++i)
            addSpring(system, i, i + 1, 0.1, stiffness, 0.01);
        finish(system);
        State state = system.start;
        state.hands.pull = pullAt(system.key[2], {0.2, 0.01, 0.0}, 1e9);
        state.hands.pull->damping = damping;
        state = run(system, state, 4000);
        for (const PaddedVec3& place : state.position)
            QVERIFY2(place.norm() < 1.0, told(place.norm(), 0.0));
    }

    // A hand that pulls at what is not there, or has let go, leaves no trace.
    void nothingToPull()
    {
        const System system = oneParticle(0.1, 1e-3, Integrator::SemiImplicitEuler);
        State state = system.start;
        state.hands.pull = pullAt(system.key[0] + 17, {5.0, 0.0, 0.0}, 10.0);
        state = run(system, state, 50);
        QCOMPARE(Vec3(state.position[0]), Vec3(0.1, 0.0, 0.0));
        state.hands.pull = pullAt(system.key[0], {5.0, 0.0, 0.0}, 10.0);
        state = run(system, state, 50);
        state.hands.pull.reset();
        const Vec3 speed = state.velocity[0];
        QVERIFY(speed.x() > 0.0);
        state = run(system, state, 50);
        QCOMPARE(Vec3(state.velocity[0]), speed);
    }

    // A pin by hand holds a particle where it is; when it is pulled out, the particle falls from
    // rest.
    void pins()
    {
        System free = heavySystem(1e-3);
        free.key = {Key(40), Key(41)};
        addParticle(free, Vec3::Zero(), 0.1);
        addParticle(free, {1.0, 0.0, 0.0}, 0.1);
        finish(free);
        Simulation simulation(shared(std::move(free)));
        QVERIFY(simulation.runUntil(0.1));
        const Vec3 place = positionOf(simulation, 40);
        QVERIFY(place.y() < -0.04);
        HandCommands told;
        told.hands.pins = {40};
        simulation.handle(told);
        QVERIFY(simulation.runUntil(0.2));
        QCOMPARE(positionOf(simulation, 40), place);
        QVERIFY(positionOf(simulation, 41).y() < -0.15);
        QCOMPARE(simulation.frame()->layout->pinned, (std::vector<std::uint8_t>{1, 0}));
        QCOMPARE(simulation.frame()->handPins, told.hands.pins);
        told.hands.pins.clear();
        simulation.handle(told);
        QVERIFY(simulation.runUntil(0.3));
        const double fall = place.y() - 0.5 * standardGravity * 0.01;
        QVERIFY2(isNear(positionOf(simulation, 40).y(), fall, 1e-3),
                 told2(positionOf(simulation, 40).y(), fall));
    }

    // A fan head on pushes a panel in the middle of its nozzle with 1/2 rho Ca A U^2; where the jet
    // has become twice as wide, its speed is half of that and its force a quarter.
    void fans_data()
    {
        QTest::addColumn<double>("away"); // m, from the nozzle
        QTest::addColumn<double>("share");
        QTest::newRow("at the nozzle") << 0.0 << 1.0;
        QTest::newRow("twice as wide") << 2.0 << 0.25;
        QTest::newRow("behind it") << -0.1 << 0.0;
    }
    void fans()
    {
        QFETCH(double, away);
        QFETCH(double, share);
        System system = emptySystem(1e-3);
        system.airDensity = 1.2;
        const double side = 1e-3; // m, small in the jet
        addParticle(system, {0.0, -side / 3.0, -side / 3.0}, 1.0);
        addParticle(system, {0.0, 2.0 * side / 3.0, -side / 3.0}, 1.0);
        addParticle(system, {0.0, -side / 3.0, 2.0 * side / 3.0}, 1.0);
        addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0);
        finish(system);
        State state = system.start;
        Airflow fan;
        fan.kind = WindKind::Jet;
        fan.origin = {-away, 0.0, 0.0};
        fan.velocity = {8.0, 0.0, 0.0};
        fan.radius = 0.4;
        fan.widening = 0.2;
        state.hands.fan = fan;
        const double area = 0.5 * side * side;
        const double expected = share * 0.5 * 1.2 * 2.0 * area * 64.0;
        const Vec3 load = panelLoads(system, state)[0];
        QVERIFY2(isNear(load, Vec3(expected, 0.0, 0.0), 1e-12 + 1e-9 * expected),
                 told(load, Vec3(expected, 0.0, 0.0)));
        // this load is what moves the panel
        state = run(system, state, 1);
        const double speed = expected / 3.0 * 1e-3;
        QVERIFY(isNear(state.velocity[0], Vec3(speed, 0.0, 0.0), 1e-12 + 1e-9 * speed));
    }

    // A collider that is carried arrives where it is told, pushes what is in its way and lets
    // nothing through, however fast the hand is.
    void carries()
    {
        System system = emptySystem(1.0 / 240.0);
        system.substeps = 4;
        Obstacle ball{ColliderShape::Sphere,
                      {-1.0, 0.0, 0.0},
                      Vec3::UnitY(),
                      0.2,
                      Response::Contact,
                      0.0,
                      0.0};
        ball.key = 9;
        system.obstacles = {ball};
        addParticle(system, Vec3::Zero(), 0.01);
        finish(system);
        Simulation simulation(shared(std::move(system)));
        HandCommands told;
        told.hands.carries = {{9, {2.0, 0.0, 0.0}}}; // straight through the particle, at once
        simulation.handle(told);
        QVERIFY(simulation.runUntil(1.0));
        const std::shared_ptr<const Frame> frame = simulation.frame();
        QVERIFY(isNear(frame->colliderPosition[0], Vec3(1.0, 0.0, 0.0), 1e-6));
        QVERIFY2(frame->position[0].x() > 1.2 - 1e-9, told2(frame->position[0].x(), 1.2));
        QVERIFY(frame->velocity[0].norm() <= 10.0 + 1e-9);
        // a new run has it back at its place
        auto again = std::make_shared<System>(simulation.system());
        ++again->run;
        again->start.carried.clear();
        simulation.load(std::move(again));
        QVERIFY(isNear(simulation.frame()->colliderPosition[0], Vec3(-1.0, 0.0, 0.0), 0.0));
    }

    // All that hands can do, on a cloth: the same bits at any number of threads, from a checkpoint,
    // and by a track that is written and read.
    void sameBits()
    {
        const Scene scene = cloth();
        const auto system = compile(scene);
        QVERIFY(system);
        Simulation first(*system);
        HandCommands told;
        const auto act = [&](Simulation& simulation, int step) {
            const auto& key = simulation.system().key;
            if (step == 10) {
                told.hands.pull = pullAt(0, {0.3, 0.2, 0.4}, 60.0);
                told.hands.pull->grip = {{key[30], key[31], key[44]}, {0.3, 0.3, 0.4}};
            }
            if (step > 10 && step < 60 && told.hands.pull)
                told.hands.pull->to += Vec3(0.002, 0.004, -0.001);
            if (step == 25) {
                Airflow fan;
                fan.kind = WindKind::Jet;
                fan.origin = {0.0, 0.0, 3.0};
                fan.velocity = {0.0, 0.0, -9.0};
                told.hands.fan = fan;
            }
            if (step == 40)
                told.hands.pins.push_back(key[30]);
            if (step == 60)
                told.hands.pull.reset();
            if (step == 70)
                ++told.halts;
            if (step == 80) {
                told.hands.fan.reset();
                told.hands.pins.clear();
            }
            simulation.handle(told);
        };
        std::optional<State> checkpoint;
        for (int step = 0; step < 120; ++step) {
            act(first, step);
            if (step == 45)
                checkpoint = first.state();
            QVERIFY(first.step());
        }
        const std::uint64_t hash = stateHash(first.state());

        const QTemporaryDir folder;
        const std::string file = folder.filePath("hands.csv").toStdString();
        QVERIFY(!writeControlTrack(scene, trackOf(*first.frame()), file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        for (const int threads : {1, 2, 3, 8}) {
            Simulation again(*system, threads);
            ControlPlayer hands(*track);
            for (int step = 0; step < 120; ++step) {
                hands.giveTo(again);
                QVERIFY(again.step());
            }
            QCOMPARE(stateHash(again.state()), hash);
        }

        told = {};
        for (int step = 0; step < 45; ++step) { // orders that were given up to there
            Simulation nobody(*system);
            act(nobody, step);
        }
        Simulation later(*system, *checkpoint);
        for (int step = 45; step < 120; ++step) {
            act(later, step);
            QVERIFY(later.step());
        }
        QCOMPARE(stateHash(later.state()), hash);
    }

    // An edit while something is held leaves it in the hand.
    void survivesEdits()
    {
        const Scene scene = cloth();
        LiveSystem live(scene);
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        HandCommands told;
        const Key key = simulation.system().key[60];
        told.hands.pull = pullAt(key, positionOf(simulation, key) + Vec3(0.0, 0.5, 0.0), 40.0);
        told.hands.pins = {simulation.system().key[20]};
        simulation.handle(told);
        QVERIFY(simulation.runUntil(0.1));
        // a particle with a smaller number goes: all others change their places
        live.apply(removal(live.scene(), {Id{simulation.system().key[5]}}));
        simulation.load(std::get<Update>(live.update(2, 1)));
        const auto held = simulation.frame()->held;
        QVERIFY(held);
        QVERIFY(isNear(held->point, positionOf(simulation, key), 0.0));
        const Vec3 pinned = positionOf(simulation, told.hands.pins[0]);
        QVERIFY(simulation.runUntil(0.2));
        QVERIFY(isNear(positionOf(simulation, told.hands.pins[0]), pinned, 0.0));
    }

private:
    static const char* told2(double got, double expected) { return ripstop::told(got, expected); }
};

const RegisteredTest registered("test_hands", runPlain<TestHands>);

} // namespace ripstop::test_hands
#include "test_hands.moc"
