// ripstop-cli bench: what its figures mean.
#include "model/cli_call.h"
#include "registered_test.h"

#include <QJsonArray>
#include <QtTest>

#include <cmath>

namespace ripstop::test_cli_bench {

class TestCliBench : public QObject
{
    Q_OBJECT

private slots:
    void benchMeasuresProjections()
    {
        const Outcome outcome = call({"bench", "--race", "projection", "--filter", "glider",
                                      "--seconds", "0.02", "--threads", "2", "--json"});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const QJsonObject all = outcome.json();
        QVERIFY(!all["machine"].toObject()["compiler"].toString().isEmpty());
        const QJsonArray rows = all["projection"].toArray();
        QCOMPARE(rows.size(), 2); // one thread, and two
        const QJsonObject row = rows.first().toObject();
        QCOMPARE(row["particles"].toInt(), 49);
        QCOMPARE(row["rods"].toInt(), 198);
        // the definition, from the other figures
        const double projections = row["steps_per_second"].toObject()["median"].toDouble()
                                   * row["substeps"].toDouble() * row["sweeps"].toDouble() * 198.0;
        const QJsonObject cost = row["ns_per_projection"].toObject();
        QVERIFY(std::abs(cost["median"].toDouble() * projections - 1e9) < 1.0);
        QVERIFY(cost["quiet"].toDouble() <= cost["median"].toDouble());
        QVERIFY(cost["median"].toDouble() <= cost["slow"].toDouble());
        QCOMPARE(all["whole_steps"].toArray().first().toObject()["panels"].toInt(), 64);
        QVERIFY(!all["targets"].toArray().isEmpty());
    }

    // Every effort that is reported keeps the strain below its limit and the path within 50 mm.
    void benchFindsEfforts()
    {
        const Outcome outcome = call({"bench", "--race", "quality", "--filter", "cloth_10",
                                      "--quick", "--seconds", "0.2", "--json"});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        int reached = 0;
        for (const QJsonValue& value : outcome.json()["quality"].toArray()) {
            const QJsonObject row = value.toObject();
            if (!row["reached"].toBool())
                continue;
            ++reached;
            QVERIFY(row["strain"].toDouble() < row["limit"].toDouble());
            QVERIFY(row["path_error_m"].toDouble() < 0.05 || !row["path_counts"].toBool());
        }
        QVERIFY(reached > 0);
    }
};

const RegisteredTest registered("test_cli_bench", runWithCore<TestCliBench>);

} // namespace ripstop::test_cli_bench
#include "test_cli_bench.moc"
