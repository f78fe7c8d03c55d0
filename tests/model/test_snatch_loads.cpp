// Loads that come in a blow: what a run tells of them, and of how far that is from what they are.
#include "builders/builder.h"
#include "builders/network.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "measure/probe.h"
#include "model/chain.h"
#include "model/first_item.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "study/flight.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop::test_snatch_loads {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double mass = 0.5; // kg, at the end of the rope

// As a new user builds it: a rope of Dyneema by its upper end, with a weight at the other.
Scene rope(double angle, double segments = 20.0)
{
    const Builder& builder = *findBuilder("rope");
    constexpr double dyneema = 1.0; // of 1 mm
    return *build(builder, newDesign(builder, {{"cord", dyneema},
                                               {"angle", angle},
                                               {"end_mass", mass},
                                               {"segments", segments}}));
}

WorstPlaces worstOf(const Scene& scene, double seconds)
{
    Simulation simulation(*compile(scene));
    if (!simulation.runUntil(seconds))
        qFatal("it diverges");
    return simulation.frame()->worstOfRun;
}

// What falls from 110 degrees gets tight at 70 again, where a part of its speed v is along the
// rope. From there k x^2 / 2 = m v^2 / 2 + c x, c being the pull of what goes round and of the
// weight. Of what swings, the damping ratio z leaves the share that it has where the force of
// spring and damper on m is largest: where its rate, k x' + d x'', is zero.
double largestPull(Scene scene)
{
    double length = 0.0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links)
            length += link.restLength;
    });
    const Material& cord = firstOf<Material>(scene);
    const double stiffness = *cord.axialStiffness / length;
    const double g = scene.settings.gravity.norm();
    const double height = length * std::sin(20.0 * degree);
    const double speed = std::sqrt(2.0 * g * 2.0 * height);
    const double along = speed * std::sin(20.0 * degree);
    const double around = speed * std::cos(20.0 * degree);
    const double steady = mass * (around * around / length + g * std::sin(20.0 * degree));
    const double z = 0.5 * std::sqrt(stiffness / mass) * cord.dampingTime;
    const double root = std::sqrt(1.0 - z * z);
    const double turned = std::atan((1.0 - 4.0 * z * z) * root / (z * (3.0 - 4.0 * z * z)));
    return steady
           + std::sqrt(steady * steady + stiffness * mass * along * along)
                 * std::exp(-z / root * turned);
}

std::size_t tensionProbe(const Simulation& simulation)
{
    const std::vector<ProbeSpec>& probes = simulation.system().probes;
    const auto probe = std::ranges::find(probes, Quantity::Tension, &ProbeSpec::quantity);
    return std::size_t(probe - probes.begin());
}

constexpr double strength = 100.0; // N

// 2 kg that fall half a metre into a line of 1 m.
Chain fallingWeight()
{
    Chain chain({Vec3(0, 0, 0), Vec3(0, -0.5, 0)}, 1, 2.0, line(strength));
    chain.row().links[0].restLength = 1.0;
    chain.row().links[0].resists = Resists::Tension;
    chain.scene.settings.viscosity = 2.0;
    return chain;
}

} // namespace

class TestSnatchLoads : public QObject
{
    Q_OBJECT

private slots:
    // What a new scene gets does the steps of the blow again in finer ones, and looks within them.
    // It is the same blow however many links the rope has, and however long the steps are; where
    // these are too long even then, it says by about how much.
    void snatchIsFelt_data()
    {
        QTest::addColumn<double>("segments");
        QTest::addColumn<double>("rate"); // Hz
        for (const double segments : {1.0, 2.0, 20.0})
            for (const double rate : {120.0, 240.0})
                QTest::addRow("%g links at %g Hz", segments, rate) << segments << rate;
    }
    void snatchIsFelt()
    {
        QFETCH(const double, segments);
        QFETCH(const double, rate);
        Scene scene = rope(110.0, segments);
        scene.settings.timeStep = 1.0 / rate;
        const WorstPlaces worst = worstOf(scene, 1.0);
        const LoadedPlace& place = worst.all().front();
        const double truth = largestPull(scene);
        const double would = place.load * (place.isAtLeast() ? 1.0 + place.shortfall : 1.0);
        QVERIFY2(std::abs(would - truth) < 0.1 * truth,
                 qPrintable(QString("%1, expected %2").arg(would).arg(truth)));
        if (rate == 240.0)
            QVERIFY2(!place.isAtLeast(), qPrintable(QString::number(place.shortfall)));
        if (rate == 240.0 && segments == 20.0)
            QVERIFY(place.load * (1.0 + place.shortfall) > truth);
    }

    // What a probe reads of the blow is what the list of loads tells of it, and so it is in a study
    // and in a formula.
    void probesFeelTheSnatch()
    {
        Scene scene = rope(110.0, 1.0); // of one link, which its probe reads
        const Id formula = addProbe(scene, "twice", Quantity::Formula);
        std::get<Probe>(*findItem(scene, formula)).formula = "2*tension";
        const Id falling = addProbe(scene, "falls", Quantity::Formula);
        std::get<Probe>(*findItem(scene, falling)).formula = "-tension";
        Simulation simulation(*compile(scene));
        const std::size_t probe = tensionProbe(simulation);
        double most = 0.0;
        double twice = 0.0;
        double least = 0.0;
        double leastAtEnd = 0.0;
        while (simulation.state().time < 1.0) {
            QVERIFY(simulation.step());
            most = std::max(most, simulation.sample().most()[probe]);
            const ProbeSample sample = simulation.sample();
            twice = std::max(twice, sample.most()[probe + 3]);
            least = std::min(least, sample.most().back());
            leastAtEnd = std::min(leastAtEnd, sample.probe.back());
        }
        const double load = simulation.frame()->worstOfRun.all()[0].load;
        QVERIFY2(std::abs(most - load) < 1e-9 * load,
                 qPrintable(QString("%1, the list has %2").arg(most).arg(load)));
        const double truth = largestPull(scene);
        QVERIFY2(std::abs(most - truth) < 0.1 * truth, qPrintable(QString::number(most)));
        QCOMPARE(twice, 2.0 * most);
        QVERIFY(least < 0.0);
        QCOMPARE(least, leastAtEnd); // a number that falls with the load has no peak by it

        FlightPlan plan;
        plan.seconds = 1.0;
        plan.measures = {{"tension", Reduction::Largest}};
        QCOMPARE(fly(scene, {}, plan)->measured.front(), most);
    }

    // What a probe reads at an instant stays that of the instant, so that a mean over many is as it
    // should be; there is more within the steps of the blow alone.
    void instantsAreAsTheyWere()
    {
        Simulation simulation(*compile(rope(110.0, 1.0)));
        const std::size_t probe = tensionProbe(simulation);
        std::size_t withPeak = 0;
        while (simulation.state().time < 1.0) {
            QVERIFY(simulation.step());
            const ProbeSample sample = simulation.sample();
            const System& system = simulation.system();
            QCOMPARE(sample.probe[probe],
                     Readings(system, simulation.state()).value(system.probes[probe]));
            withPeak += sample.most()[probe] > sample.probe[probe];
        }
        QVERIFY(withPeak > 0);
        QVERIFY2(withPeak < 48, qPrintable(QString::number(withPeak))); // of 240, those of the blow
    }

    // A place to which a run is put has had no step.
    void placesHaveNoPeak()
    {
        const auto system = *compile(rope(110.0, 1.0));
        Simulation simulation(system);
        while (simulation.sample().highest.empty())
            QVERIFY(simulation.step() && simulation.state().time < 1.0);
        Simulation there(system);
        there.place(simulation.state());
        QVERIFY(there.sample().highest.empty());
        simulation.load(system);
        QVERIFY(simulation.sample().highest.empty());
    }

    // A line that breaks bears nothing at the end of the step; what it bore counts.
    void probesTellWhatBreaks()
    {
        Scene scene = rope(110.0);
        Material& cord = firstOf<Material>(scene);
        const double strength = 0.5 * largestPull(scene);
        cord.lineStrength = strength;
        const double bears = strength * cord.jointEfficiency.value_or(1.0);
        addProbe(scene, "margin", Quantity::Margin);
        addProbe(scene, "all", Quantity::MaxTension);
        Simulation simulation(*compile(scene));
        double pull = 0.0;
        double margin = 0.0;
        while (simulation.state().tears.empty()) {
            QVERIFY(simulation.step() && simulation.state().time < 1.0);
            const ProbeSample sample = simulation.sample();
            pull = sample.most().back();
            margin = sample.most()[sample.probe.size() - 2];
        }
        QVERIFY(pull >= simulation.state().tears[0].force);
        QVERIFY2(std::abs(margin * bears - pull) < 1e-9 * pull,
                 qPrintable(QString::number(margin)));
        QVERIFY(margin >= 1.0);
    }

    // A weight that falls into its line: the run knows the jerk, when the moment has long
    // forgotten it. Ends of steps show no more of it than it knows, a step before or after.
    void runRemembersTheJerk()
    {
        const Chain chain = fallingWeight();
        Simulation simulation(*compile(chain.scene));
        double most = 0.0;
        double when = 0.0;
        while (simulation.state().time < 8.0) {
            QVERIFY(simulation.step());
            if (const double now = simulation.frame()->linkMargin[0]; now > most) {
                most = now;
                when = simulation.state().time;
            }
        }
        const auto frame = simulation.frame();
        const double weight = 2.0 * chain.scene.settings.gravity.norm() / strength; // 1
        QVERIFY(most > 2.0 * weight); // a load that comes at once is felt twice, at least
        QVERIFY(frame->worstOfRun.all()[0].margin() >= most);
        QVERIFY(std::abs(frame->worstOfRun.all()[0].time - when) <= chain.scene.settings.timeStep);
        const double now = frame->worstNow.all()[0].margin();
        QVERIFY2(std::abs(now - weight) < 0.01 * weight, qPrintable(QString::number(now)));
    }

    // A damper takes hold at once: of 2 kg that have fallen half a metre, through what takes n of
    // the speed in a second, it pulls with c v from the first moment on.
    void damperTakesHoldAtOnce()
    {
        Chain chain = fallingWeight();
        const double n = chain.scene.settings.viscosity; // 1/s
        const double g = chain.scene.settings.gravity.norm();
        double time = 0.0; // s, of the fall
        for (int i = 0; i < 100; ++i)
            time = 0.5 * n / g + (1.0 - std::exp(-n * time)) / n;
        const double speed = g / n * (1.0 - std::exp(-n * time));
        const Material& cord = chain.stuff();
        const double truth = *cord.axialStiffness * cord.dampingTime * speed; // of 1 m

        const auto frame = chain.after(0.5);
        const LoadedPlace& place = frame->worstOfRun.all()[0];
        QVERIFY2(std::abs(place.load - truth) < 0.05 * truth,
                 qPrintable(QString("%1, expected %2").arg(place.load).arg(truth)));
        QVERIFY(std::abs(place.time - time) < chain.scene.settings.timeStep);
    }

    // A cord that bears a tenth less than the blow breaks by it, and one that bears a tenth more
    // holds.
    void breaksByTheBlow()
    {
        for (const auto& [share, breaks] : {std::pair(0.9, true), std::pair(1.1, false)}) {
            Scene scene = rope(110.0);
            Material& cord = firstOf<Material>(scene);
            cord.lineStrength = share * largestPull(scene) / cord.jointEfficiency.value_or(1.0);
            Simulation simulation(*compile(scene));
            QVERIFY(simulation.runUntil(1.0));
            QCOMPARE(!simulation.state().tears.empty(), breaks);
        }
    }

    // A step that is too long for the blow tells too little, and says by about how much.
    void shortfallIsTold()
    {
        Scene scene = rope(110.0);
        scene.settings.solver = Solver::Direct; // which takes the steps that it is given
        scene.settings.integrator = Integrator::Bdf2;
        scene.settings.substeps = 1;
        const WorstPlaces worst = worstOf(scene, 1.0);
        const LoadedPlace& place = worst.all().front();
        const double truth = largestPull(scene);
        QVERIFY2(place.load < 0.7 * truth, qPrintable(QString::number(place.load)));
        const double would = place.load * (1.0 + place.shortfall);
        QVERIFY2(std::abs(would - truth) < 0.15 * truth,
                 qPrintable(QString("%1, expected %2").arg(would).arg(truth)));
        QVERIFY(place.isAtLeast());
        QVERIFY(RunAccuracy().loadComplaint(worst).english().find("came in a blow")
                != std::string::npos);
    }

    // Short steps tell the load as it is, and nothing is wrong with it.
    void shortStepsTellTheLoad()
    {
        Scene scene = rope(110.0);
        scene.settings.timeStep /= 16.0;
        const WorstPlaces worst = worstOf(scene, 1.0);
        const LoadedPlace& place = worst.all().front();
        const double truth = largestPull(scene);
        QVERIFY2(std::abs(place.load - truth) < 0.03 * truth,
                 qPrintable(QString("%1, expected %2").arg(place.load).arg(truth)));
        QVERIFY2(place.shortfall < 0.02, qPrintable(QString::number(place.shortfall)));
        QVERIFY(RunAccuracy().loadComplaint(worst).empty());
    }

    // What swings down on a taut rope pulls with 3 m g less 2 m g by the cosine, and slowly; beside
    // that it rings by no more than it was let go with, on a rope that was not stretched.
    void swingHasNone()
    {
        const Scene scene = rope(60.0);
        const WorstPlaces worst = worstOf(scene, 2.0);
        const LoadedPlace& place = worst.all().front();
        const double weight = mass * scene.settings.gravity.norm();
        const double truth = weight * (3.0 - 2.0 * std::cos(60.0 * degree));
        const double ringing = weight * std::cos(60.0 * degree);
        QVERIFY2(place.load > 0.99 * truth && place.load < truth + ringing,
                 qPrintable(QString("%1, expected %2").arg(place.load).arg(truth)));
        QVERIFY2(place.shortfall < 0.01, qPrintable(QString::number(place.shortfall)));
        QVERIFY(RunAccuracy().loadComplaint(worst).empty());
    }

    // Steps that damp by turning it are no blow either.
    void swingHasNoneByEuler()
    {
        Scene scene = rope(60.0);
        scene.settings.integrator = Integrator::SemiImplicitEuler;
        scene.settings.substeps = 1;
        const WorstPlaces worst = worstOf(scene, 2.0);
        QCOMPARE(worst.all().front().shortfall, 0.0);
        QVERIFY(RunAccuracy().loadComplaint(worst).empty());
    }

    // From each moment of the blow it goes on as it did.
    void goesOnAlike()
    {
        const auto system = *compile(rope(110.0));
        Simulation whole(system);
        QVERIFY(whole.runUntil(0.52));
        std::vector<State> moments;
        for (int i = 0; i < 8; ++i) {
            moments.push_back(whole.state());
            QVERIFY(whole.step());
        }
        QVERIFY(whole.runUntil(0.6));
        for (const State& moment : moments) {
            Simulation rest(system, moment);
            QVERIFY(rest.runUntil(0.6));
            QCOMPARE(stateHash(rest.state()), stateHash(whole.state()));
        }
    }

    // What breaks by a blow needs no more of it, nor does what is far from breaking in any case,
    // and where nothing bears anything nothing is said.
    void nothingToSay()
    {
        QVERIFY(RunAccuracy().loadComplaint(WorstPlaces()).empty());
        WorstPlaces worst;
        LoadedPlace place;
        place.load = 2.0;
        place.strength = 1.0;
        place.shortfall = 1.0;
        place.torn = true;
        worst.offer(place);
        QVERIFY(RunAccuracy().loadComplaint(worst).empty());

        WorstPlaces light;
        place.torn = false;
        place.load = 0.04; // and twice of that is less than a tenth
        light.offer(place);
        QVERIFY(RunAccuracy().loadComplaint(light).empty());
    }
};

const RegisteredTest registered("test_snatch_loads", runPlain<TestSnatchLoads>);

} // namespace ripstop::test_snatch_loads
#include "test_snatch_loads.moc"
