// One piece of cloth is looked at in all four lanes of the kernel, which has the law
// (cloth_kernel.inl).
#include "laws/cloth_law.h"

#include "laws/cloth_pack.h"

#include <cmath>
#include <numbers>

#define RIPSTOP_KERNEL "laws/cloth_lanes_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

ClothLaw ClothLaw::of(double warp, double weft, double poisson, double shear)
{
    const double across = poisson * weft / warp;
    const double share = 1.0 / (1.0 - poisson * across);
    ClothLaw law;
    law.warp = warp * share;
    law.weft = weft * share;
    law.coupling = poisson * weft * share;
    law.shear = shear;
    return law;
}

void followLaws(const ClothLawPack& law, const Coordinates& strain, ClothTensionPack& now)
{
    (wideMachine ? wide::follow : anywhere::follow)(law, strain, now);
}

ClothTension ClothTensionPack::of(int lane) const
{
    ClothTension one;
    one.state = isTaut[lane]       ? ClothState::Taut
                : isWrinkled[lane] ? ClothState::Wrinkled
                                   : ClothState::Slack;
    one.tension = tension.of(lane);
    const auto& s = stiffness;
    one.stiffness << s.warp[lane], s.warpWeft[lane], s.warpShear[lane], //
        s.warpWeft[lane], s.weft[lane], s.weftShear[lane],              //
        s.warpShear[lane], s.weftShear[lane], s.shear[lane];
    one.energy = energy[lane];
    return one;
}

double bucklingLoadOf(double bendingStiffness, double length)
{
    constexpr double square = std::numbers::pi * std::numbers::pi;
    return square * bendingStiffness / (length * length);
}

ClothTension tensionOf(const PieceLaw& law, const Vec3& strain)
{
    ClothLawPack laws;
    Coordinates strains;
    for (int lane = 0; lane < 4; ++lane) {
        laws.set(lane, law);
        strains.set(lane, strain);
    }
    ClothTensionPack now;
    followLaws(laws, strains, now);
    return now.of(0);
}

Vec3 threadStrain(const PieceLaw& law, const Vec3& strain, const ClothTension& now)
{
    return now.state == ClothState::Taut ? strain : strainOf(law, now.tension);
}

Vec3 pullingStrain(const PieceLaw& law, const Vec3& strain)
{
    return threadStrain(law, strain, tensionOf(law, strain));
}

Vec3 strainOf(const ClothLaw& law, const Vec3& tension)
{
    const double inverse = 1.0 / (law.warp * law.weft - law.coupling * law.coupling);
    const double across = -law.coupling * inverse;
    return {law.weft * inverse * tension[0] + across * tension[1],
            across * tension[0] + law.warp * inverse * tension[1], 1.0 / law.shear * tension[2]};
}

double largestTension(const Vec3& tension)
{
    const double mean = 0.5 * (tension[0] + tension[1]);
    const double half = 0.5 * (tension[0] - tension[1]);
    return mean + std::sqrt(half * half + tension[2] * tension[2]);
}

} // namespace ripstop
