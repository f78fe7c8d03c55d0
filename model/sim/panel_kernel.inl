// Wind on fabric, four panels at a time; see panel_load.h.
//
// With c = (b - a) x (c - a), twice the area long, and r = c.w / c^2, the share of c that is the
// head-on wind, the laws need one division and no unit normal:
//     paper          F = 1/4 rho C |c.w| r c
//     linear normal  F = 1/4 rho C |c| |w| r c
//     skin friction  F = 1/4 rho Cs |c| |t| t,  t = w - r c
// What a panel gets does not depend on the three beside it.

// Zero where there is no law, no area or no panel any more.
RIPSTOP_INLINE Coordinates panelLoads(const Coordinates& normal, const Coordinates& wind, Mask law,
                                      Four strength, Four friction)
{
    const Four square = dot(normal, normal);
    const Four through = dot(normal, wind);
    const Four share = through / square;

    const Mask linear = law == std::int64_t(AirLaw::LinearNormal);
    Four pace = magnitude(through);
    if (any(linear))
        pace = linear ? root(square * dot(wind, wind)) : pace;
    Coordinates load = (strength * pace * share) * normal;

    const Mask rough = friction > all(0.0);
    if (any(rough)) {
        const Coordinates along = {fused(-share, normal.x, wind.x), fused(-share, normal.y, wind.y),
                                   fused(-share, normal.z, wind.z)};
        const Four drag = friction * root(square * dot(along, along));
        const Coordinates both = {fused(drag, along.x, load.x), fused(drag, along.y, load.y),
                                  fused(drag, along.z, load.z)};
        load = select(rough, both, load);
    }
    const Mask meetsAir = (law != std::int64_t(AirLaw::None)) & (square != all(0.0));
    return select(meetsAir, load, Coordinates{});
}

RIPSTOP_INLINE void fillFour(const PanelWork& work, std::size_t i0, std::size_t i1, std::size_t i2,
                             std::size_t i3)
{
    const FabricPanel& p0 = work.panels[i0];
    const FabricPanel& p1 = work.panels[i1];
    const FabricPanel& p2 = work.panels[i2];
    const FabricPanel& p3 = work.panels[i3];
    const auto [a0, b0, c0] = p0.corner;
    const auto [a1, b1, c1] = p1.corner;
    const auto [a2, b2, c2] = p2.corner;
    const auto [a3, b3, c3] = p3.corner;

    const PaddedVec3* x = work.position;
    const Four from0 = four(x[a0]), from1 = four(x[a1]);
    const Four from2 = four(x[a2]), from3 = four(x[a3]);
    const Coordinates ab = coordinates(four(x[b0]) - from0, four(x[b1]) - from1,
                                       four(x[b2]) - from2, four(x[b3]) - from3);
    const Coordinates ac = coordinates(four(x[c0]) - from0, four(x[c1]) - from1,
                                       four(x[c2]) - from2, four(x[c3]) - from3);

    const PaddedVec3* v = work.velocity;
    const Coordinates sum = coordinates(
        four(v[a0]) + four(v[b0]) + four(v[c0]), four(v[a1]) + four(v[b1]) + four(v[c1]),
        four(v[a2]) + four(v[b2]) + four(v[c2]), four(v[a3]) + four(v[b3]) + four(v[c3]));
    const Four third = all(-1.0 / 3.0);
    const Coordinates wind = {fused(sum.x, third, all(work.wind.x())),
                              fused(sum.y, third, all(work.wind.y())),
                              fused(sum.z, third, all(work.wind.z()))};

    Mask law = {std::int64_t(p0.law), std::int64_t(p1.law), std::int64_t(p2.law),
                std::int64_t(p3.law)};
    const std::uint8_t g0 = work.gone[i0], g1 = work.gone[i1];
    const std::uint8_t g2 = work.gone[i2], g3 = work.gone[i3];
    if (g0 | g1 | g2 | g3)
        law = Mask{g0, g1, g2, g3} == 0 ? law : Mask{} + std::int64_t(AirLaw::None);

    const Four quarterDensity = all(0.25 * work.airDensity);
    const Four strength = {p0.normalCoefficient, p1.normalCoefficient, p2.normalCoefficient,
                           p3.normalCoefficient};
    const Four friction = {p0.skinFriction, p1.skinFriction, p2.skinFriction, p3.skinFriction};
    store(
        panelLoads(cross(ab, ac), wind, law, quarterDensity * strength, quarterDensity * friction),
        work.load[i0], work.load[i1], work.load[i2], work.load[i3]);
}

void fillPanels(const PanelWork& work, std::size_t first, std::size_t last)
{
    std::size_t i = first;
    for (; i + 4 <= last; i += 4)
        fillFour(work, i, i + 1, i + 2, i + 3);
    if (i < last) // the last one is repeated, and written again
        fillFour(work, i, std::min(i + 1, last - 1), std::min(i + 2, last - 1), last - 1);
}
