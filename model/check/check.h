// Problems of a scene: errors, which keep it from running, and warnings, which let it run but
// hardly as its author means it.
// Compiling asks for the first error; the update of a running system asks only about what was
// touched; the follower thread of the editor and the command line ask for the whole list. All
// functions read the scene and write nothing. Files of colliders are read through the cache of
// shapes/shape_files.h.
#pragma once

#include "check/finding.h"

namespace ripstop {

// All problems, errors first. The list has at most `most` problems of each sort, so that a broken
// table of a million rows stays readable.
std::vector<Finding> problemsOf(const Scene& scene, std::size_t most = 20);

class ElementIndex;

// The first error, without looking for warnings of the mesh and the run; the second function looks
// at items only. `index` is that of the scene as it is.
std::optional<Finding> firstError(const Scene& scene, const ElementIndex& index);
std::optional<Finding> firstErrorOfItems(const Scene& scene, const ElementIndex& index);

// Whether an element has no error of its own: what is left to check when only its values changed.
bool isSound(const ConstRef& element, const ElementIndex& index);

bool hasErrors(const std::vector<Finding>& problems);

} // namespace ripstop
