#include "simulation/run_accuracy.h"

#include "simulation/damping_percent.h"

namespace ripstop {

Message RunAccuracy::complaint() const
{
    if (isMet())
        return {};
    if (worst == 0.0) // the only steps that missed are those of which nothing was measured
        return Message(
            "No step could be told how true it was: the motion runs away. Take a shorter "
            "time step, or smaller loads.");
    if (missedShare() <= mostMissed)
        return Message("Breaks in steps that missed the wanted accuracy: %1, the first at %2 s. "
                       "Whether that load breaks it is not sure; a shorter time step tells.",
                       tornUntrue, Message::number("%.3g", tornUntrueFirst));
    const auto percent = [](double share) { return Message::number("%.3g", 100.0 * share); };
    const Message where =
        worstLink == 0
            ? Message("%1 % of the steps missed the wanted accuracy, worst at %2 s in elastic "
                      "panels by a factor of %3",
                      percent(missedShare()), Message::number("%.3g", worstTime),
                      Message::number("%.3g", worst))
            : Message("%1 % of the steps missed the wanted accuracy, worst at %2 s in link %3 by a "
                      "factor of %4",
                      percent(missedShare()), Message::number("%.3g", worstTime), worstLink,
                      Message::number("%.3g", worst));
    if (pulls <= wantedPulls && strain <= wantedStrain)
        return Message("%1. After %2 s it was kept; a shorter time step may keep it throughout.",
                       where, Message::number("%.3g", missedLast));
    const Message remedy =
        isAutomatic ? Message("Take a shorter time step.") : Message("Take the automatic solver.");
    return pulls / wantedPulls >= strain / wantedStrain
               ? Message("%1. Pulls in links are off by %2 % in the last one, where %3 % are "
                         "wanted: the design is not as stiff as it says. %4",
                         where, percent(pulls), percent(wantedPulls), remedy)
               : Message("%1. Rods that never stretch are %2 % too long in the last one, where %3 "
                         "% are wanted. %4",
                         where, percent(strain), percent(wantedStrain), remedy);
}

Message RunAccuracy::dampingComplaint() const
{
    const bool isDamped = damping > mostDamping;
    if (!isMet() || (!isDamped && lost <= mostLost))
        return {};
    const Message told =
        isDamped
            ? Message("The time steps damp the motion by %1 % of critical: much of it swings "
                      "faster than the %2 Hz that they tell truly, and comes out weaker, or dies "
                      "away.",
                      dampingPercent(damping), Message::number("%.3g", fastestSwing))
            : Message("The motion dies away by the time steps: in ten seconds they took %1 % of "
                      "its energy, most of what it lost.",
                      Message::number("%.0f", 100.0 * lost));
    if (!isDamped && losesInLines)
        return Message("%1 Lines that never stretch lose it as they get tight, however short the "
                       "step is: give them a stiffness.",
                       told);
    return couldTakeBdf2
               ? Message("%1 Take the integrator BDF2, which damps far less, or a shorter time "
                         "step.",
                         told)
               : Message("%1 Take a shorter time step, or more substeps.", told);
}

Message RunAccuracy::loadComplaint(const WorstPlaces& ofRun) const
{
    constexpr double leastMargin = 0.1; // that it may have, to be worth a word
    if (!isMet() || ofRun.all().empty())
        return {};
    const LoadedPlace& worst = ofRun.all().front();
    if (!worst.isAtLeast() || worst.margin() * (1.0 + worst.shortfall) < leastMargin)
        return {};
    const Message time = Message::number("%.3g", worst.time);
    const Message higher = Message::number("%.0f", 100.0 * worst.shortfall);
    return worst.kind == LoadKind::Cloth
               ? Message("The worst load of the run, in panel %1 at %2 s, came in a blow of which "
                         "the time steps took much of the energy: without that it would be about "
                         "%3 % higher. Take a shorter time step.",
                         worst.element, time, higher)
               : Message("The worst load of the run, in link %1 at %2 s, came in a blow of which "
                         "the time steps took much of the energy: without that it would be about "
                         "%3 % higher. Take a shorter time step.",
                         worst.element, time, higher);
}

} // namespace ripstop
