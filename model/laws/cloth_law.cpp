// One piece of cloth is looked at in all four lanes of the kernel, which has the law (cloth_kernel.inl).
#include "laws/cloth_law.h"

#include "laws/cloth_pack.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

struct ClothMoment
{
    ClothLawPack law;
    Coordinates strain;
    ClothTensionPack now;
};

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "laws/cloth_moment_kernel.inl"
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

ClothTension tensionOf(const ClothLaw& law, const Vec3& strain)
{
    ClothMoment moment;
    for (int lane = 0; lane < 4; ++lane) {
        moment.law.set(lane, law);
        moment.strain.x[lane] = strain[0];
        moment.strain.y[lane] = strain[1];
        moment.strain.z[lane] = strain[2];
    }
    (wideMachine ? wide::follow : anywhere::follow)(moment);
    const auto& [isTaut, isWrinkled, tension, s, energy] = moment.now;
    ClothTension now;
    now.state = isTaut[0]       ? ClothState::Taut
                : isWrinkled[0] ? ClothState::Wrinkled
                                : ClothState::Slack;
    now.tension = {tension.x[0], tension.y[0], tension.z[0]};
    now.stiffness << s.warp[0], s.warpWeft[0], s.warpShear[0], //
        s.warpWeft[0], s.weft[0], s.weftShear[0],              //
        s.warpShear[0], s.weftShear[0], s.shear[0];
    now.energy = energy[0];
    return now;
}

Vec3 threadStrain(const ClothLaw& law, const Vec3& strain, const ClothTension& now)
{
    switch (now.state) {
    case ClothState::Slack:
        return Vec3::Zero();
    case ClothState::Wrinkled:
        return strainOf(law, now.tension);
    case ClothState::Taut:
        break;
    }
    return strain;
}

Vec3 pullingStrain(const ClothLaw& law, const Vec3& strain)
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
