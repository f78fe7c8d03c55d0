// Edits of a scene while it flies, as the window hands them to a simulation; the functions fail the
// test that calls them.
#pragma once

#include "compile/compile.h"
#include "recording/replay.h"
#include "system/fields.h"
#include "system/moment.h"

#include "flown.h"

#include <QtTest>

#include <functional>

namespace ripstop {

inline void edit(Simulation& simulation, const Scene& scene)
{
    simulation.load(*compile(scene, simulation.system().generation + 1, simulation.system().run));
}

inline void runFor(Simulation& simulation, double seconds)
{
    QVERIFY(simulation.runUntil(simulation.state().time + seconds));
}

// A recording that has an edit in it is computed again to the bit, and a run goes on from the
// middle of a ramp as it went on then: in another simulation, and at any number of threads.
inline void checkEditIsRecorded(const Scene& scene, const Scene& edited,
                                const std::function<bool(const State&)>& isUnderWay)
{
    const auto recording =
        flown(scene, 200, [&](Simulation& simulation, Recorder& recorder, int step) {
            if (step == 100) {
                edit(simulation, edited);
                recorder.loaded(simulation, designOf(edited));
            }
        });
    const auto outcome = replay(*recording, 2);
    QVERIFY2(outcome, outcome ? "" : outcome.message().english().c_str());
    QVERIFY(!outcome->difference);

    const auto moment = *recording->moment(112);
    QVERIFY(isUnderWay(moment->state));
    Simulation other(*compile(scene, 5, 9));
    other.load(Update{*compile(edited, 6, 10), nullptr, {}, moment});
    while (other.state().step < 200)
        QVERIFY(other.step());
    QCOMPARE(stateHash(other.state()), recording->hashOf(200));

    for (const int threads : {1, 2}) {
        Simulation checkpoint(moment->system, moment->state, threads);
        while (checkpoint.state().step < 200)
            QVERIFY(checkpoint.step());
        QCOMPARE(stateHash(checkpoint.state()), recording->hashOf(200));
    }
}

} // namespace ripstop
