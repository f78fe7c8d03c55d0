#include "constraints/guides.h"

#include <algorithm>
#include <iterator>

namespace ripstop {

const GuidedParticle* guideOf(const System& system, int particle)
{
    if (system.guided.empty())
        return nullptr;
    const auto found =
        std::lower_bound(system.guided.begin(), system.guided.end(), particle,
                         [](const GuidedParticle& one, int p) { return one.particle < p; });
    return found != system.guided.end() && found->particle == particle ? &*found : nullptr;
}

void setGuides(System& system, std::vector<GuidedParticle> guides)
{
    const auto byParticle = [](const GuidedParticle& a, const GuidedParticle& b) {
        return a.particle < b.particle;
    };
    std::sort(guides.begin(), guides.end(), byParticle);
    std::vector<GuidedParticle> all; // of two for the same particle, the new one comes first
    all.reserve(system.guided.size() + guides.size());
    std::merge(guides.begin(), guides.end(), system.guided.begin(), system.guided.end(),
               std::back_inserter(all), byParticle);
    const auto same = [](const GuidedParticle& a, const GuidedParticle& b) {
        return a.particle == b.particle;
    };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    std::erase_if(all, [](const GuidedParticle& one) { return one.guide == Guide::None; });
    system.guided = std::move(all);
}

void dropAcrossGuides(const System& system, std::span<PaddedVec3> vector)
{
    for (const GuidedParticle& guided : system.guided) {
        PaddedVec3& own = vector[std::size_t(guided.particle)];
        own = guided.freePart(own);
    }
}

void dropAcrossGuides(const System& system, std::span<Mat3> matrix)
{
    for (const GuidedParticle& guided : system.guided) {
        Mat3& own = matrix[std::size_t(guided.particle)];
        for (int c = 0; c < 3; ++c)
            own.col(c) = guided.freePart(own.col(c));
        for (int r = 0; r < 3; ++r)
            own.row(r) = guided.freePart(own.row(r).transpose()).transpose();
    }
}

void keepOnGuides(const System& system, std::span<const PaddedVec3> before, State& state)
{
    for (const GuidedParticle& guided : system.guided) {
        const auto p = std::size_t(guided.particle);
        const Vec3 way = state.position[p] - before[p];
        state.position[p] = before[p] + guided.freePart(way);
        turnAlong(guided, state);
    }
}

void turnAlong(const GuidedParticle& guided, State& state)
{
    const auto p = std::size_t(guided.particle);
    state.velocity[p] = guided.freePart(state.velocity[p]);
    state.drift[p] = guided.freePart(state.drift[p]);
    state.velocityBefore[p] = guided.freePart(state.velocityBefore[p]);
}

} // namespace ripstop
