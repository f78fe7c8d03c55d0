// What a panel carries of the pull of a fabric at one instant, in the numbers that people read. The
// engine finds it (system/membrane.h), frames have it.
#pragma once

#include "laws/cloth_law.h"
#include "laws/tear_limits.h"

namespace ripstop {

struct PanelPull
{
    bool carries = false; // or links do it, and there is nothing to tell
    ClothState state = ClothState::Slack;
    double strain = 0.0;  // 1, the largest of its threads; 0 where it is slack
    double tension = 0.0; // N/m, the largest principal one; negative where it pushes all around
    double warp = 0.0;    // N/m, that the warp threads carry; shear is in neither
    double weft = 0.0; // All three are per width of the flat cloth, as a tensile test has it: the
                       // tension of laws/cloth_law.h times the stretch along it.
    double warpStrain = 0.0; // 1, by which these threads are longer than at rest
    double weftStrain = 0.0;

    friend bool operator==(const PanelPull&, const PanelPull&) = default;
};

// The threads of a panel that are nearest to breaking; of equals those that pull more, and then the
// warp.
struct ThreadLoad
{
    int threads = 0;    // 0 the warp, 1 the weft
    double ratio = 0.0; // 1, what they bear over their limit; 0 for what never tears
};

inline ThreadLoad threadLoad(const PanelPull& pull, const FabricTear& tear)
{
    if (tear.rule == TearRule::Never)
        return {};
    const auto over = [](double load, double limit) {
        return load > 0.0 ? load / limit : 0.0; // infinitely far above a limit of 0
    };
    const bool byStrain = tear.rule == TearRule::Strain;
    const double warp = over(byStrain ? pull.warpStrain : pull.warp, tear.warp);
    const double weft = over(byStrain ? pull.weftStrain : pull.weft, tear.weft);
    const bool isWeft = weft != warp ? weft > warp : pull.weft > pull.warp;
    return isWeft ? ThreadLoad{1, weft} : ThreadLoad{0, warp};
}

} // namespace ripstop
