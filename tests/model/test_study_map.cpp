// A study seen over two of its variables: what each cell is, and the lines over them.
#include "builders/builder.h"
#include "model/cli_call.h"
#include "model/files.h"
#include "registered_test.h"
#include "scene/path.h"
#include "study/point_scene.h"
#include "study/study_map.h"
#include "study/study_table.h"
#include "study/suggested_variable.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_study_map {

namespace {

// A grid with this value at each place.
StudyMap gridOf(std::size_t columns, std::size_t rows,
                const std::function<double(double, double)>& value)
{
    StudyMap map;
    map.isGrid = true;
    map.x.labels.resize(columns);
    map.y = StudyAxis{};
    map.y->labels.resize(rows);
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x)
            map.points.push_back({map.points.size(), double(x), double(y),
                                  value(double(x), double(y)), FlightOutcome::Held});
    return map;
}

double lengthOf(const std::vector<MapSegment>& lines)
{
    double sum = 0.0;
    for (const MapSegment& line : lines)
        sum += std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
    return sum;
}

// A pendulum that is hung on a line of strength that varies, in a folder of its own.
QString writeStudy(const QTemporaryDir& folder, const QByteArray& plan)
{
    QFile::copy(scene("pendulum"), folder.filePath("pendulum.ripstop.json"));
    const QString file = folder.filePath("a.ripstop-study.json");
    write(file, R"({"format": "ripstop-study", "version": 1, "scene": "pendulum.ripstop.json",
        "seconds": 0.05, "variables": [
        {"name": "gravity", "paths": ["settings.gravity"], "values": ["0,-9.81,0", "0,-1.62,0"]},
        {"name": "mass", "paths": ["#4.mass"], "from": 1, "to": 100, "count": 3, "scale": "log"},
        {"name": "air", "paths": ["settings.airDensity"], "values": [1.2, 0]}],
        "measures": [{"probe": "tension", "reduction": "max"}], "plan": )"
                    + plan + "}");
    return file;
}

} // namespace

class TestStudyMap : public QObject
{
    Q_OBJECT

private slots:
    // Over a plane the contour is a straight line: x + 2 y = 5.5 goes from (5.5 - 2 * 2, 2) to
    // (5, 0.25) in a grid of six by three.
    void contourOfAPlane()
    {
        const StudyMap map = gridOf(6, 3, [](double x, double y) { return x + 2.0 * y; });
        const auto lines = contour(map, 5.5);
        for (const MapSegment& line : lines)
            for (const auto& end : {line.from, line.to})
                QVERIFY(std::abs(end[0] + 2.0 * end[1] - 5.5) < 1e-12);
        QVERIFY(std::abs(lengthOf(lines) - std::hypot(5.0 - 1.5, 2.0 - 0.25)) < 1e-12);
    }

    // Round a cone the contours are circles; chords between the sides of squares are shorter by
    // less than 1 %.
    void contourOfACone()
    {
        const StudyMap map =
            gridOf(41, 41, [](double x, double y) { return std::hypot(x - 20.0, y - 20.0); });
        const double circle = 2.0 * std::numbers::pi * 12.3;
        const double length = lengthOf(contour(map, 12.3));
        QVERIFY2(length < circle && length > 0.99 * circle, qPrintable(QString::number(length)));
    }

    // A saddle x y about the middle of one square: its two branches stay apart, on either side.
    void contourOfASaddle()
    {
        const auto saddle = [](double x, double y) { return (x - 0.5) * (y - 0.5); };
        for (const double level : {0.1, -0.1}) {
            const auto lines = contour(gridOf(2, 2, saddle), level);
            QCOMPARE(lines.size(), std::size_t(2));
            for (const MapSegment& line : lines) {
                const double x = (line.from[0] + line.to[0]) / 2.0;
                const double y = (line.from[1] + line.to[1]) / 2.0;
                QVERIFY(saddle(x, y) * level > 0.0); // in the quarter where the sign is its own
            }
        }
    }

    void cellsWithoutAValueHaveNoContour()
    {
        StudyMap map = gridOf(3, 2, [](double x, double) { return x; });
        map.points[1].outcome = FlightOutcome::Stopped; // a corner of both squares
        QVERIFY(contour(map, 0.5).empty());
        QVERIFY(contour(map, 1.5).empty());
    }

    // What diverged may have come to any number: it takes no part in the colours.
    void colourIsOfFlightsThatEndedAsMeant()
    {
        StudyMap map = gridOf(3, 1, [](double x, double) { return x; });
        map.points[2].outcome = FlightOutcome::Stopped;
        map.points[2].value = 1e30;
        const auto span = valueSpan(map);
        QVERIFY(span);
        QCOMPARE(span->least, 0.0);
        QCOMPARE(span->largest, 1.0);
        for (StudyMap::Point& point : map.points)
            point.outcome = FlightOutcome::Stopped;
        QVERIFY(!valueSpan(map));
    }

    void levelsAreRound()
    {
        const StudyMap map = gridOf(2, 1, [](double x, double) { return 37.0 + 89.0 * x; });
        QCOMPARE(contourLevels(map, 8), (std::vector<double>{40, 60, 80, 100, 120}));
        QVERIFY(contourLevels(gridOf(2, 2, [](double, double) { return 1.0; }), 8).empty());
    }

    // What tears below the diagonal of a square of n cells has a border of n - 1 cells in each
    // direction.
    void frontierIsTheBorder()
    {
        StudyMap map = gridOf(5, 5, [](double, double) { return 0.0; });
        for (StudyMap::Point& point : map.points)
            if (point.y < point.x)
                point.outcome = FlightOutcome::Torn;
        QVERIFY(std::abs(lengthOf(frontier(map)) - 8.0) < 1e-12);
        for (const MapSegment& line : frontier(map)) // right of the diagonal and below it
            QVERIFY(std::abs((line.from[0] + line.to[0] - line.from[1] - line.to[1]) / 2.0 - 0.5)
                    < 0.6);
        for (StudyMap::Point& point : map.points)
            if (point.outcome == FlightOutcome::Torn)
                point.outcome = FlightOutcome::Missing; // what is not known is no border
        QVERIFY(frontier(map).empty());
    }

    // A slice of a grid of three variables has each of its points once, at the place of its values.
    void slicesOfAGrid()
    {
        const QTemporaryDir folder;
        const auto opened = openStudy(writeStudy(folder, R"({"kind": "grid"})").toStdString());
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QCOMPARE(opened->points.count(), std::size_t(2 * 3 * 2));
        LedgerRows rows;
        for (std::size_t i = 0; i < opened->points.count(); ++i) {
            FlightResult flight;
            flight.measured = {double(i)};
            flight.torn = i % 4 == 1;
            flight.stopped = i == 7 ? "diverged" : "";
            if (i != 3)
                rows.emplace(opened->key(i), flight);
        }
        const StudyFlights flights = flightsOf(*opened, rows);
        // points are numbered with the last variable changing fastest: 6 gravity + 2 mass + air
        const StudyMap map = mapOf(*opened, flights, {1, 0, 0, {0, 0, 1}});
        QVERIFY(map.isGrid);
        QCOMPARE(map.x.title, std::string("mass (kg)"));
        QVERIFY(map.x.isLogarithmic);
        QCOMPARE(map.x.labels, (std::vector<std::string>{"1", "10", "100"}));
        QCOMPARE(map.columns(), std::size_t(3));
        QCOMPARE(map.rows(), std::size_t(2));
        for (std::size_t row = 0; row < 2; ++row)
            for (std::size_t column = 0; column < 3; ++column) {
                const StudyMap::Point& point = map.points[row * 3 + column];
                QCOMPARE(point.number, 6 * row + 2 * column + 1);
                if (point.number != 3)
                    QCOMPARE(point.value, double(point.number));
            }
        QCOMPARE(map.points[0].outcome, FlightOutcome::Torn);
        QCOMPARE(map.points[1].outcome, FlightOutcome::Missing);
        QCOMPARE(map.points[3].outcome, FlightOutcome::Stopped);
        QCOMPARE(map.points[5].outcome, FlightOutcome::Held);
        const StudyTally tally = tallyOf(flights);
        QCOMPARE(tally.flown, std::size_t(11));
        QCOMPARE(tally.stopped, std::size_t(1));
    }

    // --- what somebody points at ----------------------------------------------------------------

    // A limit of tearing is in the unit of the rule that it belongs to.
    void unitsAreThoseOfTheThing()
    {
        Scene scene;
        Material cord;
        cord.name = "cord";
        cord.tearRule = TearRule::Force;
        scene.items.push_back({takeId(scene), cord});
        QCOMPARE(unitOf(scene, "cord.tearLimit"), std::string("N"));
        QCOMPARE(unitOf(scene, "settings.gravity"), std::string("m/s\u00b2"));
        QCOMPARE(unitOf(scene, "none.mass"), std::string());
    }

    // By name where that finds it again, by id where another item has the name, or it is an
    // element.
    void pathsFindTheirThing()
    {
        Scene scene;
        Material cord;
        cord.name = "cord";
        for (int i = 0; i < 2; ++i)
            scene.items.push_back({takeId(scene), cord});
        Wind wind;
        wind.name = "wind";
        scene.items.push_back({takeId(scene), wind});
        const Property& compliance = propertyOf<&Material::compliance>();
        QCOMPARE(pathOf(scene, scene.items[0].id, compliance), std::string("cord.compliance"));
        QCOMPARE(pathOf(scene, scene.items[1].id, compliance), std::string("#2.compliance"));
        QCOMPARE(pathOf(scene, settingsId, propertyOf<&Settings::gravity>()),
                 std::string("settings.gravity"));
        for (const Entry& entry : scene.items)
            for (const Property& property :
                 propertiesOf(kindOf(*find(std::as_const(scene), entry.id)))) {
                const auto place = findPlace(scene, pathOf(scene, entry.id, property));
                QVERIFY(place && place->property == &property);
                QCOMPARE(place->targets, std::vector{entry.id});
            }
    }

    void suggestsValuesRoundTheOneThatIs()
    {
        Scene scene;
        scene.settings.airDensity = 1.2;
        scene.settings.sweeps = 8;
        scene.settings.gravity = {0.0, -10.0, 0.0};
        const auto valuesOf = [&](const char* key, std::optional<SliderRange> range = {}) {
            const auto variable =
                suggestedVariable(scene, *findProperty(Kind::Settings, key), {settingsId}, range);
            return variable ? variable->values : std::vector<std::string>();
        };
        // half to twice, by factors of the root of two
        QCOMPARE(valuesOf("airDensity").front(), std::string("0.6"));
        QCOMPARE(valuesOf("airDensity")[2], std::string("1.2"));
        QCOMPARE(valuesOf("airDensity").back(), std::string("2.4"));
        QCOMPARE(valuesOf("airDensity", SliderRange{0.0, 1.0}),
                 (std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"}));
        // a decade either way of what nobody has chosen, all of what somebody has
        Scene line;
        line.items.push_back({takeId(line), Material()});
        std::get<Material>(line.items[0].item).tearLimit = 450.0;
        const Property& limit = *findProperty(Kind::Material, "tearLimit");
        const auto endsOf = [&](const SliderRange& range) {
            const auto found = suggestedVariable(line, limit, {line.items[0].id}, range)->spread;
            return std::pair(found->a, found->b);
        };
        const SliderRange usual = rangeAround(limit, 450.0);
        QVERIFY(usual.high > 1e3 * usual.low && usual.high < 4500.0);
        QCOMPARE(endsOf(usual), std::pair(45.0, usual.high));
        QCOMPARE(endsOf({1.0, 2000.0, true}), std::pair(1.0, 2000.0));
        QCOMPARE(valuesOf("sweeps"), (std::vector<std::string>{"4", "7", "10", "13", "16"}));
        QCOMPARE(valuesOf("gravity"),
                 (std::vector<std::string>{"0, -5, 0", "0, -7.5, 0", "0, -10, 0", "0, -12.5, 0",
                                           "0, -15, 0"}));
        QVERIFY(valuesOf("integrator").size() > 2);
        for (const std::string& name : valuesOf("integrator"))
            QVERIFY(assignment(scene, "settings.integrator=" + name));
        QVERIFY(valuesOf("title").empty());
    }

    // --- builders' parameters --------------------------------------------------------------------

    // A rope that is built again with another length is that long, and what is set in it beside
    // that is set in the rope that came of it.
    void partsAreBuiltAgain()
    {
        const Scene rope = *build(*findBuilder("rope"), {{"length", 2.0}, {"segments", 10.0}});
        const auto part = [](const Scene& scene) {
            for (const Entry& entry : scene.items)
                if (const auto* one = std::get_if<Part>(&entry.item))
                    return *one;
            return Part();
        };
        const std::string name = part(rope).name;
        const auto made = sceneWith(rope, {name + ".built.length=3.5", name + ".built.segments=7",
                                           "settings.airDensity=1.1"});
        QVERIFY2(made, made ? "" : made.message().english().c_str());
        QCOMPARE(part(*made).links.size(), std::size_t(7));
        double length = 0.0;
        for (const Link& link : part(*made).links)
            length += link.restLength;
        QVERIFY2(std::abs(length - 3.5) < 1e-12, qPrintable(QString::number(length)));
        QCOMPARE(made->settings.airDensity, 1.1);
        QCOMPARE(*sceneWith(rope, {}), rope);
        QCOMPARE(unitOf(rope, name + ".built.length"), std::string("m"));
        QCOMPARE(unitOf(rope, name + ".built.lenght"), std::string());
    }

    // A number may bring its unit. A hoop counts without pressure only: its mass changes nothing of
    // a canopy that has some, unless the other is set as well.
    void parametersHaveUnitsAndMayBeIdle()
    {
        const Scene chute =
            *build(*findBuilder("parachute"), newDesign(*findBuilder("parachute"), {}));
        const auto heavy = sceneWith(chute, {"parachute.built.payload=100 lb"});
        QVERIFY2(heavy, heavy ? "" : heavy.message().english().c_str());
        forEachPart(*heavy, [](Id, const Part& part) {
            QVERIFY(std::abs(part.parameters.at("payload") - 45.359237) < 1e-9); // by definition
        });
        const std::string mass = "parachute.built.hoop_mass";
        const std::string pressure = "parachute.built.pressure";
        QCOMPARE(idleAmong(chute, {mass}), std::vector{mass});
        QCOMPARE(idleAmong(chute, {mass, pressure}), std::vector<std::string>());
        QCOMPARE(idleAmong(chute, {pressure, "wind.velocity"}), std::vector<std::string>());
    }

    void whatCannotBeBuiltIsNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("fragment");
        QTest::newRow("no such part") << "kite.built.length=1"
                                      << "kite";
        QTest::newRow("a typing error") << "rope.built.lenght=1"
                                        << "did you mean \"length\"";
        QTest::newRow("no number") << "rope.built.length=long"
                                   << "must be a number";
        QTest::newRow("out of range") << "rope.built.length=-1"
                                      << "length";
    }

    void whatCannotBeBuiltIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, fragment);
        const Scene rope = *build(*findBuilder("rope"), {});
        const auto made = sceneWith(rope, {text.toStdString()});
        QVERIFY(!made);
        const QString said = QString::fromStdString(made.message().english());
        QVERIFY2(said.contains(fragment), qPrintable(said));
    }

    // Points that are drawn lie where their numbers are, and vectors side by side.
    void drawnPointsLieByTheirNumbers()
    {
        const QTemporaryDir folder;
        const auto opened = openStudy(
            writeStudy(folder, R"({"kind": "sobol", "count": 16, "seed": 3})").toStdString());
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        const StudyMap map = mapOf(*opened, StudyFlights(16, nullptr), {1, 0, 0, {}});
        QVERIFY(!map.isGrid);
        QCOMPARE(map.points.size(), std::size_t(16));
        for (const StudyMap::Point& point : map.points) {
            const auto values = opened->points.values(point.number);
            QCOMPARE(point.x, std::stod(values[1]));
            QCOMPARE(point.y, values[0] == "0,-9.81,0" ? 0.0 : 1.0);
        }
        QVERIFY(frontier(map).empty());
    }
};

const RegisteredTest registered("test_study_map", runPlain<TestStudyMap>);

} // namespace ripstop::test_study_map
#include "test_study_map.moc"
