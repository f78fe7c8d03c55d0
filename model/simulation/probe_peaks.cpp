#include "simulation/probe_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace ripstop {

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

void ProbePeaks::noteTears(const System& system, const State& state, std::size_t tearsBefore)
{
    const std::span<const State::Tear> torn = std::span(state.tears).subspan(tearsBefore);
    if (torn.empty() || system.probes.empty())
        return;
    std::optional<JudgedPlaces> judged; // for margins alone
    for (std::size_t i = 0; i < system.probes.size(); ++i) {
        const ProbeSpec& probe = system.probes[i];
        const bool isTension =
            probe.quantity == Quantity::Tension || probe.quantity == Quantity::MaxTension;
        if (!isTension && probe.quantity != Quantity::Margin)
            continue;
        for (const State::Tear& tear : torn) {
            const auto isLink = [&](int l) {
                return system.links[std::size_t(l)].key == tear.element;
            };
            const auto isPanel = [&](int p) {
                return system.panelKey[std::size_t(p)] == tear.element;
            };
            const bool isOfLink = std::ranges::any_of(probe.links, isLink);
            if (isTension) {
                const bool hasSnapped = tear.length == 0.0; // by its bending moment
                if (isOfLink && !hasSnapped)
                    note(system, i, tear.force);
            } else if (isOfLink || std::ranges::any_of(probe.panels, isPanel)) {
                if (!judged)
                    judged = judgedPlacesOf(system);
                if (const LoadedPlace place = tornPlace(system, tear, *judged);
                    place.strength > 0.0)
                    note(system, i, place.margin());
            }
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
