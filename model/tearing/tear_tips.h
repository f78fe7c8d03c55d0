// Where a tear or a notch ends in fabric, and how hard it is driven on.
//
// A tip is a particle on an edge of the fabric around which its panels fill far more than half a
// turn: the end of a slit, the corner of a hole. A tear that goes on by a length dl lets go of the
// energy G dl that the fabric holds; G is called its driving force, J/m. It follows from where the
// particles are, without tearing anything (Eshelby 1951; Steinmann 2000; Mueller and Maugin 2002,
// On material forces and finite element discretizations): were the tip and the particles beside it
// set on by d in the flat fabric, and carried along where it is now, the energy of the panels
// around them would change by
//
//     g d,  g = sum of A (W grad q - (F - Q)^T F S grad q)
//
// A is the area of a panel, W and S its energy and tension (laws/cloth_law.h), F the gradient of
// where it has gone, Q the turn of the fabric at the tip, and q is 1 at these particles and 0 at
// all others. G is the length of g. This is Rice's J integral (1968) over the ring of panels around
// them. It holds for each law, and hangs on size and shape of the panels far less than the pull of
// a panel at a tip does. Panels of constant strain are too stiff for what is at a tip: G is that of
// a slit whose ends are half a panel less far. The load at which a tear goes on is 11 % too large
// with three panels in half a slit, and 4 % with seven (linear finite elements beside it).
#pragma once

#include "system/system.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ripstop {

class TearTips
{
public:
    struct Driven
    {
        int membrane; // of the panels at the tip the one that pulls most
        double ratio; // 1, of the load to the one at which the tear goes on: the root of G over
                      // what the fabric bears
    };

    // Finds tips and rings anew where the fabric is another one or has torn since.
    void look(const System& system, const State& state);

    // Whether a panel of fabric with a tear energy is in the ring of a tip, where pulls hang on the
    // size of panels.
    bool isNear(const System& system, int panel) const;

    // Those that are driven harder than their fabric bears, the hardest driven first; of tips with
    // a panel in common the first alone.
    const std::vector<Driven>& overdriven(const System& system, const State& state);

private:
    using Plane = Eigen::Vector2d;
    using Turn = Eigen::Matrix2d;

    struct RingPanel
    {
        int membrane;
        Turn turn;   // from the frame of the panel to that of the ring
        Plane slope; // 1/m, grad q in the frame of the ring
        bool atTip;
    };
    using Tip = std::vector<RingPanel>;       // the ring around it
    using FlatCorners = std::array<Plane, 3>; // m

    // A panel in the plane in which those around a tip are laid out.
    struct Placed
    {
        int panel;
        Turn turn; // from the frame of the panel
        FlatCorners at;
    };

    static Placed layBeside(int panel, const FlatCorners& flat, std::size_t a, std::size_t b,
                            const Plane& placeA, const Plane& placeB, const Plane& other);
    FlatCorners flatOf(const System& system, int panel) const;
    std::vector<int> panelsHere(const System& system, const State& state, int particle) const;
    std::vector<Placed> laidOut(const System& system, std::vector<int> panels, int particle) const;
    bool isTip(const System& system, const State& state, int particle) const;
    void addTip(const System& system, const State& state, int particle);
    double forceAt(const System& system, const State& state, const Tip& tip) const;
    int weakestOf(const System& system, const State& state, const Tip& tip) const;

    std::uint64_t m_serial = 0;
    std::vector<std::uint8_t> m_gone; // [panels] as it was then
    bool m_looks = false;             // some fabric has a tear energy
    std::vector<int> m_membrane;      // [panels] or -1
    std::vector<Tip> m_tips;
    std::vector<std::uint8_t> m_near; // [panels], or empty
    std::vector<Driven> m_driven;
};

} // namespace ripstop
