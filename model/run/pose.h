// Makes a design of an instant of its run.
#pragma once

#include "run/frame.h"
#include "scene/edit.h"

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

} // namespace ripstop
