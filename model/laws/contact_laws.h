// What colliders look like and what they do to a particle that meets them.
//
// The shape says which numbers of a collider count (shapes/solid.h); the response says how much of
// its velocity a particle keeps (contact/contact.h has the formulas). The scene chooses both,
// contact obeys them.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class ColliderShape { Plane, Sphere, Box, Cylinder, HeightField, Mesh };
template <>
inline constexpr std::array<std::string_view, 6> choiceNames<ColliderShape>{
    "plane", "sphere", "box", "cylinder", "height_field", "mesh"};

enum class Response { Stop, Slide, Contact };
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Response>{"stop", "slide", "contact"};

} // namespace ripstop
