// Which things of a scene a list of ids stands for, sorted by kind, because an id alone does not
// say whether it is an item, a particle, a link or a panel. It takes one pass over the items of the
// scene and copies none of them. The texts about a selection begin with it (document/words.h).
#pragma once

#include "scene/property.h"

#include <array>

namespace ripstop {

// The things that were found. The references hold until the scene changes.
struct Census
{
    struct Found
    {
        Id id;
        ConstRef ref;
        Id part; // the part that an element belongs to; noId for an item
    };
    std::array<std::vector<Found>, kindCount> found; // by kind, ascending ids

    const std::vector<Found>& operator[](Kind kind) const& { return found[std::size_t(kind)]; }
    std::vector<Found> operator[](Kind kind) && { return std::move(found[std::size_t(kind)]); }
};

// Looks up `ids`, which are in ascending order; ids that stand for nothing are left out. It is fast
// for many elements of few parts.
Census census(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
