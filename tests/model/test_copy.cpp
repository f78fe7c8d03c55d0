// Copies, mirrors, arrays, welding, alignment and splitting (shaping/copy.h, shaping/align.h,
// shaping/operation.h).
//
// Stages: a strip of two cells with known counts is copied and mirrored, then welded, weighed,
// aligned and split; the numbers follow from counting its rows. after() checks for each edit that
// undo and redo give the scenes back and that the outcome has no error. At the end every operation
// is tried on designs of all builders, and a large design is timed.
#include "registered_test.h"
#include "shaping/copy.h"

#include "builders/builder.h"
#include "check/check.h"
#include "io/scene_file.h"
#include "scene/element_index.h"
#include "select/element_counts.h"
#include "shaping/align.h"
#include "shaping/operation.h"
#include "shaping/pin.h"
#include "shaping/split.h"
#include "shaping/spread_mass.h"
#include "shaping/weld.h"
#include "thread_time.h"
#include "views/small_scenes.h"

#include <QtTest>

#include <numbers>
#include <numeric>

namespace ripstop::test_copy {

namespace {

const Part& partOf(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = found ? found : &part; });
    return *found;
}

Vec3 placeOf(const Scene& scene, Id id)
{
    return std::get<const Particle*>(*find(scene, id))->position;
}

double massOf(const Scene& scene)
{
    double mass = 0.0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles)
            mass += row.mass;
    });
    return mass;
}

Vec3 normalOf(const Scene& scene, const Panel& row)
{
    const Vec3 a = placeOf(scene, row.a);
    return (placeOf(scene, row.b) - a).cross(placeOf(scene, row.c) - a);
}

// Applies the edit, and proves that it can be taken back and that what it leaves is sound.
Scene after(Scene scene, const Edit& edit)
{
    const Scene before = scene;
    const Edit inverse = apply(scene, edit);
    Scene undone = scene;
    (void)apply(undone, inverse);
    undone.nextId = before.nextId; // no number is used twice, not even after undo
    [&] { QVERIFY2(undone == before, "undo must give back the scene as it was"); }();
    Scene again = undone;
    (void)apply(again, edit);
    again.nextId = scene.nextId;
    [&] { QVERIFY2(again == scene, "redo must give the same"); }();
    const auto problem = firstError(scene, ElementIndex(scene));
    [&] { QVERIFY2(!problem, problem ? problem->message.english().c_str() : ""); }();
    return scene;
}

// A strip of two cells, x from 0 to 2 and y from 0 to 1, of 6 particles (2 to 7), with 7 links
// along the sides of the cells and 4 panels that face +z. Part 1, material 30, group 31 of all.
Scene strip()
{
    Scene scene;
    Part part;
    part.name = "strip";
    std::uint32_t next = 2;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 2; ++y)
            part.particles.push_back({.id = Id{next++}, .position = Vec3(x, y, 0), .mass = 0.5});
    const auto at = [](int x, int y) { return Id{std::uint32_t(2 + 2 * x + y)}; };
    for (int x = 0; x < 3; ++x)
        part.links.push_back(rod(Id{next++}, at(x, 0), at(x, 1), Id{30}));
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y)
            part.links.push_back(rod(Id{next++}, at(x, y), at(x + 1, y), Id{30}));
    for (int x = 0; x < 2; ++x) {
        part.panels.push_back({Id{next++}, at(x, 0), at(x + 1, 0), at(x + 1, 1), Id{30}});
        part.panels.push_back({Id{next++}, at(x, 0), at(x + 1, 1), at(x, 1), Id{30}});
    }
    Group group;
    group.name = "all";
    for (std::uint32_t id = 2; id < next; ++id)
        group.members.push_back(Id{id});
    scene.items = {{Id{1}, part}, {Id{30}, Material{}}, {Id{31}, group}};
    scene.nextId = Id{32};
    return scene;
}

const Group& groupOf(const Scene& scene) { return *findItem<Group>(scene, Id{31}); }

} // namespace

class TestCopy : public QObject
{
    Q_OBJECT

private slots:
    void aPartIsCopiedWithAllThatIsInIt()
    {
        const Scene scene = strip();
        const Copies copies =
            duplicated(scene, {Id{1}}, {shifted(Vec3(0, 0, 3))}, Message("Duplicate"));
        const Scene now = after(scene, copies.edit);
        QCOMPARE(copies.ids.size(), std::size_t(1));
        const Part& copy = *findItem<Part>(now, copies.ids.front());
        QCOMPARE(copy.particles.size(), std::size_t(6));
        QCOMPARE(copy.links.size(), std::size_t(7));
        QCOMPARE(copy.panels.size(), std::size_t(4));
        QCOMPARE(copy.particles[3].position, Vec3(1, 1, 3));
        QCOMPARE(massOf(now), 2.0 * massOf(scene));
        for (const Link& row : copy.links)
            QVERIFY(findRow(copy.particles, row.from) && findRow(copy.particles, row.to));
    }

    // A line from a part to another one stays with the original.
    void copiesAreNotTiedToWhatIsNotCopied()
    {
        Scene scene = strip();
        const Copies second = duplicated(scene, {Id{1}}, {shifted(Vec3(0, 0, 3))}, {});
        scene = after(scene, second.edit);
        const Id other = findItem<Part>(scene, second.ids.front())->particles.front().id;
        (void)apply(scene,
                    {{}, {AddRows{Id{1}, {}, {rod(scene.nextId, Id{2}, other, Id{30})}, {}}}});
        const Copies third = duplicated(scene, {Id{1}}, {shifted(Vec3(0, 5, 0))}, {});
        const Scene now = after(scene, third.edit);
        QCOMPARE(findItem<Part>(now, third.ids.front())->links.size(), std::size_t(7));
    }

    // Of one cell: 4 particles, the 4 links and 2 panels among them, and not what leads out.
    void elementsAreCopiedWithWhatLiesAmongThem()
    {
        const Scene scene = strip();
        const Copies copies =
            duplicated(scene, {Id{2}, Id{3}, Id{4}, Id{5}}, {shifted(Vec3(0, 0, 1))}, {});
        const Scene now = after(scene, copies.edit);
        QCOMPARE(copies.ids.size(), std::size_t(4 + 4 + 2));
        QCOMPARE(partOf(now).particles.size(), std::size_t(10));
        QCOMPARE(partOf(now).links.size(), std::size_t(11));
        QCOMPARE(partOf(now).panels.size(), std::size_t(6));
    }

    void arraysCount()
    {
        const Scene scene = strip();
        const Scene row = after(scene, linearArray(scene, {Id{1}}, 4, Vec3(0, 2, 0)).edit);
        int parts = 0;
        double highest = 0.0;
        forEachPart(row, [&](Id, const Part& part) {
            ++parts;
            highest = std::max(highest, part.particles.back().position.y());
        });
        QCOMPARE(parts, 4);
        QCOMPARE(highest, 1.0 + 3 * 2.0);

        // six around y: each a sixth of a turn further, none on the first
        const Copies ring =
            radialArray(scene, {Id{7}}, 6, Vec3::Zero(), Vec3::UnitY(), 2.0 * std::numbers::pi);
        const Scene around = after(scene, ring.edit);
        QCOMPARE(ring.ids.size(), std::size_t(5));
        Vec3 sum = placeOf(around, Id{7});
        for (const Id id : ring.ids) {
            sum += placeOf(around, id);
            QVERIFY(std::abs((placeOf(around, id) - Vec3(0, 1, 0)).norm() - 2.0) < 1e-14);
        }
        QVERIFY((sum - Vec3(0, 6, 0)).norm() < 1e-13); // corners of a hexagon cancel
        // a half turn of 3: at 0, 90 and 180 degrees
        const Copies half =
            radialArray(scene, {Id{7}}, 3, Vec3::Zero(), Vec3::UnitY(), std::numbers::pi);
        const Scene fan = after(scene, half.edit);
        QVERIFY((placeOf(fan, half.ids.back()) - Vec3(-2, 1, 0)).norm() < 1e-14);
    }

    // Mirrored at x = 0 the strip is 4 cells: 2 particles and 1 link lie on the plane.
    void aMirroredStripHangsTogether()
    {
        const Scene scene = strip();
        const Copies copies = mirrored(scene, {Id{1}}, Vec3::Zero(), 0, 1e-3);
        const Scene now = after(scene, copies.edit);
        const Part& part = partOf(now);
        QCOMPARE(part.particles.size(), std::size_t(5 * 2));
        QCOMPARE(part.links.size(), std::size_t(5 + 4 * 2)); // across, along
        QCOMPARE(part.panels.size(), std::size_t(8));
        for (const Panel& row : part.panels) // all face the same way
            QVERIFY(normalOf(now, row).z() > 0.0);
        QCOMPARE(groupOf(now).members.size(),
                 part.particles.size() + part.links.size() + part.panels.size());
        // for each particle there is one on the other side
        for (const Particle& one : part.particles) {
            const Vec3 twin(-one.position.x(), one.position.y(), one.position.z());
            QCOMPARE(
                std::ranges::count_if(
                    part.particles, [&](const Particle& other) { return other.position == twin; }),
                1);
        }
    }

    void mirroringPutsWhatIsNearOntoThePlane()
    {
        Scene scene = strip();
        (void)apply(scene, setValue(scene, Id{2}, "position", Vec3(0.0005, 0, 0)));
        const Scene near = after(scene, mirrored(scene, {Id{1}}, Vec3::Zero(), 0, 1e-3).edit);
        QCOMPARE(partOf(near).particles.size(), std::size_t(10));
        QCOMPARE(placeOf(near, Id{2}), Vec3(Vec3::Zero()));
        const Scene far = after(scene, mirrored(scene, {Id{1}}, Vec3::Zero(), 0, 1e-4).edit);
        QCOMPARE(partOf(far).particles.size(), std::size_t(11));
    }

    void copyAndPasteGoFromSceneToScene()
    {
        const Scene scene = strip();
        const Scene some = excerpt(scene, {Id{2}, Id{3}, Id{4}, Id{5}, Id{31}});
        const Result<Scene> read = parseScene(sceneText(some), "the clipboard");
        QVERIFY2(read, read ? "" : read.message().english().c_str());
        QCOMPARE(partOf(*read).links.size(), std::size_t(4));

        // into a scene that has none of it, and into its own, where the material is there
        const Copies foreign = pasted(fallingPair(), *read);
        const Scene now = after(fallingPair(), foreign.edit);
        QCOMPARE(now.items.size(), fallingPair().items.size() + 3); // material, part, group
        QCOMPARE(foreign.ids.size(), std::size_t(2));
        QCOMPARE(findItem<Group>(now, foreign.ids.back())->members.size(), std::size_t(4 + 4 + 2));
        const Scene own = after(scene, pasted(scene, *read).edit);
        QCOMPARE(own.items.size(), scene.items.size() + 2);
        QCOMPARE(massOf(own), massOf(scene) + 4 * 0.5);
    }

    // The copies of two halves that touch: welding makes them one strip.
    void weldingJoinsWhatIsNear()
    {
        const Scene scene = strip();
        const Copies copies = duplicated(scene, {Id{1}}, {shifted(Vec3(2.0, 0, 1e-4))}, {});
        const Scene two = after(scene, copies.edit);
        const Weld weld = weldedWithin(two, {Id{1}, copies.ids.front()}, 1e-3, WeldAt::First);
        const Scene now = after(two, weld.edit);
        QCOMPARE(weld.merged, std::size_t(2));
        QCOMPARE(weld.links, std::size_t(1)); // there were two along the seam
        QCOMPARE(weld.panels, std::size_t(0));
        QVERIFY(std::abs(massOf(now) - massOf(two)) < 1e-15);
        for (const Id id : weld.kept)
            QCOMPARE(placeOf(now, id).z(), 0.0);
        const EditCounts counts = editCountsOf(weld.edit);
        QCOMPARE(counts.removed.particles, std::size_t(2));
        QCOMPARE(weldedWithin(scene, {Id{1}}, 0.5, WeldAt::First).merged, std::size_t(0));
    }

    // The ends of one cell's diagonal: the link between them and panels with both go.
    void weldingAllLeavesNoWreckage()
    {
        const Scene scene = strip();
        const Weld weld = welded(scene, {Id{2}, Id{4}}, WeldAt::Middle); // (0,0) and (1,0)
        const Scene now = after(scene, weld.edit);
        QCOMPARE(placeOf(now, Id{2}), Vec3(0.5, 0, 0));
        QCOMPARE(std::get<const Particle*>(*find(now, Id{2}))->mass, 1.0);
        QCOMPARE(weld.links, std::size_t(1));
        QCOMPARE(weld.panels, std::size_t(1));
        QVERIFY(!std::ranges::count(groupOf(now).members, Id{4}));
    }

    void pinning_()
    {
        const Scene scene = strip();
        QVERIFY(!allPinned(scene, {Id{1}}));
        const Scene now = after(scene, pinning(scene, {Id{1}}, true));
        QVERIFY(allPinned(now, {Id{1}}));
        QVERIFY(after(now, pinning(now, {Id{1}}, false)) == scene);
        QVERIFY(!allPinned(scene, {}));
    }

    void massesAddUp()
    {
        const Scene scene = strip();
        const auto spread = [&](MassBy by, double amount, std::vector<Id> ids = {Id{1}}) {
            const Result<Edit> edit = massSpread(scene, ids, by, amount);
            return edit ? massOf(after(scene, *edit)) : -1.0;
        };
        QVERIFY(std::abs(spread(MassBy::Particle, 0.1) - 0.6) < 1e-15);
        QVERIFY(std::abs(spread(MassBy::TotalEvenly, 1.7) - 1.7) < 1e-15);
        QVERIFY(std::abs(spread(MassBy::TotalInProportion, 1.7) - 1.7) < 1e-15);
        QVERIFY(std::abs(spread(MassBy::Length, 0.1) - 0.7) < 1e-15); // 7 m
        QVERIFY(std::abs(spread(MassBy::Area, 0.05) - 0.1) < 1e-15);  // 2 m^2
        // two of the six share the total, the other four keep their 0.5
        QVERIFY(std::abs(spread(MassBy::TotalEvenly, 1.0, {Id{2}, Id{3}}) - 3.0) < 1e-15);
        QVERIFY(!massSpread(scene, {}, MassBy::TotalEvenly, 1.0));
        QVERIFY(!massSpread(scene, {Id{2}, Id{7}}, MassBy::Area, 1.0));
    }

    void theCentreOfGravity()
    {
        Scene scene = strip();
        QVERIFY((massPropertiesOf(scene, {}).centre - Vec3(1, 0.5, 0)).norm() < 1e-15);
        QCOMPARE(massPropertiesOf(scene, {}).mass, 3.0);
        (void)apply(scene, setValue(scene, Id{2}, "mass", 1.5)); // (0,0)
        QVERIFY((massPropertiesOf(scene, {Id{2}, Id{6}}).centre - Vec3(0.5, 0, 0)).norm() < 1e-15);
    }

    void particlesAlign()
    {
        Scene scene = strip();
        const std::vector<Id> row{Id{2}, Id{4}, Id{6}}; // y = 0, x = 0, 1, 2
        (void)apply(scene, setValue(scene, Id{4}, "position", Vec3(0.2, 0.6, 0.3)));
        const Scene least = after(scene, aligned(scene, row, 1, Side::Least, RestLengths::Keep));
        QCOMPARE(placeOf(least, Id{4}), Vec3(0.2, 0.0, 0.3));
        const Scene middle = after(scene, aligned(scene, row, 1, Side::Middle, RestLengths::Keep));
        QCOMPARE(placeOf(middle, Id{2}).y(), 0.3);
        const Scene even = after(scene, distributed(scene, row, 0, RestLengths::Rebind));
        QCOMPARE(placeOf(even, Id{4}), Vec3(1.0, 0.6, 0.3));
        const Scene flat = after(scene, flattened(scene, {Id{1}}, RestLengths::Keep));
        // three points off one plane: what is left of the height is nothing
        const Vec3 normal = (placeOf(flat, Id{3}) - placeOf(flat, Id{2}))
                                .cross(placeOf(flat, Id{6}) - placeOf(flat, Id{2}))
                                .normalized();
        for (const Particle& one : partOf(flat).particles)
            QVERIFY(std::abs(normal.dot(one.position - placeOf(flat, Id{2}))) < 1e-14);
    }

    void partsAlignAsWholes()
    {
        const Scene scene = strip();
        const Copies copies = duplicated(scene, {Id{1}}, {shifted(Vec3(5, 3, 0))}, {});
        const Scene two = after(scene, copies.edit);
        const std::vector<Id> both{Id{1}, copies.ids.front()};
        const Scene now = after(two, aligned(two, both, 1, Side::Most, RestLengths::Keep));
        QCOMPARE(placeOf(now, Id{2}), Vec3(0, 3, 0));
        QCOMPARE(placeOf(now, Id{3}), Vec3(0, 4, 0));
        QCOMPARE(findItem<Part>(now, both.back())->particles.front().position, Vec3(5, 3, 0));
    }

    // Two springs of 2k in a row are one of k; the total stays where the material knows it.
    void splitLinksAreWhatTheyWere()
    {
        Scene scene = strip();
        (void)apply(scene, setValue(scene, Id{30}, "linearDensity", 0.3)); // kg/m
        (void)apply(scene, setValue(scene, Id{30}, "compliance", 0.006));
        const Id middle = partOf(scene).links[1].id; // from (1,0) to (1,1), side of two panels
        const LinksSplit split = linksSplit(scene, {middle}, 3, 9.0);
        const Scene now = after(scene, split.edit);
        const Part& part = partOf(now);
        QCOMPARE(split.links, std::size_t(1));
        QCOMPARE(split.made.size(), std::size_t(2));
        QCOMPARE(part.links.size(), std::size_t(6 + 3));
        QCOMPARE(part.panels.size(), std::size_t(2 + 2 * 3));
        QVERIFY(std::abs(massOf(now) - massOf(scene)) < 1e-15);
        double length = 0.0, area = 0.0;
        for (const Link& row : part.links)
            if (row.compliance) {
                length += row.restLength;
                QCOMPARE(*row.compliance, 0.002);
            }
        QVERIFY(std::abs(length - 1.0) < 1e-15);
        for (const Panel& row : part.panels) {
            area += 0.5 * normalOf(now, row).norm();
            QVERIFY(normalOf(now, row).z() > 0.0);
        }
        QVERIFY(std::abs(area - 2.0) < 1e-14);
        QVERIFY(!std::ranges::count(groupOf(now).members, middle));
    }

    // Three sides of one triangle at once.
    void allSidesOfAPanelSplit()
    {
        const Scene scene = oneOfEverything();
        const LinksSplit split = linksSplit(scene, {Id{5}, Id{6}, Id{7}}, 2, 0.01);
        const Scene now = after(scene, split.edit);
        QCOMPARE(partOf(now).links.size(), std::size_t(6));
        QCOMPARE(partOf(now).panels.size(), std::size_t(4));
        double area = 0.0;
        for (const Panel& row : partOf(now).panels)
            area += 0.5 * normalOf(now, row).norm();
        QVERIFY(std::abs(area - 0.5) < 1e-15);
    }

    void whatHangsOnAParticle()
    {
        const Scene scene = strip();
        // (1,0): 3 links and 3 panels touch it
        const ElementCounts counts = alsoRemoved({Id{4}}, removal(scene, {Id{4}}));
        QCOMPARE(counts.particles, std::size_t(0));
        QCOMPARE(counts.links, std::size_t(3));
        QCOMPARE(counts.panels, std::size_t(3));
        QVERIFY(alsoRemoved({Id{1}}, removal(scene, {Id{1}})).isNothing());
    }

    void operationsWork_data()
    {
        QTest::addColumn<QString>("name");
        for (const Operation& operation : allOperations())
            QTest::newRow(operation.name.data()) << QString::fromUtf8(operation.name.data());
    }

    // With its defaults each does something, or says in a sentence why not; with nothing selected
    // it says so.
    void operationsWork()
    {
        QFETCH(QString, name);
        const Operation& operation = *findOperation(name.toStdString());
        Parameters values;
        for (const Parameter& one : operation.parameters)
            values[std::string(one.key)] = one.initial;
        const Scene scene = strip();
        std::vector<Id> all{Id{1}};
        for (const Link& row : partOf(scene).links)
            all.push_back(row.id);
        const Result<Shaped> shaped = operation.apply(scene, all, values);
        if (shaped) {
            const Scene now = after(scene, shaped->edit);
            QVERIFY(!(now == scene));
        } else {
            QVERIFY(shaped.message().english().ends_with("."));
        }
        const Result<Shaped> nothing = operation.apply(scene, {}, values);
        QVERIFY(!nothing && nothing.message().english().ends_with("."));
    }

    void everyDesignTakesEveryOperation_data()
    {
        QTest::addColumn<QString>("name");
        for (const Builder& builder : allBuilders())
            if (builder.family != Family::Obstacles) // which have nothing to shape
                QTest::newRow(builder.name.data()) << QString::fromUtf8(builder.name.data());
    }

    // What comes out is sound, and can be taken back; also of a part of the design.
    void everyDesignTakesEveryOperation()
    {
        QFETCH(QString, name);
        const Scene scene = *build(*findBuilder(name.toStdString()), {});
        std::vector<Id> whole, some;
        forEachPart(scene, [&](Id id, const Part& part) {
            whole.push_back(id);
            for (std::size_t i = 0; i < part.particles.size(); i += 2)
                some.push_back(part.particles[i].id);
            for (std::size_t i = 0; i < part.links.size(); i += 3)
                some.push_back(part.links[i].id);
        });
        int done = 0;
        for (const Operation& operation : allOperations())
            for (const auto& ids : {whole, some}) {
                Parameters values;
                for (const Parameter& one : operation.parameters)
                    values[std::string(one.key)] = one.initial;
                if (const Result<Shaped> shaped = operation.apply(scene, ids, values)) {
                    (void)after(scene, shaped->edit);
                    ++done;
                }
            }
        QVERIFY(done >= 6);
        for (const int axis : {0, 1, 2})
            (void)after(scene, aligned(scene, some, axis, Side::Middle, RestLengths::Keep));
        (void)after(scene, flattened(scene, whole, RestLengths::Keep));
        const Scene text = excerpt(scene, some);
        const Result<Scene> read = parseScene(sceneText(text), "the clipboard");
        QVERIFY2(read, read ? "" : read.message().english().c_str());
        (void)after(scene, pasted(scene, *read).edit);
    }

    void largeDesignsAreQuick()
    {
        const Scene scene = *build(*findBuilder("cloth"), {{"columns", 316}, {"rows", 316}});
        std::vector<Id> ids;
        forEachPart(scene, [&](Id id, const Part&) { ids.push_back(id); });
        double start = threadTime();
        const Copies copies = mirrored(scene, ids, Vec3(10, 0, 0), 0, 1e-3);
        Scene now = scene;
        (void)apply(now, copies.edit);
        qInfo("mirrored 100 489 particles in %.0f ms", threadTime() - start);
        start = threadTime();
        const Weld weld = weldedWithin(now, ids, 1e-4, WeldAt::First);
        qInfo("looked for %zu welds among 200 978 in %.0f ms", weld.merged, threadTime() - start);
        QCOMPARE(weld.merged, std::size_t(0));
    }
};

const RegisteredTest registered("test_copy", runWithCore<TestCopy>);

} // namespace ripstop::test_copy
#include "test_copy.moc"
