// The search along the frontier: it finds the border that the whole grid has, with few of its
// points.
#include "io/scene_file.h"
#include "model/files.h"
#include "model/tether.h"
#include "registered_test.h"
#include "study/frontier_search.h"
#include "study/study_map.h"
#include "study/study_run.h"

#include <QtTest>

#include <cmath>
#include <map>

namespace ripstop::test_frontier {

namespace {

using Border = std::function<bool(const std::vector<double>& place)>; // whether it holds there

double at(const std::vector<double>& place, std::size_t v)
{
    return v < place.size() ? place[v] : 0.0;
}

Border borderOf(int shape)
{
    switch (shape) {
    case 0:
        return [](const auto& p) { return at(p, 0) + 0.6 * at(p, 1) + 0.4 * at(p, 2) > 0.73; };
    case 1:
        return [](const auto& p) { return std::hypot(at(p, 0) - 0.5, at(p, 1) - 0.5) > 0.31; };
    case 2:
        return [](const auto& p) { return at(p, 1) > 0.2 + 3.0 * std::pow(at(p, 0) - 0.5, 2); };
    default:
        return [](const auto&) { return true; };
    }
}

struct Grid
{
    Study study;
    std::vector<std::size_t> values;

    explicit Grid(const std::vector<std::size_t>& counts)
        : values(counts)
    {
        study.plan.kind = StudyPlan::Kind::Frontier;
        for (const std::size_t count : counts)
            study.variables.push_back(count > 1 ? rangeVariable(0.0, 1.0, int(count), false)
                                                : StudyVariable{"one", {}, {"0"}, {}});
    }

    std::size_t count() const
    {
        std::size_t all = 1;
        for (const std::size_t one : values)
            all *= one;
        return all;
    }
    std::vector<double> placeOf(std::size_t point) const // shares of the range
    {
        std::vector<double> place(values.size());
        for (std::size_t v = values.size(); v-- > 0;) {
            place[v] = double(point % values[v]) / double(std::max<std::size_t>(1, values[v] - 1));
            point /= values[v];
        }
        return place;
    }
};

// Searches until nothing more is needed.
std::map<std::size_t, bool> found(const Grid& grid, const Border& holds,
                                  std::map<std::size_t, bool> known = {})
{
    const HeldAt heldAt = [&](std::size_t point) {
        const auto one = known.find(point);
        return one == known.end() ? std::nullopt : std::optional(one->second);
    };
    for (;;) {
        const auto points = frontierPoints(grid.study, heldAt);
        if (points.empty())
            return known;
        for (const std::size_t point : points) {
            const bool isNew = known.emplace(point, holds(grid.placeOf(point))).second;
            if (!isNew)
                qFatal("a known point is asked for again");
        }
    }
}

// Pairs of neighbours of the whole grid of which one holds and the other does not, that the search
// has not flown both.
std::size_t missed(const Grid& grid, const Border& holds, const std::map<std::size_t, bool>& known)
{
    std::size_t missing = 0, stride = 1;
    for (std::size_t v = grid.values.size(); v-- > 0; stride *= grid.values[v])
        for (std::size_t point = 0; point < grid.count(); ++point)
            if ((point / stride) % grid.values[v] + 1 < grid.values[v]
                && holds(grid.placeOf(point)) != holds(grid.placeOf(point + stride)))
                missing += !known.contains(point) || !known.contains(point + stride);
    return missing;
}

const QString tetherStudy = R"({"format": "ripstop-study", "version": 1, "seconds": 0.6,
    "scene": "tether.ripstop.json", "untilTear": true, "measures": [], "variables": [
    {"name": "mass", "paths": ["#3.mass"], "from": 0.5, "to": 2, "count": 33},
    {"name": "strength", "paths": ["cord.tearLimit"], "from": 50, "to": 250, "count": 33}],
    "plan": {"kind": "%1"}})";

constexpr auto massStudy = R"({"format": "ripstop-study", "version": 1, "seconds": 0.02,
    "scene": "pendulum.ripstop.json", "plan": {"kind": "frontier"}, "variables": [
    {"name": "mass", "paths": ["#4.mass"], "from": 1, "to": 2, "count": 17}]})";

} // namespace

class TestFrontier : public QObject
{
    Q_OBJECT

private slots:
    void findsTheWholeBorder_data()
    {
        QTest::addColumn<std::vector<std::size_t>>("counts");
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("share"); // of all points, that may be flown
        using Counts = std::vector<std::size_t>;
        QTest::newRow("one variable") << Counts{129} << 0 << 0.15;
        QTest::newRow("a slanted line") << Counts{65, 65} << 0 << 0.2;
        QTest::newRow("odd numbers of values") << Counts{50, 37} << 0 << 0.35;
        QTest::newRow("a circle") << Counts{65, 65} << 1 << 0.3;
        QTest::newRow("a corner of a parabola") << Counts{65, 33} << 2 << 0.3;
        QTest::newRow("a plane in space") << Counts{17, 17, 17} << 0 << 0.6;
        // between 0.13 and 0.73 the two values differ everywhere: 40 of 66 are the border itself
        QTest::newRow("few values of one") << Counts{33, 2} << 0 << 0.75;
        QTest::newRow("one value of one") << Counts{33, 1} << 0 << 0.5;
        QTest::newRow("all hold") << Counts{33, 33} << 3 << 0.03;
    }

    void findsTheWholeBorder()
    {
        QFETCH(std::vector<std::size_t>, counts);
        QFETCH(int, shape);
        QFETCH(double, share);
        const Grid grid(counts);
        const Border holds = borderOf(shape);
        const auto known = found(grid, holds);
        QCOMPARE(missed(grid, holds, known), std::size_t(0));
        QVERIFY2(double(known.size()) <= share * double(grid.count()),
                 qPrintable(QString("%1 of %2").arg(known.size()).arg(grid.count())));
    }

    // A border that is known in parts, in any order, comes to the same.
    void goesOnFromWhatIsKnown()
    {
        const Grid grid({65, 65});
        const Border holds = [](const auto& p) { return p[0] * p[1] > 0.2; };
        const auto whole = found(grid, holds);
        std::map<std::size_t, bool> part;
        for (const auto& [point, held] : whole)
            if (point % 3 == 0)
                part.emplace(point, held);
        QCOMPARE(found(grid, holds, part), whole);
    }

    // A weight of mass m falls freely for the length of its slack tether, of half a metre, onto a
    // stiffness k: its largest pull is W (1 + sqrt(1 + 2 h k / W)), and it tears where that is more
    // than the strength. The search flies a part of the map and has the border of all of it.
    void flightsOfATether()
    {
        const QTemporaryDir folder;
        QVERIFY(!saveScene(tether(), folder.filePath("tether.ripstop.json").toStdString()));
        const auto studyOfPlan = [&](const char* plan) {
            const QString file = folder.filePath(QString("%1.ripstop-study.json").arg(plan));
            write(file, tetherStudy.arg(plan).toUtf8());
            return openStudy(file.toStdString());
        };
        std::map<std::string, std::vector<std::vector<double>>> lines;
        std::size_t flights = 0;
        for (const char* plan : {"grid", "frontier"}) {
            const auto opened = studyOfPlan(plan);
            QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
            const auto flown = flyMissing(
                *opened, {}, 2, [] { return false; }, [](const FlightNews&) {});
            QVERIFY(flown);
            QCOMPARE(flown->tally.flown, flown->planned);
            flights = flown->tally.flown;
            const auto known = readLedgers(ledgerFolder(opened->file));
            QCOMPARE(countOf(missingPoints(*opened, flightsOf(*opened, known->rows))),
                     std::size_t(0));
            const StudyMap map = mapOf(*opened, flightsOf(*opened, known->rows), {0, 1, 0, {}});
            for (const MapSegment& line : frontier(map))
                lines[plan].push_back({line.from[0], line.from[1], line.to[0], line.to[1]});
        }
        QVERIFY(!lines["grid"].empty());
        QCOMPARE(lines["frontier"], lines["grid"]);
        QVERIFY2(flights < 1089 / 3, qPrintable(QString::number(flights)));
    }

    // Each shard flies its part of what is needed next, and together they find it all.
    void shardsTakeTurns()
    {
        const QTemporaryDir folder;
        QFile::copy(SCENES_DIR "/pendulum.ripstop.json", folder.filePath("pendulum.ripstop.json"));
        const QString file = folder.filePath("a.ripstop-study.json");
        // nothing tears in it: the coarse grid is all, and shards wait for nobody afterwards
        write(file, massStudy);
        const auto opened = openStudy(file.toStdString());
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        const auto nobody = [](const FlightNews&) {};
        const auto first = flyMissing(
            *opened, {0, 3}, 1, [] { return false; }, nobody);
        // of the places 0, 4, 8, 12 and 16 the first and the fourth are of the first of three
        // shards
        QCOMPARE(first->tally.flown, std::size_t(2));
        QCOMPARE(first->ofOthers, std::size_t(3));
        for (const std::size_t shard : {1, 2})
            QVERIFY(flyMissing(
                *opened, {shard, 3}, 1, [] { return false; }, nobody));
        const auto known = readLedgers(ledgerFolder(opened->file));
        QCOMPARE(known->rows.size(), std::size_t(5));
        QCOMPARE(countOf(missingPoints(*opened, flightsOf(*opened, known->rows))), std::size_t(0));
    }
};

const RegisteredTest registered("test_frontier", runPlain<TestFrontier>);

} // namespace ripstop::test_frontier
#include "test_frontier.moc"
