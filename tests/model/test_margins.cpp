// How near to breaking lines, cloth and spars are: margins of loads that are known by hand, with
// joints and a safety factor; what has no strength; and the worst places of a moment and of a run.
#include "check/strength_gaps.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "measure/margins.h"
#include "model/chain.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"
#include "run/has_margins.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace ripstop::test_margins {

namespace {

constexpr double g = standardGravity; // m/s^2

void addProbe(Scene& scene, Quantity quantity)
{
    scene.items.push_back({takeId(scene), Probe{.quantity = quantity}});
}

void compareWithin(double value, double expected, double share)
{
    QVERIFY2(std::abs(value - expected) <= share * std::abs(expected),
             qPrintable(QStringLiteral("%1 instead of %2").arg(value).arg(expected)));
}

} // namespace

class TestMargins : public QObject
{
    Q_OBJECT

private slots:
    // A line under a weight bears m g of its strength, less what its knots and the safety factor
    // take of that.
    void lineUnderAWeight_data()
    {
        QTest::addColumn<double>("joints");
        QTest::addColumn<double>("safety");
        QTest::newRow("as it is") << 1.0 << 1.0;
        QTest::newRow("with knots") << 0.6 << 1.0;
        QTest::newRow("twice as safe") << 1.0 << 2.0;
        QTest::newRow("both") << 0.5 << 3.0;
    }

    void lineUnderAWeight()
    {
        QFETCH(double, joints);
        QFETCH(double, safety);
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, line(100.0));
        chain.stuff().jointEfficiency = joints;
        chain.scene.settings.safetyFactor = safety;
        const auto frame = chain.after(2.0);
        const double bears = 100.0 * joints / safety;
        QCOMPARE(frame->linkMargin.size(), 1u);
        compareWithin(frame->linkMargin[0], 2.0 * g / bears, 1e-3);
        QCOMPARE(frame->worstNow.all().size(), 1u);
        const LoadedPlace& worst = frame->worstNow.all()[0];
        QCOMPARE(worst.kind, LoadKind::Line);
        QCOMPARE(worst.element, std::uint32_t(chain.row().links[0].id));
        compareWithin(worst.load, 2.0 * g, 1e-3);
        compareWithin(worst.strength, bears, 1e-12);
        compareWithin(worst.place.y(), -0.5, 2e-3);
    }

    // What tears at a limit of its own bears that, whatever its material could; and it is as near
    // to its end as that says.
    void limitInForceComesFirst()
    {
        Material cord = line(100.0);
        cord.tearRule = TearRule::Force;
        cord.tearLimit = 30.0;
        Chain byMaterial({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, cord);
        byMaterial.scene.settings.safetyFactor = 2.0;
        compareWithin(byMaterial.after(2.0)->worstNow.all()[0].strength, 15.0, 1e-12);
        byMaterial.stuff().lineStrength.reset(); // which need not be known then
        compareWithin(byMaterial.after(2.0)->worstNow.all()[0].strength, 15.0, 1e-12);
        QVERIFY(materialsWithoutStrength(byMaterial.scene).empty());

        cord = line(100.0);
        cord.tearRule = TearRule::Strength;
        Chain byItself({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, cord, Link{.tearLimit = 25.0});
        const auto frame = byItself.after(2.0);
        compareWithin(frame->worstNow.all()[0].strength, 25.0, 1e-12);
        compareWithin(frame->linkMargin[0], 2.0 * g / 25.0, 1e-3);

        Strip made = strip({.across = 2, .along = 4}, 0.0, 40.0);
        made.cloth().warpStrength = made.cloth().weftStrength = 4000.0;
        made.cloth().tearRule = TearRule::Tension;
        made.cloth().tearLimit = 1000.0;
        Simulation simulation(*compile(made.scene));
        QVERIFY(simulation.runUntil(0.1));
        compareWithin(simulation.frame()->worstNow.all()[0].strength, 1000.0, 1e-12);
    }

    // What breaks by it is told with a margin that says so.
    void tornByItsLimit()
    {
        Material cord = line(100.0);
        cord.tearRule = TearRule::Force;
        cord.tearLimit = 10.0;
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, cord);
        const LoadedPlace worst = chain.after(2.0)->worstOfRun.all()[0];
        QVERIFY(worst.torn);
        QVERIFY2(worst.margin() > 1.0, qPrintable(QString::number(worst.margin())));
    }

    // A thread stands for a strip of cloth and has the pull of it; it may be warp or weft.
    void threadByItsWidth()
    {
        Material cloth;
        cloth.membraneStiffness = 1e5;
        cloth.dampingTime = 0.02;
        cloth.warpStrength = 900.0;
        cloth.weftStrength = 600.0;
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, cloth,
                    Link{.role = LinkRole::Thread, .width = 0.05});
        addProbe(chain.scene, Quantity::FabricStress);
        const auto frame = chain.after(2.0);
        compareWithin(frame->linkMargin[0], 2.0 * g / 0.05 / 600.0, 1e-3);
        compareWithin(frame->probe[0], 2.0 * g / 0.05, 1e-3);
        QCOMPARE(frame->worstNow.all()[0].kind, LoadKind::Thread);
    }

    // Each panel of a tensile strip bears W / b, whatever the mesh.
    void clothOfAStrip_data()
    {
        QTest::addColumn<double>("grain");
        QTest::addColumn<int>("along");
        for (const int along : {4, 8, 16})
            for (const double grain : {0.0, 90.0})
                QTest::addRow("%d cells, %s", along, grain == 0.0 ? "warp" : "weft")
                    << grain << along;
    }

    void clothOfAStrip()
    {
        QFETCH(double, grain);
        QFETCH(int, along);
        Strip made = strip({.across = along / 2, .along = along}, grain, 40.0);
        for (const Quantity quantity :
             {Quantity::FabricStress, Quantity::MeanStress, Quantity::WarpStress,
              Quantity::WeftStress, Quantity::WrinkledShare, Quantity::BendingMoment})
            addProbe(made.scene, quantity);
        made.cloth().warpStrength = 400.0;
        made.cloth().weftStrength = 250.0;
        made.cloth().jointEfficiency = 0.8;
        Simulation simulation(*compile(made.scene));
        QVERIFY(simulation.runUntil(5.0));
        const auto frame = simulation.frame();
        const double bears = 0.8 * (grain == 0.0 ? 400.0 : 250.0);
        QVERIFY(!frame->panelMargin.empty());
        for (const double margin : frame->panelMargin)
            compareWithin(margin, 40.0 / width / bears, 0.01);
        QCOMPARE(frame->worstNow.all()[0].kind, LoadKind::Cloth);

        const std::vector<double>& read = frame->probe;
        compareWithin(read[0], 40.0 / width, 0.01);
        compareWithin(read[1], 40.0 / width, 0.01);
        compareWithin(grain == 0.0 ? read[2] : read[3], 40.0 / width, 0.01);
        QVERIFY(std::abs(grain == 0.0 ? read[3] : read[2]) < 0.01 * 40.0 / width);
        QVERIFY(std::isnan(read[5])); // there is no spar
    }

    // The moment of a cantilever at its clamp is that of the weights on it, F L of a load at its
    // end, on every mesh.
    void momentOfACantilever_data()
    {
        QTest::addColumn<int>("links");
        QTest::addRow("5 links") << 5;
        QTest::addRow("10 links") << 10;
        QTest::addRow("20 links") << 20;
    }

    void momentOfACantilever()
    {
        QFETCH(int, links);
        constexpr double reach = 1.0; // m
        constexpr double load = 0.5;  // kg
        Material spar;
        spar.axialStiffness = 1e5;
        spar.dampingTime = 0.01;
        spar.flexuralRigidity = 50.0;
        spar.breakingMoment = 12.0;
        std::vector<Vec3> places;
        for (int i = -1; i <= links; ++i)
            places.push_back({reach * i / links, 0.0, 0.0});
        Chain chain(places, 2, 1e-3, spar);
        chain.row().particles.back().mass = load;
        addProbe(chain.scene, Quantity::BendingMoment);
        const auto frame = chain.after(3.0);
        double moment = 0.0;
        for (const Particle& particle : chain.row().particles)
            moment += particle.pinned ? 0.0 : particle.mass * g * particle.position.x();
        const LoadedPlace& worst = frame->worstNow.all()[0];
        QCOMPARE(worst.kind, LoadKind::Spar);
        compareWithin(worst.load, moment, 0.01); // it sags by 3 %, which takes 0.1 % of its reach
        compareWithin(worst.margin(), moment / 12.0, 0.01);
        QCOMPARE(frame->probe[0], worst.load);
        QVERIFY(worst.place.norm() < 1e-9); // the clamp
        compareWithin(frame->linkMargin[0], worst.margin(), 1e-12);
        compareWithin(frame->linkMargin[1], worst.margin(), 1e-12);
    }

    // A line of many links is one place, that where it bears most: at the top, where all hangs. One
    // that forks is three.
    void lineOfManyLinksIsOnePlace()
    {
        std::vector<Vec3> places;
        for (int i = 0; i <= 20; ++i)
            places.push_back({0.0, -0.1 * i, 0.0});
        Chain chain(places, 1, 0.1, line(100.0));
        const auto frame = chain.after(2.0);
        QCOMPARE(frame->worstNow.all().size(), 1u);
        QCOMPARE(frame->worstNow.all()[0].element, std::uint32_t(chain.row().links[0].id));
        compareWithin(frame->worstNow.all()[0].load, 20 * 0.1 * g, 1e-3);
        QCOMPARE(frame->worstOfRun.all().size(), 1u);

        Part& part = chain.row();
        part.particles.push_back(
            {.id = takeId(chain.scene), .position = {0.1, -1.0, 0.0}, .mass = 0.1});
        Link branch = part.links.front();
        branch.id = takeId(chain.scene);
        branch.from = part.particles[10].id;
        branch.to = part.particles.back().id;
        part.links.push_back(branch);
        QCOMPARE(chain.after(2.0)->worstNow.all().size(), 3u);
    }

    // What pushes is not judged.
    void strutBearsNothing()
    {
        const Chain chain({Vec3(0, 0, 0), Vec3(0, 1, 0)}, 1, 2.0, line(100.0));
        const auto frame = chain.after(1.0);
        QVERIFY(frame->tension[0] < -0.9 * 2.0 * g);
        QCOMPARE(frame->linkMargin[0], 0.0);
        QVERIFY(frame->worstNow.all().empty());
        QVERIFY(hasMargins(*frame));
    }

    void withoutStrengthThereIsNone()
    {
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, line({}));
        Probe probe;
        probe.quantity = Quantity::Margin;
        chain.scene.items.push_back({takeId(chain.scene), probe});
        const auto bare = chain.after(0.5);
        QVERIFY(!hasMargins(*bare));
        QVERIFY(bare->worstNow.all().empty() && bare->worstOfRun.all().empty());
        QVERIFY(std::isnan(bare->probe[0]));
        chain.stuff().warpStrength = 400.0; // which is of cloth, and there is none
        QVERIFY(!hasMargins(*chain.after(0.5)));
        chain.stuff().lineStrength = 40.0;
        const auto strong = chain.after(2.0);
        compareWithin(strong->probe[0], 2.0 * g / 40.0, 1e-3);
    }

    // The list finds the largest of the margins of all panels, however cloth is strained: taut,
    // wrinkled and slack, with any ratio of warp to weft.
    void listFindsTheWorstPanel()
    {
        std::minstd_rand random(7);
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution(low, high)(random);
        };
        for (int i = 0; i < 300; ++i) {
            Strip made = strip({}, between(0.0, 180.0), 1.0);
            made.cloth().weftStiffness = stiffness * between(0.3, 3.0);
            made.cloth().poissonRatio = between(0.0, 0.4);
            made.cloth().warpStrength = between(100.0, 1000.0);
            if (i % 3 > 0)
                made.cloth().weftStrength = between(100.0, 1000.0);
            Simulation simulation(*compile(made.scene));
            State state = simulation.state();
            const double size = std::pow(10.0, between(-5.0, -2.0)); // m
            for (Vec3& place : state.position)
                place += Vec3(between(-size, size), between(-size, size), between(-size, size));
            simulation.place(state);
            const auto frame = simulation.frame();
            double most = 0.0;
            for (const double margin : frame->panelMargin)
                most = std::max(most, margin);
            QVERIFY(most > 0.0);
            QCOMPARE(frame->worstNow.all()[0].margin(), most);
        }
    }

    // A margin against a strength that is no more tells nothing: a place is judged anew with its
    // strength, with the joints and with the safety factor, and stays with other edits, also with
    // those that bring other materials, as an import does. The list names what the scene has.
    void listFollowsEdits()
    {
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, line(100.0));
        Part& part = chain.row();
        part.particles.push_back(
            {.id = takeId(chain.scene), .position = {1, 0, 0}, .pinned = true});
        part.particles.push_back({.id = takeId(chain.scene), .position = {1, -1, 0}, .mass = 1.0});
        Link other = part.links.front();
        other.id = takeId(chain.scene);
        other.from = part.particles[2].id;
        other.to = part.particles[3].id;
        part.links.push_back(other);
        const Id first = part.links.front().id;

        LiveSystem live(chain.scene);
        const auto take = [&] { return std::get<Update>(live.update(2, 1)); };
        Simulation simulation(take().system);
        const auto after = [&](const Edit& edit) {
            live.apply(edit);
            simulation.load(take());
            if (!simulation.step())
                qFatal("It stopped.");
            return simulation.frame()->worstOfRun;
        };
        const auto setting = [&](Kind kind, const char* key, Id id, double value) {
            return Edit{Message("Edit"),
                        {SetValues{findProperty(kind, key), {id}, {Value(value)}}}};
        };
        QVERIFY(simulation.runUntil(2.0));
        const WorstPlaces before = simulation.frame()->worstOfRun;
        QCOMPARE(before.all().size(), 2u);
        const double end = simulation.state().time;
        QVERIFY(before.all()[0].time < end);

        WorstPlaces now = after(setting(Kind::Settings, "airDensity", settingsId, 0.1));
        QCOMPARE(now.all()[0], before.all()[0]);
        const Chain come({Vec3(2, 0, 0), Vec3(2, -1, 0)}, 2, 1.0, line(5.0));
        Scene more = live.scene();
        Entry stuff = come.scene.items[0], row = come.scene.items[1];
        stuff.id = takeId(more);
        row.id = takeId(more);
        Part& rows = std::get<Part>(row.item);
        for (Particle& particle : rows.particles)
            particle.id = takeId(more);
        rows.links[0].id = takeId(more);
        rows.links[0].from = rows.particles[0].id;
        rows.links[0].to = rows.particles[1].id;
        rows.links[0].material = stuff.id;
        now = after({Message("Import"), {AddItem{0, stuff}, AddItem{0, row}}});
        QCOMPARE(now.all()[0], before.all()[0]);
        now = after(setting(Kind::Material, "lineStrength", stuff.id, 6.0));
        QCOMPARE(now.all()[0], before.all()[0]);
        now = after(removal(live.scene(), {other.id}));
        QCOMPARE(now.all().size(), 1u);
        QCOMPARE(now.all()[0].element, std::uint32_t(first));
        now = after(setting(Kind::Material, "lineStrength", chain.material, 400.0));
        QVERIFY(now.all()[0].time > end);
        compareWithin(now.all()[0].strength, 400.0, 1e-12);
        now = after(setting(Kind::Material, "jointEfficiency", chain.material, 0.5));
        compareWithin(now.all()[0].strength, 200.0, 1e-12);
        now = after(setting(Kind::Settings, "safetyFactor", settingsId, 4.0));
        compareWithin(now.all()[0].strength, 50.0, 1e-12);
    }

    // Materials are named that carry something and have no strength of its kind.
    void gapsAreNamed()
    {
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, line(100.0));
        QVERIFY(materialsWithoutStrength(chain.scene).empty());
        chain.stuff().lineStrength.reset();
        QCOMPARE(materialsWithoutStrength(chain.scene), std::vector{chain.material});
        chain.stuff().warpStrength = 400.0; // which a line has no use for
        QCOMPARE(materialsWithoutStrength(chain.scene), std::vector{chain.material});
        chain.stuff().breakingMoment = 12.0;
        QVERIFY(materialsWithoutStrength(chain.scene).empty());
        chain.row().links[0].material = noId;
        QCOMPARE(materialsWithoutStrength(chain.scene), std::vector{noId});

        Strip made = strip({}, 0.0, 1.0);
        QCOMPARE(materialsWithoutStrength(made.scene), std::vector{made.material});
        made.cloth().weftStrength = 300.0;
        QVERIFY(materialsWithoutStrength(made.scene).empty());
    }

    // A strength by which nothing tears is named, too, where something has a use for it.
    void whatNeverTearsIsNamed()
    {
        Strip made = strip({}, 0.0, 1.0);
        QVERIFY(materialsThatNeverTear(made.scene).empty());
        made.cloth().lineStrength = 300.0; // there is no line
        QVERIFY(materialsThatNeverTear(made.scene).empty());
        made.cloth().warpStrength = 300.0;
        QCOMPARE(materialsThatNeverTear(made.scene), std::vector{made.material});
        made.cloth().tearRule = TearRule::Strength;
        QVERIFY(materialsThatNeverTear(made.scene).empty());

        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, line(100.0));
        QCOMPARE(materialsThatNeverTear(chain.scene), std::vector{chain.material});
    }

    // Of the canopies that air opens; until the safety factor is as large as what is missing where
    // the load does not slow down, 1.05 of the steady one instead of 1.7 (Knacke 1991, table 5-1).
    void openingLoadsAreKnownToBeLow()
    {
        QVERIFY(openingSafetyFactor > 1.7 / 1.05);
        Strip made = strip({}, 0.0, 1.0);
        QVERIFY(!understatesOpening(made.scene));
        for (Entry& entry : made.scene.items)
            if (auto* part = std::get_if<Part>(&entry.item))
                part->canopyPressure = 1.68;
        QVERIFY(understatesOpening(made.scene));
        made.scene.settings.safetyFactor = openingSafetyFactor;
        QVERIFY(!understatesOpening(made.scene));
    }

    void worstPlacesAreTheWorst()
    {
        WorstPlaces worst;
        std::map<std::uint32_t, double> most; // of each element
        std::uint32_t random = 1;
        for (int i = 0; i < 2000; ++i) {
            random = 1664525u * random + 1013904223u; // Numerical Recipes
            const std::uint32_t element = 1 + (random >> 16) % 40;
            const double load = double((random >> 8) % 1009);
            most[element] = std::max(most[element], load);
            LoadedPlace place;
            place.element = place.whole = place.material = element;
            place.load = load;
            place.strength = 100.0;
            worst.offer(place);
        }
        std::vector<double> sorted;
        for (const auto& [element, load] : most)
            sorted.push_back(load / 100.0);
        std::ranges::sort(sorted, std::greater());
        QCOMPARE(worst.all().size(), WorstPlaces::most);
        for (std::size_t i = 0; i < WorstPlaces::most; ++i) {
            QCOMPARE(worst.all()[i].margin(), sorted[i]);
            QCOMPARE(worst.all()[i].load, most[worst.all()[i].element]);
        }
    }

    // Of 24 lines that bear alike three stand in the list, and of panels around a point the worst,
    // in whatever order they are offered.
    void noPlaceFillsTheList()
    {
        std::vector<LoadedPlace> places;
        for (std::uint32_t i = 0; i < 24; ++i) {
            LoadedPlace line;
            line.element = line.whole = 100 + i;
            line.material = 1;
            line.load = 50.0 + i;
            line.strength = 100.0;
            places.push_back(line);
        }
        for (std::uint32_t i = 0; i < 6; ++i) { // a fan around particle 500, and one further off
            LoadedPlace panel;
            panel.element = panel.whole = 200 + i;
            panel.material = 2;
            panel.kind = LoadKind::Cloth;
            panel.corners =
                i < 5 ? std::array{500u, 501u + i, 502u + i} : std::array{600u, 601u, 602u};
            panel.load = 90.0 - i;
            panel.strength = 100.0;
            places.push_back(panel);
        }
        std::minstd_rand random(3);
        for (int i = 0; i < 50; ++i) {
            std::ranges::shuffle(places, random);
            WorstPlaces worst;
            for (const LoadedPlace& place : places)
                worst.offer(place);
            QStringList elements;
            for (const LoadedPlace& place : worst.all())
                elements << QString::number(place.element);
            QCOMPARE(elements.join(' '), QStringLiteral("200 205 123 122 121"));
        }
    }
};

const RegisteredTest registered("test_margins", runPlain<TestMargins>);

} // namespace ripstop::test_margins
#include "test_margins.moc"
