// Bending of fabric, four panels at a time where it pays; see fabric_bending.cpp.
//
// What a panel gets does not depend on the three beside it, so threads may cut the panels anywhere.

struct FourSides // of four panels, across from their corners
{
    Coordinates side[3];
};

RIPSTOP_INLINE FourSides fourSides(const PaddedVec3* x, const BentPanel* const (&p)[4])
{
    const auto side = [&](std::size_t from, std::size_t to) {
        return coordinates(pack(x[p[0]->corner[to]]) - pack(x[p[0]->corner[from]]),
                           pack(x[p[1]->corner[to]]) - pack(x[p[1]->corner[from]]),
                           pack(x[p[2]->corner[to]]) - pack(x[p[2]->corner[from]]),
                           pack(x[p[3]->corner[to]]) - pack(x[p[3]->corner[from]]));
    };
    return {{side(1, 2), side(2, 0), side(0, 1)}};
}

// m^4, twice the area, squared, that panels have at least for the height over a side.
RIPSTOP_INLINE Pack leastOf(const FourSides& four, const BentPanel* const (&p)[4], std::size_t k)
{
    const Pack height{p[0]->leastHeight[k], p[1]->leastHeight[k], p[2]->leastHeight[k],
                      p[3]->leastHeight[k]};
    return height * height * dot(four.side[k], four.side[k]);
}

RIPSTOP_INLINE Pack largest(const Pack& a, const Pack& b) { return a > b ? a : b; }

struct FourPanels
{
    std::size_t row[4];
    const BentPanel* panel[4];

    RIPSTOP_INLINE FourPanels(const BendWork& work, std::size_t i, std::size_t last)
    {
        for (std::size_t k = 0; k < 4; ++k) { // the last of an odd lot more than once
            row[k] = std::min(i + k, last - 1);
            panel[k] = work.panels + row[k];
        }
    }
};

void fillNormals(const BendWork& work, std::size_t first, std::size_t last)
{
    const Pack point = all(1e-200); // m^4, so that a panel without sides divides by something
    for (std::size_t i = first; i < last; i += 4) {
        const FourPanels four(work, i, last);
        const FourSides sides = fourSides(work.position, four.panel);
        const Coordinates normal = cross(sides.side[0], sides.side[1]);
        const Pack square = dot(normal, normal);
        const Pack least =
            largest(largest(leastOf(sides, four.panel, 0), leastOf(sides, four.panel, 1)),
                    largest(leastOf(sides, four.panel, 2), point));
        const Mask isLess = square < least;
        const Pack perArea = all(1.0) / root(isLess ? least : square);
        store(perArea * normal, work.normal[four.row[0]], work.normal[four.row[1]],
              work.normal[four.row[2]], work.normal[four.row[3]]);
        const Pack noted = isLess ? -perArea : perArea;
        for (int k = 0; k < 4; ++k)
            work.perArea[four.row[k]] = work.panelGone[four.panel[k]->panel] ? 0.0 : noted[k];
    }
}

RIPSTOP_INLINE Pack cross(const Pack& a, const Pack& b)
{
    const Pack c = a * __builtin_shufflevector(b, b, 1, 2, 0, 3)
                   - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
    return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}

RIPSTOP_INLINE double dot(const Pack& a, const Pack& b)
{
    const Pack c = a * b;
    return c[0] + c[1] + c[2];
}

template <bool torn>
RIPSTOP_INLINE void fillBendingOf(const BendWork& work, std::size_t first, std::size_t last)
{
    const PaddedVec3* const normals = work.turn;
    PaddedVec3* bending = work.bending + 2 * first;
    for (std::size_t i = first; i < last; ++i, bending += 2) {
        const BentPanel& panel = work.panels[i];
        const Pack normal = pack(normals[i]);
        Pack along{}, across{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int beside = panel.beside[k];
            if (torn && work.perArea[beside] == 0.0)
                continue;
            const Pack jump = fused(all(panel.sign[k]), pack(normals[beside]), -normal);
            along = fused(all(panel.share[k][0]), jump, along);
            across = fused(all(panel.share[k][1]), jump, across);
        }
        const Pack stiffness = all(torn && work.perArea[i] == 0.0 ? 0.0 : panel.stiffness);
        pack(bending[0]) = stiffness * along;
        pack(bending[1]) = stiffness * across;
    }
}

// How normals turn as corners go their ways.
void fillTurns(const BendWork& work, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const std::array<int, 3>& corner = work.panels[i].corner;
        const auto side = [&](const PaddedVec3* x, std::size_t k) -> Pack {
            return pack(x[corner[k]]) - pack(x[corner[0]]);
        };
        const Pack change = cross(side(work.way, 1), side(work.position, 2))
                            + cross(side(work.position, 1), side(work.way, 2));
        const Pack normal = pack(work.normal[i]);
        const double perArea = work.perArea[i];
        pack(work.turn[i]) = perArea < 0.0
                                 ? all(-perArea) * change
                                 : all(perArea) * fused(all(-dot(normal, change)), normal, change);
    }
}

void fillBending(const BendWork& work, std::size_t first, std::size_t last)
{
    work.torn ? fillBendingOf<true>(work, first, last) : fillBendingOf<false>(work, first, last);
}

// What the bends of a panel do to its normal, N m.
template <bool torn>
RIPSTOP_INLINE Pack momentOf(const BentPanel& panel, std::size_t i, const PaddedVec3* bending,
                             const double* perArea)
{
    if (torn && perArea[i] == 0.0)
        return Pack{};
    BentPanel::Plane own = panel.own;
    if (torn)
        for (std::size_t k = 0; k < 3; ++k)
            if (perArea[panel.beside[k]] == 0.0)
                own = {own[0] + panel.share[k][0], own[1] + panel.share[k][1]};
    Pack along = all(own[0]) * pack(bending[2 * i]);
    Pack across = all(own[1]) * pack(bending[2 * i + 1]);
    for (std::size_t k = 0; k < 3; ++k) {
        const int beside = panel.beside[k];
        if (torn && perArea[beside] == 0.0)
            continue;
        const PaddedVec3* const theirs = bending + 2 * std::ptrdiff_t(beside);
        along = fused(all(panel.shareBeside[k][0]), pack(theirs[0]), along);
        across = fused(all(panel.shareBeside[k][1]), pack(theirs[1]), across);
    }
    return along + across;
}

// What is rare is kept out of line: the pull along the side for the height over which a panel
// counts as larger than it is.
//   left  N m, of the moment along the normal
__attribute__((noinline)) void addAlongSide(const BendWork& work, std::size_t i, double left)
{
    const BentPanel& panel = work.panels[i];
    const auto side = [&](std::size_t k) -> Pack {
        return pack(work.position[panel.corner[(k + 2) % 3]])
               - pack(work.position[panel.corner[(k + 1) % 3]]);
    };
    const auto least = [&](std::size_t k) {
        return panel.leastHeight[k] * panel.leastHeight[k] * dot(side(k), side(k));
    };
    std::size_t over = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (least(k) > least(over))
            over = k;
    const double height = panel.leastHeight[over] * work.perArea[i]; // 1/m
    const Pack pull = all(left * height * height) * side(over);
    pack(work.load[3 * i + (over + 1) % 3]) -= pull;
    pack(work.load[3 * i + (over + 2) % 3]) += pull;
}

// Puts what a moment on the normal pulls with at the corners into three rows.
//   left  N m, of the moment along the normal
RIPSTOP_INLINE void putLoads(const BendWork& work, std::size_t i, const Pack& moment, double left)
{
    const PaddedVec3* const x = work.position;
    const BentPanel& panel = work.panels[i];
    const bool isLess = work.perArea[i] < 0.0;
    const Pack pull = all(isLess ? -work.perArea[i] : work.perArea[i])
                      * fused(all(isLess ? 0.0 : -left), pack(work.normal[i]), moment);
    const Pack corner = pack(x[panel.corner[2]]);
    const Pack a = cross(corner - pack(x[panel.corner[1]]), pull);
    const Pack b = cross(pack(x[panel.corner[0]]) - corner, pull);
    PaddedVec3* const load = work.load + 3 * i;
    pack(load[0]) = a;
    pack(load[1]) = b;
    pack(load[2]) = -(a + b);
}

template <bool torn>
RIPSTOP_INLINE void fillLoadsOf(const BendWork& work, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const Pack moment = momentOf<torn>(work.panels[i], i, work.bending, work.perArea);
        const double left = dot(pack(work.normal[i]), moment);
        putLoads(work, i, moment, left);
        if (work.perArea[i] < 0.0)
            addAlongSide(work, i, left);
    }
}

void fillLoads(const BendWork& work, std::size_t first, std::size_t last)
{
    work.torn ? fillLoadsOf<true>(work, first, last) : fillLoadsOf<false>(work, first, last);
}

template <bool torn>
RIPSTOP_INLINE void fillLoadChangesOf(const BendWork& work, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        Pack moment = momentOf<torn>(work.panels[i], i, work.bending, work.perArea);
        if (work.less)
            moment = fused(all(-work.less[i]), pack(work.turn[i]), moment);
        putLoads(work, i, moment, dot(pack(work.normal[i]), moment));
    }
}

void fillLoadChanges(const BendWork& work, std::size_t first, std::size_t last)
{
    work.torn ? fillLoadChangesOf<true>(work, first, last)
              : fillLoadChangesOf<false>(work, first, last);
}
