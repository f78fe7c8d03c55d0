#pragma once

#include "run/simulation.h"
#include "scene/scene.h"

namespace ripstop {

// The scene as the simulation has left it: particles where they are and as fast as they are, torn
// links and gone panels removed.
Scene finalScene(Scene scene, const Simulation& simulation);

} // namespace ripstop
