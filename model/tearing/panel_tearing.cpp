#include "tearing/panel_tearing.h"

#include "laws/cloth_bound.h"
#include "system/membrane.h"

#include <algorithm>

namespace ripstop {
namespace {

// m, of a flat panel across its warp or its weft; the inverse of `shape` has the flat sides.
double widthAcross(const Membrane& membrane, int threads)
{
    const auto& s = membrane.shape;
    const double scale = 1.0 / (s[0] * s[3] - s[1] * s[2]);
    const double ab = scale * (threads == 0 ? -s[2] : s[3]);
    const double ac = scale * (threads == 0 ? s[0] : -s[1]);
    return std::max({0.0, ab, ac}) - std::min({0.0, ab, ac});
}

} // namespace

const Membrane* membraneOf(const System& system, int panel)
{
    const auto found = std::ranges::lower_bound(system.membranes, panel, {}, &Membrane::panel);
    return found != system.membranes.end() && found->panel == panel ? &*found : nullptr;
}

bool mayTear(const System& system, const State& state, const Membrane& membrane)
{
    const FabricTear tear = tearOf(system, membrane);
    const PieceLaw law = lawOf(system, membrane);
    if (tear.rule == TearRule::Never || !law.isElastic())
        return false;
    const ClothBound bound(law);
    const double strain =
        largestStrain(strainAt(membrane, cornersOf(system, membrane, state.position)));
    const double most =
        tear.rule == TearRule::Strain ? bound.stretchAt(strain) : bound.pullAt(strain);
    return !(most <= std::min(tear.warp, tear.weft));
}

PanelVerdict judge(const System& system, const State& state, const Membrane& membrane)
{
    const FabricTear tear = tearOf(system, membrane);
    if (tear.rule == TearRule::Never)
        return {};
    const PanelPull pull = pullOf(system, membrane, cornersOf(system, membrane, state.position));
    return {threadLoad(pull, tear), pull};
}

Vec3 directionOf(const System& system, const State& state, const Membrane& membrane, int threads)
{
    const Corners at = cornersOf(system, membrane, state.position);
    return axesOf(membrane, at[1] - at[0], at[2] - at[0])[std::size_t(threads)].normalized();
}

double elasticEnergyIn(const System& system, const State& state, int panel)
{
    const Membrane* membrane = membraneOf(system, panel);
    if (!membrane || state.panelGone[std::size_t(panel)])
        return 0.0;
    return membrane->area
           * tensionIn(system, *membrane, cornersOf(system, *membrane, state.position)).energy;
}

void noteTear(const System& system, State& state, const Membrane& membrane,
              const PanelVerdict& verdict, double energy)
{
    const Corners at = cornersOf(system, membrane, state.position);
    const PanelPull& pull = verdict.pull;
    const bool ofWarp = verdict.worst.threads == 0;
    state.tears.push_back({state.time, system.panelKey[std::size_t(membrane.panel)],
                           widthAcross(membrane, verdict.worst.threads),
                           ofWarp ? pull.warpStrain : pull.weftStrain,
                           ofWarp ? pull.warp : pull.weft, (at[0] + at[1] + at[2]) / 3.0, energy});
}

} // namespace ripstop
