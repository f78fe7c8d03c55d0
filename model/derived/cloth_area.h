// How much cloth there is: the area of panels laid out flat, m^2.
// A canopy in folds, or a sail that is drawn slack, has more cloth than its shape shows. Panels
// that carry the pull know how they were cut (flat_panel.h). Where links do, the rest lengths of
// those along the sides of a panel say how large it was cut (Heron's formula); a panel without a
// link on each side, or with rest lengths that close no triangle, counts as it lies. All that asks
// for the area of fabric uses it; nothing in it fails.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <utility>
#include <vector>

namespace ripstop {

// Measures the panels of one part. It keeps references to the part and the scene, which must
// outlive it and stay as they are.
class ClothArea
{
public:
    // Corners that are in other parts are looked for in the scene, if one is given.
    explicit ClothArea(const Part& part, const Scene* scene = nullptr);

    double of(const Panel& panel) const; // m^2; 0 for a corner that is not found
    double whole() const;                // m^2, of all panels

    // m, as cut: the rest length of the first link from a to b; nothing where there is none, or
    // where panels carry the pull.
    std::optional<double> lengthOf(Id a, Id b) const;

private:
    std::optional<double> byLinks(const Panel& panel) const; // m^2
    const Particle* at(Id particle) const;

    using Side = std::pair<Id, Id>; // the lower id first
    const Part& m_part;
    const Scene* m_scene;
    // In ascending order of side; none where panels carry the pull.
    std::vector<std::pair<Side, double>> m_lengths;
};

} // namespace ripstop
