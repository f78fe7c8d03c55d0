// Who touches whom in the fabric of a system while tears part it: panels and links by particle,
// with the twins and second links that the system itself has only afterwards. Numbers of particles
// and links go on from those of the system.
#pragma once

#include "assembly/split_system.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace ripstop {

class FabricMesh
{
public:
    FabricMesh(const System& system, const State& state);

    Key key(int particle) const;
    Key linkKey(int link) const;
    const Vec3& position(int particle) const; // m, now

    // Panels that are gone are passed over by all of these.
    std::vector<int> panelsAt(int particle) const; // ascending
    std::vector<int> linksAt(int particle) const;  // ascending
    std::vector<int> panelsBeside(int link) const; // that have both ends as corners
    bool isEdge(int link) const { return !panelsBeside(link).empty(); }
    bool isOnHem(int particle) const; // some edge there has one panel

    const std::array<int, 3>& corners(int panel) const;
    bool hasCorner(int panel, int particle) const;
    std::pair<int, int> othersOf(int panel, int corner) const;
    double angle(int panel, int corner) const; // rad, now
    double area(int panel) const;              // m^2, at the start

    std::pair<int, int> ends(int link) const;
    int otherEnd(int link, int particle) const;

    // The most corners that a panel at one shares with a panel at the other: 3 for the ends of an
    // edge, 2 across an edge, 1 across a corner, 0 for what is not near in the fabric.
    int nearness(int one, int other) const;

    int addTwin(int particle, Key key);
    void moveCorner(int panel, int from, int to);
    void moveEnd(int link, int from, int to);
    int addTwinLink(int link, int from, int to, Key key);

private:
    int origin(int particle) const; // in the system

    const System& m_system;
    const State& m_state;
    TwinOrigins m_origins;
    std::vector<std::pair<int, Key>> m_twins;                     // from whom
    std::vector<std::pair<std::pair<int, int>, Key>> m_twinLinks; // ends
    std::map<int, std::array<int, 3>> m_corners;                  // of panels that changed
    std::map<int, std::pair<int, int>> m_ends;                    // of links that changed
    std::map<int, std::vector<int>> m_panelsAt, m_linksAt;        // of particles where they did
};

} // namespace ripstop
