// Panels that carry the pull of a fabric, through the whole program: what is conserved, what a cut
// of the mesh changes, how they fly by default, and what is said of scenes that cannot be.
#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "constraints/elastic_panels.h"
#include "constraints/multigrid.h"
#include "derived/flat_panel.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "system/membrane.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace ripstop::test_elastic_panels {

namespace {

ThreadPool alone(1);

// Kite cloth of 1 m x 1 m that panels carry, as the builder makes it; of an E t of 40 kN/m.
Scene sheet(int cells, double hang, double wind = 0.0)
{
    return *build(*findBuilder("cloth"), {{"columns", cells},
                                          {"rows", cells},
                                          {"panels", 1},
                                          {"membrane", 40e3},
                                          {"shear", 0.03},
                                          {"density", 0.047},
                                          {"damping", 30.8}, // N s/m: 0.77 ms of damping time
                                          {"hang", hang},
                                          {"flat", 0},
                                          {"sphere", 0},
                                          {"wind", wind}});
}

Part& partOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

Material& materialOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Material* material = std::get_if<Material>(&entry.item))
            return *material;
    std::abort();
}

double lowest(const State& state)
{
    double y = state.position[0].y();
    for (const Vec3& place : state.position)
        y = std::min(y, place.y());
    return y;
}

} // namespace

class TestElasticPanels : public QObject
{
    Q_OBJECT

private slots:
    void laysFlat()
    {
        Panel panel;
        const Vec3 a(0.0, 1.0, 0.0), b(3.0, 1.0, 0.0), c(0.0, 1.0, 4.0);
        layFlat(panel, a, b, c, Vec3(0.0, 0.0, 2.0));
        QVERIFY(isNear(panel.grain, 90.0, 1e-12));
        QVERIFY(isNear(panel.restBC, 5.0, 1e-12));
        const auto flat = flatPanel(panel, Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
        QVERIFY(flat.has_value());
        QVERIFY(isNear(flat->area(), 6.0, 1e-12));
        QVERIFY(isNear(flat->ac.x(), 4.0, 1e-12) && isNear(flat->ac.y(), 0.0, 1e-12));
        panel.restBC = 8.0; // longer than the two others
        QVERIFY(!flatPanel(panel, a, b, c));
    }

    // A block is the derivative of the energy, and of its derivative, where the tension that was
    // foreseen is that of the law.
    void blocksAreDerivatives()
    {
        const auto system = *compile(sheet(1, 2));
        std::mt19937 random(5);
        const auto number = [&] { return (double(random()) / 4294967296.0 - 0.5) * 0.2; };
        std::vector<std::uint32_t> row{0, 1, 2, 3};
        for (int trial = 0; trial < 50; ++trial) {
            std::vector<PaddedVec3> place = system->start.position;
            for (PaddedVec3& p : place)
                p += Vec3(number(), number(), number());
            ElasticPanels panels;
            panels.prepare(*system, row);
            const std::vector<std::uint8_t> gone(system->panels.size(), 0);
            const auto energyAt = [&](int p, const Vec3& way) {
                std::vector<Row> rows;
                for (int i = 0; i < 4; ++i) {
                    const Vec3 x = place[std::size_t(i)] + (i == p ? way : Vec3(Vec3::Zero()));
                    rows.push_back({{x.x(), x.y(), x.z(), 0.0}});
                }
                ThreadPool pool(1);
                panels.start(*system, gone, {place, {}, 1.0, 1e9},
                             pool); // damping counts for nothing
                return panels.measure(rows, pool) / 1e18;
            };
            const double scale = energyAt(-1, Vec3::Zero());
            std::array<Vec3, 4> pull{};
            for (Vec3& each : pull)
                each.setZero();
            for (std::size_t i = 0; i < panels.panels().size(); ++i) {
                TripleBlock block;
                panels.fillBlock(i, block);
                for (std::size_t k = 0; k < 3; ++k)
                    pull[panels.panels()[i].row[k]] +=
                        Vec3(block.pull[k].v[0], block.pull[k].v[1], block.pull[k].v[2]) / 1e18;
            }
            for (int p = 0; p < 4; ++p)
                for (int c = 0; c < 3; ++c) {
                    constexpr double step = 1e-6;
                    const double slope =
                        0.5
                        * (energyAt(p, step * Vec3::Unit(c)) - energyAt(p, -step * Vec3::Unit(c)))
                        / (2.0 * step);
                    QVERIFY2(isNear(pull[std::size_t(p)][c], -slope, 1e-5 * (scale + 1.0)),
                             told(pull[std::size_t(p)][c], -slope));
                }
        }
    }

    // Blocks of pairs that are not symmetric: coarser levels and cycles against a dense solve.
    void coarserLevelsTakeAnyBlocks()
    {
        constexpr int side = 30;
        const auto at = [](int i, int k) { return i * side + k; };
        std::vector<std::pair<int, int>> pairs;
        std::vector<Row> place;
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                place.push_back({{double(i), double(k), 0.0, 0.0}});
                if (k + 1 < side)
                    pairs.emplace_back(at(i, k + 1), at(i, k)); // the higher node first, too
                if (i + 1 < side)
                    pairs.emplace_back(at(i, k), at(i + 1, k));
            }
        Multigrid grid;
        grid.analyze(side * side, pairs, {}, place, false);
        QVERIFY(grid.levels() > 1);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * side * side, 3 * side * side);
        grid.setZero(alone);
        std::mt19937 random(3);
        const auto number = [&] { return double(random()) / 4294967296.0 - 0.5; };
        const auto add = [&](Multigrid::Block& block, const Mat3& value) {
            for (int c = 0; c < 3; ++c)
                for (int r = 0; r < 3; ++r)
                    block.column[c][r] += value(r, c);
        };
        // J^T J of a coupling q = A x_i - B x_j is positive for any A and B.
        for (std::size_t n = 0; n < pairs.size(); ++n) {
            const auto [i, j] = std::minmax(pairs[n].first, pairs[n].second);
            Mat3 a = Mat3::Identity(), b = Mat3::Identity();
            for (int k = 0; k < 9; ++k) {
                a(k) += 0.3 * number();
                b(k) += 0.3 * number();
            }
            add(grid.diagonal(std::size_t(i)), a.transpose() * a);
            add(grid.diagonal(std::size_t(j)), b.transpose() * b);
            add(grid.pair(n), -a.transpose() * b);
            dense.block<3, 3>(3 * i, 3 * i) += a.transpose() * a;
            dense.block<3, 3>(3 * j, 3 * j) += b.transpose() * b;
            dense.block<3, 3>(3 * i, 3 * j) -= a.transpose() * b;
            dense.block<3, 3>(3 * j, 3 * i) -= b.transpose() * a;
        }
        for (int i = 0; i < side * side; ++i) {
            add(grid.diagonal(std::size_t(i)), 1e-3 * Mat3::Identity());
            dense.block<3, 3>(3 * i, 3 * i) += 1e-3 * Mat3::Identity();
        }
        Eigen::VectorXd right(3 * side * side);
        std::vector<Row> x(side * side);
        for (int i = 0; i < 3 * side * side; ++i)
            x[std::size_t(i / 3)].v[i % 3] = right[i] = number();
        const Eigen::VectorXd wanted = dense.ldlt().solve(right);
        QVERIFY(grid.factorize(alone));
        (void)grid.solve(
            x, 1e-9, 200, [](std::span<Row>) {}, alone);
        QVERIFY2(grid.iterations() < 60, told(grid.iterations(), 60));
        double worst = 0.0;
        for (int i = 0; i < 3 * side * side; ++i)
            worst = std::max(worst, std::abs(x[std::size_t(i / 3)].v[i % 3] - wanted[i]));
        QVERIFY2(worst < 1e-5 * wanted.cwiseAbs().maxCoeff(), told(worst, 0.0));
    }

    // Nothing holds the sheet: its momentum and its moment of momentum stay.
    void keepsMomentum()
    {
        Scene scene = sheet(6, 2);
        scene.settings.gravity = Vec3::Zero();
        scene.settings.airDensity = 0.0;
        for (Particle& particle : partOf(scene).particles)
            particle.velocity = Vec3(0.3, 0.1, 0.0) + Vec3(0.5, 0.0, 3.0).cross(particle.position)
                                + Vec3(0.0, 0.0, std::sin(7.0 * particle.position.x()));
        Simulation simulation(*compile(scene));
        const auto turning = [&] {
            const State& state = simulation.state();
            Vec3 sum = Vec3::Zero();
            for (std::size_t i = 0; i < state.position.size(); ++i)
                sum += simulation.system().mass[i] * state.position[i].cross(state.velocity[i]);
            return sum;
        };
        const Vec3 before = momentum(simulation.system(), simulation.state());
        const Vec3 turningBefore = turning();
        const double energy = energies(simulation.system(), simulation.state()).total();
        QVERIFY(simulation.runUntil(1.0));
        QVERIFY((momentum(simulation.system(), simulation.state()) - before).norm()
                < 1e-6 * before.norm());
        QVERIFY2((turning() - turningBefore).norm() < 0.01 * turningBefore.norm(),
                 told(turning(), turningBefore));
        const double after = energies(simulation.system(), simulation.state()).total();
        QVERIFY2(after <= energy * (1.0 + 1e-6), told(after, energy)); // damped, never driven
    }

    // A sheet that hangs by its edge and swings calms down, whichever way it is cut.
    void fliesByDefault_data()
    {
        QTest::addColumn<int>("cells");
        QTest::addColumn<double>("wind");
        QTest::newRow("8 x 8, hanging") << 8 << 0.0;
        QTest::newRow("8 x 8, as a flag") << 8 << 8.0;
        QTest::newRow("24 x 24, as a flag") << 24 << 8.0;
    }

    void fliesByDefault()
    {
        QFETCH(int, cells);
        QFETCH(double, wind);
        Scene scene = sheet(cells, wind > 0.0 ? 1 : 0, wind);
        const auto system = *compile(scene);
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(2.0));
        for (const Vec3& place : simulation.state().position)
            QVERIFY(place.allFinite());
        double most = 0.0; // strain
        for (const Membrane& membrane : system->membranes) {
            const ClothTension now = tensionIn(
                *system, membrane, cornersOf(*system, membrane, simulation.state().position));
            most = std::max(most, largestTension(now.tension) / 40e3);
        }
        QVERIFY2(most < 0.02, told(most, 0.02));
        QVERIFY(kineticEnergy(*system, simulation.state()) < 5.0);
    }

    void sameBitsAtAnyThreadCount()
    {
        const auto system = *compile(sheet(24, 1, 8.0));
        std::uint64_t hash = 0;
        for (const int threads : {1, 2}) {
            Simulation simulation(system, threads);
            QVERIFY(simulation.runUntil(0.2));
            const std::uint64_t now = stateHash(simulation.state());
            QVERIFY(hash == 0 || hash == now);
            hash = now;
        }
    }

    // Nothing of the run is left in the solver.
    void goesOnFromACheckpoint()
    {
        const auto system = *compile(sheet(12, 1, 8.0));
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(0.5));
        Simulation other(system, simulation.state());
        QVERIFY(simulation.runUntil(0.8));
        QVERIFY(other.runUntil(0.8));
        QCOMPARE(stateHash(other.state()), stateHash(simulation.state()));
    }

    // Solvers that sweep rods solve panels together all the same.
    void anySolverHoldsThem_data()
    {
        QTest::addColumn<Solver>("solver");
        for (std::size_t s = 0; s < choiceNames<Solver>.size(); ++s)
            QTest::newRow(choiceNames<Solver>[s].data()) << Solver(s);
    }

    void anySolverHoldsThem()
    {
        QFETCH(Solver, solver);
        Scene scene = sheet(8, 0);
        scene.settings.solver = solver;
        scene.settings.airDensity = 0.0;
        scene.settings.viscosity = 5.0;
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(2.0));
        scene.settings.solver = Solver::Auto;
        Simulation other(*compile(scene));
        QVERIFY(other.runUntil(2.0));
        const double got = lowest(simulation.state()), expected = lowest(other.state());
        QVERIFY2(isNear(got, expected, 2e-3), told(got, expected));
    }

    // Made ten times softer in flight and stiff again: it stretches and comes back, and nothing
    // flies off.
    void stiffnessMayChangeInFlight()
    {
        Scene scene = sheet(8, 0);
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(1.0));
        materialOf(scene).membraneStiffness = 400.0;
        simulation.load(*compile(scene));
        QVERIFY(simulation.runUntil(2.0));
        simulation.load(*compile(sheet(8, 0)));
        QVERIFY(simulation.runUntil(3.0));
        const double energy = kineticEnergy(simulation.system(), simulation.state());
        QVERIFY2(std::sqrt(2.0 * energy / 0.047) < 5.0, told(energy, 0.0)); // m/s
    }

    void saysWhatCannotBe()
    {
        const auto said = [](const Scene& scene) {
            std::string all;
            for (const Finding& finding : problemsOf(scene, 10))
                all += finding.message.english() + "\n";
            return all;
        };
        Scene scene = sheet(2, 0);
        QVERIFY(said(scene).find("panel") == std::string::npos);

        Scene thin = scene;
        partOf(thin).panels[1].restAB = 100.0;
        QVERIFY(said(thin).find("has no area at rest") != std::string::npos);
        QVERIFY(!compile(thin));

        Scene limp = scene;
        materialOf(limp).membraneStiffness.reset();
        QVERIFY(said(limp).find("has no membrane stiffness") != std::string::npos);
        QVERIFY(bool(compile(limp)));
        Simulation falls(*compile(limp));
        QVERIFY(falls.runUntil(0.1));

        Scene brittle = scene;
        materialOf(brittle).tearRule = TearRule::Force;
        QVERIFY(said(brittle).find("do not tear") != std::string::npos);

        Scene odd = scene;
        materialOf(odd).poissonRatio = 0.9;
        materialOf(odd).weftStiffness = 80e3;
        QVERIFY(said(odd).find("Poisson") != std::string::npos);
        QVERIFY(!compile(odd));
    }

    // Numbers that are far from any cloth: the run goes on or ends with a sentence.
    void extremes_data()
    {
        QTest::addColumn<double>("stiffness");
        for (const double stiffness : {1e-6, 1.0, 1e9, 1e30})
            QTest::addRow("%g N/m", stiffness) << stiffness;
    }

    void extremes()
    {
        QFETCH(double, stiffness);
        Scene scene = sheet(6, 0);
        materialOf(scene).membraneStiffness = stiffness;
        materialOf(scene).shearStiffness = 0.03 * stiffness;
        const auto system = compile(scene);
        QCOMPARE(bool(system), stiffness < 1e10);
        if (!system)
            return;
        Simulation simulation(*system);
        (void)simulation.runUntil(0.5);
        for (const Vec3& place : simulation.state().position)
            QVERIFY(place.allFinite());
    }
};

const RegisteredTest registered("test_elastic_panels", runPlain<TestElasticPanels>);

} // namespace ripstop::test_elastic_panels
#include "test_elastic_panels.moc"
