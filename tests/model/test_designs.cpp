// Designs of the builders against closed forms: areas, masses, trim, descent, tensions.
//
// Stages: areas and figures; kites and a parachute that are flown until they are steady; lengths
// and loads of lines; frames and rigidity particles; flags and poles in the wind.
#include "author/design_figures.h"
#include "builders/statics.h"
#include "model/sample_scenes.h"
#include "registered_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <numbers>

namespace ripstop::test_designs {

namespace {

constexpr double gravity = 9.80665; // m/s^2
constexpr double air = 1.225;       // kg/m^3

Scene built(const char* name, const Parameters& given = {})
{
    const Result<Scene> scene = build(*findBuilder(name), given);
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

DesignFigures figures(const char* name, const Parameters& given = {})
{
    return designFiguresOf(built(name, given), findBuilder(name)->family);
}

Parameters parametersOf(const QVariantMap& given)
{
    Parameters parameters;
    for (auto i = given.cbegin(); i != given.cend(); ++i)
        parameters[i.key().toStdString()] = i.value().toDouble();
    return parameters;
}

Simulation started(const Scene& scene)
{
    const auto system = compile(scene);
    if (!system)
        qFatal("%s", system.message().english().c_str());
    return Simulation(*system);
}

Scene bridle(const char* lengths, Parameters given)
{
    const Builder& builder = *findBuilder("bridle");
    setTable(given, *builder.table, *tableFromText(*builder.table, lengths));
    return *build(builder, given);
}

} // namespace

class TestDesigns : public QObject
{
    Q_OBJECT

private slots:
    void areas_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QVariantMap>("given");
        QTest::addColumn<double>("area"); // m^2
        const auto row = [](const char* text, const char* name, const QVariantMap& given,
                            double area) { QTest::newRow(text) << name << given << area; };
        row("rectangle", "rectangular_kite", {{"width", 1.2}, {"height", 0.8}, {"bow", 0}}, 0.96);
        row("diamond: half of width by height", "diamond_kite",
            {{"width", 1.2}, {"height", 0.8}, {"dihedral", 0}}, 0.48);
        row("square canopy", "cross_parachute", {{"width", 2}, {"arms", 0}}, 4.0);
        row("cross: the square and four arms", "cross_parachute", {{"width", 2}, {"arms", 1.5}},
            4.0 * (1.0 + 4.0 * 1.5));
        row("flag", "pole_flag", {{"length", 1.5}, {"height", 0.5}}, 0.75);
    }

    void areas()
    {
        QFETCH(QString, name);
        QFETCH(QVariantMap, given);
        QFETCH(double, area);
        Parameters parameters = parametersOf(given);
        const DesignFigures once = figures(qPrintable(name), parameters);
        QVERIFY2(std::abs(once.area - area) < 1e-9, qPrintable(QString::number(once.area)));
        // a fabric that is 0.1 kg/m^2 heavier weighs 0.1 A more
        const char* key = name == "pole_flag" ? "density" : "fabric";
        parameters[key] = 0.1;
        const double light = figures(qPrintable(name), parameters).mass;
        parameters[key] = 0.2;
        const double heavy = figures(qPrintable(name), parameters).mass;
        QVERIFY(std::abs(heavy - light - 0.1 * area) < 1e-9);
    }

    // Folds hide cloth and take none away.
    void aFoldedCanopyHasTheClothOfAnOpenOne()
    {
        const Parameters open{{"diameter", 8}, {"hoop", 0}},
            folded{{"diameter", 8}, {"hoop", 0}, {"mouth", 0.1}};
        const double area = figures("parachute", open).area;
        QVERIFY(std::abs(figures("parachute", folded).area / area - 1.0) < 1e-6);
    }

    void figuresOfAWing()
    {
        const DesignFigures kite =
            figures("rectangular_kite", {{"width", 1.2}, {"height", 0.8}, {"bow", 0}});
        QVERIFY(kite.aspect && std::abs(*kite.aspect - 1.5) < 1e-2); // it flies at an angle
        QVERIFY(std::abs(kite.span - 1.2) < 1e-9);
        // 25 m of flying line, 3 m of tail, and the bridle
        const double bridle = kite.lineLength - 25.0 - 3.0;
        QVERIFY(bridle > 4.0 * 0.45 * 0.8 && bridle < 4.0 * 1.2); // four legs
        QVERIFY(!figures("rope").aspect);
    }

    // The moment of air and weight about the tow point is zero at the start. Without tail and
    // thickness of the line nothing else turns the kite.
    void kitesStartInTrim_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("diamond") << "diamond_kite";
        QTest::newRow("rectangular") << "rectangular_kite";
    }

    void kitesStartInTrim()
    {
        QFETCH(QString, name);
        const Scene scene = built(qPrintable(name), {{"tail_length", 0}});
        Part kite = partOf(scene);
        Id tow{};
        for (const Entry& entry : scene.items)
            if (const Probe* probe = std::get_if<Probe>(&entry.item);
                probe && probe->name == "height")
                tow = probe->target;
        const Vec3 place = findRow(kite.particles, tow)->position;
        const double angle = std::atan2(place.y() - 1.2, place.x());
        QVERIFY(std::abs(angle * 180.0 / std::numbers::pi - 35.0) < 1e-6); // of the line
        std::erase_if(kite.particles, [&](const Particle& row) { return row.id > tow; });
        const Load load = airLoad(scene, kite, Vec3(6.0, 0.0, 0.0));
        const LumpedMass weight = lumpedMassOf(kite);
        const Vec3 pull = weight.mass * gravity * -Vec3::UnitY();
        const Vec3 moment =
            load.moment - place.cross(load.force) + (weight.center - place).cross(pull);
        QVERIFY2(moment.norm() < 1e-6 * load.force.norm(),
                 qPrintable(QString::number(moment.norm())));
        QVERIFY(load.force.y() > weight.mass * gravity); // it climbs
    }

    // Up at its line after ten seconds, steady from there on.
    void kitesFly_data() { kitesStartInTrim_data(); }

    void kitesFly()
    {
        QFETCH(QString, name);
        Simulation simulation = test_designs::started(built(qPrintable(name)));
        double lowest = 90.0, highest = 0.0; // degrees
        for (double time = 12.0; time <= 16.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            lowest = std::min(lowest, probe(simulation, "line angle"));
            highest = std::max(highest, probe(simulation, "line angle"));
            QVERIFY(probe(simulation, "line tension") > 0.0);
        }
        qInfo("line angle %.1f to %.1f degrees", lowest, highest);
        QVERIFY(lowest > 30.0 && highest < 80.0);
        QVERIFY(highest - lowest < 5.0);
    }

    // Kite and wind are the same on both sides, so that there is no side to lean to. It may sweep
    // to and fro: the mean counts, of two nodes that mirror each other, on a line of 25 m.
    void kitesHangToNoSide_data() { kitesStartInTrim_data(); }

    void kitesHangToNoSide()
    {
        QFETCH(QString, name);
        const Scene scene = built(qPrintable(name));
        const std::vector<Particle>& rows = partOf(scene).particles;
        const auto spars = std::ranges::find_if(
            scene.items, [](const Entry& entry) { return nameOf(entry.item) == "spars"; });
        const auto& nodes = std::get<Group>(spars->item).members;
        const auto start = [&](Id id) { return findRow(rows, id)->position; };
        const Id left = std::ranges::min(nodes, {}, [&](Id id) { return start(id).z(); });
        const Vec3 mirrored = start(left).cwiseProduct(Vec3(1.0, 1.0, -1.0));
        const Id right =
            std::ranges::min(nodes, {}, [&](Id id) { return (start(id) - mirrored).norm(); });
        Simulation simulation = test_designs::started(scene);
        const auto now = [&](Id id) {
            return simulation.state().position[std::size_t(findRow(rows, id) - rows.data())];
        };
        double roll = 0.0, aside = 0.0; // degrees, m
        int count = 0;
        for (double time = 8.0; time <= 24.0; time += 0.5, ++count) {
            QVERIFY(simulation.runUntil(time));
            const Vec3 span = now(right) - now(left);
            roll += std::atan2(span.y(), span.z()) * 180.0 / std::numbers::pi;
            aside += 0.5 * (now(left) + now(right)).z();
        }
        qInfo("rolls by %.2f degrees, %.2f m aside", roll / count, aside / count);
        QVERIFY(std::abs(roll / count) < 0.5);
        QVERIFY(std::abs(aside / count) < 0.25);
    }

    // v = sqrt(2 m g / (rho CD0 S0)), Knacke 1991, page 5-128; lines without thickness.
    void crossParachuteSinks_data()
    {
        QTest::addColumn<double>("arms");
        QTest::newRow("cruciform") << 1.0;
        QTest::newRow("square") << 0.0;
    }

    void crossParachuteSinks()
    {
        QFETCH(double, arms);
        const Scene scene = built("cross_parachute", {{"arms", arms}, {"line_diameter", 0}});
        const double mass = lumpedMassOf(partOf(scene)).mass;
        const double area = 1.5 * 1.5 * (1.0 + 4.0 * arms);
        const double expected = std::sqrt(2.0 * mass * gravity / (air * 0.7 * area));
        Simulation simulation = test_designs::started(scene);
        QVERIFY(simulation.runUntil(7.0));
        const double rate = probe(simulation, "sink rate");
        QVERIFY2(std::abs(rate / expected - 1.0) < 0.03,
                 qPrintable(QString("%1 and not %2 m/s").arg(rate).arg(expected)));
    }

    // A row of a table from the riser up, times the lines on each level: 1, 2, 4.
    void lineLengthsAreThoseOfTheTable()
    {
        const Scene scene = bridle("1.5\t0.6\t0,4\n1.6\t0.6\t0,4\n", {{"span", 1.0}});
        const double expected = 1.5 + 1.6 + 2.0 * 2.0 * 0.6 + 2.0 * 4.0 * 0.4;
        const DesignFigures found = designFiguresOf(scene, Family::Lines);
        QVERIFY(std::abs(found.lineLength - expected) < 1e-9);
        QCOMPARE(found.links, std::size_t(2 * 7));
        std::vector<double> lengths;
        for (const Link& link : partOf(scene).links)
            lengths.push_back(link.restLength);
        QCOMPARE(lengths.front(), 1.5);
        QCOMPARE(lengths[7], 1.6);
    }

    // A load F on a fork of half angle a: each line carries F / (2 cos a). Two lines of 0.5 m to
    // points 0.6 m apart: cos a = 0.8.
    void forksShareTheLoad()
    {
        Scene scene = bridle("1;", {{"load", 5.0}, {"line_density", 1e-6}});
        QCOMPARE(partOf(scene).links.size(), std::size_t(1));
        scene = bridle("1, 0.5", {{"span", 0.6}, {"load", 5.0}, {"line_density", 1e-6}});
        scene.settings.viscosity = 5.0;
        Simulation simulation = test_designs::started(scene);
        QVERIFY(simulation.runUntil(4.0));
        const auto frame = simulation.frame();
        const double load = 5.0 * gravity;
        QVERIFY2(std::abs(frame->tension[0] / load - 1.0) < 0.01,
                 qPrintable(QString::number(frame->tension[0])));
        for (const std::size_t i : {1, 2})
            QVERIFY2(std::abs(frame->tension[i] / (load / 1.6) - 1.0) < 0.01,
                     qPrintable(QString::number(frame->tension[i])));
    }

    // 3 by 2 bays over 1.5 m by 1 m: spars 3 x 1.5 + 4 x 1, braces of sqrt(0.5^2 + 0.5^2).
    void frameWeighsWhatItsSparsDo()
    {
        const double length = 3 * 1.5 + 4 * 1.0 + 6 * std::sqrt(0.5);
        QVERIFY(std::abs(figures("frame", {{"density", 0.05}}).mass - 0.05 * length) < 1e-12);
    }

    // A frame without braces folds up when it hangs by one corner; rigidity particles keep it as it
    // was.
    void rigidityParticlesKeepTheShape()
    {
        Scene scene = built("frame", {{"braces", 0}, {"rigidity", 1}});
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item))
                part->particles[0].pinned = false; // the upper left corner
        const auto shape = [](const Simulation& simulation) {
            const auto& x = simulation.state().position;
            return std::array{(x[0] - x[11]).norm(), (x[3] - x[8]).norm(), (x[0] - x[3]).norm()};
        };
        Simulation simulation = test_designs::started(scene);
        const auto before = shape(simulation);
        QVERIFY(simulation.runUntil(1.0));
        const auto after = shape(simulation);
        for (std::size_t i = 0; i < before.size(); ++i) // the diagonals and the upper edge
            QVERIFY2(std::abs(after[i] / before[i] - 1.0) < 0.02,
                     qPrintable(QString("%1 and not %2 m").arg(after[i]).arg(before[i])));
    }

    // The wind carries the fly away from the pole, which stays where it is.
    void flagStreams()
    {
        Simulation simulation = test_designs::started(built("pole_flag"));
        QVERIFY(simulation.runUntil(4.0));
        QVERIFY(probe(simulation, "fly") > 0.5 * 1.2);
        QVERIFY(std::abs(probe(simulation, "pole top")) < 1e-9);
    }

    // A pole of EI gives way to the pull of its flag.
    void poleBends()
    {
        Simulation simulation = test_designs::started(built("pole_flag", {{"rigidity", 40}}));
        QVERIFY(simulation.runUntil(3.0));
        QVERIFY(probe(simulation, "pole top") > 1e-3);
        QVERIFY(probe(simulation, "pole top") < 0.5 * 2.5);
    }
};

const RegisteredTest registered("test_designs", runPlain<TestDesigns>);

} // namespace ripstop::test_designs
#include "test_designs.moc"
