// Scene to System: the only bridge between what is authored and what is solved.
//
// A compile reads the scene and makes a system that nobody else has: it may run on any thread while
// no one changes that scene. Whoever edits a running scene takes live_system.h instead.
#pragma once

#include "base/result.h"
#include "scene/scene.h"
#include "system/system.h"

#include <memory>

namespace ripstop {

class ElementIndex;

// Fails with the first problem that keeps the scene from running (check.h lists them all).
// `generation` counts compiles and `run` counts resets; see System.
Result<std::shared_ptr<const System>> compile(const Scene& scene, std::uint64_t generation = 1,
                                              std::uint64_t run = 1);

// The same for a scene without errors, with its index, into a system that is empty.
void compileSound(const Scene& scene, const ElementIndex& index, System& system);

} // namespace ripstop
