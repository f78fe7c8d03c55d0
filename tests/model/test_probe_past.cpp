// What probes would have read in a run that went without them, from its recording.
//
// Stages: the numbers of a run that had the probes; a fall whose answer is known; what has no past.
#include "builders/builder.h"
#include "recording/probe_past.h"
#include "registered_test.h"
#include "views/small_scenes.h"

#include "flown.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace ripstop::test_probe_past {

namespace {

bool isProbe(const Entry& entry) { return std::holds_alternative<Probe>(entry.item); }

std::vector<Entry> probesOf(const Scene& scene)
{
    std::vector<Entry> probes;
    std::ranges::copy_if(scene.items, std::back_inserter(probes), isProbe);
    return probes;
}

Scene without(Scene scene)
{
    std::erase_if(scene.items, isProbe);
    return scene;
}

Scene fall()
{
    Scene scene = fallingPair();
    scene.settings.timeStep = 0.001; // s
    return scene;
}

Entry probe(std::uint32_t id, Quantity quantity, Id target = Id{2})
{
    return {Id{id}, Probe{"probe", quantity, target}};
}

} // namespace

class TestProbePast : public QObject
{
    Q_OBJECT

private slots:
    // The design flies the same without its probes, and they read of the recording what they would
    // have read, as far as frames are kept (run_chunk.h): places to 1e-6 m, the rest to 1e-5.
    void readsWhatTheRunWouldHave()
    {
        const Scene scene = *build(*findBuilder("hang_glider"), {});
        std::map<std::int64_t, ProbeSample> seen;
        (void)flown(scene, 200, [&](Simulation& simulation, Recorder&, int) {
            seen[simulation.state().step] = simulation.sample();
        });
        const std::vector<Entry> probes = probesOf(scene);
        QVERIFY(probes.size() > 3);
        const auto recording = flown(without(scene), 200);
        const ProbePast past = probePast(*recording, probes);
        QCOMPARE(past.time.size(), recording->frameCount());
        int compared = 0;
        for (std::size_t frame = 0; frame < past.time.size(); ++frame) {
            const auto there = seen.find(recording->stepOf(frame));
            if (there == seen.end())
                continue;
            QCOMPARE(past.time[frame], there->second.time);
            for (std::size_t i = 0; i < probes.size(); ++i) {
                const double live = there->second.probe[i];
                const double read = past.value[i][frame];
                QCOMPARE(std::isnan(read), std::isnan(live));
                if (std::isnan(live))
                    continue;
                QVERIFY2(std::abs(read - live) <= 1e-5 * (1.0 + std::abs(live)),
                         there->second.layout->probes[i].name.c_str());
                ++compared;
            }
        }
        QVERIFY(compared > 100);
    }

    // y = y0 - g t^2 / 2 and v = g t; the integrator is off by g h t / 2 in place.
    void aFall()
    {
        constexpr double g = 9.80665, h = 0.001;
        const auto recording = flown(fall(), 500);
        const ProbePast past =
            probePast(*recording, {probe(8, Quantity::PositionY), probe(9, Quantity::SinkRate)});
        QCOMPARE(past.value.size(), std::size_t(2));
        for (std::size_t i = 0; i < past.time.size(); ++i) {
            const double t = past.time[i];
            QVERIFY(std::abs(past.value[0][i] - (10.0 - 0.5 * g * t * t)) <= g * h * t + 1e-6);
            QVERIFY(std::abs(past.value[1][i] - g * t) <= 1e-6 * (1.0 + g * t));
        }
    }

    // The steps per second of the clock are in no recording, nor is a particle that was not there.
    void someHaveNone()
    {
        const auto recording = flown(fall(), 50);
        const ProbePast clock = probePast(*recording, {probe(8, Quantity::StepsPerSecond, noId)});
        QVERIFY(!clock.time.empty());
        for (const double value : clock.value[0])
            QVERIFY(std::isnan(value));
        const ProbePast stranger = probePast(*recording, {probe(8, Quantity::PositionY, Id{15})});
        for (const double value : stranger.value[0])
            QVERIFY(std::isnan(value));
        // nor does it keep the others from being read
        const ProbePast both = probePast(
            *recording, {probe(8, Quantity::PositionY, Id{15}), probe(9, Quantity::PositionY)});
        QVERIFY(!both.time.empty());
        for (std::size_t i = 0; i < both.time.size(); ++i)
            QVERIFY(std::isnan(both.value[0][i]) && std::isfinite(both.value[1][i]));
        // works are added up from when they are asked for
        const ProbePast work = probePast(*recording, {probe(8, Quantity::WorkOfAir, noId)});
        for (const double value : work.value[0])
            QVERIFY(std::isnan(value));
        const ProbePast ended =
            probePast(*recording, {probe(8, Quantity::PositionY)}, [](double) { return false; });
        QVERIFY(ended.time.empty());
    }
};

const RegisteredTest registered("test_probe_past", runWithCore<TestProbePast>);

} // namespace ripstop::test_probe_past
#include "test_probe_past.moc"
