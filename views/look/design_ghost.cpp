#include "look/design_ghost.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>; // particles of design and of now

// Particles are paired by id, as an edit or a tear may have made other rows.
Pairs pairsOf(const Layout& design, const Layout& now)
{
    Pairs pairs;
    if (design.particleId == now.particleId) {
        for (std::size_t i = 0; i < design.particleId.size(); ++i)
            pairs.emplace_back(i, i);
        return pairs;
    }
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::size_t i = 0; i < now.particleId.size(); ++i)
        place.try_emplace(now.particleId[i], i);
    for (std::size_t i = 0; i < design.particleId.size(); ++i)
        if (const auto found = place.find(design.particleId[i]); found != place.end())
            pairs.emplace_back(i, found->second);
    return pairs;
}

// The motion of a stiff body that comes nearest (Umeyama 1991).
Eigen::Isometry3d fit(const Frame& design, const Frame& now, const Pairs& pairs)
{
    Eigen::Matrix3Xd from(3, Eigen::Index(pairs.size())), to = from;
    for (Eigen::Index i = 0; i < from.cols(); ++i) {
        from.col(i) = design.position[pairs[std::size_t(i)].first];
        to.col(i) = now.position[pairs[std::size_t(i)].second];
    }
    return Eigen::Isometry3d(Eigen::umeyama(from, to, false));
}

} // namespace

std::shared_ptr<const Frame> designGhost(const std::shared_ptr<const Frame>& design,
                                         const Frame& now)
{
    const Layout& layout = *design->layout;
    const bool held = std::ranges::any_of(layout.pinned, [](std::uint8_t p) { return p != 0; });
    const Pairs pairs = held ? Pairs() : pairsOf(layout, *now.layout);
    const auto isSound = [&](const auto& pair) { return now.position[pair.second].allFinite(); };
    if (pairs.empty() || !std::ranges::all_of(pairs, isSound))
        return design;
    const Eigen::Isometry3d motion = fit(*design, now, pairs);
    auto moved = std::make_shared<Frame>(*design);
    for (Vec3& place : moved->position)
        place = motion * place;
    return moved;
}

} // namespace ripstop
