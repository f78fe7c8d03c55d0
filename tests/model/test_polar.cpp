// Polars of air laws and the published curves beside them (validation 3.6).
//
// Stages: published values by hand; the identities that rows of a polar must meet; then the
// command of ripstop-cli, and its refusals.
#include "model/cli_call.h"
#include "registered_test.h"

#include "compile/resolve.h"
#include "measure/polar.h"

#include <QJsonArray>
#include <QtTest>

#include <numbers>

namespace ripstop::test_polar {

namespace {

Outcome polar(const QStringList& arguments) { return call(QStringList{"polar"} + arguments); }

double normalAt30(const QStringList& arguments)
{
    const QJsonArray rows = polar(arguments + QStringList{"--json"}).json()["rows"].toArray();
    const QJsonObject row = rows[6].toObject();
    return row["angle"].toDouble() == 30.0 ? row["CN"].toDouble() : -1.0;
}

} // namespace

class TestPolar : public QObject
{
    Q_OBJECT

private slots:
    void references_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<QList<double>>("expected");
        const auto row = [](double degrees, QList<double> expected) {
            QTest::addRow("3.6 at %g degrees", degrees) << degrees << expected;
        };
        row(5.0, {0.030, 0.010, 0.128, 0.288, 0.218, 0.274, 0.174});
        row(10.0, {0.121, 0.039, 0.240, 0.540, 0.399, 0.548, 0.347});
        row(15.0, {0.268, 0.086, 0.338, 0.761, 0.550, 0.822, 0.518});
        row(20.0, {0.468, 0.150, 0.424, 0.953, 0.676, 1.097, 0.684});
        row(30.0, {1.000, 0.320, 0.564, 1.269, 0.863, 1.645, 1.000});
        row(60.0, {3.000, 0.960, 0.810, 1.822, 1.119, 3.290, 1.732});
        row(90.0, {4.000, 1.280, 0.880, 1.980, 1.168, 4.935, 2.000});
    }

    // Worked out by hand from the published formulas, to half a digit and that rounding.
    void references()
    {
        QFETCH(double, degrees);
        QFETCH(QList<double>, expected);
        const auto references = polarReferences();
        QCOMPARE(qsizetype(references.size()), expected.size());
        for (std::size_t i = 0; i < references.size(); ++i) {
            const double got = rowOf(references[i], degrees).normal;
            QVERIFY2(std::abs(got - expected[qsizetype(i)]) < 0.00105,
                     qPrintable(QString("%1: %2").arg(references[i].key.data()).arg(got)));
        }
    }

    // C_N^2 = C_L^2 + C_D^2 of a law without friction, whose force is normal; friction adds a drag.
    void rows()
    {
        Material material;
        material.skinFriction = 0.0;
        const std::vector<PolarRow> rows = platePolar(airOf(Id{1}, material), 7.5);
        QCOMPARE(rows.size(), std::size_t(13));
        QCOMPARE(rows.back().degrees, 90.0);
        for (const PolarRow& row : rows) {
            const double alpha = row.degrees * std::numbers::pi / 180.0;
            QVERIFY(std::abs(row.normal - 2.0 * std::sin(alpha)) < 1e-12);
            QVERIFY(std::abs(std::hypot(row.lift, row.drag) - row.normal) < 1e-12);
        }
        material.skinFriction = 0.03;
        QVERIFY(std::abs(platePolar(airOf(Id{1}, material), 90.0).front().drag - 0.03) < 1e-12);
    }

    // At 30 degrees the paper's law and a flat plate have 1, Lindenburg 1.269, the blend of 4.1
    // 0.79.
    void program()
    {
        QVERIFY(std::abs(normalAt30({"paper"}) - 1.0) < 1e-12);
        QVERIFY(std::abs(normalAt30({"linear_normal"}) - 1.0) < 1e-12);
        QVERIFY(std::abs(normalAt30({"lift_drag"}) - 1.269) < 2e-3);
        const double blended = normalAt30({"linear_normal", "--set", "plate.normalCoefficient=2.44",
                                           "--set", "plate.broadsideCoefficient=1.17"});
        QVERIFY(std::abs(blended - 0.79) < 5e-3);

        const QString kite = SCENES_DIR "/delta_kite.ripstop.json";
        QCOMPARE(polar({kite, "--material", "sail"}).exitCode, 0);
        const QByteArray csv = polar({"paper", "--step", "30", "--csv"}).out;
        QVERIFY(csv.startsWith("angle,CN,CL,CD,paper,"));
        QCOMPARE(csv.count('\n'), 5);
    }

    // Bad input is told in a sentence that names the remedy.
    void mistakes_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const QString kite = SCENES_DIR "/delta_kite.ripstop.json";
        QTest::newRow("no material named") << QStringList{kite} << "--material";
        QTest::newRow("unknown material") << QStringList{kite, "--material", "silk"} << "silk";
        QTest::newRow("no such file") << QStringList{"nowhere.json"} << "nowhere.json";
        QTest::newRow("bad number")
            << QStringList{"paper", "--set", "plate.porosity=2"} << "at most 1";
        QTest::newRow("drag below zero")
            << QStringList{"lift_drag", "--set", "plate.polar=0, 0, 0; 90, 0, -1"} << "drag";
        QTest::newRow("angles fall")
            << QStringList{"lift_drag", "--set", "plate.polar=9, 0, 0; 3, 0, 1"} << "rise";
        QTest::newRow("two columns")
            << QStringList{"lift_drag", "--set", "plate.polar=9, 0; 13, 1"} << "3 numbers";
    }
    void mistakes()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        const Outcome outcome = polar(arguments);
        QVERIFY(outcome.exitCode == 1 || outcome.exitCode == 2);
        QVERIFY2(outcome.error.contains(says), qPrintable(outcome.error));
    }
};

const RegisteredTest registered("test_polar", runPlain<TestPolar>);

} // namespace ripstop::test_polar
#include "test_polar.moc"
