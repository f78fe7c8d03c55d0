// Finds the element under the cursor.
#pragma once

#include "run/frame.h"
#include "viewport/collider_geometry.h"
#include "viewport/look.h"
#include "viewport/turntable.h"

namespace ripstop {

// What can be picked is what can be seen.
struct Pickable
{
    bool particles = true;
    bool links = true;
    bool panels = true;
};

struct Picker
{
    const Frame& frame;
    const Look& look;
    const std::vector<ColliderBody>& colliders;
    const Turntable& camera;
    double width;  // of the picture, pixels
    double height; // pixels
    Pickable pickable;

    // The id of the particle within a few pixels of (x, y), else of the link, else of the panel,
    // else of the collider that the cursor is on. What lies behind a panel or a collider is hidden
    // by it. Pixels count from the top left; noId when there is nothing.
    Id at(double x, double y) const;
};

} // namespace ripstop
