// Patches: second layers of cloth where a craft is pulled at a point.
//
// Where a nose, a tip, a line or a bridle pulls, cloth is doubled with a round piece of a heavier
// one. A patch covers the panels whose middle lies within its radius of a point, whole panels as
// the mesh has them, and adds its weight to their corners. Both layers are stretched alike, so that
// they pull as springs side by side, and the first of them to break is the one that can be
// stretched less:
//
//     E = E1 + E2,   N = E min(N1 / E1, N2 / E2),
//
// for warp and weft each, the patch being cut along the cloth below it. A patch of the same cloth
// doubles both. Cloth that is ideal has none.
#pragma once

#include "builders/craft_materials.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

// The rows of a builder that has patches, of what `choices` has; radius in m.
constexpr std::array<Parameter, 2> patchParameters(std::span<const std::string_view> choices,
                                                   double radius)
{
    return {{{"patch",
              "",
              0,
              0,
              double(choices.size() - 1),
              true,
              "Cloth that doubles real cloth where it is pulled at a point: at nose, tips and "
              "corners, and where lines are tied.",
              "Reinforcement",
              choices,
              {},
              isNotZero("cloth")},
             {"patch_radius",
              "m",
              radius,
              0.01,
              5,
              false,
              "Radius of the patches; they cover the panels whose middle lies within it.",
              {},
              {},
              {},
              isNotZero("patch")}}};
}

// Covers panels around the points with the patches that are chosen and weighs these; answers the
// materials of what is covered, which makeOf() then gives their numbers. Refuses patches that are
// too small for the mesh to have one of them.
Result<std::vector<Id>> addPatches(const Parameters& p, const std::vector<Id>& points, Scene& scene,
                                   Network& network, const CraftChoices& choices = kiteChoices);

// What two layers of cloth are together, where `cloth` has the numbers of the lower one.
void addLayer(Material& cloth, const Material& patch);

} // namespace ripstop
