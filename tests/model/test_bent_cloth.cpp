// The law of bending at any shape: cloth that is crumpled, squeezed, sheared or collapsed.
//
// Stages: forces are the slope of the energy, without sum or torque; what deforms in its plane is
// not pulled, and what is shortened along its curvature at the same angles keeps its energy; at
// small turns the law is that of isometric bending; how panels are numbered does not matter; and
// the limit of the step, made for what is flat, holds at any shape.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "forces/bend_force.h"
#include "forces/force.h"
#include "forces/forces.h"
#include "laws/bend.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_bent_cloth {

namespace {

constexpr double stiffness = 0.2; // N m
constexpr double cell = 0.02;     // m

enum class Mesh { Alternating, OneWay, Equilateral };

// A sheet in the plane y = 0, 0.2 kg/m^2, with nothing but bending. With `mixed` every third panel
// is turned over.
System sheet(Mesh mesh, int columns, int rows, bool mixed = false)
{
    System system = emptySystem(1e-4);
    const double depth = cell * (mesh == Mesh::Equilateral ? std::sqrt(0.75) : 1.0);
    const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double shift = mesh == Mesh::Equilateral && j % 2 != 0 ? 0.5 : 0.0;
            addParticle(system, {(i + shift) * cell, 0.0, j * depth}, 0.0);
        }
    int count = 0;
    const auto add = [&](int a, int b, int c) {
        mixed&& count++ % 3 == 0 ? addPanel(system, b, a, c, AirLaw::None, 0.0)
                                 : addPanel(system, a, b, c, AirLaw::None, 0.0);
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
            const bool rising = mesh == Mesh::Alternating   ? (i + j) % 2 == 0
                                : mesh == Mesh::Equilateral ? j % 2 != 0
                                                            : true;
            add(a, b, rising ? d : c);
            add(rising ? a : b, d, c);
        }
    for (const FabricPanel& panel : system.panels)
        for (const int corner : panel.corner)
            system.mass[std::size_t(corner)] += 0.2 * cell * depth / 6.0;
    for (std::size_t p = 0; p < system.mass.size(); ++p)
        system.inverseMass[p] = 1.0 / system.mass[p];
    system.bending = {{stiffness, 0.0}};
    finish(system);
    return system;
}

// A spar of springs along x, built with a bend in it.
System spar()
{
    System system = emptySystem(1e-4);
    for (int i = 0; i < 6; ++i)
        addParticle(system, {i * cell, 0.2 * cell * (i > 2), 0.0}, 0.01);
    for (int i = 0; i < 5; ++i) {
        addSpring(system, i, i + 1, distance(system, i, i + 1), 1.0);
        system.links.push_back({Key(i), LinkKind::Spring, i, i, i + 1});
        system.linkStuff.push_back({1, 0, LinkRole::Line, 0.0});
    }
    system.materialAir = {MaterialAir(), MaterialAir()};
    system.materialAir[1].key = 1;
    system.bending = {Bending(), {0.0, 0.5}};
    finish(system);
    return system;
}

// N, of bending, on each particle.
std::vector<Vec3> forcesOf(const System& system, const State& state)
{
    const auto bending = BendLists::makeForce();
    ThreadPool alone(1);
    bending->prepare(system, state);
    std::vector<Vec3> force(state.position.size(), Vec3::Zero());
    addForces(bending->fill(system, state, alone), force);
    return force;
}

double largestOf(const std::vector<Vec3>& forces)
{
    double largest = 0.0;
    for (const Vec3& force : forces)
        largest = std::max(largest, force.norm());
    return largest;
}

State crumpled(const System& system, double size, int seed = 5)
{
    State state = system.start;
    Dice dice{std::uint32_t(seed)};
    for (PaddedVec3& x : state.position)
        x += dice.vector(size);
    return state;
}

State deformed(const System& system, const Mat3& by)
{
    State state = system.start;
    for (PaddedVec3& x : state.position)
        x = Vec3(by * Vec3(x));
    return state;
}

// Rolled up along x, `shortened` at the same angles; columns are as far apart as the chord is.
State rolled(const System& system, double anglePerCell, double shortened)
{
    State state = system.start;
    for (PaddedVec3& x : state.position) {
        const double turns = x.x() / cell;
        const double radius = 0.5 * shortened * cell / std::sin(0.5 * anglePerCell);
        const double angle = anglePerCell * turns;
        x = Vec3(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), x.z());
    }
    return state;
}

// The largest w^2 of the linear system there, over that which the step at its limit h is stable
// for, 4 / h^2.
double shareOfLimit(const System& system, State state)
{
    const auto n = Eigen::Index(state.position.size());
    Eigen::MatrixXd matrix(3 * n, 3 * n);
    constexpr double way = 1e-7; // m
    for (Eigen::Index column = 0; column < 3 * n; ++column) {
        double& x = state.position[std::size_t(column / 3)][column % 3];
        const double here = x;
        x = here + way;
        const std::vector<Vec3> there = forcesOf(system, state);
        x = here - way;
        const std::vector<Vec3> back = forcesOf(system, state);
        x = here;
        for (Eigen::Index row = 0; row < 3 * n; ++row) {
            const auto p = std::size_t(row / 3);
            matrix(row, column) =
                (back[p][row % 3] - there[p][row % 3]) / (2.0 * way)
                / std::sqrt(system.mass[p] * system.mass[std::size_t(column / 3)]);
        }
    }
    const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(symmetric, Eigen::EigenvaluesOnly);
    const double limit = stiffStepLimit(system);
    return solved.eigenvalues().maxCoeff() * limit * limit / 4.0;
}

void crumplings()
{
    QTest::addColumn<int>("what"); // a mesh, a mixed sheet, a spar
    QTest::addColumn<double>("size");
    for (int what = 0; what < 5; ++what)
        for (const double size : {0.05, 0.4, 2.0}) // of a cell; past 0.1 some are squeezed
            QTest::addRow("%d, by %g cells", what, size) << what << size;
}
System systemOf(int what)
{
    return what < 3    ? sheet(Mesh(what), 4, 4)
           : what == 3 ? sheet(Mesh::Alternating, 4, 4, true)
                       : spar();
}

} // namespace

class TestBentCloth : public QObject
{
    Q_OBJECT

private slots:
    void forcesAreTheSlope_data() { crumplings(); }
    void forcesAreTheSlope()
    {
        QFETCH(int, what);
        QFETCH(double, size);
        const System system = systemOf(what);
        State state = crumpled(system, size * cell);
        const std::vector<Vec3> forces = forcesOf(system, state);
        const double largest = largestOf(forces);
        QVERIFY(largest > 0.0);
        constexpr double way = 1e-8; // m
        for (std::size_t p = 0; p < forces.size(); ++p)
            for (int c = 0; c < 3; ++c) {
                const double here = state.position[p][c];
                state.position[p][c] = here + way;
                const double more = bendingEnergy(system, state);
                state.position[p][c] = here - way;
                const double less = bendingEnergy(system, state);
                state.position[p][c] = here;
                const double slope = (less - more) / (2.0 * way);
                QVERIFY2(isNear(forces[p][c], slope, 1e-5 * largest), told(forces[p][c], slope));
            }
    }

    // Action and reaction, also of what has collapsed into a line or into a point.
    void neitherSumNorTorque_data() { crumplings(); }
    void neitherSumNorTorque()
    {
        QFETCH(int, what);
        QFETCH(double, size);
        const System system = systemOf(what);
        const State loose = crumpled(system, size * cell);
        for (const Vec3& kept :
             {Vec3(1, 1, 1), Vec3(1, 1e-9, 1e-9), Vec3(0, 1, 0), Vec3(0, 0, 0)}) {
            State state = loose;
            for (PaddedVec3& x : state.position)
                x = Vec3(kept.cwiseProduct(Vec3(x)));
            const std::vector<Vec3> forces = forcesOf(system, state);
            Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
            double sizes = 0.0, torques = 0.0;
            for (std::size_t p = 0; p < forces.size(); ++p) {
                QVERIFY(forces[p].allFinite());
                sum += forces[p];
                torque += Vec3(state.position[p]).cross(forces[p]);
                sizes += forces[p].norm();
                torques += forces[p].norm() * state.position[p].norm();
            }
            QVERIFY2(sum.norm() <= 1e-12 * sizes, told(sum.norm(), sizes));
            QVERIFY2(torque.norm() <= 1e-12 * torques, told(torque.norm(), torques));
        }
    }

    // No force in the plane, whatever happens in it: corners go by a fifth of what would squeeze
    // some panel to 9/10 of a height.
    void whatIsFlatIsNotPulled()
    {
        for (const Mesh mesh : {Mesh::Alternating, Mesh::OneWay, Mesh::Equilateral}) {
            const System system = sheet(mesh, 5, 4);
            State state = crumpled(system, 0.03 * cell);
            const double bent = largestOf(forcesOf(system, state));
            for (PaddedVec3& x : state.position)
                x.y() = 0.0;
            QVERIFY(largestOf(forcesOf(system, state)) < 1e-12 * bent);
            for (PaddedVec3& x : state.position)
                x.z() *= 3.0; // stretched
            QVERIFY(largestOf(forcesOf(system, state)) < 1e-12 * bent);
        }
    }

    // A strip rolled up has flat cells; only its angles count. No corner is pulled along it.
    void shorteningKeepsTheEnergy()
    {
        for (const Mesh mesh : {Mesh::Alternating, Mesh::OneWay}) {
            const System system = sheet(mesh, 8, 3);
            const double angle = 0.2;
            // sides across turn by the angle, one panel of each cell has half of each: 2 x 7 x 3
            // panels of A = cell^2 / 2 with G = 2 sin(angle / 2) / cell
            const double curvature = 2.0 * std::sin(0.5 * angle) / cell;
            const double expected = 0.5 * stiffness * curvature * curvature * 21 * cell * cell;
            for (const double shortened : {1.2, 1.0, 0.95, 0.905}) {
                const State state = rolled(system, angle, shortened);
                const double energy = bendingEnergy(system, state);
                QVERIFY2(isNear(energy, expected, 1e-12 * expected), told(energy, expected));
            }
        }
    }

    // The slope of a hill of 0.001: (N_e - N) |e| = y n_e with the weights of isometric bending,
    // but for its square.
    void smallTurnsAreIsometric()
    {
        for (const Mesh mesh : {Mesh::Alternating, Mesh::OneWay, Mesh::Equilateral}) {
            const System system = sheet(mesh, 5, 4, true);
            State state = system.start;
            Dice dice(7);
            for (PaddedVec3& x : state.position)
                x.y() += dice(-1e-3, 1e-3) * cell;
            const std::vector<Bend>& bends = system.of<BendLists>().list;
            const auto turnOf = [&](const Bend& bend) {
                double turn = 0.0;
                for (std::size_t k = 0; k < 4; ++k)
                    turn += bend.weight[k] * state.position[std::size_t(bend.corner[k])].y();
                return turn;
            };
            double expected = 0.0;
            for (const Bend& bend : bends) {
                expected += 0.5 * bend.stiffness * turnOf(bend) * turnOf(bend);
                for (std::size_t k = 0; k < 4; ++k)
                    if (bend.beside[k] >= 0)
                        expected += 0.5 * bend.coupling[k] * turnOf(bend)
                                    * turnOf(bends[std::size_t(bend.beside[k])]);
            }
            const double energy = bendingEnergy(system, state);
            QVERIFY2(isNear(energy, expected, 1e-4 * expected), told(energy, expected));
        }
    }

    void sidesOfPanelsDoNotMatter()
    {
        const System one = sheet(Mesh::Alternating, 5, 4),
                     mixed = sheet(Mesh::Alternating, 5, 4, true);
        const State state = crumpled(one, 0.3 * cell);
        const std::vector<Vec3> expected = forcesOf(one, state), got = forcesOf(mixed, state);
        for (std::size_t p = 0; p < got.size(); ++p)
            QVERIFY(isNear(got[p], expected[p], 1e-12 * largestOf(expected)));
    }

    // 1 or more would not be stable at the limit. Where edges are as heavy as the rest nothing is
    // to spare for what is squeezed both ways (laws/bend.h).
    void stepLimitHoldsAtAnyShape()
    {
        for (const Mesh mesh : {Mesh::Alternating, Mesh::OneWay, Mesh::Equilateral})
            for (const bool heavyEdges : {false, true}) {
                System system = sheet(mesh, 6, 5);
                if (heavyEdges) {
                    std::ranges::fill(system.mass, std::ranges::max(system.mass));
                    std::ranges::fill(system.inverseMass, 1.0 / system.mass.front());
                }
                const auto holds = [&](const State& state) {
                    const double share = shareOfLimit(system, state);
                    QVERIFY2(share < 1.0, told(share, 1.0));
                };
                holds(system.start);
                for (const double squeezed : {0.95, 0.905, 0.7, 0.4}) {
                    holds(deformed(system, Vec3(squeezed, 1, 1).asDiagonal()));
                    holds(deformed(system, Vec3(1, 1, squeezed).asDiagonal()));
                    if (!heavyEdges)
                        holds(deformed(system, Vec3(squeezed, 1, squeezed).asDiagonal()));
                }
                for (const double angle : {0.4, 1.0, 1.6})
                    holds(rolled(system, angle, 1.0));
                for (int seed = 1; seed < 5; ++seed)
                    for (const double size : {0.1, 0.3, 1.0})
                        holds(crumpled(system, size * cell, seed));
            }
    }
};

const RegisteredTest registered("test_bent_cloth", runPlain<TestBentCloth>);

} // namespace ripstop::test_bent_cloth
#include "test_bent_cloth.moc"
