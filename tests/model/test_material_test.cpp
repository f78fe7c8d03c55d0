// E t, EA and EI from tests of strips, lines and rods.
//
// Stages: curves without noise, whose stiffness is known; noise of known size, whose effect the
// theory of least squares tells; a toe of crimp; where it breaks; units and headers; bad tables;
// the own material that is made of a fit.
#include "materials/material_test.h"
#include "materials/presets.h"
#include "model/cli_call.h"
#include "model/files.h"
#include "registered_test.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <random>
#include <sstream>

namespace ripstop::test_material_test {

namespace {

const SpecimenSize strip{Specimen::Strip, 0.2, 0.05, PullDirection::Warp};

std::vector<TestPoint> pulled(double slope, int count, double longest)
{
    std::vector<TestPoint> points;
    for (int i = 0; i <= count; ++i) {
        const double x = longest * i / count;
        points.push_back({x, slope * x});
    }
    return points;
}

ElongationRange all(const std::vector<TestPoint>& points)
{
    return {points.front().elongation, points.back().elongation};
}

bool isNear(double a, double b, double share) { return std::abs(a - b) <= share * std::abs(b); }

} // namespace

class TestMaterialTest : public QObject
{
    Q_OBJECT

private slots:
    // 33.3 kgf/cm: a strip of 5 cm pulls with 1633 N per strain.
    void knownStiffness()
    {
        const double slope = 32.66e3 * 0.05;
        const auto points = pulled(slope, 50, 0.02);
        const auto fit = fitMaterialTest(points, strip, std::nullopt);
        QVERIFY(bool(fit));
        QVERIFY(isNear(fit->stiffness, 32.66e3, 1e-12));
        QVERIFY(fit->standardError < 1e-9 * fit->stiffness);
        QVERIFY(!fit->broke && !fit->strength);

        const auto line = fitMaterialTest(points, {Specimen::Line, 1.0}, std::nullopt);
        QVERIFY(isNear(line->stiffness, slope, 1e-12));

        // d = F L^3 / (48 EI): 908 g in the middle of 0.6604 m bend EI of 1.54 N m^2 by 34.7 mm
        const double span = 0.6604, weight = 0.908 * 9.80665;
        const double sag = weight * std::pow(span, 3) / (48 * 1.54);
        const auto rod =
            fitMaterialTest(pulled(weight / sag, 6, sag), {Specimen::Rod, span}, std::nullopt);
        QVERIFY(isNear(rod->stiffness, 1.54, 1e-12));
    }

    // Of forces with independent errors of s the slope has the standard deviation
    // s / sqrt(sum (x - mean)^2), the mean over many tests is the true slope, and the residual is s
    // on average. Of 400 tests the mean of slopes is within 4 / sqrt(400) of a deviation, the
    // deviation itself within 4 / sqrt(800), and 95.4 % of the slopes lie within two (+-4.2 %).
    void noiseDoesWhatTheorySays()
    {
        constexpr int tests = 400, count = 60;
        constexpr double slope = 1633.0, noise = 0.5, longest = 0.02; // N, N, 1
        const auto clean = pulled(slope, count, longest);
        double middle = 0.0, square = 0.0;
        for (const TestPoint& point : clean)
            middle += point.elongation / double(clean.size());
        for (const TestPoint& point : clean)
            square += std::pow(point.elongation - middle, 2);
        const double deviation = noise / std::sqrt(square);

        std::mt19937 random(7);
        std::normal_distribution<double> error(0.0, noise);
        double sum = 0.0, sumOfSquares = 0.0, residuals = 0.0;
        int within = 0;
        for (int test = 0; test < tests; ++test) {
            auto points = clean;
            for (TestPoint& point : points)
                point.force += error(random);
            const auto fit = fitMaterialTest(points, {Specimen::Line, 1.0}, all(clean));
            QVERIFY(bool(fit));
            const double off = fit->stiffness - slope;
            sum += off;
            sumOfSquares += off * off;
            residuals += fit->residual * fit->residual;
            within += std::abs(off) < 2.0 * fit->standardError;
        }
        QVERIFY(std::abs(sum / tests) < 4.0 * deviation / std::sqrt(tests));
        QVERIFY(isNear(std::sqrt(sumOfSquares / tests), deviation, 4.0 / std::sqrt(2.0 * tests)));
        // the last points above the largest force are cut off, so that n is a little less
        QVERIFY(isNear(std::sqrt(residuals / tests), noise, 0.05));
        QVERIFY(std::abs(double(within) / tests - 0.954) < 0.042);
    }

    // N(e) = E1 e + (E2 - E1)(e - c ln(1 + e / c)) rises from E1 to E2 about the strain c, with the
    // slope E1 + (E2 - E1) e / (c + e). A range has a slope between those at its ends; the offset
    // is that of a line that meets zero force at a strain above 0.
    void toeOfCrimp()
    {
        constexpr double soft = 800.0, stiff = 1600.0, crimp = 0.003; // N, N, 1
        std::vector<TestPoint> points;
        for (int i = 0; i <= 200; ++i) {
            const double e = 0.03 * i / 200;
            points.push_back(
                {e, soft * e + (stiff - soft) * (e - crimp * std::log(1.0 + e / crimp))});
        }
        const auto slopeAt = [](double e) { return soft + (stiff - soft) * e / (crimp + e); };
        const auto late =
            fitMaterialTest(points, {Specimen::Line, 1.0}, ElongationRange{0.02, 0.03});
        QVERIFY(late->stiffness > slopeAt(0.02) && late->stiffness < slopeAt(0.03));
        QVERIFY(late->offset < 0.0);
        const auto early =
            fitMaterialTest(points, {Specimen::Line, 1.0}, ElongationRange{0.0, 0.002});
        QVERIFY(early->stiffness > slopeAt(0.0) && early->stiffness < slopeAt(0.002));
        const auto usual = fitMaterialTest(points, {Specimen::Line, 1.0}, std::nullopt);
        QVERIFY(usual->range.from > 0.003 && usual->range.to < 0.02);
        QVERIFY(usual->stiffness > slopeAt(usual->range.from)
                && usual->stiffness < slopeAt(usual->range.to));
    }

    // A strip of 7020 I, 7355 N/m, breaks at 367.75 N.
    void whereItBreaks()
    {
        auto points = pulled(367.75 / 0.225, 90, 0.225);
        points.push_back({0.226, 40.0});
        points.push_back({0.3, 1.0});
        const auto fit = fitMaterialTest(points, strip, std::nullopt);
        QVERIFY(fit->broke && isNear(*fit->strength, 7355.0, 1e-12));
        QVERIFY(isNear(fit->highestAt, 0.225, 1e-12));
        QVERIFY(isNear(fit->stiffness, 7355.0 / 0.225, 1e-9));
        const Preset preset = presetOf(*fit, points, strip, "mine", "strip.csv");
        QVERIFY(isNear(std::get<double>(preset.breakElongation->value), 0.225, 1e-12));
        QCOMPARE(preset.values.size(), std::size_t(2));
        QVERIFY(preset.curve.points.size() >= 5 && preset.curve.points.size() <= 14);
        // of a rod F L / 4 is the moment
        const auto rod = fitMaterialTest(points, {Specimen::Rod, 0.4}, std::nullopt);
        QVERIFY(isNear(*rod->strength, 367.75 * 0.1, 1e-12));
    }

    // 100 N at 2 mm of 200 mm is the strain 0.01, however it is written.
    void unitsAndHeaders_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("force");
        QTest::addColumn<QString>("elongation");
        const auto row = [](const char* name, const char* text, const char* force = "",
                            const char* elongation = "") {
            QTest::newRow(name) << QString(text) << QString(force) << QString(elongation);
        };
        row("newtons and millimetres", "force (N),elongation (mm)\n0,0\n50,1\n100,2\n");
        row("the other order", "extension [mm];load [kN]\n0;0\n1;0.05\n2;0.1\n");
        row("per cent", "strain (%)\tforce (N)\n0\t0\n0.5\t50\n1\t100\n");
        row("strain", "# a remark\nstrain,force (daN)\n0,0\n0.005,5\n0.01,10\n");
        row("a third column", "t (s),force (N),elongation (mm)\n0,0,0\n1,50,1\n2,100,2\n");
        row("of a spreadsheet",
            "\xef\xbb\xbf\"Force (N)\",\"Elongation (mm)\"\r\n0,0\r\n50,1\r\n100,2");
        row("no header", "0,0\n50,1\n100,2\n", "N", "mm");
        row("gap in another column", "time (s),force (N),elongation (mm)\n0,0,0\n,50,1\n2,100,2\n");
        row("units beside", "force,elongation\n0,0\n50,1\n100,2\n", "N", "mm");
    }
    void unitsAndHeaders()
    {
        QFETCH(QString, text);
        QFETCH(QString, force);
        QFETCH(QString, elongation);
        const auto test = readMaterialTest(text.toStdString(), "test.csv", strip,
                                           {force.toStdString(), elongation.toStdString()});
        QVERIFY2(bool(test), test ? "" : test.message().english().c_str());
        QCOMPARE(test->points.size(), std::size_t(3));
        QVERIFY(isNear(test->points[2].elongation, 0.01, 1e-12));
        QVERIFY(isNear(test->points[2].force, 100.0, 1e-12));
        QVERIFY(!skippedText(*test));
    }

    void badTablesAreExplained_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence"); // a part of it
        const QString head = "force (N),elongation (mm)\n";
        QTest::newRow("empty") << QString() << "test.csv has no rows";
        QTest::newRow("only a header") << head << "0 rows of numbers";
        QTest::newRow("one row") << head + "1,1\n"
                                 << "1 rows of numbers";
        QTest::newRow("no header") << "0,0\n1,1\n2,2\n"
                                   << "has no header";
        QTest::newRow("other columns") << "time,speed\n1,1\n"
                                       << "line 1: The header names no column";
        QTest::newRow("no unit") << "force,elongation (mm)\n0,0\n"
                                 << "unit of the force";
        QTest::newRow("wrong unit") << "force (N),elongation (kg)\n0,0\n"
                                    << "unit of the elongation";
        QTest::newRow("gap") << head + "0,0\n,1\n2,2\n"
                             << "2 rows of numbers";
        QTest::newRow("short row") << head + "0,0\n1\n2,2\n"
                                   << "line 3: It has 1 cells instead of 2";
        QTest::newRow("text") << head + "0,0\nbroke,1\n2,2\n"
                              << "line 3: \"broke\" is no number";
        QTest::newRow("not a number") << head + "0,0\nnan,1\n2,2\n"
                                      << "\"nan\" is no number";
        QTest::newRow("decimal commas") << head + "0,0,0,0\n1,5,0,1\n"
                                        << "4 cells instead of 2";
        QTest::newRow("decimal commas beside points")
            << "force (N);elongation (mm)\n0;0\n1,500;1.5\n2;2\n"
            << "1,500 has a decimal comma";
        QTest::newRow("goes back") << head + "0,0\n2,2\n1,1\n"
                                   << "line 4: The elongation goes back";
    }
    // Loggers leave cells empty; the other rows are a test all the same.
    void rowsWithAGapAreLeftOutAndNamed()
    {
        const auto one = readMaterialTest("force (N),elongation (mm)\n0,0\n50,1\n,1.5\n100,2\n",
                                          "test.csv", strip, {});
        QVERIFY2(bool(one), one ? "" : one.message().english().c_str());
        QCOMPARE(one->points.size(), std::size_t(3));
        QCOMPARE(one->points[2].force, 100.0);
        QCOMPARE(skippedText(*one)->english(),
                 std::string("Line 4 has an empty cell and is left out."));
        const auto two =
            readMaterialTest("# a remark\nforce (N),elongation (mm)\n0,0\n,\n50,1\n80,\n100,2\n",
                             "test.csv", strip, {});
        QVERIFY(bool(two));
        QCOMPARE(skippedText(*two)->english(),
                 std::string("2 lines have an empty cell and are left out, the first of them line "
                             "4."));
    }

    // As spreadsheets write tables where decimals have a comma.
    void decimalCommasBetweenSemicolons()
    {
        const auto commas = readMaterialTest("force (N);elongation (mm)\n0;0\n1,5;1,25\n2,25;2\n",
                                             "test.csv", strip, {});
        const auto points = readMaterialTest("force (N),elongation (mm)\n0,0\n1.5,1.25\n2.25,2\n",
                                             "test.csv", strip, {});
        QVERIFY2(bool(commas), commas ? "" : commas.message().english().c_str());
        QVERIFY(bool(points));
        QCOMPARE(commas->points.size(), points->points.size());
        for (std::size_t i = 0; i < points->points.size(); ++i) {
            QCOMPARE(commas->points[i].force, points->points[i].force);
            QCOMPARE(commas->points[i].elongation, points->points[i].elongation);
        }
    }

    void badTablesAreExplained()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        const auto points = readMaterialTest(text.toStdString(), "test.csv", strip, {});
        QVERIFY(!points);
        const QString said = QString::fromStdString(points.message().english());
        QVERIFY2(said.contains(sentence), qPrintable(said));
    }

    void badFitsAreExplained()
    {
        const auto says = [](const Result<MaterialFit>& fit, const char* part) {
            return !fit && fit.message().english().find(part) != std::string::npos;
        };
        QVERIFY(says(fitMaterialTest({{0, 3}, {1, 2}, {2, 1}}, strip, std::nullopt),
                     "falls from the first row"));
        QVERIFY(says(fitMaterialTest({{0, 0}, {1, -1}, {2, -2}}, strip, std::nullopt),
                     "never above 0"));
        QVERIFY(says(fitMaterialTest(pulled(10, 10, 0.1), strip, ElongationRange{0.5, 0.6}),
                     "There are 0 points between 50 and 60 %"));
        QVERIFY(says(fitMaterialTest({{1, 0}, {1, 1}, {1, 2}}, strip, std::nullopt), "points"));
        QVERIFY(says(fitMaterialTest({{1, 0}, {1, 1}, {1, 2}}, strip, ElongationRange{0, 2}),
                     "same elongation"));
        const SpecimenSize none{Specimen::Strip, 0.2, 0.0};
        QVERIFY(!readMaterialTest("force (N),elongation (mm)\n0,0\n1,1\n2,2", "a", none, {}));
    }

    void commandLine()
    {
        const QTemporaryDir folder;
        const QString test = folder.filePath("cord.csv"), own = folder.filePath("own.json");
        QByteArray rows = "force (N),elongation (mm)\n";
        for (int i = 0; i <= 20; ++i) // EA of 12 kN, 1 m
            rows += QByteArray::number(12.0 * i) + ',' + QByteArray::number(i) + '\n';
        write(test, rows + "5,21\n");
        const QStringList arguments{"fit", test, "--of", "line", "--length", "1 m"};
        const QJsonObject fit = call(arguments + QStringList{"--json"}).json();
        QVERIFY(isNear(fit["value"].toDouble(), 12e3, 1e-9));
        QCOMPARE(fit["strength"].toDouble(), 240.0);
        QVERIFY(call(arguments).out.contains("broke at 240 N and 2 %"));
        QVERIFY(call(arguments).out.contains("meets 0 N at 0 %\n")); // and not at -0
        QCOMPARE(call(arguments
                      + QStringList{"--from", "0.2 %", "--to", "1 %", "--save", "my_cord", "--like",
                                    "liros_ltc25", "--materials", own})
                     .exitCode,
                 0);
        const QByteArray shown = call({"presets", "--show", "my_cord", "--materials", own}).out;
        QVERIFY2(shown.contains("axialStiffness 12000 N, measured: Test")
                     && shown.contains("9 points from 0.2 to 1 %")
                     && shown.contains("lineStrength 240 N, measured")
                     && shown.contains("diameter 0.00039 m, listed"),
                 shown);
        QCOMPARE(call({"fit", test, "--length", "1"}).exitCode, 2); // a strip needs a width
        QCOMPARE(call({"fit", test, "--of", "line", "--length", "1 kg"}).exitCode, 2);
        const Outcome wide = call({"fit", test, "--length", "20 cm", "--width", "5"}); // of metres
        QVERIFY2(wide.exitCode == 2 && wide.error.contains("\"5 cm\""), qPrintable(wide.error));
        QCOMPARE(call({"fit", test, "--length", "20 cm", "--width", "5 cm"}).exitCode, 0);
        QCOMPARE(call({"fit", folder.filePath("no.csv"), "--of", "line", "--length", "1"}).exitCode,
                 1);
        QCOMPARE(call(arguments + QStringList{"--from", "3", "--to", "4"}).exitCode, 1);
    }
};

const RegisteredTest registered("test_material_test", runPlain<TestMaterialTest>);

} // namespace ripstop::test_material_test
#include "test_material_test.moc"
