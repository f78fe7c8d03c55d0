// Kites of what one can buy: what they weigh, that they fly by default, and that the mesh does not
// matter.
//
// Stages: what is offered is in the library; an ideal kite is the paper's; then a real one, whose
// mass is summed up by hand, built and flown at several resolutions, and of every cloth; at last
// lines and sheets.
#include "builders/craft_materials.h"
#include "check/check.h"
#include "check/strength_gaps.h"
#include "derived/cloth_area.h"
#include "materials/presets.h"
#include "measure/diagnostics.h"
#include "model/sample_scenes.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>
#include <set>

namespace ripstop::test_craft_materials {

namespace {

Scene kite(const Parameters& given, const char* builder = "delta_kite")
{
    const Result<Scene> scene = build(*findBuilder(builder), given);
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

// What who makes a new kite gets.
Parameters real(double segments = 14)
{
    return newDesign(*findBuilder("delta_kite"), {{"segments", segments}});
}

double number(const char* preset, std::string_view key)
{
    for (const PresetNumber& number : (*findPreset(preset))->values)
        if (number.key == key)
            return std::get<double>(number.value);
    qFatal("%s has no %s", preset, std::string(key).c_str());
}

double massOf(const Part& part)
{
    double mass = 0.0;
    for (const Particle& particle : part.particles)
        mass += particle.mass;
    return mass;
}

// The largest principal stress, N/m, as a mean over the middle of both halves of a sail.
double middleStress(const Scene& scene, const Simulation& simulation)
{
    const Part& part = partOf(scene);
    const System& system = simulation.system();
    const std::vector<PanelPull> pulls = panelPulls(system, simulation.state());
    double sum = 0.0, area = 0.0;
    for (const Membrane& membrane : system.membranes) {
        const Panel& panel = part.panels[std::size_t(membrane.panel)];
        if (findItem<Material>(scene, panel.material)->name == "keel cloth")
            continue;
        double along = 0.0, across = 0.0; // of the chord; of the half span there
        for (const Id corner : {panel.a, panel.b, panel.c}) {
            const Particle& node = *findRow(part.particles, corner);
            along += (1.0 - node.textureV) / 3.0;
            across += 2.0 * std::abs(node.textureU - 0.5) / 3.0;
        }
        if (along < 0.4 || along > 0.85 || across < 0.2 * along || across > 0.8 * along)
            continue;
        sum += membrane.area * pulls[std::size_t(membrane.panel)].tension;
        area += membrane.area;
    }
    return sum / area;
}

} // namespace

class TestCraftMaterials : public QObject
{
    Q_OBJECT

private slots:
    void libraryHasWhatIsOffered()
    {
        const auto verify = [](std::span<const std::string_view> choices, PresetKind kind,
                               std::initializer_list<const char*> keys) {
            QCOMPARE(choices[0], std::string_view("ideal"));
            for (const std::string_view choice : choices.subspan(1)) {
                const Result<const Preset*> preset = findPreset(choice);
                QVERIFY2(preset, std::string(choice).c_str());
                QCOMPARE((*preset)->kind, kind);
                for (const char* key : keys)
                    QVERIFY(number(std::string(choice).c_str(), key) > 0.0);
            }
        };
        verify(clothChoices, PresetKind::Fabric, {"membraneStiffness", "arealDensity"});
        verify(sparChoices, PresetKind::Spar,
               {"axialStiffness", "flexuralRigidity", "linearDensity"});
        verify(cordChoices, PresetKind::Line, {"axialStiffness", "linearDensity", "diameter"});
    }

    void anIdealKiteIsThePapers()
    {
        const Scene scene = kite({});
        const Part& part = partOf(scene);
        QCOMPARE(part.carrier, FabricKind::Threads);
        QCOMPARE(part.links.size(), std::size_t(458));
        const auto system = compile(scene);
        for (const Rod& rod : (*system)->rods)
            QCOMPARE(rod.compliance, 0.0);
        for (const Entry& entry : scene.items)
            if (const auto* material = std::get_if<Material>(&entry.item))
                QVERIFY(!material->lineStrength && !material->jointEfficiency);
    }

    // Cloth by its area, spars and line by their lengths; the line's two pinned ends weigh a
    // segment each.
    void weighsWhatItIsMadeOf()
    {
        const Scene scene = kite(real());
        const Part& part = partOf(scene);
        double spars = 0.0;
        for (const Link& link : part.links)
            if (findItem<Material>(scene, link.material)->name == "spar")
                spars += link.restLength;
        const double line =
            part.parameters.at("line_length") * number("liros_ltc45", "linearDensity");
        const double expected = ClothArea(part).whole() * number("ripstop_075", "arealDensity")
                                + spars * number("fibreglass_tube_6", "linearDensity")
                                + line * (1.0 + 1.5 / part.parameters.at("line"));
        const double mass = massOf(part);
        QVERIFY2(std::abs(mass - expected) < 1e-6 * expected,
                 qPrintable(QString("%1 of %2 kg").arg(mass).arg(expected)));
    }

    void nothingIsIdealInARealKite_data()
    {
        QTest::addColumn<QByteArray>("builder");
        for (const char* builder : {"delta_kite", "diamond_kite", "rectangular_kite"})
            QTest::newRow(builder) << QByteArray(builder);
    }

    void nothingIsIdealInARealKite()
    {
        QFETCH(QByteArray, builder);
        const Scene scene = kite({{"cloth", 2}, {"spars", 1}, {"cord", 3}}, builder);
        QCOMPARE(partOf(scene).carrier, FabricKind::Panels);
        QVERIFY(problemsOf(scene).empty());
        const auto system = compile(scene);
        QVERIFY(bool(system));
        for (const Rod& rod : (*system)->rods)
            QVERIFY(rod.compliance > 0.0);
        Simulation simulation(*system);
        QVERIFY(simulation.runUntil(10.0));
        QVERIFY(probe(simulation, "line angle") > 35.0); // where it was launched
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    // A hem is 2 cm of the cloth, 8000 N/m of 0.75 oz at 0.8 of its seams. Only what stands for the
    // joints of the frame is nothing that one can buy.
    void allButTheFrameHasAStrength_data() { nothingIsIdealInARealKite_data(); }

    void allButTheFrameHasAStrength()
    {
        QFETCH(QByteArray, builder);
        const Scene scene = kite({{"cloth", 2}, {"spars", 1}, {"cord", 3}}, builder);
        for (const Id id : materialsWithoutStrength(scene))
            QCOMPARE(nameOf(*findItem(scene, id)), std::string("frame"));
        for (const Entry& entry : scene.items)
            if (const auto* m = std::get_if<Material>(&entry.item);
                m && (m->name == "hem" || m->name == "edge" || m->name == "tail")) {
                QCOMPARE(m->lineStrength, std::optional(160.0));
                QCOMPARE(m->jointEfficiency, std::optional(0.8));
            }
    }

    // What is known to break does so without being told.
    void tearsByItsStrength_data() { nothingIsIdealInARealKite_data(); }

    void tearsByItsStrength()
    {
        QFETCH(QByteArray, builder);
        const Scene scene = kite({{"cloth", 2}, {"spars", 1}, {"cord", 3}}, builder);
        QCOMPARE(materialsThatNeverTear(scene), std::vector<Id>());
    }

    // The same kite cut into other panels: the keel begins where it is told to, all weighs the same
    // and hangs in balance at the same point of the wing. What is left of a difference in area, and
    // of the angle at which it is trimmed for the launch, is that of an arch of few panels.
    void isTheSameKiteAtAnyResolution()
    {
        struct Built
        {
            double front, mass, area, pitch;
            Vec3 center;
        };
        const auto built = [](double segments) {
            const Scene scene = kite(real(segments));
            const Part& part = partOf(scene);
            Built one{0.0, massOf(part), ClothArea(part).whole(), 0.0, Vec3::Zero()};
            std::set<Id> corners; // of the kite, without its line
            Vec3 nose, tail;
            for (const Panel& panel : part.panels)
                for (const Id corner : {panel.a, panel.b, panel.c}) {
                    const Particle& node = *findRow(part.particles, corner);
                    corners.insert(corner);
                    if (findItem<Material>(scene, panel.material)->name == "keel cloth")
                        one.front = std::max(one.front, node.textureV); // 1 at the nose
                    else if (std::abs(node.textureV - 1.0) < 1e-12)
                        nose = node.position;
                    else if (std::hypot(node.textureU - 0.5, node.textureV) < 1e-12)
                        tail = node.position;
                }
            double mass = 0.0;
            Vec3 center = Vec3::Zero();
            for (const Id corner : corners) {
                const Particle& node = *findRow(part.particles, corner);
                mass += node.mass;
                center += node.mass * (node.position - nose);
            }
            const Vec3 back = (tail - nose).normalized(), side = Vec3::UnitZ();
            one.pitch = std::asin(back.y());
            one.center = Vec3(center.dot(back), center.dot(back.cross(side)), center.z()) / mass;
            return one;
        };
        const Built fine = built(28);
        QVERIFY(std::abs(fine.front - 0.7) < 1e-12);
        for (const double segments : {8.0, 14.0, 20.0}) {
            const Built other = built(segments);
            QVERIFY(std::abs(other.front - 0.7) < 1e-12);
            QVERIFY(std::abs(other.mass / fine.mass - 1.0) < 0.001);
            QVERIFY(std::abs(other.area / fine.area - 1.0) < 0.002);
            QVERIFY((other.center - fine.center).norm() < 0.0005);
            QVERIFY(std::abs(other.pitch - fine.pitch) < 0.01);
        }
    }

    // It stands at the same angle and pulls the same, its sail bears the same in its middle, and
    // what it does is that of shorter steps.
    void fliesAlikeAtAnyResolution()
    {
        struct Flown
        {
            double angle = 0.0, pull = 0.0, stress = 0.0;
        };
        const auto flown = [](double segments, int substeps) {
            Scene scene = kite(real(segments));
            scene.settings.substeps *= substeps;
            Simulation simulation(*compile(scene));
            constexpr int looks = 50;
            Flown mean;
            for (int i = 0; i < looks; ++i) {
                if (!simulation.runUntil(10.0 + 0.1 * i))
                    qFatal("it did not fly");
                mean.angle += probe(simulation, "line angle") / looks;
                mean.pull += probe(simulation, "line tension") / looks;
                mean.stress += middleStress(scene, simulation) / looks;
            }
            qInfo("%.0f segments: %.2f degrees, %.2f N, %.2f N/m", segments, mean.angle, mean.pull,
                  mean.stress);
            return mean;
        };
        const Flown finest = flown(28, 1);
        const auto isAlike = [&](const Flown& other) {
            return std::abs(other.angle / finest.angle - 1.0) < 0.005
                   && std::abs(other.pull / finest.pull - 1.0) < 0.01
                   && std::abs(other.stress / finest.stress - 1.0) < 0.05;
        };
        QVERIFY(isAlike(flown(28, 4)));
        QVERIFY(isAlike(flown(14, 1)));
        QVERIFY(isAlike(flown(8, 1)));
    }

    // Pushed aside, it comes back to where the wind blows: a minute and a half later it sways by
    // less than half of what the push gave it. What is left of it then depends on how the sail
    // flutters, and is another in shorter steps.
    void comesBackFromASway_data()
    {
        QTest::addColumn<double>("wind");
        for (const double wind : {4.0, 6.0, 10.0})
            QTest::newRow(qPrintable(QString("%1 m/s").arg(wind))) << wind;
    }

    void comesBackFromASway()
    {
        QFETCH(double, wind);
        Parameters given = real();
        given["wind"] = wind;
        const auto compiled = compile(kite(given));
        Simulation settling(*compiled);
        QVERIFY(settling.runUntil(6.0));
        System pushed = **compiled;
        pushed.start = settling.state();
        pushed.start.time = 0.0;
        for (std::size_t i = 0; i < pushed.start.velocity.size(); ++i)
            if (pushed.inverseMass[i] > 0.0)
                pushed.start.velocity[i].z() += 1.0; // m/s
        Simulation simulation(std::make_shared<const System>(pushed));
        const auto largestSway = [&](double from, double until) {
            double largest = 0.0;
            for (double time = from; time < until; time += 0.1) {
                if (!simulation.runUntil(time))
                    qFatal("it did not fly");
                largest = std::max(largest, std::abs(simulation.state().position[0].z()));
            }
            return largest;
        };
        const double early = largestSway(0.0, 20.0), late = largestSway(90.0, 110.0);
        qInfo("it sways by %.3f and %.3f m", early, late);
        QVERIFY(late < 0.5 * early);
    }

    void everyClothFlies_data()
    {
        QTest::addColumn<double>("cloth");
        for (std::size_t i = 1; i < clothChoices.size(); ++i)
            QTest::newRow(std::string(clothChoices[i]).c_str()) << double(i);
    }

    void everyClothFlies()
    {
        QFETCH(double, cloth);
        Parameters given = real();
        given["cloth"] = cloth;
        Simulation simulation(*compile(kite(given)));
        QVERIFY(simulation.runUntil(5.0));
        QVERIFY(simulation.frame()->accuracy.isMet());
        QVERIFY(probe(simulation, "max strain") < 0.05);
    }

    // A bob at the end of 10 m of line bounces about where the line is longer by
    // L (m g + w L g / 2) / EA, w being its mass per length.
    void aLineIsAsLongAsItsCordSays()
    {
        constexpr double length = 10.0, bob = 10.0; // m, kg
        const Parameters given{
            {"cord", 3}, {"length", length}, {"angle", 0}, {"segments", 30}, {"end_mass", bob}};
        Simulation simulation(*compile(kite(given, "rope")));
        double mean = 0.0;
        constexpr int looks = 1000; // over some thirty bounces
        for (int i = 1; i <= looks; ++i) {
            QVERIFY(simulation.runUntil(0.02 * i));
            mean += probe(simulation, "distance") / looks;
        }
        const double weight = bob + 0.5 * length * number("liros_ltc45", "linearDensity");
        const double longer = length * weight * 9.80665 / number("liros_ltc45", "axialStiffness");
        QVERIFY2(std::abs((mean - length) / longer - 1.0) < 0.02,
                 qPrintable(QString("%1 of %2 mm").arg(1e3 * (mean - length)).arg(1e3 * longer)));
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    // Of the cloth that is chosen, carried by panels, whatever is said of ideal ones; and it lies
    // on its ball, which it does not pass through.
    void aSheetIsOfItsCloth()
    {
        const Scene scene = kite({{"cloth", 2}, {"density", 5}, {"stiffness", 1}}, "cloth");
        const Part& part = partOf(scene);
        QVERIFY(part.links.empty());
        QCOMPARE(part.carrier, FabricKind::Panels);
        const double expected = number("ripstop_075", "arealDensity"); // of 1 m^2
        QVERIFY(std::abs(massOf(part) / expected - 1.0) < 1e-9);
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(3.0));
        QVERIFY(probe(simulation, "max strain") < 0.01);
        QVERIFY(probe(simulation, "lower edge") > 0.0);
        QCOMPARE(simulation.frame()->accuracy.missed, 0); // no step, as it lands least of all
    }

    // What holds real cloth open where no air does: v = sqrt(2 m g / (rho CD0 S0)) (Knacke 1991,
    // page 5-128), the drag being set for the shape that it is built in, and the cloth bellies.
    void aHoopHoldsRealCloth()
    {
        const Scene scene =
            kite({{"cloth", 1}, {"cord", 1}, {"pressure", 0}, {"hoop", 1}}, "parachute");
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(6.0));
        const double area = 0.25 * std::numbers::pi * 25.0; // m^2
        const double expected =
            std::sqrt(2.0 * massOf(partOf(scene)) * standardGravity / (1.225 * 0.775 * area));
        const double rate = probe(simulation, "sink rate");
        QVERIFY2(isNear(rate, expected, 0.15 * expected), told(rate, expected));
    }

    // All around a new flag runs a hem, 2 cm of the cloth for each metre: that is its weight, and
    // what it bears. It flies for two seconds without a tear.
    void aFlagIsHemmed()
    {
        const Scene scene = kite(newDesign(*findBuilder("pole_flag"), {}), "pole_flag");
        const double cloth = number("ripstop_075", "arealDensity");
        const double expected = cloth * (1.2 * 0.8 + 0.02 * 2.0 * (1.2 + 0.8)); // kg
        double mass = 0.0; // what is not of the pole
        double along = 0.0;
        const Part& part = partOf(scene);
        for (const Particle& particle : part.particles)
            mass += particle.position.x() > 0.01 ? particle.mass : 0.0;
        const Material* hem = nullptr;
        for (const Link& link : part.links)
            if (const auto* material = findItem<Material>(scene, link.material);
                material->name == "hem") {
                hem = material;
                along += link.restLength;
            }
        QVERIFY2(std::abs(mass / expected - 1.0) < 1e-9, told(mass, expected));
        QVERIFY(std::abs(along - 4.0) < 1e-9);
        QVERIFY(
            isNear(*hem->axialStiffness, 0.02 * number("ripstop_075", "membraneStiffness"), 1e-9));
        QVERIFY(isNear(*hem->lineStrength,
                       0.02
                           * std::min(number("ripstop_075", "warpStrength"),
                                      number("ripstop_075", "weftStrength")),
                       1e-9));
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(2.0));
        QCOMPARE(simulation.frame()->accuracy.missed, 0);
        QVERIFY(simulation.state().tears.empty());
    }
};

const RegisteredTest registered("test_craft_materials", runWithCore<TestCraftMaterials>);

} // namespace ripstop::test_craft_materials
#include "test_craft_materials.moc"
