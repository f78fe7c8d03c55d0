// What is judged is found once for each system; then a look costs a comparison for each place, and
// a place is worked out only when it is worse than the tenth of the list.
#include "simulation/load_watch.h"

#include "assembly/split_system.h"
#include "forces/bend_force.h"
#include "system/membrane.h"
#include "system/system.h"

#include <algorithm>

namespace ripstop {
namespace {

// Whether the place is there and can bear what it could when it was noted: a margin against a
// strength that is no more tells nothing of what runs.
bool isAsNoted(const System& system, const JudgedPlaces& judged, const LoadedPlace& place)
{
    const auto isNamed = [&](int link) {
        return judged.linkName[std::size_t(link)] == place.element;
    };
    switch (place.kind) {
    case LoadKind::Line:
    case LoadKind::Thread:
        return std::ranges::any_of(judged.links, [&](const JudgedPlaces::OfLink& one) {
            return one.kind == place.kind && one.strength == place.strength && isNamed(one.link);
        });
    case LoadKind::Cloth:
        return std::ranges::any_of(judged.panels, [&](const JudgedPlaces::FourPanels& four) {
            for (std::size_t k = 0; k < 4 && four.membrane[k] >= 0; ++k) {
                const Membrane& membrane = system.membranes[std::size_t(four.membrane[k])];
                if (system.panelKey[std::size_t(membrane.panel)] == place.element)
                    return place.strength == four.warp[k] || place.strength == four.weft[k];
            }
            return false;
        });
    case LoadKind::Spar:
        return std::ranges::any_of(judged.spars, [&](const JudgedPlaces::OfSpar& one) {
            const std::array<int, 2>& of = system.of<BendLists>().list[std::size_t(one.bend)].of;
            return one.strength == place.strength && std::ranges::any_of(of, isNamed);
        });
    }
    return false;
}

} // namespace

void LoadWatch::afterSubstep(const System& system, const State& state, double /*h*/,
                             Integrator /*integrator*/)
{
    prepare(system, state);
    offerPlaces(system, state, m_judged, m_ofStep);
}

void LoadWatch::look(const System& system, const State& state, std::size_t tearsBefore)
{
    prepare(system, state);
    for (const State::Tear& tear : std::span(state.tears).subspan(tearsBefore)) {
        const LoadedPlace place = tornPlace(system, tear, m_judged);
        if (place.strength > 0.0)
            m_ofRun.offer(place);
        m_firstBreaks.add(place);
    }
    for (const LoadedPlace& place : m_ofStep.all())
        m_ofRun.offer(place);
    m_ofStep.forget();
    offerPlaces(system, state, m_judged, m_ofRun);
}

bool LoadWatch::hasPeakAfter(double time) const
{
    return std::ranges::any_of(m_ofRun.all(),
                               [&](const LoadedPlace& place) { return place.time > time; });
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
    judge(system, state);
    dropOthers(system);
}

void LoadWatch::judge(const System& system, const State& state)
{
    m_judged = judgedPlacesOf(system);
    const TwinOrigins origins(state.splits);
    for (std::vector<Key>* names : {&m_judged.linkName, &m_judged.lineName})
        for (Key& name : *names)
            name = origins.link(name);
}

// What an edit has taken out of the design can no longer be gone to, and what it has given another
// strength is judged anew. All else stays, also when other materials and panels have come.
void LoadWatch::dropOthers(const System& system)
{
    const WorstPlaces before = m_ofRun;
    m_ofRun.forget();
    for (const LoadedPlace& place : before.all())
        if (isAsNoted(system, m_judged, place))
            m_ofRun.offer(place);
}

} // namespace ripstop
