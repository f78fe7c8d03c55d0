#pragma once

#include "run/simulation.h"
#include "scene/scene.h"

namespace ripstop {

// The scene as the simulation has left it: particles where they are and as fast as they are, torn
// links and gone panels removed, and what tears have doubled as rows of their own.
Scene finalScene(Scene scene, const Simulation& simulation);

} // namespace ripstop
