// Panels on the same corners stand next to each other once all are sorted by their corners.
#include "check/fabric_check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

struct Corners
{
    std::array<int, 3> particles; // ascending
    std::size_t number;           // of the panel, over all parts

    friend auto operator<=>(const Corners&, const Corners&) = default;
};

// Panels whose corners dangle are left to others.
std::vector<Corners> cornersOf(const Scene& scene, const ElementIndex& index)
{
    std::vector<Corners> all;
    std::size_t number = 0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& panel : part.panels) {
            Corners corners{
                {index.particle(panel.a), index.particle(panel.b), index.particle(panel.c)},
                number++};
            std::ranges::sort(corners.particles);
            if (corners.particles[0] >= 0)
                all.push_back(corners);
        }
    });
    return all;
}

// The numbers of those that lie on the corners of an earlier one, each with that, ascending.
std::vector<std::pair<std::size_t, std::size_t>> laidTwice(std::vector<Corners> all)
{
    std::ranges::sort(all);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 1, first = 0; i < all.size(); ++i)
        if (all[i].particles == all[first].particles)
            found.emplace_back(all[i].number, all[first].number);
        else
            first = i;
    std::ranges::sort(found);
    return found;
}

void reportTwice(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    const auto twice = laidTwice(cornersOf(scene, index));
    if (twice.empty())
        return;
    std::vector<std::pair<Id, const Part*>> panels;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& panel : part.panels)
            panels.emplace_back(panel.id, &part);
    });
    for (const auto& [second, first] : twice) {
        const auto& [id, part] = panels[second];
        add("twofold", Severity::Warning,
            Message("%1 of %2 lies on the same three corners as panel %3: both pull and catch the "
                    "wind there. Remove one.",
                    subjectOf(Kind::Panel, id), part->name, std::uint32_t(panels[first].first)),
            id);
    }
}

void reportHeavy(const Scene& scene, const AddFinding& add)
{
    constexpr double heaviest = 10.0; // kg/m^2, more than a millimetre of steel
    for (const Entry& entry : scene.items) {
        const Material* const material = std::get_if<Material>(&entry.item);
        if (!material || !material->arealDensity || !(*material->arealDensity > heaviest))
            continue;
        const Message density = Message::number("%.4g", *material->arealDensity);
        add("heavy", Severity::Warning,
            Message("Material %1 has an areal density of %2 kg/m^2, and fabrics have 0.02 to 2: "
                    "where grams are meant, type %2 g/m^2, which is %3 kg/m^2.",
                    material->name, density,
                    Message::number("%.4g", 1e-3 * *material->arealDensity)),
            entry.id);
    }
}

} // namespace

void checkFabric(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    reportTwice(scene, index, add);
    reportHeavy(scene, add);
}

} // namespace ripstop
