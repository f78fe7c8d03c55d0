// The types of items, by the names that scene files use. The names are those of Kind, without
// settings and elements.
#pragma once

#include "scene/property.h"

#include <span>
#include <string>
#include <string_view>

namespace ripstop {

std::span<const std::string_view> itemTypes();
std::string itemTypeList(); // "part, material, ..."

// The item kind of that name, or nothing: "particle" is a kind, but of no item.
std::optional<Kind> itemKind(std::string_view type);

// A new item of an item kind.
Item itemOf(Kind kind);

} // namespace ripstop
