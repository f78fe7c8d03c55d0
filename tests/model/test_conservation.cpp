// What no choice of frame, mirror or units may change (validation C1, C2, C5 to C7; C9 is in
// test_determinism.cpp).
#include "model/systems.h"

#include "measure/diagnostics.h"

#include <Eigen/Geometry>

#include <QtTest>

using namespace ripstop;

namespace {

enum class Ties { Springs, Rods };

// A patch of 5 x 5 particles, 0.1 m apart and a little bent, with fabric on it, in a light wind:
// smooth enough for trajectories to be compared after a second.
System patch(Integrator integrator, Solver solver, Ties ties, bool pinned)
{
    System system = emptySystem(1.0 / 500.0, integrator);
    system.solver = solver;
    system.sweeps = 12;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.wind = {0.5, 0.2, 0.8};
    const int side = 5;
    const auto at = [&](int i, int j) { return j * side + i; };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const Vec3 place(0.1 * i, -0.1 * j, 0.02 * std::sin(0.9 * i) * std::cos(0.7 * j));
            if (pinned && j == 0 && (i == 0 || i == side - 1))
                addPin(system, place, 0.02);
            else
                addParticle(system, place, 0.02 + 0.001 * i, {0.02 * j, 0.0, 0.03 * i});
        }
    const auto tie = [&](int a, int b) {
        const double length = distance(system, a, b);
        if (ties == Ties::Rods)
            addRod(system, a, b, length);
        else
            addSpring(system, a, b, length, 60.0, 0.05);
    };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            if (i + 1 < side)
                tie(at(i, j), at(i + 1, j));
            if (j + 1 < side)
                tie(at(i, j), at(i, j + 1));
            if (i + 1 < side && j + 1 < side) {
                tie(at(i, j), at(i + 1, j + 1));
                addPanel(system, at(i, j), at(i, j + 1), at(i + 1, j + 1), AirLaw::LinearNormal,
                         1.5, 0.02);
                addPanel(system, at(i, j), at(i + 1, j + 1), at(i + 1, j), AirLaw::Paper, 1.5,
                         0.02);
            }
        }
    return system;
}

double largestGap(const State& a, const State& b, auto map)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.position.size(); ++i)
        most = std::max(most, (map(a.position[i]) - b.position[i]).norm());
    return most;
}

Vec3 angularMomentum(const System& system, const State& state)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state.position.size(); ++i)
        sum += system.mass[i] * state.position[i].cross(state.velocity[i]);
    return sum;
}

} // namespace

Q_DECLARE_METATYPE(Ties)

class TestConservation : public QObject
{
    Q_OBJECT

    static void everyWay(const char* what, bool explicitEuler)
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<Ties>("ties");
        for (const Integrator integrator :
             {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler, Integrator::Verlet,
              Integrator::VelocityVerlet}) {
            if (integrator == Integrator::ExplicitEuler && !explicitEuler)
                continue;
            const auto name = choiceNames<Integrator>[std::size_t(integrator)];
            QTest::addRow("%s, %s, springs", what, name.data())
                << integrator << Solver::AveragedJacobi << Ties::Springs;
            for (const Solver solver :
                 {Solver::AveragedJacobi, Solver::GaussSeidel, Solver::Direct})
                QTest::addRow("%s, %s, rods by %s", what, name.data(),
                              choiceNames<Solver>[std::size_t(solver)].data())
                    << integrator << solver << Ties::Rods;
        }
    }

private slots:
    // Forces of springs and dampers on a random network, read from one explicit step of a second:
    // they and their moments cancel, to 1e-12 of their sum.
    void internalForces_data()
    {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("damping");
        QTest::newRow("C1 springs") << 50.0 << 0.0;
        QTest::newRow("C1 dampers") << 0.0 << 3.0;
        QTest::newRow("C1 both") << 50.0 << 3.0;
    }
    void internalForces()
    {
        QFETCH(double, stiffness);
        QFETCH(double, damping);
        Dice dice(1);
        System system = emptySystem(1.0, Integrator::ExplicitEuler);
        for (int i = 0; i < 60; ++i) {
            const Vec3 place = dice.vector(1.0);
            const Vec3 velocity = dice.vector(1.0);
            addParticle(system, place, dice(0.5, 2.0), velocity);
        }
        for (int i = 0; i < 200; ++i) {
            const int a = dice.below(60);
            const int b = (a + 1 + dice.below(59)) % 60;
            addSpring(system, a, b, 0.7, stiffness, damping);
        }
        finish(system);
        const State after = run(system, 1);
        Vec3 force = Vec3::Zero();
        Vec3 moment = Vec3::Zero();
        double sum = 0.0;
        for (std::size_t i = 0; i < 60; ++i) {
            const Vec3 f = system.mass[i] * (after.velocity[i] - system.start.velocity[i]);
            force += f;
            moment += system.start.position[i].cross(f);
            sum += f.norm();
        }
        QVERIFY(sum > 100.0);
        QVERIFY2(force.norm() < 1e-12 * sum, told(force.norm() / sum, 0.0));
        QVERIFY2(moment.norm() < 1e-12 * sum, told(moment.norm() / sum, 0.0));
    }

    // In vacuum without gravity a free object keeps its momentum to 1e-12, and with springs, which
    // pull along the line between their ends, its angular momentum to 1e-9. Explicit Euler moves
    // x by the old velocity, so x and F are no longer parallel to one line: it is left out.
    void freeObject_data() { everyWay("C2 free in vacuum", false); }
    void freeObject()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(Ties, ties);
        System system = patch(integrator, solver, ties, false);
        system.gravity.setZero();
        system.airDensity = 0.0;
        finish(system);
        const State after = run(system, 500);
        const Vec3 p = momentum(system, system.start);
        QVERIFY2(isNear(momentum(system, after), p, 1e-12 * std::max(1.0, p.norm())),
                 told(momentum(system, after), p));
        const Vec3 centre =
            centerOfMass(system, system.start.position) + after.time * p / totalMass(system);
        QVERIFY2(isNear(centerOfMass(system, after.position), centre, 1e-12),
                 told(centerOfMass(system, after.position), centre));
        if (ties == Ties::Springs) {
            // Verlet keeps the moment of x(n) - x(n-1), which is what it remembers.
            State seen = after;
            if (integrator == Integrator::Verlet)
                seen.velocity = after.drift;
            const Vec3 l = angularMomentum(system, system.start);
            QVERIFY2(isNear(angularMomentum(system, seen), l, 1e-9),
                     told(angularMomentum(system, seen), l));
        }
    }

    void moved_data() { everyWay("C5 translated", true); }
    void moved()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(Ties, ties);
        const Vec3 shift(1e3, -2e3, 5e2);
        System here = patch(integrator, solver, ties, true);
        System there = here;
        for (Vec3& x : there.start.position)
            x += shift;
        finish(here);
        finish(there);
        const double gap = largestGap(run(here, 500), run(there, 500),
                                      [&](const Vec3& x) { return Vec3(x + shift); });
        QVERIFY2(gap < 1e-7, told(gap, 0.0));
    }

    void turned_data() { everyWay("C5 rotated", true); }
    void turned()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(Ties, ties);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
        System here = patch(integrator, solver, ties, true);
        System there = here;
        for (auto* vectors : {&there.start.position, &there.start.velocity})
            for (Vec3& x : *vectors)
                x = turn * x;
        there.gravity = turn * here.gravity;
        there.wind = turn * here.wind;
        finish(here);
        finish(there);
        const double gap = largestGap(run(here, 500), run(there, 500),
                                      [&](const Vec3& x) { return Vec3(turn * x); });
        QVERIFY2(gap < 1e-7, told(gap, 0.0));
    }

    // The same motion on a moving train: V added to every velocity and to the wind.
    void boosted_data() { everyWay("C6 boosted", true); }
    void boosted()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(Ties, ties);
        // a walk, so that rounding errors far from the origin stay below the tolerance
        const Vec3 boost(0.7, -0.3, 1.1);
        System here = patch(integrator, solver, ties, false);
        System there = here;
        for (Vec3& v : there.start.velocity)
            v += boost;
        there.wind += boost;
        finish(here);
        finish(there);
        const State a = run(here, 500);
        const State b = run(there, 500);
        const double gap =
            largestGap(a, b, [&](const Vec3& x) { return Vec3(x + a.time * boost); });
        QVERIFY2(gap < 1e-9, told(gap, 0.0));
    }

    // x mirrored: so is the result, although every panel now winds the other way.
    void mirrored_data() { everyWay("C7 mirrored", true); }
    void mirrored()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(Ties, ties);
        const auto mirror = [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); };
        System here = patch(integrator, solver, ties, true);
        System there = here;
        for (auto* vectors : {&there.start.position, &there.start.velocity})
            for (Vec3& x : *vectors)
                x = mirror(x);
        there.wind = mirror(here.wind);
        finish(here);
        finish(there);
        const double gap = largestGap(run(here, 500), run(there, 500), mirror);
        QVERIFY2(gap < 1e-12, told(gap, 0.0));
    }

    // Winding says nothing: the other order of corners gives the same motion.
    void winding()
    {
        System here = patch(Integrator::SemiImplicitEuler, Solver::GaussSeidel, Ties::Rods, true);
        System there = here;
        for (FabricPanel& panel : there.panels)
            std::swap(panel.corner[1], panel.corner[2]);
        finish(here);
        finish(there);
        const double gap =
            largestGap(run(here, 500), run(there, 500), [](const Vec3& x) { return x; });
        QVERIFY2(gap < 1e-9, told(gap, 0.0));
    }
};

QTEST_APPLESS_MAIN(TestConservation)
#include "test_conservation.moc"
