// What a thing points at (a group its members, a probe its targets, a link its material), when
// those go or become others. The property table says which properties point.
#pragma once

#include "scene/edit.h"

#include <functional>
#include <vector>

namespace ripstop {

// Appends who comes in the place of `id`: itself, others, or nobody.
using Heirs = std::function<void(Id id, std::vector<Id>& heirs)>;

// Adds to `edit` the references of `holder` that change; those that stay as they were add nothing.
// A reference to one thing goes to its first heir.
void passOn(Edit& edit, Id holder, const ConstRef& ref, const Heirs& heirs);

// Passes on what each item of the scene points at, by the rule of the function above.
void passOn(Edit& edit, const Scene& scene, const Heirs& heirs);

} // namespace ripstop
