// A part of a builder, built again with other parameters.
//
// Three designs meet: as the builder made it, from the parameters of the part as it stands
// (chosen_materials.h); as it makes it now; and what stands in the scene. Where the parameters make
// a difference, the scene follows. What they do not touch stays: the tuned number of a material,
// the key of a control, the limit of a wind. The part keeps its id, its name, its number properties
// and its place, and its particles their ids where there are as many as before, so that what points
// at them still does.
//
// The rows of the part are the builder's, but for what was painted on them, which goes over to the
// new ones by its place (carry_paint.h). What else was changed in them by hand goes when the part
// is built again; `HandmadeParts` counts it, so that one is told before.
#pragma once

#include "author/chosen_materials.h"
#include "author/handmade.h"
#include "builders/builder.h"
#include "scene/edit.h"

#include <optional>

namespace ripstop {

struct Rebuilt
{
    Edit edit;
    HandmadeParts lost;
    std::size_t painted = 0;            // rows that have what was painted at their place
    std::vector<OtherMaterial> staying; // of choices that are as they were
    std::size_t letGo = 0; // groups, probes, controls and links that pointed at what goes
    Scene built;           // as the builder makes it, for its figures
};

// The builder of a part, null when it was drawn by hand, imported or detached.
const Builder* builderOf(const Part& part);

// Parts with a builder that are in a selection, or hold something of it; ascending.
std::vector<Id> builtParts(const Scene& scene, const std::vector<Id>& selected);

// `id` is that of a part with a builder. New rows are numbered from `nextId` on, or from where the
// scene is. Fails as the builder does.
Result<Rebuilt> rebuilt(const Scene& scene, Id id, const Parameters& parameters,
                        std::optional<Id> nextId = {});

// The parts keep what they are and forget how they were built. Empty where none has a builder.
Edit detached(const Scene& scene, const std::vector<Id>& parts);

} // namespace ripstop
