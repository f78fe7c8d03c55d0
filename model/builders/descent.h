// What parachutes of the builders hang from and sink by: the coefficient of the cloth that gives a
// wanted drag, the materials, and the hoop that holds the mouth open. The round and the cross
// parachute share it; lengths in m, masses in kg.
#pragma once

#include "builders/craft_materials.h"
#include "builders/network.h"

#include <array>
#include <map>
#include <span>
#include <string>

namespace ripstop {

// What canopies, their lines and what is sewn along their edges may be made of.
inline constexpr auto canopyCloths = std::to_array<std::string_view>(
    {"ideal", "mil_7020_1", "mil_7020_3", "mil_44378_1", "mil_498_g", "f111", "silicone_nylon",
     "skytex_32", "ripstop_075"});
inline constexpr auto canopyCords = std::to_array<std::string_view>(
    {"ideal", "mil_5040_1", "mil_5040_3", "liros_tsl90", "liros_tsl190", "dyneema_1", "dyneema_2"});
inline constexpr auto canopyTapes =
    std::to_array<std::string_view>({"hem", "mil_5625_050", "mil_5625_056", "mil_5625_100"});
inline constexpr auto canopyPatches = std::to_array<std::string_view>(
    {"none", "mil_7020_1", "mil_7020_3", "mil_44378_1", "f111", "silicone_nylon"});
inline constexpr CraftChoices canopyChoices{
    canopyCloths, {}, canopyCords, canopyTapes, canopyPatches};

// The normal force coefficient of the cloth that gives a canopy which sinks upright the drag
// coefficient CD0 on the area S0, m^2. Skin friction takes its share: the force upwards is
// Cn sum(A ny^2) + Cf sum(A |wt| wt_y). The payload then sinks at v = sqrt(2 m g / (rho CD0 S0))
// (Knacke 1991, page 5-128). The cloth is given that coefficient.
void setDrag(Scene& scene, const Network& network, std::span<const Id> cloth, double coefficient,
             double area);

struct CanopyMaterials
{
    std::array<Id, 2> cloth;
    Id seams;
    Id lines; // of the parameter "line_diameter"
    Id frame; // rods that nobody sees
};

// `cloth` has the skin friction of the parameter "friction".
CanopyMaterials addCanopyMaterials(Scene& scene, const std::map<std::string, double>& parameters,
                                   Material cloth, const std::array<const char*, 2>& names,
                                   const std::array<const char*, 2>& colors);

// Two particles above and below the skirt, `reach` m away, tied to all of it: a rigid double
// pyramid where the skirt pushes, as the paper's does. One that only pulls could close while the
// two part, unless they are tied to each other as well.
std::vector<Id> addHoop(Network& network, const std::vector<Id>& skirt, double reach, double mass,
                        Id material, bool isTied);

} // namespace ripstop
