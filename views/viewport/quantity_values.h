// The quantities that the view can be coloured by, taken from a frame.
#pragma once

#include "run/frame.h"

#include <string_view>
#include <vector>

namespace ripstop {

enum class ColorBy { Material, Strain, Tension, Speed, PanelLoad };

// One quantity of one frame. Only the arrays that it has are filled; the others are empty.
struct QuantityValues
{
    std::vector<double> particle; // [particles]
    std::vector<double> link;     // [links]
    std::vector<double> panel;    // [panels]
};

// Strain (1) and tension (N) belong to links; a particle gets the largest of the links that end
// there. Speed (m/s) belongs to particles. Panel load is per area (N/m^2), so that it does not
// depend on how fine the mesh is. Torn links and panels that are gone read 0.
QuantityValues valuesOf(const Frame& frame, ColorBy colorBy);

// Values that lie on either side of zero with a different meaning: pulled or pressed.
constexpr bool isSigned(ColorBy colorBy)
{
    return colorBy == ColorBy::Strain || colorBy == ColorBy::Tension;
}

} // namespace ripstop
