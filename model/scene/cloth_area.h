// How much cloth there is: the area of panels laid out flat.
#pragma once

#include "scene/scene.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace ripstop {

// Of the panels of one part, which must outlive it. A canopy in folds, or a sail that is drawn
// slack, has more cloth than its shape shows: the rest lengths of the links along the sides of a
// panel say how large it was cut. A panel without a link on each side counts as it lies.
class ClothArea
{
public:
    explicit ClothArea(const Part& part);

    double of(const std::array<Id, 3>& corner) const; // m^2; 0 when one is of another part
    double whole() const;                             // m^2, of all panels

private:
    std::optional<double> lengthOf(Id a, Id b) const; // m, of the first link there

    using Side = std::pair<Id, Id>; // the lower id first
    const Part& m_part;
    std::vector<std::pair<Side, double>> m_lengths; // in ascending order of side
};

} // namespace ripstop
