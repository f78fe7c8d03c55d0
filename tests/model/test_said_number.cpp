// Numbers as people say them (scene/said_number.h): prefixes, digits and no exponents, in the
// sentences of the model. The window's own are in tests/views/test_spoken.cpp.
#include "registered_test.h"
#include "scene/said_number.h"
#include "scene/typed_number.h"

#include <QtTest>

namespace ripstop::test_said_number {

class TestSaidNumber : public QObject
{
    Q_OBJECT

private slots:
    void sentences_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("said");
        const auto row = [](double value, const char* unit, const char* said) {
            QTest::newRow(said) << value << QString::fromUtf8(unit) << QString::fromUtf8(said);
        };
        row(0.206257, "kg", "206.3 g");
        row(8e-4, "m", "0.8 mm");
        row(33000.0, "N/m", "33 kN/m");
        row(1e9, "", "1000000000");
        row(1e-7, "", "0.0000001");
        row(-2.5, "m", "-2.5 m");
        row(1e-15, "N", "0 N");
        row(std::nan(""), "N", "\u2013");
        row(INFINITY, "N", "\u2013");
    }
    void sentences()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, said);
        QCOMPARE(QString::fromStdString(saidNumber(value, unit.toStdString()).english()), said);
    }

    // To the digits that are said.
    void whatIsSaidCanBeTyped()
    {
        for (const char* unit : {"m", "m\u00b2", "kg", "s", "N", "Pa", "J", "N/m", "kg/m\u00b2"})
            for (double value = 1.2345e-5; value < 1e6; value *= 3.7) {
                const std::string said = saidNumber(value, unit, 6).english();
                const Typed typed = typedNumber(said, unit);
                QVERIFY2(typed.number, said.c_str());
                QVERIFY2(std::abs(typed.number->number / value - 1.0) < 1e-5, said.c_str());
            }
    }

    // Each in the unit of the largest, which is what stands behind them.
    void numbersThatStandTogetherShareAUnit()
    {
        const ReadableUnit unit = readableUnit(0.25, "kg");
        QCOMPARE(unit.name, std::string("g"));
        QCOMPARE(plainNumber(0.01 / unit.factor, 6), std::string("10"));
        QCOMPARE(plainNumber(0.25 / unit.factor, 6), std::string("250"));
        QCOMPARE(readableUnit(0.0, "kg").name, std::string("kg"));
    }
};

const RegisteredTest registered("test_said_number", runPlain<TestSaidNumber>);

} // namespace ripstop::test_said_number
#include "test_said_number.moc"
