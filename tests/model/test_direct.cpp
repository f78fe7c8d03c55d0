// The direct rod solver alone: heavy loads on light lines, frames, and what it costs in energy.
//
// Stages: a heavy load on a light line and its tensions; what one implicit step does to a whirl
// and a pendulum; free frames, single rods, one-sided rods, rods without length and a jumble; then
// bits, changes in place, and that a step allocates nothing.
#include "assembly/finish.h"
#include "model/heavy_line.h"
#include "registered_test.h"

#include "measure/diagnostics.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <new>
#include <numbers>

static std::atomic<long> allocations = 0;

void* operator new(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    ++allocations;
    const auto a = std::size_t(alignment);
    if (void* memory = std::aligned_alloc(a, (size + a - 1) / a * a))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace ripstop::test_direct {

namespace {

double largestStrain(const System& system, const State& state)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < system.rods.size(); ++i) {
        const Rod& rod = system.rods[i];
        const double length =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm();
        const double strain = length / rod.restLength - 1.0;
        if (rod.resists != Resists::Tension || strain > 0.0)
            worst = std::max(worst, std::abs(strain));
    }
    return worst;
}

// Six corners of an octahedron of 1 m, every one tied to every other: 15 rods where 12 would do.
System bracedOctahedron()
{
    System system = directSystem(0.01, 4);
    system.gravity.setZero();
    const Vec3 spin(1.0, 5.0, -2.0); // rad/s
    for (const Vec3& corner : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                               Vec3(0, 0, 1), Vec3(0, 0, -1)})
        addParticle(system, corner, 0.1 + 0.05 * double(system.mass.size()),
                    Vec3(1.0, 2.0, 3.0) + spin.cross(corner));
    for (int a = 0; a < 6; ++a)
        for (int b = a + 1; b < 6; ++b)
            addRod(system, a, b, distance(system, a, b));
    finish(system);
    return system;
}

// Whatever a scene may hold: pins, lines, struts, soft rods, a rod of no length, coincident ends,
// springs, masses from 1 g to 10 kg, rods that contradict each other, rods that tear.
System jumble(std::uint32_t seed)
{
    System system = directSystem(1.0 / 240.0, 2);
    Dice dice(seed);
    system.viscosity = 0.1;
    for (int i = 0; i < 60; ++i) {
        const Vec3 place = dice.vector(1.0);
        if (i % 13 == 0)
            addPin(system, place);
        else
            addParticle(system, i % 17 == 1 ? system.start.position.back() : place,
                        std::pow(10.0, dice(-3.0, 1.0)), dice.vector(3.0));
    }
    for (int k = 0; k < 130; ++k) {
        const int a = dice.below(60);
        const int b = (a + 1 + dice.below(58)) % 60;
        const double length = distance(system, a, b) * dice(0.95, 1.05);
        Rod& rod = addRod(system, a, b, k % 29 == 0 ? 0.0 : length, k % 7 == 0 ? 1e-4 : 0.0);
        rod.resists = std::array{Resists::Both, Resists::Tension, Resists::Compression}[k % 3];
        if (k % 11 == 0)
            rod.tear = {TearRule::Force, 2000.0};
    }
    for (int k = 0; k < 20; ++k) {
        const int a = dice.below(60);
        const int b = (a + 1 + dice.below(58)) % 60;
        addSpring(system, a, b, distance(system, a, b), 0.5, 0.001);
    }
    finish(system);
    return system;
}

} // namespace

class TestDirect : public QObject
{
    Q_OBJECT

private slots:
    // 65 kg swing from 45 degrees on 100 particles of 1 g: no rod is ever 0.1 % too long or short,
    // and it falls as a pendulum of its length does: from 45 degrees a quarter of the period
    // 2 pi sqrt(L / g) 1.0400 (complete elliptic integral) takes it to the lowest point.
    void heavyLoadOnLightLine()
    {
        System system = heavyLine(65.0, Vec3(std::sqrt(0.5), -std::sqrt(0.5), 0.0));
        finish(system);
        const double quarter = 0.5 * std::numbers::pi * std::sqrt(10.0 / standardGravity) * 1.0400;
        Stepper stepper;
        State state = system.start;
        double lowest = 0.0;
        for (int i = 0; i < 300; ++i) {
            const double before = state.position.back().x();
            stepper.step(system, state);
            const double strain = largestStrain(system, state);
            QVERIFY2(strain < 1e-3, told(strain, 0.0));
            const double after = state.position.back().x();
            if (before > 0.0 && after <= 0.0 && lowest == 0.0)
                lowest = state.time - 0.01 * after / (after - before);
        }
        QVERIFY2(isNear(lowest, quarter, 0.01 * quarter), told(lowest, quarter));
    }

    // A real line (LTC80: 0.57 g/m, EA 18.2 kN) at 300 N lies still, however finely it is cut:
    // links of a tenth of a millimetre are 10^10 times as stiff as their masses in a step.
    void fineLinesAreAsStiffAsTheyAre_data()
    {
        QTest::addColumn<double>("link"); // m
        for (const double link : {1e-2, 1e-3, 1e-4})
            QTest::addRow("%g m", link) << link;
    }

    void fineLinesAreAsStiffAsTheyAre()
    {
        QFETCH(double, link);
        constexpr double pull = 300.0, stiffness = 18181.8, density = 0.57e-3;
        System system = emptySystem(1.0 / 240.0, Integrator::Bdf2);
        system.solver = Solver::Direct;
        const int segments = 4;
        addPin(system, Vec3::Zero());
        for (int i = 1; i <= segments; ++i) {
            const Vec3 place(link * i, 0.0, 0.0);
            const int end =
                i < segments ? addParticle(system, place, density * link) : addPin(system, place);
            const double rest = link / (1.0 + pull / stiffness);
            addRod(system, i - 1, end, rest, rest / stiffness).dampingTime = 0.77e-3;
        }
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 240; ++i) {
            stepper.step(system, state);
            QVERIFY2(stepper.accuracy().pulls < 1e-6, told(stepper.accuracy().pulls, 0.0));
            for (const double tension : tensions(system, state))
                QVERIFY2(isNear(tension, pull, 1e-6 * pull), told(tension, pull));
        }
    }

    // At rest each rod carries the weight below it, and does so without a flicker.
    void tensionsOfHang_data()
    {
        QTest::addColumn<double>("load"); // kg
        QTest::addColumn<Resists>("resists");
        QTest::newRow("65 kg on rods") << 65.0 << Resists::Both;
        QTest::newRow("65 kg on lines") << 65.0 << Resists::Tension;
        QTest::newRow("no load") << 0.001 << Resists::Both;
    }
    void tensionsOfHang()
    {
        QFETCH(double, load);
        QFETCH(Resists, resists);
        System system = heavyLine(load, Vec3(0.0, -1.0, 0.0));
        for (Rod& rod : system.rods)
            rod.resists = resists;
        system.viscosity = 5.0;
        finish(system);
        State state = run(system, 1000);
        Stepper stepper;
        for (int step = 0; step < 20; ++step) {
            stepper.step(system, state);
            for (std::size_t i = 0; i < system.rods.size(); ++i) {
                const int below = 100 - std::max(system.rods[i].a, system.rods[i].b);
                const double expected = (load + 0.001 * below) * standardGravity;
                QVERIFY2(isNear(state.rodTension[i], expected, 1e-5 * expected),
                         told(state.rodTension[i], expected));
            }
        }
    }

    // A mass on a rod without weight: each step goes on straight and comes back along the rod, so
    // the angle of a step shrinks from q to atan(sin q / (2 - cos q)) = q - q^3, or 1 / w^2 grows
    // by 2 h per second.
    void whirl()
    {
        System system = directSystem(0.01, 4);
        system.gravity.setZero();
        const double speed = 4.0; // rad/s
        addPin(system, Vec3::Zero());
        addParticle(system, {2.0, 0.0, 0.0}, 3.0, {0.0, 2.0 * speed, 0.0});
        addRod(system, 0, 1, 2.0);
        finish(system);
        const double time = 5.0;
        const State state = run(system, 500);
        const double got = state.velocity[1].norm() / 2.0;
        const double h = 0.0025;
        const double expected = 1.0 / std::sqrt(1.0 / (speed * speed) + 2.0 * h * time);
        QVERIFY2(isNear(got, expected, 2e-3 * expected), told(got, expected));
    }

    // Small swings: what holds the mass pulls along the rod of the end of the step, which makes it
    // implicit Euler. Its energy falls like exp(-W^2 h t), W^2 = g / L, its period is 2 pi / W
    // (1 + W^2 h^2 / 3).
    void pendulum()
    {
        System system = directSystem(0.01, 4);
        const double h = 0.0025;
        const double angle = 0.03;
        addPin(system, Vec3::Zero());
        addParticle(system, {std::sin(angle), -std::cos(angle), 0.0}, 2.0);
        addRod(system, 0, 1, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        std::vector<double> crossings; // s, downwards through the middle
        while (crossings.size() < 6) {
            const double before = state.position[1].x();
            stepper.step(system, state);
            const double after = state.position[1].x();
            if (before > 0.0 && after <= 0.0)
                crossings.push_back(state.time - 0.01 * after / (after - before));
        }
        const double rate = std::sqrt(standardGravity);
        const double period = (crossings.back() - crossings.front()) / 5.0;
        const double expected = 2.0 * std::numbers::pi / rate * (1.0 + rate * rate * h * h / 3.0);
        QVERIFY2(isNear(period, expected, 1e-3 * expected), told(period, expected));

        const auto energy = [&](const State& s) {
            return 0.5 * s.velocity[1].squaredNorm() + standardGravity * (s.position[1].y() + 1.0);
        };
        const double left = energy(state) / energy(system.start);
        const double damped = std::exp(-rate * rate * h * state.time);
        QVERIFY2(isNear(left, damped, 0.02 * damped), told(left, damped));
    }

    // Nothing from outside: momentum stays, and so does the shape, turn after turn. A free spin
    // loses what the whirl above loses.
    void freeFrame()
    {
        const System system = bracedOctahedron();
        const Vec3 before = momentum(system, system.start);
        const Vec3 center = centerOfMass(system, system.start.position);
        const State state = run(system, 1000);
        const double size = before.norm();
        QVERIFY2(isNear(momentum(system, state), before, 1e-11 * size),
                 told(momentum(system, state), before));
        const Vec3 way = 10.0 * before / totalMass(system);
        QVERIFY2(isNear(centerOfMass(system, state.position), center + way, 1e-9),
                 told(centerOfMass(system, state.position), Vec3(center + way)));
        QVERIFY2(largestStrain(system, state) < 1e-4, told(largestStrain(system, state), 0.0));
    }

    // A rod without compliance gives way by 1e-4 under ten times the weight of all: of a stretch
    // that it is to take away it leaves the share s / (s + w), s = 1e-4 L / (100 m) at h = 1.
    void oneRod()
    {
        System system = emptySystem(1.0);
        system.solver = Solver::Direct;
        const double s = 0.2;
        addParticle(system, {0.0, 0.0, 0.0}, 1.0);
        addParticle(system, {1.0 + s, 0.0, 0.0}, 3.0);
        addRod(system, 0, 1, 1.0);
        finish(system);
        const State state = run(system, 1);
        const double softness = 1e-4 / (100.0 * 4.0);
        const double share = (4.0 / 3.0) / (4.0 / 3.0 + softness);
        QVERIFY2(isNear(state.position[0].x(), 0.75 * s * share, 1e-9),
                 told(state.position[0].x(), 0.75 * s * share));
        QVERIFY2(isNear(state.position[1].x(), 1.0 + s - 0.25 * s * share, 1e-9),
                 told(state.position[1].x(), 1.0 + s - 0.25 * s * share));
        QVERIFY2(isNear(state.rodTension[0], s / (4.0 / 3.0) * share, 1e-9),
                 told(state.rodTension[0], s / (4.0 / 3.0) * share));
    }

    void oneWay_data()
    {
        QTest::addColumn<Resists>("resists");
        QTest::addColumn<double>("length"); // m, rest length is 1
        QTest::addColumn<bool>("acts");
        QTest::newRow("long line") << Resists::Tension << 1.2 << true;
        QTest::newRow("short line") << Resists::Tension << 0.8 << false;
        QTest::newRow("long strut") << Resists::Compression << 1.2 << false;
        QTest::newRow("short strut") << Resists::Compression << 0.8 << true;
    }
    void oneWay()
    {
        QFETCH(Resists, resists);
        QFETCH(double, length);
        QFETCH(bool, acts);
        System system = emptySystem(0.01);
        system.solver = Solver::Direct;
        addParticle(system, Vec3::Zero(), 1.0);
        addParticle(system, {length, 0.0, 0.0}, 1.0);
        addRod(system, 0, 1, 1.0).resists = resists;
        finish(system);
        const State state = run(system, 1);
        const double got = (state.position[1] - state.position[0]).norm();
        const double expected = acts ? 1.0 : length;
        QVERIFY2(isNear(got, expected, acts ? 1e-4 : 0.0), told(got, expected));
        QCOMPARE(state.rodTension[0] != 0.0, acts);
    }

    // A rod of no length holds two particles together, from coincidence too.
    void noLength()
    {
        System system = directSystem(0.01, 4);
        system.viscosity = 2.0;
        addPin(system, Vec3::Zero());
        addParticle(system, Vec3::Zero(), 1.0);
        addParticle(system, Vec3::Zero(), 2.0);
        addRod(system, 0, 1, 0.0);
        addRod(system, 1, 2, 0.0);
        finish(system);
        const State state = run(system, 500);
        QVERIFY2(state.position[2].norm() < 1e-4, told(state.position[2].norm(), 0.0));
        const double weight = 3.0 * standardGravity;
        QVERIFY2(isNear(state.rodTension[0], weight, 1e-3 * weight),
                 told(state.rodTension[0], weight));
    }

    void jumbleHolds_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 12; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }

    // Nothing blows up, whatever comes: rods that contradict each other throw particles about in
    // the first steps, and from then on energy can only be lost.
    void jumbleHolds()
    {
        QFETCH(int, seed);
        const System system = jumble(std::uint32_t(seed));
        Stepper stepper;
        State state = system.start;
        double most = 0.0; // J
        for (int i = 0; i < 1200; ++i) {
            stepper.step(system, state);
            for (const Vec3& x : state.position)
                QVERIFY(x.allFinite());
            const double energy = energies(system, state).total();
            if (i < 10)
                most = std::max(most, energy);
            QVERIFY2(energy <= most, told(energy, most));
        }
    }

    // The same bits in every run and at every number of threads, and on from a checkpoint.
    void sameBits()
    {
        const System system = jumble(3);
        const State once = run(system, 200);
        QVERIFY(stateHash(once) != stateHash(system.start));
        for (const int threads : {1, 2, 3, 8})
            QCOMPARE(stateHash(run(system, 200, threads)), stateHash(once));
        QCOMPARE(stateHash(run(system, run(system, 77), 123)), stateHash(once));
    }

    // Numbers that change in place are read again, pins too: as if prepared anew.
    void changedInPlace()
    {
        System system = heavyLine(65.0, Vec3(std::sqrt(0.5), -std::sqrt(0.5), 0.0));
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 10; ++i)
            stepper.step(system, state);
        for (const bool pinned : {false, true}) {
            system.mass[50] = 3.0;
            system.inverseMass[50] = pinned ? 0.0 : 1.0 / 3.0;
            system.rods[7].compliance = 1e-5;
            system.rods[9].restLength = 0.11;
            touchAll(system);
            const State expected = run(system, state, 10);
            for (int i = 0; i < 10; ++i)
                stepper.step(system, state);
            QCOMPARE(stateHash(state), stateHash(expected));
        }
    }

    void noHeap()
    {
        const System system = jumble(4);
        Stepper stepper;
        State state = system.start;
        state.tears.reserve(system.tearableRods.size());
        stepper.step(system, state);
        const long before = allocations;
        for (int i = 0; i < 20; ++i)
            stepper.step(system, state);
        QCOMPARE(allocations - before, 0L);
    }
};

const RegisteredTest registered("test_direct", runPlain<TestDirect>);

} // namespace ripstop::test_direct
#include "test_direct.moc"
