// Stiffness of a link from what its material is, so that it does not depend on the mesh.
//
// A line or spar of axial stiffness EA (N) and length L is a spring of EA / L.
//
// A woven fabric is cells of p x q with threads along their sides and two diagonals (the bias). A
// thread that stands for a strip of width w (half a cell from either side, so half as much at an
// edge) is a spring of Y w / L. A shear by the angle g makes each diagonal, of length D, longer or
// shorter by p q g / D; two springs k then hold k (p q g / D)^2 of energy, and the fabric
// G g^2 p q / 2 with G = G t (N/m), so k = G D^2 / (2 p q): G w / D with w = D^3 / (2 p q).
//
// The diagonals also resist stretching. Along threads that are r times as long as their cells are
// wide they add G r^2, along the others G / r^2, and they tie both by G (C11 = Y1 + G r^2,
// C22 = Y2 + G / r^2, C12 = G). A strip that may become narrower has the modulus
// C11 - C12^2 / C22. That this be the measured E t along either, C11 = C22 = c and threads have
//     Y = c - G r^2, c = (E t + sqrt((E t)^2 + 4 G^2)) / 2.
// Cells that are so long that G r^2 is above c stay too stiff along their longer side, by what
// fabricModulus() says. The lattice is that of Provot 1995; sums of areas in place of counts go
// back to Van Gelder 1998.
#pragma once

#include "scene/items.h"

#include <optional>

namespace ripstop {

// What of a fabric a link stands for.
struct FabricStrip
{
    LinkRole role = LinkRole::Line;
    double width = 0.0;      // m
    double cellAspect = 1.0; // 1, r above; of threads
};
FabricStrip stripOf(const Link& link);

// N/m, of a link that does not set its own. Where the material has no physical number for this
// role, it is the material's `stiffness`. `restLength` in m.
double springStiffness(const Material& material, const FabricStrip& strip, double restLength);

// m/N, of a rod that does not set its own: the reciprocal of the stiffness that follows from the
// material, or the material's `compliance`.
double rodCompliance(const Material& material, const FabricStrip& strip, double restLength);

// The same of a link, whose factor its material's stiffness is times.
double springStiffness(const Material& material, const Link& link);
double rodCompliance(const Material& material, const Link& link);

// m, of either diagonal of a cell with sides p and q, m.
double biasWidth(double p, double q);

// 1, r above, of lengths of cells along a thread and across it. What is square is 1 to the bit,
// whatever rounding has made of its sides.
double aspectOfCells(double along, double across);

// N/m, what a fabric of cells with this aspect pulls with per strain along its threads: E t, or
// more where its diagonals alone are stiffer. Nothing where the material does not say.
std::optional<double> fabricModulus(const Material& material, double cellAspect);

} // namespace ripstop
