// Makes a design of an instant of its run: what Adopt pose of the editor and run --final of the
// command line do. It looks at values only and may be called from any thread.
#pragma once

#include "scene/edit.h"
#include "simulation/frame.h"

#include <cstddef>

namespace ripstop {

struct PoseOptions
{
    bool rebindsLengths = false; // links have no strain in the new design
    bool keepsMotion = true;     // particles start as fast as they are; or at rest
};

struct Posed
{
    Scene scene;
    Edit edit; // that leads there
};

// The scene as the frame has left it: particles where they are, torn links and gone panels removed,
// what tears and cuts have doubled as rows of their own, what hands have pinned pinned, and
// colliders where hands have put them. The frame has to be one of a run of this scene.
Posed posed(Scene scene, const Frame& frame, const PoseOptions& options = {});

// Particles that a design of such a frame has more than its scene: the twins at tears and cuts.
std::size_t partedParticles(const Layout& layout);

} // namespace ripstop
