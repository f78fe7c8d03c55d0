// Bending of fabric and of spars; the deflections that theory knows are in verify (M6, M-EI).
//
// Stages: which sides of panels bend and which do not; rest shapes and energies in closed form;
// the limit on the time step and energy over many steps; then tears and spars, scenes without
// bending, edits of a running scene, threads and substeps.
#include "assembly/finish.h"
#include "builders/builder.h"
#include "builders/network.h"
#include "check/check.h"
#include "check/step_check.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "compile/patch.h"
#include "forces/bend_force.h"
#include "forces/forces.h"
#include "laws/bend.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop::test_bending {

namespace {

constexpr double stiffness = 0.2; // N m

// A sheet of square cells of `cell` m in the plane y = 0, its diagonals one way or alternating.
BendingNet sheet(int columns, int rows, double cell, bool alternating = true)
{
    BendingNet net;
    const auto at = [&](int i, int j) { return i * (rows + 1) + j; };
    const Bending bending{stiffness, 0.0};
    for (int i = 0; i <= columns; ++i)
        for (int j = 0; j <= rows; ++j) {
            net.position.push_back({i * cell, 0.0, j * cell});
            net.pinned.push_back(0);
        }
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
            const bool rising = !alternating || (i + j) % 2 == 0;
            net.panels.push_back({{a, b, rising ? d : c}, bending});
            net.panels.push_back({{rising ? a : b, d, c}, bending});
        }
    return net;
}

Vec3 turnOf(const Bend& bend, const std::vector<Vec3>& x)
{
    Vec3 turn = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k)
        turn += bend.weight[k] * x[std::size_t(bend.corner[k])];
    return turn;
}

double energyOf(const std::vector<Bend>& bends, const std::vector<Vec3>& x)
{
    double energy = 0.0;
    for (const Bend& bend : bends) {
        const Vec3 turn = turnOf(bend, x);
        energy += 0.5 * bend.stiffness * turn.squaredNorm();
        for (std::size_t k = 0; k < 4; ++k)
            if (bend.beside[k] >= 0)
                energy += 0.5 * bend.coupling[k]
                          * turn.dot(turnOf(bends[std::size_t(bend.beside[k])], x));
    }
    return energy;
}

// Loose, of springs, 0.2 kg/m^2.
System looseSheet(int columns, int rows)
{
    const double cell = 0.02;
    System system = emptySystem(1.0);
    const BendingNet net = sheet(columns, rows, cell);
    for (const Vec3& x : net.position)
        addParticle(system, x, 0.2 * cell * cell);
    for (const BendingNet::Panel& panel : net.panels) {
        const auto [a, b, c] = panel.corner;
        addPanel(system, a, b, c, AirLaw::None, 0.0);
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            addSpring(system, from, to, distance(system, from, to), 500.0);
    }
    system.bending = {{stiffness, 0.0}};
    return system;
}

void crumple(State& state, double size, double speed)
{
    Dice dice(5);
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        state.position[i] += dice.vector(size);
        state.velocity[i] += dice.vector(speed);
    }
}

bool isFinite(const State& state)
{
    return std::all_of(state.position.begin(), state.position.end(),
                       [](const PaddedVec3& x) { return x.allFinite() && x.norm() < 1e6; });
}

// Links between neighbours of a row of places, all of one material with EI = 1 N m^2.
void addSpar(BendingNet& net, const std::vector<int>& particles)
{
    for (std::size_t i = 1; i < particles.size(); ++i) {
        const int a = particles[i - 1], b = particles[i];
        const double length = (net.position[std::size_t(a)] - net.position[std::size_t(b)]).norm();
        net.links.push_back({a, b, length, 1, {0.0, 1.0}});
    }
}

int addPlace(BendingNet& net, const Vec3& place)
{
    net.position.push_back(place);
    net.pinned.push_back(0);
    return int(net.position.size()) - 1;
}

template <typename T>
Id idNamed(const Scene& scene, std::string_view name)
{
    for (const Entry& entry : scene.items)
        if (const T* item = std::get_if<T>(&entry.item); item && item->name == name)
            return entry.id;
    std::abort();
}

template <typename T>
T& itemNamed(Scene& scene, std::string_view name)
{
    return std::get<T>(*findItem(scene, idNamed<T>(scene, name)));
}

} // namespace

class TestBending : public QObject
{
    Q_OBJECT

private slots:
    // sides inside: columns (rows - 1) + rows (columns - 1) + a diagonal in each cell
    void everySideInsideBends()
    {
        const auto bends = bendsOf(sheet(5, 3, 0.1));
        QCOMPARE(int(bends.size()), 5 * 2 + 3 * 4 + 15);
        for (const Bend& bend : bends) {
            double sum = 0.0;
            for (const double w : bend.weight)
                sum += w;
            QVERIFY(std::abs(sum) < 1e-12);
        }
    }

    void whatHasNoTwoStiffPanelsDoesNotBend()
    {
        BendingNet net = sheet(1, 1, 0.1);
        QCOMPARE(int(bendsOf(net).size()), 1);
        net.panels[0].bending = {}; // limp
        QVERIFY(bendsOf(net).empty());
        net = sheet(1, 1, 0.1);
        net.position.push_back({0.1, 0.1, 0.0});
        net.pinned.push_back(0);
        net.panels.push_back({{0, 3, 4}, net.panels[0].bending}); // the third on the diagonal
        QVERIFY(bendsOf(net).empty());
        net = sheet(1, 1, 0.1);
        net.pinned.assign(4, 1);
        QVERIFY(bendsOf(net).empty());
        net = sheet(1, 1, 0.1);
        for (Vec3& x : net.position)
            x.z() = 0.0; // no area
        QVERIFY(bendsOf(net).empty());
    }

    // flat, turned, stretched and sheared sheets have no turns
    void flatIsFlat()
    {
        const BendingNet net = sheet(4, 4, 0.1);
        const auto bends = bendsOf(net);
        Eigen::Matrix3d skew;
        skew << 1.1, 0.3, 0.2, -0.4, 0.9, 0.5, 0.1, 0.7, 1.3;
        std::vector<Vec3> x;
        for (const Vec3& place : net.position)
            x.push_back(skew * place + Vec3(3.0, -2.0, 1.0));
        for (const Bend& bend : bends)
            QVERIFY(turnOf(bend, x).norm() < 1e-12);
    }

    // E = B k^2 / 2 for each area; half a cell at either end has no curvature
    void energyOfACylinder_data()
    {
        QTest::addColumn<bool>("alternating");
        QTest::newRow("alternating") << true;
        QTest::newRow("one way") << false;
    }
    void energyOfACylinder()
    {
        QFETCH(bool, alternating);
        const double cell = 0.02;
        const BendingNet net = sheet(20, 6, cell, alternating);
        const double radius = 2.0;
        std::vector<Vec3> x;
        for (const Vec3& place : net.position)
            x.push_back({radius * std::sin(place.x() / radius),
                         radius * (1.0 - std::cos(place.x() / radius)), place.z()});
        const double area = 19 * cell * 6 * cell;
        const double expected = 0.5 * stiffness / (radius * radius) * area;
        QVERIFY2(isNear(energyOf(bendsOf(net), x), expected, 1e-3 * expected),
                 told(energyOf(bendsOf(net), x), expected));
    }

    // M9: 1e4 steps at half the limit, from a bump
    void energyIsKept()
    {
        System system = looseSheet(6, 4);
        system.integrator = Integrator::VelocityVerlet;
        finish(system);
        system.timeStep = 0.5 * stiffStepLimit(system);
        State state = system.start;
        for (PaddedVec3& x : state.position)
            x.y() += 0.005 * std::cos(std::numbers::pi * x.x() / 0.12)
                     * std::cos(std::numbers::pi * x.z() / 0.08);
        const double before = energies(system, state).total();
        double furthest = 0.0;
        for (int i = 0; i < 100; ++i) {
            state = run(system, state, 100);
            furthest = std::max(furthest, std::abs(energies(system, state).total() - before));
        }
        QVERIFY2(furthest < 0.01 * before, told(furthest, 0.0));
        QVERIFY(momentum(system, state).norm() < 1e-12);
    }

    void stepLimitIsSafeAndNear()
    {
        System system = looseSheet(8, 8);
        finish(system);
        const double limit = stiffStepLimit(system);
        for (const auto& [factor, stays] : {std::pair(0.99, true), std::pair(1.7, false)}) {
            system.timeStep = factor * limit;
            State state = system.start;
            crumple(state, 1e-5, 0.0);
            // bending never pulls harder than some moment: what is not stable crumples
            state = run(system, state, 4000);
            const bool isCrumpled = std::ranges::any_of(
                state.position, [](const PaddedVec3& x) { return !(std::abs(x.y()) < 1e-3); });
            QCOMPARE(isCrumpled, !stays);
        }
    }

    void sceneHasTheSameStepLimit()
    {
        Scene scene = *build(*findBuilder("bending_test"), {});
        const auto system = *compile(scene);
        const double inScene = stepLimit(scene)->timeStep;
        QVERIFY2(isNear(inScene, stiffStepLimit(*system), 1e-9 * inScene),
                 told(inScene, stiffStepLimit(*system)));
        scene.settings.substeps = 1;
        QVERIFY(problemsOf(scene).empty()); // the automatic solver takes as many as it needs
        scene.settings.solver = Solver::SmallSteps;
        const auto problems = problemsOf(scene);
        QVERIFY(std::any_of(problems.begin(), problems.end(), [](const Finding& problem) {
            return problem.message.english().find("bending") != std::string::npos;
        }));
    }

    void tearDropsBends()
    {
        System system = looseSheet(4, 4);
        system.springs[20].tear = {TearRule::Length, 0.0}; // at once
        finish(system);
        system.timeStep = 0.5 * stiffStepLimit(system);
        State state = system.start;
        crumple(state, 0.002, 0.0);
        state = run(system, state, 1);
        const auto gone = std::count(state.panelGone.begin(), state.panelGone.end(), 1);
        QVERIFY(gone > 0);
        const BendLists& lists = system.of<BendLists>();
        BendScratch bends;
        bends.size(lists);
        ThreadPool alone(1);
        fillBends(system, state, alone, bends);
        const auto isGone = [&](int row) {
            return state.panelGone[std::size_t(lists.panels[std::size_t(row)].panel)] != 0;
        };
        int dropped = 0;
        for (std::size_t i = 0; i < lists.panels.size(); ++i) {
            const bool isAlone =
                isGone(int(i)) || std::ranges::all_of(lists.panels[i].beside, [&](int beside) {
                    return beside == int(i) || isGone(beside);
                });
            for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
                QCOMPARE(bends.load[k].norm() == 0.0, isAlone);
            dropped += isAlone;
        }
        QVERIFY(dropped >= int(gone));
        state = run(system, state, 1000);
        QVERIFY(isFinite(state));
        QVERIFY(momentum(system, state).norm() < 1e-12);
    }

    void tornSparHinges()
    {
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}, {"rigidity", 1}, {"ends", 1}});
        Material& cord = itemNamed<Material>(scene, "cord");
        cord.tearRule = TearRule::Length;
        cord.tearLimit = 1e-3; // all of them
        const auto system = *compile(scene);
        QCOMPARE(int(system->of<BendLists>().list.size()), 3);
        State state = run(*system, 4); // one in a substep, as System::tearsPerStep says
        QCOMPARE(int(state.tears.size()), 4);
        QCOMPARE(bendingEnergy(*system, state), 0.0);
    }

    void linksGoOnStraight()
    {
        // two spars of one material that cross
        BendingNet net;
        const int middle = addPlace(net, Vec3::Zero());
        const int west = addPlace(net, {-1, 0, 0}), east = addPlace(net, {1, 0, 0});
        const int south = addPlace(net, {0, 0, -1}), north = addPlace(net, {0, 0.1, 1});
        addSpar(net, {west, middle, east});
        addSpar(net, {south, middle, north});
        const auto bends = bendsOf(net);
        QCOMPARE(int(bends.size()), 2);
        for (const Bend& bend : bends) {
            QCOMPARE(bend.corner[0], middle);
            QVERIFY(bend.corner[1] + bend.corner[2] == west + east
                    || bend.corner[1] + bend.corner[2] == south + north);
        }
        // a corner is a joint
        BendingNet corner;
        addSpar(corner, {addPlace(corner, {1, 0, 0}), addPlace(corner, {0, 0, 0}),
                         addPlace(corner, {0, 0, 1})});
        QVERIFY(bendsOf(corner).empty());
    }

    void hoopStaysRound()
    {
        System system = emptySystem(1e-4);
        const int count = 12;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            addParticle(system, {std::cos(angle), std::sin(angle), 0.0}, 0.1);
        }
        for (int i = 0; i < count; ++i) {
            addSpring(system, i, (i + 1) % count, distance(system, i, (i + 1) % count), 1e4);
            system.links.push_back({Key(i), LinkKind::Spring, i, i, (i + 1) % count});
            system.linkStuff.push_back({1, 0, LinkRole::Line, 0.0});
        }
        system.materialAir = {MaterialAir(), MaterialAir()};
        system.materialAir[1].key = 1;
        system.bending = {Bending(), {0.0, 5.0}};
        finish(system);
        QCOMPARE(int(system.of<BendLists>().list.size()), count);
        QVERIFY(bendingEnergy(system, system.start) < 1e-20);
        const State after = run(system, 1000);
        for (int i = 0; i < count; ++i)
            QVERIFY((after.position[std::size_t(i)] - system.start.position[std::size_t(i)]).norm()
                    < 1e-9);
    }

    void limpScenesHaveNone()
    {
        const auto system = *compile(*build(*findBuilder("cloth"), {}));
        QVERIFY(system->of<BendLists>().list.empty() && system->bending.empty());
    }

    // bending given to a running scene, changed and taken away again
    void editsInPlace()
    {
        Scene scene = *build(*findBuilder("cloth"), {{"columns", 6}, {"rows", 5}});
        const Id cloth = idNamed<Material>(scene, "cloth");
        LiveSystem live(scene);
        System running = *std::get<Update>(live.update(1, 1)).system;
        const Property* property = findProperty(Kind::Material, "bendingStiffness");
        for (const double value : {1e-4, 2e-4, 0.0, 1e-3}) {
            live.apply({{}, {SetValues{property, {cloth}, {value}}}});
            const auto update = std::get<Update>(live.update(1, 1));
            QVERIFY(update.patch);
            (void)apply(*update.patch, running);
            QVERIFY(running == **compile(live.scene(), 1, 1));
            QCOMPARE(running.of<BendLists>().list.empty(), value == 0.0);
        }
    }

    // Bends of rods join the solve of the rods, and leave it with the solver that takes them.
    void sparsOfRodsEditedInPlace()
    {
        const Scene scene = *build(*findBuilder("rope"), {{"segments", 6}, {"rigidity", 1.0}});
        const Id cord = idNamed<Material>(scene, "cord");
        LiveSystem live(scene);
        System running = *std::get<Update>(live.update(1, 1)).system;
        QCOMPARE(int(running.of<BendLists>().withRods().size()), 5);
        QVERIFY(std::isinf(stiffStepLimit(running)) && !stepLimit(scene));
        Simulation flown(std::make_shared<const System>(running));
        const auto edit = [&](Kind kind, Id id, const char* key, const Value& value) {
            live.apply({{}, {SetValues{findProperty(kind, key), {id}, {value}}}});
            const auto update = std::get<Update>(live.update(1, 1));
            (void)apply(*update.patch, running);
            flown.load(update);
            flown.step();
        };
        for (const double value : {2.0, 0.0, 3.0}) {
            edit(Kind::Material, cord, "flexuralRigidity", value);
            QVERIFY(running == **compile(live.scene(), 1, 1));
            QCOMPARE(running.of<BendLists>().withRods().empty(), value == 0.0);
            QVERIFY(isFinite(flown.state()));
        }
        edit(Kind::Settings, settingsId, "solver", std::string("small_steps"));
        QVERIFY(running == **compile(live.scene(), 1, 1));
        QVERIFY(running.of<BendLists>().withRods().empty());
        QVERIFY(std::isfinite(stiffStepLimit(running)) && stepLimit(live.scene()));
    }

    // A bow is at rest where its string pulls: without anything that slows it, it does not begin to
    // tremble.
    void bentSparStaysAtRest()
    {
        Scene scene;
        scene.settings.gravity = Vec3::Zero();
        scene.settings.airDensity = 0.0;
        Material rod;
        rod.axialStiffness = 1508e3; // N, carbon, 4 mm
        rod.flexuralRigidity = 1.54; // N m^2
        rod.dampingTime = 1e-4;      // s
        const Id material = addItem(scene, rod);
        Network network(scene, "bow");
        const int links = 20;
        const double length = 1.2, half = 0.8; // m, radians
        const auto nodes =
            network.line(network.particle(Vec3::Zero()), network.particle({length, 0.0, 0.0}),
                         links, 0.0195 * length, material, Resists::Both);
        network.rod(nodes.front(), nodes.back(), material, Resists::Tension);
        network.setRestLength(length * std::sin(half) / half);
        network.finish({}, {});
        scene.settings.viscosity = 40.0; // 1/s, until it is at rest
        const auto slowed = *compile(scene);
        scene.settings.viscosity = 0.0;
        const auto free = *compile(scene);
        State state = slowed->start; // straight rods, put on an arc
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const auto place =
                std::size_t(std::ranges::find(free->key, Key(nodes[i])) - free->key.begin());
            const double angle = half * (2.0 * double(i) / links - 1.0);
            state.position[place] =
                0.5 * length / half * Vec3(std::sin(angle), std::cos(angle), 0.0);
        }
        state = run(*slowed, state, 480);
        QVERIFY(bendingEnergy(*slowed, state) > 1.0); // J
        QVERIFY2(energies(*slowed, state).kinetic < 1e-9, "not at rest");
        state = run(*free, state, 480);
        QVERIFY2(energies(*free, state).kinetic < 1e-9, told(energies(*free, state).kinetic, 0.0));
    }

    void sameBitsAtAnyNumberOfThreads()
    {
        System system = looseSheet(100, 60);
        finish(system);
        system.timeStep = 0.5 * stiffStepLimit(system);
        crumple(system.start, 0.002, 0.1);
        const std::uint64_t one = stateHash(run(system, 20, 1));
        for (const int threads : {4, 2})
            QCOMPARE(stateHash(run(system, 20, threads)), one);
    }

    // the automatic solver takes the substeps that bending needs
    void automaticSubsteps()
    {
        Scene scene = *build(*findBuilder("bending_test"), {{"cells", 8}});
        scene.settings.substeps = 1;
        scene.settings.solver = Solver::Auto;
        const auto system = *compile(scene);
        Stepper stepper;
        State state = system->start;
        for (int i = 0; i < 200; ++i) {
            stepper.step(*system, state);
            QVERIFY(system->timeStep / state.substeps <= stiffStepLimit(*system)
                    || state.substeps == 0);
        }
        QVERIFY(isFinite(state));
        QVERIFY(stepper.choice(*system).english().find("bending") != std::string::npos);
    }
};

const RegisteredTest registered("test_bending", runPlain<TestBending>);

} // namespace ripstop::test_bending
#include "test_bending.moc"
