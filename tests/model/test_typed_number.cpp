// Numbers as people type them (scene/typed_number.h): units and arithmetic, changes such as "+10
// %", vectors, and what is refused with which words. Each case is a row of text, wanted unit and
// expected number; conversions are exact factors, so decimals have to come out to the last bit.
#include "registered_test.h"
#include "scene/property.h"
#include "scene/typed_number.h"
#include "scene/units.h"

#include <QtTest>

namespace ripstop::test_typed_number {

namespace {

constexpr double inch = 0.0254; // m
constexpr double kgf = 9.80665; // N

} // namespace

class TestTypedNumber : public QObject
{
    Q_OBJECT

private slots:
    void values_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("expected");
        const auto row = [](const char* text, const char* unit, double expected) {
            QTest::addRow("%s in %s", text, unit) << QString::fromUtf8(text) << unit << expected;
        };
        // a number without a unit is in the unit that is wanted
        row("12", "kg", 12.0);
        row("-3.5", "m", -3.5);
        row("0,5", "m", 0.5);
        row(".5", "m", 0.5);
        row("1e-3", "m", 1e-3);
        row("\u22122", "m", -2.0); // a typographic minus
        row("1/240", "s", 1.0 / 240.0);
        row("(1 + 2)*4", "", 12.0);
        row("2^3", "", 8.0);
        row("sqrt(2)", "m", std::sqrt(2.0));
        row("2*pi", "", 2.0 * std::acos(-1.0));
        // a number with a unit is converted
        row("25 g", "kg", 0.025);
        row("25g", "kg", 0.025);
        row("12 cm", "m", 0.12);
        row("30 km/h", "m/s", 30.0 / 3.6);
        row("2*15 cm", "m", 0.3);
        row("3 m + 20 cm", "m", 3.2);
        row("1 m - 3*12 in", "m", 1.0 - 36.0 * inch);
        row("40 g/m\u00b2", "kg/m\u00b2", 0.04);
        row("40 g/m^2", "kg/m\u00b2", 0.04);
        row("40 g/m2", "kg/m\u00b2", 0.04);
        row("3 N/mm", "N/m", 3000.0);
        row("2 N s/m", "N s/m", 2.0);
        row("2 N\u00b7s/m", "N s/m", 2.0);
        row("200 daN", "N", 2000.0);
        row("2 kgf", "N", 2.0 * kgf);
        row("1.5 bar", "Pa", 1.5e5);
        row("500 \u00b5m", "m", 5e-4);
        row("5 %", "", 0.05);
        row("5 %", "%", 5.0);
        row("90\u00b0", "deg", 90.0);
        row("90\u00b0", "\u00b0", 90.0);
        row("2*90 deg", "degrees", 180.0);
        row("0 g", "kg", 0.0);
        row("5 cm - 50 mm", "m", 0.0);
        row("50 % * 3 kg", "kg", 1.5);
        row("60 kg * 9.81 m/s^2", "N", 588.6);
        row("sqrt(4 m^2)", "m", 2.0);
        // the unit belongs to the fraction, or to its lower part, as it is wanted
        row("1/240 s", "s", 1.0 / 240.0);
        row("1/240 s", "1/s", 1.0 / 240.0);
        row("5 1/s", "1/s", 5.0);
        row("1 m / 2 s", "m/s", 0.5);
        row("100 km / 2 h", "m/s", 50.0 / 3.6);
    }
    void values()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, expected);
        const auto value = [](std::string_view typed, std::string_view wanted) {
            return typedValue(typed, wanted);
        };
        for (const auto read : {typedNumber, +value}) {
            const Typed typed = read(text.toStdString(), unit.toStdString());
            QVERIFY2(typed.number, typed.complaint.english().c_str());
            QCOMPARE(typed.number->sort, TypedNumber::Sort::Absolute);
            QVERIFY2(std::abs(typed.number->number - expected) <= 1e-12 * std::abs(expected),
                     qPrintable(QString::number(typed.number->number, 'g', 17)));
        }
    }

    // What is written into a file is what was meant.
    void decimalsStayDecimals()
    {
        QVERIFY(typedNumber("7 cm", "m").number->number == 0.07);
        QVERIFY(typedNumber("7 %", "%").number->number == 7.0);
        QVERIFY(typedNumber("3*0.1 m", "m").number->number == 0.3);
    }

    // What becomes of 8 in the wanted unit.
    void changes_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("expected");
        const auto row = [](const char* text, const char* unit, double expected) {
            QTest::addRow("%s in %s", text, unit) << QString::fromUtf8(text) << unit << expected;
        };
        row("*1.5", "kg", 12.0);
        row("\u00d7 1.5", "kg", 12.0);
        row("/2", "kg", 4.0);
        row("* 3/2", "kg", 12.0);
        row("*150 %", "kg", 12.0);
        row("+5 %", "kg", 8.4);
        row("-5%", "kg", 7.6);
        row("+=5 %", "kg", 8.4);
        row("-=5 %", "kg", 7.6);
        row("+25 %", "", 10.0);
        row("+0.2", "kg", 8.2);
        row("+=200 g", "kg", 8.2);
        row("-=0.2", "kg", 7.8);
        row("\u2212=0.2", "kg", 7.8);
        row("+ 2*100 g", "kg", 8.2);
        row("-3", "kg", -3.0); // a sign, not a change
    }
    void changes()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, expected);
        const Typed typed = typedNumber(text.toStdString(), unit.toStdString());
        QVERIFY2(typed.number, typed.complaint.english().c_str());
        QVERIFY(std::abs(typed.number->appliedTo(8.0) - expected) < 1e-12);
    }

    void complaints_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("says");
        QTest::addColumn<int>("at");
        const auto row = [](const char* text, const char* unit, const char* says, int at) {
            QTest::addRow("%s in %s", text, unit)
                << QString::fromUtf8(text) << unit << QString::fromUtf8(says) << at;
        };
        row("heavy", "kg", "must be a number in kg, mg, g, t or oz", 0);
        row("12 furlong", "m", "must be a number in m, mm, cm, dm or km", 3);
        row("25 g", "m", "must be in m, mm, cm, dm or km", 3);
        row("12", "kg", nullptr, 0);
        row("3 m^2", "m", "must be in m, mm, cm, dm or km", 2);
        row("5 %", "kg", "must be in kg", 2);
        row("25 g", "", "must be a number without a unit", 3);
        row("1 m + 1 kg", "m", "must be a sum of numbers in one kind of unit", 2);
        row("1 m + 1", "m", "must be a sum of numbers in one kind of unit", 2);
        row("2 + 1 m^2", "m", "must be a sum of numbers in one kind of unit", 6);
        row("*2 kg", "kg", "must be a number without a unit", 3);
        row("+2 m", "kg", "must be in kg", 3);
        row("", "kg", "must be a number", 0);
        row("1 +", "kg", "must be a number", 0);
        row("(1", "kg", "must be a number", 0);
        row("5 5", "kg", "must be a number", 0);
        row("1,2,3", "kg", "must be a number", 0);
        row("1e999", "kg", "must be a number", 0);
        row("3 \u20ac", "kg", "must be a number", 2);
    }
    void complaints()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(QString, says);
        QFETCH(int, at);
        const Typed typed = typedNumber(text.toStdString(), unit.toStdString());
        QCOMPARE(typed.number.has_value(), says.isNull());
        QVERIFY2(QString::fromStdString(typed.complaint.english()).startsWith(says),
                 typed.complaint.english().c_str());
        if (!says.isNull())
            QCOMPARE(int(typed.at), at);
    }

    // Where points are decimals, "7,000" may be thousands, and is no number; what cannot be those
    // is one with a decimal comma, and the window reads both.
    void thousandsAreRefused_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says"); // or empty, where it is a number
        const auto row = [](const char* text, const char* says) {
            QTest::addRow("%s", text) << QString(text) << QString(says);
        };
        row("7,000", "must be written with 7000 or 7.000");
        row("1,225", "must be written with 1225 or 1.225");
        row("-12,500 N", "must be written with 12500 or 12.500");
        row("2*100,250", "must be written with 100250 or 100.250");
        row("0,5", "");
        row("1,25", "");
        row("1,2500", "");
        row("0,125", "");
        row("1234,567", "");
        row("7.000", "");
    }
    void thousandsAreRefused()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Typed typed = typedValue(text.toStdString(), "N", ThreeDigits::AreRefused);
        QCOMPARE(typed.number.has_value(), says.isEmpty());
        QVERIFY2(QString::fromStdString(typed.complaint.english()).startsWith(says),
                 typed.complaint.english().c_str());
        QVERIFY(typedValue(text.toStdString(), "N").number);
        QVERIFY(typedNumber(text.toStdString(), "N").number);
    }

    void changesHaveNoPlaceWithoutAValue()
    {
        for (const char* text : {"*2", "/2", "+=2"})
            QVERIFY2(!typedValue(text, "kg").number, text);
        QCOMPARE(typedValue("+2", "kg").number->number, 2.0); // a sign
        QCOMPARE(typedValue("-5 %", "").number->number, -0.05);
    }

    void changesOfValues()
    {
        using enum TypedNumber::Sort;
        QVERIFY(changed(3, {Times, 1.5}) == Value(5));      // 4.5, rounded
        QVERIFY(changed(3, {Absolute, 2.5}) == Value(2.5)); // refused by its type
        QVERIFY(changed(Vec3(1, 2, 3), {Plus, 1.0}, 1) == Value(Vec3(1, 3, 3)));
        QVERIFY(changed(std::monostate(), {Times, 2.0}) == Value(std::monostate()));
        QVERIFY(changed(std::monostate(), {Absolute, 2.0}) == Value(2.0));
    }

    // Each number of a vector may have a unit, as in --set; the only one, at the end, is that of
    // all.
    void vectors()
    {
        const Property& velocity = *findProperty(Kind::Wind, "velocity");
        const auto read = valueFromText(velocity, "36 km/h, 0, 1");
        QVERIFY(read && std::get<Vec3>(*read) == Vec3(10.0, 0.0, 1.0));
        for (const char* all : {"36, 0, 18 km/h", "36, 0, 18km/h", "10, 0, 5"}) {
            const auto same = valueFromText(velocity, all);
            QVERIFY2(same && (std::get<Vec3>(*same) - Vec3(10.0, 0.0, 5.0)).norm() < 1e-12, all);
        }
        const auto sum = valueFromText(velocity, "1, 2, 3*2 m/s");
        QVERIFY(sum && std::get<Vec3>(*sum) == Vec3(1.0, 2.0, 6.0));
        const auto wrong = valueFromText(velocity, "36 kg, 0, 1");
        QVERIFY(!wrong && wrong.message().english().starts_with("wind.velocity must be in m/s"));
    }

    // Every unit of the table of properties can be typed.
    void unitsOfTheTable()
    {
        for (const Property& property : allProperties()) {
            const auto unit = property.unit;
            const Typed typed = typedValue("7 " + std::string(unit), unit);
            QVERIFY2(typed.number && typed.number->number == 7.0, property.key.data());
            QVERIFY2(unit.empty() || unitsLike(unit).front() == unit, property.key.data());
        }
    }

    // The unit of a tear limit is what the rule compares.
    void unitOfATearLimit()
    {
        Scene scene;
        Material material;
        Link link{.id = Id{2}, .material = Id{1}};
        const Property& ofLink = *findProperty(Kind::Link, "tearLimit");
        const Property& ofMaterial = *findProperty(Kind::Material, "tearLimit");
        for (const auto& [rule, unit] :
             {std::pair(TearRule::Length, "m"), std::pair(TearRule::Force, "N"),
              std::pair(TearRule::Strain, ""), std::pair(TearRule::Never, "")}) {
            material.tearRule = rule;
            scene.items = {{Id{1}, material}};
            QCOMPARE(unitOf(scene, ofLink, &std::as_const(link)), std::string_view(unit));
            QCOMPARE(unitOf(scene, ofMaterial, &std::as_const(material)), std::string_view(unit));
        }
        // of fabric, by width; a link's own limit is a force
        material.tearRule = TearRule::Tension;
        scene.items = {{Id{1}, material}};
        QCOMPARE(unitOf(scene, ofMaterial, &std::as_const(material)), std::string_view("N/m"));
        QCOMPARE(unitOf(scene, ofLink, &std::as_const(link)), std::string_view("N"));
    }
};

const RegisteredTest registered("test_typed_number", runPlain<TestTypedNumber>);

} // namespace ripstop::test_typed_number
#include "test_typed_number.moc"
