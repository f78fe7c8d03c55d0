// Bends of spars whose rods are solved together, as the direct solver has them (direct_solver.h).
//
// A bend with the turn y (laws/bend.h) adds h^2 k (|y| - y_0)^2 / 2 to the sum that is minimised,
// y_0 being the turn that the spar is built with. Its block of the matrix is J^T S J (Gauss and
// Newton), J being how y changes with the corners and S how the moment does with y: the slope along
// y, and across it what the turn pulls with, but not less than 0. What is left out is that J turns
// with the links. A solve is by so much nearer to exact as the cosine of the angle of a bend is to
// 1, since J takes no part along the links; the pull of the rods has what the rest would add. The
// matrix stays positive.
//
// As a force that is known at the start of a substep, bending would bound the substep by l^2
// sqrt(m / EI) or so, l and m being the length and the mass of a link; and a spar that is bent far
// would not come to rest (laws/bend.h).
#pragma once

#include "constraints/triple.h"
#include "parallel/simd_pack.h"
#include "system/system.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ripstop {

struct SparBend : Triple
{
    std::size_t bend = 0; // in BendLists::withRods()
    std::array<int, 2> rod{};
    double stiffness = 0.0;       // kg, h^2 k
    double rest = 0.0;            // m, y_0
    Vec3 turn = Vec3::Zero();     // m
    std::array<Mat3, 3> slope{};  // 1, J, symmetric, by corner
    Vec3 moment = Vec3::Zero();   // kg m, of the law where the particles are now
    Vec3 foreseen = Vec3::Zero(); // kg m, that the linear system gave
    Vec3 before = Vec3::Zero();   // kg m, of the law where the move began
};

class SparBends
{
public:
    // Takes over all bends that are solved with rods. Takes memory; nothing else does.
    //   row  [particles]  of the solver
    void prepare(const System& system, std::span<const std::uint32_t> row);

    // Whether these are still the bends of the system; their stiffness may have changed.
    bool areOf(const System& system) const;

    void numberPairs(std::size_t nodes, std::vector<std::pair<int, int>>& pairs);

    bool empty() const { return m_bends.empty(); }
    std::span<const SparBend> bends() const { return m_bends; }

    // Before a substep of which rods reach back h, s.
    //   torn  [rods]
    void start(const System& system, std::span<const std::uint8_t> torn, double h);

    // Where the rows are now; returns twice the energy there, kg m^2.
    double measure(std::span<const Row> position);
    double energy() const; // that again

    TripleBlock block(const SparBend& bend) const;

    // Foresees the moments at the end of a move, before measure().
    void foresee(std::span<const Row> move);

    // After measure(): what of the move was foreseen, as a share of it.
    void settle(double share);

    // After measure(): twice the energy of what moments differ by from their law, kg m^2.
    double errors() const;

private:
    std::vector<Bend> m_laws;                  // of the system
    std::vector<SparBend> m_bends;             // those that have something to move
    std::vector<std::array<int, 3>> m_corners; // of all, by which they are known
};

} // namespace ripstop
