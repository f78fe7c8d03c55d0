// The particle of an id, in whichever part of a scene it is.
#pragma once

#include "scene/property.h"

namespace ripstop {

// Null when there is no such particle.
inline const Particle* particleOf(const Scene& scene, Id id)
{
    const std::optional<ConstRef> ref = find(scene, id);
    const auto* const row = ref ? std::get_if<const Particle*>(&*ref) : nullptr;
    return row ? *row : nullptr;
}

} // namespace ripstop
