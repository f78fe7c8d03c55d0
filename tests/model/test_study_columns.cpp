// A study as columns: percentiles over a variable, what lies in brushes, and where a file of a
// study is broken.
#include "registered_test.h"
#include "study/study_columns.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <deque>

namespace ripstop::test_study_columns {

namespace {

// Flights of which each has one number.
struct Flown
{
    std::deque<FlightResult> rows;
    StudyFlights flights;
    StudyColumn variable{"wind (m/s)", {}, {}, false};
    StudyColumn reading{"pull (N)", {}, {}, false};

    void add(double x, double y, const std::string& stopped = {})
    {
        FlightResult& row = rows.emplace_back();
        row.stopped = stopped;
        row.measured = {y};
        flights.push_back(&row);
        variable.value.push_back(x);
        reading.value.push_back(stopped.empty() ? y : std::nan(""));
    }
    std::vector<StudyBand> bands() const { return bandsOf(variable, reading, flights); }
};

constexpr const char* study = R"({
  "format": "ripstop-study", "version": 1,
  "scene": "a.ripstop.json",
  "seconds": 2,
  "variables": [{"paths": ["a.b"], "values": [1]}]
})";

constexpr const char* placed = R"({
  "format": "ripstop-study", "version": 1,
  "scene": "a.ripstop.json",
  "seconds": 1,
  "variables": [{"paths": ["a.b"], "values": [1]}],
  "plan": {"kind": "grid"}
})";

QString failureOf(const std::string& text)
{
    const auto read = studyOf(text);
    return read ? QString() : QString::fromStdString(read.message().english());
}

} // namespace

class TestStudyColumns : public QObject
{
    Q_OBJECT

private slots:
    // Of the numbers 0 to 100 the n-th percentile is n; with ten times as much at the second value.
    void percentilesOfRepeats()
    {
        Flown flown;
        for (int i = 0; i <= 100; ++i) {
            const int shuffled = (37 * i) % 101;
            flown.add(8.0, 10.0 * shuffled);
            flown.add(5.0, shuffled);
        }
        flown.add(8.0, 0.0, "diverged");
        const auto bands = flown.bands();
        QCOMPARE(bands.size(), std::size_t(2));
        QCOMPARE(bands[0].x, 5.0);
        QCOMPARE(bands[1].x, 8.0);
        for (std::size_t i = 0; i < bandPercents.size(); ++i) {
            QVERIFY(std::abs(bands[0].value[i] - bandPercents[i]) < 1e-9);
            QVERIFY(std::abs(bands[1].value[i] - 10.0 * bandPercents[i]) < 1e-9);
        }
        QCOMPARE(bands[0].failed, std::size_t(0));
        QCOMPARE(bands[1].failed, std::size_t(1));
        QCOMPARE(bands[1].counted, std::size_t(101));
        QCOMPARE(bands[1].points.size(), std::size_t(102));
    }

    void aValueEachIsACurve()
    {
        Flown flown;
        for (const double x : {3.0, 1.0, 2.0})
            flown.add(x, x * x);
        flown.flights.push_back(nullptr); // and one that is not flown
        flown.variable.value.push_back(4.0);
        flown.reading.value.push_back(std::nan(""));
        const auto bands = flown.bands();
        QCOMPARE(bands.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i)
            for (const double value : bands[i].value)
                QCOMPARE(value, double((i + 1) * (i + 1)));
    }

    // Of a thousand values that are all different, in bands of neighbours: with y = x evenly from 0
    // to 1, the percentiles of a band of width w round m are m + (n / 100 - 1 / 2) w.
    void neighboursAreTakenTogether()
    {
        Flown flown;
        constexpr int count = 1000;
        for (int i = 0; i < count; ++i) {
            const double x = double((389 * i) % count) / count;
            flown.add(x, x);
        }
        const auto bands = flown.bands();
        QVERIFY(bands.size() > 5 && bands.size() < 100);
        std::size_t all = 0;
        for (const StudyBand& band : bands) {
            all += band.points.size();
            const double width = double(band.points.size() - 1) / count;
            for (std::size_t i = 0; i < bandPercents.size(); ++i)
                QVERIFY(std::abs(band.value[i] - band.x - (bandPercents[i] / 100.0 - 0.5) * width)
                        < 1e-9);
        }
        QCOMPARE(all, std::size_t(count));
    }

    // What lies in all of them; what has no number lies in none.
    void brushes()
    {
        const StudyColumn a{"a", {1.0, 2.0, 3.0, std::nan("")}, {}, false};
        const StudyColumn b{"b", {4.0, 1.0, 1.0, 1.0}, {}, false};
        using Points = std::vector<std::size_t>;
        QCOMPARE(pointsIn({a, b}, {{0, {1.5, 9.0}}}), (Points{1, 2}));
        QCOMPARE(pointsIn({a, b}, {{0, {0.0, 2.0}}, {1, {0.0, 2.0}}}), (Points{1}));
        QCOMPARE(pointsIn({a, b}, {{1, {1.0, 1.0}}}), (Points{1, 2, 3}));
    }

    void brokenFilesNameThePlace()
    {
        const std::string text = study;
        QCOMPARE(failureOf(text), QString());
        const auto at = [&](const std::string& words) { return text.find(words); };
        // without a comma after the scene the next line does not fit
        std::string noComma = text;
        noComma.erase(at(",\n  \"seconds\""), 1);
        QVERIFY2(failureOf(noComma).contains("line 4, column 3"), qPrintable(failureOf(noComma)));
        const QString cut = failureOf(text.substr(0, at("[\"a.b\"")));
        QVERIFY2(cut.contains("line 5"), qPrintable(cut));
        QVERIFY2(failureOf("no study at all").contains("line 1, column "),
                 qPrintable(failureOf("no study at all")));
        QVERIFY2(failureOf("").contains("line 1"), qPrintable(failureOf("")));
        std::string zero = text + std::string(1, '\0');
        QVERIFY2(failureOf(zero).contains("line 6"), qPrintable(failureOf(zero)));
        QCOMPARE(failureOf("{}"), QString("is no study"));
    }

    // Lines and columns as an editor counts them; of what is missing that of what should hold it.
    void wrongFieldsNameThePlace_data()
    {
        QTest::addColumn<int>("line");
        QTest::addColumn<int>("column");
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::newRow("no number") << 4 << 3 << R"("seconds": 1)"
                                   << R"("seconds": "one")";
        QTest::newRow("misspelt") << 4 << 17 << R"("seconds": 1)"
                                  << R"("seconds": 1, "til": 2)";
        QTest::newRow("no list") << 5 << 18 << R"(["a.b"])"
                                 << R"("a.b")";
        QTest::newRow("in a list") << 5 << 33 << R"(["a.b"])"
                                   << R"(["a", 5])";
        QTest::newRow("in a plan") << 6 << 29 << R"("grid")"
                                   << R"("sobol", "count": 0)";
        QTest::newRow("none of it") << 6 << 3 << R"("grid")"
                                    << R"("sobol")";
    }

    void wrongFieldsNameThePlace()
    {
        QFETCH(int, line);
        QFETCH(int, column);
        QFETCH(QString, before);
        QFETCH(QString, after);
        QString text = placed;
        QVERIFY(text.contains(before));
        const QTemporaryDir folder;
        QFile file(folder.filePath("a.ripstop-study.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text.replace(before, after).toUtf8());
        file.close();
        const auto read = readStudy(file.fileName().toStdString());
        QVERIFY(!read);
        const QString said = QString::fromStdString(read.message().english());
        QVERIFY2(said.contains(QString("(line %1, column %2) has").arg(line).arg(column)),
                 qPrintable(said));
    }
};

const RegisteredTest registered("test_study_columns", runPlain<TestStudyColumns>);

} // namespace ripstop::test_study_columns
#include "test_study_columns.moc"
