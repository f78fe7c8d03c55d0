#include "forces/fabric_air.h"

#include "forces/air_step.h"
#include "forces/canopy_air.h"
#include "forces/force.h"
#include "forces/panel_load.h"

#include <vector>

namespace ripstop {
namespace {

class FabricAirForce final : public Force
{
public:
    Message name() const override { return Message("air on fabric"); }
    ForceKind kind() const override { return ForceKind::Air; }
    bool acts(const System& system, const State&) const override
    {
        return !system.panels.empty() && system.airDensity > 0.0;
    }
    bool hangsOn(const Edited& e) const override
    {
        return e.materials || e.particles || e.panels || e.winds;
    }
    void list(System& system) const override { listWings(system); }
    void prepare(const System& system, const State&) override
    {
        m_load.resize(system.panels.size());
        m_canopies.prepare(system);
    }
    void advance(const System& system, State& state, double h) override
    {
        m_canopies.advance(system, state, h);
    }
    Lane fill(const System& system, const State& state, ThreadPool& pool) override
    {
        fillFabricLoads(system, state, pool, m_wings, m_load);
        return {.load = m_load.data(), .at = &system.panelsAt, .parts = 3.0};
    }
    void addDamping(const System& system, const State& state, Damping& damping) const override
    {
        addAirDamping(system, state, damping);
    }

private:
    WingLoads m_wings;
    CanopyFiller m_canopies;
    std::vector<PaddedVec3> m_load; // [panels] N
};

} // namespace

void fillFabricLoads(const System& system, const State& state, ThreadPool& pool, WingLoads& wings,
                     std::span<PaddedVec3> load)
{
    fillPanelLoads(system, state, pool, load);
    wings.add(system, state, load);
    addCanopyLoads(system, state, pool, load);
}

std::unique_ptr<Force> FabricLists::makeForce() { return std::make_unique<FabricAirForce>(); }

} // namespace ripstop
