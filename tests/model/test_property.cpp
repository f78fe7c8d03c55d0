// The table of properties is what files, forms and the manual are made from: these tests keep its
// rows honest, whatever rows there are.
//
// Stages: every row is set and read back, accepts its default, and has a help that is a sentence;
// then names, choices, ids and keys; and the order of the table and of kinds.
#include "registered_test.h"
#include "scene/property.h"

#include <QRegularExpression>
#include <QtTest>

#include <set>
#include <string_view>

namespace ripstop::test_property {

namespace {

// The compiler writes an enumerator by its name, and a number that has none as "(Choice)7"
// or "7".
template <auto choice>
constexpr bool isEnumerator()
{
    constexpr std::string_view before = "choice = ";
    const std::string_view name = __PRETTY_FUNCTION__;
    const char first = name[name.find(before) + before.size()];
    return first != '(' && !(first >= '0' && first <= '9');
}

template <typename... Choices>
constexpr bool areNamed()
{
    return ((isEnumerator<Choices(choiceNames<Choices>.size() - 1)>()
             && !isEnumerator<Choices(choiceNames<Choices>.size())>())
            && ...);
}

// Tables have a row for each name; so none is forgotten when each enumerator has a name.
static_assert(
    areNamed<Integrator, Solver, Guide, LinkKind, LinkRole, Resists, TearRule, TearMesh, AirLaw,
             WindKind, ColliderShape, Response, ControlKind, Quantity, PlotAxis>(),
    "as many names as enumerators");

// One default object of each kind.
struct Examples
{
    Settings settings;
    Particle particle;
    Link link;
    Panel panel;
    Part part;
    Material material;
    Group group;
    Collider collider;
    Wind wind;
    Control control;
    Probe probe;
    Plot plot;

    std::vector<Ref> all()
    {
        return {&settings, &particle, &link, &panel,   &part,  &material,
                &group,    &collider, &wind, &control, &probe, &plot};
    }
    Ref of(Kind kind) { return all()[std::size_t(kind)]; }
};

// Values that the property accepts and that differ from its default.
std::vector<Value> otherValues(const Property& property)
{
    struct Other
    {
        const Property& property;

        std::vector<Value> operator()(std::monostate) const
        {
            return {0.5, std::min(2.0, property.range.high)};
        }
        std::vector<Value> operator()(bool value) const { return {!value}; }
        std::vector<Value> operator()(int value) const { return {value + 1}; }
        std::vector<Value> operator()(double value) const
        {
            return {0.75 * value + 0.25 * std::min(property.range.high, value + 1.0)};
        }
        std::vector<Value> operator()(const std::string& value) const
        {
            std::vector<Value> others;
            for (const std::string_view choice : property.choices)
                if (choice != value)
                    others.emplace_back(std::string(choice));
            if (property.choices.empty())
                others.emplace_back(property.key == "color"  ? "#123456"
                                    : property.key == "path" ? "0: 1 2 3; 2.5: 0 0 -1"
                                                             : value + "z");
            return others;
        }
        std::vector<Value> operator()(const Vec3& value) const
        {
            return {Vec3(value + Vec3(1.0, -2.0, 3.0))};
        }
        std::vector<Value> operator()(Id) const { return {Id{7}}; }
        std::vector<Value> operator()(const std::vector<Id>&) const
        {
            return {std::vector<Id>{Id{7}, Id{9}}};
        }
        std::vector<Value> operator()(const NumberRows& rows) const
        {
            if (rows.size() > 1)
                return {NumberRows{rows.front(), rows.back()}};
            std::vector<double> later = rows.front();
            later[0] += 1.5;
            return {NumberRows{rows.front(), later}};
        }
    };
    return std::visit(Other{property}, property.initial);
}

bool holdsIds(const Value& value)
{
    return std::holds_alternative<Id>(value) || std::holds_alternative<std::vector<Id>>(value);
}

} // namespace

class TestProperty : public QObject
{
    Q_OBJECT

    static void everyProperty()
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const Property& p : allProperties())
            QTest::newRow((std::string(kindName(p.kind)) + "." + std::string(p.key)).c_str())
                << index++;
    }

    static const Property& row(int index) { return allProperties()[std::size_t(index)]; }

private slots:
    void roundTrips_data() { everyProperty(); }

    // get, set, get: and no other property of the object changes.
    void roundTrips()
    {
        QFETCH(int, index);
        const Property& property = row(index);
        Examples examples;
        const Ref object = examples.of(property.kind);
        QVERIFY(kindOf(asConst(object)) == property.kind);
        QVERIFY(property.get(asConst(object)) == property.initial);

        for (const Value& other : otherValues(property)) {
            QVERIFY(!(other == property.initial));
            const auto reason = refusal(property, other);
            QVERIFY2(!reason, reason ? reason->english().c_str() : "");
            property.set(object, other);
            QVERIFY(property.get(asConst(object)) == other);
            for (const Property& neighbour : propertiesOf(property.kind))
                if (neighbour.key != property.key)
                    QVERIFY2(neighbour.get(asConst(object)) == neighbour.initial,
                             neighbour.key.data());
        }
        property.set(object, property.initial);
        QVERIFY(property.get(asConst(object)) == property.initial);
    }

    void defaultIsAccepted_data() { everyProperty(); }

    void defaultIsAccepted()
    {
        QFETCH(int, index);
        const auto reason = refusal(row(index), row(index).initial);
        QVERIFY2(!reason, reason ? reason->english().c_str() : "");
    }

    void helpIsASentence_data() { everyProperty(); }

    void helpIsASentence()
    {
        QFETCH(int, index);
        const QString help = QString::fromUtf8(row(index).help.data(), int(row(index).help.size()));
        QVERIFY2(help.size() > 10, qPrintable(help));
        QVERIFY2(help.front().isUpper(), qPrintable(help));
        QVERIFY2(help.endsWith('.') && help.count(". ") == 0 && !help.endsWith(".."),
                 qPrintable(help));
        QVERIFY2(!help.contains("  "), qPrintable(help));
    }

    void namesAreWellFormed_data() { everyProperty(); }

    void namesAreWellFormed()
    {
        QFETCH(int, index);
        const Property& property = row(index);
        static const QRegularExpression key("^[a-z][A-Za-z0-9]*$");
        QVERIFY(key.match(QString::fromStdString(std::string(property.key))).hasMatch());
        QVERIFY(!property.label.empty());
        QVERIFY(QChar(property.label.front()).isUpper());

        static const std::set<std::string_view> units{
            "",      "%",          "s",       "m",    "deg",       "m/s", "m/s\u00b2",
            "kg",    "kg/m\u00b3", "m\u00b2", "1/s",  "N/m",       "N m", "N m\u00b2",
            "N s/m", "m/N",        "N",       "kg/m", "kg/m\u00b2"};
        QVERIFY2(units.contains(property.unit), property.unit.data());
    }

    void choicesDiffer_data() { everyProperty(); }

    // Every enumerator has a name of its own; the unnamed would all be written as one.
    void choicesDiffer()
    {
        QFETCH(int, index);
        const auto choices = row(index).choices;
        const std::set<std::string_view> different(choices.begin(), choices.end());
        QCOMPARE(different.size(), choices.size());
        QVERIFY(!different.contains(""));
    }

    void idsSayWhatTheyPointAt_data() { everyProperty(); }

    void idsSayWhatTheyPointAt()
    {
        QFETCH(int, index);
        QCOMPARE(!row(index).pointsAt.empty(), holdsIds(row(index).initial));
    }

    void keysAreUnique()
    {
        std::set<std::pair<Kind, std::string_view>> seen;
        for (const Property& property : allProperties()) {
            QVERIFY2(seen.emplace(property.kind, property.key).second, property.key.data());
            QCOMPARE(findProperty(property.kind, property.key), &property);
        }
        QVERIFY(!findProperty(Kind::Particle, "restLength"));
        QVERIFY(!findProperty(Kind::Particle, ""));
    }

    // propertiesOf() returns a stretch of the table, so the rows of a kind must stand together.
    void tableIsGroupedByKind()
    {
        std::size_t total = 0;
        for (int kind = 0; kind < kindCount; ++kind) {
            const auto rows = propertiesOf(Kind(kind));
            QVERIFY2(!rows.empty(), kindName(Kind(kind)).data());
            for (const Property& property : rows)
                QCOMPARE(int(property.kind), kind);
            total += rows.size();
        }
        QCOMPARE(total, allProperties().size());
    }

    void itemsHaveNames()
    {
        for (const Kind kind : {Kind::Part, Kind::Material, Kind::Group, Kind::Collider, Kind::Wind,
                                Kind::Control, Kind::Probe, Kind::Plot})
            QVERIFY2(findProperty(kind, "name"), kindName(kind).data());
    }

    void kindsHaveNames()
    {
        std::set<std::string_view> seen;
        for (int kind = 0; kind < kindCount; ++kind) {
            QVERIFY(seen.insert(kindName(Kind(kind))).second);
            QVERIFY(kindFromName(kindName(Kind(kind))) == Kind(kind));
            QVERIFY(!kindPlural(Kind(kind)).empty());
        }
        QVERIFY(!kindFromName("kite"));
        QVERIFY(!kindFromName(""));
        QVERIFY(isElement(Kind::Particle) && isElement(Kind::Link) && isElement(Kind::Panel));
        QVERIFY(!isElement(Kind::Part) && !isElement(Kind::Settings));
    }
};

const RegisteredTest registered("test_property", runPlain<TestProperty>);

} // namespace ripstop::test_property
#include "test_property.moc"
