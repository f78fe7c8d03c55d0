// Tearing: what the cases (verify/tearing.cpp) do not ask.
//
// Stages: what breaks at a limit, what goes with it, and that a broken rod holds nothing; then how
// many break in one step, and how overloads of different rules are compared; how long a link at an
// opening waits; and at last links that are pressed or have no length.
#include "assembly/carry_over.h"
#include "assembly/finish.h"
#include "assembly/split_system.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"
#include "tearing/tear_opening.h"
#include "tearing/tearing.h"
#include "verify/tear_sheets.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_tearing {

namespace {

// A link of 0.5 m between a pin and a hand that draws away at a steady speed.
System pulled(LinkKind kind, const TearLimit& tear, double speed, double timeStep)
{
    System system = emptySystem(timeStep);
    addPin(system, Vec3::Zero());
    addPin(system, {0.5, 0.0, 0.0});
    if (kind == LinkKind::Spring)
        addSpring(system, 0, 1, 0.5, 100.0).tear = tear;
    else
        addRod(system, 0, 1, 0.5).tear = tear;
    system.inputs.push_back({Key(7), ControlKind::Move, {1.0, 0.0, 0.0}, 100.0, 100.0, speed, {1}});
    finish(system);
    return system;
}

// The time step at whose end the first link is torn.
int firstTornStep(const System& system, int most)
{
    Stepper stepper;
    State state = system.start;
    for (int step = 1; step <= most; ++step) {
        stepper.step(system, state);
        if (!state.tears.empty())
            return step;
    }
    return -1;
}

// 3 x 3 particles, 0.1 m apart, eight panels, springs along their edges; link 0 may tear.
System torn3x3(const TearLimit& tear)
{
    System system = emptySystem(1.0 / 240.0);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            addParticle(system, {0.1 * i, 0.0, 0.1 * j}, 0.01 + 0.001 * i + 0.002 * j,
                        {0.0, 0.1 * i * j, 0.0});
    const auto tie = [&](int a, int b) {
        addSpring(system, a, b, 0.8 * distance(system, a, b), 50.0);
    };
    tie(4, 5); // from the middle to the right
    for (const auto& [a, b] : {std::pair(0, 1),
                               {1, 2},
                               {3, 4},
                               {6, 7},
                               {7, 8},
                               {0, 3},
                               {3, 6},
                               {1, 4},
                               {4, 7},
                               {2, 5},
                               {5, 8},
                               {1, 5},
                               {0, 4},
                               {3, 7},
                               {4, 8}})
        tie(a, b);
    for (const int corner : {0, 1, 3, 4}) {
        addPanel(system, corner, corner + 3, corner + 4, AirLaw::LinearNormal, 2.0);
        addPanel(system, corner, corner + 4, corner + 1, AirLaw::LinearNormal, 2.0);
    }
    system.springs[0].tear = tear;
    finish(system);
    return system;
}

} // namespace

class TestTearing : public QObject
{
    Q_OBJECT

private slots:
    // The rule is >, not >=: at the limit itself a link holds. 0.25 m/s at dt = 1/8 makes steps of
    // 1/32 m, which are exact in binary; the limit of 0.75 m is met at step 8.
    void atTheLimit_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::newRow("T1 spring") << LinkKind::Spring;
        QTest::newRow("T1 rod") << LinkKind::Rod;
    }
    void atTheLimit()
    {
        QFETCH(LinkKind, kind);
        const System length = pulled(kind, {TearRule::Length, 0.75}, 0.25, 0.125);
        QCOMPARE(run(length, 8).position[1].x(), 0.75);
        QCOMPARE(firstTornStep(length, 20), 9);
        QCOMPARE(firstTornStep(pulled(kind, {TearRule::Strain, 0.5}, 0.25, 0.125), 20), 9);
        if (kind == LinkKind::Spring)
            QCOMPARE(firstTornStep(pulled(kind, {TearRule::Force, 25.0}, 0.25, 0.125), 20), 9);
    }

    // T3: one spring goes, the two panels beside it with it, and nothing else; momentum stays.
    void bookkeeping()
    {
        System system = torn3x3({TearRule::Strain, 0.1});
        system.airDensity = 0.0;
        Stepper stepper;
        State state = system.start;
        const Vec3 before = momentum(system, state);
        const double area = fabricArea(system, state);
        stepper.step(system, state);

        QCOMPARE(state.tears.size(), std::size_t(1));
        QCOMPARE(state.tears[0].element, system.links[0].key);
        QCOMPARE(std::count(state.springTorn.begin(), state.springTorn.end(), 1), 1);
        QCOMPARE(std::count(state.panelGone.begin(), state.panelGone.end(), 1), 2);
        for (std::size_t p = 0; p < system.panels.size(); ++p) {
            const auto& corner = system.panels[p].corner;
            const bool beside = std::count(corner.begin(), corner.end(), 4)
                                && std::count(corner.begin(), corner.end(), 5);
            QCOMPARE(bool(state.panelGone[p]), beside);
        }
        QVERIFY2(isNear(momentum(system, state), before, 1e-15),
                 told(momentum(system, state), before));
        State flat = system.start;
        flat.panelGone = state.panelGone;
        QVERIFY2(isNear(fabricArea(system, flat), 0.75 * area, 1e-12 * area),
                 told(fabricArea(system, flat), 0.75 * area));

        // the two halves go their ways: torn stays torn, no air on what is gone, no event twice
        system.airDensity = 1.225;
        system.wind = {1.0, 2.0, 3.0};
        for (int i = 0; i < 500; ++i)
            stepper.step(system, state);
        QCOMPARE(state.tears.size(), std::size_t(1));
        QCOMPARE(tensions(system, state)[0], 0.0);
        QCOMPARE(strains(system, state)[0], 0.0);
        for (std::size_t p = 0; p < system.panels.size(); ++p)
            QCOMPARE(panelLoads(system, state)[p].isZero(0.0), bool(state.panelGone[p]));
        for (const Vec3& x : state.position)
            QVERIFY(x.allFinite());
    }

    // 2 kg on a rod of 1 m.
    void brokenRodLetsGo_data()
    {
        QTest::addColumn<TearRule>("rule");
        QTest::addColumn<bool>("breaks");
        QTest::newRow("a limit of 19 N below 19.61") << TearRule::Force << true;
        QTest::newRow("no limit") << TearRule::Never << false;
    }

    void brokenRodLetsGo()
    {
        QFETCH(TearRule, rule);
        QFETCH(bool, breaks);
        System system = emptySystem(1.0 / 240.0);
        system.gravity = {0.0, -standardGravity, 0.0};
        addPin(system, Vec3::Zero());
        addParticle(system, {0.0, -1.0, 0.0}, 2.0);
        addRod(system, 0, 1, 1.0).tear = {rule, 19.0};
        finish(system);
        const State state = run(system, 240);
        QCOMPARE(state.tears.size(), std::size_t(breaks ? 1 : 0));
        QCOMPARE(state.position[1].y() < -1.5, breaks);
        QCOMPARE(state.rodTension[0] == 0.0, breaks);
    }

    // Twenty links in a row that are all far above their limit at once part at one place, the
    // weakest; the load of a kilogram falls with what is below it.
    void aLinePartsAtOnePlace()
    {
        System system = emptySystem(1.0 / 240.0);
        system.gravity = {0.0, -standardGravity, 0.0};
        addPin(system, Vec3::Zero());
        for (int i = 1; i <= 20; ++i) {
            addParticle(system, {0.0, -0.1 * i, 0.0}, i == 20 ? 1.0 : 1e-4);
            addRod(system, i - 1, i, 0.1).tear = {TearRule::Force, i == 7 ? 1.0 : 2.0};
        }
        finish(system);
        const State state = run(system, 240);
        QCOMPARE(state.tears.size(), std::size_t(1));
        QCOMPARE(state.tears[0].element, system.links[6].key);
        QVERIFY(state.position[7].y() < -4.0);
        QVERIFY(state.position[6].y() > -0.61);
    }

    // A line that stretches holds its load for as long as a pull takes to run along it, and is
    // drawn on from both ends meanwhile: what is left of it parts no more.
    void whatIsLeftOfALineIsLetBe()
    {
        System system = emptySystem(1e-3);
        system.substeps = 20;
        addPin(system, Vec3::Zero());
        constexpr int links = 20;
        for (int i = 1; i <= links; ++i) {
            const Vec3 place(0.1 * i, 0.0, 0.0);
            i == links ? addPin(system, place) : addParticle(system, place, 1e-3);
            addRod(system, i - 1, i, 0.1, 1e-5).tear = {TearRule::Force, 100.0};
        }
        for (const auto& [end, way] : {std::pair(0, -1.0), std::pair(links, 1.0)})
            system.inputs.push_back(
                {Key(end + 7), ControlKind::Move, {way, 0.0, 0.0}, 100.0, 100.0, 0.5, {end}});
        finish(system);
        QCOMPARE(run(system, 50).tears.size(), std::size_t(1)); // drawn by 50 mm, breaks at 20
    }

    // The other line of what hangs by two bears all of it when one has parted, a moment later.
    void theOtherLineBreaksAfterwards()
    {
        System system = emptySystem(1e-3);
        system.gravity = {0.0, -standardGravity, 0.0};
        system.substeps = 4;
        addPin(system, {-0.5, 0.0, 0.0});
        addPin(system, {0.5, 0.0, 0.0});
        addParticle(system, {0.0, -1.0, 0.0}, 10.0);
        for (const int pin : {0, 1}) {
            const TearLimit limit{TearRule::Force, pin == 0 ? 50.0 : 60.0};
            addRod(system, pin, 2, std::sqrt(1.25), 1e-5).tear = limit;
        }
        finish(system);
        QCOMPARE(run(system, 500).tears.size(), std::size_t(2));
    }

    void mostPerStep_data()
    {
        QTest::addColumn<int>("most");
        QTest::addColumn<std::vector<std::vector<Key>>>("torn"); // in each step
        using Steps = std::vector<std::vector<Key>>;
        QTest::newRow("any number, in the order of the links") << 0 << Steps{{0, 1, 2, 3, 4}, {}};
        QTest::newRow("one, the worst first") << 1 << Steps{{1}, {3}, {2}, {4}, {0}, {}};
        QTest::newRow("two") << 2 << Steps{{1, 3}, {2, 4}, {0}, {}};
        QTest::newRow("more than there are") << 9 << Steps{{1, 3, 2, 4, 0}, {}};
    }

    // Links side by side between two pins, at strains of 0.5, 0.9, 0.7, 0.9, 0.6 and a limit of
    // 0.4, and one below it. The two that are alike break in the order of the links.
    void mostPerStep()
    {
        QFETCH(int, most);
        QFETCH(std::vector<std::vector<Key>>, torn);
        System system = emptySystem(0.01);
        system.substeps = 3;
        system.tearsPerStep = most;
        addPin(system, Vec3::Zero());
        addPin(system, {1.0, 0.0, 0.0});
        for (const double strain : {0.5, 0.9, 0.7, 0.9, 0.6, 0.3})
            addSpring(system, 0, 1, 1.0 / (1.0 + strain), 10.0).tear = {TearRule::Strain, 0.4};
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (const std::vector<Key>& expected : torn) {
            const std::size_t before = state.tears.size();
            stepper.step(system, state);
            std::vector<Key> now;
            for (std::size_t i = before; i < state.tears.size(); ++i)
                now.push_back(state.tears[i].element);
            QVERIFY(now == expected);
        }
    }

    // Overloads of different rules are compared by how many times the limit they are; above a
    // limit of 0 is infinitely far.
    void rulesCompared()
    {
        System system = emptySystem(0.01);
        system.tearsPerStep = 1;
        addPin(system, Vec3::Zero());
        addPin(system, {1.0, 0.0, 0.0});
        addSpring(system, 0, 1, 0.5, 10.0).tear = {TearRule::Length, 0.8}; // 1.25 times
        addSpring(system, 0, 1, 0.5, 10.0).tear = {TearRule::Force, 2.5};  // 2 times
        addSpring(system, 0, 1, 0.5, 10.0).tear = {TearRule::Strain, 0.0}; // infinitely
        addRod(system, 0, 1, 0.5).tear = {TearRule::Strain, 2.0 / 3.0};    // 1.5 times
        finish(system);
        const State state = run(system, 5);
        std::vector<Key> order;
        for (const State::Tear& tear : state.tears)
            order.push_back(tear.element);
        QVERIFY(order == (std::vector<Key>{2, 1, 3, 0}));
    }

    // A link at an opening that stays as long waits while its overload is less than a quarter above
    // what has faded of the one that opened it: by 1/e in sqrt((m + m') / k) and the damping time.
    // One without stiffness waits as long as it is that long.
    void waitsForItsLoadToGo_data()
    {
        QTest::addColumn<double>("stiffness");
        QTest::newRow("it pulls") << 1000.0;
        QTest::newRow("it never pulls") << 0.0;
    }

    void waitsForItsLoadToGo()
    {
        QFETCH(double, stiffness);
        constexpr int weak = 1, columns = 4;
        System system = tearSheet(columns, 4, weak, LinkKind::Spring);
        system.timeStep = 1e-4;
        for (Spring& spring : system.springs)
            if (spring.tear.rule != TearRule::Never) {
                spring.stiffness = stiffness;
                spring.damping *= stiffness; // of 0 neither
            }
        State state = system.start;
        for (std::size_t i = (weak + 1) * (columns + 1); i < state.position.size(); ++i)
            state.position[i].z() += 0.02;
        TearScratch scratch;
        std::vector<PaddedVec3> force(system.springs.size(), PaddedVec3(Vec3::Zero()));
        tearOverloaded(system, state, {{}, force, {}}, scratch);
        QVERIFY(openTears(system, state));
        const auto parted = splitSystem(system, state.splits, {});
        State drawn = carryOver(system, state, *parted); // a hand keeps it as it is
        QVERIFY(!drawn.tearHolds.empty());
        double soonest = 1e9; // s
        for (const TearHold& hold : drawn.tearHolds) {
            const LinkPlace& link = parted->links[std::size_t(hold.link)];
            const Spring& spring = parted->springs[std::size_t(link.index)];
            const double mass =
                parted->mass[std::size_t(link.a)] + parted->mass[std::size_t(link.b)];
            if (spring.tear.rule != TearRule::Never)
                soonest = std::min(soonest, std::sqrt(mass / spring.stiffness)
                                                + spring.damping / spring.stiffness);
        }
        const std::size_t before = drawn.tears.size();
        force.assign(parted->springs.size(), PaddedVec3(Vec3::Zero()));
        int steps = 0;
        for (; drawn.tears.size() == before && steps < 1000; ++steps)
            tearOverloaded(*parted, drawn, {{}, force, {}}, scratch);
        QVERIFY(drawn.tearHolds == State(drawn).tearHolds); // all are numbers
        if (stiffness == 0.0) {
            QCOMPARE(drawn.tears.size(), before);
            return;
        }
        const double waited = (steps - 1) * system.timeStep, expected = soonest * std::log(1.25);
        QVERIFY2(waited >= expected && waited < expected + 2.0 * system.timeStep,
                 told(waited, expected));
    }

    // A strut that is pressed short is not torn, and a link without rest length has no strain.
    void notInTension()
    {
        System system = emptySystem(0.01);
        addPin(system, Vec3::Zero());
        addPin(system, {0.5, 0.0, 0.0});
        addSpring(system, 0, 1, 1.0, 100.0).tear = {TearRule::Force, 10.0};
        addSpring(system, 0, 1, 1.0, 100.0).tear = {TearRule::Strain, 0.2};
        addSpring(system, 0, 1, 0.0, 100.0).tear = {TearRule::Strain, 0.2};
        addPin(system, {0.5, 0.0, 0.0});
        addSpring(system, 1, 2, 0.0, 100.0).tear = {TearRule::Force, 0.0}; // coincident
        finish(system);
        QVERIFY(run(system, 10).tears.empty());
    }
};

const RegisteredTest registered("test_tearing", runPlain<TestTearing>);

} // namespace ripstop::test_tearing
#include "test_tearing.moc"
