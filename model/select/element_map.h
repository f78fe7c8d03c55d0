// A number of many elements as a formula of where they lie: a worn strip, a reinforced corner, a
// grain that fans out, a picture.
//
//     x, y, z   m, the middle of the element in the scene
//     u, v      texture of the middle, 0 to 1 across and up the picture on the fabric
//     value     what it has now; a link without a number of its own, what its material gives it
//     grey      of the picture at u, v: 0 is black and 1 white; where no element has a texture, of
//               the picture laid over all of them as they lie, along the two longer sides of the
//               box around them
//
// A grain is an angle from the way in which the picture on the fabric goes up, as the brush paints
// it and as the colours tell it (flat_panel.h), so that one number is one direction on the cloth;
// `value` is such an angle too, from -90 to 90 degrees.
//
// Functions are those of formulas (derived/formula.h); numbers have no units and are SI. So
// "value * (1 - 0.5 * exp(-(x^2 + z^2) / 0.04))" on tear limits is a place of half the strength.
#pragma once

#include "base/result.h"
#include "scene/edit.h"
#include "shapes/height_grid.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct MappedNumbers
{
    Edit edit;
    std::size_t count = 0; // elements
    double least = 0.0;    // of the new numbers
    double most = 0.0;
};

// `property` is a number of particles, links or panels, and `elements` are of that kind. Fails,
// with the element that it is about, where the formula gives a number that the property cannot be,
// and where `value` is asked for and there is none.
Result<MappedNumbers> mapped(const Scene& scene, const Property& property,
                             const std::vector<Id>& elements, std::string_view formula,
                             const HeightGrid* picture = nullptr);

// The same with the picture in this file, PNG or PGM, or without one where it is empty.
Result<MappedNumbers> mappedByPicture(const Scene& scene, const Property& property,
                                      const std::vector<Id>& elements, std::string_view formula,
                                      const std::filesystem::path& picture);

// A formula to begin with: half of what there is in the middle of those elements that have the
// number, and ever less of a change away from it. Empty where there are none.
std::string fadingSpot(const Scene& scene, const Property& property,
                       const std::vector<Id>& elements);

// The numbers of elements of this kind that can be mapped.
std::vector<const Property*> mappableNumbers(Kind kind);

} // namespace ripstop
