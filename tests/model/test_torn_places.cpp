// What tore by its strength stays in the list of the worst places of the run, as torn and with what
// it bore then: at least its strength.
#include "model/chain.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_torn_places {

class TestTornPlaces : public QObject
{
    Q_OBJECT

private slots:
    // A margin of 1, or of the safety factor, is the least; afterwards the line bears nothing.
    void tornLineIsListed_data()
    {
        QTest::addColumn<double>("safety");
        QTest::newRow("as it is") << 1.0;
        QTest::newRow("twice as safe") << 2.0;
    }

    void tornLineIsListed()
    {
        QFETCH(double, safety);
        Material made = line(12.0);
        made.tearRule = TearRule::Strength;
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, made);
        chain.scene.settings.safetyFactor = safety;
        const auto frame = chain.after(1.0);
        QCOMPARE(frame->tears.size(), 1u);
        const LoadedPlace& worst = frame->worstOfRun.all()[0];
        QVERIFY(worst.torn);
        QCOMPARE(worst.element, std::uint32_t(chain.row().links[0].id));
        QVERIFY(worst.margin() >= safety);
        // let go at rest it bears twice the weight at most
        QVERIFY(worst.load < 2.0 * 2.0 * standardGravity);
        QCOMPARE(worst.time, frame->tears[0].time);
        QVERIFY(frame->worstNow.all().empty());
    }

    void tornClothIsListed_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("warp") << 0.0;
        QTest::newRow("weft") << 90.0;
    }

    void tornClothIsListed()
    {
        QFETCH(double, grain);
        Strip made = strip({}, grain, 40.0); // 200 N/m
        made.cloth().warpStrength = 150.0;
        made.cloth().weftStrength = 100.0;
        made.cloth().tearRule = TearRule::Strength;
        made.scene.settings.safetyFactor = 1.5;
        Simulation simulation(*compile(made.scene));
        QVERIFY(simulation.runUntil(1.0));
        const auto frame = simulation.frame();
        QVERIFY(!frame->tears.empty());
        const LoadedPlace& worst = frame->worstOfRun.all()[0];
        QVERIFY(worst.torn);
        QCOMPARE(worst.kind, LoadKind::Cloth);
        const double bears = (grain == 0.0 ? 150.0 : 100.0) / 1.5;
        QVERIFY2(isNear(worst.strength, bears, 1e-12 * bears), told(worst.strength, bears));
        QVERIFY(worst.margin() >= 1.5);
    }

    // Of one material the worst list has three places; those that broke first are all told, in
    // their order, each with what it could bear.
    void whatBrokeFirstIsListed()
    {
        constexpr double bears = 100.0; // N/m
        Strip made = strip({}, 0.0, 40.0);
        made.cloth().warpStrength = made.cloth().weftStrength = bears;
        made.cloth().tearRule = TearRule::Strength;
        Simulation simulation(*compile(made.scene));
        QVERIFY(simulation.runUntil(1.0));
        const auto frame = simulation.frame();
        const auto broken = frame->firstBreaks.all();
        QVERIFY(frame->tears.size() > WorstPlaces::mostAlike);
        QCOMPARE(broken.size(), std::min(frame->tears.size(), FirstBreaks::most));
        for (std::size_t i = 0; i < broken.size(); ++i) {
            QCOMPARE(broken[i].element, std::uint32_t(frame->tears[i].element));
            QCOMPARE(broken[i].time, frame->tears[i].time);
            QCOMPARE(broken[i].load, frame->tears[i].force);
            QCOMPARE(broken[i].kind, LoadKind::Cloth);
            QCOMPARE(broken[i].strength, bears);
            QVERIFY(broken[i].torn && broken[i].margin() >= 1.0);
        }
    }

    // A rule of strain knows no strength: what broke by it is told, and no margin.
    void whatHasNoStrengthIsListedToo()
    {
        Material made = line(12.0);
        made.lineStrength.reset();
        made.tearRule = TearRule::Strain;
        made.tearLimit = 0.001; // at 10 N, beside what its damping takes
        Chain chain({Vec3(0, 0, 0), Vec3(0, -1, 0)}, 1, 2.0, made);
        const auto frame = chain.after(1.0);
        QCOMPARE(frame->tears.size(), 1u);
        QVERIFY(frame->worstOfRun.all().empty());
        QCOMPARE(frame->firstBreaks.all().size(), 1u);
        const LoadedPlace& first = frame->firstBreaks.all()[0];
        QCOMPARE(first.element, std::uint32_t(chain.row().links[0].id));
        QCOMPARE(first.kind, LoadKind::Line);
        QVERIFY(first.load >= 10.0);
        QCOMPARE(first.strength, 0.0);
    }

    void snappedSparIsListed()
    {
        Material spar;
        spar.axialStiffness = 1e5;
        spar.dampingTime = 0.01;
        spar.flexuralRigidity = 50.0;
        spar.breakingMoment = 3.0; // the load asks for 4.9
        spar.tearRule = TearRule::Strength;
        Chain chain(
            {Vec3(-0.2, 0, 0), Vec3(0, 0, 0), Vec3(0.2, 0, 0), Vec3(0.6, 0, 0), Vec3(1, 0, 0)}, 2,
            1e-3, spar);
        chain.row().particles.back().mass = 0.5;
        const auto frame = chain.after(1.0);
        QCOMPARE(frame->tears.size(), 1u);
        const LoadedPlace& worst = frame->worstOfRun.all()[0];
        QVERIFY(worst.torn);
        QCOMPARE(worst.kind, LoadKind::Spar);
        QCOMPARE(worst.load, frame->tears[0].force);
        QVERIFY(worst.margin() >= 1.0);
    }
};

const RegisteredTest registered("test_torn_places", runPlain<TestTornPlaces>);

} // namespace ripstop::test_torn_places
#include "test_torn_places.moc"
