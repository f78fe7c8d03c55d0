// What the threads of a mesh pull with as a fabric, beside what their material says.
//
// Under an even strain each link of stiffness k and length L that lies at the angle a in a panel of
// the area A adds W = k L^2 / A to its stiffness in that direction (shared with the panel on its
// other side), so that with c = cos(a - t), s = sin(a - t) about lines at the angle t
//
//     C11 = sum W c^4,  C22 = sum W s^4,  C12 = G = sum W s^2 c^2 = sum W (1 - cos 4 (a - t)) / 8.
//
// Warp and weft run where G is least: 4 t is the argument of sum W exp(4 i a). In a grid of quads
// that is along the threads, and G is the shear stiffness of the biases (link_stiffness.h). Three
// families of threads, as in triangles, resist shear with 3/8 of what they pull with, whatever the
// material says, and so do, in part, threads of a grid whose lines zigzag. Particles that give way
// unevenly make it softer: these are upper bounds.
#pragma once

#include "scene/items.h"

#include <map>

namespace ripstop {

struct LatticeStiffness
{
    double along = 0.0; // N/m, of a strip along warp or weft that may become narrower
    double shear = 0.0; // N/m
};

// Means over the panels of a part beside threads of each material that has a membrane stiffness.
// Panels beside links with a stiffness of their own, or none that is finite, are passed over.
std::map<Id, LatticeStiffness> latticeStiffness(const Part& part,
                                                const std::map<Id, const Material*>& materials);

} // namespace ripstop
