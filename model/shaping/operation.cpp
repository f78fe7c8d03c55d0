// The rows of the shaping operations: names of choices and parameters first, then one function for
// each operation, which takes whole values from the parameters, calls the function of its own
// header (copy.h, weld.h, smooth.h and others), and turns an empty result into a sentence that
// says what to select. allOperations() puts the drawing operations behind them.
#include "shaping/operation.h"

#include "derived/panel_fabric.h"
#include "select/elements.h"
#include "shaping/copy.h"
#include "shaping/draw_operations.h"
#include "shaping/pin.h"
#include "shaping/smooth.h"
#include "shaping/split.h"
#include "shaping/spread_mass.h"
#include "shaping/weld.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace ripstop {
namespace {

using Choices = std::array<std::string_view, 3>;

constexpr Choices planes{"across_x", "across_y", "across_z"};
constexpr std::array<std::string_view, 4> planePlaces{"origin", "least_side", "middle",
                                                      "most_side"};
constexpr Choices axes{"x", "y", "z"};
constexpr std::array<std::string_view, 4> centres{"origin", "centre_of_mass", "median",
                                                  "middle_of_the_box"};
constexpr std::array<std::string_view, 4> waysToHold{"along_a_line", "in_a_plane", "in_place",
                                                     "not_at_all"};
constexpr std::array<std::string_view, 4> guideAxes{"x", "y", "z", "through_what_is_selected"};
constexpr std::array<std::string_view, 2> smoothings{"laplacian", "taubin"};
constexpr std::array<std::string_view, 2> borders{"stays", "along_itself"};
constexpr std::array<std::string_view, 2> lengthWays{"keep", "rebind"};
constexpr std::array<std::string_view, 2> weldWhich{"those_within_the_distance", "all_into_one"};
constexpr std::array<std::string_view, 2> weldPlaces{"in_their_middle", "at_the_first"};
constexpr std::array<std::string_view, 5> massWays{"each_particle_(kg)", "by_length_(kg/m)",
                                                   "by_area_(kg/m\u00b2)", "total_evenly_(kg)",
                                                   "total_as_it_is_spread_(kg)"};

// clang-format off
const std::array mirrorParameters{
    Parameter{"plane",     "",  0, 0, 2, true, "Direction that is turned round: x swaps left and right, y up and down, z front and back.", {}, planes},
    Parameter{"place",     "",  0, 0, 3, true, "Where the plane stands: at the origin, on the side of least or most x, y or z of what is selected, or in its middle.", {}, planePlaces},
    Parameter{"offset",    "m", 0, -1e4, 1e4, false, "Moves the plane along its direction."},
    Parameter{"tolerance", "m", 0.001, 0, 10, false, "Particles as near to the plane as this are put on it and belong to both halves."},
};
const std::array rowParameters{
    Parameter{"count", "",  3, 2, 1000, true, "How many there are in the end, with the one that is there."},
    Parameter{"x",     "m", 0.5, -1e4, 1e4, false, "Step from one to the next."},
    Parameter{"y",     "m", 0, -1e4, 1e4, false, "Step from one to the next."},
    Parameter{"z",     "m", 0, -1e4, 1e4, false, "Step from one to the next."},
};
const std::array ringParameters{
    Parameter{"count",  "",    6, 2, 1000, true, "How many there are in the end, with the one that is there."},
    Parameter{"axis",   "",    1, 0, 2, true, "Axis that the ring runs about.", {}, axes},
    Parameter{"centre", "",    0, 0, 3, true, "What the axis runs through.", {}, centres},
    Parameter{"angle",  "deg", 360, -360, 360, false, "From the first to the last; a full turn puts none on the first."},
};
const std::array weldParameters{
    Parameter{"which",    "",  0, 0, 1, true, "Which of the selected particles become one.", {}, weldWhich},
    Parameter{"distance", "m", 0.001, 0, 100, false, "Particles nearer to each other than this become one."},
    Parameter{"place",    "",  0, 0, 1, true, "Where the one particle is.", {}, weldPlaces},
};
const std::array massParameters{
    Parameter{"way",    "", 3, 0, 4, true, "What the amount is and how it is shared out. Links and panels count that lie among what is selected.", {}, massWays},
    Parameter{"amount", "", 0.1, 0, 1e6, false, "Mass in the unit that the line above says. It takes the place of the mass that is there."},
};
const std::array guideParameters{
    Parameter{"held", "", 0, 0, 3, true, "How each particle is held: free along a line or in a plane through its place, without friction; in its place; or not at all.", {}, waysToHold},
    Parameter{"axis", "", 0, 0, 3, true, "Direction of the line, or across the plane: an axis of the world, or the line or plane that fits what is selected best, as through two or three particles.", {}, guideAxes},
};
const std::array smoothParameters{
    Parameter{"method",     "", 1, 0, 1, true, "Taubin's keeps the size; the Laplacian one shrinks and draws tight.", {}, smoothings},
    Parameter{"factor",     "", 0.5, 0.01, 1, false, "Share of the way to the middle of its neighbours that a particle goes in one pass."},
    Parameter{"iterations", "", 10, 1, 1000, true, "More of them smooth longer waves."},
    Parameter{"border",     "", 0, 0, 1, true, "What the edge of fabric does. Ends of lines stay.", {}, borders},
    Parameter{"lengths",    "", 1, 0, 1, true, "Rest lengths of links: rebind them to the new distances, so that the design stays free of load, or keep them.", {}, lengthWays},
};
const std::array splitParameters{
    Parameter{"count", "",   2, 2, 1000, true, "Links that each one becomes."},
    Parameter{"mass",  "kg", 0.001, 0, 1e3, false, "Mass of each new particle, where the linear density of the material does not say it."},
};
// clang-format on

std::optional<Failure> nothingToMove(const Scene& scene, const std::vector<Id>& ids)
{
    if (!movableOf(scene, ids).isEmpty())
        return std::nullopt;
    return Failure{"Nothing is selected that has a place. Select particles, links, panels or a "
                   "part first."};
}

Result<Shaped> selecting(Copies copies)
{
    return Shaped{std::move(copies.edit), std::move(copies.ids)};
}

Result<Shaped> mirror(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const Movable movable = movableOf(scene, ids);
    if (const auto nothing = nothingToMove(scene, ids))
        return *nothing;
    Eigen::AlignedBox3d box;
    for (const Vec3& place : movable.position)
        box.extend(place);
    for (const MovableCollider& one : movable.colliders)
        box.extend(one.collider.position);
    const int axis = whole(values, "plane");
    const std::array<Vec3, 4> places{Vec3::Zero(), box.min(), box.center(), box.max()};
    Vec3 point = places[std::size_t(whole(values, "place"))];
    point[axis] += values.at("offset");
    Copies copies = mirrored(scene, ids, point, axis, values.at("tolerance"));
    if (copies.ids.empty())
        return Failure{"All that is selected lies on the plane and is its own mirror image. Choose "
                       "another plane or a smaller tolerance."};
    // both halves are selected: the design as it is now
    std::vector<Id> both = ids;
    both.insert(both.end(), copies.ids.begin(), copies.ids.end());
    return Shaped{std::move(copies.edit), std::move(both)};
}

Result<Shaped> row(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    if (const auto nothing = nothingToMove(scene, ids))
        return *nothing;
    const Vec3 step(values.at("x"), values.at("y"), values.at("z"));
    if (step.isZero())
        return Failure{"The step is 0, so that all would lie in one place. Give it a length."};
    return selecting(linearArray(scene, ids, whole(values, "count"), step));
}

Result<Shaped> ring(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    if (const auto nothing = nothingToMove(scene, ids))
        return *nothing;
    const double angle = values.at("angle") * std::numbers::pi / 180.0;
    if (angle == 0.0)
        return Failure{"The angle is 0, so that all would lie in one place. 360 is a full ring."};
    const int centre = whole(values, "centre");
    const std::array<Pivot, 3> pivots{Pivot::Mass, Pivot::Median, Pivot::Box};
    const Vec3 pivot = centre == 0
                           ? Vec3(Vec3::Zero())
                           : pivotOf(scene, movableOf(scene, ids), pivots[std::size_t(centre - 1)]);
    return selecting(radialArray(scene, ids, whole(values, "count"), pivot,
                                 Vec3::Unit(whole(values, "axis")), angle));
}

Result<Shaped> weld(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const auto at = WeldAt(whole(values, "place"));
    Weld weld = whole(values, "which") == 1 ? welded(scene, ids, at)
                                            : weldedWithin(scene, ids, values.at("distance"), at);
    if (weld.merged == 0)
        return Failure{"No two of the selected particles are that near to each other. Select more, "
                       "or weld over a longer distance."};
    return Shaped{std::move(weld.edit), std::move(weld.kept)};
}

Result<Shaped> mass(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    Result<Edit> edit = massSpread(scene, ids, MassBy(whole(values, "way")), values.at("amount"));
    if (!edit)
        return edit.failure();
    return Shaped{std::move(*edit)};
}

Result<Shaped> guide(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    if (particlesOf(scene, ids).empty())
        return Failure{"No particle is selected. Select particles, links or panels first."};
    const int held = whole(values, "held");
    if (held == 2)
        return Shaped{pinning(scene, ids, true)};
    if (held == 3)
        return Shaped{guiding(scene, ids, Guide::None, Vec3::UnitX())};
    const Guide guide = held == 0 ? Guide::Line : Guide::Plane;
    const int axis = whole(values, "axis");
    if (axis < 3)
        return Shaped{guiding(scene, ids, guide, Vec3::Unit(axis))};
    const Result<Vec3> through = axisThrough(scene, ids, guide);
    if (!through)
        return through.failure();
    return Shaped{guiding(scene, ids, guide, *through)};
}

Result<Shaped> smooth(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const SmoothHow how{Smoothing(whole(values, "method")), values.at("factor"),
                        whole(values, "iterations"), Border(whole(values, "border"))};
    Edit edit = smoothed(scene, ids, how, RestLengths(whole(values, "lengths")));
    if (edit.changes.empty())
        return Failure{"Nothing is selected that could be smoothed. Select fabric or lines, with "
                       "more than their border and ends."};
    return Shaped{std::move(edit)};
}

Result<Shaped> splitLinks(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    LinksSplit split = linksSplit(scene, ids, whole(values, "count"), values.at("mass"));
    if (split.links == 0)
        return Failure{"No link is selected. Select the links that are to be split."};
    return Shaped{std::move(split.edit), std::move(split.made)};
}

Result<Shaped> threadsToPanels(const Scene& scene, const std::vector<Id>& ids, const Parameters&)
{
    const std::vector<Id> elements = elementsOf(scene, ids);
    if (elements.empty())
        return Failure{"Nothing is selected. Select fabric or its part first."};
    const auto isSelected = [&](const auto& row) {
        return std::ranges::binary_search(elements, row.id);
    };
    std::vector<Id> parts;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (std::ranges::any_of(part.particles, isSelected)
            || std::ranges::any_of(part.links, isSelected)
            || std::ranges::any_of(part.panels, isSelected))
            parts.push_back(id);
    });
    Result<PanelFabric> made = carriedByPanels(scene, parts);
    if (!made)
        return made.failure();
    return Shaped{std::move(made->edit), std::move(made->parts)};
}

// clang-format off
const std::array shapingOperations{
    Operation{"mirror", "Mirror", "Adds the other half of what is selected. What lies on the plane belongs to both halves, panels are turned round, and copies join the groups of their originals.", mirrorParameters, mirror},
    Operation{"row",    "Array in a row", "Copies what is selected again and again, each copy a step further.", rowParameters, row},
    Operation{"ring",   "Array in a ring", "Copies what is selected around an axis: gores of a canopy, spokes.", ringParameters, ring},
    Operation{"weld",   "Weld", "Makes one particle of several, with the mass of all. Links and panels that fall together become one.", weldParameters, weld},
    Operation{"guide",  "Guide", "Holds the selected particles: a ring on a rail is free along a line, a foot on a floor in a plane. The guide takes up all force across it and gives no friction.", guideParameters, guide},
    Operation{"smooth", "Smooth", "Takes bumps and creases out of the selected fabric and lines.", smoothParameters, smooth},
    Operation{"mass",   "Set mass", "Gives mass to the selected particles.", massParameters, mass},
    Operation{"split",  "Split links", "Makes several links of each, with new particles between them. The line stays as long, as stiff and as strong; panels beside it are split too.", splitParameters, splitLinks},
    Operation{"panels", "Threads to panels", "Has the panels of the selected parts carry the pull of their fabric, with warp, weft, shear and wrinkles, in place of threads. Lines, spars and hems stay, and the panels keep the cut that the threads had.", {}, threadsToPanels},
};
// clang-format on

} // namespace

std::span<const Operation> allOperations()
{
    static const std::vector<Operation> all = [] {
        std::vector<Operation> both(shapingOperations.begin(), shapingOperations.end());
        both.insert(both.end(), drawOperations().begin(), drawOperations().end());
        return both;
    }();
    return all;
}

const Operation* findOperation(std::string_view name)
{
    for (const Operation& operation : allOperations())
        if (operation.name == name)
            return &operation;
    return nullptr;
}

} // namespace ripstop
