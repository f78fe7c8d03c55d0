// Fabric of threads that becomes one of panels: it is the one that would have been imported so,
// stretches as its numbers say, keeps what is no thread and what named the threads, and can be
// taken back.
#include "author/rebuild.h"
#include "author/stability.h"
#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "derived/panel_fabric.h"
#include "derived/thread_fabric.h"
#include "measure/diagnostics.h"
#include "registered_test.h"
#include "shaping/operation.h"
#include "simulation/simulation.h"

#include "cli_call.h"
#include "first_item.h"
#include "meshes.h"
#include "systems.h"

#include <QtTest>

namespace ripstop::test_panel_fabric {

namespace {

constexpr double stiffness = 1000.0; // N/m, of plainFabric()
constexpr double gravity = 9.80665;  // m/s^2

std::vector<Id> partsOf(const Scene& scene)
{
    std::vector<Id> ids;
    forEachPart(scene, [&](Id id, const Part&) { ids.push_back(id); });
    return ids;
}

// The scene after the edit, whose inverse leads back.
Scene converted(const Scene& scene)
{
    const Result<PanelFabric> made = carriedByPanels(scene, partsOf(scene));
    if (!made)
        qFatal("%s", made.message().english().c_str());
    Scene after = scene;
    const Edit inverse = apply(after, made->edit);
    Scene back = after;
    (void)apply(back, inverse);
    if (!(back == scene))
        qFatal("not taken back");
    return after;
}

std::string refusalOf(const Scene& scene)
{
    const Result<PanelFabric> made = carriedByPanels(scene, partsOf(scene));
    return made ? "" : made.message().english();
}

// 1 m x 1 m in 4 x 4 squares or their triangles.
Scene imported(bool quads, FabricKind carrier)
{
    MeshFabric fabric = plainFabric();
    fabric.material.poissonRatio = 0.0;
    fabric.carrier = carrier;
    return sceneOf(preparedOf(meshOf(sheet(4, 0.25, quads).c_str())), fabric);
}

// Pinned along the upper edge, with `load` in kg along the lower one, shared out by width.
void hang(Scene& scene, double load)
{
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 10.0;
    for (Particle& particle : firstOf<Part>(scene).particles) {
        const Vec3& place = particle.position;
        particle.pinned = place.y() > 0.999;
        const bool isCorner = place.x() < 1e-6 || place.x() > 0.999;
        if (place.y() < 1e-6)
            particle.mass += load / (isCorner ? 8.0 : 4.0);
    }
}

const Finding* findingOf(const std::vector<Finding>& findings, std::string_view sort)
{
    const auto found = std::ranges::find(findings, sort, &Finding::sort);
    return found == findings.end() ? nullptr : &*found;
}

} // namespace

class TestPanelFabric : public QObject
{
    Q_OBJECT

private slots:
    // Choosing threads for fabric that was imported as panels makes those that the import makes of
    // triangles, in one step that can be taken back; before, nothing holds it, which is told once.
    void choosingThreadsMakesThem()
    {
        const Scene panels = imported(false, FabricKind::Panels);
        const Scene threads = imported(false, FabricKind::Threads);
        const Edit chosen{
            {},
            {SetValues{&propertyOf<&Part::carrier>(), partsOf(panels), {std::string("threads")}}}};
        Scene bare = panels;
        (void)apply(bare, chosen);
        Part& tied = firstOf<Part>(bare); // with a line, as a sail on its sheet
        const Particle& clew = tied.particles.front();
        const Particle cleat{
            .id = takeId(bare), .position = clew.position - Vec3::UnitX(), .pinned = true};
        tied.links.push_back({.id = takeId(bare),
                              .from = clew.id,
                              .to = cleat.id,
                              .material = tied.panels.front().material});
        tied.particles.push_back(cleat);
        const std::vector<Finding> problems = problemsOf(bare);
        QCOMPARE(std::ranges::count(problems, "threadless", &Finding::sort), 1);
        QVERIFY(!findingOf(problems, "loose"));
        const std::vector<Finding> findings = stabilityOf(bare);
        const Finding* const repairable = findingOf(findings, "threadless");
        QVERIFY(repairable && repairable->repair);
        (void)apply(bare, *repairable->repair);
        QVERIFY(!findingOf(problemsOf(bare), "threadless"));

        Scene made = panels;
        const Edit inverse = apply(made, threaded(panels, chosen));
        const Part &part = firstPart(made), expected = firstPart(threads);
        QVERIFY(part.carrier == FabricKind::Threads);
        QCOMPARE(part.links.size(), expected.links.size());
        for (std::size_t i = 0; i < part.links.size(); ++i) {
            const Link &link = part.links[i], &like = expected.links[i];
            QVERIFY(link.from == like.from && link.to == like.to && link.kind == like.kind);
            QVERIFY(link.role == LinkRole::Thread && link.material == like.material);
            QVERIFY(std::abs(link.restLength - like.restLength) < 1e-12);
            QVERIFY(std::abs(link.width - like.width) < 1e-12);
        }
        QCOMPARE(problemsOf(made).size(), problemsOf(threads).size());
        (void)apply(made, inverse);
        QVERIFY(made.items == panels.items);
    }

    // Particles, cut and material are those of the import with panels; only ids differ, which are
    // drawn for the threads as well. So both fly with the same bits.
    void isWhatIsImportedWithPanels_data()
    {
        QTest::addColumn<bool>("quads");
        QTest::newRow("quads") << true;
        QTest::newRow("triangles") << false;
    }
    void isWhatIsImportedWithPanels()
    {
        QFETCH(bool, quads);
        Scene made = converted(imported(quads, FabricKind::Threads));
        Scene direct = imported(quads, FabricKind::Panels);
        const Part &part = firstPart(made), expected = firstPart(direct);
        QVERIFY(part.links.empty());
        QVERIFY(part.carrier == FabricKind::Panels);
        QVERIFY(part.particles == expected.particles);
        QCOMPARE(part.panels.size(), expected.panels.size());
        for (std::size_t i = 0; i < part.panels.size(); ++i) {
            Panel panel = part.panels[i];
            panel.id = expected.panels[i].id;
            QVERIFY(panel == expected.panels[i]);
        }
        QVERIFY(firstOf<Material>(made) == firstOf<Material>(direct));
        hang(made, 1.0);
        hang(direct, 1.0);
        Simulation one(*compile(made)), other(*compile(direct));
        QVERIFY(one.runUntil(0.5) && other.runUntil(0.5));
        QCOMPARE(stateHash(one.state()), stateHash(other.state()));
    }

    // A load W at the edge of a sheet of width b and length L stretches it by W L / (E t b), here
    // by 2.45 mm for 250 g under E t = 1 kN/m; the sheet itself weighs 1 % of it where it hangs.
    void stretchesAsItsNumbersSay()
    {
        Scene scene = converted(imported(true, FabricKind::Threads));
        for (Particle& particle : firstOf<Part>(scene).particles)
            particle.mass *= 0.01;
        hang(scene, 0.25);
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(6.0));
        double lowest = 0.0;
        for (const PaddedVec3& place : simulation.state().position)
            lowest = std::min(lowest, place.y());
        const double expected = 0.25 * gravity / stiffness;
        QVERIFY2(isNear(-lowest, expected, 0.01 * expected), told(-lowest, expected));
    }

    // Where threads were worn or doubled, so are the panels beside them: all alike as one of
    // theirs, and one with sides of different threads as their mean.
    void keepsTheFactorsOfThreads()
    {
        Scene scene = imported(false, FabricKind::Threads);
        for (Link& link : firstOf<Part>(scene).links) {
            link.strengthFactor = 0.5;
            link.stiffnessFactor = 2.0;
        }
        const Panel first = firstPart(scene).panels.front();
        for (Link& link : firstOf<Part>(scene).links)
            if (std::minmax(link.from, link.to) == std::minmax(first.a, first.b))
                link.strengthFactor = 0.2;
        const Scene made = converted(scene);
        QCOMPARE(firstPart(made).panels.front().strengthFactor, 0.4); // (0.2 + 0.5 + 0.5) / 3
        for (const Panel& panel : firstPart(made).panels)
            QCOMPARE(panel.stiffnessFactor, 2.0);
        QCOMPARE(firstPart(made).panels.back().strengthFactor, 0.5);
    }

    // What is drawn or saved under load has its cut in the lengths of threads.
    void keepsTheCutOfThreads()
    {
        Scene scene = imported(false, FabricKind::Threads);
        const Scene slack = converted(scene);
        for (Particle& particle : firstOf<Part>(scene).particles)
            particle.position *= 1.02;
        const Scene made = converted(scene);
        const Part &part = firstPart(made), expected = firstPart(slack);
        for (std::size_t i = 0; i < part.panels.size(); ++i) {
            QVERIFY(isNear(part.panels[i].restAB, expected.panels[i].restAB, 1e-12));
            QVERIFY(isNear(part.panels[i].restBC, expected.panels[i].restBC, 1e-12));
            QVERIFY(isNear(part.panels[i].restCA, expected.panels[i].restCA, 1e-12));
        }
        // panels that were cut before keep their own
        Scene cut = imported(false, FabricKind::Threads);
        Panel& own = firstOf<Part>(cut).panels[3];
        own.restAB = own.restBC = own.restCA = 0.3;
        own.grain = 20.0;
        const Scene kept = converted(cut);
        QVERIFY(firstPart(kept).panels[3] == own);
        QVERIFY(firstPart(kept).panels[4].restAB > 0.0);
    }

    // Lines stay, and threads without a width, which no fabric follows from. Groups that named
    // threads name the panels beside them, and probes the part.
    void keepsWhatIsNoThread()
    {
        Scene scene = imported(true, FabricKind::Threads);
        Part& part = firstOf<Part>(scene);
        const Id hem = part.links[0].id, narrow = part.links[1].id;
        part.links[0].role = LinkRole::Line;
        part.links[1].width = 0.0;
        const Link thread = part.links[5];
        const Id id = partsOf(scene)[0];
        const Id group = addGroup(scene, "seam", {hem, thread.id});
        const Id strain = addProbe(scene, "strain", Quantity::MaxStrain, thread.id);
        const Scene made = converted(scene);
        const Part after = firstPart(made);
        QCOMPARE(after.links.size(), std::size_t(2));
        QCOMPARE(after.links[0].id, hem);
        QCOMPARE(after.links[1].id, narrow);
        const auto isBeside = [&](const Panel& panel) {
            const std::array corners{panel.a, panel.b, panel.c};
            return std::ranges::count(corners, thread.from) + std::ranges::count(corners, thread.to)
                   == 2;
        };
        std::vector<Id> members{hem};
        for (const Panel& panel : after.panels)
            if (isBeside(panel))
                members.push_back(panel.id);
        std::ranges::sort(members);
        QVERIFY(members.size() > 1);
        QVERIFY(findItem<Group>(made, group)->members == members);
        QCOMPARE(findItem<Probe>(made, strain)->target, id);
        QVERIFY(!hasErrors(problemsOf(made)));
    }

    void saysWhyNot()
    {
        Scene limp = imported(true, FabricKind::Threads);
        firstOf<Material>(limp).name = "knit";
        firstOf<Material>(limp).membraneStiffness.reset();
        const std::string said = refusalOf(limp);
        QVERIFY(said.find("knit") != std::string::npos
                && said.find("membrane stiffness") != std::string::npos);

        Scene bare = imported(true, FabricKind::Threads);
        firstOf<Part>(bare).panels.clear();
        QVERIFY(refusalOf(bare).find("no panels") != std::string::npos);

        Scene plain = imported(true, FabricKind::Threads);
        firstOf<Part>(plain).panels[2].material = noId;
        QVERIFY(refusalOf(plain).find("has no material") != std::string::npos);

        QVERIFY(refusalOf(imported(true, FabricKind::Panels)).find("no fabric of threads")
                != std::string::npos);
        QVERIFY(refusalOf(*build(*findBuilder("rope"), {})).find("no fabric of threads")
                != std::string::npos);
    }

    // What is selected says which parts.
    void isAnOperation()
    {
        Scene scene = imported(true, FabricKind::Threads);
        (void)apply(scene, importOf(preparedOf(meshOf(cubeOfQuads)), plainFabric(), scene).edit);
        const std::vector<Id> parts = partsOf(scene);
        QCOMPARE(parts.size(), std::size_t(2));
        const Operation& operation = *findOperation("panels");
        const Id thread = firstPart(scene).links[3].id;
        const Result<Shaped> shaped = operation.apply(scene, {thread}, {});
        QVERIFY(bool(shaped));
        QVERIFY(shaped->selected == std::vector<Id>{parts[0]});
        (void)apply(scene, shaped->edit);
        QVERIFY(findItem<Part>(scene, parts[0])->links.empty());
        QVERIFY(!findItem<Part>(scene, parts[1])->links.empty());
        QVERIFY(!operation.apply(scene, {}, {}));
        QVERIFY(!operation.apply(scene, {parts[0]}, {}));
    }

    // Whoever has only switched what carries the pull is told, once, and can have the threads
    // removed.
    void isTheRemedyOfThreadsBesidePanels()
    {
        Scene scene = imported(true, FabricKind::Threads);
        QVERIFY(!findingOf(stabilityOf(scene), "both"));
        firstOf<Part>(scene).carrier = FabricKind::Panels;
        const std::vector<Finding> findings = stabilityOf(scene);
        const Finding* finding = findingOf(findings, "both");
        QVERIFY(finding && finding->repair);
        QVERIFY(findingOf(problemsOf(scene), finding->sort)); // told() passes it over there
        (void)apply(scene, *finding->repair);
        QVERIFY(!findingOf(stabilityOf(scene), "both"));
        QVERIFY(!findingOf(problemsOf(scene), "both"));
        QVERIFY(firstPart(scene).links.empty());
        const Scene direct = converted(imported(true, FabricKind::Threads));
        QVERIFY(firstPart(scene) == firstPart(direct));
    }

    // A builder knows of no panels that carry: its threads come back and are told again.
    void comesBackWithItsBuilder()
    {
        Parameters parameters{{"columns", 4}, {"rows", 4}, {"membrane", stiffness}};
        Scene scene = converted(*build(*findBuilder("cloth"), parameters));
        QVERIFY(!findingOf(stabilityOf(scene), "both"));
        const Id id = partsOf(scene)[0];
        parameters = findItem<Part>(scene, id)->parameters;
        parameters["width"] = 2.0;
        const Result<Rebuilt> again = rebuilt(scene, id, parameters);
        QVERIFY(bool(again));
        (void)apply(scene, again->edit);
        const std::vector<Finding> findings = stabilityOf(scene);
        const Finding* finding = findingOf(findings, "both");
        QVERIFY(finding && finding->repair);
        (void)apply(scene, *finding->repair);
        QVERIFY(std::ranges::none_of(findItem<Part>(scene, id)->links, isOfFabric));
        QVERIFY(bool(compile(scene)));
    }

    void worksInTheTerminal()
    {
        QTemporaryDir folder;
        const auto path = [&](const char* name) { return folder.filePath(name); };
        write(path("sheet.obj"), QByteArray::fromStdString(sheet(4, 0.25, true)));
        const auto import = [&](const char* fabric, const QString& to) {
            return call({"import", path("sheet.obj"), "--unit", "m", "--fabric", fabric, "-o", to})
                .exitCode;
        };
        QCOMPARE(import("threads", path("threads.json")), 0);
        QCOMPARE(import("panels", path("panels.json")), 0);
        const Outcome made =
            call({"convert", path("threads.json"), "--fabric", "panels", "-o", path("made.json")});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        // 40 edges, two diagonals in each of 16 squares, and 32 triangles
        QVERIFY2(made.out.contains("32 panels carry what 72 threads have carried"), made.out);
        const auto flown = [&](const char* name) {
            return call({"run", path(name), "--seconds", "0.5", "--json"}).json();
        };
        QVERIFY(!flown("made.json")["hash"].toString().isEmpty());
        QCOMPARE(flown("made.json")["hash"], flown("panels.json")["hash"]);

        const auto refusal = [&](const QStringList& more, int code) {
            const Outcome outcome = call(QStringList{"convert", path("threads.json"), "--fabric",
                                                     "panels", "-o", path("not.json")}
                                         + more);
            return outcome.exitCode == code ? outcome.error : QString();
        };
        QVERIFY(refusal({"--set", "fabric.membraneStiffness="}, 1).contains("membrane stiffness"));
        QVERIFY(refusal({"--part", "sial"}, 2).contains("--part sial"));
        QVERIFY(!QFile::exists(path("not.json")));
        // the other way: 40 edges and the diagonal of each square, by either command
        const Outcome back =
            call({"convert", path("panels.json"), "--fabric", "threads", "-o", path("back.json")});
        QVERIFY2(back.out.contains("56 threads carry what 32 panels have carried"), back.out);
        const Outcome set = call({"run", path("panels.json"), "--set", "sheet.carrier=threads",
                                  "--seconds", "0.5", "--json"});
        QVERIFY2(!set.error.contains("no links"), qPrintable(set.error));
        QCOMPARE(set.json()["hash"], flown("back.json")["hash"]);
        QVERIFY(call({"convert", path("back.json"), "--fabric", "threads", "-o", path("not.json")})
                    .error.contains("has its threads already"));
        QVERIFY(call({"convert", path("made.json"), "--fabric", "panels", "-o", path("not.json")})
                    .error.contains("no fabric of threads"));
    }
};

const RegisteredTest registered("test_panel_fabric", runWithCore<TestPanelFabric>);

} // namespace ripstop::test_panel_fabric
#include "test_panel_fabric.moc"
