// Where the fabric of a part is: what has a size and two sides of a kite, on however long a line.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// m, of the particles that panels join, or of all where there are no panels. What is no number is
// left out.
std::vector<Vec3> fabricPlacesOf(const Part& part);

} // namespace ripstop
