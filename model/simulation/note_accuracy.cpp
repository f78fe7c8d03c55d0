#include "simulation/note_accuracy.h"

#include <algorithm>

namespace ripstop {

void noteAccuracy(const System& system, const Stepper& stepper, const State& now, std::size_t torn,
                  RecentDamping& damping, RunAccuracy& accuracy)
{
    const StepAccuracy& last = stepper.accuracy();
    const double ratio = last.ratio(system);
    const bool isAutomatic = system.solver == Solver::Auto;
    accuracy.pulls = last.pulls;
    accuracy.strain = last.strain;
    accuracy.wantedPulls = system.accuracy;
    accuracy.wantedStrain = system.strainGoal;
    accuracy.isAutomatic = isAutomatic;
    ++accuracy.steps;
    if (ratio > 1.0) {
        ++accuracy.missed;
        accuracy.missedLast = now.time;
        if (torn > 0 && accuracy.tornUntrue == 0)
            accuracy.tornUntrueFirst = now.time;
        accuracy.tornUntrue += std::int64_t(torn);
    }
    damping.add(stepper.numericalDamping(), system, now);
    accuracy.damping = damping.ratio();
    accuracy.lost = std::max(accuracy.lost, damping.lost());
    accuracy.couldTakeBdf2 = stepper.integrator() != Integrator::Bdf2
                             && (isAutomatic || system.solver == Solver::Direct);
    accuracy.losesInLines = accuracy.lost > RunAccuracy::mostLost
                            && std::ranges::any_of(system.rods, [](const Rod& rod) {
                                   return rod.resists == Resists::Tension && rod.compliance == 0.0;
                               });
    if (ratio > accuracy.worst) {
        const int rod = last.worstRod(system);
        accuracy.worst = ratio;
        accuracy.worstTime = now.time;
        accuracy.worstLink =
            rod < 0 ? 0 : system.links[std::size_t(system.rodLink[std::size_t(rod)])].key;
    }
}

} // namespace ripstop
