// A hand that drags what controls move: it turns a way in the picture into values of controls.
//
// The axes of the controls, as the picture shows them, are the columns of a small matrix; the
// values are the damped least-squares solution, so that of several controls each takes its share
// and an axis that points at the eye takes nothing. It is a plain value that a drag keeps.
#pragma once

#include "camera/camera.h"
#include "scene/scene.h"

#include <utility>
#include <vector>

namespace ripstop {

class Hand
{
public:
    // Grips the element or collider, through all controls that have it as a target. A hand that
    // grips nothing has no controls.
    Hand(const Scene& scene, Id id, const Vec3& place);

    bool isEmpty() const { return m_controls.empty(); }
    const std::vector<Id>& controls() const { return m_controls; }

    // How far each control has to go for what is gripped to follow the cursor, m: the smallest
    // values that do. Along an axis that points at the eye nothing can be dragged.
    //   dx, dy  pixels, y down, since it was gripped
    std::vector<double> pull(const Camera& camera, double pictureHeight, double dx,
                             double dy) const;

private:
    Vec3 m_place; // m, where it was gripped
    std::vector<Id> m_controls;
    std::vector<Vec3> m_axes; // unit
};

} // namespace ripstop
