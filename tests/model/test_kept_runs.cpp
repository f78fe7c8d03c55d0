// Recordings that a study keeps of its best flights: which those are, however they are flown.
#include "registered_test.h"

#include "io/scene_file.h"
#include "study/kept_runs.h"
#include "study/study_search.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>

namespace ripstop::test_kept_runs {

namespace {

// A weight without air: after 0.5 s it is g t^2 / 2 = 1.226 m below where it began, and 0.5 s times
// its speed aside.
Scene falling()
{
    Scene scene;
    scene.settings.airDensity = 0.0;
    Part part;
    part.name = "weight";
    part.particles.resize(1);
    part.particles[0].id = takeId(scene);
    part.particles[0].mass = 1.0;
    const Id particle = part.particles[0].id;
    scene.items.push_back(Entry{takeId(scene), part});
    for (const auto& [name, quantity] :
         {std::pair("x", Quantity::PositionX), std::pair("y", Quantity::PositionY)}) {
        Probe probe;
        probe.name = name;
        probe.quantity = quantity;
        probe.target = particle;
        scene.items.push_back(Entry{takeId(scene), probe});
    }
    return scene;
}

constexpr auto fallStudy = R"({"format": "ripstop-study", "version": 1, "seconds": 0.5,
    "scene": "fall.ripstop.json", "keep": "best", "keepCount": 3,
    "variables": [{"name": "y", "paths": ["weight.particles.position.y"], "values": []},
                  {"name": "v", "paths": ["weight.particles.velocity.x"], "values": []}],
    "plan": {"kind": "points", "file": "points.csv"},
    "measures": [{"probe": "y", "reduction": "final"}, {"probe": "x", "reduction": "final"}],
    "objectives": [{"probe": "y", "reduction": "final", "goal": "maximise"}%1],
    "constraints": [{"probe": "y", "reduction": "final", "atMost": 3.5}]})";
constexpr auto alsoNear = R"(, {"probe": "x", "reduction": "final", "goal": "minimise"})";

constexpr auto fivePoints = "y,v\n1,0\n5,0\n3,0\n2,0\n4,0\n"; // 5 is not allowed: it stays above

// Such a study in a folder of its own.
class Fall
{
public:
    explicit Fall(const char* points = fivePoints, const char* moreWanted = "")
    {
        const auto write = [&](const char* name, const QByteArray& text) {
            QFile file(m_folder.filePath(name));
            if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0)
                qFatal("a file cannot be written");
        };
        write("points.csv", points);
        write("a.ripstop-study.json", QString(fallStudy).arg(moreWanted).toUtf8());
        const QString scene = m_folder.filePath("fall.ripstop.json");
        if (saveScene(falling(), scene.toStdString()))
            qFatal("the scene cannot be written");
    }

    // As far as so many flights; gives the points that are kept, as it says.
    std::vector<std::size_t> fly(Shard shard = {}, std::size_t most = 1000, int jobs = 1) const
    {
        std::atomic<std::size_t> flown = 0; // told on one thread, asked on another
        const auto done = flyMissing(
            open(), shard, jobs, [&] { return flown >= most; },
            [&](const FlightNews&) { ++flown; });
        return done && done->best ? *done->best : std::vector<std::size_t>();
    }

    OpenedStudy open() const
    {
        auto opened = openStudy(m_folder.filePath("a.ripstop-study.json").toStdString());
        if (!opened)
            qFatal("%s", opened.message().english().c_str());
        return std::move(*opened);
    }
    QDir runs() const { return QDir(m_folder.filePath("a.ripstop-runs")); }

    // The heights of the points whose recordings are in the folder, and are those of their rows.
    QStringList heightsKept() const
    {
        const OpenedStudy opened = open();
        const auto known = readLedgers(ledgerFolder(opened.file));
        QStringList heights;
        for (std::size_t i = 0; i < opened.points.count(); ++i)
            if (const auto row = known->rows.find(opened.key(i));
                row != known->rows.end() && readKeptRun(opened, i, row->second))
                heights << QString::fromStdString(opened.points.value(i, 0));
        if (heights.size() != runs().entryList({"*.ripstop-run"}).size())
            heights << "and others";
        return heights;
    }

private:
    QTemporaryDir m_folder;
};

using Points = std::vector<std::size_t>;
using Heard = std::vector<std::pair<std::size_t, std::size_t>>;
const QStringList bestHeights{"3", "2", "4"}; // in the order of their points

} // namespace

class TestKeptRuns : public QObject
{
    Q_OBJECT

private slots:
    // The highest that are allowed, the best first; running again makes what is missing.
    void theBestAreKept()
    {
        const Fall fall;
        QCOMPARE(fall.fly(), (Points{4, 2, 3}));
        QCOMPARE(fall.heightsKept(), bestHeights);
        QVERIFY(QFile::remove(QString::fromStdString(keptRun(fall.open(), 2).string())));
        QCOMPARE(fall.fly(), (Points{4, 2, 3}));
        QCOMPARE(fall.heightsKept(), bestHeights);
    }

    // It is told before the first and after each of those that are flown again, and an end between
    // them leaves what there is.
    void tellsHowFarTheRecordingIs()
    {
        const Fall fall;
        Heard heard;
        const auto nobody = [](const FlightNews&) {};
        const auto hear = [&](std::size_t done, std::size_t wanted) {
            heard.emplace_back(done, wanted);
        };
        const auto afterOne = [&] { return heard.size() >= 2; };
        const auto ended = flyMissing(fall.open(), {}, 1, afterOne, nobody, hear);
        QVERIFY(ended && ended->best);
        QCOMPARE(*ended->best, (Points{4}));
        QCOMPARE(heard, (Heard{{0, 3}, {1, 3}}));
        heard.clear();
        const auto goesOn = [] { return false; };
        const auto done = flyMissing(fall.open(), {}, 1, goesOn, nobody, hear);
        QVERIFY(done && done->best);
        QCOMPARE(*done->best, (Points{4, 2, 3}));
        QCOMPARE(heard, (Heard{{0, 2}, {1, 2}, {2, 2}}));
        heard.clear();
        QVERIFY(flyMissing(fall.open(), {}, 1, goesOn, nobody, hear)); // all are there
        QCOMPARE(heard, Heard());
    }

    // The first shard has flown 1, 3 and 4; the 2 of the other overtakes the 1.
    void overtakenFlightsLoseTheirs()
    {
        const Fall fall;
        QCOMPARE(fall.fly({0, 2}), (Points{4, 2, 0}));
        QCOMPARE(fall.heightsKept(), (QStringList{"1", "3", "4"}));
        QCOMPARE(fall.fly({1, 2}), (Points{4, 2, 3}));
        QCOMPARE(fall.heightsKept(), bestHeights);
        const Fall reversed;
        reversed.fly({1, 2});
        QCOMPARE(reversed.heightsKept(), (QStringList{"2"}));
        reversed.fly({0, 2});
        QCOMPARE(reversed.heightsKept(), bestHeights);
    }

    void endedAndTakenUpItIsTheSame()
    {
        const Fall fall;
        QCOMPARE(fall.fly({}, 2), Points());
        QCOMPARE(fall.heightsKept(), QStringList());
        QCOMPARE(fall.fly({}, 1000, 2), (Points{4, 2, 3}));
        QCOMPARE(fall.heightsKept(), bestHeights);
    }

    // Rows and recordings that were copied together, as `study merge` finds them.
    void whatWasBroughtTogether()
    {
        const Fall here, there;
        here.fly({0, 2});
        there.fly({1, 2});
        for (const QString& name : there.runs().entryList(QDir::Files))
            QFile::copy(there.runs().filePath(name), here.runs().filePath(name));
        QCOMPARE(here.heightsKept(), (QStringList{"1", "3", "2", "4"}));
        const OpenedStudy opened = here.open();
        const auto known = readLedgers(ledgerFolder(opened.file));
        QCOMPARE(removeOvertaken(opened, flightsOf(opened, known->rows)), (Points{4, 2, 3}));
        QCOMPARE(here.heightsKept(), bestHeights);
    }

    // Of 4 m and of 3 m at 1 m/s none is better in both, 3 m at 2 m/s is only behind those, and 1 m
    // behind all. The last point flies as the third does.
    void frontsComeOneAfterTheOther()
    {
        const Fall fall("y,v\n1,2\n3,2\n3,1\n4,3\n3,1\n", alsoNear);
        QCOMPARE(fall.fly(), (Points{3, 2, 1}));
        const OpenedStudy opened = fall.open();
        const auto known = readLedgers(ledgerFolder(opened.file));
        const StudyFlights flights = flightsOf(opened, known->rows);
        QCOMPARE(bestDesigns(opened, flights, 10), (Points{3, 2, 1, 0}));
        QCOMPARE(bestDesigns(opened, flights, 1), (Points{3}));
        QCOMPARE(bestPoints(opened, flights), (Points{3, 2}));
    }
};

const RegisteredTest registered("test_kept_runs", runPlain<TestKeptRuns>);

} // namespace ripstop::test_kept_runs
#include "test_kept_runs.moc"
