// What a set of ids is made of.
#pragma once

#include "scene/property.h"

#include <array>

namespace ripstop {

// The things behind a list of ids, sorted by kind. The references hold until the scene changes.
struct Census
{
    struct Found
    {
        Id id;
        ConstRef ref;
        Id part; // of an element; noId for an item
    };
    std::array<std::vector<Found>, kindCount> found; // by kind, ascending ids

    const std::vector<Found>& operator[](Kind kind) const& { return found[std::size_t(kind)]; }
    std::vector<Found> operator[](Kind kind) && { return std::move(found[std::size_t(kind)]); }
};

// `ids` in ascending order; ids of nothing are left out. Fast for many elements of few parts.
Census census(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
