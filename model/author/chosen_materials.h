// The parameters of a built part as it stands: of what its cloth, spars and lines are by now.
//
// A builder asks for materials by name. One that was exchanged for another of the library since
// (materials/neighbours.h) stays when the part is built again, and so the form of its parameters
// has to say what is there, not what there was.
#pragma once

#include "builders/builder.h"
#include "scene/scene.h"

namespace ripstop {

// Of a part with a builder. A choice follows where all that it was the material of is of another
// one that the builder offers.
Parameters parametersNow(const Scene& scene, Id part);

} // namespace ripstop
