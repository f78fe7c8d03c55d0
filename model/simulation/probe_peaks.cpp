#include "simulation/probe_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

bool isOfLinks(const ProbeSpec& probe, const System& system, const State::Tear& tear)
{
    return std::ranges::any_of(
        probe.links, [&](int l) { return system.links[std::size_t(l)].key == tear.element; });
}

bool isOfPanels(const ProbeSpec& probe, const System& system, const State::Tear& tear)
{
    return std::ranges::any_of(
        probe.panels, [&](int p) { return system.panelKey[std::size_t(p)] == tear.element; });
}

} // namespace

void ProbePeaks::beginStep(const System& system, const State& state)
{
    if (!m_instant || m_serial != system.serial || m_valuesSerial != system.valuesSerial) {
        m_serial = system.serial;
        m_valuesSerial = system.valuesSerial;
        afterSubstep(system, state, 0.0, Integrator::Auto);
    }
    forget();
}

void ProbePeaks::afterSubstep(const System& system, const State& state, double /*h*/,
                              Integrator /*integrator*/)
{
    if (!m_instant)
        m_instant.emplace(system, state);
    m_instant->goTo(system, state);
    for (std::size_t i = 0; i < system.probes.size(); ++i)
        if (isLoad(system.probes[i].quantity))
            note(system, i, m_instant->value(system.probes[i]));
}

void ProbePeaks::noteTears(const System& system, std::span<const State::Tear> torn,
                           const JudgedPlaces& judged)
{
    for (const State::Tear& tear : torn) {
        const LoadedPlace place = tornPlace(system, tear, judged);
        for (std::size_t i = 0; i < system.probes.size(); ++i) {
            const ProbeSpec& probe = system.probes[i];
            if (probe.quantity == Quantity::Margin && place.strength > 0.0
                && (isOfLinks(probe, system, tear) || isOfPanels(probe, system, tear)))
                note(system, i, place.margin());
            const bool isTension =
                probe.quantity == Quantity::Tension || probe.quantity == Quantity::MaxTension;
            const bool isPull = place.kind == LoadKind::Line || place.kind == LoadKind::Thread;
            if (isTension && isPull && isOfLinks(probe, system, tear))
                note(system, i, tear.force);
        }
    }
}

void ProbePeaks::raise(std::span<double> values) const
{
    if (m_isNoted)
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::fmax(values[i], m_highest[i]); // passes over what is no number
}

void ProbePeaks::note(const System& system, std::size_t probe, double value)
{
    if (!std::exchange(m_isNoted, true))
        m_highest.assign(system.probes.size(), std::numeric_limits<double>::quiet_NaN());
    m_highest[probe] = std::fmax(m_highest[probe], value);
}

} // namespace ripstop
