// The work of air, hands, dampers and contact, and what the solver makes of energy, where theory
// knows the numbers.
//
// Stages: one account after another on a system that only it concerns (dampers, gravity, hands,
// air, bounces, tears); then that reading disturbs nothing, and that frames keep the ledger.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"
#include "recording/run_chunk.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_energy_ledger {

namespace {

constexpr double g = standardGravity;

// What a flight of so many seconds leaves in the ledger of a system.
struct Outcome
{
    Work work;
    double change = 0.0; // J, of the energy
    State state;
};

Outcome fly(System& system, double seconds, const HandCommands& hands = {})
{
    askForLedger(system);
    finish(system);
    Simulation simulation(std::make_shared<const System>(system));
    simulation.handle(hands);
    simulation.runUntil(seconds);
    if (const auto& trouble = simulation.trouble())
        qFatal("%s", trouble->message.english().c_str());
    const State& state = simulation.state();
    return {state.work, energies(system, state).total() - energies(system, system.start).total(),
            state};
}

// Every joule of the change of energy has a name.
void compareBalance(const Outcome& out)
{
    const Work& w = out.work;
    const double named = w.air + w.hands + w.damping + w.contact + w.tearing + w.residual;
    QVERIFY2(isNear(named, out.change, 1e-9 * (1.0 + std::abs(out.change))),
             told(named, out.change));
}

} // namespace

class TestEnergyLedger : public QObject
{
    Q_OBJECT

    static void integrators()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("semi-implicit Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("Verlet") << Integrator::Verlet;
        QTest::newRow("velocity Verlet") << Integrator::VelocityVerlet;
    }

private slots:
    // A weight that circles a pin, without weight: all that changes is the solver's doing. Who goes
    // straight on for h at the speed v and is put back on the circle of radius L has the speed
    // v (1 - (v h / L)^2) to the third order, as the chord leaves the next tangent by half of the
    // angle; that takes m h v^4 / L^2 of power.
    void circlesAlone_data() { integrators(); }
    void circlesAlone()
    {
        QFETCH(Integrator, integrator);
        const double h = 1e-3, mass = 2.0, length = 0.8;
        System system = emptySystem(h, integrator);
        addPin(system, Vec3::Zero());
        addParticle(system, {length, 0.0, 0.0}, mass, {0.0, 4.0, 0.0});
        addRod(system, 0, 1, length);
        askForLedger(system);
        finish(system);
        Simulation simulation(std::make_shared<const System>(system));
        double taken = 0.0;
        while (simulation.state().time < 2.0 && simulation.step()) {
            const double speed = simulation.state().velocity[1].norm();
            taken += h * mass * h * std::pow(speed, 4) / (length * length);
        }
        const Work& work = simulation.state().work;
        QVERIFY2(isNear(work.residual, -taken, 0.01 * taken), told(work.residual, -taken));
        QCOMPARE(work.air, 0.0);
        QCOMPARE(work.hands, 0.0);
        QCOMPARE(work.damping, 0.0);
        QCOMPARE(work.contact, 0.0);
        QCOMPARE(work.tearing, 0.0);
    }

    // v = v0 exp(-c t) loses m v0^2 / 2 (1 - exp(-2 c t)).
    void viscosityTakes_data() { integrators(); }
    void viscosityTakes()
    {
        QFETCH(Integrator, integrator);
        System system = emptySystem(1e-3, integrator);
        system.viscosity = 0.5;
        addParticle(system, Vec3::Zero(), 2.0, {10.0, 0.0, 0.0});
        const Outcome out = fly(system, 1.0);
        const double expected = -100.0 * (1.0 - std::exp(-1.0));
        QVERIFY2(isNear(out.work.damping, expected, 1e-3 * 100.0),
                 told(out.work.damping, expected));
        compareBalance(out);
        QVERIFY2(std::abs(out.work.residual) < 1e-3 * 100.0, told(out.work.residual, 0.0));
    }

    // A damped spring that has come to rest has lost k s^2 / 2, all of it to its damper.
    void damperTakes_data() { integrators(); }
    void damperTakes()
    {
        QFETCH(Integrator, integrator);
        const double stiffness = 100.0, stretch = 0.2;
        System system = emptySystem(1e-3, integrator);
        addPin(system, Vec3::Zero());
        addParticle(system, {1.0 + stretch, 0.0, 0.0}, 1.0);
        addSpring(system, 0, 1, 1.0, stiffness, 2.0);
        const Outcome out = fly(system, 12.0);
        const double expected = -0.5 * stiffness * stretch * stretch;
        QVERIFY2(isNear(out.work.damping, expected, 0.01 * 2.0), told(out.work.damping, expected));
        compareBalance(out);
        QVERIFY2(std::abs(out.work.residual) < 0.01 * 2.0, told(out.work.residual, 0.0));
    }

    // A pin that is lifted by 1 m lifts what hangs on it: m g of work for each metre, and c m v
    // more against viscosity. It starts and stops at once, with m v^2 / 2 to be lost each time: a
    // spring swings until viscosity has taken that, a rod that cannot stretch loses it in the jerk,
    // for which only the solver is to blame.
    void liftingTakesWork_data()
    {
        QTest::addColumn<bool>("onRod");
        QTest::newRow("in a spring") << false;
        QTest::newRow("in a rod") << true;
    }
    void liftingTakesWork()
    {
        QFETCH(bool, onRod);
        const double mass = 3.0, stiffness = 2000.0, speed = 0.5;
        System system = heavySystem(1e-3);
        system.viscosity = 2.0;
        addPin(system, Vec3::Zero());
        addParticle(system, {0.0, -1.0, 0.0}, mass);
        if (onRod)
            addRod(system, 0, 1, 1.0);
        else // at rest from the beginning
            addSpring(system, 0, 1, 1.0 - mass * g / stiffness, stiffness);
        system.inputs = {{Key(90), ControlKind::Move, {0.0, 1.0, 0.0}, 1.0, speed, speed, {0}}};
        const Outcome out = fly(system, 6.0);
        QVERIFY(isNear(out.state.position[1].y(), 0.0, 1e-3));
        compareBalance(out);
        const double lifts = mass * g;
        const double brakes = system.viscosity * mass * speed;
        const double jerks = mass * speed * speed;
        const Work& work = out.work;
        QVERIFY2(isNear(work.hands, lifts + brakes + jerks, 0.005 * lifts),
                 told(work.hands, lifts + brakes + jerks));
        const double damped = -brakes - (onRod ? 0.0 : jerks);
        QVERIFY2(isNear(work.damping, damped, 0.005 * lifts), told(work.damping, damped));
        const double lost = onRod ? -jerks : 0.0;
        QVERIFY2(isNear(work.residual, lost, 0.005 * lifts), told(work.residual, lost));
    }

    // A hand that holds a weight and does not move does no work in the end, whatever it did on the
    // way: it stretches by m g / k, so the weight loses (m g)^2 / k, half of it kept by the hand.
    void handHolds()
    {
        const double mass = 0.05, stiffness = 20.0;
        System system = heavySystem(1e-3);
        system.viscosity = 1.0;
        addParticle(system, Vec3::Zero(), mass);
        system.key = {Key(7)};
        HandCommands hands;
        HandPull pull;
        pull.grip.particle[0] = 7;
        pull.stiffness = stiffness;
        pull.damping = 0.0;
        hands.hands.pull = pull;
        const Outcome out = fly(system, 20.0, hands);
        const double kept = std::pow(mass * g, 2) / stiffness;
        QVERIFY2(isNear(out.work.hands, -0.5 * kept, 0.01 * kept),
                 told(out.work.hands, -0.5 * kept));
        QVERIFY2(isNear(out.work.damping, -0.5 * kept, 0.01 * kept),
                 told(out.work.damping, -0.5 * kept));
        compareBalance(out);
    }

    // A panel that sinks at its terminal speed v gives the air m g v.
    void airTakes_data() { integrators(); }
    void airTakes()
    {
        QFETCH(Integrator, integrator);
        System system = heavySystem(1e-3, integrator);
        const double mass = 0.3; // kg, of all three
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 2)})
            addParticle(system, place, mass / 3.0);
        addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0);
        const double terminal = std::sqrt(mass * g / (0.5 * system.airDensity * 2.0 * 2.0));
        for (PaddedVec3& velocity : system.start.velocity)
            velocity = Vec3(0.0, -terminal, 0.0);
        const Outcome out = fly(system, 4.0);
        const double expected = -mass * g * terminal * 4.0;
        QVERIFY2(isNear(out.work.air, expected, 1e-3 * std::abs(expected)),
                 told(out.work.air, expected));
        compareBalance(out);
        QVERIFY2(std::abs(out.work.residual) < 1e-3 * std::abs(expected),
                 told(out.work.residual, 0.0));
    }

    // A ball that falls by H and bounces with the restitution e loses m g H (1 - e^2), and nothing
    // while it lies.
    void bounceTakes()
    {
        const double mass = 2.0, height = 1.0, restitution = 0.5;
        System system = heavySystem(1e-4);
        addParticle(system, {0.0, height, 0.0}, mass);
        system.obstacles.push_back({ColliderShape::Plane, Vec3::Zero(), Vec3::UnitY(), 0.0,
                                    Response::Contact, restitution, 0.0});
        System again = system;
        const Outcome once = fly(system, 0.6); // it falls for 0.45 s and rises for 0.23 s
        const double expected = -mass * g * height * (1.0 - restitution * restitution);
        QVERIFY2(isNear(once.work.contact, expected, 0.01 * std::abs(expected)),
                 told(once.work.contact, expected));
        compareBalance(once);
        const Outcome lies = fly(again, 5.0);
        QVERIFY2(isNear(lies.work.contact, -mass * g * height, 0.01 * mass * g),
                 told(lies.work.contact, -mass * g * height));
        QVERIFY2(std::abs(lies.work.residual) < 0.01 * mass * g, told(lies.work.residual, 0.0));
    }

    // Two weights on a rope that slide until friction has stopped them lose all that they had by
    // it, with what a new scene gets.
    void frictionTakes()
    {
        const double mass = 1.0, speed = 3.0; // kg, m/s
        System system = heavySystem(1.0 / 240.0, Integrator::Auto);
        system.solver = Solver::Auto;
        for (const double x : {0.0, 0.1}) {
            addParticle(system, {x, 0.0, 0.0}, 0.5 * mass);
            system.start.velocity.back() = {speed, 0.0, 0.0};
        }
        addRod(system, 0, 1, 0.1, 1.0 / 20000.0);
        system.obstacles.push_back(
            {ColliderShape::Plane, Vec3::Zero(), Vec3::UnitY(), 0.0, Response::Contact, 0.0, 0.4});
        const Outcome out = fly(system, 2.0);
        const double had = 0.5 * mass * speed * speed;
        QVERIFY2(isNear(out.work.contact, -had, 0.01 * had), told(out.work.contact, -had));
        compareBalance(out);
        QVERIFY2(std::abs(out.work.residual) < 0.01 * had, told(out.work.residual, 0.0));
    }

    // A spring that tears at rest takes along what it held.
    void tearTakes()
    {
        System system = emptySystem(1e-3);
        addPin(system, Vec3::Zero());
        addParticle(system, {1.5, 0.0, 0.0}, 1.0);
        addSpring(system, 0, 1, 1.0, 10.0).tear = {TearRule::Strain, 0.3};
        const Outcome out = fly(system, 0.1);
        QCOMPARE(out.state.tears.size(), std::size_t(1));
        QVERIFY2(isNear(out.work.tearing, -0.5 * 10.0 * 0.25, 1e-3), told(out.work.tearing, -1.25));
        compareBalance(out);
        QVERIFY2(std::abs(out.work.residual) < 1e-3, told(out.work.residual, 0.0));
    }

    // Reading the ledger changes nothing of the flight.
    void doesNotDisturb()
    {
        const auto towed = [](bool asked) {
            System system = heavySystem(1.0 / 240.0);
            system.wind = {5.0, 1.0, 0.0};
            addPin(system, Vec3::Zero());
            for (const Vec3& place : {Vec3(2, 0, 0), Vec3(3, 0, 0.5), Vec3(3, 0, -0.5)})
                addParticle(system, place, 0.01);
            addRod(system, 0, 1, 2.0);
            for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}, {1, 3}})
                addRod(system, a, b, distance(system, a, b), 1e-5);
            addPanel(system, 1, 2, 3, AirLaw::LinearNormal, 2.0);
            if (asked)
                askForLedger(system);
            finish(system);
            Simulation simulation(std::make_shared<const System>(system));
            simulation.runUntil(2.0);
            return stateHash(simulation.state());
        };
        QCOMPARE(towed(true), towed(false));
    }

    // Kept frames have the ledger; those of a file that was written before there was one have
    // zeros.
    void isRecorded()
    {
        RunChunk chunk;
        State state;
        state.position.resize(1);
        state.velocity.resize(1);
        state.work.air = 1.5;
        chunk.start = std::make_shared<const State>(state);
        for (int step = 1; step <= 2; ++step) {
            state.step = step;
            state.work.residual = -0.25 * step;
            chunk.frames.push_back(std::make_shared<const KeptFrame>(kept(state, chunk)));
        }
        const std::string bytes = bytesOf(chunk);
        const auto read = chunkOf(bytes);
        QVERIFY(read);
        QCOMPARE(read->start->work.air, 1.5);
        QCOMPARE(stateOf(*read, *read->frames[1]).work.residual, -0.5);

        // frames have no fields since version 4; a start has arrays of velocities and of ramps, and
        // since version 5 those of panels that wait and of ramps of laws and of cuts, since version
        // 6 of factors
        const std::size_t after = sizeof(std::uint64_t) + 2 * sizeof(std::uint64_t)
                                  + sizeof(std::uint64_t) + 3 * sizeof(std::uint64_t)
                                  + sizeof(std::uint64_t) + sizeof(std::uint64_t);
        const std::size_t ledger = sizeof(std::uint64_t) + 3 * sizeof(Work);
        const auto third = chunkOf(std::string_view(bytes).substr(0, bytes.size() - after));
        QVERIFY(third);
        QCOMPARE(third->start->work.air, 1.5);
        const auto old = chunkOf(std::string_view(bytes).substr(0, bytes.size() - after - ledger));
        QVERIFY(old);
        QCOMPARE(old->start->work, Work());
        QCOMPARE(old->frames[1]->step, std::int64_t(2));
        QVERIFY(!chunkOf(std::string_view(bytes).substr(0, bytes.size() - after - sizeof(Work))));
    }
};

const RegisteredTest registered("test_energy_ledger", runPlain<TestEnergyLedger>);

} // namespace ripstop::test_energy_ledger
#include "test_energy_ledger.moc"
