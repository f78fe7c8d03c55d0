// All that the layers need to know to draw one instant.
//
// The stage puts it together in prepare() and hands it to the layers; it refers to what the stage,
// the document and the frame hold, and lives for that one call. Layers that need something later
// take a copy of that.
#pragma once

#include "look/color_map.h"
#include "look/look.h"
#include "look/quantity_values.h"
#include "look/theme.h"

#include <Eigen/Geometry>

#include <limits>

class vtkPoints;

namespace ripstop {

struct ColliderBody;
struct Limb;   // look/figure.h
struct Person; // look/people.h

struct Picture
{
    const Scene& scene;
    const Frame& frame;
    const Look& look;
    const Theme& theme;
    vtkPoints* points; // the positions of the frame, in place
    const std::vector<Id>& selected;
    const std::vector<ColliderBody>& colliders;
    const std::vector<Person>& people;           // none where they are not to be seen
    const std::vector<std::vector<Limb>>& limbs; // [people]

    ColorBy colorBy = ColorBy::Material;
    const QuantityValues& values; // empty when coloured by material
    const ColorMap& colors;
    ValueRange range;

    Eigen::AlignedBox3d bounds; // m, of what is shown, without the ground
    double pixelRatio = 1.0;    // device pixels per pixel
    bool isMeshShown = false;   // the links that stand for fabric, on fabric

    const Layout& layout() const { return *frame.layout; }
    Color colorOf(double value) const // grey where nothing has the quantity
    {
        return colors.at(values.isKnown ? value : std::numeric_limits<double>::quiet_NaN(), range);
    }
};

} // namespace ripstop
