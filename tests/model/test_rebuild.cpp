// Designs that go into an open scene, are built again with other parameters, and are detached.
//
// Stages: every builder is inserted into an empty and into another scene; then parts are built
// again with the same and with each other parameter, where what was tuned by hand must stay; then
// what is lost is counted, and parts are detached. after() checks undo for each edit. A new
// builder is covered without a change here.
#include "check/check.h"
#include "io/scene_file.h"
#include "model/rebuilding.h"
#include "registered_test.h"
#include "shaping/transform.h"

#include <QtTest>

#include <set>

namespace ripstop::test_rebuild {

using namespace rebuilding;

namespace {

bool isClean(const Scene& scene)
{
    for (const Finding& problem : problemsOf(scene))
        if (problem.severity == Severity::Error)
            qWarning("%s", problem.message.english().c_str());
    return !hasErrors(problemsOf(scene));
}

} // namespace

class TestRebuild : public QObject
{
    Q_OBJECT

private slots:
    void everyBuilderIsInserted_data()
    {
        QTest::addColumn<QString>("name");
        for (const Builder& builder : allBuilders())
            QTest::newRow(builder.name.data()) << builder.name.data();
    }

    // Into an empty scene it is the built scene, under whatever ids; beside another it is clear of
    // it and brings no second ground or wind unless that is wished.
    void everyBuilderIsInserted()
    {
        QFETCH(QString, name);
        const Scene alone = inserting(Scene{}, qPrintable(name));
        const Scene wanted = built(qPrintable(name));
        QCOMPARE(alone.items.size(), wanted.items.size());
        QVERIFY(isClean(alone));
        QCOMPARE(alone.settings.substeps, wanted.settings.substeps);

        InsertWish wish;
        wish.at = PlaceAt::Beside;
        wish.withSurroundings = false;
        const Scene kite = built("delta_kite");
        const Scene both = inserting(kite, qPrintable(name), wish);
        QVERIFY(isClean(both));
        std::size_t winds = 0;
        std::set<std::string> names;
        for (const Entry& entry : both.items) {
            winds += std::holds_alternative<Wind>(entry.item);
            QVERIFY2(names.insert(nameOf(entry.item)).second, nameOf(entry.item).c_str());
        }
        QCOMPARE(winds, std::size_t(1));
        if (findBuilder(name.toStdString())->family == Family::Obstacles)
            return;
        Eigen::AlignedBox3d first, second;
        for (const Particle& row : part(both, 0).particles)
            first.extend(row.position);
        for (const Particle& row : part(both, 1).particles)
            second.extend(row.position);
        QVERIFY(second.min().z() > first.max().z());
    }

    void placesAreThoseOfTheWish()
    {
        const Scene scene = built("rope");
        InsertWish wish;
        wish.at = PlaceAt::Shift;
        wish.place = Vec3(1, 2, 3);
        const Scene moved = inserting(scene, "rope", wish);
        const Vec3 by = part(moved, 1).particles[3].position - part(scene).particles[3].position;
        QVERIFY((by - wish.place).norm() < 1e-12);
        wish.at = PlaceAt::Point;
        const Scene there = inserting(scene, "box", wish);
        QVERIFY(
            (itemNamed<Collider>(const_cast<Scene&>(there), "box")->position - wish.place).norm()
            < 1e-12);
    }

    // Every builder: built again with the parameters it has, nothing changes and nothing is lost.
    void theSameParametersChangeNothing_data() { everyBuilderIsInserted_data(); }

    void theSameParametersChangeNothing()
    {
        QFETCH(QString, name);
        if (findBuilder(name.toStdString())->family == Family::Obstacles)
            return;
        const Scene alone = built(qPrintable(name));
        QVERIFY(changing(alone, {}) == alone);
        QVERIFY(handWork(alone, partId(alone)).isNothing());
        InsertWish wish;
        wish.at = PlaceAt::Beside;
        const Scene two =
            inserting(alone, qPrintable(name), wish); // with a shift, and numbered names
        QVERIFY(handWork(two, partId(two, 1)).isNothing());
        const Scene again = changing(two, {}, 1);
        QCOMPARE(again.items.size(), two.items.size());
        for (std::size_t i = 0; i < part(two, 1).particles.size(); ++i) {
            QCOMPARE(part(again, 1).particles[i].id, part(two, 1).particles[i].id);
            QVERIFY(
                (part(again, 1).particles[i].position - part(two, 1).particles[i].position).norm()
                < 1e-6);
        }
    }

    // A file that is older than a parameter does not say it. It means what was built then, and is
    // built again as that, though a new design would be offered something else.
    void aFileThatSaysNothingIsBuiltAsBefore_data() { everyBuilderIsInserted_data(); }

    void aFileThatSaysNothingIsBuiltAsBefore()
    {
        QFETCH(QString, name);
        const Builder& builder = *findBuilder(name.toStdString());
        if (builder.family == Family::Obstacles)
            return;
        Scene old = built(qPrintable(name));
        Part& before = *const_cast<Part*>(&part(old));
        for (const Parameter& parameter : builder.parameters)
            before.parameters.erase(std::string(parameter.key));
        QVERIFY(handWork(old, partId(old)).isNothing());
        const Scene again = changing(old, {});
        QVERIFY(part(again).particles == before.particles);
        QVERIFY(part(again).links == before.links);
        QVERIFY(part(again).panels == before.panels);
        QCOMPARE(part(again).carrier, before.carrier);
        for (const Parameter& parameter : builder.parameters)
            QCOMPARE(part(again).parameters.at(std::string(parameter.key)), parameter.initial);
    }

    // Real cloth is chosen for an ideal craft that flies already, and taken back.
    void clothIsChosenLater_data()
    {
        QTest::addColumn<Parameters>("real");
        QTest::newRow("parachute") << Parameters{{"cloth", 1}, {"cord", 1}, {"pressure", 1.68}};
        QTest::newRow("hang_glider") << Parameters{{"cloth", 1}, {"spars", 2}};
        QTest::newRow("delta_kite") << Parameters{{"cloth", 2}, {"spars", 1}, {"cord", 3}};
    }

    void clothIsChosenLater()
    {
        QFETCH(Parameters, real);
        const char* name = QTest::currentDataTag();
        const auto verify = [](const Scene& scene, const Scene& wanted) {
            QVERIFY(isClean(scene));
            QCOMPARE(part(scene).carrier, part(wanted).carrier);
            QCOMPARE(part(scene).particles.size(), part(wanted).particles.size());
            QCOMPARE(part(scene).links.size(), part(wanted).links.size());
            QCOMPARE(part(scene).panels.size(), part(wanted).panels.size());
            for (std::size_t i = 0; i < part(wanted).panels.size(); ++i) {
                const auto of = [&](const Scene& one) {
                    return findItem<Material>(one, part(one).panels[i].material);
                };
                QVERIFY(*of(scene) == *of(wanted));
                QCOMPARE(part(scene).panels[i].grain, part(wanted).panels[i].grain);
            }
        };
        const Scene ideal = built(name);
        const Scene sewn = changing(ideal, real);
        verify(sewn, built(name, real));
        Parameters back;
        for (const auto& [key, value] : real)
            back[key] = part(ideal).parameters.at(key);
        verify(changing(sewn, back), ideal);
    }

    // Every number of every builder, from its default to the middle of its range: what comes is
    // what the builder makes, in the same place, and undo restores (after() checks that).
    void everyParameterCanBeChanged_data() { everyBuilderIsInserted_data(); }

    void everyParameterCanBeChanged()
    {
        QFETCH(QString, name);
        const Builder& builder = *findBuilder(name.toStdString());
        if (builder.family == Family::Obstacles)
            return;
        const Scene scene = built(qPrintable(name));
        for (const Parameter& parameter : builder.parameters) {
            double value =
                0.5 * (parameter.initial + std::min(parameter.high, 4.0 * parameter.initial + 1.0));
            if (parameter.whole)
                value = std::floor(value);
            const Parameters given{{std::string(parameter.key), value}};
            const Result<Scene> wanted = build(builder, given);
            if (!wanted)
                continue;
            const Scene changed = changing(scene, given);
            const char* what = parameter.key.data();
            QVERIFY2(isClean(changed), what);
            QVERIFY2(part(changed).parameters.at(std::string(parameter.key)) == value, what);
            QVERIFY2(part(changed).particles.size() == part(*wanted).particles.size(), what);
            QVERIFY2(part(changed).links.size() == part(*wanted).links.size(), what);
            QVERIFY2(changed.items.size() == wanted->items.size()
                         || changed.items.size() == scene.items.size(),
                     what); // a material that is no longer used stays
            for (std::size_t i = 0; i < part(changed).particles.size(); ++i)
                QVERIFY2((part(changed).particles[i].position - part(*wanted).particles[i].position)
                                 .norm()
                             < 1e-9,
                         what);
            const auto groupSize = [](const Scene& one) {
                std::size_t size = 0;
                for (const Entry& entry : one.items)
                    if (const Group* group = std::get_if<Group>(&entry.item))
                        size += group->members.size();
                return size;
            };
            QVERIFY2(groupSize(changed) == groupSize(*wanted), what);
        }
    }

    // What the author tuned and the parameters do not touch stays; what they touch follows.
    void tunedNumbersStay()
    {
        Scene scene = built("rectangular_kite");
        itemNamed<Material>(scene, "sail")->skinFriction = 0.123;
        itemNamed<Material>(scene, "sail")->color = "#000000";
        itemNamed<Probe>(scene, "height")->plotted = false;
        itemNamed<Wind>(scene, "wind")->velocity.z() = 1.0;
        scene.settings.sweeps = 17;
        Scene changed = changing(scene, {{"lift_slope", 3.0}, {"columns", 6}, {"gusts", 7.7}});
        QCOMPARE(itemNamed<Material>(changed, "sail")->skinFriction, 0.123);
        QCOMPARE(itemNamed<Material>(changed, "sail")->color, std::string("#000000"));
        QCOMPARE(itemNamed<Material>(changed, "sail")->normalCoefficient, 3.0);
        QVERIFY(!itemNamed<Probe>(changed, "height")->plotted);
        QCOMPARE(itemNamed<Wind>(changed, "wind")->velocity.z(), 1.0);
        QVERIFY(itemNamed<Wind>(changed, "gusts"));
        QCOMPARE(changed.settings.sweeps, 17);
        QVERIFY(isClean(changed));
        // the way back: the gusts go, and the tail with its group
        changed = changing(changed, {{"gusts", 0.0}, {"tail_length", 0.0}});
        QVERIFY(!itemNamed<Wind>(changed, "gusts"));
        QVERIFY(!itemNamed<Group>(changed, "tail nodes"));
        QVERIFY(isClean(changed));
    }

    // A part that was moved, turned and renamed is built again where it is.
    void keepsItsPlaceAndName()
    {
        Scene scene = built("frame");
        Part& frame = *itemNamed<Part>(scene, "frame");
        frame.name = "my frame";
        const Motion motion = turned(Vec3(1, 0, 0), Vec3(1, 2, 3), 0.7);
        for (Particle& row : frame.particles)
            row.position = motion.map * row.position;
        QVERIFY(handWork(scene, partId(scene)).isNothing());
        const Scene changed = changing(scene, {{"width", 3.0}});
        QCOMPARE(part(changed).name, std::string("my frame"));
        const Scene wanted = built("frame", {{"width", 3.0}});
        for (std::size_t i = 0; i < part(wanted).particles.size(); ++i)
            QVERIFY((motion.map * part(wanted).particles[i].position
                     - part(changed).particles[i].position)
                        .norm()
                    < 1e-6);
    }

    // Work by hand is counted before it is lost; what pointed at rows that go lets go of them.
    void saysWhatIsLost()
    {
        Scene scene = built("frame");
        Part& frame = *itemNamed<Part>(scene, "frame");
        frame.particles[4].position.x() += 0.1;
        frame.particles[5].mass = 3.0;
        frame.links[2].restLength *= 2.0;
        const HandmadeParts work = handWork(scene, partId(scene));
        QCOMPARE(work.moved, std::size_t(1));
        QCOMPARE(work.changed, std::size_t(2));
        QCOMPARE(work.added + work.removed, std::size_t(0));

        Probe mine;
        mine.name = "mine";
        mine.target = frame.particles[7].id;
        scene.items.push_back({takeId(scene), mine});
        Parameters parameters = part(scene).parameters;
        parameters["width"] = 2.0; // as many particles: they keep their ids
        const Result<Rebuilt> wider = rebuilt(scene, partId(scene), parameters);
        QVERIFY(wider && wider->letGo == 0);
        parameters["columns"] = 7;
        const Result<Rebuilt> finer = rebuilt(scene, partId(scene), parameters);
        QVERIFY(finer && finer->letGo == 1);
        Scene changed = after(scene, finer->edit);
        QCOMPARE(itemNamed<Probe>(changed, "mine")->target, noId);

        itemNamed<Part>(scene, "frame")->links.pop_back();
        QCOMPARE(handWork(scene, partId(scene)).removed, std::size_t(1));
    }

    // Of two parts of one builder only the chosen one changes, with its own groups and probes.
    void onlyTheOneThatIsMeant()
    {
        InsertWish wish;
        wish.at = PlaceAt::Beside;
        const Scene two = inserting(built("frame"), "frame", wish);
        const Scene changed = changing(two, {{"columns", 5}}, 1);
        QVERIFY(part(changed, 0) == part(two, 0));
        QCOMPARE(part(changed, 1).particles.size(), std::size_t(18));
        QVERIFY(isClean(changed));
        Scene copy = changed;
        const Group& corners = *itemNamed<Group>(copy, "upper corners 2");
        QCOMPARE(corners.members.size(), std::size_t(2));
        for (const Id id : corners.members)
            QVERIFY(findRow(part(changed, 1).particles, id));
    }

    void tablesAreKept()
    {
        const Builder& bridle = *findBuilder("bridle");
        Parameters given;
        setTable(given, *bridle.table, {{1.5, 1.2}, {1.6, 1.3}});
        const Scene scene = *build(bridle, given);
        QVERIFY(tableOf(part(scene).parameters, *bridle.table)
                == (NumberRows{{1.5, 1.2}, {1.6, 1.3}}));
        const Scene changed = changing(scene, {{"load", 9.0}});
        QCOMPARE(part(changed).links[0].restLength, 1.5);
        QVERIFY(handWork(changed, partId(changed)).isNothing());
    }

    // Detached, a part keeps every row and forgets its builder; undo attaches it (after()).
    void detaching()
    {
        const Scene scene = built("delta_kite");
        const Scene free = after(scene, detached(scene, {partId(scene)}));
        QVERIFY(!builderOf(part(free)));
        QVERIFY(part(free).particles == part(scene).particles);
        QVERIFY(builtParts(free, {partId(free)}).empty());
        QVERIFY(detached(free, {partId(free)}).changes.empty());
        QCOMPARE(builtParts(scene, {part(scene).links[3].id}), std::vector{partId(scene)});
    }

    // The builder of an older version may have had other parameters.
    void refusesUnknownParameters()
    {
        Scene scene = built("rope");
        itemNamed<Part>(scene, "rope")->parameters["colour"] = 3.0;
        const Result<Rebuilt> again = rebuilt(scene, partId(scene), part(scene).parameters);
        QVERIFY(!again && again.message().english().find("colour") != std::string::npos);
    }
};

const RegisteredTest registered("test_rebuild", runPlain<TestRebuild>);

} // namespace ripstop::test_rebuild
#include "test_rebuild.moc"
