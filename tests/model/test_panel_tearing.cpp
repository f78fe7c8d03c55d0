// Panels that carry the pull of a fabric and tear: which do, what is told of it, how the mesh parts
// there, and what rules say of links and panels.
#include "assembly/carry_over.h"
#include "assembly/split_system.h"
#include "check/check.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "derived/tear_bounds.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "tearing/tear_opening.h"
#include "tearing/tearing.h"

#include <QtTest>

namespace ripstop::test_panel_tearing {

namespace {

// The start, with all places moved away from the corner of the strip.
State stretched(const System& system, double across, double along)
{
    State state = system.start;
    for (PaddedVec3& place : state.position) {
        place.x() *= across;
        place.y() *= along;
    }
    return state;
}

} // namespace

class TestPanelTearing : public QObject
{
    Q_OBJECT

private slots:
    // Stretched by s along the warp, threads of E t = 10 kN/m have Green's strain e = (s^2 - 1) /
    // 2, and the pull per flat width is s E t e. What is pushed across, and wrinkles, has no other
    // pull. A panel that goes lets go of its area times E t e^2 / 2.
    void tellsWhatTore_data()
    {
        QTest::addColumn<double>("across");
        QTest::newRow("taut") << 1.0;
        QTest::newRow("wrinkled") << 0.9;
    }

    void tellsWhatTore()
    {
        QFETCH(double, across);
        constexpr double stretch = 1.05;
        const double green = 0.5 * (stretch * stretch - 1.0);
        const double pull = stretch * stiffness * green; // N/m
        const StripMesh mesh{2, 3, false, 0.0};
        for (const double limit : {0.999 * pull, 1.001 * pull}) {
            Strip made = strip(mesh, 0.0, 1.0);
            made.cloth().tearRule = TearRule::Tension;
            made.cloth().tearLimit = limit;
            const auto system = *compile(made.scene);
            State state = stretched(*system, across, stretch);
            TearScratch scratch;
            tearOverloaded(*system, state, {}, scratch);
            if (limit > pull) {
                QVERIFY(state.tears.empty());
                continue;
            }
            QCOMPARE(state.tears.size(), system->panels.size()); // all alike, in their order
            const double area = width * length / double(system->panels.size());
            for (std::size_t i = 0; i < state.tears.size(); ++i) {
                const State::Tear& tear = state.tears[i];
                QCOMPARE(tear.element, system->panelKey[i]);
                QVERIFY2(isNear(tear.force, pull, 1e-9 * pull), told(tear.force, pull));
                QVERIFY2(isNear(tear.strain, stretch - 1.0, 1e-9), told(tear.strain, 0.05));
                QVERIFY2(isNear(tear.length, width / mesh.across, 1e-9),
                         told(tear.length, width / mesh.across));
                const double energy = area * 0.5 * stiffness * green * green;
                QVERIFY2(isNear(tear.energy, energy, 1e-9 * energy), told(tear.energy, energy));
            }
            QCOMPARE(goneIn(state), int(system->panels.size()));
            QCOMPARE(energies(*system, state).elastic, 0.0);
        }
    }

    // By strain, warp and weft alike: of threads that are 5 % longer, a limit of 4.99 % is passed
    // and one of 5.01 % is not, whether shear is there or not.
    void tearsByStrain()
    {
        for (const double grain : {0.0, 90.0})
            for (const double limit : {0.0499, 0.0501}) {
                Strip made = strip(coarse, grain, 1.0);
                made.cloth().tearRule = TearRule::Strain;
                made.cloth().tearLimit = limit;
                const auto system = *compile(made.scene);
                State state = stretched(*system, 1.0, 1.05);
                TearScratch scratch;
                tearOverloaded(*system, state, {}, scratch);
                QCOMPARE(state.tears.empty(), limit > 0.05);
            }
    }

    // A length or a force is none of a panel.
    void tearsByNothingElse()
    {
        for (const TearRule rule :
             {TearRule::Never, TearRule::Length, TearRule::Force, TearRule::Strength}) {
            Strip made = strip(coarse, 0.0, 1.0);
            made.cloth().tearRule = rule;
            made.cloth().tearLimit = 0.0;
            const auto system = *compile(made.scene);
            State state = stretched(*system, 1.0, 1.5);
            TearScratch scratch;
            tearOverloaded(*system, state, {}, scratch);
            QVERIFY(state.tears.empty());
        }
    }

    // As many as a step may have: the worst first, and of equals the first panel. Above a limit of
    // 0 all are equal, infinitely far.
    void worstFirst()
    {
        Strip made = strip(coarse, 0.0, 1.0);
        made.scene.settings.tearsPerStep = 2;
        made.cloth().tearRule = TearRule::Tension;
        made.cloth().tearLimit = 100.0;
        const auto system = *compile(made.scene);
        State state = stretched(*system, 1.0, 1.05);
        for (std::size_t i = 0; i < 3; ++i) // the upper row is pulled farther
            state.position[i].y() += 0.01;
        TearScratch scratch;
        tearOverloaded(*system, state, {}, scratch);
        QCOMPARE(state.tears.size(), std::size_t(2));
        for (const State::Tear& tear : state.tears) {
            const auto panel = std::ranges::find(system->panelKey, tear.element);
            QVERIFY(panel - system->panelKey.begin() < 4); // of two cells
        }

        made.cloth().tearLimit = 0.0;
        const auto brittle = *compile(made.scene);
        State again = stretched(*brittle, 1.0, 1.05);
        tearOverloaded(*brittle, again, {}, scratch);
        QCOMPARE(again.tears.size(), std::size_t(2));
        QCOMPARE(again.tears[0].element, brittle->panelKey[0]);
        QCOMPARE(again.tears[1].element, brittle->panelKey[1]);
    }

    // The mesh parts across the pull: below the particle all panels take the twin, above it none.
    // Nothing is lost, and nothing jumps.
    void partsAcrossThePull_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("warp") << 0.0;
        QTest::newRow("weft") << 90.0;
    }

    void partsAcrossThePull()
    {
        QFETCH(double, grain);
        Strip made = strip({4, 4, false, 0.0}, grain, 1.0);
        made.scene.settings.tearMesh = TearMesh::Split;
        made.scene.settings.tearsPerStep = 1;
        made.cloth().tearRule = TearRule::Tension;
        made.cloth().tearLimit = 300.0;
        const auto system = *compile(made.scene);
        State state = stretched(*system, 1.0, 1.05);
        TearScratch scratch;
        tearOverloaded(*system, state, {}, scratch);
        QCOMPARE(state.tears.size(), std::size_t(1));
        QCOMPARE(state.tears[0].energy, 0.0);
        const double before = energies(*system, state).total();
        QVERIFY(openTears(*system, state));
        QCOMPARE(state.splits.size(), std::size_t(1));
        const Split& split = state.splits[0];
        const auto at = [&](Key key) -> const Vec3& {
            const auto found = std::ranges::find(system->key, key);
            return state.position[std::size_t(found - system->key.begin())];
        };
        const double height = at(split.from).y();
        double below = 0.0, above = 0.0; // m, of the middles of panels
        for (std::size_t i = 0; i < system->panels.size(); ++i) {
            const auto& corner = system->panels[i].corner;
            double middle = 0.0;
            for (const int c : corner)
                middle += state.position[std::size_t(c)].y() / 3.0;
            const auto has = [&](int c) { return system->key[std::size_t(c)] == split.from; };
            if (std::ranges::none_of(corner, has))
                continue;
            QVERIFY(state.panelHold[i] > 1.0); // all at the opening wait
            const bool moves =
                std::ranges::find(split.panels, system->panelKey[i]) != split.panels.end();
            (moves ? below : above) = middle - height;
        }
        QVERIFY2(below * above < 0.0, told(below, above));

        const auto now = splitSystem(*system, state.splits, {});
        const State carried = carryOver(*system, state, *now);
        QCOMPARE(now->membranes, system->membranes);
        QVERIFY(isNear(energies(*now, carried).total(), before, 1e-9 * std::abs(before)));
        QVERIFY(isNear(totalMass(*now), totalMass(*system), 1e-12));
        QCOMPARE(carried.panelHold, state.panelHold);
        QCOMPARE(goneIn(carried), 0);
    }

    // What goes on being overloaded tears again. It waits for its load to go, which takes the time
    // in which a pull crosses a panel of the mass m, sqrt(m / E t), and the damping time: what is
    // held falls by 1/e in that time, and ends a quarter above what the panel bears.
    void waitsForItsLoadToGo_data()
    {
        QTest::addColumn<double>("timeStep");
        QTest::newRow("long steps") << 1.0 / 240.0;
        QTest::newRow("short steps") << 1e-4;
    }

    void waitsForItsLoadToGo()
    {
        QFETCH(double, timeStep);
        Strip made = strip({1, 4, false, 0.0}, 0.0, 1.0);
        made.scene.settings.timeStep = timeStep;
        made.scene.settings.tearMesh = TearMesh::Split;
        made.cloth().tearRule = TearRule::Tension;
        made.cloth().tearLimit = 100.0;
        const auto system = *compile(made.scene);
        State state = system->start;
        for (std::size_t i = 2; i < state.position.size(); ++i) // the upper cell alone is drawn
            state.position[i].y() -= 0.005;
        TearScratch scratch;
        tearOverloaded(*system, state, {}, scratch);
        QCOMPARE(state.tears.size(), std::size_t(1));
        QVERIFY(openTears(*system, state));
        const auto parted = splitSystem(*system, state.splits, {});
        State drawn = carryOver(*system, state, *parted); // a hand keeps it as it is
        int steps = 0;
        for (; drawn.tears.size() == 1 && steps < 1000; ++steps)
            tearOverloaded(*parted, drawn, {}, scratch);
        double mass = 0.0;
        for (const int corner : parted->panels[0].corner)
            mass += parted->mass[std::size_t(corner)];
        const double easing = std::sqrt(mass / stiffness) + made.cloth().dampingTime;
        const double waited = (steps - 1) * timeStep, expected = easing * std::log(1.25);
        QVERIFY2(waited >= expected && waited < expected + 2.0 * timeStep, told(waited, expected));
    }

    // A panel that holds on to nothing else cannot part; it goes, with what it held.
    void crumbs()
    {
        Strip made = strip({1, 1, true, 0.0}, 0.0, 1.0);
        made.scene.settings.tearMesh = TearMesh::Split;
        made.cloth().tearRule = TearRule::Tension;
        made.cloth().tearLimit = 300.0;
        for (Entry& entry : made.scene.items)
            if (Part* part = std::get_if<Part>(&entry.item)) {
                part->panels.resize(1);
                for (Particle& particle : part->particles)
                    particle.pinned = false;
            }
        const auto system = *compile(made.scene);
        State state = stretched(*system, 1.0, 1.05);
        const double energy = energies(*system, state).elastic;
        QVERIFY(energy > 0.0);
        TearScratch scratch;
        tearOverloaded(*system, state, {}, scratch);
        QVERIFY(!openTears(*system, state));
        QCOMPARE(goneIn(state), 1);
        QCOMPARE(state.tears[0].energy, energy);
    }

    // An edit in flight comes to what a compile of the edited scene does.
    void limitsMayChangeInFlight()
    {
        Strip made = strip(coarse, 0.0, 1.0);
        LiveSystem live(made.scene);
        const auto take = [&] {
            auto update = live.update(2, 1);
            return std::get<Update>(std::move(update));
        };
        Simulation simulation(take().system);
        const auto set = [&](const char* key, Value value) {
            live.apply({Message("Edit"),
                        {SetValues{findProperty(Kind::Material, key), {made.material}, {value}}}});
            simulation.load(take());
            const auto compiled = compile(live.scene(), 2, 1);
            QVERIFY(bool(compiled));
            QVERIFY(simulation.system() == **compiled);
        };
        set("tearRule", std::string("tension"));
        set("tearLimit", 5.0);
        QCOMPARE(simulation.system().clothTear[1], (FabricTear{TearRule::Tension, 5.0, 5.0}));
        set("tearRule", std::string("strength"));
        set("weftStrength", 7.0);
        QCOMPARE(simulation.system().clothTear[1],
                 (FabricTear{TearRule::Tension, FabricTear::unbreakable, 7.0}));
    }

    // Threads tear at the tension times their width, lines at their strength; a limit of a link's
    // own is a force.
    void linksTearBySuchRules()
    {
        Material material;
        material.tearRule = TearRule::Tension;
        material.tearLimit = 300.0;
        const TearLimit never{TearRule::Never, 0.0};
        QCOMPARE(linkTearOf(material, LinkRole::Thread, 0.02, {}),
                 (TearLimit{TearRule::Force, 6.0}));
        QCOMPARE(linkTearOf(material, LinkRole::Bias, 0.02, {}), never);
        QCOMPARE(linkTearOf(material, LinkRole::Line, 0.0, {}), never);
        QCOMPARE(linkTearOf(material, LinkRole::Line, 0.0, 8.0), (TearLimit{TearRule::Force, 8.0}));
        material.tearRule = TearRule::Strength;
        QCOMPARE(linkTearOf(material, LinkRole::Line, 0.0, {}), never);
        material.lineStrength = 450.0;
        QCOMPARE(linkTearOf(material, LinkRole::Line, 0.0, {}),
                 (TearLimit{TearRule::Force, 450.0}));
        QCOMPARE(linkTearOf(material, LinkRole::Thread, 0.02, {}), never);
        QCOMPARE(linkTearOf(material, LinkRole::Line, 0.0, 8.0), (TearLimit{TearRule::Force, 8.0}));
    }

    void saysWhatCannotTear()
    {
        const auto said = [](const Scene& scene) {
            std::string all;
            for (const Finding& finding : problemsOf(scene, 10))
                all += finding.message.english() + "\n";
            return all;
        };
        const auto has = [&](Strip& made, const char* words) {
            return said(made.scene).find(words) != std::string::npos;
        };
        Strip made = strip(coarse, 0.0, 1.0);
        Material& cloth = made.cloth();
        for (const TearRule rule : {TearRule::Never, TearRule::Strain, TearRule::Tension}) {
            cloth.tearRule = rule;
            QVERIFY(!has(made, "tear"));
        }
        for (const TearRule rule : {TearRule::Length, TearRule::Force}) {
            cloth.tearRule = rule;
            QVERIFY(has(made, "Choose tension, strength or strain"));
        }
        cloth.tearRule = TearRule::Strength;
        QVERIFY(has(made, "Type its warp and weft strength"));
        cloth.warpStrength = 400.0;
        QVERIFY(has(made, "no weft strength"));
        cloth.warpStrength.reset();
        cloth.weftStrength = 400.0;
        QVERIFY(has(made, "no warp strength"));
        cloth.warpStrength = 400.0;
        QVERIFY(!has(made, "tear"));

        for (Entry& entry : made.scene.items)
            if (Part* part = std::get_if<Part>(&entry.item)) {
                Link line;
                line.id = takeId(made.scene);
                line.from = part->particles[0].id;
                line.to = part->particles[1].id;
                line.material = made.material;
                line.kind = LinkKind::Rod;
                line.restLength = width / 2.0;
                part->links.push_back(line);
                break;
            }
        QVERIFY(has(made, "has no line strength"));
        made.cloth().tearRule = TearRule::Tension;
        QVERIFY(has(made, "a line has no width"));
        made.cloth().tearRule = TearRule::Strength;
        made.cloth().lineStrength = 450.0;
        QVERIFY(!has(made, "tear"));
    }
};

const RegisteredTest registered("test_panel_tearing", runPlain<TestPanelTearing>);

} // namespace ripstop::test_panel_tearing
#include "test_panel_tearing.moc"
