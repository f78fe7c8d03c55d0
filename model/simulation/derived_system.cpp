// Deriving, carrying the motion on, and the layout that tells views of it.
#include "simulation/derived_system.h"

#include "assembly/carry_over.h"
#include "assembly/split_system.h"
#include "compile/patch.h"
#include "simulation/torn_system.h"
#include "system/moment.h"
#include "tearing/tear_opening.h"

#include <utility>

namespace ripstop {
namespace {

std::shared_ptr<const System> derivedOf(const System& compiled, const State& state)
{
    if (state.splits.empty() && state.hands.pins.empty())
        return nullptr;
    return splitSystem(compiled, state.splits, state.hands.pins);
}

std::shared_ptr<const Layout> layoutOf(const System& system,
                                       const std::shared_ptr<const System>& derived,
                                       const std::vector<Split>& splits)
{
    auto layout = std::make_shared<Layout>();
    const TwinOrigins origins(splits);
    if (!splits.empty()) {
        layout->particleKey = system.key;
        layout->torn = std::make_shared<TornSystem>(TornSystem{derived, splits});
    }
    layout->particleId.reserve(system.key.size());
    for (const Key key : system.key)
        layout->particleId.push_back(origins.particle(key));
    layout->pinned.reserve(system.inverseMass.size());
    layout->links.reserve(system.links.size());
    layout->panelCorners.reserve(system.panels.size());
    for (const double w : system.inverseMass)
        layout->pinned.push_back(w == 0.0);
    layout->guided = system.guided;
    for (const LinkPlace& link : system.links)
        layout->links.push_back({origins.link(link.key), link.kind, link.a, link.b,
                                 link.kind == LinkKind::Rod
                                     ? system.rods[std::size_t(link.index)].restLength
                                     : system.springs[std::size_t(link.index)].restLength});
    layout->panelId = system.panelKey;
    for (const FabricPanel& panel : system.panels)
        layout->panelCorners.push_back(panel.corner);
    for (const Input& input : system.inputs)
        layout->inputId.push_back(input.key);
    for (const Obstacle& obstacle : system.obstacles)
        layout->colliderId.push_back(obstacle.key);
    for (const ProbeSpec& probe : system.probes)
        layout->probes.push_back({probe.key, probe.name, probe.unit, probe.plotted});
    return layout;
}

} // namespace

DerivedSystem::DerivedSystem(std::shared_ptr<const System> compiled)
    : m_compiled(std::move(compiled))
    , m_layout(layoutOf(*m_compiled, nullptr, {}))
{}

DerivedSystem::DerivedSystem(std::shared_ptr<const System> compiled, const State& state)
    : m_compiled(std::move(compiled))
    , m_derived(derivedOf(*m_compiled, state))
    , m_layout(layoutOf(system(), m_derived, state.splits))
{}

std::shared_ptr<const System> DerivedSystem::replace(std::shared_ptr<const System> compiled)
{
    m_layoutIsStale = true;
    std::shared_ptr<const System> before = std::exchange(m_compiled, std::move(compiled));
    return m_derived ? std::exchange(m_derived, nullptr) : before;
}

std::shared_ptr<const System> DerivedSystem::apply(const Patch& patch)
{
    m_layoutIsStale |= ripstop::apply(patch, own());
    m_layoutIsStale |= m_derived != nullptr;
    return std::exchange(m_derived, nullptr);
}

System& DerivedSystem::own()
{
    // Whoever compiled it gave it away, and it was not made const.
    if (m_compiled.use_count() > 1)
        m_compiled = std::make_shared<System>(*m_compiled);
    return const_cast<System&>(*m_compiled);
}

void DerivedSystem::derive(const State& state)
{
    m_derived = derivedOf(*m_compiled, state);
    m_layoutIsStale = true;
}

void DerivedSystem::carryOn(const System& before, RunState& run)
{
    derive(run.now);
    run.lastGood = carryOver(before, run.now, system(), std::move(run.lastGood));
    std::swap(run.now, run.lastGood);
}

void DerivedSystem::deriveAnew(RunState& run)
{
    const std::shared_ptr<const System> before = m_derived ? m_derived : m_compiled;
    carryOn(*before, run);
}

void DerivedSystem::goOnFrom(const Moment& moment, RunState& run)
{
    run.now = moment.state;
    const std::shared_ptr<const System> before = derivedOf(*moment.system, run.now);
    carryOn(before ? *before : *moment.system, run);
}

void DerivedSystem::followTears(std::size_t before, RunState& run)
{
    if (system().tearMesh != TearMesh::Split || run.now.tears.size() == before)
        return;
    if (openTears(system(), run.now))
        deriveAnew(run);
}

const std::shared_ptr<const Layout>& DerivedSystem::layout(const State& state)
{
    if (std::exchange(m_layoutIsStale, false))
        if (auto layout = layoutOf(system(), m_derived, state.splits); *layout != *m_layout)
            m_layout = std::move(layout);
    return m_layout;
}

} // namespace ripstop
