// Edits of groups from a selection: a new one, and elements that join or leave one. The menus of
// the editor, probes for several elements (measure.h) and rebuilt parts use it. Functions that
// take a group expect it to exist.
#pragma once

#include "scene/edit.h"

#include <string>

namespace ripstop {

// "group", "group 2", ...: the first that no item has.
std::string freeName(const Scene& scene, std::string_view base);

// A new group of the elements that a selection means, at the end of the items. Its id is the next
// one of the scene.
Edit grouped(const Scene& scene, const std::string& name, const std::vector<Id>& selected);

// The edit that adds these elements to the group or takes them out of it; empty where that changes
// nothing.
Edit addedToGroup(const Scene& scene, Id group, const std::vector<Id>& selected);
Edit removedFromGroup(const Scene& scene, Id group, const std::vector<Id>& selected);

} // namespace ripstop
