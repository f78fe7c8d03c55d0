// How thick a line or a spar is, for those who draw it or make a mesh of it.
#pragma once

#include "scene/items.h"

namespace ripstop {

// m, of round links of a material: its diameter. A spar whose diameter nobody has said is the tube
// of thin wall that has its stiffnesses, with EI = EA r^2 / 2; a line is as thick as a solid one of
// its weight. 0 where nothing tells, as of a hem.
double linkThickness(const Material& material);

} // namespace ripstop
