// Finds the element under the cursor.
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
    // Pins are always drawn. Who wants particles and nothing else gets those without a dot, too.
    bool particles(bool pinned) const
    {
        return wanted.particles && (drawn.particles || pinned || (!wanted.links && !wanted.panels));
    }
};

// What was found: an element of the frame, or a collider.
struct Picked
{
    enum class Sort { Nothing, Particle, Link, Panel, Collider };
    Sort sort = Sort::Nothing;
    Id id = noId;
    std::size_t element = 0;   // its place in the frame; not of a collider
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

// [particles] where they are in the picture.
std::vector<OnScreen> projected(const CameraView& view);

} // namespace ripstop
