// Where the things of a scene are, by id: what it takes to follow references in one read each.
#pragma once

#include "base/key_index.h"
#include "scene/property.h"

#include <optional>
#include <vector>

namespace ripstop {

// Of one scene at one time: adding and removing rows or items makes it stale.
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

    const std::vector<Id>& repeated() const { return m_repeated; } // ids that are used again

private:
    int placeOf(Id id, Kind kind) const;
    void add(Id id, Kind kind, int place);

    KeyIndex m_index{0};      // 4 x place + which table: particles, links, panels, items
    std::vector<Kind> m_kind; // [items]
    std::vector<Id> m_repeated;
};

} // namespace ripstop
