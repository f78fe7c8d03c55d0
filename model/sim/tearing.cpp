#include "sim/tearing.h"

namespace ripstop {
namespace {

struct Load
{
    double length;     // m
    double restLength; // m
    double force;      // N, positive in tension
    double strain() const { return restLength > 0.0 ? length / restLength - 1.0 : 0.0; }
};

bool breaks(const TearLimit& tear, const Load& load)
{
    switch (tear.rule) {
    case TearRule::Length:
        return load.length > tear.limit;
    case TearRule::Strain:
        return load.strain() > tear.limit;
    case TearRule::Force:
        return load.force > tear.limit;
    case TearRule::Never:
        break;
    }
    return false;
}

} // namespace

void tearLinks(const System& system, State& state, std::span<const double> rodLength,
               std::span<const PaddedVec3> springForce, std::span<const double> restLength)
{
    for (const int tearable : system.tearable) {
        const auto l = std::size_t(tearable);
        const LinkPlace& link = system.links[l];
        const auto index = std::size_t(link.index);
        const bool rod = link.kind == LinkKind::Rod;
        std::uint8_t& torn = rod ? state.rodTorn[index] : state.springTorn[index];
        if (torn)
            continue;

        const Vec3& a = state.position[std::size_t(link.a)];
        const Vec3& b = state.position[std::size_t(link.b)];
        const double length = (b - a).norm();
        const Load load = rod ? Load{rodLength[index], restLength[index], state.rodTension[index]}
                              : Load{length, system.springs[index].restLength,
                                     length > 0.0 ? springForce[index].dot(b - a) / length : 0.0};
        if (!breaks(rod ? system.rods[index].tear : system.springs[index].tear, load))
            continue;

        torn = 1;
        if (rod)
            state.rodTension[index] = 0.0;
        for (int k = system.panelsBeside.start[l]; k < system.panelsBeside.start[l + 1]; ++k)
            state.panelGone[std::size_t(system.panelsBeside.items[std::size_t(k)])] = 1;
        state.tears.push_back(
            {state.time, link.key, load.length, load.strain(), load.force, 0.5 * (a + b)});
    }
}

} // namespace ripstop
