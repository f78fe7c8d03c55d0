// Items that the outline adds, made so that they are useful at once.
//
// The functions only make the entry; the outline pushes the edit that adds it.
#pragma once

#include "scene/edit.h"

#include <QString>

namespace ripstop {

// The kinds that can be added as they are; parts come from builders, imports and drawing.
inline constexpr std::array addableKinds{Kind::Material, Kind::Collider, Kind::Wind, Kind::Control,
                                         Kind::Probe,    Kind::Plot,     Kind::Group};

// The item that makes sense beside what is selected: a group of it, a control that moves it, a
// probe on it. Its name is not used yet, its id is the next free one. For colliders there is
// newCollider().
Entry newItem(const Scene& scene, Kind kind, const std::vector<Id>& selected);

// A collider of this shape, of a size that is seen. A mesh needs a file; other shapes have none.
Entry newCollider(const Scene& scene, ColliderShape shape, const std::string& file = {});

} // namespace ripstop
