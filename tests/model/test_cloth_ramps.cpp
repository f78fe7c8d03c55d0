// Edits in flight of panels that carry the pull of a fabric: laws and cuts go over within the time
// that the author has set, are those of a cloth all the way, and come to the same bits however they
// come.
#include "builders/builder.h"
#include "builders/network.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "measure/diagnostics.h"
#include "registered_test.h"
#include "simulation/cloth_ramps.h"

#include "edited_flight.h"
#include "first_item.h"
#include "sample_scenes.h"
#include "systems.h"

#include <QtTest>

#include <Eigen/Eigenvalues>

#include <numbers>
#include <random>

namespace ripstop::test_cloth_ramps {

namespace {

// N/m, of a taut cloth.
Mat3 stiffnessOf(const ClothLaw& law) { return tensionOf(law, Vec3::Zero()).stiffness; }

constexpr double stiff = 40e3;      // N/m, E t of kite cloth
constexpr double gravity = 9.80665; // m/s^2

double top(const Scene& scene)
{
    double top = -1e9;
    for (const Particle& particle : partOf(scene).particles)
        top = std::max(top, particle.position.y());
    return top;
}

// 1 m x 1 m of panels without Poisson's ratio, pinned along the upper edge, in a calm without air
// that takes speed; `load` in kg along the lower edge, shared out by width.
Scene hungSheet(double load = 0.0)
{
    Scene scene = *build(*findBuilder("cloth"), {{"columns", 6},
                                                 {"rows", 6},
                                                 {"panels", 1},
                                                 {"membrane", stiff},
                                                 {"density", 0.047},
                                                 {"hang", 2},
                                                 {"level", 3.0},
                                                 {"flat", 0},
                                                 {"sphere", 0}});
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 5.0;
    firstOf<Material>(scene).poissonRatio = 0.0;
    const double high = top(scene);
    std::vector<Particle*> lower;
    for (Particle& particle : firstOf<Part>(scene).particles) {
        particle.pinned = particle.position.y() > high - 1e-6;
        if (particle.position.y() < high - 1.0 + 1e-6)
            lower.push_back(&particle);
    }
    for (Particle* particle : lower)
        particle->mass += load / 6.0;
    for (Particle* corner : {lower.front(), lower.back()})
        corner->mass -= load / 12.0;
    return scene;
}

double weight(const Scene& scene) // N
{
    double mass = 0.0;
    for (const Particle& particle : partOf(scene).particles)
        mass += particle.mass;
    return mass * gravity;
}

// Green's strain under which a width of 1 m pulls with a force: its pull along the stretched cloth
// is E t e sqrt(1 + 2 e), found by halving.
double strainUnder(double force, double stiffness)
{
    double low = 0.0, high = 10.0;
    for (int i = 0; i < 100; ++i) {
        const double e = 0.5 * (low + high);
        (stiffness * e * std::sqrt(1.0 + 2.0 * e) < force ? low : high) = e;
    }
    return low;
}

ClothLaw lawOf(const Simulation& simulation)
{
    return ripstop::lawOf(simulation.system(), simulation.system().membranes[0]);
}

Scene withStiffness(Scene scene, double stiffness) // N/m
{
    firstOf<Material>(scene).membraneStiffness = stiffness;
    firstOf<Material>(scene).shearStiffness = 0.3 * stiffness;
    return scene;
}

struct Extremes
{
    double strain = 0.0; // 1, largest of threads
    double speed = 0.0;  // m/s
};

Extremes fly(Simulation& simulation, double seconds)
{
    Extremes seen;
    const double end = simulation.state().time + seconds;
    while (simulation.state().time < end && simulation.step()) {
        const State& state = simulation.state();
        for (const PaddedVec3& velocity : state.velocity)
            seen.speed = std::max(seen.speed, velocity.norm());
        for (const Membrane& membrane : simulation.system().membranes)
            seen.strain = std::max(
                seen.strain,
                threadElongation(simulation.system(), membrane,
                                 cornersOf(simulation.system(), membrane, state.position)));
    }
    return seen;
}

double lengthOf(const PanelCut& cut, int side) // m, at rest
{
    Eigen::Matrix2d shape;
    shape << cut.shape[0], cut.shape[1], cut.shape[2], cut.shape[3];
    return shape.inverse().col(side).norm();
}

PanelCut cutOf(const Eigen::Matrix2d& sides)
{
    const Eigen::Matrix2d shape = sides.inverse();
    return {0.5 * sides.determinant(), {shape(0, 0), shape(0, 1), shape(1, 0), shape(1, 1)}};
}

} // namespace

class TestClothRamps : public QObject
{
    Q_OBJECT

private slots:
    // The means of two inverses of positive matrices is the inverse of one: whatever two cloths are
    // like, those in between would resist all strains. Halfway the compliances are the means.
    void lawsInBetweenAreStable()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> power(1.0, 6.0), share(0.0, 1.0);
        const auto any = [&] {
            const double warp = std::pow(10.0, power(random)), weft = std::pow(10.0, power(random));
            const double most = 0.98 * std::sqrt(warp / weft); // of Poisson's ratio
            return ClothLaw::of(warp, weft, most * share(random), std::pow(10.0, power(random)));
        };
        for (int i = 0; i < 200; ++i) {
            const ClothLaw from = any(), to = any();
            for (const double s : {1e-3, 0.1, 0.5, 0.9, 0.999}) {
                const Mat3 stiffness = stiffnessOf(lawBetween(from, to, s));
                const Eigen::SelfAdjointEigenSolver<Mat3> solver(stiffness);
                QVERIFY2(solver.eigenvalues().minCoeff() > 0.0, told(s, from.warp));
                const Mat3 expected =
                    (1.0 - s) * stiffnessOf(from).inverse() + s * stiffnessOf(to).inverse();
                QVERIFY(((stiffness * expected) - Mat3::Identity()).norm() < 1e-6);
            }
            QVERIFY(lawBetween(from, to, 1.0) == to);
            QVERIFY(stiffnessOf(lawBetween({}, to, 0.25)).isApprox(0.25 * stiffnessOf(to), 1e-12));
        }
    }

    // Half of the way to twice the size is 1.5 times it. Warps run both ways, so that a turn by 170
    // degrees is one by -10; halfway it is one by -5, as is every cut in between a triangle.
    void cutsInBetweenAreTriangles()
    {
        Eigen::Matrix2d sides;
        sides << 0.3, 0.1, 0.0, 0.2;
        const PanelCut from = cutOf(sides);
        const PanelCut larger = cutBetween(from, cutOf(2.0 * sides), 0.5);
        QVERIFY(isNear(larger.area, 2.25 * from.area, 1e-12));
        QVERIFY(isNear(lengthOf(larger, 0), 0.45, 1e-12));

        const auto turned = [&](double degrees) {
            return cutOf(Eigen::Rotation2Dd(degrees * std::numbers::pi / 180.0) * sides);
        };
        const PanelCut half = cutBetween(from, turned(170.0), 0.5);
        const PanelCut expected = turned(-5.0);
        QVERIFY(isNear(half.area, from.area, 1e-12));
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY2(isNear(half.shape[i], expected.shape[i], 1e-9),
                     told(half.shape[i], expected.shape[i]));

        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        for (int i = 0; i < 200; ++i) {
            Eigen::Matrix2d one, other;
            one << number(random), number(random), number(random), number(random);
            other << number(random), number(random), number(random), number(random);
            if (one.determinant() < 0.0)
                one.col(0) *= -1.0;
            if (other.determinant() < 0.0)
                other.col(0) *= -1.0;
            for (const double s : {0.0, 0.2, 0.5, 0.8, 0.999})
                QVERIFY(cutBetween(cutOf(one), cutOf(other), s).area > 0.0);
            QVERIFY(cutBetween(cutOf(one), cutOf(other), 1.0) == cutOf(other));
        }
    }

    // s^2 (3 - 2 s) of the way after the share s of the time: 5/32 after a quarter, half after a
    // half; then exactly what was typed. Without Poisson's ratio the compliance along the warp is
    // 1 / warp.
    void numbersGoOver()
    {
        const Scene scene = hungSheet();
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.2);
        const ClothLaw before = lawOf(simulation);
        Scene edited = withStiffness(scene, 10e3);
        firstOf<Material>(edited).dampingTime = before.dampingTime + 0.32;
        edit(simulation, edited);
        QVERIFY(isNear(lawOf(simulation).warp, stiff, 1e-9 * stiff));
        const double step = scene.settings.timeStep;
        const auto compare = [&](double share) {
            const double compliance = (1.0 + 3.0 * share) / stiff;
            QVERIFY2(isNear(1.0 / lawOf(simulation).warp, compliance, 1e-9 * compliance),
                     told(1.0 / lawOf(simulation).warp, compliance));
            const double time = before.dampingTime + 0.32 * share;
            QVERIFY2(isNear(lawOf(simulation).dampingTime, time, 1e-9),
                     told(lawOf(simulation).dampingTime, time));
        };
        const double began = simulation.state().clothRamps.at(0).began;
        for (int i = 0; i < 5; ++i) {
            QVERIFY(simulation.step());
            const double s = (simulation.state().time - began) / 0.1;
            compare(s * s * (3.0 - 2.0 * s));
        }
        runFor(simulation, 0.1 + step);
        QVERIFY(simulation.state().clothRamps.empty());
        QVERIFY(lawOf(simulation) == (*compile(edited))->cloth[1]);
    }

    // What a user did: softer by a slider, and back by a typed number. What gets softer falls into
    // its threads, which at most doubles the strain of the whole weight; once it is calm, it is not
    // strained beyond that on its way back, and moves no faster than twice the steepest of the
    // ramp.
    void sheetsAreNotThrown_data()
    {
        QTest::addColumn<double>("load");
        QTest::newRow("by itself") << 0.0;
        QTest::newRow("with a load") << 0.4;
    }
    void sheetsAreNotThrown()
    {
        QFETCH(double, load);
        const Scene scene = hungSheet(load);
        const double softest = strainUnder(weight(scene), 1e-3 * stiff);
        Simulation simulation(*compile(scene));
        runFor(simulation, 1.0);
        edit(simulation, withStiffness(scene, 1e-3 * stiff));
        const Extremes soft = fly(simulation, 6.0);
        QVERIFY2(soft.strain < 2.0 * softest, told(soft.strain, softest));
        edit(simulation, scene);
        const double lasts = simulation.state().clothRamps.at(0).lasts;
        const Extremes back = fly(simulation, 3.0);
        QVERIFY2(back.strain < softest, told(back.strain, softest));
        const double steepest = 1.5 * softest / lasts; // m/s, of 1 m of cloth
        QVERIFY2(back.speed < 2.0 * steepest, told(back.speed, 2.0 * steepest));
        const Extremes rest = fly(simulation, 0.5);
        const double stiffest = strainUnder(weight(scene), stiff);
        QVERIFY2(rest.strain < 1.01 * stiffest, told(rest.strain, stiffest));
    }

    // A sheet that 6 kg have stretched to 1.7 m is to be 1 m again. Its panels shrink by the share
    // that the stretch of the upper ones has of them, which is the way over the size of the sheet;
    // the ramp lasts half the period with which a load swings that hangs so far down.
    void longWaysTakeLonger()
    {
        const Scene scene = hungSheet(6.0);
        Simulation simulation(*compile(withStiffness(scene, 1e-3 * stiff)));
        runFor(simulation, 8.0);
        double lowest = 3.0;
        for (const PaddedVec3& place : simulation.state().position)
            lowest = std::min(lowest, place.y());
        const double length = top(scene) - lowest;
        QVERIFY(length > 1.6);
        edit(simulation, scene);
        const double lasts = simulation.state().clothRamps.at(0).lasts;
        const double stretch = std::sqrt(1.0 + 2.0 * strainUnder(weight(scene), 1e-3 * stiff));
        const double way = (1.0 - 1.0 / stretch) * std::hypot(1.0, length);
        const double expected = std::numbers::pi * std::sqrt(way / gravity);
        QVERIFY2(isNear(lasts, expected, 0.01 * expected), told(lasts, expected));
    }

    // A cut is let out while it hangs: 1 % longer along the warp is 1 cm at the lower edge.
    void cutsGoOver()
    {
        const Scene scene = hungSheet();
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.5);
        Scene longer = scene;
        for (Panel& panel : firstOf<Part>(longer).panels)
            for (double Panel::*side : {&Panel::restAB, &Panel::restBC, &Panel::restCA})
                panel.*side *= 1.01;
        const double area = simulation.system().membranes[0].area;
        edit(simulation, longer);
        QCOMPARE(simulation.state().panelRamps.size(), simulation.system().membranes.size());
        QVERIFY(isNear(simulation.system().membranes[0].area, area, 1e-12));
        const double lasts = simulation.state().panelRamps[0].lasts;
        const Extremes seen = fly(simulation, lasts + scene.settings.timeStep);
        const double steepest = 1.5 * 0.01 * std::sqrt(2.0) / lasts; // m/s, of the lower corners
        QVERIFY2(seen.speed < 2.0 * steepest, told(seen.speed, steepest));
        QVERIFY(simulation.state().panelRamps.empty());
        QVERIFY(simulation.system().membranes == (*compile(longer))->membranes);
    }

    // A factor that is painted while it hangs goes over as a stiffness does: halfway from 1 to 1/16
    // the compliance is the mean of 1 and 16. What hangs is not thrown when it goes back.
    void factorsGoOver()
    {
        const Scene scene = hungSheet(10.0);
        Scene painted = scene;
        for (Panel& panel : firstOf<Part>(painted).panels)
            panel.stiffnessFactor = 1.0 / 16.0;
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.5);
        edit(simulation, painted);
        const auto factor = [&] { return simulation.system().membranes[0].factors.stiffness; };
        QCOMPARE(simulation.state().factorRamps.size(), simulation.system().membranes.size());
        QCOMPARE(factor(), 1.0);
        runFor(simulation, 0.5 * simulation.state().factorRamps[0].lasts);
        QVERIFY2(isNear(factor(), 2.0 / 17.0, 0.02), told(factor(), 2.0 / 17.0));
        fly(simulation, 4.0);
        QVERIFY(simulation.state().factorRamps.empty());
        QCOMPARE(factor(), 1.0 / 16.0);

        edit(simulation, scene);
        const double lasts = simulation.state().factorRamps.at(0).lasts;
        QVERIFY(lasts > 2.0 * scene.settings.rampTime); // 4 cm are a long way
        const Extremes back = fly(simulation, 3.0);
        const double softest = strainUnder(weight(scene), stiff / 16.0);
        QVERIFY2(back.strain < 1.5 * softest, told(back.strain, softest)); // of the upper panels
        const double steepest = 1.5 * softest / lasts;                     // m/s, of 1 m of cloth
        QVERIFY2(back.speed < 2.0 * steepest, told(back.speed, 2.0 * steepest));
        QCOMPARE(factor(), 1.0);
    }

    // Between pins nothing moves: what the hand brings is the change of the energy in the cloth,
    // A (C1 - C0) e^2 / 2 for a strain e along the warp, and nothing is left over.
    void ledgerShowsWhatTheHandBrought()
    {
        Scene scene = hungSheet();
        const double high = top(scene);
        for (Particle& particle : firstOf<Part>(scene).particles) {
            particle.pinned = true;
            particle.position.y() = high + 1.02 * (particle.position.y() - high);
        }
        addProbe(scene, "hands", Quantity::WorkOfHands, noId);
        addProbe(scene, "left over", Quantity::EnergyResidual, noId);
        Simulation simulation(*compile(scene));
        runFor(simulation, 0.01);
        edit(simulation, withStiffness(scene, 3.0 * stiff));
        runFor(simulation, 0.2);
        const double strain = 0.5 * (1.02 * 1.02 - 1.0);
        const double brought = 0.5 * 2.0 * stiff * strain * strain;
        QVERIFY2(isNear(probe(simulation, "hands"), brought, 1e-6 * brought),
                 told(probe(simulation, "hands"), brought));
        QVERIFY(std::abs(probe(simulation, "left over")) < 1e-9 * brought);

        // let out to where it is, it holds nothing any more
        Scene loose = withStiffness(scene, 3.0 * stiff);
        const Part& part = partOf(loose);
        const auto place = [&](Id id) { return findRow(part.particles, id)->position; };
        for (Panel& panel : firstOf<Part>(loose).panels) {
            panel.restAB = (place(panel.a) - place(panel.b)).norm();
            panel.restBC = (place(panel.b) - place(panel.c)).norm();
            panel.restCA = (place(panel.c) - place(panel.a)).norm();
        }
        edit(simulation, loose);
        runFor(simulation, 0.2);
        const double held = 0.5 * stiff * strain * strain; // at the start
        QVERIFY2(isNear(probe(simulation, "hands"), -held, 0.02 * held),
                 told(probe(simulation, "hands"), -held));
        QVERIFY(std::abs(probe(simulation, "left over")) < 1e-9 * brought);
    }

    void isRecorded()
    {
        const Scene scene = hungSheet(0.4);
        Scene soft = withStiffness(scene, 500.0);
        for (Panel& panel : firstOf<Part>(soft).panels)
            panel.restAB *= 0.999;
        firstOf<Part>(soft).panels[3].stiffnessFactor = 0.5;
        checkEditIsRecorded(scene, soft, [](const State& state) {
            return !state.clothRamps.empty() && !state.panelRamps.empty()
                   && !state.factorRamps.empty();
        });
    }

    // An edit that no cloth can have is refused, in the middle of a ramp as well, and leaves the
    // run alone; what repairs it is taken.
    void whatIsRefusedLeavesTheRunAlone()
    {
        const Scene scene = hungSheet();
        LiveSystem live(scene);
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        const Id material = partOf(scene).panels[0].material;
        const auto set = [&](const char* key, double value) {
            live.apply({Message("test"),
                        {SetValues{findProperty(Kind::Material, key), {material}, {value}}}});
        };
        runFor(simulation, 0.2);
        set("membraneStiffness", 400.0);
        simulation.load(std::get<Update>(live.update(2, 1)));
        runFor(simulation, 0.05);
        Simulation alone(simulation.compiled(), simulation.state());
        const State before = simulation.state();

        set("poissonRatio", 0.9);
        set("weftStiffness", 40e3);
        const auto refused = live.update(3, 1);
        QVERIFY(std::holds_alternative<Finding>(refused));
        QVERIFY(std::get<Finding>(refused).message.english().find("Poisson") != std::string::npos);
        QVERIFY(simulation.state() == before);
        runFor(simulation, 0.2);
        runFor(alone, 0.2);
        QCOMPARE(stateHash(simulation.state()), stateHash(alone.state()));

        set("weftStiffness", 400.0);
        simulation.load(std::get<Update>(live.update(4, 1)));
        QCOMPARE(simulation.state().clothRamps.size(), std::size_t(1));
        runFor(simulation, 0.2);
        QVERIFY(simulation.system().cloth == (*compile(live.scene()))->cloth);
    }

    // A fabric that gets its stiffness in flight takes it up and holds, as one does that goes on
    // from the middle of it, with solvers of its own; one that loses it falls.
    void limpClothTakesUpItsPull()
    {
        Scene scene = hungSheet();
        firstOf<Material>(scene).membraneStiffness.reset();
        scene.settings.gravity = Vec3::Zero();
        LiveSystem live(scene);
        Simulation simulation(std::get<Update>(live.update(1, 1)).system);
        const Id material = partOf(scene).panels[0].material;
        const auto set = [&](const Value& stiffness) {
            live.apply(
                {Message("test"),
                 {SetValues{
                     findProperty(Kind::Material, "membraneStiffness"), {material}, {stiffness}}}});
            simulation.load(std::get<Update>(live.update(simulation.system().generation + 1, 1)));
        };
        runFor(simulation, 0.1);
        QVERIFY(!lawOf(simulation).isElastic());
        live.apply({Message("test"),
                    {SetValues{findProperty(Kind::Settings, "gravity"),
                               {settingsId},
                               {Value(Vec3(0.0, -gravity, 0.0))}}}});
        set(Value(stiff));
        runFor(simulation, 0.05);
        Simulation other(simulation.compiled(), simulation.state());
        runFor(simulation, 2.0);
        runFor(other, 2.0);
        QCOMPARE(stateHash(other.state()), stateHash(simulation.state()));
        const Extremes rest = fly(simulation, 0.5);
        const double stiffest = strainUnder(weight(scene), stiff);
        QVERIFY2(rest.strain > 0.5 * stiffest && rest.strain < 1.01 * stiffest,
                 told(rest.strain, stiffest));
        set(Value());
        runFor(simulation, 0.2);
        QVERIFY(!lawOf(simulation).isElastic());
        QVERIFY(fly(simulation, 0.5).speed > 1.0);
    }
};

const RegisteredTest registered("test_cloth_ramps", runWithCore<TestClothRamps>);

} // namespace ripstop::test_cloth_ramps
#include "test_cloth_ramps.moc"
