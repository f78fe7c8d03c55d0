// Looks at four particles at a time for those that may touch something; see contact.h.

// The lanes that are not above the plane. A position that is not a number is not above.
RIPSTOP_INLINE Mask notAbove(const Obstacle& plane, const Vec3& position, const Coordinates& at)
{
    const Coordinates offset = {at.x - all(position.x()), at.y - all(position.y()),
                                at.z - all(position.z())};
    const Coordinates normal = {all(plane.normal.x()), all(plane.normal.y()),
                                all(plane.normal.z())};
    return ~(dot(offset, normal) >= all(plane.thickness));
}

// The lanes whose way, between `low` and `high`, does not keep out of the bounds of the obstacle.
RIPSTOP_INLINE Mask mayMeet(const PlacedObstacle& placed, const Coordinates& low,
                            const Coordinates& high)
{
    return ~((low.x > all(placed.high.x())) | (low.y > all(placed.high.y()))
             | (low.z > all(placed.high.z())) | (high.x < all(placed.low.x()))
             | (high.y < all(placed.low.y())) | (high.z < all(placed.low.z())));
}

RIPSTOP_INLINE Coordinates gathered(const PaddedVec3* v, std::size_t count)
{
    return coordinates(pack(v[0]), pack(v[count > 1 ? 1 : 0]), pack(v[count > 2 ? 2 : 0]),
                       pack(v[count > 3 ? 3 : 0]));
}

template <bool planesOnly>
RIPSTOP_INLINE void findContactsOf(const ContactWork& work, std::size_t first, std::size_t last)
{
    for (std::size_t i0 = first; i0 < last; i0 += 4) {
        const std::size_t count = std::min<std::size_t>(last - i0, 4);
        const Coordinates at = gathered(work.state.position.data() + i0, count);
        Coordinates low = at, high = at;
        if constexpr (!planesOnly) {
            const Coordinates was = gathered(work.before.data() + i0, count);
            low = {lesser(at.x, was.x), lesser(at.y, was.y), lesser(at.z, was.z)};
            high = {greater(at.x, was.x), greater(at.y, was.y), greater(at.z, was.z)};
        }
        Mask near = {};
        for (std::size_t o = 0; o < work.placed.size(); ++o) {
            const Obstacle& obstacle = work.system.obstacles[o];
            if (planesOnly || obstacle.shape == ColliderShape::Plane)
                near |= notAbove(obstacle, work.placed[o].position, at);
            else
                near |= mayMeet(work.placed[o], low, high);
        }
        if (!any(near))
            continue;
        for (std::size_t k = 0; k < count; ++k)
            if (near[k] != 0)
                resolveContact(work, i0 + k);
    }
}

void findContacts(const ContactWork& work, std::size_t first, std::size_t last)
{
    if (work.planesOnly)
        findContactsOf<true>(work, first, last);
    else
        findContactsOf<false>(work, first, last);
}
