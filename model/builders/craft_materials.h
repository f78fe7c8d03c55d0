// What a craft is made of: cloth, spars and lines by name, out of the library
// (materials/presets.h).
//
// A builder lays its craft as the papers have it, of rods that never stretch, with masses from its
// own parameters; that is what the choice "ideal" leaves. With a cloth that one can buy, panels
// carry the pull of the sail, the warp along the textures' v; the rods that stood for the cloth go,
// and hems are rods of what two turns of a hem of 1 cm make of the cloth, its strength at its seams
// included. Spars get EA and EI, and so do the rods that stand for the frame, but for bending and
// strength: what they stand for is no tube that could break there; a line stretches, and its second
// rods (kite_flight.h), which make up for sweeps that have not converged, go. What is chosen says
// what the craft weighs.
//
// What a craft may be made of is its own: a kite of spinnaker cloth, a canopy of parachute nylon.
// The choices stand in files by their number: new ones go to the end of a list.
#pragma once

#include "builders/builder.h"
#include "builders/network.h"
#include "materials/preset.h"

#include <array>
#include <vector>

namespace ripstop {

inline constexpr auto clothChoices =
    std::to_array<std::string_view>({"ideal", "ripstop_050", "ripstop_075", "ripstop_150",
                                     "skytex_27", "skytex_32", "skytex_38", "teijin_d2"});
inline constexpr auto sparChoices =
    std::to_array<std::string_view>({"ideal", "fibreglass_tube_6", "fibreglass_tube_8",
                                     "carbon_tube_6", "carbon_tube_8", "carbon_wrapped_8"});
inline constexpr auto cordChoices = std::to_array<std::string_view>(
    {"ideal", "dyneema_1", "dyneema_2", "liros_ltc45", "liros_ltc80", "liros_ltc120",
     "liros_ltc200", "liros_ltc400"});
inline constexpr auto patchChoices =
    std::to_array<std::string_view>({"none", "ripstop_050", "ripstop_075", "ripstop_150",
                                     "teijin_d2", "surf_dacron", "dacron_sail"});

// clang-format off
inline constexpr auto materialParameters = std::to_array<Parameter>({
    {"cloth", "", 0, 0, clothChoices.size() - 1, true, "Cloth of the sail; ideal cloth never stretches and weighs what is said below, a real one is carried by panels and wrinkles.", "Materials", clothChoices, 2},
    {"spars", "", 0, 0, sparChoices.size() - 1,  true, "Spars of the frame; ideal ones never stretch, real ones bend.", {}, sparChoices, 1},
    {"cord",  "", 0, 0, cordChoices.size() - 1,  true, "What the line is made of; an ideal one never stretches.", {}, cordChoices, 3},
});
// clang-format on

// Lists of names of the library, of which the first is not in it; a craft without spars has none.
struct CraftChoices
{
    std::span<const std::string_view> cloth;
    std::span<const std::string_view> spars;
    std::span<const std::string_view> cord;
    std::span<const std::string_view> tapes = {};   // the first is the cloth itself, turned in
    std::span<const std::string_view> patches = {}; // the first is none
};
inline constexpr CraftChoices kiteChoices{clothChoices, sparChoices, cordChoices, {}, patchChoices};

// Ids of materials of the scene; what a craft does not have stays empty.
struct CraftMaterials
{
    std::vector<Id> cloth;   // of panels
    std::vector<Id> patches; // of panels that a patch covers (reinforcement.h)
    std::vector<Id> seams;   // of rods that stand for the cloth
    std::vector<Id> hems;    // of rods along its free edges, of sewn seams, and of ribbons
    std::vector<Id> spars;   // of rods that are spars
    std::vector<Id> frame;   // of rods that stand for the rest of the frame
    std::vector<Id> wires;   // of those of the frame that are steel cables
    std::vector<Id> lines;   // of the line, and of the legs of a bridle
    std::vector<Id> doubled; // of second rods of the line

    std::vector<Id> allCloth() const; // with and without patches
};

// Null where there are none.
const Preset* patchOf(const Parameters& p, const CraftChoices& choices);

bool isIdeal(const Parameters& p, std::string_view parameter);

// kg/m^2, of the cloth that is chosen, or what this parameter says of an ideal one.
double clothDensity(const Parameters& p, const CraftChoices& choices = kiteChoices,
                    std::string_view ofIdeal = "fabric");

// kg/m, of the line that is chosen, or what this parameter says of an ideal one.
double cordDensity(const Parameters& p, const CraftChoices& choices = kiteChoices,
                   std::string_view ofIdeal = "line_density");

// kg/m, of the tape that hems and seams are made with, or of the cloth that is turned in.
double hemDensity(const Parameters& p, const CraftChoices& choices);

// kg/m, of the spar that is chosen, or 0 of ideal ones.
double sparDensity(const Parameters& p, const CraftChoices& choices);

// kg, of the rods so far that are spars; `ideal` where they are that.
double frameMass(const Parameters& p, const std::vector<Id>& spars, const Network& network,
                 double ideal, const CraftChoices& choices = kiteChoices);

// Makes the craft of what is chosen, once it is laid. Panels that carry already keep their cut.
void makeOf(const Parameters& p, const CraftMaterials& materials, Scene& scene, Network& network,
            const CraftChoices& choices = kiteChoices);

} // namespace ripstop
