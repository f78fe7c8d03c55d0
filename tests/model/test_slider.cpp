// Ranges of sliders (scene/slider.h): places and values on even and logarithmic ranges, the range
// that is proposed around a value of any property, the text in which a scene file keeps sliders,
// and what becomes of sliders whose elements are removed. Every property of the table is tried, so
// that a new one is covered without a change here.
#include "registered_test.h"
#include "scene/slider.h"

#include <QtTest>

namespace ripstop::test_slider {

namespace {

const Property& stiffness = *findProperty(Kind::Material, "stiffness");
const Property& mass = *findProperty(Kind::Particle, "mass");
const Property& wind = *findProperty(Kind::Wind, "velocity");
const Property& sweeps = *findProperty(Kind::Settings, "sweeps");

bool says(const std::optional<Message>& reason, const char* words)
{
    return reason && reason->english().find(words) != std::string::npos;
}

} // namespace

class TestSlider : public QObject
{
    Q_OBJECT

private slots:
    // Equal ways are equal differences, or equal factors: half way from 1 to 10 000 is 100.
    void scales()
    {
        const SliderRange even{0.0, 10.0, false}, log{1.0, 1e4, true}, withZero{1e-3, 1e3, true};
        QCOMPARE(valueAt(even, 0.25), 2.5);
        QCOMPARE(valueAt(log, 0.5), 100.0);
        QCOMPARE(valueAt(log, 0.0), 1.0);
        QCOMPARE(valueAt(withZero, 0.0), 0.0);
        QCOMPARE(valueAt(withZero, 0.5), 1.0);
        QCOMPARE(placeOf(log, 100.0), 0.5);
        QCOMPARE(placeOf(even, 2.5), 0.25);
    }

    // A value beyond an end stands at that end.
    void outside()
    {
        QCOMPARE(placeOf({1.0, 10.0, false}, 0.0), 0.0);
        QCOMPARE(placeOf({1.0, 10.0, false}, 99.0), 1.0);
        QCOMPARE(placeOf({1.0, 10.0, true}, -1.0), 0.0);
        QCOMPARE(placeOf({1.0, 10.0, true}, 99.0), 1.0);
    }

    void dragsGiveNumbersThatPeopleType()
    {
        QVERIFY(valueAt({0.0, 1.0, false}, 0.1 + 0.2) == 0.3);
        QVERIFY(valueAt({0.0, 25.0, false}, 1.0 / 3.0) == 8.33);
    }

    // Whatever a property starts with, its slider can be had, and shows it.
    void everyRangeAroundAValueIsAllowed()
    {
        int tried = 0;
        for (const Property& property : allProperties()) {
            if (!hasRange(property))
                continue;
            const double* initial = std::get_if<double>(&property.initial);
            const bool isWhole = std::holds_alternative<int>(property.initial);
            for (const double sort : {initial ? *initial : 1.0, 0.0, 1e-4, 0.3, 5e4}) {
                const double value = isWhole ? std::rint(sort) : sort;
                if (value < property.range.low || value > property.range.high)
                    continue;
                const SliderRange range = rangeAround(property, value);
                const auto reason = refusal(property, range);
                QVERIFY2(!reason, (std::string(property.key) + " at " + std::to_string(value) + " "
                                   + reason.value_or(Message()).english())
                                      .c_str());
                QVERIFY2(range.low <= value || range.logarithmic, property.key.data());
                QVERIFY2(range.high >= value, property.key.data());
                ++tried;
            }
        }
        QVERIFY(tried > 100);
    }

    // What spans many powers of ten is turned by factors.
    void wideRangesAreLogarithmic()
    {
        QVERIFY(rangeAround(*findProperty(Kind::Settings, "strainGoal"), 1.0).logarithmic);
        QVERIFY(rangeAround(mass, 0.02).logarithmic);
        QVERIFY(!rangeAround(*findProperty(Kind::Collider, "restitution"), 0.2).logarithmic);
    }

    void rangesThatCannotBeHad()
    {
        const double infinity = std::numeric_limits<double>::infinity();
        QVERIFY(!refusal(mass, {0.0, 1.0, false}));
        QVERIFY(says(refusal(mass, {-1.0, 1.0, false}), "0 or above"));
        QVERIFY(says(refusal(mass, {2.0, 1.0, false}), "rise"));
        QVERIFY(says(refusal(mass, {1.0, 1.0, false}), "rise"));
        QVERIFY(says(refusal(mass, {0.0, 1.0, true}), "logarithmic"));
        QVERIFY(says(refusal(mass, {0.0, infinity, false}), "finite"));
        QVERIFY(refusal(mass, {std::nan(""), 1.0, false}));
        QVERIFY(refusal(wind, {-1.0, 1.0, false})); // a length
    }

    void textAndBack()
    {
        const std::vector<Slider> sliders{{&stiffness, {Id{17}}, {1.0, 1e5, true}},
                                          {&mass, {Id{3}, Id{4}}, {0.0, 0.5, false}},
                                          {&sweeps, {settingsId}, {1.0, 256.0, false}},
                                          {findProperty(Kind::Link, "kind"), {Id{9}}, {}}};
        const std::string text = textOf(sliders);
        QVERIFY(text.starts_with("material.stiffness #17 1 1e+05 log; particle.mass #3 #4 0 0.5"));
        const auto read = slidersFromText(text);
        QVERIFY(read && *read == sliders);
        QVERIFY(slidersFromText("")->empty());
    }

    void brokenTexts_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("no property") << "sail.size #3 0 1"
                                     << "no property";
        QTest::newRow("no dot") << "mass #3 0 1"
                                << "no property";
        QTest::newRow("a name") << "part.name #3"
                                << "no property that can be tuned";
        QTest::newRow("no ids") << "particle.mass 0 1"
                                << "names nothing";
        QTest::newRow("a wrong id") << "particle.mass #x 0 1"
                                    << "is no id";
        QTest::newRow("no range") << "particle.mass #3"
                                  << "two numbers";
        QTest::newRow("half a range") << "particle.mass #3 0"
                                      << "two numbers";
        QTest::newRow("too much") << "particle.mass #3 0 1 log more"
                                  << "two numbers";
        QTest::newRow("falling") << "particle.mass #3 1 0"
                                 << "rise";
        QTest::newRow("range of a choice") << "link.kind #3 0 1"
                                           << "no range";
        QTest::newRow("second of two") << "particle.mass #3 0 1; x"
                                       << "no property";
    }
    void brokenTexts()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const auto read = slidersFromText(text.toStdString());
        QVERIFY(!read);
        QVERIFY2(QString::fromStdString(read.message().english()).contains(says),
                 read.message().english().c_str());
    }

    // What was removed has no slider, and what is left of several keeps theirs.
    void slidersOfWhatIsGone()
    {
        Scene scene;
        Part part;
        part.particles.push_back({.id = Id{2}});
        scene.items = {{Id{1}, part}};
        scene.nextId = Id{9};
        const auto left = existing(scene, {{&mass, {Id{2}, Id{3}}, {}},
                                           {&mass, {Id{4}}, {}},
                                           {&stiffness, {Id{2}}, {}}}); // of another kind
        QCOMPARE(left.size(), std::size_t(1));
        QVERIFY(left[0].ids == std::vector<Id>{Id{2}});
    }
};

const RegisteredTest registered("test_slider", runPlain<TestSlider>);

} // namespace ripstop::test_slider
#include "test_slider.moc"
