// Parts the mesh of a system at one particle after another: a particle gets a twin, and panels and
// links are told to which of the two they belong. Tears (tear_opening.h) and cuts (cutting.h) say
// which panels go.
//
// What ends at the particle:
//   - edges of panels on one side alone go with these; an edge between the two sides becomes two,
//   - other links go with the panel that they leave through, or else by their direction; those that
//     held two panels together across the opening and no longer have neighbours there break,
//   - pins and hands stay with the particle.
// The mass is shared by the areas of the panels at the start; a side without panels counts as a
// mean one. Place and velocity are those of the particle, so that mass, its centre, momentum and
// energy do not change.
#pragma once

#include "tearing/fabric_mesh.h"

#include <optional>

namespace ripstop {

// What goes with the twin of a particle, and what stays.
struct Sides
{
    std::vector<int> nearPanels;
    std::vector<int> nearLinks;              // without those that are cut
    std::vector<std::pair<int, double>> cut; // links and the share of the twin
    double share = 0.5;                      // of the mass, of the twin
    bool leaves = false;                     // something behind
};

class MeshParting
{
public:
    // Links that tears hold or have just torn (State::tearHolds) count as there.
    MeshParting(const System& system, State& state);

    const FabricMesh& mesh() const { return m_mesh; }
    bool isOnTear(int particle) const { return m_isOnTear[std::size_t(particle)]; }

    // Of the panels at `from`, those that are near go with the twin; links that leave through none
    // of them go where `direction` points.
    Sides sides(int from, const std::vector<int>& panels, const std::vector<std::uint8_t>& isNear,
                const Vec3& direction) const;

    // With a ratio, links and panels at the particle are held (State::tearHolds, panelHold).
    void part(int from, const Sides& sides, std::optional<double> heldRatio);

private:
    struct Across
    {
        int link;
        int nearness;
    };

    bool isTorn(int link) const;
    bool isDead(int link) const { return isTorn(link) && !m_pending[std::size_t(link)]; }
    bool goesAlong(int from, int to, const Vec3& direction, const std::vector<int>& panels,
                   const std::vector<std::uint8_t>& isNear) const;
    std::vector<Across> linksAcross(int particle) const;
    void hold(int link, double ratio);
    void holdPanel(int panel, double ratio);
    void markTips();
    void markTips(int from, int twin);

    const System& m_system;
    State& m_state;
    FabricMesh m_mesh;
    std::vector<std::uint8_t> m_pending;  // [links] has let go and waits, or is held
    std::vector<std::uint8_t> m_isOnTear; // [particles] and twins
    std::vector<std::uint8_t> m_isHeld;   // [particles] and twins
    std::size_t m_cuts = 0;               // so far
};

} // namespace ripstop
