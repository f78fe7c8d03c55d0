// Pins that a control moves: they are as fast as they go, to dampers, to the air and to probes, and
// what the hand does that moves them is in the ledger.
#include "builders/network.h"
#include "model/probe_bench.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/finish.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_moved_pins {

namespace {

constexpr double g = standardGravity;

// Moves these particles at a speed, m/s, as far as the limit, m.
Control moving(std::vector<Id> targets, const Vec3& axis, double speed, double limit = 1000.0)
{
    Control control;
    control.targets = std::move(targets);
    control.axis = axis;
    control.limit = limit;
    control.rate = speed;
    control.automaticRate = speed;
    return control;
}

// A weight that is towed along x by a damped spring.
System towed(Integrator integrator, double h, double mass, double speed)
{
    System system = emptySystem(h, integrator);
    addPin(system, Vec3::Zero());
    addParticle(system, {-1.0, 0.0, 0.0}, mass);
    addSpring(system, 0, 1, 1.0, 1000.0, 50.0);
    system.inputs = {{Key(90), ControlKind::Move, Vec3::UnitX(), 100.0, speed, speed, {0}}};
    askForLedger(system);
    finish(system);
    return system;
}

// A plate and a line that are held across +x.
Bench plateAndLine()
{
    Part part;
    const auto pin = [&](unsigned id, const Vec3& place) {
        part.particles.push_back({.id = Id{id}, .position = place, .mass = 1.0, .pinned = true});
    };
    pin(10, {0.0, 50.0, 0.0});
    pin(11, {0.0, 51.0, 0.0});
    pin(12, {0.0, 50.0, 1.0});
    pin(13, {0.0, 50.0, 5.0});
    pin(14, {0.0, 52.0, 5.0});
    part.panels = {{Id{20}, Id{10}, Id{11}, Id{12}, Id{2}}};
    part.links = {
        {.id = Id{21}, .from = Id{13}, .to = Id{14}, .material = Id{3}, .restLength = 2.0}};
    Material line;
    line.diameter = 0.002;
    Bench bench;
    bench.scene.items = {{Id{1}, part}, {Id{2}, Material()}, {Id{3}, line}};
    Group plate;
    plate.members = {Id{20}};
    bench.scene.items.push_back({Id{4}, plate});
    bench.scene.nextId = Id{30};
    bench.add({.quantity = Quantity::AirForce, .target = Id{4}});
    bench.add({.quantity = Quantity::Airspeed, .target = Id{10}});
    bench.add({.quantity = Quantity::Drag, .target = Id{21}});
    bench.add({.quantity = Quantity::Airspeed, .target = Id{21}});
    return bench;
}

} // namespace

class TestMovedPins : public QObject
{
    Q_OBJECT

private slots:
    // A weight that is towed by a damped spring comes along at the speed v of the hand, which gives
    // it m v^2: one half to keep, the other one to the damper. The spring is at its own length
    // then, to where the pin goes in the next substep.
    void towsByADamper_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("semi-implicit Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("Verlet") << Integrator::Verlet;
        QTest::newRow("velocity Verlet") << Integrator::VelocityVerlet;
        QTest::newRow("BDF2") << Integrator::Bdf2;
    }

    void towsByADamper()
    {
        QFETCH(Integrator, integrator);
        const double h = 1e-3, mass = 2.0, speed = 0.5;
        Simulation simulation(std::make_shared<const System>(towed(integrator, h, mass, speed)));
        QVERIFY(simulation.runUntil(4.0));
        const State& state = simulation.state();
        QVERIFY(isNear(state.velocity[0], {speed, 0.0, 0.0}, 1e-9));
        QVERIFY2(isNear(state.velocity[1], {speed, 0.0, 0.0}, 1e-3 * speed),
                 told(state.velocity[1], {speed, 0.0, 0.0}));
        const double length = state.position[0].x() - state.position[1].x();
        const double seen = integrator == Integrator::Bdf2 ? 1.0 : 1.0 - speed * h;
        QVERIFY2(isNear(length, seen, 0.05 * speed * h), told(length, seen));
        const double given = mass * speed * speed;
        const Work& work = state.work;
        QVERIFY2(isNear(work.hands, given, 0.02 * given), told(work.hands, given));
        QVERIFY2(isNear(work.damping, -0.5 * given, 0.02 * given),
                 told(work.damping, -0.5 * given));
    }

    // The ledger of what goes on from a moment is that of the whole.
    void ledgerGoesOnAlike()
    {
        const auto shared = std::make_shared<const System>(towed(Integrator::Bdf2, 1e-3, 2.0, 0.5));
        Simulation whole(shared);
        QVERIFY(whole.runUntil(0.1));
        Simulation rest(shared, whole.state());
        QVERIFY(whole.runUntil(0.2) && rest.runUntil(0.2));
        QVERIFY(whole.state().work == rest.state().work);
    }

    // A pin that is let go while it moves flies on as it came.
    void fliesOnWhenLetGo_data() { towsByADamper_data(); }
    void fliesOnWhenLetGo()
    {
        QFETCH(Integrator, integrator);
        const double h = 1e-3, speed = 0.5;
        System system = emptySystem(h, integrator);
        addPin(system, Vec3::Zero());
        system.inputs = {{Key(90), ControlKind::Move, Vec3::UnitX(), 100.0, speed, speed, {0}}};
        System free = system;
        free.inverseMass[0] = 1.0;
        free.inputs[0].automaticRate = 0.0;
        finish(system);
        finish(free);
        const State held = run(system, system.start, 100);
        const State state = run(free, held, 100);
        QVERIFY2(isNear(state.velocity[0], {speed, 0.0, 0.0}, 1e-9),
                 told(state.velocity[0], {speed, 0.0, 0.0}));
        QVERIFY2(isNear(state.position[0], {200.0 * h * speed, 0.0, 0.0}, 1e-9),
                 told(state.position[0], {200.0 * h * speed, 0.0, 0.0}));
    }

    // What moves through still air is loaded as what stands in the wind.
    void meetsAirAsItMoves()
    {
        const double speed = 7.0;
        Bench moved = plateAndLine();
        moved.scene.items.push_back(
            {takeId(moved.scene),
             moving({Id{10}, Id{11}, Id{12}, Id{13}, Id{14}}, -Vec3::UnitX(), speed)});
        Bench blown = plateAndLine();
        Wind wind;
        wind.velocity = {speed, 0.0, 0.0};
        blown.scene.items.push_back({takeId(blown.scene), wind});
        const std::vector<double> inAir = moved.read(20), inWind = blown.read(20);
        for (std::size_t i = 0; i < inWind.size(); ++i) {
            QVERIFY(inWind[i] > 0.0);
            QVERIFY2(isNear(inAir[i], inWind[i], 1e-9 * inWind[i]), told(inAir[i], inWind[i]));
        }
        QVERIFY2(isNear(inAir[1], speed, 1e-9), told(inAir[1], speed));
    }

    // A hand that lifts a spar by its clamp to the height H gives its weights m g H, what they are
    // slowed by and m v^2, whatever the spar sags by: force is change of momentum.
    void liftsBySpar()
    {
        const double speed = 0.25, height = 1.0, mass = 0.05, drag = 4.0;
        Bench bench;
        Scene& scene = bench.scene;
        scene.settings.airDensity = 0.0;
        scene.settings.viscosity = drag; // 1/s
        Material spar;
        spar.axialStiffness = 1e5;   // N
        spar.flexuralRigidity = 0.5; // N m^2
        spar.dampingTime = 1e-3;
        const Id material = addItem(scene, spar);
        Network network(scene, "spar");
        std::vector<Id> nodes;
        for (int i = 0; i < 6; ++i) {
            nodes.push_back(network.particle({0.1 * i, 0.0, 0.0}, mass));
            if (i > 0)
                network.rod(nodes[std::size_t(i) - 1], nodes.back(), material);
        }
        for (const std::size_t clamped : {0u, 1u})
            network.row(nodes[clamped]).pinned = true;
        network.finish({}, {});
        addItem(scene, moving({nodes[0], nodes[1]}, Vec3::UnitY(), speed, height));
        bench.add({.quantity = Quantity::WorkOfHands});
        bench.add({.quantity = Quantity::EnergyResidual});
        const std::vector<double> read =
            bench.read(int(1.5 * height / speed / scene.settings.timeStep));
        const double masses = 4.0 * mass;
        const double given = masses * (g * height + speed * speed + drag * speed * height);
        QVERIFY2(isNear(read[0], given, 0.01 * given), told(read[0], given));
        QVERIFY2(isNear(read[1], 0.0, 0.01 * given), told(read[1], 0.0));
    }

    // Cloth that sticks out stiffly from its clamp weighs on it, by its bending.
    void clampHoldsCloth()
    {
        const double mass = 0.002;
        Bench bench;
        Scene& scene = bench.scene;
        scene.settings.airDensity = 0.0;
        scene.settings.viscosity = 10.0; // 1/s
        Material cloth;
        cloth.bendingStiffness = 0.1; // N m
        cloth.airLaw = AirLaw::None;
        const Id material = addItem(scene, cloth);
        Network network(scene, "cloth");
        constexpr int columns = 5;
        constexpr double cell = 0.02; // m
        std::vector<Id> nodes;
        const auto at = [&](int i, int j) { return nodes[std::size_t(j * columns + i)]; };
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < columns; ++i) {
                nodes.push_back(network.particle({cell * i, 0.0, cell * j}, mass));
                network.row(nodes.back()).pinned = i < 2;
            }
        for (int i = 0; i < columns; ++i) {
            network.rod(at(i, 0), at(i, 1), material);
            if (i + 1 == columns)
                break;
            network.rod(at(i, 0), at(i + 1, 0), material);
            network.rod(at(i, 1), at(i + 1, 1), material);
            network.rod(at(i, 0), at(i + 1, 1), material);
            network.panel(at(i, 0), at(i, 1), at(i + 1, 1), material);
            network.panel(at(i, 0), at(i + 1, 1), at(i + 1, 0), material);
        }
        network.finish({}, {});
        bench.add({.quantity = Quantity::Reaction});
        const double read = bench.read(int(4.0 / scene.settings.timeStep)).front();
        const double weight = 2.0 * columns * mass * g;
        QVERIFY2(isNear(read, weight, 0.005 * weight), told(read, weight));
    }
};

const RegisteredTest registered("test_moved_pins", runPlain<TestMovedPins>);

} // namespace ripstop::test_moved_pins
#include "test_moved_pins.moc"
