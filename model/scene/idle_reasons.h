// Reasons why a value does nothing that something can be done about (author/remedy.h), as half
// sentences. The conditions of the table of properties (property_needs.h) say them, and remedies
// recognise them.
#pragma once

namespace ripstop::idle {

inline constexpr const char* notAutomatic = "only the automatic solver aims at a strain";
inline constexpr const char* stiffSolver = "the paper's solver takes every rod as stiff";
inline constexpr const char* pinned = "the particle is pinned";
inline constexpr const char* linkIsRod = "the link is a rod, which has a compliance";
inline constexpr const char* linkIsSpring = "the link is a spring, which has a stiffness";
inline constexpr const char* onlyRods = "its links are all rods, which take the compliance";
inline constexpr const char* onlySprings = "its links are all springs, which take the stiffness";
inline constexpr const char* noThread =
    "no link of it is a thread with a width, and no panel of it is elastic";
inline constexpr const char* noBias =
    "no link of it is a bias with a width, and no panel of it is elastic";
inline constexpr const char* noElasticPanel = "no panel of it carries the pull of a fabric";
inline constexpr const char* ownOfSprings = "each of its springs has its own";
inline constexpr const char* ownOfRods = "each of its rods has its own";
inline constexpr const char* ownOfLinks = "each of its links has its own";
inline constexpr const char* physicalCounts =
    "its axial, membrane or shear stiffness counts instead";
inline constexpr const char* neverTears = "the material never tears; choose what it tears by";
inline constexpr const char* heldInShape = "rigidity particles hold all its links in shape";
inline constexpr const char* noAir = "the air density is 0";

} // namespace ripstop::idle
