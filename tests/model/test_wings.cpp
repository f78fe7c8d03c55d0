// Wings with the vortex law: how they are cut into strips, tears, edges. What the law gives is in
// the cases of ripstop-cli verify.
//
// Stages: how panels become strips, where the nose is, and what tears take away; then the vortex
// lattice of the tests (vortex_lattice.h) is held against print and against the cases; then shapes
// that are no wings, and a glider that starts in trim and flies straight.
#include "assembly/finish.h"
#include "builders/builder.h"
#include "builders/statics.h"
#include "compile/compile.h"
#include "laws/vortex_wing.h"
#include "measure/diagnostics.h"
#include "measure/polar.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "verify/case.h"
#include "verify/small_systems.h"
#include "vortex_lattice.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_wings {

namespace {

Scene glider(std::map<std::string, double> more = {})
{
    more["vortex"] = 1.0;
    return *build(*findBuilder("hang_glider"), more);
}

std::shared_ptr<const System> compiled(const Scene& scene)
{
    const auto system = compile(scene);
    return system ? *system : nullptr;
}

MaterialAir wingAir()
{
    MaterialAir air;
    air.normalCoefficient = 1.0; // when stalled: less than a wing has
    air.stall = 0.25;
    return air;
}

// The lattice of a delta in the plane y = 0, nose to -x.
System delta(int rows)
{
    System system = emptySystem(0.01);
    const auto at = [](int row, int column) { return row * (row + 1) / 2 + column; };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= row; ++column)
            addParticle(system, {double(row), 0.0, column - 0.5 * row}, 1.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column <= row; ++column) {
            addPanel(system, at(row, column), at(row + 1, column), at(row + 1, column + 1),
                     wingAir());
            if (column < row) // the other way round, which must not matter
                addPanel(system, at(row, column), at(row, column + 1), at(row + 1, column + 1),
                         wingAir());
        }
    return system;
}

FlatWing rectangle(double aspect) // chord 1 m
{
    return {[](double) { return 0.0; }, [](double) { return 1.0; }, cosineStrips(aspect, 32), 8};
}

FlatWing triangle(double aspect) // keel 1 m, nose to the wind
{
    const double tip = 0.25 * aspect;
    return {[=](double y) { return std::abs(y) / tip; }, [](double) { return 1.0; },
            cosineStrips(2.0 * tip, 24), 12};
}

Vec3 sum(const std::vector<Vec3>& loads)
{
    Vec3 total = Vec3::Zero();
    for (const Vec3& load : loads)
        total += load;
    return total;
}

} // namespace

class TestWings : public QObject
{
    Q_OBJECT

private slots:
    void stripsShareThePanels_data()
    {
        QTest::addColumn<int>("rows");
        for (const int rows : {3, 4, 8, 14})
            QTest::newRow(qPrintable(QString("delta of %1 segments").arg(rows))) << rows;
    }

    void stripsShareThePanels()
    {
        QFETCH(int, rows);
        System system = delta(rows);
        system.wind = {10.0, 1.0, 0.0};
        finish(system);
        QCOMPARE(system.of<FabricLists>().wings.size(), std::size_t(1));
        const WingStrips& wing = system.of<FabricLists>().wings.front();
        QCOMPARE(wing.panels.size(), std::size_t(rows * rows));
        std::vector<double> area(wing.panels.size(), 0.0);
        std::array<double, wingStrips> wash{}, load{}, place{};
        for (const StripPart& part : wing.parts) {
            const auto corner = system.panels[std::size_t(part.panel)].corner;
            double x = 0.0;
            for (const int i : corner)
                x += system.start.position[std::size_t(i)].x() / 3.0;
            area[std::size_t(part.panel)] += part.area;
            wash[std::size_t(part.strip)] += part.wash;
            load[std::size_t(part.strip)] += part.load;
            place[std::size_t(part.strip)] += part.load * x;
        }
        for (const double share : area)
            QVERIFY(std::abs(share - 1.0) < 1e-9);
        for (int strip = 0; strip < wingStrips; ++strip) {
            const std::size_t s = std::size_t(strip);
            QVERIFY(std::abs(wash[s] - 1.0) < 1e-9);
            QVERIFY(std::abs(load[s] - 1.0) < 1e-9);
            // the leading edge of a delta runs from the nose to the tips; a quarter of the chord
            const double out = std::abs(std::cos(M_PI * (strip + 0.5) / wingStrips));
            QVERIFY(std::abs(place[s] - rows * (out + 0.25 * (1.0 - out))) < 1e-6 * rows);
        }
    }

    // Without wind the shape says where the front is.
    void calmAirFindsTheNose()
    {
        System windy = delta(8);
        windy.wind = {10.0, 1.0, 0.0};
        finish(windy);
        System calm = delta(8);
        for (PaddedVec3& place : calm.start.position) // wider than long
            place.z() *= 1.5;
        for (PaddedVec3& place : windy.start.position)
            place.z() *= 1.5;
        finish(calm);
        finish(windy);
        calm.wind = windy.wind;
        const Vec3 one = sum(panelLoads(windy, windy.start));
        const Vec3 other = sum(panelLoads(calm, calm.start));
        QVERIFY(one.y() > 0.0);
        QVERIFY((one - other).norm() < 1e-9 * one.norm());
    }

    void tornPanelsStallTheirStrips()
    {
        System system = delta(8);
        system.wind = {10.0, 1.0, 0.0};
        finish(system);
        State state = system.start;
        const double whole = sum(panelLoads(system, state)).y();
        state.panelGone[20] = 1;
        const std::vector<Vec3> loads = panelLoads(system, state);
        QCOMPARE(loads[20], Vec3(Vec3::Zero()));
        const double torn = sum(loads).y();
        QVERIFY(torn > 0.3 * whole && torn < whole);
        std::fill(state.panelGone.begin(), state.panelGone.end(), std::uint8_t(1));
        QCOMPARE(sum(panelLoads(system, state)), Vec3(Vec3::Zero()));
    }

    // The lattice itself, by an example that is solved in print (Bertin and Smith, 2nd ed., example
    // 7.2: aspect ratio 5, swept by 45 degrees, one row of eight cells: 1.096 pi)
    void latticeOfTheBook()
    {
        const auto sweep = [](double y) { return std::abs(y); };
        const FlatWing wing{sweep, [=](double y) { return sweep(y) + 1.0; }, evenStrips(5.0, 8), 1};
        QVERIFY(std::abs(latticeAnswer(wing).slope / (1.096 * M_PI) - 1.0) < 1e-3);
    }

    // The lattice also meets the limit of slender wings, pi A / 2 (Jones 1946, NACA TR 835).
    void latticeOfSlenderWings()
    {
        const double aspect = 0.02;
        const FlatWingAnswer slender = latticeAnswer(triangle(aspect));
        QVERIFY(std::abs(slender.slope / (0.5 * M_PI * aspect) - 1.0) < 0.02);
        QVERIFY(std::abs(slender.efficiency - 1.0) < 1e-3);
    }

    // What the cases of verify expect of flat wings is what the lattice says.
    void latticeIsBehindTheCases_data()
    {
        QTest::addColumn<QString>("title");
        QTest::addColumn<double>("answer");
        for (const double aspect : {2.0, 4.0, 6.0}) {
            const FlatWingAnswer answer = latticeAnswer(rectangle(aspect));
            const QString wing = QString("rectangular wing of aspect ratio %1, ").arg(aspect);
            QTest::newRow(qPrintable(wing + "slope")) << wing + "lift slope" << answer.slope;
            QTest::newRow(qPrintable(wing + "efficiency"))
                << wing + "span efficiency" << answer.efficiency;
        }
        QTest::newRow("delta") << QString("equilateral delta of 14 segments, lift slope")
                               << latticeAnswer(triangle(4.0 / std::sqrt(3.0))).slope;
    }

    void latticeIsBehindTheCases()
    {
        QFETCH(QString, title);
        QFETCH(double, answer);
        const std::vector<Case> cases = casesWith(title.toStdString());
        QCOMPARE(cases.size(), std::size_t(1));
        QVERIFY2(std::abs(answer / cases.front().expected - 1.0) < 1e-3,
                 qPrintable(QString::number(answer)));
    }

    // Shapes that are no wings: nothing worse than the load of plates comes out.
    void oddShapes()
    {
        System line = emptySystem(0.01);
        for (int i = 0; i < 3; ++i)
            addParticle(line, {double(i), 0.0, 0.0}, 1.0);
        addPanel(line, 0, 1, 2, wingAir());
        line.wind = {5.0, 1.0, 0.0};
        finish(line);
        QVERIFY(line.of<FabricLists>().wings.empty());
        QCOMPARE(sum(panelLoads(line, line.start)), Vec3(Vec3::Zero()));

        for (std::uint32_t seed = 1; seed <= 50; ++seed) {
            Dice dice(seed);
            System odd = emptySystem(0.01);
            for (int i = 0; i < 12; ++i)
                addParticle(odd, dice.vector(1.0), 1.0, dice.vector(5.0));
            for (int i = 0; i < 20; ++i) {
                const int a = dice.below(12);
                addPanel(odd, a, (a + 1 + dice.below(5)) % 12, (a + 6 + dice.below(6)) % 12,
                         wingAir());
            }
            odd.wind = dice.vector(10.0);
            finish(odd);
            const State state = run(odd, 20);
            for (const PaddedVec3& place : state.position)
                QVERIFY(place.allFinite());
            for (const Vec3& load : panelLoads(odd, state))
                QVERIFY(load.allFinite());
        }
    }

    void gliderStartsInTrim()
    {
        const Scene scene = glider();
        const Part* part = nullptr;
        forEachPart(scene, [&](Id, const Part& one) { part = &one; });
        const LumpedMass weight = lumpedMassOf(*part);
        const Load load = airLoad(scene, *part, -part->particles.front().velocity);
        const double pull = weight.mass * 9.80665;
        QVERIFY((load.force - Vec3(0.0, pull, 0.0)).norm() < 1e-6 * pull);
        QVERIFY((load.moment - weight.center.cross(load.force)).norm() < 1e-6 * pull);

        // the engine says the same of this wing
        const auto system = compiled(scene);
        QVERIFY(system);
        const Vec3 engine = sum(panelLoads(*system, system->start));
        QVERIFY((engine - load.force).norm() < 1e-9 * pull);
    }

    // Air and wing are mirror images of themselves; what is left comes from the order of sweeps.
    void gliderFliesStraight()
    {
        Simulation simulation(compiled(glider()));
        QVERIFY(simulation.runUntil(20.0));
        const Vec3 centre = centerOfMass(simulation.system(), simulation.state().position);
        QVERIFY(centre.x() > 200.0);
        QVERIFY2(std::abs(centre.z()) < 0.01 * centre.x(), qPrintable(QString::number(centre.z())));
    }

    void sameBitsOnThreads()
    {
        const auto system = compiled(glider());
        const auto hash = [&](int threads) {
            return stateHash(run(*system, system->start, 60, threads));
        };
        QCOMPARE(hash(2), hash(1));
        QCOMPARE(hash(4), hash(1));
    }

    void polarIsOfAWing()
    {
        const MaterialAir air = wingAir();
        const std::vector<PolarRow> rows = platePolar(air, 2.0);
        const double lift = latticeAnswer(rectangle(2.0)).slope * std::sin(2.0 * M_PI / 180.0);
        QVERIFY(std::abs(rows[1].lift / lift - 1.0) < 0.03);
        QVERIFY(rows[1].drag > 0.0);
        QVERIFY(std::abs(rows.back().normal - air.normalCoefficient) < 1e-9);
    }
};

const RegisteredTest registered("test_wings", runPlain<TestWings>);

} // namespace ripstop::test_wings
#include "test_wings.moc"
