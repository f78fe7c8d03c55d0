// Parachutes and hang gliders of what one can buy fly: a canopy of cloth stays open by the air in
// it alone, and all sink as such craft do, whatever their mesh and their cloth.
//
// Stages: the canopy that collapses, its start, the one that opens, the cross; then the limit of
// stiff cloth, meshes, cloths, tubes that bend, luff lines, the glider.
#include "model/real_craft.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>
#include <optional>

namespace ripstop::test_real_flights {

namespace {

// The same of stiffer and airtight cloth, spars and lines.
Scene stiffened(Scene scene, double factor)
{
    for (Entry& entry : scene.items)
        if (Material* material = std::get_if<Material>(&entry.item)) {
            for (std::optional<double>* stiffness :
                 {&material->membraneStiffness, &material->weftStiffness, &material->shearStiffness,
                  &material->axialStiffness})
                if (*stiffness)
                    **stiffness *= factor;
            material->flexuralRigidity *= factor;
            material->porosity = 0.0;
        }
    return scene;
}

// m that a canopy in folds, thrown down at 20 m/s, falls until it is full; 0 when it stays shut.
double wayOfFilling(const Scene& scene)
{
    Simulation simulation(*compile(scene));
    const double from = probe(simulation, "height");
    while (simulation.state().canopies[0].fullness < 0.9)
        if (!simulation.step() || simulation.state().time > 10.0)
            return 0.0;
    return from - probe(simulation, "height");
}

double meanPull(const Scene& scene) // N, of the line
{
    Simulation simulation(*compile(scene));
    constexpr int looks = 100;
    double pull = 0.0;
    for (int look = 0; look < looks; ++look) {
        if (!simulation.runUntil(8.0 + 0.05 * look))
            return 0.0;
        pull += probe(simulation, "line tension") / looks;
    }
    return pull;
}

} // namespace

class TestRealFlights : public QObject
{
    Q_OBJECT

private slots:
    // Cloth pushes nothing. Without air in it, nothing holds the mouth of a canopy open against the
    // lines, which pull it in; full, it is 0.67 D0 = 3.35 m wide (Knacke 1991, table 5-1).
    void collapsesWithoutPressure()
    {
        const Scene scene = craft("parachute", nylon({{"altitude", 1000.0}}));
        Simulation simulation(*compile(scene));
        QVERIFY(mouthWidth(scene, simulation) > 3.2);
        QVERIFY(simulation.runUntil(10.0));
        const double width = mouthWidth(scene, simulation);
        qInfo("%.2f m wide after 10 s, sinks at %.2f m/s", width, probe(simulation, "sink rate"));
        QVERIFY(width < 0.5 * 3.35);
    }

    // What nothing has pulled yet is not stretched, however it is cut, folded or full.
    void startsUnstrained_data()
    {
        QTest::addColumn<double>("sectors");
        QTest::addColumn<double>("rings");
        for (const auto& [sectors, rings] : {std::pair(6.0, 3.0), {12.0, 4.0}, {24.0, 6.0}})
            QTest::addRow("%.0f gores", sectors) << sectors << rings;
    }

    void startsUnstrained()
    {
        QFETCH(double, sectors);
        QFETCH(double, rings);
        for (const auto& [mouth, vent] : {std::pair(0.0, 0.0),
                                          {0.05, 0.0},
                                          {0.3, 0.0},
                                          {0.6, 0.0},
                                          {0.0, 0.5},
                                          {0.05, 0.5},
                                          {0.3, 0.5}}) {
            const Scene scene = craft("parachute", nylon({{"pressure", 1.68},
                                                          {"mouth", mouth},
                                                          {"vent_diameter", vent},
                                                          {"sectors", sectors},
                                                          {"rings", rings}}));
            Simulation simulation(*compile(scene));
            const double strain = probe(simulation, "max strain");
            QVERIFY2(strain < 1e-9, told(strain, mouth));
        }
    }

    // The air opens it from folds, and holds it as wide as round canopies are: 0.67 to 0.70 D0
    // (Knacke 1991, table 5-1). It sinks with CD0 of 0.65 to 0.85 (validation 4.8).
    void opensWithPressure()
    {
        const Scene scene = craft(
            "parachute",
            nylon({{"pressure", 1.68}, {"mouth", 0.1}, {"speed", 20.0}, {"altitude", 1000.0}}));
        Simulation simulation(*compile(scene));
        QVERIFY(mouthWidth(scene, simulation) < 0.2 * 5.0);
        QVERIFY(simulation.runUntil(10.0));
        double width = 0.0, rate = 0.0;
        constexpr int looks = 100;
        for (int look = 0; look < looks; ++look) {
            QVERIFY(simulation.runUntil(10.0 + 0.1 * look));
            width += mouthWidth(scene, simulation) / looks;
            rate += probe(simulation, "sink rate") / looks;
        }
        const double mass = massOf(partOf(scene));
        const double drag = 2.0 * mass * 9.80665 / (1.225 * 0.25 * pi * 25.0 * rate * rate);
        qInfo("%.2f m wide, sinks at %.2f m/s: CD0 %.3f", width, rate, drag);
        QVERIFY(width > 0.6 * 5.0 && width < 0.75 * 5.0);
        QVERIFY(drag > 0.65 && drag < 0.85);
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    // A vent of a tenth of the diameter, a = 1 % of the area, takes at least its share of the area
    // and so of the drag, which at one weight is 1 / v^2. It takes no more than its share of the
    // area across the wind, a / 0.62^2 at the least width of full round canopies, and what the air
    // that leaves by it takes from the pressure of cloth that leaks nothing, (1 + 0.6 a
    // sqrt(Cp))^-2 (forces/canopy_air.h).
    void ventTakesItsShare_data()
    {
        QTest::addColumn<Parameters>("given");
        QTest::newRow("nylon") << nylon({{"pressure", 1.68}, {"altitude", 1000.0}});
        QTest::newRow("ideal") << Parameters{{"pressure", 1.68}, {"altitude", 1000.0}};
    }

    void ventTakesItsShare()
    {
        QFETCH(Parameters, given);
        double rate[2] = {};
        for (const int vented : {0, 1}) {
            given["vent_diameter"] = vented * 0.5;
            Simulation simulation(*compile(craft("parachute", given)));
            constexpr int looks = 100;
            for (int look = 0; look < looks; ++look) {
                QVERIFY(simulation.runUntil(10.0 + 0.1 * look));
                rate[vented] += probe(simulation, "sink rate") / looks;
            }
            QVERIFY(simulation.frame()->accuracy.isMet());
        }
        const double left = std::pow(rate[0] / rate[1], 2.0); // 1, of the drag
        constexpr double share = 0.01;
        const double pressure = std::pow(1.0 + 0.6 * share / (1.0 - share) * std::sqrt(1.68), -2.0);
        qInfo("%.3f and %.3f m/s: %.2f %% of the drag is left", rate[0], rate[1], 100.0 * left);
        QVERIFY(left < 1.0 - share);
        QVERIFY(left > (1.0 - share / (0.62 * 0.62)) * pressure);
    }

    // Cross parachutes have CD0 of 0.60 to 0.85 on the area of the cloth (Knacke 1991, table 5-1).
    // Cloth that lets air through takes from the 0.7 that the builder is told.
    void crossSinks()
    {
        const Scene scene = craft("cross_parachute", nylonCross());
        QCOMPARE(partOf(scene).carrier, FabricKind::Panels);
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(10.0));
        const double rate = probe(simulation, "sink rate");
        const double area = 5.0 * 1.5 * 1.5;
        const double drag = 2.0 * massOf(partOf(scene)) * 9.80665 / (1.225 * area * rate * rate);
        qInfo("sinks at %.2f m/s: CD0 %.3f", rate, drag);
        QVERIFY(drag > 0.60 && drag < 0.70);
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    // The law of panels and that of ideal threads are one in the limit of cloth that does not
    // stretch and lets no air through, whatever shape the craft starts in.
    void stiffCraftFlyAsIdealOnes()
    {
        const Parameters opening{
            {"pressure", 1.68}, {"mouth", 0.05}, {"speed", 20.0}, {"altitude", 1000.0}};
        Parameters ideal = opening;
        ideal["cloth"] = ideal["cord"] = 0.0;
        const double way = wayOfFilling(stiffened(craft("parachute", nylon(opening)), 10.0));
        const double idealWay = wayOfFilling(craft("parachute", ideal));
        qInfo("full after %.2f m, of ideal cloth after %.2f m", way, idealWay);
        QVERIFY2(isNear(way, idealWay, 0.05 * idealWay), told(way, idealWay));

        const double pull = meanPull(stiffened(craft("rectangular_kite", {}), 100.0));
        const double idealPull =
            meanPull(craft("rectangular_kite", {{"cloth", 0.0}, {"spars", 0.0}, {"cord", 0.0}}));
        qInfo("pulls with %.3f N, of ideal cloth with %.3f N", pull, idealPull);
        QVERIFY2(isNear(pull, idealPull, 0.01 * idealPull), told(pull, idealPull));
    }

    // The same craft cut into other panels, and a canopy into other gores, sinks as fast.
    void sinksAlikeAtAnyResolution_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<Parameters>("coarse");
        QTest::addColumn<Parameters>("usual");
        QTest::addColumn<Parameters>("fine");
        QTest::newRow("parachute")
            << QByteArray("parachute") << Parameters{{"rings", 4.0}, {"sectors", 12.0}}
            << Parameters{{"rings", 6.0}, {"sectors", 24.0}}
            << Parameters{{"rings", 12.0}, {"sectors", 48.0}};
        QTest::newRow("hang glider")
            << QByteArray("hang_glider") << Parameters{{"segments", 12.0}}
            << Parameters{{"segments", 8.0}} << Parameters{{"segments", 16.0}};
    }

    void sinksAlikeAtAnyResolution()
    {
        QFETCH(QByteArray, builder);
        const auto sinkRate = [&](const Parameters& mesh) {
            Parameters given = builder == "parachute" ? nylon({{"pressure", 1.68}}) : dacron();
            given["altitude"] = 1000.0;
            given.insert(mesh.begin(), mesh.end());
            Simulation simulation(*compile(craft(builder, given)));
            constexpr int looks = 100; // the glider swings a little
            double rate = 0.0;
            for (int look = 0; look < looks; ++look) {
                if (!simulation.runUntil(15.0 + 0.1 * look))
                    qFatal("it did not fly");
                rate += probe(simulation, "sink rate") / looks;
            }
            return rate;
        };
        QFETCH(Parameters, coarse);
        QFETCH(Parameters, usual);
        QFETCH(Parameters, fine);
        const double finest = sinkRate(fine);
        for (const Parameters& mesh : {coarse, usual}) {
            const double rate = sinkRate(mesh);
            qInfo("%.4f m/s, the finest %.4f", rate, finest);
            QVERIFY(std::abs(rate / finest - 1.0) < 0.01);
        }
    }

    void everyClothFlies_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<double>("cloth");
        for (const char* builder : {"parachute", "cross_parachute", "hang_glider"}) {
            const auto& choices = parameterOf(builder, "cloth").choices;
            for (std::size_t i = 1; i < choices.size(); ++i)
                QTest::addRow("%s, %s", builder, std::string(choices[i]).c_str())
                    << QByteArray(builder) << double(i);
        }
    }

    void everyClothFlies()
    {
        QFETCH(QByteArray, builder);
        QFETCH(double, cloth);
        Parameters given = builder == "parachute"         ? nylon({{"pressure", 1.68}})
                           : builder == "cross_parachute" ? nylonCross()
                                                          : dacron();
        given["cloth"] = cloth;
        Simulation simulation(*compile(craft(builder, given)));
        QVERIFY(simulation.runUntil(5.0));
        QVERIFY(simulation.frame()->accuracy.isMet());
        QVERIFY(probe(simulation, "max strain") < 0.05);
    }

    // Leading edges bend outside of the cross tube; softer ones more.
    void tubesBend()
    {
        const auto rise = [](double rigidity) { // m, of the tips over the ends of the cross tube
            Scene scene = craft("hang_glider", dacron({{"altitude", 400.0}}));
            for (Entry& entry : scene.items)
                if (Material* tube = std::get_if<Material>(&entry.item);
                    tube && tube->name == "tube")
                    tube->flexuralRigidity = rigidity;
            const std::vector<Id> edge = members(scene, "leading edge"); // nose, left side, right
            Simulation simulation(*compile(scene));
            if (!simulation.runUntil(10.0))
                qFatal("it did not fly");
            const auto at = [&](std::size_t node) -> Vec3 {
                const auto& keys = simulation.system().key;
                const auto found = std::ranges::find(keys, std::uint32_t(edge[node]));
                return simulation.state().position[std::size_t(found - keys.begin())];
            };
            const std::size_t rows = (edge.size() - 1) / 2, held = 2 * rows / 3;
            const Vec3 straight = at(0) + 1.5 * (at(held) - at(0)); // where a stiff tip would be
            return (at(rows) - straight).norm();
        };
        const double stiff = rise(2e6), soft = rise(1500.0);
        qInfo("tips bend %.3f and %.3f m", stiff, soft);
        QVERIFY(soft > 3.0 * stiff);
    }

    // A sail that is pressed down in a dive loses the twist that turns the nose up, and dives on;
    // lines that keep its edge where it is cut leave the wing nearer to the speed that it is
    // trimmed for. In slow flight the edge rises and they do nothing.
    void luffLinesHoldADive()
    {
        const auto speedOf = [](double trim, double lines) {
            Simulation simulation(*compile(
                craft("hang_glider",
                      dacron({{"altitude", 1000.0}, {"speed", trim}, {"luff_lines", lines}}))));
            if (!simulation.runUntil(40.0))
                qFatal("it did not fly");
            return probe(simulation, "speed");
        };
        QVERIFY(std::abs(speedOf(11.0, 2.0) / speedOf(11.0, 0.0) - 1.0) < 1e-3);
        const double without = speedOf(16.0, 0.0), with = speedOf(16.0, 2.0);
        qInfo("trimmed for 16 m/s it flies at %.2f m/s, with lines at %.2f", without, with);
        QVERIFY(std::abs(with - 16.0) < 0.6 * std::abs(without - 16.0));
    }

    // As the ideal one does: a glide ratio above 2, held (validation 4.7).
    void gliderGlides()
    {
        Simulation simulation(*compile(craft("hang_glider", dacron({{"altitude", 400.0}}))));
        QVERIFY(simulation.runUntil(15.0));
        double lowest = 1e9, highest = 0.0;
        for (double time = 15.0; time <= 30.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            lowest = std::min(lowest, probe(simulation, "glide ratio"));
            highest = std::max(highest, probe(simulation, "glide ratio"));
        }
        qInfo("glide ratio %.2f to %.2f at %.2f m/s, strain %.4f", lowest, highest,
              probe(simulation, "speed"), probe(simulation, "max strain"));
        QVERIFY(lowest > 2.0);
        QVERIFY(highest / lowest < 1.2);
        QVERIFY(simulation.frame()->accuracy.isMet());
    }
};

const RegisteredTest registered("test_real_flights", runPlain<TestRealFlights>);

} // namespace ripstop::test_real_flights
#include "test_real_flights.moc"
