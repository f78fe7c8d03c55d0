// Fabric and lines that keep apart: particles against panels.
//
// A particle keeps at least the thickness from panels that it does not belong to, on the side where
// it is. Who may meet whom is found once in each time step, with a grid of cells that particles are
// sorted into; each substep then goes through the pairs, in the order of the panels, and
//     moves   both along the normal until they are a thickness apart, by their inverse masses
//     stops   what of their relative velocity closes the gap; Coulomb friction takes from the rest
// as the first pass of Bridson, Fedkiw and Anderson 2002 does. What starts closer than the
// thickness, such as the neighbours of a particle in a fine mesh, keeps nine tenths of the distance
// that it starts with. Where two panels cross with no particle near, nothing is found.
#pragma once

#include "system/system.h"

#include <cstdint>
#include <vector>

namespace ripstop {

class FabricContact
{
public:
    // The pairs that may touch within the next time step.
    void find(const System& system, const State& state);

    // After the rods: positions and velocities of one substep.
    void resolve(const System& system, State& state) const;

private:
    struct Pair
    {
        int particle;
        int panel;
        double side;      // 1 or -1, of the panel's normal
        double thickness; // m
        double friction;
    };
    struct Cell
    {
        int x;
        int y;
        int z;

        friend bool operator==(const Cell&, const Cell&) = default;
    };

    double travel(const System& system, const State& state) const;
    void sortParticles(const System& system, const State& state);
    void findNear(const System& system, const State& state, int panel, double reach);
    void consider(const System& system, const State& state, int particle, int panel);
    Cell cellOf(const Vec3& place) const;
    std::size_t bucketOf(const Cell& cell) const;

    double m_cell = 1.0;        // m, edge of a cell
    std::vector<Cell> m_cellOf; // [particles]
    std::vector<int> m_start;   // [buckets + 1] places in m_sorted
    std::vector<int> m_sorted;  // particles by bucket
    std::vector<Pair> m_pairs;
};

} // namespace ripstop
