// What a running simulation is told of an edit: the values of it go from the thread that compiles
// to the thread that runs, and nobody changes them on the way.
//
// Whoever only passes an update on needs to know neither systems nor patches: they are named here
// and not included.
#pragma once

#include "compile/design.h"

#include <memory>

namespace ripstop {

struct Moment; // system/moment.h
struct Patch;  // compile/patch.h
struct System; // system/system.h

// Either what to run from now on, or what to change in it.
struct Update
{
    std::shared_ptr<const System> system; // null when there is a patch
    std::shared_ptr<const Patch> patch;
    Design design = {};                        // that this comes from, where someone keeps it
    std::shared_ptr<const Moment> moment = {}; // the run begins there; null: at the start
};

} // namespace ripstop
