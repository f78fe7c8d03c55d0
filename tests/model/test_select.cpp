// Selections from selections: counts follow from the geometry of a sheet of n x n particles.
//
// Stages: growing, shrinking, connected parts, edges and loops; other kinds, similar things and
// groups; then conditions, on elements, items and measured quantities, with the words for wrong
// ones; and the time on a large sheet.
#include "builders/builder.h"
#include "registered_test.h"
#include "scene/units.h"
#include "select/condition.h"
#include "select/group.h"
#include "select/select.h"

#include <QtTest>

#include <algorithm>
#include <ctime>
#include <numbers>
#include <set>

namespace ripstop::test_select {

namespace {

constexpr int n = 7; // particles along each side of the sheet

// A sheet in the xy plane, one metre from particle to particle, with structural springs of one
// material, bend springs over two cells of another, and panels cut along one diagonal; and apart
// from it a rope of four particles.
struct Sheet
{
    Scene scene;
    Id sheet, rope;
    Id structural, bend, line, cloth;
    std::vector<Id> rows, columns; // structural springs along x, along y
    std::vector<Id> ropeLinks;

    Sheet()
    {
        Part part, other;
        part.name = "sheet";
        other.name = "rope";
        std::uint32_t id = 1;
        const auto take = [&] { return Id{id++}; };
        sheet = take();
        rope = take();
        const auto material = [&](Id& place, const char* name) {
            place = take();
            Material made;
            made.name = name;
            scene.items.push_back({place, made});
        };
        material(structural, "structural");
        material(bend, "bend");
        material(line, "line");
        material(cloth, "cloth");
        first = id;
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column)
                part.particles.push_back({.id = take(), .position = Vec3(column, row, 0)});
        const auto spring = [&](Part& to, Id a, Id b, Id of, double length) {
            Link link;
            link.id = take();
            link.from = a;
            link.to = b;
            link.material = of;
            link.kind = LinkKind::Spring;
            link.restLength = length;
            to.links.push_back(link);
            return link.id;
        };
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                if (column + 1 < n)
                    rows.push_back(
                        spring(part, at(row, column), at(row, column + 1), structural, 1.0));
                if (row + 1 < n)
                    columns.push_back(
                        spring(part, at(row, column), at(row + 1, column), structural, 1.0));
                if (column + 2 < n)
                    spring(part, at(row, column), at(row, column + 2), bend, 2.0);
            }
        for (int row = 0; row + 1 < n; ++row)
            for (int column = 0; column + 1 < n; ++column) {
                part.panels.push_back(
                    {take(), at(row, column), at(row, column + 1), at(row + 1, column + 1), cloth});
                part.panels.push_back(
                    {take(), at(row, column), at(row + 1, column + 1), at(row + 1, column), cloth});
            }
        for (int i = 0; i < 4; ++i)
            other.particles.push_back({.id = take(), .position = Vec3(20.0, i, 0), .mass = 0.5});
        for (int i = 0; i < 3; ++i) {
            ropeLinks.push_back(
                spring(other, other.particles[i].id, other.particles[i + 1].id, line, 1.0));
            other.links.back().kind = LinkKind::Rod;
        }
        other.particles.back().pinned = true;
        scene.items.insert(scene.items.begin(), {{sheet, part}, {rope, other}});
        scene.nextId = Id{id};
    }

    Id at(int row, int column) const { return Id(first + std::uint32_t(row * n + column)); }
    const Part& part() const { return *findItem<Part>(scene, sheet); }
    const Part& ropePart() const { return *findItem<Part>(scene, rope); }

    std::uint32_t first;
};

struct Counts
{
    std::size_t particles, links, panels;
    friend bool operator==(const Counts&, const Counts&) = default;
};

Counts countsOf(const Scene& scene, const std::vector<Id>& ids)
{
    const Elements elements = sortedElements(scene, ids);
    return {elements.particles.size(), elements.links.size(), elements.panels.size()};
}

std::vector<Id> sorted(std::vector<Id> ids)
{
    std::ranges::sort(ids);
    return ids;
}

template <typename Rows>
std::vector<Id> idsOf(const Rows& rows)
{
    std::vector<Id> ids;
    for (const auto& row : rows)
        ids.push_back(row.id);
    return ids;
}

// The message of a condition that must fail.
QString complaint(const char* condition)
{
    const Sheet sheet;
    const auto found = matching(sheet.scene, {}, condition);
    return found ? QString() : QString::fromStdString(found.message().english());
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

} // namespace

class TestSelect : public QObject
{
    Q_OBJECT

private slots:
    // On panels cut along one diagonal an inner particle has six neighbours, and the next ring has
    // twelve. Bend springs over two cells are not a way.
    void growingAndShrinkingGoRingByRing()
    {
        const Sheet s;
        const std::vector<Id> seed{s.at(3, 3)};
        const std::vector<Id> once = grown(s.scene, seed);
        QCOMPARE(once.size(), std::size_t(7));
        const std::vector<Id> twice = grown(s.scene, once);
        QCOMPARE(twice.size(), std::size_t(19));
        QCOMPARE(shrunk(s.scene, twice), once);
        QCOMPARE(shrunk(s.scene, once), seed);
        QVERIFY(shrunk(s.scene, seed).empty());
        QVERIFY(grown(s.scene, {}).empty());

        // a rope grows by its links
        const Part& rope = s.ropePart();
        QCOMPARE(grown(s.scene, {rope.particles[0].id}).size(), std::size_t(2));
        QCOMPARE(grown(s.scene, {s.ropeLinks[0]}).size(), std::size_t(2));
        // all of it has nothing beside it that is not selected
        QCOMPARE(shrunk(s.scene, {s.rope}).size(), std::size_t(4 + 3));
    }

    void panelsGrowByCorners()
    {
        const Sheet s;
        // a corner of the sheet has the two panels of its cell; the three corners of one of them
        // are shared with panels of the next cells
        const Id corner = s.part().panels.front().id;
        std::set<Id> expected;
        const Panel& seed = s.part().panels.front();
        for (const Panel& panel : s.part().panels)
            for (const Id a : {panel.a, panel.b, panel.c})
                if (a == seed.a || a == seed.b || a == seed.c)
                    expected.insert(panel.id);
        QCOMPARE(grown(s.scene, {corner}), std::vector<Id>(expected.begin(), expected.end()));
        QCOMPARE(shrunk(s.scene, grown(s.scene, {corner})).size(), std::size_t(1));
    }

    void connectedGivesThePart()
    {
        const Sheet s;
        QCOMPARE(connected(s.scene, {s.at(0, 0)}), elementsOf(s.scene, {s.sheet}));
        QCOMPARE(connected(s.scene, {s.ropeLinks[1]}), elementsOf(s.scene, {s.rope}));
        QCOMPARE(connected(s.scene, {s.part().panels[5].id}), elementsOf(s.scene, {s.sheet}));
        QVERIFY(connected(s.scene, {}).empty());
        QCOMPARE(connected(s.scene, {s.at(2, 2), s.ropeLinks[0]}),
                 elementsOf(s.scene, {s.sheet, s.rope}));
    }

    void boundaryIsTheEdgeOfTheFabric()
    {
        const Sheet s;
        QCOMPARE(countsOf(s.scene, boundary(s.scene, {})), (Counts{4 * (n - 1), 4 * (n - 1), 0}));
        // the edge of one cell is its four corners; its diagonal is inside, and is no link
        const std::vector<Id> cell{s.part().panels[0].id, s.part().panels[1].id};
        QCOMPARE(countsOf(s.scene, boundary(s.scene, cell)), (Counts{4, 4, 0}));
    }

    void loopsFollowRowsAndEdges()
    {
        const Sheet s;
        // a spring of an inner row: its row, from edge to edge
        const auto inRow = [&](int row) {
            return std::vector<Id>(s.rows.begin() + row * (n - 1),
                                   s.rows.begin() + (row + 1) * (n - 1));
        };
        QCOMPARE(loop(s.scene, {inRow(3)[2]}), inRow(3));
        // one of the edge: all around
        QCOMPARE(countsOf(s.scene, loop(s.scene, {inRow(0)[2]})), (Counts{0, 4 * (n - 1), 0}));
        // two neighbours: the particles of their row
        QCOMPARE(countsOf(s.scene, loop(s.scene, sorted({s.at(2, 2), s.at(2, 3)}))),
                 (Counts{n, 0, 0}));
        // a particle of the edge: the edge; one inside says nothing about a direction
        QCOMPARE(countsOf(s.scene, loop(s.scene, {s.at(0, 3)})), (Counts{4 * (n - 1), 0, 0}));
        QCOMPARE(loop(s.scene, {s.at(3, 3)}), std::vector{s.at(3, 3)});
        // a rope from end to end
        QCOMPARE(loop(s.scene, {s.ropeLinks[1]}), s.ropeLinks);
        QCOMPARE(loop(s.scene, {s.ropePart().particles[1].id}), idsOf(s.ropePart().particles));
    }

    // An edge is followed along its panels, whether or not links run there; of two particles on it
    // the shorter stretch is taken, from corner to corner.
    void loopsFollowEdgesOfPanels()
    {
        for (const bool hasLinks : {true, false}) {
            Sheet s;
            if (!hasLinks)
                std::get<Part>(*findItem(s.scene, s.sheet)).links.clear();
            QCOMPARE(countsOf(s.scene, loop(s.scene, {s.at(0, 3)})), (Counts{4 * (n - 1), 0, 0}));
            QCOMPARE(countsOf(s.scene, loop(s.scene, sorted({s.at(0, 3), s.at(0, 4)}))),
                     (Counts{4 * (n - 1), 0, 0}));
            std::vector<Id> foot, corner;
            for (int column = 0; column < n; ++column)
                foot.push_back(s.at(0, column));
            QCOMPARE(loop(s.scene, {s.at(0, 0), s.at(0, n - 1)}), sorted(foot));
            QCOMPARE(loop(s.scene, sorted({s.at(0, 1), s.at(1, 0)})),
                     sorted({s.at(0, 0), s.at(0, 1), s.at(1, 0)}));
            QCOMPARE(loop(s.scene, {s.at(3, 3)}), std::vector{s.at(3, 3)});
        }
    }

    void invertedAreTheOthersOfTheKinds()
    {
        const Sheet s;
        QCOMPARE(countsOf(s.scene, inverted(s.scene, {s.at(0, 0)})), (Counts{n * n + 3, 0, 0}));
        QCOMPARE(inverted(s.scene, {}), everyElement(s.scene).ids());
        QVERIFY(inverted(s.scene, everyElement(s.scene).ids()).empty());
    }

    void placesTurnIntoOtherKinds()
    {
        const Sheet s;
        const std::vector<Id> cell{s.part().panels[0].id, s.part().panels[1].id};
        const std::vector<Id> corners = turnedInto(Kind::Particle, s.scene, cell);
        QCOMPARE(corners, sorted({s.at(0, 0), s.at(0, 1), s.at(1, 0), s.at(1, 1)}));
        QCOMPARE(turnedInto(Kind::Panel, s.scene, corners), cell);
        QCOMPARE(turnedInto(Kind::Link, s.scene, corners).size(), std::size_t(4));
    }

    void theSimilarAreFound()
    {
        const Sheet s;
        const auto of = [&](Alike alike, Id id) {
            return countsOf(s.scene, similar(alike, s.scene, {id}));
        };
        const std::size_t structural = 2 * n * (n - 1);
        const std::size_t bends = n * (n - 2);
        QCOMPARE(of(Alike::Material, s.rows[0]), (Counts{0, structural, 0}));
        QCOMPARE(of(Alike::Type, s.rows[0]), (Counts{0, structural + bends, 0}));
        QCOMPARE(of(Alike::Type, s.ropeLinks[0]), (Counts{0, 3, 0}));
        QCOMPARE(of(Alike::Type, s.ropePart().particles.back().id), (Counts{1, 0, 0}));
        QCOMPARE(of(Alike::Measure, s.rows[0]), (Counts{0, structural + 3, 0}));
        QCOMPARE(of(Alike::Measure, s.ropePart().particles[0].id), (Counts{4, 0, 0}));
        QCOMPARE(of(Alike::Part, s.ropeLinks[0]), (Counts{0, 3, 0}));
        QCOMPARE(of(Alike::Part, s.at(0, 0)), (Counts{n * n, 0, 0}));
    }

    void itemsStandForTheirElements()
    {
        Sheet s;
        QCOMPARE(countsOf(s.scene, {s.rope}), (Counts{4, 3, 0}));
        QCOMPARE(countsOf(s.scene, {s.line}), (Counts{0, 3, 0}));
        // rows that are lost and ids of nothing harm nobody
        (void)apply(s.scene,
                    {Message(), {RemoveRows{s.rope, {s.ropePart().particles[1].id}, {}, {}}}});
        for (const auto& from : {grown, shrunk, connected, loop, boundary, inverted})
            (void)from(s.scene, {s.sheet, s.rope, s.ropeLinks[0], Id{4000000}});
        QVERIFY(grown(Scene{}, {Id{5}}).empty());
    }

    void groupsAreMadeAndChangedInOneStep()
    {
        Sheet s;
        const Scene before = s.scene;
        const std::vector<Id> edge = boundary(s.scene, {});
        const Id id = s.scene.nextId;
        const Edit undo = apply(s.scene, grouped(s.scene, "edge", edge));
        QCOMPARE(findItem<Group>(s.scene, id)->members, edge);
        QCOMPARE(freeName(s.scene, "edge"), std::string("edge 2"));

        (void)apply(s.scene, addedToGroup(s.scene, id, {s.rope}));
        QCOMPARE(findItem<Group>(s.scene, id)->members.size(), edge.size() + 7);
        QVERIFY(addedToGroup(s.scene, id, {s.rope}).changes.empty()); // they are in it
        (void)apply(s.scene, removedFromGroup(s.scene, id, edge));
        QCOMPARE(findItem<Group>(s.scene, id)->members, elementsOf(s.scene, {s.rope}));
        QVERIFY(removedFromGroup(s.scene, id, edge).changes.empty());

        (void)apply(s.scene, undo);
        QCOMPARE(s.scene.items, before.items);
    }

    void conditionsFind_data()
    {
        QTest::addColumn<QString>("condition");
        QTest::addColumn<int>("particles");
        QTest::addColumn<int>("links");
        QTest::addColumn<int>("panels");
        const int structural = 2 * n * (n - 1), bends = n * (n - 2), panels = 2 * (n - 1) * (n - 1);
        const auto row = [](const char* text, int a, int b, int c) {
            QTest::newRow(text) << QString(text) << a << b << c;
        };
        row("mass > 100 g", 4, 0, 0);
        row("mass>0,1kg", 4, 0, 0);
        row("mass = 0.5", 4, 0, 0);
        row("mass < 0.1 lb", n * n, 0, 0); // 45 g
        row("position.x >= 20 m", 4, 0, 0);
        row("particle.position.y < 50 cm", n + 1, 0, 0);
        row("restLength > 1500 mm", 0, bends, 0);
        row("restLength <= 1", 0, structural + 3, 0);
        row("Rest length > 1500 mm", 0, bends, 0);
        row("kind = spring and rest length <= 1", 0, structural, 0);
        row("pinned", 1, 0, 0);
        row("not pinned", n * n + 3, 0, 0);
        row("pinned = no", n * n + 3, 0, 0);
        row("kind = rod", 0, 3, 0);
        row("kind != rod", 0, structural + bends, 0);
        row("material = cloth", 0, 0, panels);
        row("material != cloth", 0, structural + bends + 3, 0);
        row("material = line", 0, 3, 0);
        row("stiffness = 100", 0, structural + bends + 3, 0); // which the materials say
        row("stiffness > 0.2 N/mm", 0, 0, 0);
        row("part = rope", 4, 3, 0);
        row("part = rope and pinned", 1, 0, 0);
        row("restLength = 1 and kind = spring", 0, structural, 0);
        row("role = line", 0, structural + bends + 3, 0);
    }
    void conditionsFind()
    {
        QFETCH(QString, condition);
        QFETCH(int, particles);
        QFETCH(int, links);
        QFETCH(int, panels);
        const Sheet s;
        const auto found = matching(s.scene, {}, condition.toStdString());
        QVERIFY2(found, found ? "" : found.message().english().c_str());
        QCOMPARE(countsOf(s.scene, *found),
                 (Counts{std::size_t(particles), std::size_t(links), std::size_t(panels)}));
    }

    void itemsHavePropertiesToo()
    {
        const Sheet s;
        QCOMPARE(*matching(s.scene, {}, "name = rope"), std::vector{s.rope});
        QCOMPARE(matching(s.scene, {}, "material.stiffness > 50")->size(), std::size_t(4));
    }

    void measuredThingsAreFound()
    {
        const Sheet s;
        const std::array keys{Measurement::Key{"strain", "%", "", Kinds{Kind::Link}}};
        const Measurement measurement{
            keys, [&](const Measurement::Key&, Kind) {
                return Measurement::Reading{{s.ropeLinks[2], s.ropeLinks[0]}, {6.0, 4.0}};
            }};
        QCOMPARE(*matching(s.scene, measurement, "strain > 5 %"), std::vector{s.ropeLinks[2]});
        QCOMPARE(*matching(s.scene, measurement, "strain > 0"),
                 (std::vector{s.ropeLinks[0], s.ropeLinks[2]}));
        QCOMPARE(*matching(s.scene, measurement, "strain >= 6 and kind = rod"),
                 std::vector{s.ropeLinks[2]});
    }

    // The message says where, and what could be there instead.
    void wrongConditionsAreExplained_data()
    {
        QTest::addColumn<QString>("condition");
        QTest::addColumn<int>("place");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* text, int place, const char* says) {
            QTest::newRow(*text ? text : "nothing") << QString(text) << place << QString(says);
        };
        row("", 1, "mass < 1 g");
        row("< 5", 1, "a property is missing");
        row("mas < 1 g", 1, "mass");
        row("mass", 5, "is a number");
        row("mass <", 7, "a value is missing");
        row("mass < heavy", 8, "\"heavy\" is not a number");
        row("mass < 1 mm", 10, "\"mm\" is not a unit of mass; use one of kg");
        row("mass 5", 6, "expected <");
        row("pinned > 1", 8, "= or !=");
        row("not mass < 1", 5, "!=");
        row("kind = sprig", 8, "spring");
        row("material = clot", 12, "cloth");
        row("position > 2 m", 1, "position.x");
        row("mass.y > 2", 1, "no x, y or z");
        row("mass < 1 g and", 15, "a property is missing");
        row("mass < 1 g and leng > 2", 16, "nothing has a \"leng\"");
        row("members = 3", 1, "a list");
        row("strain > 5 %", 1, "nothing has"); // without a measurement
    }
    void wrongConditionsAreExplained()
    {
        QFETCH(QString, condition);
        QFETCH(int, place);
        QFETCH(QString, says);
        const QString said = complaint(qPrintable(condition));
        QVERIFY2(said.startsWith(QString("At character %1: ").arg(place)), qPrintable(said));
        QVERIFY2(said.contains(says), qPrintable(said));
    }

    void unitsAreExact()
    {
        QCOMPARE(*unitFactor("g", "kg"), 1e-3);
        QCOMPARE(*unitFactor("km/h", "m/s"), 1 / 3.6);
        QCOMPARE(*unitFactor("%", ""), 0.01);
        QCOMPARE(*unitFactor("g/m\u00b2", "kg/m\u00b2"), 1e-3);
        QCOMPARE(*unitFactor("g/m^2", "kg/m^2"), 1e-3);
        QCOMPARE(*unitFactor("rad", "degrees"), 180.0 / std::numbers::pi);
        QVERIFY(!unitFactor("g", "m") && !unitFactor("furlong", "m"));
    }

    // On the cloth of 316 x 316 particles: what two of them find, and how long each takes. The
    // times are figures to read, not to judge by, as another machine is another figure.
    void largeSheets()
    {
        const auto built =
            build(*findBuilder("cloth"), {{"columns", 315}, {"rows", 315}, {"sphere", 0}});
        QVERIFY(built);
        const Scene& scene = *built;
        const Elements all = everyElement(scene);
        QCOMPARE(all.particles.size(), std::size_t(316 * 316));
        const std::vector<Id> whole = all.ids();
        std::vector<Id> half;
        for (const Particle* particle : all.particles)
            if (particle->position.x() < 0.0)
                half.push_back(particle->id);
        const std::vector<Id> link{all.links[all.links.size() / 2]->id};
        const auto time = [&](const char* what, const auto& run) {
            double best = 1e9; // others on the machine make it longer and never shorter
            for (int i = 0; i < 3; ++i) {
                const double start = cpuSeconds();
                run();
                best = std::min(best, cpuSeconds() - start);
            }
            qInfo("%-28s %6.1f ms", what, 1e3 * best);
        };
        qInfo("%zu particles, %zu links, %zu panels", all.particles.size(), all.links.size(),
              all.panels.size());
        time("grow half", [&] { (void)grown(scene, half); });
        time("grow all", [&] { (void)grown(scene, whole); });
        time("shrink half", [&] { (void)shrunk(scene, half); });
        std::size_t count = 0;
        time("connected", [&] { count = connected(scene, {half.front()}).size(); });
        QCOMPARE(count, whole.size());
        time("invert half", [&] { (void)inverted(scene, half); });
        time("loop", [&] { (void)loop(scene, link); });
        time("boundary", [&] { count = boundary(scene, {}).size(); });
        QCOMPARE(count, std::size_t(2 * 4 * 315)); // particles and links
        time("turn half into panels", [&] { (void)turnedInto(Kind::Panel, scene, half); });
        time("same material", [&] { (void)similar(Alike::Material, scene, link); });
        time("same measure", [&] { (void)similar(Alike::Measure, scene, link); });
        time("same part", [&] { (void)similar(Alike::Part, scene, link); });
        for (const char* condition :
             {"mass < 1 g", "restLength > 1 mm", "stiffness > 1", "kind = spring",
              "material = structural", "position.y > 1 and not pinned"})
            time(condition, [&] { (void)matching(scene, {}, condition); });
    }
};

const RegisteredTest registered("test_select", runPlain<TestSelect>);

} // namespace ripstop::test_select
#include "test_select.moc"
