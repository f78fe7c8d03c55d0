// What is seen at one moment: a frame and the colliders, by a camera, in a picture of some size.
//
// Everything that answers a question about the picture (what is under the cursor, what hides what)
// is asked with one of these. It refers to what it shows and is never kept.
#pragma once

#include "camera/camera.h"
#include "look/collider_geometry.h"
#include "look/look.h"
#include "simulation/frame.h"

#include <QRect>

#include <vector>

namespace ripstop {

// Pixels count from the top left.
struct CameraView
{
    const Frame& frame;
    const Look& look;
    const std::vector<ColliderBody>& colliders;
    const Camera& camera;
    double width;                    // of the picture, pixels
    double height;                   // pixels
    std::vector<QRect> covered = {}; // by what stands over the picture (overlaysOf()), pixels
};

} // namespace ripstop
