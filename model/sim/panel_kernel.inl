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

RIPSTOP_INLINE std::int64_t lawNow(const PanelWork& work, std::size_t i)
{
    return std::int64_t(work.gone[i] ? AirLaw::None : work.panels[i].law);
}

void fillPanels(const PanelWork& work, std::size_t first, std::size_t last)
{
    const auto x = [&](int particle) -> const Four& { return four(work.position[particle]); };
    const auto v = [&](int particle) -> const Four& { return four(work.velocity[particle]); };
    const Four third = all(-1.0 / 3.0);
    const Four quarterDensity = all(0.25 * work.airDensity);
    const Coordinates air = {all(work.wind.x()), all(work.wind.y()), all(work.wind.z())};

    for (std::size_t i0 = first; i0 < last; i0 += 4) {
        // Past the end the last panel is repeated, and written again.
        const std::size_t i1 = std::min(i0 + 1, last - 1);
        const std::size_t i2 = std::min(i0 + 2, last - 1);
        const std::size_t i3 = std::min(i0 + 3, last - 1);
        const FabricPanel& p0 = work.panels[i0];
        const FabricPanel& p1 = work.panels[i1];
        const FabricPanel& p2 = work.panels[i2];
        const FabricPanel& p3 = work.panels[i3];
        const auto [a0, b0, c0] = p0.corner;
        const auto [a1, b1, c1] = p1.corner;
        const auto [a2, b2, c2] = p2.corner;
        const auto [a3, b3, c3] = p3.corner;

        const Coordinates ab =
            coordinates(x(b0) - x(a0), x(b1) - x(a1), x(b2) - x(a2), x(b3) - x(a3));
        const Coordinates ac =
            coordinates(x(c0) - x(a0), x(c1) - x(a1), x(c2) - x(a2), x(c3) - x(a3));
        const Coordinates sum = coordinates(v(a0) + v(b0) + v(c0), v(a1) + v(b1) + v(c1),
                                            v(a2) + v(b2) + v(c2), v(a3) + v(b3) + v(c3));
        const Coordinates wind = {fused(sum.x, third, air.x), fused(sum.y, third, air.y),
                                  fused(sum.z, third, air.z)};
        const Mask law = {lawNow(work, i0), lawNow(work, i1), lawNow(work, i2), lawNow(work, i3)};
        const Four strength = {p0.normalCoefficient, p1.normalCoefficient, p2.normalCoefficient,
                               p3.normalCoefficient};
        const Four friction = {p0.skinFriction, p1.skinFriction, p2.skinFriction, p3.skinFriction};
        store(panelLoads(cross(ab, ac), wind, law, quarterDensity * strength,
                         quarterDensity * friction),
              work.load[i0], work.load[i1], work.load[i2], work.load[i3]);
    }
}
