// Looks at four particles at a time for those that may be inside of something; see contact.h.

// Lanes that are not outside. What is not a number is not outside.
RIPSTOP_INLINE Mask notOutside(const Obstacle& obstacle, const Four& x0, const Four& x1,
                               const Four& x2, const Four& x3)
{
    const Coordinates at = coordinates(x0, x1, x2, x3);
    const Coordinates offset = {at.x - all(obstacle.position.x()),
                                at.y - all(obstacle.position.y()),
                                at.z - all(obstacle.position.z())};
    if (obstacle.shape == ColliderShape::Sphere)
        return ~(dot(offset, offset) >= all(obstacle.radius * obstacle.radius));
    const Coordinates normal = {all(obstacle.normal.x()), all(obstacle.normal.y()),
                                all(obstacle.normal.z())};
    return ~(dot(offset, normal) >= all(0.0));
}

void findContacts(const ContactWork& work, std::size_t first, std::size_t last)
{
    const PaddedVec3* x = work.state.position.data();
    for (std::size_t i0 = first; i0 < last; i0 += 4) {
        const std::size_t count = std::min<std::size_t>(last - i0, 4);
        const Four& x0 = four(x[i0]);
        const Four& x1 = four(x[i0 + (count > 1 ? 1 : 0)]);
        const Four& x2 = four(x[i0 + (count > 2 ? 2 : 0)]);
        const Four& x3 = four(x[i0 + (count > 3 ? 3 : 0)]);
        Mask near = {};
        for (const Obstacle& obstacle : work.system.obstacles)
            near |= notOutside(obstacle, x0, x1, x2, x3);
        if (!any(near))
            continue;
        for (std::size_t k = 0; k < count; ++k)
            if (near[k] != 0)
                resolveContact(work, i0 + k);
    }
}
