// Bends of fabric that are solved together with the panels that carry its pull, as the direct
// solver has them (direct_solver.h).
//
// A panel adds h^2 B A |G|^2 / 2 to the sum that is minimised (laws/bend.h). G comes of the normals
// of four panels and so of six corners, which the matrix of what pulls has no blocks for: with them
// a sheet would have three times as many. What the matrix gets is a bound in blocks that are there,
//
//     c |dN|^2 >= B A |dG|^2,     c = sum of B A (sum of shares) (own share),
//
// dN being the turn of each panel's normal, for which a side is no further than its own corners.
// addBeyond() takes it back and adds the bends themselves, by multiplication: conjugate gradients
// need no more, and have the bound to go by. Without a pull in the fabric they take as many more
// iterations as the fourth root of c h^2 / m; in fabric that pulls c is next to nothing.
//
// As a force that is known at the start of a substep, bending would bound the substep by
// l^2 sqrt(m / B) or so, l being the size of a cell: a sheet of 10^5 cells would need a hundred
// times as many as one of 10^3.
#pragma once

#include "constraints/triple.h"
#include "laws/fabric_bending.h"
#include "system/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

class FabricBends
{
public:
    // Takes over all panels that are solved so. Takes memory; nothing else does.
    //   row  [particles]  of the solver
    void prepare(const System& system, std::span<const std::uint32_t> row);

    // Whether these are still the panels of the system; their numbers may have changed.
    bool areOf(const System& system) const;

    bool empty() const { return m_panels.empty(); }

    // Reads the numbers of the panels, for substeps of which rods reach back h, s.
    void takeValues(const System& system, double h);

    // Before a substep.
    //   gone  [panels of the system]
    void start(std::span<const std::uint8_t> gone) { m_gone = gone; }

    // Where the rows are now; returns twice the energy there, kg m^2.
    double measure(std::span<const Row> position, ThreadPool& pool);
    double energy() const { return m_twice; } // that again

    // Adds the bound above to what a panel that carries a pull adds to the matrix, by its place in
    // System::membranes.
    void addBound(int membrane, TripleBlock& block) const;

    // What the bends pull with, to the right-hand side of the first rows, kg m.
    void addPulls(std::span<Row> to) const;

    // Adds to y what the matrix is beyond the bound, times x; returns x times that.
    //   x, y  [nodes]
    double addBeyond(std::span<const Row> x, std::span<Row> y, ThreadPool& pool);

    // Foresees the moments at the end of a move, before measure().
    void foresee(std::span<const Row> move, ThreadPool& pool);

    // After measure(): what of the move was foreseen, as a share of it.
    void settle(double share);

    // After measure(): twice the energy of what moments differ by from their law, kg m^2.
    double errors() const;

private:
    void addLoads(std::span<const PaddedVec3> loads, std::span<Row> to) const;

    std::vector<BentPanel> m_panels; // of rows, with stiffnesses of kg m^4: h^2 B A
    std::vector<int> m_placeOf;      // [membranes] in m_panels, or -1
    std::vector<double> m_bound;     // [panels] kg m^2, h^2 c above
    FabricBending m_bending;
    std::span<const std::uint8_t> m_gone;         // [panels of the system]
    std::vector<PaddedVec3> m_position, m_way;    // [rows] m
    std::vector<PaddedVec3> m_load, m_change;     // [panels] kg m, three of each
    std::vector<PaddedVec3> m_foreseen, m_before; // [panels] kg m^3, two of each: moments
    double m_twice = 0.0;                         // kg m^2
};

} // namespace ripstop
