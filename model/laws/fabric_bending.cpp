// The passes are in fabric_bending_kernel.inl, compiled for both kinds of machine. fillChange()
// goes through the last two of fill() again, with the turns of normals in place of the normals:
// they are linear in these.
#include "laws/fabric_bending.h"

#include "parallel/simd_pack.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

struct BendWork
{
    const BentPanel* panels;
    const std::uint8_t* panelGone; // [panels of the system]
    const PaddedVec3* position;    // m
    const PaddedVec3* way;         // m
    const double* less;            // [panels] N m, or null
    PaddedVec3* normal;            // of a FabricBending, as all that follows
    double* perArea;
    PaddedVec3* turn; // of the normals
    PaddedVec3* bending;
    PaddedVec3* load;
    bool torn; // some panel is gone
};

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "laws/fabric_bending_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

bool isSolvedWithPull(const BendsAndPanels& bends, std::span<const std::uint8_t> carries,
                      std::span<const double> mass, double timeStep)
{
    const auto carriesPull = [&](const BentPanel& panel) {
        return carries[std::size_t(panel.panel)] != 0;
    };
    return !bends.panels.empty() && std::ranges::all_of(bends.panels, carriesPull)
           && fabricBendsStiffly(bends.bends, mass, timeStep);
}

void FabricBending::size(std::size_t panels)
{
    m_normal.resize(panels);
    m_perArea.resize(panels);
    m_bending.resize(2 * panels);
}

void FabricBending::sizeChange()
{
    m_turn.resize(m_normal.size());
    m_bendingChange.resize(m_bending.size());
}

void FabricBending::fill(std::span<const BentPanel> panels, std::span<const std::uint8_t> gone,
                         const PaddedVec3* position, PaddedVec3* load, ThreadPool& pool)
{
    m_torn = std::ranges::find(gone, 1) != gone.end();
    const BendWork work{
        panels.data(),    gone.data(),     position,         nullptr, nullptr, m_normal.data(),
        m_perArea.data(), m_normal.data(), m_bending.data(), load,    m_torn};
    for (const auto pass : {wideMachine ? wide::fillNormals : anywhere::fillNormals,
                            wideMachine ? wide::fillBending : anywhere::fillBending,
                            wideMachine ? wide::fillLoads : anywhere::fillLoads})
        pool.parallelFor(panels.size(),
                         [&](std::size_t first, std::size_t last) { pass(work, first, last); });
}

void FabricBending::fillChange(std::span<const BentPanel> panels, std::span<const double> less,
                               const PaddedVec3* position, const PaddedVec3* way, PaddedVec3* load,
                               ThreadPool& pool)
{
    const BendWork work{panels.data(),
                        nullptr,
                        position,
                        way,
                        less.empty() ? nullptr : less.data(),
                        m_normal.data(),
                        m_perArea.data(),
                        m_turn.data(),
                        m_bendingChange.data(),
                        load,
                        m_torn};
    for (const auto pass : {wideMachine ? wide::fillTurns : anywhere::fillTurns,
                            wideMachine ? wide::fillBending : anywhere::fillBending,
                            wideMachine ? wide::fillLoadChanges : anywhere::fillLoadChanges})
        pool.parallelFor(panels.size(),
                         [&](std::size_t first, std::size_t last) { pass(work, first, last); });
}

double FabricBending::energy(std::span<const BentPanel> panels) const
{
    double energy = 0.0;
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (const double stiffness = panels[i].stiffness; stiffness > 0.0)
            energy += 0.5 / stiffness
                      * (m_bending[2 * i].squaredNorm() + m_bending[2 * i + 1].squaredNorm());
    return energy;
}

} // namespace ripstop
