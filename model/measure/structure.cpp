#include "measure/structure.h"

#include "forces/bend_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Visits what the panels of a probe carry, with their area at rest, m^2.
template <typename Visit>
void forEachPull(const ProbeSpec& probe, Readings& readings, Visit&& visit)
{
    const std::vector<Membrane>& membranes = readings.system().membranes; // ascending by panel
    if (membranes.empty())
        return;
    for (const int panel : probe.panels) {
        const auto found = std::ranges::lower_bound(membranes, panel, {}, &Membrane::panel);
        if (found != membranes.end() && found->panel == panel
            && !readings.state().panelGone[std::size_t(panel)])
            visit(readings.panelPull()[std::size_t(panel)], found->area);
    }
}

double largestOfThreads(const ProbeSpec& probe, Readings& readings)
{
    const std::vector<LinkStuff>& stuff = readings.system().linkStuff;
    double largest = nothing;
    for (const int link : probe.links)
        if (std::size_t(link) < stuff.size() && stuff[std::size_t(link)].width > 0.0)
            largest = std::fmax(largest, readings.tension()[std::size_t(link)]
                                             / stuff[std::size_t(link)].width);
    return largest;
}

} // namespace

double fabricStress(const ProbeSpec& probe, Readings& readings)
{
    double largest = largestOfThreads(probe, readings);
    forEachPull(probe, readings, [&](const PanelPull& pull, double) {
        largest = std::fmax(largest, pull.tension); // passes over no number
    });
    return largest;
}

double meanOfPanels(const ProbeSpec& probe, Readings& readings, double PanelPull::*number)
{
    double sum = 0.0;
    double all = 0.0;
    forEachPull(probe, readings, [&](const PanelPull& pull, double area) {
        sum += area * pull.*number;
        all += area;
    });
    return all > 0.0 ? sum / all : nothing;
}

double wrinkledShare(const ProbeSpec& probe, Readings& readings)
{
    double folded = 0.0;
    double all = 0.0;
    forEachPull(probe, readings, [&](const PanelPull& pull, double area) {
        folded += pull.state == ClothState::Taut ? 0.0 : area;
        all += area;
    });
    return all > 0.0 ? folded / all : nothing;
}

double bendingMoment(const ProbeSpec& probe, Readings& readings)
{
    const System& system = readings.system();
    const std::vector<std::uint8_t>& isMeant = readings.isOf(probe);
    double largest = nothing;
    for (const Bend& bend : system.of<BendLists>().list)
        if (bend.ofSpar && (isMeant[std::size_t(bend.of[0])] || isMeant[std::size_t(bend.of[1])]))
            largest = std::fmax(largest, bendingMoment(system, readings.state(), bend));
    return largest;
}

} // namespace ripstop
