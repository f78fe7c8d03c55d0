// Bends of fabric that are solved together with the panels which carry its pull, as a new scene has
// them where its cells are small.
//
// Stages: how loads change is the slope of the loads, symmetric, positive and below its bound at
// any shape; a strip droops as the heavy elastica does and swings as a cantilever does, in whole
// steps at any size of cells; slack cloth falls as it does in steps that are short enough for
// bending as a force; and bits hang neither on threads nor on where a run was begun.
#include "model/first_item.h"
#include "model/systems.h"
#include "registered_test.h"

#include "check/check.h"
#include "check/step_check.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "compile/patch.h"
#include "derived/flat_panel.h"
#include "laws/fabric_bending.h"
#include "measure/diagnostics.h"
#include "scene/property.h"
#include "simulation/simulation.h"
#include "step/solver_plan.h"
#include "step/stepper.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace ripstop::test_fabric_bends {

namespace {

constexpr double bending = 5e-6;  // N m, of ripstop
constexpr double density = 0.047; // kg/m^2

struct Sheet
{
    int along = 20; // cells
    int across = 4;
    double cell = 0.002;    // m
    bool isClamped = false; // one more column of cells before it, which is pinned
};

int at(const Sheet& sheet, int i, int j) { return j * (sheet.along + 2) + i + 1; }

// In the plane y = 0 along x, of ripstop that panels carry; without air.
Scene sceneOf(const Sheet& sheet)
{
    Scene scene;
    const Id id = takeId(scene);
    Material cloth;
    cloth.name = "ripstop";
    cloth.membraneStiffness = 4e4;
    cloth.shearStiffness = 1e3;
    cloth.bendingStiffness = bending;
    cloth.arealDensity = density;
    cloth.dampingTime = 1e-3;
    cloth.airLaw = AirLaw::None;
    scene.items.push_back({id, cloth});
    scene.settings.airDensity = 0.0;
    const Id partId = takeId(scene);
    Part part;
    part.name = "sheet";
    part.carrier = FabricKind::Panels;
    for (int j = 0; j <= sheet.across; ++j)
        for (int i = -1; i <= sheet.along; ++i) {
            Particle particle;
            particle.id = takeId(scene);
            particle.position = {i * sheet.cell, 0.0, j * sheet.cell};
            particle.pinned = sheet.isClamped && i <= 0;
            particle.mass = 0.0;
            part.particles.push_back(particle);
        }
    const auto cover = [&](int a, int b, int c) {
        Panel panel;
        panel.id = takeId(scene);
        panel.material = id;
        for (const auto& [corner, place] : {std::pair(&panel.a, a), {&panel.b, b}, {&panel.c, c}}) {
            Particle& particle = part.particles[std::size_t(place)];
            *corner = particle.id;
            particle.mass += density * sheet.cell * sheet.cell / 6.0;
        }
        const auto place = [&](int i) { return part.particles[std::size_t(i)].position; };
        panel.grain = grainAlong(place(a), place(b), place(c), Vec3::UnitX());
        part.panels.push_back(panel);
    };
    for (int j = 0; j < sheet.across; ++j)
        for (int i = -1; i < sheet.along; ++i) {
            const int a = at(sheet, i, j), b = at(sheet, i + 1, j);
            const int c = at(sheet, i, j + 1), d = at(sheet, i + 1, j + 1);
            const bool rises = (i + j) % 2 == 0;
            cover(a, b, rises ? d : c);
            cover(rises ? a : b, d, c);
        }
    scene.items.push_back({partId, part});
    return scene;
}

// Twice as long as its bending length, where it droops by 41.49 degrees.
Sheet peirceStrip(int along)
{
    const double overhang = 2.0 * std::cbrt(bending / (density * standardGravity));
    return {along, std::max(4, along / 5), overhang / along, true};
}

double cantileverFrequency(const Sheet& strip) // 1/s
{
    return 3.51602 * std::sqrt(bending / (density * std::pow(strip.along * strip.cell, 4)));
}

std::shared_ptr<const System> compiled(const Scene& scene)
{
    const auto system = compile(scene);
    if (!system)
        qFatal("%s", system.message().english().c_str());
    return *system;
}

const Vec3& tipOf(const Sheet& strip, const State& state)
{
    return state.position[std::size_t(at(strip, strip.along, strip.across / 2))];
}

void takesWholeSteps(const Scene& scene)
{
    QVERIFY(problemsOf(scene).empty());
    const SolverPlan plan = planFor(*compiled(scene));
    QCOMPARE(plan.substeps, 1);
    QCOMPARE(plan.integrator, Integrator::Bdf2);
}

using Field = std::vector<PaddedVec3>; // [particles]

double product(const Field& a, const Field& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i].dot(b[i]);
    return sum;
}

// A crumpled sheet, and what bends it.
struct Crumpled
{
    std::shared_ptr<const System> system = compiled(sceneOf({8, 6}));
    std::span<const BentPanel> panels = system->of<BendLists>().panels;
    State state = system->start;
    FabricBending bends;
    ThreadPool alone{1};

    explicit Crumpled(double size, Dice& dice) // of a cell
    {
        for (PaddedVec3& x : state.position)
            x += dice.vector(size * Sheet().cell);
        bends.size(panels.size());
        bends.sizeChange();
    }

    Field gathered(const Field& load) const // N, at particles
    {
        Field sum(state.position.size());
        for (std::size_t i = 0; i < panels.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                sum[std::size_t(panels[i].corner[k])] += load[3 * i + k];
        return sum;
    }

    Field loads(const std::vector<PaddedVec3>& position)
    {
        Field load(3 * panels.size());
        bends.fill(panels, state.panelGone, position.data(), load.data(), alone);
        return gathered(load);
    }

    // After loads() of where it is.
    Field changeAlong(const Field& way, std::span<const double> less = {})
    {
        Field load(3 * panels.size());
        bends.fillChange(panels, less, state.position.data(), way.data(), load.data(), alone);
        return gathered(load);
    }

    Field anyWay(Dice& dice) const
    {
        Field way(state.position.size());
        for (PaddedVec3& x : way)
            x = dice.vector(1.0);
        return way;
    }
};

} // namespace

class TestFabricBends : public QObject
{
    Q_OBJECT

private slots:
    // What is flat pulls with nothing that could turn, so that nothing is left out.
    void changeIsTheSlopeOfLoads()
    {
        Dice dice(5);
        Crumpled flat(0.0, dice);
        const Field way = flat.anyWay(dice);
        constexpr double step = 1e-9; // m
        std::vector<PaddedVec3> there = flat.state.position, back = there;
        for (std::size_t i = 0; i < there.size(); ++i) {
            there[i] += step * way[i];
            back[i] -= step * way[i];
        }
        const Field after = flat.loads(there), before = flat.loads(back);
        (void)flat.loads(flat.state.position);
        const Field change = flat.changeAlong(way);
        double size = 0.0, off = 0.0;
        for (std::size_t i = 0; i < change.size(); ++i) {
            size = std::max(size, change[i].norm());
            off = std::max(off, (change[i] - (after[i] - before[i]) / (2.0 * step)).norm());
        }
        QVERIFY2(size > 0.0 && off < 1e-5 * size, qPrintable(QString::number(off / size)));
    }

    void changeIsSymmetricAndHolds_data()
    {
        QTest::addColumn<double>("size");
        for (const double size : {0.0, 0.05, 0.4, 2.0}) // of a cell; past 0.1 some are squeezed
            QTest::addRow("%g", size) << size;
    }
    void changeIsSymmetricAndHolds()
    {
        QFETCH(double, size);
        Dice dice(7);
        for (int time = 0; time < 20; ++time) {
            Crumpled sheet(size, dice);
            (void)sheet.loads(sheet.state.position);
            const Field one = sheet.anyWay(dice), other = sheet.anyWay(dice);
            const Field ofOne = sheet.changeAlong(one), ofOther = sheet.changeAlong(other);
            const double there = product(ofOne, other), back = product(one, ofOther);
            QVERIFY(std::abs(there - back) <= 1e-9 * (std::abs(there) + std::abs(back)));
            QVERIFY(product(one, ofOne) < 0.0);
        }
    }

    // Heavy elastica, B t'' = -w (L - s) cos t with t(0) = t'(L) = 0, for w L^3 = 8 B.
    void stripsDroopAsPeirceSays_data() { sizesOfCells(); }
    void stripsDroopAsPeirceSays()
    {
        QFETCH(int, cells);
        const Sheet strip = peirceStrip(cells);
        Scene scene = sceneOf(strip);
        takesWholeSteps(scene);
        const double frequency = cantileverFrequency(strip);
        scene.settings.viscosity = 2.0 * frequency;
        Simulation simulation(compiled(scene));
        (void)simulation.runUntil(14.0 / frequency);
        QVERIFY2(!simulation.trouble(), "stopped");
        const Vec3& tip = tipOf(strip, simulation.state());
        const double angle = std::atan2(-tip.y(), tip.x()) * 180.0 / std::numbers::pi;
        QVERIFY2(std::abs(angle - 41.4873) < 0.5, qPrintable(QString::number(angle)));
    }

    // 3.516 sqrt(B / (rho L^4)), let go from the shape of the first mode.
    void stripsSwingAsCantileversDo_data() { sizesOfCells(); }
    void stripsSwingAsCantileversDo()
    {
        QFETCH(int, cells);
        const Sheet strip = peirceStrip(cells);
        Scene scene = sceneOf(strip);
        scene.settings.gravity = Vec3::Zero();
        takesWholeSteps(scene);
        const auto system = compiled(scene);
        State state = system->start;
        const double length = strip.along * strip.cell;
        const double b = 1.875104 / length; // 1/m, cos cosh = -1
        const double ratio = (std::cosh(b * length) + std::cos(b * length))
                             / (std::sinh(b * length) + std::sin(b * length));
        const auto shapeAt = [&](double x) {
            return 0.005 * length
                   * (std::cosh(b * x) - std::cos(b * x)
                      - ratio * (std::sinh(b * x) - std::sin(b * x)));
        };
        double along = 0.0; // m, with no cell stretched
        for (int i = 1; i <= strip.along; ++i) {
            const double height = shapeAt(i * strip.cell);
            const double rise = height - shapeAt((i - 1) * strip.cell);
            along += std::sqrt(strip.cell * strip.cell - rise * rise);
            for (int j = 0; j <= strip.across; ++j) {
                Vec3& place = state.position[std::size_t(at(strip, i, j))];
                place = {along, height, place.z()};
            }
        }
        Stepper stepper;
        std::vector<double> turns; // s, when the tip goes up through rest
        while (turns.size() < 4 && state.time < 3.0) {
            const double before = tipOf(strip, state).y();
            stepper.step(*system, state);
            const double after = tipOf(strip, state).y();
            if (before < 0.0 && after >= 0.0)
                turns.push_back(state.time - system->timeStep * after / (after - before));
        }
        QCOMPARE(turns.size(), 4u);
        const double frequency = 2.0 * std::numbers::pi * 3.0 / (turns[3] - turns[0]);
        const double expected = cantileverFrequency(strip);
        QVERIFY2(std::abs(frequency - expected) < 0.02 * expected,
                 qPrintable(QString::number(frequency / expected)));
    }

    // Held by two corners, it folds as it falls. In steps of a sixteenth bending is a force.
    void slackClothFallsAsInShortSteps()
    {
        const Sheet square{16, 17, 0.005};
        Scene scene = sceneOf(square);
        std::vector<Particle>& particles = firstOf<Part>(scene).particles;
        particles[0].pinned = particles[std::size_t(square.along) + 1].pinned = true;
        takesWholeSteps(scene);
        const auto fallen = [&](double share) { // of a step
            Scene other = scene;
            other.settings.timeStep *= share;
            const auto system = compiled(other);
            Simulation simulation(system);
            (void)simulation.runUntil(0.15);
            return std::pair(system->of<BendLists>().panelsAreSolved, simulation.state().position);
        };
        const auto [isSolved, exact] = fallen(1.0 / 16.0);
        QVERIFY(!isSolved);
        const double fall = 0.5 * standardGravity * 0.15 * 0.15; // m, freely
        for (const double share : {1.0, 0.25}) {
            const auto [isSolvedHere, position] = fallen(share);
            QVERIFY(isSolvedHere);
            for (const auto& [i, j] : {std::pair(8, 8), {8, 17}, {2, 15}}) {
                const auto place = std::size_t(at(square, i, j));
                const double off = (position[place] - exact[place]).norm();
                QVERIFY2(off < 0.03 * share * fall, qPrintable(QString::number(off / fall)));
            }
        }
    }

    // Where some fabric is of threads all of it bends by forces, and the check of the scene, which
    // has no system to ask, says so.
    void fabricOfThreadsBesideItKeepsForces()
    {
        Scene scene = sceneOf({});
        QVERIFY(compiled(scene)->of<BendLists>().panelsAreSolved);
        QVERIFY(!stepLimit(scene));
        Part threads = firstOf<Part>(scene);
        threads.carrier = FabricKind::Threads;
        std::map<Id, Id> renamed;
        for (Particle& particle : threads.particles) {
            particle.position.y() += 1.0;
            particle.id = renamed[particle.id] = takeId(scene);
        }
        for (Panel& panel : threads.panels) {
            panel.id = takeId(scene);
            for (Id* const corner : {&panel.a, &panel.b, &panel.c})
                *corner = renamed.at(*corner);
        }
        const Id id = takeId(scene);
        scene.items.push_back({id, threads});
        const auto system = compiled(scene);
        QVERIFY(!system->of<BendLists>().panelsAreSolved);
        QVERIFY(stepLimit(scene));
        QVERIFY(stepLimit(scene)->timeStep < scene.settings.timeStep);
        QVERIFY(planFor(*system).substeps > 1);
    }

    // As if the run had begun with what was typed.
    void stiffnessIsReadAgainWhenItIsTyped()
    {
        LiveSystem live(sceneOf(peirceStrip(20)));
        System running = *std::get<Update>(live.update(1, 1)).system;
        State state = running.start;
        Stepper stepper;
        for (int i = 0; i < 10; ++i)
            stepper.step(running, state);
        State other = state;
        const Id cloth = live.scene().items.front().id;
        live.apply(
            {{},
             {SetValues{
                 findProperty(Kind::Material, "bendingStiffness"), {cloth}, {4.0 * bending}}}});
        const auto update = std::get<Update>(live.update(1, 1));
        QVERIFY(update.patch);
        (void)apply(*update.patch, running);
        const auto fresh = compiled(live.scene());
        Stepper another;
        for (int i = 0; i < 10; ++i) {
            stepper.step(running, state);
            another.step(*fresh, other);
        }
        QCOMPARE(stateHash(state), stateHash(other));
    }

    void sameBitsAtAnyNumberOfThreads()
    {
        const auto system = compiled(sceneOf({40, 30, 0.002, true}));
        QVERIFY(system->of<BendLists>().panelsAreSolved);
        std::optional<std::uint64_t> alone;
        for (const int threads : {1, 2, 3}) {
            Stepper stepper(threads);
            State state = system->start;
            for (int i = 0; i < 30; ++i)
                stepper.step(*system, state);
            alone = alone.value_or(stateHash(state));
            QCOMPARE(stateHash(state), *alone);
        }
    }

    void goesOnFromACheckpoint()
    {
        const auto system = compiled(sceneOf(peirceStrip(20)));
        State all = system->start, begun = all;
        Stepper stepper, first, second;
        for (int i = 0; i < 40; ++i) {
            stepper.step(*system, all);
            (i < 17 ? first : second).step(*system, begun);
        }
        QCOMPARE(stateHash(begun), stateHash(all));
    }

private:
    static void sizesOfCells()
    {
        QTest::addColumn<int>("cells");
        for (const int cells : {10, 20, 40})
            QTest::addRow("%d cells", cells) << cells;
    }
};

const RegisteredTest registered("test_fabric_bends", runPlain<TestFabricBends>);

} // namespace ripstop::test_fabric_bends
#include "test_fabric_bends.moc"
