// Studies: the points that a plan makes, what is measured, what a ledger keeps, and the map of a
// tether whose border is known.
#include "model/tether.h"
#include "registered_test.h"
#include "scene/path.h"
#include "study/distribution.h"
#include "study/flight.h"
#include "study/ledger.h"
#include "study/plan.h"
#include "study/study.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <fstream>
#include <set>

namespace ripstop::test_study {

namespace {

StudyVariable drawn(const std::string& name, Distribution spread)
{
    return {name, {name}, {}, spread};
}

Study studyWith(StudyPlan plan, std::vector<StudyVariable> variables)
{
    Study study;
    study.scene = "x.ripstop.json";
    study.seconds = 1.0;
    study.plan = std::move(plan);
    study.variables = std::move(variables);
    return study;
}

double numberOf(const std::string& text) { return std::stod(text); }

std::filesystem::path pathIn(const QTemporaryDir& folder, const char* name)
{
    return std::filesystem::path(folder.path().toStdString()) / name;
}

} // namespace

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    // The share below the quantile is what was asked for, by the error function of the C library.
    void normalQuantiles()
    {
        for (const double share : {1e-12, 1e-5, 0.0228, 0.075, 0.5, 0.6, 0.925, 0.97725, 0.99999}) {
            const double back = 0.5 * std::erfc(-normalQuantile(share) / std::sqrt(2.0));
            QVERIFY2(std::abs(back - share) <= 1e-13 * share, qPrintable(QString::number(share)));
        }
        QVERIFY(std::abs(normalQuantile(0.975) - 1.959963984540054) < 1e-14);
    }

    void quantiles()
    {
        const Distribution triangle{Distribution::Kind::Triangular, 1.0, 5.0, 2.0};
        // the mode has the share (c - a) / (b - a) below it; the median follows from the right side
        QCOMPARE(quantile(triangle, 0.25), 2.0);
        QCOMPARE(quantile(triangle, 0.5), 5.0 - std::sqrt(0.5 * 4.0 * 3.0));
        QCOMPARE(quantile({Distribution::Kind::Log, 1e-3, 1e3}, 0.5), 1.0);
        QCOMPARE(quantile({Distribution::Kind::LogNormal, 40.0, 0.1}, 0.5), 40.0);
        QCOMPARE(quantile({Distribution::Kind::Uniform, -1.0, 3.0}, 0.25), 0.0);
    }

    // (t, m, s)-nets: of the first 2^m points each of the 2^m slices of a dimension has one; of the
    // first two dimensions, whose t is 0, also each of the 4 x 4 cells of 16 points.
    void sobolPointsFillEvenly()
    {
        for (std::size_t dimension = 0; dimension < sobolDimensions; ++dimension)
            for (int m = 1; m <= 10; ++m) {
                std::set<std::uint32_t> slices;
                for (std::size_t i = 0; i < (1u << m); ++i)
                    slices.insert(sobolPoint(i, dimension) >> (32 - m));
                QCOMPARE(slices.size(), std::size_t(1u << m));
            }
        std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
        for (std::size_t i = 0; i < 16; ++i)
            cells.insert({sobolPoint(i, 0) >> 30, sobolPoint(i, 1) >> 30});
        QCOMPARE(cells.size(), std::size_t(16));
    }

    void hypercubesHaveOneInEachSlice()
    {
        const Distribution unit{Distribution::Kind::Uniform, 0.0, 1.0};
        const auto points = StudyPoints::of(studyWith({StudyPlan::Kind::LatinHypercube, 50, 7, {}},
                                                      {drawn("a", unit), drawn("b", unit)}));
        QVERIFY(points);
        std::set<int> a, b;
        std::set<std::pair<int, int>> both;
        for (std::size_t i = 0; i < points->count(); ++i) {
            const auto values = points->values(i);
            a.insert(int(50.0 * numberOf(values[0])));
            b.insert(int(50.0 * numberOf(values[1])));
            both.insert({int(2.0 * numberOf(values[0])), int(2.0 * numberOf(values[1]))});
        }
        QCOMPARE(a.size(), std::size_t(50));
        QCOMPARE(b.size(), std::size_t(50));
        QCOMPARE(both.size(), std::size_t(4)); // and not along a line
    }

    void gridsAndOneAtATime()
    {
        const std::vector<StudyVariable> variables{{"a", {"a"}, {"1", "2"}, {}},
                                                   {"b", {"b"}, {"x", "y", "z"}, {}}};
        const auto grid = StudyPoints::of(studyWith({}, variables));
        QCOMPARE(grid->count(), std::size_t(6));
        QCOMPARE(grid->values(4), (std::vector<std::string>{"2", "y"}));
        const auto single =
            StudyPoints::of(studyWith({StudyPlan::Kind::OneAtATime, 0, 1, {}}, variables));
        QCOMPARE(single->count(), std::size_t(4));
        const std::vector<std::vector<std::string>> wanted{
            {"1", "x"}, {"2", "x"}, {"1", "y"}, {"1", "z"}};
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(single->values(i), wanted[i]);
    }

    // What was flown of a shorter study is part of the longer one.
    void longerPlansBeginAlike()
    {
        const Distribution spread{Distribution::Kind::Normal, 100.0, 10.0};
        for (const auto kind : {StudyPlan::Kind::MonteCarlo, StudyPlan::Kind::Sobol}) {
            const auto some = StudyPoints::of(studyWith({kind, 20, 3, {}}, {drawn("a", spread)}));
            const auto more = StudyPoints::of(studyWith({kind, 30, 3, {}}, {drawn("a", spread)}));
            double sum = 0.0;
            for (std::size_t i = 0; i < 20; ++i) {
                QCOMPARE(more->values(i), some->values(i));
                sum += numberOf(some->values(i).front());
            }
            QVERIFY(std::abs(sum / 20.0 - 100.0) < 4.0 * 10.0 / std::sqrt(20.0));
        }
    }

    void studiesAreReadAsTheyAreWritten()
    {
        const char* text = R"({"format": "ripstop-study", "version": 1, "title": "t",
            "scene": "kite.ripstop.json", "seconds": 8, "untilTear": true,
            "variables": [
                {"name": "stiffness", "paths": ["sail.membraneStiffness", "hem.membraneStiffness"],
                 "from": 1000, "to": 100000, "count": 3, "scale": "log"},
                {"paths": ["wind.velocity"], "values": ["6,0,0", "8,0,0"]},
                {"paths": ["sail.warpStrength"], "values": [100, 2.5]}],
            "plan": {"kind": "grid"},
            "measures": [{"probe": "pull", "reduction": "percentile", "percent": 99, "from": 2}]})";
        const auto study = studyOf(text);
        QVERIFY2(study, study ? "" : study.message().english().c_str());
        QCOMPARE(study->variables[0].values, (std::vector<std::string>{"1000", "10000", "100000"}));
        QCOMPARE(study->variables[1].name, std::string("wind.velocity"));
        QCOMPARE(study->variables[2].values, (std::vector<std::string>{"100", "2.5"}));
        QCOMPARE(headingOf(study->measures[0], "N"), std::string("pull p99 from 2 s (N)"));
        const std::string written = studyText(*study);
        const auto again = studyOf(written);
        QVERIFY2(again, again ? "" : again.message().english().c_str());
        QCOMPARE(studyText(*again), written);
    }

    // The schema names the choices that there are, and every field that a study writes.
    void schemaKnowsAll()
    {
        QFile file(SOURCE_DIR "/docs/ripstop-study.schema.json");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject top = QJsonDocument::fromJson(file.readAll()).object();
        const auto fieldsOfList = [&](const char* list) {
            return top["properties"][list]["items"]["properties"].toObject();
        };
        const auto choices = [](const QJsonValue& field) {
            std::vector<std::string> all;
            for (const QJsonValue& one : field["enum"].toArray())
                all.push_back(one.toString().toStdString());
            return all;
        };
        const auto same = [](const auto& names, const std::vector<std::string>& found) {
            return std::ranges::equal(names, found, {},
                                      [](const auto& name) { return std::string(name); });
        };
        QVERIFY(same(choiceNames<StudyPlan::Kind>,
                     choices(top["properties"]["plan"]["properties"]["kind"])));
        for (const char* list : {"measures", "objectives", "constraints"})
            QVERIFY(same(choiceNames<Reduction>, choices(fieldsOfList(list)["reduction"])));
        QVERIFY(same(choiceNames<StudyPlan::Method>,
                     choices(top["properties"]["plan"]["properties"]["method"])));
        QVERIFY(same(choiceNames<KeptRuns>, choices(top["properties"]["keep"])));
        QVERIFY(same(choiceNames<Goal>, choices(fieldsOfList("objectives")["goal"])));
        QVERIFY(same(choiceNames<WantedOutcome>, choices(fieldsOfList("constraints")["outcome"])));

        Study study = studyWith({StudyPlan::Kind::Sobol, 4, 2, "f"}, {{"v", {"a"}, {"1"}, {}}});
        study.title = study.controls = "x";
        study.untilTear = true;
        study.measures = {{"p", Reduction::Percentile, 5.0, 1.0, 2.0}};
        using Kind = Distribution::Kind;
        for (const Kind kind : {Kind::Uniform, Kind::Normal, Kind::LogNormal, Kind::Triangular})
            study.variables.push_back(drawn("d", {kind, 1.0, 3.0, 2.0}));
        study.variables.push_back({"r", {"a"}, {"1", "2"}, Distribution{Kind::Log, 1.0, 2.0}});
        study.objectives = {{study.measures.front(), Goal::Target, 2.0}};
        study.constraints = {{Constraint::Kind::AtMost, study.measures.front(), 1.0, {}},
                             {Constraint::Kind::AtLeast, study.measures.front(), 1.0, {}},
                             {Constraint::Kind::Outcome, {}, 0.0, WantedOutcome::Accurate}};
        study.keep = KeptRuns::Best;
        const QJsonObject written =
            QJsonDocument::fromJson(QByteArray::fromStdString(studyText(study))).object();
        study.plan.kind = StudyPlan::Kind::Optimise;
        study.plan.polish = 10;
        const QJsonObject optimised =
            QJsonDocument::fromJson(QByteArray::fromStdString(studyText(study))).object();
        const auto isKnown = [](const QJsonObject& object, const QJsonObject& fields) {
            return std::ranges::all_of(object.keys(),
                                       [&](const QString& key) { return fields.contains(key); });
        };
        QVERIFY(isKnown(written, top["properties"].toObject()));
        for (const QJsonObject& one : {written, optimised})
            QVERIFY(isKnown(one["plan"].toObject(),
                            top["properties"]["plan"]["properties"].toObject()));
        for (const char* list : {"variables", "measures", "objectives", "constraints"})
            for (const QJsonValue& one : written[list].toArray())
                QVERIFY2(isKnown(one.toObject(), fieldsOfList(list)), list);
    }

    void whatIsWrongIsNamed_data()
    {
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("names");
        QTest::newRow("misspelt") << R"("secnods": 3, "variables": [])"
                                  << "secnods";
        QTest::newRow("no seconds") << R"("title": "x")"
                                    << "seconds";
        QTest::newRow("no values")
            << R"("seconds": 1, "variables": [{"paths": ["a"], "distribution": "normal",
                  "mean": 0, "deviation": 1}])"
            << "values";
        QTest::newRow("downwards") << R"("seconds": 1, "variables": [{"paths": ["a"], "from": 2,
                                        "to": 1, "count": 4}])"
                                   << "variables[0].from";
        QTest::newRow("one path in two variables")
            << R"("seconds": 1, "variables": [{"name": "one", "paths": ["a"], "values": [1, 2]},
                  {"name": "other", "paths": ["b", "a"], "values": [3, 4]}])"
            << "sets a a second time";
        QTest::newRow("plan") << R"("seconds": 1, "variables": [], "plan": {"kind": "gird"})"
                              << "plan.kind";
        QTest::newRow("count") << R"("seconds": 1, "variables": [], "plan": {"kind": "sobol"})"
                               << "plan.count";
        QTest::newRow("nothing wanted")
            << R"("seconds": 1, "variables": [], "plan": {"kind": "optimise"})"
            << "objectives";
        QTest::newRow("a swarm for two")
            << R"("seconds": 1, "variables": [], "plan": {"kind": "optimise"},
                  "objectives": [{"probe": "a"}, {"probe": "b"}])"
            << "nsga2";
        QTest::newRow("no limit")
            << R"("seconds": 1, "variables": [], "constraints": [{"probe": "a"}])"
            << "constraints[0].atLeast";
        QTest::newRow("the best of nothing") << R"("seconds": 1, "variables": [], "keep": "best")"
                                             << "objectives";
        QTest::newRow("text") << R"("seconds": "ten")"
                              << "seconds";
    }

    void whatIsWrongIsNamed()
    {
        QFETCH(QString, part);
        QFETCH(QString, names);
        const auto study = studyOf(R"({"format": "ripstop-study", "version": 1, "scene": "x", )"
                                   + part.toStdString() + '}');
        QVERIFY(!study);
        QVERIFY2(QString::fromStdString(study.message().english()).contains(names),
                 study.message().english().c_str());
    }

    // v = 3 t + 1 at 0 to 10 s.
    void measures()
    {
        const auto of = [](Reduction reduction, double from = 0.0, double to = 1e300) {
            MeasureReader reader({"v", reduction, 90.0, from, to});
            for (int i = 0; i <= 1000; ++i)
                reader.take(0.01 * i, 3.0 * 0.01 * i + 1.0, 3.0 * 0.01 * i + 1.0, 0.01);
            return reader.result();
        };
        QCOMPARE(of(Reduction::Last), 31.0);
        QCOMPARE(of(Reduction::Mean), 16.0);
        QCOMPARE(of(Reduction::Mean, 8.0), 28.0);
        QCOMPARE(of(Reduction::Mean, 0.0, 2.0), 4.0);
        QCOMPARE(of(Reduction::Least, 2.0), 7.0);
        QCOMPARE(of(Reduction::Largest, 0.0, 2.0), 7.0);
        QCOMPARE(of(Reduction::LargestTime), 10.0);
        QCOMPARE(of(Reduction::Slope), 3.0);
        QCOMPARE(of(Reduction::Percentile), 28.0);
        // of 1001 values: mean of squares 1 + 6 t + 9 t^2, with mean t 5 and t^2 (n (2n + 1) / 6)
        // dt^2
        const double square = 1e-4 * 1000.0 * 2001.0 / 6.0;
        QCOMPARE(of(Reduction::Rms), std::sqrt(1.0 + 30.0 + 9.0 * square));
    }

    // A torn line is left out, as are counts that are none; rows that are there twice are taken
    // once, keys tell all apart.
    void ledgersKeepWhatWasFlown()
    {
        const QTemporaryDir folder;
        const auto runs = pathIn(folder, "s.ripstop-runs");
        FlightResult flight;
        flight.time = 0.1;
        flight.steps = 24;
        flight.hash = "00000000000000ff";
        flight.torn = 1;
        flight.firstTear = 0.05;
        flight.firstTearUnit = "N/m";
        flight.stopped = "a \"reason\"\n";
        flight.inaccurate = "missed";
        flight.measured = {1.0 / 3.0, std::nan("")};
        {
            auto ledger = Ledger::open(runs, "shard-1-of-2", {"a", "b"}, "design");
            QVERIFY(ledger);
            QVERIFY(!ledger->add("k1", flight));
            QVERIFY(!ledger->add("k1", flight));
        }
        std::ofstream(runs / "shard-1-of-2.jsonl", std::ios::app)
            << R"({"key":"k5","time":1,"steps":1e300,"hash":"00","torn":0,"measured":[1,2]})"
               "\n"
            << R"({"key":"k6","time":1,"steps":2,"hash":"00","torn":-1,"measured":[1,2]})"
               "\n"
            << R"({"key":"k2","time":0.)";
        {
            auto ledger = Ledger::open(runs, "shard-1-of-2", {"a", "b"}, "design");
            flight.hash = "0000000000000100";
            QVERIFY(!ledger->add("k3", flight));
            QVERIFY(!ledger->add("k1", flight)); // another hash: somebody should know
        }
        std::ofstream(runs / "shard-2-of-2.jsonl")
            << R"({"program":"Ripstop 0.1.0","design":"design","measures":["a","b"]})"
               "\n"
            << R"({"key":"k4","time":1,"steps":2,"hash":"00","torn":0,"measured":[1,2]})"
               "\n";
        const auto content = readLedgers(runs);
        QVERIFY(content);
        QCOMPARE(content->other.rows, std::size_t(1)); // this build's are not among them
        QCOMPARE(content->other.program, std::string("Ripstop 0.1.0"));
        QCOMPARE(content->rows.size(), std::size_t(3));
        QCOMPARE(content->torn, std::size_t(3));
        QCOMPARE(content->differing, std::size_t(1));
        const FlightResult& row = content->rows.at("k1");
        QCOMPARE(row.time, 0.1);
        QCOMPARE(row.steps, std::int64_t(24));
        QCOMPARE(row.hash, std::string("00000000000000ff"));
        QCOMPARE(row.firstTear, 0.05);
        QVERIFY(std::isnan(row.firstTearLoad));
        QCOMPARE(row.firstTearUnit, std::string("N/m"));
        QCOMPARE(row.stopped, std::string("a \"reason\"\n"));
        QCOMPARE(row.inaccurate, std::string("missed"));
        QCOMPARE(row.measured[0], 1.0 / 3.0);
        QVERIFY(std::isnan(row.measured[1]));
    }

    void keysHangOnAllThatMatters()
    {
        const Scene scene = tether();
        FlightPlan plan;
        plan.seconds = 1.0;
        const auto keys = FlightKeys::of(scene, {}, plan);
        std::set<std::string> all{keys->of({"a=1", "b=2"}), keys->of({"a=1b", "=2"}),
                                  keys->of({"a=1"}), keys->of({})};
        QCOMPARE(keys->of({"a=1"}), FlightKeys::of(scene, {}, plan)->of({"a=1"}));
        plan.untilTear = true;
        all.insert(FlightKeys::of(scene, {}, plan)->of({}));
        plan.measures.push_back({"height", Reduction::Last, 0.0, 0.0, 1.0});
        all.insert(FlightKeys::of(scene, {}, plan)->of({}));
        Scene other = scene;
        other.settings.timeStep *= 0.5;
        all.insert(FlightKeys::of(other, {}, plan)->of({}));
        QCOMPARE(all.size(), std::size_t(7));
    }

    // Between two steps one is told how far the flight is, and may end it there.
    void tellsHowFarAFlightIs()
    {
        StudyProgress progress;
        std::vector<double> shares;
        FlightPlan plan;
        plan.seconds = 0.5;
        plan.progress = &progress;
        plan.isInterrupted = [&] {
            shares.push_back(progress.underWay());
            return false;
        };
        QVERIFY(fly(tether(), {}, plan));
        QVERIFY(shares.size() > 10);
        QVERIFY(std::ranges::is_sorted(shares));
        QCOMPARE(shares.front(), 0.0);
        for (std::size_t i = 0; i < shares.size(); ++i) // steps are of one length
            QVERIFY(std::abs(shares[i] - double(i) / double(shares.size())) < 1e-6);
        QCOMPARE(progress.underWay(), 0.0); // it is over

        plan.isInterrupted = [&] { return progress.underWay() > 0.5; };
        QVERIFY(!fly(tether(), {}, plan));
        QCOMPARE(progress.underWay(), 0.0);
    }

    // W (1 + sqrt(1 + 2 h k / W)) is the most that a tether of stiffness k pulls when the weight W
    // has fallen by h: it tears where its limit is less. With default settings, every cell of the
    // map is right that is farther from the border than the time step loses of the swing.
    void tetherTearsWhereItShould()
    {
        constexpr int side = 12;
        const double weight = 9.80665;
        const Scene base = tether();
        FlightPlan plan;
        plan.seconds = 1.0;
        plan.untilTear = true;
        int torn = 0, held = 0;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const double k =
                    quantile({Distribution::Kind::Log, 100.0, 2000.0}, (i + 0.5) / side);
                const double limit =
                    quantile({Distribution::Kind::Log, 20.0, 400.0}, (j + 0.5) / side);
                const double most = weight * (1.0 + std::sqrt(1.0 + 2.0 * 0.5 * k / weight));
                if (std::abs(std::log(limit / most)) < 0.125) // half a cell of log 20 / 12
                    continue;
                Scene scene = base;
                for (const auto& [path, value] :
                     {std::pair("cord.compliance", 1.0 / k), std::pair("cord.tearLimit", limit)}) {
                    const auto edit = assignment(
                        scene, path + ('=' + QString::number(value, 'g', 17).toStdString()));
                    QVERIFY2(edit, edit ? "" : edit.message().english().c_str());
                    static_cast<void>(apply(scene, *edit));
                }
                const auto flight = fly(scene, {}, plan);
                QVERIFY2(flight->stopped.empty(), flight->stopped.c_str());
                QVERIFY2((flight->torn > 0) == (limit < most),
                         qPrintable(QString("k %1, limit %2, most %3, torn %4")
                                        .arg(k)
                                        .arg(limit)
                                        .arg(most)
                                        .arg(flight->torn)));
                QCOMPARE(flight->firstTearUnit, std::string(flight->torn > 0 ? "N" : ""));
                (flight->torn > 0 ? torn : held)++;
            }
        QVERIFY(torn > 30 && held > 30);
    }
};

const RegisteredTest registered("test_study", runWithCore<TestStudy>);

} // namespace ripstop::test_study
#include "test_study.moc"
