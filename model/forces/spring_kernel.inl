// Forces of springs, four at a time; see spring_force.h.
//
// What a spring gets does not depend on the three beside it, so threads may cut the springs
// anywhere.

struct SpringNumbers
{
    Pack rest;      // m
    Pack stiffness; // N/m
    Pack damping;   // N s/m
    Mask resists;
};

struct Pull
{
    Pack tension;   // N
    Pack perLength; // N/m
};

RIPSTOP_INLINE Pull pullOf(const SpringNumbers& spring, const Coordinates& separation,
                           const Coordinates& velocityDifference)
{
    const Pack length = root(dot(separation, separation));
    const Pack perMetre = all(1.0) / length;
    const Pack stretch = length - spring.rest;
    const Pack rate = dot(velocityDifference, separation) * perMetre;
    Pack tension = fused(spring.stiffness, stretch, spring.damping * rate);

    const Mask onlyTension = spring.resists == std::int64_t(Resists::Tension);
    const Mask onlyCompression = spring.resists == std::int64_t(Resists::Compression);
    if (any(onlyTension | onlyCompression)) {
        const Mask pulls = (stretch > all(0.0)) & (tension > all(0.0));
        const Mask pushes = (stretch < all(0.0)) & (tension < all(0.0));
        tension = ((onlyTension & ~pulls) | (onlyCompression & ~pushes)) ? Pack{} : tension;
    }
    const Mask hasDirection = length != all(0.0);
    return {hasDirection ? tension : Pack{}, hasDirection ? tension * perMetre : Pack{}};
}

RIPSTOP_INLINE SpringNumbers numbersOf(const Spring& s0, const Spring& s1, const Spring& s2,
                                       const Spring& s3)
{
    return {Pack{s0.restLength, s1.restLength, s2.restLength, s3.restLength},
            Pack{s0.stiffness, s1.stiffness, s2.stiffness, s3.stiffness},
            Pack{s0.damping, s1.damping, s2.damping, s3.damping},
            Mask{std::int64_t(s0.resists), std::int64_t(s1.resists), std::int64_t(s2.resists),
                 std::int64_t(s3.resists)}};
}

double tensionOf(const Spring& spring, const PaddedVec3& separation,
                 const PaddedVec3& velocityDifference)
{
    const Pack& d = pack(separation);
    const Pack& v = pack(velocityDifference);
    return pullOf(numbersOf(spring, spring, spring, spring), coordinates(d, d, d, d),
                  coordinates(v, v, v, v))
        .tension[0];
}

RIPSTOP_INLINE Pack between(const PaddedVec3* rows, const Spring& s)
{
    return pack(rows[s.b]) - pack(rows[s.a]);
}

RIPSTOP_INLINE void fillFour(const SpringWork& work, std::size_t i0, std::size_t i1, std::size_t i2,
                             std::size_t i3)
{
    const Spring& s0 = work.springs[i0];
    const Spring& s1 = work.springs[i1];
    const Spring& s2 = work.springs[i2];
    const Spring& s3 = work.springs[i3];
    const PaddedVec3* x = work.position;
    const PaddedVec3* v = work.velocity;

    const Pack d0 = between(x, s0), d1 = between(x, s1);
    const Pack d2 = between(x, s2), d3 = between(x, s3);
    Pack perLength =
        pullOf(numbersOf(s0, s1, s2, s3), coordinates(d0, d1, d2, d3),
               coordinates(between(v, s0), between(v, s1), between(v, s2), between(v, s3)))
            .perLength;
    const std::uint8_t t0 = work.torn[i0], t1 = work.torn[i1];
    const std::uint8_t t2 = work.torn[i2], t3 = work.torn[i3];
    if (t0 | t1 | t2 | t3)
        perLength = Mask{t0, t1, t2, t3} == 0 ? perLength : Pack{};

    // Fused with zero, which keeps the fourth number from becoming a negative zero.
    pack(work.force[i0]) = fused(d0, spread<0>(perLength), Pack{});
    pack(work.force[i1]) = fused(d1, spread<1>(perLength), Pack{});
    pack(work.force[i2]) = fused(d2, spread<2>(perLength), Pack{});
    pack(work.force[i3]) = fused(d3, spread<3>(perLength), Pack{});
}

void fillSprings(const SpringWork& work, std::size_t first, std::size_t last)
{
    std::size_t i = first;
    for (; i + 4 <= last; i += 4)
        fillFour(work, i, i + 1, i + 2, i + 3);
    if (i < last) // the last spring is repeated, and its force written again
        fillFour(work, i, std::min(i + 1, last - 1), std::min(i + 2, last - 1), last - 1);
}
