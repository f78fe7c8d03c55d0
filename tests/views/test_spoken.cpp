// Numbers as people say them, in readouts and in fields, and that what is shown can be typed.
#include "document/spoken.h"
#include "document/time_left.h"
#include "document/words.h"
#include "scene/typed_number.h"
#include "views/run_with_widgets.h"

#include <QLocale>

namespace ripstop::test_spoken {

class TestSpoken : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void readouts_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("said");
        const auto row = [](double value, const char* unit, const char* said) {
            QTest::newRow(said) << value << QString::fromUtf8(unit)
                                << QString::fromUtf8(said).replace(' ', QChar(0x00a0));
        };
        row(8e-4, "m", "0.8 mm");
        row(-8e-4, "m", "-0.8 mm");
        row(5e-4, "kg/m", "0.5 g/m");
        row(0.04, "kg/m\u00b2", "40 g/m\u00b2");
        row(0.32, "kg", "320 g");
        row(1.25, "kg", "1.25 kg");
        row(15.54321, "m", "15.54 m");
        row(0.5, "m", "0.5 m");
        row(3e-5, "m", "30 \u00b5m"); // 0.03 mm would be said in zeros
        row(8.905e-8, "J", "0.08905 \u00b5J");
        row(25.0, "m", "25 m");
        row(12345.0, "N", "12.35 kN");
        row(2e5, "N/m", "200 kN/m");
        row(1.0 / 960.0, "s", "1.042 ms");
        row(12345.0, "", "12345"); // not 1.234E+04
        row(0.0, "N", "0 N");
        row(2.043e-14, "", "0"); // an error of rounding
        row(-3e-12, "m", "0 m");
        row(0.02, "%", "0.02 %");
        row(35.0, "deg", "35 deg");
    }
    void readouts()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, said);
        QCOMPARE(spokenText(value, unit.toStdString()), said);
    }

    void strainsAreSaidInPercent()
    {
        QCOMPARE(readingText(Quantity::MaxStrain, 0.0002, ""), QString("0.02\u00a0%"));
        QCOMPARE(readingText(Quantity::MaxStrain, 2.398e-14, ""), QString("0\u00a0%"));
        QCOMPARE(readingText(Quantity::PositionY, -7.567e-9, "m"), QString("0\u00a0m")); // lies
        QCOMPARE(readingText(Quantity::PositionY, 2e-8, "m"), QString("0.02\u00a0\u00b5m"));
        QCOMPARE(readingText(Quantity::GlideRatio, 9.5, ""), QString("9.5"));
        QCOMPARE(readingText(Quantity::Strain, std::nan(""), ""), QString(QChar(0x2013)));
    }

    void fields_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("number");
        QTest::addColumn<QString>("beside");
        QTest::newRow("usual") << 0.25 << "m"
                               << "0.25"
                               << "m";
        QTest::newRow("small") << 8e-4 << "m"
                               << "0.8 mm"
                               << "";
        QTest::newRow("line of 1 mm") << 1e-3 << "m"
                                      << "1 mm"
                                      << "";
        QTest::newRow("line") << 5e-4 << "kg/m"
                              << "0.5 g/m"
                              << "";
        QTest::newRow("stiff") << 1e6 << "N/m"
                               << "1 MN/m"
                               << "";
        QTest::newRow("nothing") << 0.0 << "m"
                                 << "0"
                                 << "m";
        QTest::newRow("no prefix") << 1e-5 << ""
                                   << "0.00001"
                                   << "";
        QTest::newRow("many") << 2e7 << ""
                              << "20000000"
                              << "";
        QTest::newRow("absurd") << 1e99 << "N"
                                << "1e+93 MN"
                                << "";
        QTest::newRow("rounding stays") << 1e-12 << ""
                                        << "0.000000000001"
                                        << "";
    }
    // A bare number is in the unit of the field, whatever it shows.
    void fields()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, number);
        QFETCH(QString, beside);
        const Spoken said = spokenInField(value, unit.toStdString());
        QCOMPARE(said.number, number);
        QCOMPARE(said.unit, beside);
        const Typed typed = typedNumber(said.number.toStdString(), unit.toStdString());
        QVERIFY2(typed.number, typed.complaint.english().c_str());
        QVERIFY(std::abs(typed.number->number - value) <= 1e-6 * std::abs(value));
    }

    // One unit for all numbers of an axis, that of the largest, and as many decimals as steps need.
    void axes_data()
    {
        QTest::addColumn<double>("largest");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<bool>("isShare");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        QTest::addColumn<QString>("said");
        const auto row = [](double largest, const char* unit, bool isShare, double value,
                            double step, const char* said) {
            QTest::newRow(said) << largest << QString::fromUtf8(unit) << isShare << value << step
                                << QString::fromUtf8(said);
        };
        row(8e-4, "m", false, 5e-4, 1e-4, "0.5 mm");
        row(0.273, "m", false, 0.2, 0.05, "0.20 m");
        row(24e3, "N", false, 5e3, 5e3, "5 kN");
        row(2e-3, "", true, 5e-4, 5e-4, "0.05 %");
        row(3.0, "s", false, 0.1 + 0.2 - 0.3, 0.5, "0 s"); // what rounding leaves
        row(5e-4, "kg/m", false, 2e-4, 1e-4, "0.2 g/m");
    }
    void axes()
    {
        QFETCH(double, largest);
        QFETCH(QString, unit);
        QFETCH(bool, isShare);
        QFETCH(double, value);
        QFETCH(double, step);
        QFETCH(QString, said);
        const SpokenScale scale = spokenScale(largest, unit.toStdString(), isShare);
        QCOMPARE(scale.atStep(value, step) + ' ' + scale.unit, said);
    }

    void stepsAreRound()
    {
        for (const auto& [least, step] : {std::pair{0.7, 1.0},
                                          {1.0, 1.0},
                                          {1.1, 2.0},
                                          {2.5, 5.0},
                                          {5.952, 10.0},
                                          {0.273, 0.5},
                                          {3e-5, 5e-5}})
            QVERIFY2(std::abs(roundStep(least) - step) < 1e-9 * step,
                     qPrintable(QString::number(least)));
        QCOMPARE(roundStep(0.0), 0.0);
    }

    // Numbers in sentences of the engine have no exponents either, but for a mere row of digits.
    void sentences()
    {
        QCOMPARE(translated(Message::number("%.3g", 1.04e-5)), QString("0.0000104"));
        QCOMPARE(translated(Message::number("%.3g", 2.5e7)), QString("25000000"));
        QCOMPARE(translated(Message::number("%.3g", 0.25)), QString("0.25"));
        QCOMPARE(translated(Message::number("%.3g", 1e30)), QString("1e+30"));
    }

    // A quarter in 10 s leaves three quarters, 30 s; what has hardly begun tells nothing yet.
    void howLongWorkGoesOn()
    {
        QCOMPARE(secondsLeft(10.0, 0.25), 30.0);
        QCOMPARE(timeLeftText(secondsLeft(10.0, 0.25)), QString("About 30 s left."));
        QCOMPARE(timeLeftText(secondsLeft(100.0, 0.25)), QString("About 5 min left."));
        QCOMPARE(timeLeftText(secondsLeft(10.0, 1.0)), QString("About 1 s left."));
        QVERIFY(timeLeftText(secondsLeft(0.5, 0.25)).isEmpty());
        QVERIFY(timeLeftText(secondsLeft(10.0, 0.0)).isEmpty());
    }

    void micrometresCanBeTyped()
    {
        const Typed typed = typedNumber("30 \u00b5m", "m");
        QVERIFY(typed.number);
        QVERIFY(std::abs(typed.number->number - 30e-6) < 1e-18);
    }
};

const RegisteredTest registered("test_spoken", runWithWidgets<TestSpoken>);

} // namespace ripstop::test_spoken
#include "test_spoken.moc"
