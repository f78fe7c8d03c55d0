// Values as people type them, and what a property refuses.
//
// Stages: texts of each type that are read and those that are refused, with the words of the
// refusal; limits of properties; that every shown value and every default can be typed again to
// the last bit; and the nearest word that is proposed for a mistyped one.
#include "registered_test.h"
#include "scene/property.h"

#include <QtTest>

#include <cmath>
#include <limits>

Q_DECLARE_METATYPE(ripstop::Value)

namespace ripstop::test_value {

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

// "particle.mass"
const Property* propertyAt(const QString& path)
{
    const auto kind = kindFromName(path.section('.', 0, 0).toStdString());
    return kind ? findProperty(*kind, path.section('.', 1).toStdString()) : nullptr;
}

// This is not inlined, because GCC 12 would take parts of the variant for uninitialized.
[[gnu::noinline]] Value value(Value v) { return v; }

} // namespace

class TestValue : public QObject
{
    Q_OBJECT

private slots:
    void reads_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("text");
        QTest::addColumn<Value>("expected");

        // clang-format off
        QTest::newRow("true")              << "particle.pinned"     << "true"        << value(true);
        QTest::newRow("yes")               << "particle.pinned"     << "yes"         << value(true);
        QTest::newRow("one is true")       << "particle.pinned"     << "1"           << value(true);
        QTest::newRow("false")             << "particle.pinned"     << "false"       << value(false);
        QTest::newRow("no")                << "particle.pinned"     << "no"          << value(false);
        QTest::newRow("zero is false")     << "particle.pinned"     << "0"           << value(false);
        QTest::newRow("whole number")      << "settings.substeps"   << "12"          << value(12);
        QTest::newRow("whole, with point") << "settings.substeps"   << "12.0"        << value(12);
        QTest::newRow("number")            << "particle.mass"       << "0.25"        << value(0.25);
        QTest::newRow("number, exponent")  << "particle.mass"       << "2.5e-1"      << value(0.25);
        QTest::newRow("number, no point")  << "particle.mass"       << "3"           << value(3.0);
        QTest::newRow("blanks around")     << "particle.mass"       << "  3\t"       << value(3.0);
        QTest::newRow("zero mass")         << "particle.mass"       << "0"           << value(0.0);
        QTest::newRow("text")              << "part.name"           << "left wing"   << value(std::string("left wing"));
        QTest::newRow("no text")           << "settings.title"      << ""            << value(std::string());
        QTest::newRow("colour")            << "material.color"      << "#aB01ff"     << value(std::string("#aB01ff"));
        QTest::newRow("choice")            << "settings.integrator" << "verlet"      << value(std::string("verlet"));
        QTest::newRow("vector")            << "particle.position"   << "1, 0,-2.5"   << value(Vec3(1.0, 0.0, -2.5));
        QTest::newRow("id")                << "link.from"           << "17"          << value(Id{17});
        QTest::newRow("id as in a path")   << "link.from"           << "#17"         << value(Id{17});
        QTest::newRow("no id")             << "link.material"       << ""            << value(noId);
        QTest::newRow("largest id")        << "link.from"           << "4294967294"  << value(Id{4294967294u});
        QTest::newRow("ids")               << "control.targets"     << "3, 1,2"      << value(std::vector<Id>{Id{3}, Id{1}, Id{2}});
        QTest::newRow("no ids")            << "control.targets"     << " "           << value(std::vector<Id>{});
        QTest::newRow("optional, there")   << "link.stiffness"      << "40"          << value(40.0);
        QTest::newRow("optional, absent")  << "link.stiffness"      << ""            << value(std::monostate());
        QTest::newRow("with a unit")       << "particle.mass"       << "25 g"        << value(0.025);
        QTest::newRow("rows")              << "material.polar"      << "0,0,1; 90,1,2"  << value(NumberRows{{0, 0, 1}, {90, 1, 2}});
        QTest::newRow("rows, end mark")    << "material.polar"      << "0,0,1; 90,1,2;" << value(NumberRows{{0, 0, 1}, {90, 1, 2}});
        // clang-format on
    }

    void reads()
    {
        QFETCH(QString, path);
        QFETCH(QString, text);
        QFETCH(Value, expected);
        const Property* property = propertyAt(path);
        QVERIFY(property);
        const Result<Value> read = valueFromText(*property, text.toStdString());
        QVERIFY2(read, read ? "" : read.message().english().c_str());
        QVERIFY(*read == expected);
    }

    void refusesText_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");

        // clang-format off
        QTest::newRow("word for a switch")     << "particle.pinned"     << "maybe"      << "must be true or false";
        QTest::newRow("part of a whole")       << "settings.substeps"   << "2.5"        << "must be a whole number";
        QTest::newRow("whole beyond int")      << "settings.substeps"   << "3e9"        << "must be a whole number";
        QTest::newRow("zero substeps")         << "settings.substeps"   << "0"          << "must be at least 1";
        QTest::newRow("word for a number")     << "particle.mass"       << "heavy"      << "must be a number in kg";
        QTest::newRow("wrong unit")            << "particle.mass"       << "3 m"        << "must be in kg";
        QTest::newRow("two numbers")           << "particle.mass"       << "1, 2"       << "must be a number";
        QTest::newRow("nothing for a number")  << "particle.mass"       << ""           << "must be a number";
        QTest::newRow("negative mass")         << "particle.mass"       << "-1"         << "must be at least 0";
        QTest::newRow("infinite mass")         << "particle.mass"       << "inf"        << "must be a finite number";
        QTest::newRow("mass that is not one")  << "particle.mass"       << "nan"        << "must be a finite number";
        QTest::newRow("beyond double")         << "particle.mass"       << "1e999"      << "must be a number";
        QTest::newRow("zero radius")           << "collider.radius"     << "0"          << "must be above 0";
        QTest::newRow("too much bounce")       << "collider.restitution" << "1.5"       << "must be at most 1";
        QTest::newRow("step too long")         << "settings.timeStep"   << "1"          << "must be at most 0.1";
        QTest::newRow("unknown choice")        << "settings.integrator" << "leapfrog"   << "must be one of explicit_euler, semi_implicit_euler, implicit_euler, verlet, velocity_verlet, bdf2, rk4, auto";
        QTest::newRow("choice in capitals")    << "settings.integrator" << "Verlet"     << "must be one of";
        QTest::newRow("colour by name")        << "material.color"      << "red"        << "must be a colour as #rrggbb";
        QTest::newRow("colour, wrong digit")   << "material.color"      << "#12345g"    << "must be a colour as #rrggbb";
        QTest::newRow("two of three")          << "particle.position"   << "1, 2"       << "must be three numbers";
        QTest::newRow("four of three")         << "particle.position"   << "1, 2, 3, 4" << "must be three numbers";
        QTest::newRow("gap in three")          << "particle.position"   << "1, , 3"     << "must be three numbers";
        QTest::newRow("infinite place")        << "particle.position"   << "1, inf, 3"  << "must be three finite numbers";
        QTest::newRow("negative id")           << "link.from"           << "-1"         << "must be an id";
        QTest::newRow("part of an id")         << "link.from"           << "1.5"        << "must be an id";
        QTest::newRow("id too large")          << "link.from"           << "4294967296" << "must be an id";
        QTest::newRow("name for an id")        << "link.from"           << "tip"        << "must be an id";
        QTest::newRow("gap in ids")            << "control.targets"     << "1,,2"       << "must be a list of ids";
        QTest::newRow("word, optional")        << "link.stiffness"      << "soft"       << "must be a number";
        QTest::newRow("negative, optional")    << "link.stiffness"      << "-4"         << "must be at least 0";
        QTest::newRow("empty row")             << "material.polar"      << "0,0,1;;9,1,2" << "must be rows of numbers";
        QTest::newRow("short row")             << "material.polar"      << "0,0,1;9,1"  << "must have 3 numbers in each row (row 2)";
        QTest::newRow("row that falls")        << "material.polar"      << "9,0,1;0,0,1" << "must have angles that rise from row to row, between 0 and 90 (row 2)";
        // clang-format on
    }

    // The message names the property, the reason and the text.
    void refusesText()
    {
        QFETCH(QString, path);
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Property* property = propertyAt(path);
        QVERIFY(property);
        const Result<Value> read = valueFromText(*property, text.toStdString());
        QVERIFY(!read);
        const QString message = QString::fromStdString(read.message().english());
        QVERIFY2(message.startsWith(path + ' ' + says), qPrintable(message));
        QVERIFY2(message.endsWith("not \"" + text + '"'), qPrintable(message));
    }

    void refusesValue_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<Value>("value");
        QTest::addColumn<QString>("says");

        // clang-format off
        QTest::newRow("nothing")             << "particle.mass"     << value(std::monostate())       << "needs a value";
        QTest::newRow("whole for a number")  << "particle.mass"     << value(1)                      << "must be a number";
        QTest::newRow("number for a whole")  << "settings.substeps" << value(1.0)                    << "must be a whole number";
        QTest::newRow("text for a switch")   << "particle.pinned"   << value(std::string("true"))    << "must be true or false";
        QTest::newRow("number for a text")   << "part.name"         << value(1.0)                    << "must be a text";
        QTest::newRow("number for a vector") << "particle.position" << value(1.0)                    << "must be three numbers";
        QTest::newRow("number for an id")    << "link.from"         << value(1)                      << "must be an id";
        QTest::newRow("id for ids")          << "control.targets"   << value(Id{1})                  << "must be a list of ids";
        QTest::newRow("text, optional")      << "link.stiffness"    << value(std::string("1"))       << "must be a number";
        QTest::newRow("not a number")        << "particle.mass"     << value(notANumber)             << "must be a finite number";
        QTest::newRow("infinite, optional")  << "link.stiffness"    << value(infinity)               << "must be a finite number";
        QTest::newRow("vector, infinite")    << "particle.velocity" << value(Vec3(0, -infinity, 0))  << "must be three finite numbers";
        QTest::newRow("vector, no number")   << "particle.velocity" << value(Vec3(0, 0, notANumber)) << "must be three finite numbers";
        // clang-format on
    }

    void refusesValue()
    {
        QFETCH(QString, path);
        QFETCH(Value, value);
        QFETCH(QString, says);
        const Property* property = propertyAt(path);
        QVERIFY(property);
        const auto reason = refusal(*property, value);
        QVERIFY(reason);
        QCOMPARE(QString::fromStdString(reason->english()), says);
    }

    void limits_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<Value>("value");
        QTest::addColumn<bool>("accepted");

        // clang-format off
        QTest::newRow("closed low end")      << "settings.timeStep"    << value(1e-6)   << true;
        QTest::newRow("below it")            << "settings.timeStep"    << value(0.9e-6) << false;
        QTest::newRow("closed high end")     << "settings.timeStep"    << value(0.1)    << true;
        QTest::newRow("above it")            << "settings.timeStep"    << value(0.1001) << false;
        QTest::newRow("open low end")        << "collider.radius"      << value(0.0)    << false;
        QTest::newRow("just inside it")      << "collider.radius"      << value(1e-300) << true;
        QTest::newRow("no high end")         << "collider.radius"      << value(1e300)  << true;
        QTest::newRow("whole, low end")      << "settings.substeps"    << value(1)      << true;
        QTest::newRow("whole, below it")     << "settings.substeps"    << value(-1)     << false;
        QTest::newRow("fraction, high end")  << "collider.restitution" << value(1.0)    << true;
        QTest::newRow("optional, absent")    << "link.tearLimit"       << value(std::monostate()) << true;
        // clang-format on
    }

    void limits()
    {
        QFETCH(QString, path);
        QFETCH(Value, value);
        QFETCH(bool, accepted);
        const Property* property = propertyAt(path);
        QVERIFY(property);
        QCOMPARE(!refusal(*property, value), accepted);
    }

    void textRoundTrips_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<Value>("value");

        // clang-format off
        QTest::newRow("true")            << "particle.pinned"     << value(true);
        QTest::newRow("false")           << "particle.pinned"     << value(false);
        QTest::newRow("whole")           << "settings.substeps"   << value(10000);
        QTest::newRow("third")           << "particle.mass"       << value(1.0 / 3.0);
        QTest::newRow("smallest double") << "particle.mass"       << value(std::numeric_limits<double>::denorm_min());
        QTest::newRow("largest double")  << "particle.mass"       << value(std::numeric_limits<double>::max());
        QTest::newRow("round number")    << "particle.mass"       << value(100.0);
        QTest::newRow("text")            << "settings.notes"      << value(std::string("a, b = \"c\""));
        QTest::newRow("choice")          << "settings.solver"     << value(std::string("paper_jacobi"));
        QTest::newRow("vector")          << "particle.position"   << value(Vec3(0.1, -1.0 / 7.0, 1e-17));
        QTest::newRow("id")              << "link.from"           << value(Id{4294967294u});
        QTest::newRow("no id")           << "link.from"           << value(noId);
        QTest::newRow("ids")             << "group.members"       << value(std::vector<Id>{Id{5}, Id{2}});
        QTest::newRow("one id")          << "group.members"       << value(std::vector<Id>{Id{5}});
        QTest::newRow("no ids")          << "group.members"       << value(std::vector<Id>{});
        QTest::newRow("absent")          << "link.damping"        << value(std::monostate());
        QTest::newRow("optional")        << "link.damping"        << value(0.1);
        // clang-format on
    }

    // What is shown can be typed again, to the last bit.
    void textRoundTrips()
    {
        QFETCH(QString, path);
        QFETCH(Value, value);
        const Property* property = propertyAt(path);
        QVERIFY(property);
        const std::string text = textFromValue(value);
        const Result<Value> read = valueFromText(*property, text);
        QVERIFY2(read, text.c_str());
        QVERIFY2(*read == value, text.c_str());
    }

    void everyDefaultRoundTrips()
    {
        for (const Property& property : allProperties()) {
            const Result<Value> read = valueFromText(property, textFromValue(property.initial));
            QVERIFY2(read && *read == property.initial, property.key.data());
        }
    }

    void nearestWord_data()
    {
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("expected");

        QTest::newRow("itself") << "mass"
                                << "mass";
        QTest::newRow("letter missing") << "mas"
                                        << "mass";
        QTest::newRow("letter too many") << "masss"
                                         << "mass";
        QTest::newRow("letter wrong") << "mess"
                                      << "mass";
        QTest::newRow("letters swapped") << "psoition"
                                         << "position";
        QTest::newRow("capitals missing") << "restlength"
                                          << "restLength";
        QTest::newRow("another word") << "temperature"
                                      << "";
        QTest::newRow("nothing") << ""
                                 << "";
    }

    void nearestWord()
    {
        QFETCH(QString, word);
        QFETCH(QString, expected);
        static constexpr std::array<std::string_view, 5> words{"mass", "position", "velocity",
                                                               "restLength", "pinned"};
        QCOMPARE(QString::fromStdString(std::string(nearest(word.toStdString(), words))), expected);
    }

    void nearestOfNothing() { QVERIFY(nearest("mass", {}).empty()); }
};

const RegisteredTest registered("test_value", runPlain<TestValue>);

} // namespace ripstop::test_value
#include "test_value.moc"
