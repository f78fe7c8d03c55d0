// Fabric and lines that keep apart: particles against panels.
//
// A particle keeps at least the thickness from panels that it does not belong to, on the side where
// it is. Who may meet whom is found once in each time step, with a grid of cells that particles are
// sorted into; each substep then goes through the pairs, in the order of the panels, and
//     moves   both along the normal until they are a thickness apart, by their inverse masses
//     stops   what of their relative velocity closes the gap; Coulomb friction takes from the rest
// as the first pass of Bridson, Fedkiw and Anderson 2002 does. What starts closer keeps the
// distance that it starts with where it lies on a panel, and nine tenths of it where it lies
// beside, as the neighbours of a particle in a fine mesh do. Fabric that lies on fabric keeps all
// of it, as the panels that it comes to later hold it a thickness away: with less it would slide up
// steps. Where two panels cross with no particle near, nothing is found.
//
// The Stepper has one, for systems with a fabricLayer, and calls it from the thread that steps.
#pragma once

#include "system/system.h"

#include <cstdint>
#include <vector>

namespace ripstop {

class FabricContact
{
public:
    // Finds the pairs that may touch within the next time step; to be called once before it.
    void find(const System& system, const State& state);

    // Pushes the pairs apart, after the rods of each substep: changes positions, velocities and
    // drift.
    void resolve(const System& system, State& state) const;

private:
    struct Pair
    {
        int particle;
        int panel;
        double side;      // 1 or -1, of the panel's normal
        double thickness; // m
        double friction;  // 1
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
