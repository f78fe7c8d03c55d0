// The cases of ripstop-cli verify: each holds, and the list is what its readers expect.
//
// Stages: every case is run and has to hold; then the list (ids, texts, filter) and how tolerances
// and results are put into words; the references; and the command itself.
#include "registered_test.h"
#include "verify/case.h"
#include "verify/reference.h"
#include "verify/text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

#include <cmath>
#include <limits>
#include <set>

namespace ripstop::test_verify {

class TestVerify : public QObject
{
    Q_OBJECT

    const std::vector<Case> m_cases = allCases();

private slots:
    void holds_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < m_cases.size(); ++i)
            QTest::newRow(
                qPrintable(QString::fromStdString(m_cases[i].id + " " + m_cases[i].title)))
                << int(i);
    }

    void holds()
    {
        QFETCH(int, index);
        const CaseResult result = run(m_cases[std::size_t(index)]);
        QVERIFY2(
            result.holds,
            qPrintable(QString("got %1, expected %2, tolerance %3")
                           .arg(result.got, 0, 'g', 12)
                           .arg(result.expected, 0, 'g', 12)
                           .arg(QString::fromStdString(textOf(result.tolerance, result.unit)))));
    }

    void everyCaseSaysWhatItIs()
    {
        QVERIFY(m_cases.size() >= 70);
        std::set<std::string> titles;
        for (const Case& one : m_cases) {
            const QString name = QString::fromStdString(one.id + " " + one.title);
            QVERIFY2(!one.id.empty() && !one.title.empty() && !one.source.empty()
                         && !one.section.empty(),
                     qPrintable(name));
            QVERIFY2(titles.insert(name.toStdString()).second,
                     qPrintable(name + " is there twice"));
            QVERIFY2(std::isfinite(one.expected), qPrintable(name));
        }
    }

    void filter()
    {
        QCOMPARE(casesWith("").size(), m_cases.size());
        QVERIFY(casesWith("no such case").empty());
        const std::vector<Case> pendulum = casesWith("PENDULUM");
        QVERIFY(!pendulum.empty() && pendulum.size() < m_cases.size());
        for (const Case& one : casesWith("t-k5"))
            QCOMPARE(one.id, std::string("T-K5"));
    }

    void tolerances_data()
    {
        QTest::addColumn<double>("got");
        QTest::addColumn<double>("expected");
        QTest::addColumn<int>("rule");
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("held");
        const auto row = [](const char* name, double got, double expected, Tolerance tolerance,
                            bool held) {
            QTest::newRow(name) << got << expected << int(tolerance.rule) << tolerance.value
                                << held;
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        row("exact", 3.0, 3.0, exactly, true);
        row("not exact", 3.0000001, 3.0, exactly, false);
        row("at the edge", 3.5, 3.0, within(0.5), true);
        row("beyond the edge", 2.4, 3.0, within(0.5), false);
        row("a share of a negative number", -101.0, -100.0, relative(0.01), true);
        row("more than its share", -102.0, -100.0, relative(0.01), false);
        row("at most", 2.0, 2.0, atMost, true);
        row("more", 2.1, 2.0, atMost, false);
        row("at least", 2.0, 2.0, atLeast, true);
        row("less", 1.9, 2.0, atLeast, false);
        row("not a number, within", nan, 1.0, within(1e9), false);
        row("not a number, share", nan, 1.0, relative(1e9), false);
        row("not a number, at most", nan, 1.0, atMost, false);
        row("not a number, at least", nan, 1.0, atLeast, false);
    }

    void tolerances()
    {
        QFETCH(double, got);
        QFETCH(double, expected);
        QFETCH(int, rule);
        QFETCH(double, value);
        QTEST(ripstop::holds(got, expected, {Rule(rule), value}), "held");
    }

    void resultsInWords()
    {
        ReferenceResult result;
        result.got = 5.0 / 3.0;
        result.ratio = 2.0 / 3.0;
        QCOMPARE(publishedText(0.65, 0.85), std::string("0.65 to 0.85"));
        QCOMPARE(publishedText(3.5, 3.5), std::string("3.5"));
        QCOMPARE(gotText(result), std::string("1.667"));
        QCOMPARE(ratioText(result), std::string("0.67"));
        result.got = result.ratio = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(gotText(result), std::string("not reached"));
        QCOMPARE(ratioText(result), std::string());
    }

    void toleranceInWords()
    {
        QCOMPARE(textOf(within(0.001), "m"), std::string("0.001 m"));
        QCOMPARE(textOf(within(0.1), ""), std::string("0.1"));
        QCOMPARE(textOf(relative(0.001), "m"), std::string("0.1 % of expected"));
        QCOMPARE(textOf(relative(1e-12), "m"), std::string("1e-12 of expected"));
        QCOMPARE(textOf(exactly, "m"), std::string("exact"));
        QCOMPARE(textOf(atMost, "m"), std::string("at most"));
        QCOMPARE(textOf(atLeast, "m"), std::string("at least"));
    }

    // No row must hold, but each is about something that was published.
    void references()
    {
        const std::vector<Reference> references = allReferences();
        QVERIFY(references.size() >= 20);
        std::set<std::string> titles;
        for (const Reference& one : references) {
            const QString name = QString::fromStdString(one.title + ", " + one.note);
            QVERIFY2(one.low > 0.0 && one.high >= one.low, qPrintable(name));
            QVERIFY2(!one.section.empty() && !one.source.empty() && !one.note.empty(),
                     qPrintable(name));
            QVERIFY2(titles.insert(name.toStdString()).second,
                     qPrintable(name + " is there twice"));
        }
        const std::vector<Reference> cups = referencesWith("CUP");
        QVERIFY(!cups.empty() && cups.size() < references.size());
        const ReferenceResult cup = run(cups[0]);
        QCOMPARE(cup.ratio, cup.got / (0.5 * (cup.low + cup.high)));
        QCOMPARE(cup.inside, cup.got >= cup.low && cup.got <= cup.high);
    }

    void command()
    {
        QProcess process;
        process.start(CLI_PROGRAM, {"verify", "--filter", "T-K5", "--json"});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 0);
        const QJsonObject object =
            QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QCOMPARE(object["do_not_hold"].toInt(-1), 0);
        QCOMPARE(object["cases"].toInt(), int(casesWith("T-K5").size()));
        const QJsonArray results = object["results"].toArray();
        QCOMPARE(results.size(), object["cases"].toInt());
        for (const char* key : {"id", "section", "title", "expected", "got", "tolerance",
                                "tolerance_rule", "unit", "source", "holds", "seconds"})
            QVERIFY2(results[0].toObject().contains(key), key);

        process.start(CLI_PROGRAM, {"verify", "--filter", "T-K5"});
        QVERIFY(process.waitForFinished(60000));
        const QByteArray table = process.readAllStandardOutput();
        QVERIFY2(table.contains("All " + QByteArray::number(results.size()) + " cases hold"),
                 table);

        process.start(CLI_PROGRAM, {"verify", "--references", "--filter", "head on", "--json"});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 0);
        const QJsonArray compared = QJsonDocument::fromJson(process.readAllStandardOutput())
                                        .object()["references"]
                                        .toArray();
        QCOMPARE(compared.size(), int(referencesWith("head on").size()));
        QVERIFY(compared[0].toObject()["ratio"].toDouble() > 0.0);

        process.start(CLI_PROGRAM, {"verify", "--references", "--list"});
        QVERIFY(
            process.waitForFinished(60000)); // it must not run what it lists: that takes minutes
        QCOMPARE(process.exitCode(), 0);
        const QByteArray list = process.readAllStandardOutput();
        for (const Reference& reference : allReferences())
            QVERIFY2(list.contains(reference.title.c_str()), reference.title.c_str());

        process.start(CLI_PROGRAM, {"verify", "--filter", "no such case"});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 2);
    }
};

const RegisteredTest registered("test_verify", runWithCore<TestVerify>);

} // namespace ripstop::test_verify
#include "test_verify.moc"
