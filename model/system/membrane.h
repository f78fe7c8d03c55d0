// What a panel that carries the pull of a fabric carries, where its corners are.
//
// A triangle of constant strain: the gradient of where the cloth has gone is the same all over it
// (panels.h), and so are its strain and its tension (laws/cloth_law.h). Damping of its material is
// Kelvin and Voigt's, of what its threads stretch by; what wrinkles take up has none.
#pragma once

#include "laws/panel_pull.h"
#include "system/system.h"

#include <array>

namespace ripstop {

// Where the warp and the weft have gone, each 1 long at rest.
using ClothAxes = std::array<Vec3, 2>;

//   ab, ac  m
inline ClothAxes axesOf(const Membrane& membrane, const Vec3& ab, const Vec3& ac)
{
    const auto& s = membrane.shape;
    return {Vec3(s[0] * ab + s[2] * ac), Vec3(s[1] * ab + s[3] * ac)};
}

inline Vec3 strainOf(const ClothAxes& axes) // as ClothLaw has it
{
    return {0.5 * (axes[0].squaredNorm() - 1.0), 0.5 * (axes[1].squaredNorm() - 1.0),
            axes[0].dot(axes[1])};
}

// d(warp, weft) of the barycentric coordinate of a corner, 1/m.
std::array<double, 2> gradient(const Membrane& membrane, int corner);

// That of its material, as stiff as this panel is of it, for a piece as long as a square of twice
// its area is.
PieceLaw lawOf(const System& system, const Membrane& membrane);

// At what it tears, likewise.
FabricTear tearOf(const System& system, const Membrane& membrane);

using Corners = std::array<Vec3, 3>; // m

template <typename Positions> // [particles] m
Corners cornersOf(const System& system, const Membrane& membrane, const Positions& position)
{
    const auto& [a, b, c] = system.panels[std::size_t(membrane.panel)].corner;
    return {position[std::size_t(a)], position[std::size_t(b)], position[std::size_t(c)]};
}

inline Vec3 strainAt(const Membrane& membrane, const Corners& corners)
{
    return strainOf(axesOf(membrane, corners[1] - corners[0], corners[2] - corners[0]));
}

// What a panel carries with its corners at these places; without what damping adds.
ClothTension tensionIn(const System& system, const Membrane& membrane, const Corners& corners);

// N, on its corners, likewise.
Corners pullsOnCorners(const System& system, const Membrane& membrane, const Corners& corners);

// N, on its corners, of its damping as it goes from one place to another within h, s.
Corners dampingPulls(const System& system, const Membrane& membrane, const Corners& from,
                     const Corners& to, double h);

// What it carries in the numbers that people read.
PanelPull pullOf(const System& system, const Membrane& membrane, const Corners& corners);

// 1, length over that at rest, of threads of this strain of Green's.
double stretchOf(double strain);

// What a strain stretches most, 1; 0 where it shortens all around.
double largestStrain(const Vec3& strain);

// By how much the warp or the weft of a panel is longer than at rest, the larger of both, 1; 0
// where neither is.
double threadElongation(const System& system, const Membrane& membrane, const Corners& corners);

// J, what the damping of a panel takes as it goes from one place to another within h, s.
double lossIn(const System& system, const Membrane& membrane, const Corners& from,
              const Corners& to, double h);

} // namespace ripstop
