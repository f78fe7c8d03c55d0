// Where the things of a scene are, by id, so that each reference is followed in one read.
// Compiling, the check and the step limit follow millions of references; halving a table for each
// would cost more than building this once. It is a value for one scene at one time: adding or
// removing rows or items makes it stale, and setting values does not.
#pragma once

#include "base/key_index.h"
#include "scene/property.h"

#include <optional>
#include <vector>

namespace ripstop {

class ElementIndex
{
public:
    ElementIndex() = default;
    explicit ElementIndex(const Scene& scene);

    std::optional<Kind> kindOf(Id id) const;

    // The row's number, counted through all parts in the author's order; -1 when there is no such
    // thing.
    int particle(Id id) const { return placeOf(id, Kind::Particle); }
    int link(Id id) const { return placeOf(id, Kind::Link); }
    int panel(Id id) const { return placeOf(id, Kind::Panel); }

    // The material's place in Scene::items; -1 when there is no such material.
    int material(Id id) const;

    const std::vector<Id>& repeated() const { return m_repeated; } // ids of second uses

private:
    int placeOf(Id id, Kind kind) const;
    void add(Id id, Kind kind, int place);

    KeyIndex m_index{0};      // 4 x place + which table: particles, links, panels, items
    std::vector<Kind> m_kind; // [items]
    std::vector<Id> m_repeated;
};

} // namespace ripstop
