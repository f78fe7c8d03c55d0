// Parachutes and hang gliders of what one can buy: what they weigh, how their cloth is cut, and
// that a canopy of cloth stays open by the air in it alone.
//
// Stages: what is offered is in the library; masses summed up by hand; the grain of every panel;
// then flights: the canopy that collapses, the one that opens and how it sinks, cloths, the glider.
#include "builders/builder.h"
#include "check/check.h"
#include "check/strength_gaps.h"
#include "derived/cloth_area.h"
#include "derived/flat_panel.h"
#include "materials/presets.h"
#include "model/sample_scenes.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_real_craft {

namespace {

constexpr double pi = std::numbers::pi;

const Parameter& parameterOf(const char* builder, std::string_view key)
{
    for (const Parameter& parameter : findBuilder(builder)->parameters)
        if (parameter.key == key)
            return parameter;
    qFatal("no such parameter");
}

double choice(const char* builder, std::string_view key, std::string_view name)
{
    const auto& choices = parameterOf(builder, key).choices;
    const auto found = std::ranges::find(choices, name);
    if (found == choices.end())
        qFatal("no such choice");
    return double(found - choices.begin());
}

Scene craft(const char* builder, const Parameters& given)
{
    const Result<Scene> scene = build(*findBuilder(builder), given);
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

// 24 gores of 1.1 oz nylon on cords of 445 N, 2.5 m from the apex to the skirt.
Parameters nylon(const Parameters& more = {})
{
    Parameters given{{"cloth", choice("parachute", "cloth", "mil_7020_1")},
                     {"cord", choice("parachute", "cord", "mil_5040_1")},
                     {"hoop", 0.0}};
    for (const auto& [key, value] : more)
        given[key] = value;
    return given;
}

Parameters dacron(const Parameters& more = {})
{
    Parameters given{{"cloth", choice("hang_glider", "cloth", "dacron_sail")},
                     {"spars", choice("hang_glider", "spars", "aluminium_50")}};
    for (const auto& [key, value] : more)
        given[key] = value;
    return given;
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

std::vector<Id> members(const Scene& scene, std::string_view group)
{
    for (const Entry& entry : scene.items)
        if (const Group* found = std::get_if<Group>(&entry.item); found && found->name == group)
            return found->members;
    qFatal("no such group");
}

// Twice the mean distance of the skirt from its middle, m.
double mouthWidth(const Scene& scene, const Simulation& simulation)
{
    const std::vector<Id> skirt = members(scene, "skirt");
    const System& system = simulation.system();
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < system.key.size(); ++i)
        if (std::ranges::find(skirt, Id{system.key[i]}) != skirt.end())
            places.push_back(simulation.state().position[i]);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : places)
        middle += place / double(places.size());
    double width = 0.0;
    for (const Vec3& place : places)
        width += 2.0 * (place - middle).norm() / double(places.size());
    return width;
}

double middleOfGore(double x, double z) // rad, of 24
{
    constexpr double gore = 2.0 * pi / 24.0;
    return (std::floor(std::atan2(z, x) / gore) + 0.5) * gore;
}

// Where the warp of a panel runs on the cloth as it is printed, rad: from the side ab, turned
// towards c by the grain.
double warpOnPicture(const Part& part, const Panel& panel)
{
    const auto at = [&](Id id) {
        const Particle& row = *findRow(part.particles, id);
        return Eigen::Vector2d(row.textureU, row.textureV);
    };
    const Eigen::Vector2d ab = at(panel.b) - at(panel.a);
    const Eigen::Vector2d ac = at(panel.c) - at(panel.a);
    const double hand = ab.x() * ac.y() - ab.y() * ac.x() > 0.0 ? 1.0 : -1.0;
    return std::atan2(ab.y(), ab.x()) + hand * panel.grain * pi / 180.0;
}

} // namespace

class TestRealCraft : public QObject
{
    Q_OBJECT

private slots:
    void libraryHasWhatIsOffered_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<QByteArray>("parameter");
        QTest::addColumn<QList<QByteArray>>("needed");
        const QList<QByteArray> cloth{"membraneStiffness", "arealDensity", "shearStiffness"};
        const QList<QByteArray> line{"axialStiffness", "linearDensity", "lineStrength"};
        QTest::newRow("canopy") << QByteArray("parachute") << QByteArray("cloth") << cloth;
        QTest::newRow("lines") << QByteArray("parachute") << QByteArray("cord") << line;
        QTest::newRow("tapes") << QByteArray("parachute") << QByteArray("tape") << line;
        QTest::newRow("sail") << QByteArray("hang_glider") << QByteArray("cloth") << cloth;
        QTest::newRow("tubes") << QByteArray("hang_glider") << QByteArray("spars")
                               << QList<QByteArray>{"axialStiffness", "flexuralRigidity",
                                                    "linearDensity"};
    }

    void libraryHasWhatIsOffered()
    {
        QFETCH(QByteArray, builder);
        QFETCH(QByteArray, parameter);
        QFETCH(QList<QByteArray>, needed);
        for (const std::string_view name :
             parameterOf(builder, parameter.data()).choices.subspan(1))
            for (const QByteArray& key : needed)
                QVERIFY2(number(std::string(name).c_str(), key.data()) > 0.0, name.data());
    }

    // Hems are 2 cm of Dacron of 40 kN/m, wires steel cables of 920 lb (AC 43.13-1B, table 7-3);
    // seams and skirt 2 cm of nylon of 7355 N/m.
    void hemsAndWiresHaveTheirStrength()
    {
        const auto strength = [](const Scene& scene, std::string_view name) {
            const auto found = std::ranges::find_if(
                scene.items, [&](const Entry& entry) { return nameOf(entry.item) == name; });
            return std::get<Material>(found->item).lineStrength.value_or(0.0);
        };
        const Scene glider = craft("hang_glider", dacron());
        QCOMPARE(strength(glider, "hem"), 800.0);
        QVERIFY(std::abs(strength(glider, "wire") - 920.0 * 4.4482216) < 1.0);
        for (const Id id : materialsWithoutStrength(glider))
            QCOMPARE(nameOf(*findItem(glider, id)), std::string("frame"));
        const Scene canopy = craft("parachute", nylon({{"pressure", 1.68}}));
        QCOMPARE(strength(canopy, "gore seams"), 147.1);
        QCOMPARE(strength(canopy, "skirt"), 147.1);
        QVERIFY(materialsWithoutStrength(canopy).empty());
        const Scene papers = craft("hang_glider", {});
        QCOMPARE(strength(papers, "wire"), 0.0);
    }

    // The cloth has the area of D0. Gores are triangles of sides R: S/2 R^2 sin(2 pi / S) of it,
    // S R of seams, 2 S R sin(pi / S) of skirt, each of a hem of 2 cm of cloth; and S lines.
    void canopyWeighsWhatItIsMadeOf_data()
    {
        QTest::addColumn<QByteArray>("tape");
        QTest::newRow("hems") << QByteArray("hem");
        QTest::newRow("tubular nylon") << QByteArray("mil_5625_050");
    }

    void canopyWeighsWhatItIsMadeOf()
    {
        QFETCH(QByteArray, tape);
        const Scene scene =
            craft("parachute",
                  nylon({{"pressure", 1.68}, {"tape", choice("parachute", "tape", tape.data())}}));
        constexpr double S = 24.0;
        const double R = 2.5 * std::sqrt(2.0 * pi / (S * std::sin(2.0 * pi / S)));
        const double density = number("mil_7020_1", "arealDensity");
        const double hem = tape == "hem" ? 0.02 * density : number("mil_5625_050", "linearDensity");
        const double expected = density * 0.25 * pi * 5.0 * 5.0
                                + hem * S * R * (1.0 + 2.0 * std::sin(pi / S))
                                + number("mil_5040_1", "linearDensity") * S * 4.5 + 25.0;
        QVERIFY2(std::abs(massOf(partOf(scene)) / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(massOf(partOf(scene))).arg(expected)));
    }

    // Cloth by its area, three tubes by their lengths.
    void gliderWeighsWhatItIsMadeOf()
    {
        const Scene scene = craft("hang_glider", dacron({{"fittings", 9.0}}));
        const Part& part = partOf(scene);
        double tubes = 0.0;
        for (const Link& link : part.links)
            if (findItem<Material>(scene, link.material)->name == "tube")
                tubes += link.restLength;
        // the keel has 4 m and a little more, as it is bent by its reflex
        const double edge = std::hypot(4.8, 4.0, 4.8 * std::tan(3.0 * pi / 180.0));
        QVERIFY(std::abs(tubes - (2.0 * edge + 4.0)) < 0.01 * tubes);
        const double expected = ClothArea(part).whole() * number("dacron_sail", "arealDensity")
                                + tubes * number("aluminium_50", "linearDensity") + 9.0 + 65.0;
        QVERIFY2(std::abs(massOf(part) / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(massOf(part)).arg(expected)));
    }

    // The warp of flat cloth runs along the middle of each gore, or at the grain to it. The picture
    // that is printed on it is the cloth as it is cut.
    void warpFollowsTheGores_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("block cut") << 0.0;
        QTest::newRow("bias cut") << 45.0;
    }

    void warpFollowsTheGores()
    {
        QFETCH(double, grain);
        const Scene scene =
            craft("parachute", nylon({{"grain", grain}, {"pressure", 1.68}, {"rings", 12.0}}));
        const Part& part = partOf(scene);
        QCOMPARE(part.carrier, FabricKind::Panels);
        for (const Panel& panel : part.panels) {
            Eigen::Vector2d middle = Eigen::Vector2d::Zero();
            for (const Id corner : {panel.a, panel.b, panel.c}) {
                const Particle& row = *findRow(part.particles, corner);
                middle += Eigen::Vector2d(row.textureU - 0.5, row.textureV - 0.5) / 3.0;
            }
            const double along = middleOfGore(middle.x(), middle.y());
            const double off = std::remainder(
                warpOnPicture(part, panel) - along - grain * pi / 180.0, pi); // it runs both ways
            QVERIFY2(std::abs(off) < 1e-6, qPrintable(QString("%1 rad").arg(off)));
        }
    }

    // The gores of a cap are planes from ring to ring, so the warp lies in the plane through the
    // axis and the middle of its gore.
    void warpFollowsTheGoresOfACap()
    {
        const Scene scene = craft("parachute", nylon({{"rings", 12.0}}));
        const Part& part = partOf(scene);
        for (const Panel& panel : part.panels) {
            const auto at = [&](Id id) { return findRow(part.particles, id)->position; };
            const Vec3 ab = at(panel.b) - at(panel.a), ac = at(panel.c) - at(panel.a);
            const Vec3 along = ab.normalized();
            const Vec3 across = (ac - ac.dot(along) * along).normalized();
            const double grain = panel.grain * pi / 180.0;
            const Vec3 warp = std::cos(grain) * along + std::sin(grain) * across;
            const Vec3 middle = (at(panel.a) + at(panel.b) + at(panel.c)) / 3.0;
            const double turn = middleOfGore(middle.x(), middle.z());
            QVERIFY(std::abs(warp.dot(Vec3(-std::sin(turn), 0.0, std::cos(turn)))) < 1e-9);
        }
    }

    // The halves of a sail are cut as mirror images.
    void warpFollowsTheTrailingEdge_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("along the trailing edge") << 0.0;
        QTest::newRow("at an angle") << 30.0;
        QTest::newRow("along the keel") << 90.0;
    }

    void warpFollowsTheTrailingEdge()
    {
        QFETCH(double, grain);
        // flat, so that the picture is the cloth but for its two scales, 9.6 m and 4 m
        const Scene scene = craft("hang_glider", dacron({{"grain", grain},
                                                         {"billow", 0.0},
                                                         {"washout", 0.0},
                                                         {"reflex", 0.0},
                                                         {"dihedral", 0.0}}));
        const Part& part = partOf(scene);
        for (const Panel& panel : part.panels) {
            std::array<Eigen::Vector2d, 3> at;
            double side = 0.0;
            for (int corner = 0; corner < 3; ++corner) {
                const Particle& row = *findRow(
                    part.particles, std::array{panel.a, panel.b, panel.c}[std::size_t(corner)]);
                at[std::size_t(corner)] = {9.6 * (row.textureU - 0.5), 4.0 * row.textureV};
                side += row.textureU - 0.5;
            }
            const Eigen::Vector2d ab = at[1] - at[0], ac = at[2] - at[0];
            const double hand = ab.x() * ac.y() - ab.y() * ac.x() > 0.0 ? 1.0 : -1.0;
            const double warp =
                std::atan2(ab.y(), ab.x()) + hand * panel.grain * pi / 180.0; // from the right
            const double wanted = (side > 0.0 ? -1.0 : 1.0) * grain * pi / 180.0;
            QVERIFY(std::abs(std::remainder(warp - wanted, pi)) < 1e-6);
        }
    }

    void nothingIsIdealInARealCraft_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<Parameters>("given");
        QTest::newRow("parachute") << QByteArray("parachute") << nylon({{"pressure", 1.68}});
        QTest::newRow("hang glider") << QByteArray("hang_glider") << dacron();
    }

    void nothingIsIdealInARealCraft()
    {
        QFETCH(QByteArray, builder);
        QFETCH(Parameters, given);
        const Scene scene = craft(builder, given);
        QVERIFY(problemsOf(scene).empty());
        const auto system = compile(scene);
        QVERIFY(bool(system));
        for (const Rod& rod : (*system)->rods)
            QVERIFY(rod.compliance > 0.0);
        for (const Entry& entry : scene.items)
            if (const Material* material = std::get_if<Material>(&entry.item))
                QVERIFY2(material->name != "seams", "nothing is made of it");
    }

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

    // The same craft cut into other panels, and a canopy into other gores, sinks as fast; how far
    // the leading edges of the glider give way outside of its cross tube takes finer panels.
    void sinksAlikeAtAnyResolution_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<Parameters>("coarse");
        QTest::addColumn<Parameters>("usual");
        QTest::addColumn<Parameters>("fine");
        QTest::addColumn<double>("within");
        QTest::newRow("parachute")
            << QByteArray("parachute") << Parameters{{"rings", 4.0}, {"sectors", 12.0}}
            << Parameters{{"rings", 6.0}, {"sectors", 24.0}}
            << Parameters{{"rings", 12.0}, {"sectors", 48.0}} << 0.01;
        QTest::newRow("hang glider")
            << QByteArray("hang_glider") << Parameters{{"segments", 12.0}}
            << Parameters{{"segments", 8.0}} << Parameters{{"segments", 16.0}} << 0.03;
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
        QFETCH(double, within);
        const double finest = sinkRate(fine);
        for (const Parameters& mesh : {coarse, usual}) {
            const double rate = sinkRate(mesh);
            qInfo("%.4f m/s, the finest %.4f", rate, finest);
            QVERIFY(std::abs(rate / finest - 1.0) < within);
        }
    }

    void everyClothFlies_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<double>("cloth");
        for (const char* builder : {"parachute", "hang_glider"}) {
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
        const bool isCanopy = builder == "parachute";
        Parameters given = isCanopy ? nylon({{"pressure", 1.68}}) : dacron();
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

const RegisteredTest registered("test_real_craft", runPlain<TestRealCraft>);

} // namespace ripstop::test_real_craft
#include "test_real_craft.moc"
