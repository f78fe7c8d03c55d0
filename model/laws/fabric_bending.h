// Bending of all panels of a fabric (bend.h) where its corners are: normals, what the gradients of
// the normals pull with, and how that changes where corners go.
//
// It takes three passes over the panels, as each needs of those beside it what the pass before has
// found: normals N = X / |X| with X = (b - a) x (c - a), then moments B A G, and then loads. A
// moment M on the normal is Q = (M - N (N . M)) / |X| on X, and with it Q x e on a corner, e being
// the side across from it. What a pass gives a panel depends on no other panel's result of that
// pass: threads share the panels, and come to the same bits.
#pragma once

#include "laws/bend.h"
#include "parallel/thread_pool.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

// Whether the fabric among the bends is better solved together with what carries its pull than left
// as a force: all of it has panels that carry a pull, and it bends too stiffly for whole time
// steps.
//   carries   [panels of the net] whether they carry a pull
//   mass      [particles]  kg, or 0 of what is pinned
//   timeStep  s
bool isSolvedWithPull(const BendsAndPanels& bends, std::span<const std::uint8_t> carries,
                      std::span<const double> mass, double timeStep);

class FabricBending
{
public:
    // Take memory, the second for fillChange(); nothing else does.
    void size(std::size_t panels);
    void sizeChange();

    // Fills what follows, and the loads, for positions that the corners of panels are places in.
    //   gone      [panels of the system]
    //   position  m
    //   load      [panels] N, three of each: of corners
    void fill(std::span<const BentPanel> panels, std::span<const std::uint8_t> gone,
              const PaddedVec3* position, PaddedVec3* load, ThreadPool& pool);

    // After fill(), for the same positions: how it all changes along ways of the corners, m, to the
    // first order, but that what pulls does not turn with the panels (Gauss and Newton). So the
    // matrix of it is symmetric, and positive for minus the loads.
    //   less  [panels] N m, or empty: a stiffness against the turns of normals that is taken off
    void fillChange(std::span<const BentPanel> panels, std::span<const double> less,
                    const PaddedVec3* position, const PaddedVec3* way, PaddedVec3* load,
                    ThreadPool& pool);

    // J, of all panels: half of the square of B A G over B A.
    double energy(std::span<const BentPanel> panels) const;

    // What fill() filled.
    std::span<const PaddedVec3> normals() const { return m_normal; } // 1
    std::span<const double> perArea() const
    {
        return m_perArea;
    } // 1/m^2, of twice the area; less
      // than 0 where it counts as more
      // than it is, 0 of what is gone
    std::span<const PaddedVec3> bending() const { return m_bending; } // N m^2, two of each: B A G

    // How fillChange() changed that.
    std::span<const PaddedVec3> bendingChange() const { return m_bendingChange; }

private:
    std::vector<PaddedVec3> m_normal, m_bending;
    std::vector<double> m_perArea;
    std::vector<PaddedVec3> m_turn, m_bendingChange; // of the last fillChange()
    bool m_torn = false;                             // some panel is gone
};

} // namespace ripstop
