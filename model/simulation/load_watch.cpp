// What is judged is found once for each system; then a look costs a comparison for each place, and
// a place is worked out only when it is worse than the tenth of the list.
#include "simulation/load_watch.h"

#include "assembly/split_system.h"
#include "system/system.h"

#include <algorithm>

namespace ripstop {
namespace {

// Of links where some are not 1, and of elastic panels.
std::vector<ElementFactors> factorsOf(const System& system)
{
    std::vector<ElementFactors> factors(system.linkFactors.begin(), system.linkFactors.end());
    for (const Membrane& membrane : system.membranes)
        factors.push_back(membrane.factors);
    return factors;
}

} // namespace

void LoadWatch::look(const System& system, const State& state, std::size_t tearsBefore)
{
    prepare(system, state);
    offerTears(system, std::span(state.tears).subspan(tearsBefore), m_judged, m_ofRun);
    offerPlaces(system, state, m_judged, m_ofRun);
}

WorstPlaces LoadWatch::now(const System& system, const State& state)
{
    WorstPlaces worst;
    prepare(system, state);
    offerPlaces(system, state, m_judged, worst);
    return worst;
}

void LoadWatch::prepare(const System& system, const State& state)
{
    m_isKnown &= m_serial == system.serial && m_valuesSerial == system.valuesSerial;
    if (m_isKnown)
        return;
    m_isKnown = true;
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
    const std::vector<ElementFactors> factors = factorsOf(system);
    if (m_strength != system.strength || m_safetyFactor != system.safetyFactor
        || m_factors != factors)
        m_ofRun.forget();
    m_strength = system.strength;
    m_factors = factors;
    m_safetyFactor = system.safetyFactor;
    judge(system, state);
    dropGone(system);
}

void LoadWatch::judge(const System& system, const State& state)
{
    m_judged = judgedPlacesOf(system);
    const TwinOrigins origins(state.splits);
    for (std::vector<Key>* names : {&m_judged.linkName, &m_judged.lineName})
        for (Key& name : *names)
            name = origins.link(name);
}

// What an edit has taken out of the design can no longer be gone to.
void LoadWatch::dropGone(const System& system)
{
    const WorstPlaces before = m_ofRun;
    m_ofRun.forget();
    for (const LoadedPlace& place : before.all()) {
        const std::vector<Key>& keys =
            place.kind == LoadKind::Cloth ? system.panelKey : m_judged.linkName;
        if (std::ranges::find(keys, place.element) != keys.end())
            m_ofRun.offer(place);
    }
}

} // namespace ripstop
