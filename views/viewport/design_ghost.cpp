#include "viewport/design_ghost.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>; // particles of design and of now

// By id, as an edit or a tear may have made other rows.
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

Eigen::Isometry3d fit(const Frame& design, const Frame& now, const Pairs& pairs)
{
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    for (const auto& [d, n] : pairs) {
        from += design.position[d] / double(pairs.size());
        to += now.position[n] / double(pairs.size());
    }
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& [d, n] : pairs)
        covariance += (now.position[n] - to) * (design.position[d] - from).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 mirror = Vec3::Ones(); // a turn, never a mirror image
    mirror.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Eigen::Matrix3d turn = svd.matrixU() * mirror.asDiagonal() * svd.matrixV().transpose();
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.linear() = turn;
    motion.translation() = to - turn * from;
    return motion;
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
