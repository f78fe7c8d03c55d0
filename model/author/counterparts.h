// What in a scene stands for what a builder made.
//
// A part of a builder came into the scene with new ids, perhaps with other names, and may have been
// moved and turned since. Rows are paired in their order, which copying keeps. Materials are those
// that paired rows are made of; groups, controls, probes, winds and colliders are known by their
// name, with or without the number that made it a free one, and by what they point at.
#pragma once

#include "scene/scene.h"
#include "shaping/transform.h"

#include <map>

namespace ripstop {

struct Counterparts
{
    Motion motion;           // from where the builder has it to where the part is
    double tolerance = 0.0;  // m, within which a particle is where the motion takes it
    std::map<Id, Id> heldAs; // [rows and items of the built scene] those of the open one
};

// The part of a scene that a builder made.
const Entry& partEntry(const Scene& built);

// `built` is what the builder makes of the parameters that the part keeps. Tables of rows of
// another length than were built have no counterparts.
Counterparts counterpartsOf(const Scene& scene, Id part, const Scene& built);

} // namespace ripstop
