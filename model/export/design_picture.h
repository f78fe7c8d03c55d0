// A small picture of a design, drawn without a window, a display or a graphics card: what desktops
// show for scene files.
//
// Panels are flat and lit from beside the eye, the nearest ones hide the others; lines and spars
// are drawn where they are seen. The fabric fills the picture, and long lines leave it. What the
// author has hidden is not drawn, nor are colliders. The background is transparent.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ripstop {

struct RasterPicture
{
    int size = 0;                     // pixels, of each side
    std::vector<std::uint8_t> pixels; // [4 size size] red, green, blue, alpha, from the top

    friend bool operator==(const RasterPicture&, const RasterPicture&) = default;
};

RasterPicture pictureOf(const Scene& scene, int size); // pixels, 1 to 4096

Result<std::string> pngBytes(const RasterPicture& picture);

} // namespace ripstop
