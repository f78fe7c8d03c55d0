// Four pieces of cloth side by side, as kernels have them (parallel/simd_pack.h): the law of
// cloth_law.h in each lane, and what it makes of a strain. laws/cloth_kernel.inl computes with
// them. Strains and tensions are Coordinates: along the warp, along the weft, and the shear.
#pragma once

#include "laws/cloth_law.h"
#include "parallel/simd_pack.h"

namespace ripstop {

struct ClothLawPack
{
    Pack warp{}; // N/m, as in ClothLaw
    Pack weft{};
    Pack coupling{};
    Pack shear{};
    Mask pushes{};
    Pack alongWarp{}; // m/N, the compliance: its inverse
    Pack alongWeft{};
    Pack across{};
    Pack ofShear{};
    Pack bucklingLoad{}; // N/m, as in PieceLaw

    void set(int lane, const PieceLaw& law)
    {
        const double inverse = 1.0 / (law.warp * law.weft - law.coupling * law.coupling);
        warp[lane] = law.warp;
        weft[lane] = law.weft;
        coupling[lane] = law.coupling;
        shear[lane] = law.shear;
        pushes[lane] = law.pushes ? -1 : 0;
        alongWarp[lane] = law.weft * inverse;
        alongWeft[lane] = law.warp * inverse;
        across[lane] = -law.coupling * inverse;
        ofShear[lane] = 1.0 / law.shear;
        bucklingLoad[lane] = law.bucklingLoad;
    }

    // Nothing is there: it has no tension, and a compliance that does no harm.
    void clear(int lane)
    {
        warp[lane] = weft[lane] = coupling[lane] = shear[lane] = 0.0;
        pushes[lane] = -1;
        alongWarp[lane] = alongWeft[lane] = ofShear[lane] = 1.0;
        across[lane] = bucklingLoad[lane] = 0.0;
    }
};

struct ClothStiffnessPack // N/m, symmetric
{
    Pack warp;
    Pack weft;
    Pack shear;
    Pack warpWeft;
    Pack warpShear;
    Pack weftShear;
};

struct ClothTensionPack // as ClothTension
{
    Mask isTaut;
    Mask isWrinkled;
    Coordinates tension;
    ClothStiffnessPack stiffness;
    Pack energy;

    ClothTension of(int lane) const;
};

// What tensionOf() says of each lane, to the bit. Kernels include cloth_kernel.inl instead.
void followLaws(const ClothLawPack& law, const Coordinates& strain, ClothTensionPack& now);

} // namespace ripstop
