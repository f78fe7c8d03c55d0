// Finds the element under the cursor.
//
// It answers from the same arrays that are drawn, and by exact rays: an element is found only where
// it can be seen. One question projects all particles, so it is asked for clicks and, at intervals,
// for what the mouse is on. A Picker refers to the picture of now and is never kept.
#pragma once

#include "camera/camera_projection.h"

#include <vector>

namespace ripstop {

struct ElementKinds
{
    bool particles = true;
    bool links = true;
    bool panels = true;
};

// What can be taken is what can be seen and is wanted.
struct Pickable
{
    ElementKinds drawn;
    ElementKinds wanted;

    bool links() const { return wanted.links && drawn.links; }
    bool panels() const { return wanted.panels && drawn.panels; }
    // Also where particles have no dots: the corners of fabric are there to be seen.
    bool particles() const { return wanted.particles; }
    // Pins, and what nothing holds, are always drawn.
    bool hasDot(bool pinned, bool loose) const { return drawn.particles || pinned || loose; }
};

// What was found: an element of the frame, or a collider.
struct Picked
{
    enum class Sort { Nothing, Particle, Link, Panel, Collider };
    Sort sort = Sort::Nothing;
    Id id = noId;
    std::size_t element = 0;   // its index in the arrays of the frame; unused for a collider
    Vec3 place = Vec3::Zero(); // m, on it
};

struct Picker
{
    CameraView view;
    Pickable pickable;

    // The id of the particle within a few pixels of (x, y), else of the link, else of the panel,
    // else of the collider that the cursor is on. What lies behind a panel or a collider is hidden
    // by it, exactly. Pixels count from the top left; noId when there is nothing.
    Id at(double x, double y) const { return under(x, y).id; }
    Picked under(double x, double y) const;
};

// Where all particles are in the picture, [particles].
std::vector<OnScreen> projected(const CameraView& view);

} // namespace ripstop
