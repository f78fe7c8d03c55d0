// What a study came to: indices of sensitivity of functions whose indices are known, the report,
// and the database, which Python's own reader reads back.
#include "model/cli_call.h"
#include "registered_test.h"
#include "study/plan.h"
#include "study/sensitivity.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_study_report {

namespace {

using Function = std::function<double(const std::vector<double>&)>;

StudyVariable variableOf(const char* name, Distribution spread)
{
    return {name, {name}, {}, spread};
}

Sensitivity sensitivity(std::vector<StudyVariable> variables, int count, std::uint64_t seed,
                        const Function& function)
{
    Study study;
    study.plan.kind = StudyPlan::Kind::Sensitivity;
    study.plan.count = count;
    study.plan.seed = seed;
    study.variables = std::move(variables);
    const auto points = StudyPoints::of(study);
    std::vector<double> values;
    for (std::size_t i = 0; i < points->count(); ++i) {
        std::vector<double> x;
        for (const std::string& value : points->values(i))
            x.push_back(std::stod(value));
        values.push_back(function(x));
    }
    return sensitivityOf(values, study.variables.size());
}

// Ishigami and Homma (1990) with a = 7 and b = 0.1.
double ishigami(const std::vector<double>& x)
{
    const double sine = std::sin(x[1]);
    return std::sin(x[0]) + 7.0 * sine * sine + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

std::vector<StudyVariable> ishigamiVariables()
{
    const Distribution angle{Distribution::Kind::Uniform, -std::numbers::pi, std::numbers::pi};
    return {variableOf("x1", angle), variableOf("x2", angle), variableOf("x3", angle)};
}

bool isNear(const ConfidenceBand& band, double known, double tolerance)
{
    return std::abs(band.value - known) <= tolerance;
}

} // namespace

class TestStudyReport : public QObject
{
    Q_OBJECT

private slots:
    // Known values of the function: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2. The spread of the
    // estimate over seeds is 0.004 with 4096 points of Sobol', and 0.015 is four times of that.
    void ishigamisIndices()
    {
        constexpr double first[]{0.31391, 0.44241, 0.0};
        constexpr double total[]{0.55759, 0.44241, 0.24368};
        for (const std::uint64_t seed : {1, 2, 3}) {
            const Sensitivity found = sensitivity(ishigamiVariables(), 4096, seed, ishigami);
            QCOMPARE(found.blocks, std::size_t(4096));
            QVERIFY(std::abs(found.mean - 3.5) < 0.05);
            QVERIFY(std::abs(found.variance - 13.84459) < 0.2);
            for (std::size_t v = 0; v < 3; ++v) {
                const auto& [one, all] = found.variables[v];
                QVERIFY2(isNear(one, first[v], 0.015), qPrintable(QString::number(one.value)));
                QVERIFY2(isNear(all, total[v], 0.015), qPrintable(QString::number(all.value)));
                QVERIFY(one.low <= first[v] && first[v] <= one.high);
                QVERIFY(all.low <= total[v] && total[v] <= all.high);
            }
        }
    }

    // The speed of descent sqrt(2 m g / (rho Cd A)), nearly linear in its logarithm: variances of
    // 5 % of m, 5 % of Cd and 2 * 2 % of the diameter are as 0.25 : 0.25 : 0.16 of 0.66.
    void speedOfDescent()
    {
        const std::vector<StudyVariable> variables{
            variableOf("m", {Distribution::Kind::Normal, 90.0, 4.5}),
            variableOf("Cd", {Distribution::Kind::Normal, 1.5, 0.075}),
            variableOf("D", {Distribution::Kind::Normal, 8.0, 0.16})};
        const Sensitivity found = sensitivity(variables, 4096, 1, [](const auto& x) {
            return std::sqrt(8.0 * x[0] * 9.80665
                             / (1.225 * x[1] * std::numbers::pi * x[2] * x[2]));
        });
        constexpr double known[]{0.37879, 0.37879, 0.24242};
        for (std::size_t v = 0; v < 3; ++v) {
            QVERIFY(isNear(found.variables[v].first, known[v], 0.015));
            QVERIFY(isNear(found.variables[v].total, known[v], 0.015));
        }
        QVERIFY(std::abs(std::sqrt(found.variance) / found.mean - 0.04062) < 0.0005);
    }

    void blocksThatAreNotWholeAreLeftOut()
    {
        // f = x, of blocks {A, B, AB}
        const Sensitivity found =
            sensitivityOf({0.1, 0.9, 0.9, 0.3, std::nan(""), 0.2, 0.7, 0.2, 0.2, 0.4, 0.6, 0.6}, 1);
        QCOMPARE(found.blocks, std::size_t(3));
        QCOMPARE(found.leftOut, std::size_t(1));
        QVERIFY(sensitivityOf({1.0, 2.0, 3.0}, 1).variables.empty());
        // of nothing that varies there are no indices
        const Sensitivity flat = sensitivityOf({1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, 1);
        QVERIFY(std::isnan(flat.variables[0].first.value));
    }

    // A longer plan begins with the shorter one.
    void longerPlansKeepTheirPoints()
    {
        Study study;
        study.plan.kind = StudyPlan::Kind::Sensitivity;
        study.plan.count = 8;
        study.variables = ishigamiVariables();
        const auto shorter = StudyPoints::of(study);
        QCOMPARE(shorter->count(), std::size_t(40));
        study.plan.count = 16;
        const auto longer = StudyPoints::of(study);
        for (std::size_t i = 0; i < shorter->count(); ++i)
            QCOMPARE(longer->values(i), shorter->values(i));
        // the third point of a block is that of A with the first variable of B
        QCOMPARE(shorter->values(7)[0], shorter->values(6)[0]);
        QCOMPARE(shorter->values(7)[1], shorter->values(5)[1]);
        study.variables.resize(11, study.variables.front());
        QVERIFY(!StudyPoints::of(study));
    }

    void reportAndDatabaseOfAStudy()
    {
        QTemporaryDir folder;
        const QString study = folder.filePath("s.ripstop-study.json");
        const Outcome made =
            call({"study", "new", study, "--scene", scene("pendulum"), "--vary",
                  "settings.airDensity=1..8", "--vary", "settings.gravity.y=-12..-8", "--plan",
                  "sensitivity", "--count", "16", "--seconds", "0.5"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const Outcome run = call({"study", "run", study});
        QVERIFY2(run.error.contains("Flown: 64"), qPrintable(run.error));
        const Outcome told = call({"study", "report", study});
        QVERIFY2(told.exitCode == 0, qPrintable(told.error));
        for (const char* part : {"# s.ripstop-study.json", "## Variables", "| held | 64 |",
                                 "## Sensitivity", "From 16 blocks"})
            QVERIFY2(told.out.contains(part), told.out.constData());
        const QString page = folder.filePath("s.html");
        QCOMPARE(call({"study", "report", study, "--html", "-o", page}).exitCode, 0);
        QFile file(page);
        QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().contains("<td>held<td>64"));

        const QString database = folder.filePath("s.sqlite");
        const Outcome merged = call({"study", "merge", study, "--sqlite", database});
        if (merged.error.contains("built without SQLite"))
            return;
        QVERIFY2(merged.exitCode == 0, qPrintable(merged.error));
        QCOMPARE(call({"study", "merge", study, "--sqlite", database}).exitCode, 0); // again
        // the pendulum feels no air: of a block, A and A with the density of B are one motion, and
        // so are B and A with the gravity of B
        QProcess python;
        python.start("python3", {"-c",
                                 "import sqlite3, sys\n"
                                 "d = sqlite3.connect(sys.argv[1])\n"
                                 "print(*d.execute('select count(*), count(distinct hash), "
                                 "max(typeof(\"time (s)\")) from flights').fetchone())\n"
                                 "print(*d.execute('select value from study where key=\"plan\"')"
                                 ".fetchone())",
                                 database});
        QVERIFY(python.waitForFinished());
        QCOMPARE(python.readAllStandardOutput(), QByteArray("64 32 real\nsensitivity\n"));
        // nothing else is overwritten
        const Outcome refused = call({"study", "merge", study, "--sqlite", page});
        QVERIFY2(refused.exitCode != 0 && refused.error.contains("no database"),
                 qPrintable(refused.error));
    }
};

const RegisteredTest registered("test_study_report", runPlain<TestStudyReport>);

} // namespace ripstop::test_study_report
#include "test_study_report.moc"
