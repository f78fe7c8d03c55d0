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
// The diagonals also resist stretching. In square cells they add G to the stiffness along each
// thread and across (C11 = Y + G, C12 = G), and a strip that may become narrower has the modulus
// C11 - C12^2 / C11. That this be the measured E t, threads have
//     Y = c - G, c = (E t + sqrt((E t)^2 + 4 G^2)) / 2.
// The lattice is that of Provot 1995; sums of areas in place of counts go back to Van Gelder 1998.
#pragma once

#include "scene/items.h"

namespace ripstop {

// N/m, of a link that does not set its own. Where the material has no physical number for this
// role, it is the material's `stiffness`. `width` and `restLength` in m.
double springStiffness(const Material& material, LinkRole role, double width, double restLength);

// m/N, of a rod that does not set its own: the reciprocal of the stiffness that follows from the
// material, or the material's `compliance`.
double rodCompliance(const Material& material, LinkRole role, double width, double restLength);

// The same of a link, whose factor its material's stiffness is times.
double springStiffness(const Material& material, const Link& link);
double rodCompliance(const Material& material, const Link& link);

// m, of either diagonal of a cell with sides p and q, m.
double biasWidth(double p, double q);

} // namespace ripstop
