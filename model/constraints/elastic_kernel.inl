// Panels that carry a pull, four at a time; see elastic_panels.h.
#include "laws/cloth_kernel.inl"

using ClothAxesPack = std::array<Coordinates, 2>;

RIPSTOP_INLINE Coordinates cornersOf(const FourPanels& four, std::size_t corner, const Row* rows)
{
    const auto& [a, b, c, d] = four.row[corner];
    return coordinates(pack(rows[a].v), pack(rows[b].v), pack(rows[c].v), pack(rows[d].v));
}

RIPSTOP_INLINE ClothAxesPack axesOf(const FourPanels& four, const Row* position)
{
    const Coordinates a = cornersOf(four, 0, position);
    const Coordinates ab = cornersOf(four, 1, position) - a;
    const Coordinates ac = cornersOf(four, 2, position) - a;
    const Pack* const s = four.shape;
    return {s[0] * ab + s[2] * ac, s[1] * ab + s[3] * ac};
}

RIPSTOP_INLINE Coordinates strainOf(const ClothAxesPack& axes)
{
    return {all(0.5) * (product(axes[0], axes[0]) - all(1.0)),
            all(0.5) * (product(axes[1], axes[1]) - all(1.0)), product(axes[0], axes[1])};
}

RIPSTOP_INLINE void keepSome(const ClothLawPack& law, double kept, ClothTensionPack& now)
{
    ClothStiffnessPack& s = now.stiffness;
    const auto withKept = [kept](Pack stiffness, Pack taut) {
        return all(1.0 - kept) * stiffness + all(kept) * taut;
    };
    s.warp = now.isTaut ? s.warp : withKept(s.warp, law.warp);
    s.weft = now.isTaut ? s.weft : withKept(s.weft, law.weft);
    s.shear = now.isTaut ? s.shear : withKept(s.shear, law.shear);
    s.warpWeft = now.isTaut ? s.warpWeft : withKept(s.warpWeft, law.coupling);
    s.warpShear = now.isTaut ? s.warpShear : withKept(s.warpShear, Pack{});
    s.weftShear = now.isTaut ? s.weftShear : withKept(s.weftShear, Pack{});
}

void measureFours(std::span<FourPanels> fours, const Row* position, double kept)
{
    for (FourPanels& four : fours) {
        four.axes = axesOf(four, position);
        four.now = tensionOf(four.law, strainOf(four.axes) - four.offset);
        keepSome(four.law, kept, four.now);
    }
}

void foreseeFours(std::span<FourPanels> fours, const Row* move)
{
    for (FourPanels& four : fours) {
        const Coordinates first = cornersOf(four, 0, move);
        Coordinates change{};
        for (std::size_t k = 1; k < 3; ++k) {
            const Coordinates way = cornersOf(four, k, move) - first;
            const Pack g0 = four.shape[2 * k - 2], g1 = four.shape[2 * k - 1];
            const Pack warp = product(four.axes[0], way), weft = product(four.axes[1], way);
            change = change + Coordinates{g0 * warp, g1 * weft, g1 * warp + g0 * weft};
        }
        const ClothStiffnessPack& s = four.now.stiffness;
        const Coordinates more{product({s.warp, s.warpWeft, s.warpShear}, change),
                               product({s.warpWeft, s.weft, s.weftShear}, change),
                               product({s.warpShear, s.weftShear, s.shear}, change)};
        four.before = four.now.tension;
        four.tension = four.now.tension + more;
    }
}

RIPSTOP_INLINE Pack energyOf(const FourPanels& four, const Coordinates& tension)
{
    return four.weight * product(tension, strainOf(four.law, tension));
}

void addUp(std::span<const FourPanels> fours, ElasticPanels::Account& account)
{
    for (const FourPanels& four : fours) {
        const Pack pulls = energyOf(four, four.tension);
        const Pack errors = energyOf(four, four.now.tension - four.tension);
        for (int lane = 0; lane < 4; ++lane) {
            account.pulls += pulls[lane];
            account.errors += errors[lane];
        }
    }
}

// Whether what they have at least takes all of `twice`.
bool takeAll(std::span<const FourPanels> fours, const Row* position, double twice)
{
    for (const FourPanels& four : fours) {
        const Coordinates strain = strainOf(axesOf(four, position)) - four.offset;
        const Pack least = all(2.0) * four.weight * leastEnergyOf(four.law, strain);
        for (int lane = 0; lane < 4; ++lane)
            twice -= least[lane];
        if (twice < 0.0)
            return true;
    }
    return false;
}

void leaveThreads(const ClothLawPack& law, Coordinates& strain)
{
    strain = pullingStrain(law, strain);
}
