// Spars that are loaded until they snap: a cantilever at its root, at the moment that statics say,
// whatever the mesh and however far it is bent; lines with knots; and what is said of spars that
// cannot snap.
#include "check/check.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "derived/tear_bounds.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "run/tear_report.h"
#include "scene/property.h"
#include "simulation/simulation.h"

#include <QtTest>

namespace ripstop::test_snapped_spars {

namespace {

constexpr double reach = 0.5;                                                 // m, of the spar
constexpr double breaking = 3.0;                                              // N m
constexpr double density = 0.05;                                              // kg/m
constexpr double ownMoment = 0.5 * density * standardGravity * reach * reach; // N m, at its root

struct Beam
{
    Scene scene;
    Id material{};
    std::vector<Id> particles; // the first two are clamped, the last one bears the load

    Material& spar() { return std::get<Material>(*findItem(scene, material)); }
};

// A spar along x from the origin, clamped by a link before it, with a load at its far end.
//   load  N, under gravity
Beam beam(int links, double rigidity, double load)
{
    Beam made;
    Scene& scene = made.scene;
    made.material = takeId(scene);
    Material material;
    material.name = "tube";
    material.axialStiffness = 1e6;
    material.flexuralRigidity = rigidity;
    material.tearRule = TearRule::Strength;
    material.breakingMoment = breaking;
    scene.items.push_back({made.material, material});
    scene.settings.viscosity = 20.0;
    const Id id = takeId(scene);
    Part part;
    part.name = "beam";
    const double cell = reach / links;
    for (int i = -1; i <= links; ++i) {
        Particle particle;
        particle.id = takeId(scene);
        particle.position = {i * cell, 0.0, 0.0};
        particle.pinned = i <= 0;
        particle.mass = i == links ? load / standardGravity + 0.5 * density * cell : density * cell;
        made.particles.push_back(particle.id);
        part.particles.push_back(particle);
    }
    for (int i = 0; i <= links; ++i) {
        Link link;
        link.id = takeId(scene);
        link.from = made.particles[std::size_t(i)];
        link.to = made.particles[std::size_t(i) + 1];
        link.material = made.material;
        link.restLength = cell;
        part.links.push_back(link);
    }
    scene.items.push_back({id, part});
    return made;
}

// The load comes as its share of gravity grows, within so many seconds and by 1 % at a time; then
// 1 s more. Calls look(share) after each, which says whether to go on.
template <typename Look>
void loadSlowly(Simulation& simulation, Scene scene, double seconds, Look&& look)
{
    const Vec3 gravity = scene.settings.gravity;
    for (int n = 1; n <= 100; ++n) {
        scene.settings.gravity = n / 100.0 * gravity;
        simulation.load(*compile(scene));
        simulation.runUntil(n / 100.0 * seconds);
        if (!look(n / 100.0))
            return;
    }
    simulation.runUntil(seconds + 1.0);
}

Simulation unloaded(Scene scene)
{
    scene.settings.gravity = Vec3::Zero();
    return Simulation(*compile(scene));
}

int tornIn(const State& state)
{
    return int(std::count(state.rodTorn.begin(), state.rodTorn.end(), 1)
               + std::count(state.springTorn.begin(), state.springTorn.end(), 1));
}

} // namespace

class TestSnappedSpars : public QObject
{
    Q_OBJECT

private slots:
    // Statics: the moment at the root is W L, with its own weight w L^2 / 2 more, while the spar is
    // as good as straight, with EI = 50 N m^2 to 1e-4 of it. The joint at the clamp has all of it,
    // whatever the length of a link.
    void cantileverSnapsAtItsRoot_data()
    {
        QTest::addColumn<int>("links");
        QTest::addColumn<double>("share"); // of the breaking load
        QTest::addColumn<double>("efficiency");
        for (const int links : {4, 8, 16})
            for (const double share : {0.985, 1.015})
                QTest::addRow("%d links, %g of the load", links, share) << links << share << 1.0;
        QTest::addRow("with a joint that holds") << 10 << 0.985 << 0.8;
        QTest::addRow("with a joint that does not hold") << 10 << 1.015 << 0.8;
    }

    void cantileverSnapsAtItsRoot()
    {
        QFETCH(int, links);
        QFETCH(double, share);
        QFETCH(double, efficiency);
        const double bears = efficiency * breaking; // N m
        Beam made = beam(links, 50.0, (share * bears - ownMoment) / reach);
        if (efficiency < 1.0)
            made.spar().jointEfficiency = efficiency;
        Simulation simulation = unloaded(made.scene);
        bool held = true; // up to 0.98 of what it bears
        loadSlowly(simulation, made.scene, 5.0, [&](double loaded) {
            if (loaded * share < 0.98)
                held &= simulation.state().tears.empty();
            return simulation.state().tears.empty();
        });
        QVERIFY(held);
        const State& state = simulation.state();
        if (share < 1.0) {
            QCOMPARE(tornIn(state), 0);
            const double tip = state.position[state.position.size() - 1].y(); // W L^3 / (3 EI)
            const double sag = share * bears * reach * reach / (3.0 * 50.0);
            QVERIFY2(isNear(-tip, sag, 0.05 * sag), told(-tip, sag));
            return;
        }
        QVERIFY(!state.tears.empty());
        const Tear tear = simulation.frame()->tears[0];
        QVERIFY(isSnap(tear));
        QVERIFY2(tear.force > bears && tear.force < 1.015 * bears, told(tear.force, bears));
        QVERIFY2(isNear(tear.place, Vec3::Zero(), 1e-6), told(tear.place, Vec3::Zero()));
        const Part& part = std::get<Part>(made.scene.items[1].item);
        QCOMPARE(tear.element, std::uint32_t(part.links[1].id)); // the first that is not clamped
        simulation.runUntil(state.time + 0.3); // by g / c (t - 1 / c), c being the viscosity
        QVERIFY2(state.position.back().y() < -0.12, told(state.position.back().y(), -0.123));
    }

    // Bent far, the arm of the load is how far the tip still reaches. With EI = 2 N m^2 it has
    // sagged by a fifth of its length when it snaps.
    void armIsHowFarItReaches_data()
    {
        QTest::addColumn<int>("links");
        for (const int links : {4, 8, 16})
            QTest::addRow("%d links", links) << links;
    }

    void armIsHowFarItReaches()
    {
        QFETCH(int, links);
        const double load = 1.6 * breaking / reach;
        Beam made = beam(links, 2.0, load);
        made.scene.settings.viscosity = 5.0; // it swings at about 7/s and lags by 5 / 7^2 s
        Simulation simulation = unloaded(made.scene);
        double before = 0.0, moment = 0.0; // N m, while it held
        loadSlowly(simulation, made.scene, 20.0, [&](double share) {
            if (!simulation.state().tears.empty())
                return false;
            before = moment;
            moment = 0.0;
            const System& system = simulation.system();
            for (std::size_t i = 0; i < system.mass.size(); ++i)
                moment += share * standardGravity * system.mass[i]
                          * std::max(simulation.state().position[i].x(), 0.0);
            return true;
        });
        QVERIFY(!simulation.state().tears.empty());
        const double step = moment - before; // by which the next one is higher at most
        QVERIFY2(moment < breaking * 1.01 && moment + 2.0 * step > breaking,
                 told(moment, breaking));
        const Tear tear = simulation.frame()->tears[0];
        QVERIFY2(isNear(tear.force, breaking, 0.015 * breaking), told(tear.force, breaking));
        QVERIFY2(isNear(tear.place, Vec3::Zero(), 1e-6), told(tear.place, Vec3::Zero()));
    }

    // A load on the middle of a spar that both ends bear bends it there with W L / 4; it snaps into
    // two.
    void snapsInTheMiddle()
    {
        Beam made = beam(10, 50.0, 1e-3);
        Part& part = std::get<Part>(made.scene.items[1].item);
        part.links.erase(part.links.begin()); // the clamp
        part.particles.back().pinned = true;
        const double load = 1.02 * 4.0 * breaking / reach;
        part.particles[6].mass = load / standardGravity;
        part.particles[0].position.y() = 1.0; // of no part in it
        Simulation simulation = unloaded(made.scene);
        bool held = true;
        loadSlowly(simulation, made.scene, 5.0, [&](double share) {
            if (share < 0.97)
                held &= simulation.state().tears.empty();
            return simulation.state().tears.empty();
        });
        simulation.runUntil(simulation.state().time + 0.2);
        QVERIFY(held);
        QVERIFY(!simulation.state().tears.empty());
        const Tear tear = simulation.frame()->tears[0];
        QVERIFY2(isNear(tear.force, breaking, 0.015 * breaking), told(tear.force, breaking));
        QVERIFY2(std::abs(tear.place.x() - 0.5 * reach) < 1e-3, told(tear.place.x(), 0.25));
        QVERIFY(simulation.state().position[6].y() < -0.05); // nothing holds it up
    }

    // Never, unless its material tears by strength; and an edit in flight says so at once.
    void snapsWhenItIsToldTo()
    {
        Beam made = beam(10, 50.0, 1.5 * breaking / reach);
        made.spar().breakingMoment = 2.0 * breaking;
        LiveSystem live(made.scene);
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        const auto edit = [&](const char* key, const Value& value) {
            live.apply(
                {{}, {SetValues{findProperty(Kind::Material, key), {made.material}, {value}}}});
            const auto update = std::get<Update>(live.update(1, 1));
            QVERIFY(update.patch);
            simulation.load(update);
            QVERIFY(simulation.system() == **compile(live.scene(), 1, 1));
        };
        edit("tearRule", std::string("force"));
        edit("tearLimit", 1e9);
        edit("breakingMoment", breaking);
        QVERIFY(simulation.runUntil(3.0)); // it has swung to rest
        QCOMPARE(tornIn(simulation.state()), 0);
        edit("breakingMoment", 1.6 * breaking);
        edit("tearRule", std::string("strength"));
        QVERIFY(simulation.runUntil(3.5));
        QCOMPARE(tornIn(simulation.state()), 0);
        edit("jointEfficiency", 0.9);
        QVERIFY(simulation.runUntil(4.0));
        QVERIFY(!simulation.state().tears.empty());
        QVERIFY(isSnap(simulation.frame()->tears[0]));
        const auto frame = simulation.frame();
        QCOMPARE(std::string(loadUnit(frame->tears[0], *frame->layout)), std::string("N m"));
    }

    // A line of 100 N with knots that leave 0.6 of it breaks at 60 N.
    void lineBreaksAtItsKnots_data()
    {
        QTest::addColumn<double>("share");
        QTest::addRow("holds") << 0.99;
        QTest::addRow("breaks") << 1.01;
    }

    void lineBreaksAtItsKnots()
    {
        QFETCH(double, share);
        Beam made = beam(4, 0.0, share * 60.0 - density * reach * standardGravity);
        Material& line = made.spar();
        line.breakingMoment.reset();
        line.lineStrength = 100.0;
        line.jointEfficiency = 0.6;
        Part& part = std::get<Part>(made.scene.items[1].item);
        for (Particle& particle : part.particles)
            particle.position = {0.0, -particle.position.x(), 0.0};
        Simulation simulation = unloaded(made.scene);
        loadSlowly(simulation, made.scene, 5.0,
                   [&](double) { return simulation.state().tears.empty(); });
        QCOMPARE(tornIn(simulation.state()) > 0, share > 1.0);
        if (share > 1.0) {
            const Tear tear = simulation.frame()->tears[0];
            QVERIFY(!isSnap(tear));
            QVERIFY2(tear.force > 60.0 && tear.force < 60.6, told(tear.force, 60.0));
        }
    }

    void panelsTearAtTheirSeams()
    {
        Material cloth;
        cloth.tearRule = TearRule::Strength;
        cloth.warpStrength = 400.0;
        cloth.jointEfficiency = 0.8;
        QCOMPARE(fabricTearOf(cloth).warp, 320.0);
        QCOMPARE(fabricTearOf(cloth).weft, FabricTear::unbreakable);
    }

    // A spar needs its moment and its rigidity to snap; the list of problems says which is missing.
    void saysWhatCannotSnap()
    {
        const auto found = [](const Scene& scene) {
            const std::vector<Finding> findings = problemsOf(scene);
            return std::ranges::count(findings, "unsnappable", &Finding::sort);
        };
        Beam made = beam(4, 50.0, 1.0);
        QCOMPARE(found(made.scene), 0);
        made.spar().breakingMoment.reset();
        QCOMPARE(found(made.scene), 1);
        made.spar().breakingMoment = breaking;
        made.spar().flexuralRigidity = 0.0;
        QCOMPARE(found(made.scene), 1);
        made.spar().tearRule = TearRule::Never;
        QCOMPARE(found(made.scene), 0);
    }
};

const RegisteredTest registered("test_snapped_spars", runPlain<TestSnappedSpars>);

} // namespace ripstop::test_snapped_spars
#include "test_snapped_spars.moc"
