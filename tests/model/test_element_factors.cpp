// Factors of stiffness and strength that single links and panels have: what stretches and breaks
// by them, that margins know them, and that files, copies, mirrors and splits keep them.
#include "compile/compile.h"
#include "derived/flat_panel.h"
#include "io/scene_file.h"
#include "measure/margins.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"
#include "scene/particle_of.h"
#include "scene/usage.h"
#include "select/elements.h"
#include "shaping/copy.h"
#include "shaping/split.h"
#include "simulation/simulation.h"
#include "tearing/tearing.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_element_factors {

namespace {

constexpr StripMesh mesh{4, 8, false, 0.0};

Part& partOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

// Calls change(panel) for those of which the middle is between two heights, m from the upper edge.
template <typename Change>
void forPanels(Scene& scene, double from, double to, Change change)
{
    Part& part = partOf(scene);
    for (Panel& panel : part.panels) {
        double depth = 0.0;
        for (const Id corner : {panel.a, panel.b, panel.c})
            depth -= findRow(part.particles, corner)->position.y() / 3.0;
        if (depth > from && depth < to)
            change(panel);
    }
}

// How long a thread of stiffness E t is over its length at rest, pulled by T per flat width:
// s E t (s^2 - 1) / 2 = T.
double stretchUnder(double pull, double stiffness)
{
    double s = 1.0;
    for (int i = 0; i < 50; ++i)
        s -= (0.5 * stiffness * s * (s * s - 1.0) - pull) / (0.5 * stiffness * (3.0 * s * s - 1.0));
    return s;
}

// Two links of 1 m in a row under 100 N, EA = 10 kN.
Scene chain(LinkKind kind)
{
    Scene scene;
    Material line;
    line.axialStiffness = 1e4;
    line.damping = 100.0;
    line.dampingTime = 0.02;
    line.lineStrength = 400.0;
    const Id material = takeId(scene);
    scene.items.push_back({material, line});
    Part part;
    for (int i = 0; i < 3; ++i)
        part.particles.push_back({.id = takeId(scene),
                                  .position = Vec3(0.0, -i, 0.0),
                                  .mass = i == 2 ? 100.0 / standardGravity : 1e-3,
                                  .pinned = i == 0});
    for (std::size_t i = 0; i < 2; ++i)
        part.links.push_back({.id = takeId(scene),
                              .from = part.particles[i].id,
                              .to = part.particles[i + 1].id,
                              .material = material,
                              .kind = kind});
    scene.items.push_back({takeId(scene), part});
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 10.0;
    scene.settings.accuracy = 0.01;
    return scene;
}

const Rod& rodOf(const System& system, std::size_t link)
{
    return system.rods[std::size_t(system.links[link].index)];
}

State stretched(const System& system, double stretch)
{
    State state = system.start;
    for (PaddedVec3& place : state.position)
        place.y() *= stretch;
    return state;
}

} // namespace

class TestElementFactors : public QObject
{
    Q_OBJECT

private slots:
    // Two halves in a row: the same pull stretches the one by what its own stiffness gives.
    void aStripStretchesLikeSpringsInARow()
    {
        constexpr double load = 20.0; // N
        Strip made = strip(mesh, 0.0, load);
        made.scene.settings.accuracy = 0.01;
        forPanels(made.scene, 0.25 * length, 0.75 * length,
                  [](Panel& panel) { panel.stiffnessFactor = 2.0; });
        Simulation simulation(*compile(made.scene));
        simulation.runUntil(3.0);
        const double expected = 0.5 * length
                                * (stretchUnder(load / width, stiffness)
                                   + stretchUnder(load / width, 2.0 * stiffness) - 2.0);
        const double got = -simulation.state().position.back().y() - length;
        QVERIFY2(isNear(got, expected, 1e-3 * expected), told(got, expected));
    }

    // F L / EA in one link, half of that in one that is twice as stiff; what is its own, 5 kN/m,
    // stays as it is.
    void linksStretchByTheirFactors_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("rods") << int(LinkKind::Rod);
        QTest::newRow("springs") << int(LinkKind::Spring);
    }

    void linksStretchByTheirFactors()
    {
        QFETCH(int, kind);
        Scene scene = chain(LinkKind(kind));
        Link& lower = partOf(scene).links[1];
        lower.stiffnessFactor = 2.0;
        const auto sag = [&] {
            Simulation simulation(*compile(scene));
            simulation.runUntil(6.0);
            return -simulation.state().position[2].y() - 2.0;
        };
        QVERIFY2(isNear(sag(), 0.015, 2e-5), told(sag(), 0.015));
        lower.stiffness = 5e3;
        lower.compliance = 1.0 / 5e3;
        QVERIFY2(isNear(sag(), 0.03, 4e-5), told(sag(), 0.03));
        const Property& property = propertyOf<&Link::stiffnessFactor>();
        QVERIFY(whyIdle(scene, usageOf(scene), property, lower.id).has_value());
    }

    // A row of half the strength breaks at half of what the others bear, and nothing else does.
    void aWeakRowBreaksFirst()
    {
        constexpr double stretch = 1.02;
        const double pull = stretch * 0.5 * stiffness * (stretch * stretch - 1.0); // N/m
        for (const double bears : {1.998 * pull, 2.002 * pull}) {
            Strip made = strip(mesh, 0.0, 1.0);
            made.cloth().tearRule = TearRule::Strength;
            made.cloth().warpStrength = bears;
            std::vector<Id> weak;
            forPanels(made.scene, 3.0 * length / 8.0, 4.0 * length / 8.0, [&](Panel& panel) {
                panel.strengthFactor = 0.5;
                weak.push_back(panel.id);
            });
            QCOMPARE(weak.size(), std::size_t(2 * mesh.across));
            const auto system = *compile(made.scene);
            State state = stretched(*system, stretch);
            TearScratch scratch;
            tearOverloaded(*system, state, {}, scratch);
            if (bears > 2.0 * pull) {
                QVERIFY(state.tears.empty());
                continue;
            }
            QCOMPARE(state.tears.size(), weak.size());
            for (const State::Tear& tear : state.tears)
                QVERIFY(std::ranges::count(weak, Id{tear.element}) == 1);
        }
    }

    // Limits are of the material and so times the factor; a length is none of its strengths, and a
    // limit of the link's own is what was typed.
    void limitsOfLinks()
    {
        Scene scene = chain(LinkKind::Rod);
        Material& line = std::get<Material>(scene.items[0].item);
        Link& upper = partOf(scene).links[0];
        upper.strengthFactor = 0.5;
        const auto limit = [&] { return rodOf(**compile(scene), 0).tear.limit; };
        line.tearRule = TearRule::Strength;
        QCOMPARE(limit(), 200.0);
        line.tearLimit = 0.08;
        line.tearRule = TearRule::Strain;
        QCOMPARE(limit(), 0.04);
        line.tearRule = TearRule::Length;
        QCOMPARE(limit(), 0.08);
        upper.tearLimit = 0.03;
        line.tearRule = TearRule::Strain;
        QCOMPARE(limit(), 0.03);
    }

    // 100 N in a line of 400 N that is half worn through, and in a whole one.
    void marginsKnowThem()
    {
        Scene scene = chain(LinkKind::Rod);
        partOf(scene).links[0].strengthFactor = 0.5;
        Simulation simulation(*compile(scene));
        simulation.runUntil(6.0);
        const Margins found = margins(simulation.system(), simulation.state());
        QVERIFY2(isNear(found.link[0], 0.5, 1e-3), told(found.link[0], 0.5));
        QVERIFY2(isNear(found.link[1], 0.25, 1e-3), told(found.link[1], 0.25));

        Strip made = strip(mesh, 0.0, 1.0);
        made.cloth().warpStrength = 2000.0;
        partOf(made.scene).panels[0].strengthFactor = 0.25;
        const auto system = *compile(made.scene);
        const Margins ofPanels = margins(*system, stretched(*system, 1.02));
        QVERIFY2(isNear(ofPanels.panel[0], 4.0 * ofPanels.panel[1], 1e-9),
                 told(ofPanels.panel[0], 4.0 * ofPanels.panel[1]));
    }

    // A factor of 1 is nothing: the same system, and no word of it in the file.
    void whatIsNotPaintedIsAsBefore()
    {
        Strip made = strip(mesh, 0.0, 1.0);
        QVERIFY(sceneText(made.scene).find("Factor") == std::string::npos);
        QVERIFY((*compile(chain(LinkKind::Rod)))->linkFactors.empty());
        partOf(made.scene).panels[3].strengthFactor = 0.3;
        partOf(made.scene).panels[3].stiffnessFactor = 1.7;
        const std::string text = sceneText(made.scene);
        QVERIFY(text.find("\"stiffnessFactor\": 1.7") != std::string::npos);
        QVERIFY(text.find("\"strengthFactor\": 0.3") != std::string::npos);
        const Result<Scene> read = parseScene(text, "painted");
        QVERIFY(read);
        QVERIFY(*read == made.scene);
    }

    // The mirror image of a panel has the mirror image of its warp, and its factors.
    void mirrorsKeepFactorsAndGrain()
    {
        for (const double grain : {0.0, 30.0, 75.0}) {
            Strip made = strip(coarse, grain, 1.0);
            Scene& scene = made.scene;
            const Vec3 a(0.0, 0.0, 0.0), b(0.3, 0.0, 0.0), c(0.1, 0.2, 0.0);
            Part& part = partOf(scene);
            for (std::size_t i = 0; i < 3; ++i)
                part.particles[i].position = std::array{a, b, c}[i];
            part.panels = {{.id = part.panels[0].id,
                            .a = part.particles[0].id,
                            .b = part.particles[1].id,
                            .c = part.particles[2].id,
                            .material = made.material,
                            .restAB = 0.3,
                            .restBC = std::hypot(0.2, 0.2),
                            .restCA = std::hypot(0.1, 0.2),
                            .grain = grain,
                            .stiffnessFactor = 2.0,
                            .strengthFactor = 0.5}};
            part.particles.resize(3);
            const Panel original = part.panels[0];
            std::vector<Id> ids;
            for (const Particle& particle : part.particles)
                ids.push_back(particle.id);
            (void)apply(scene, mirrored(scene, ids, Vec3(-1.0, 0.0, 0.0), 0, 1e-6).edit);
            const Panel copy = partOf(scene).panels[1];
            QCOMPARE(copy.stiffnessFactor, 2.0);
            QCOMPARE(copy.strengthFactor, 0.5);
            const auto warpOf = [&](const Panel& panel) -> Vec3 {
                const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
                const auto shares = *warpShares(panel, at(panel.a), at(panel.b), at(panel.c));
                return shares[0] * (at(panel.b) - at(panel.a))
                       + shares[1] * (at(panel.c) - at(panel.a));
            };
            Vec3 expected = warpOf(original);
            expected.x() = -expected.x();
            const Vec3 got = warpOf(copy);
            QVERIFY2(std::min((got - expected).norm(), (got + expected).norm()) < 1e-12,
                     told(got, expected));
        }
    }

    // The pieces of a panel have its warp and its factors, those of a link its factors.
    void splitsKeepFactorsAndGrain()
    {
        Strip made = strip(coarse, 20.0, 1.0);
        Scene& scene = made.scene;
        Part& part = partOf(scene);
        for (Panel& panel : part.panels)
            panel.strengthFactor = 0.5;
        part.links.push_back({.id = takeId(scene),
                              .from = part.panels[0].a,
                              .to = part.panels[0].c,
                              .material = made.material,
                              .strengthFactor = 0.7});
        (void)apply(scene, linksSplit(scene, {part.links[0].id}, 3, 1e-3).edit);
        const Part& after = partOf(scene);
        QCOMPARE(after.links.size(), std::size_t(3));
        for (const Link& link : after.links)
            QCOMPARE(link.strengthFactor, 0.7);
        const Vec3 warp(std::sin(20.0 * M_PI / 180.0), -std::cos(20.0 * M_PI / 180.0), 0.0);
        for (const Panel& panel : after.panels) {
            QCOMPARE(panel.strengthFactor, 0.5);
            const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
            const double expected = grainAlong(at(panel.a), at(panel.b), at(panel.c), warp);
            const double off = std::remainder(panel.grain - expected, 180.0);
            QVERIFY2(isNear(off, 0.0, 1e-9), told(panel.grain, expected));
        }
    }

    // In flight: another system of the same motion, in which the pull is what the new factor says.
    void editsReachARun()
    {
        Scene scene = chain(LinkKind::Rod);
        const auto before = *compile(scene);
        partOf(scene).links[0].stiffnessFactor = 4.0;
        const auto after = *compile(scene);
        QCOMPARE(rodOf(*before, 0).compliance, 4.0 * rodOf(*after, 0).compliance);
        QCOMPARE(after->linkFactors.size(), std::size_t(2));
        QVERIFY(!(*before == *after));
    }
};

const RegisteredTest registered("test_element_factors", runPlain<TestElementFactors>);

} // namespace ripstop::test_element_factors
#include "test_element_factors.moc"
