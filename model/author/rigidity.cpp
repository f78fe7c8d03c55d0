// Linear algebra on the velocities of all particles, three rows each:
// 1. stretchesOf() has a column for each link; what pins and guides hold is taken out of it.
// 2. freeOf() finds the velocities that stretch nothing as the eigenvectors of near zero;
//    rigidMotionsOf() finds those of the whole as one body. What is left of the first without the
//    second are the modes, each made as local as it can be.
// 3. bracesFor() takes one rod after the other: the one that stretches the remaining modes most
//    for its length, and removes the direction that it stops.
// 4. withBraces() draws them.
#include "author/rigidity.h"

#include "shaping/drawing.h"
#include "shaping/movable.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of squared singular values over the largest: what is as soft as this yields.
constexpr double soft = 1e-10;

Index placeOf(int particle) { return 3 * Index(particle); }

// An orthonormal base of the columns' span. What is shorter than 1e-6 is noise: columns here are
// about as long as 1.
MatrixXd spanOf(const MatrixXd& columns)
{
    if (columns.cols() == 0)
        return columns;
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
    const Index most = std::min(columns.rows(), columns.cols());
    Index rank = 0;
    while (rank < most && std::abs(qr.matrixR()(rank, rank)) > 1e-6)
        ++rank;
    return qr.householderQ() * MatrixXd::Identity(columns.rows(), rank);
}

// The part of a velocity that pins and guides take away.
Vec3 heldPart(const Rigidity& r, int particle, const Vec3& velocity)
{
    if (r.pinned[std::size_t(particle)])
        return velocity;
    return velocity - r.guides[std::size_t(particle)].freePart(velocity);
}

// The number of independent directions that a particle can go in.
int waysOf(const Rigidity& r, int particle)
{
    if (r.pinned[std::size_t(particle)])
        return 0;
    switch (r.guides[std::size_t(particle)].guide) {
    case Guide::Line:
        return 1;
    case Guide::Plane:
        return 2;
    case Guide::None:
        break;
    }
    return 3;
}

// A column for each link, its direction as a unit vector at both ends. Velocities that the links
// allow are orthogonal to all columns; v = 0 at pins.
MatrixXd stretchesOf(const Rigidity& r)
{
    MatrixXd rows = MatrixXd::Zero(placeOf(int(r.particles.size())), Index(r.links.size()));
    for (std::size_t l = 0; l < r.links.size(); ++l) {
        const auto [a, b] = r.links[l];
        const Vec3 along =
            (r.position[std::size_t(b)] - r.position[std::size_t(a)]).stableNormalized();
        rows.col(Index(l)).segment<3>(placeOf(a)) = heldPart(r, a, along) - along;
        rows.col(Index(l)).segment<3>(placeOf(b)) = along - heldPart(r, b, along);
    }
    return rows;
}

// An orthonormal base of what the columns leave free, and pins and guides.
MatrixXd freeOf(const MatrixXd& stretches, const Rigidity& r)
{
    MatrixXd gram = stretches * stretches.transpose();
    double largest = 1.0;
    if (stretches.cols() > 0)
        largest = std::max(largest, gram.diagonal().maxCoeff());
    for (int p = 0; p < int(r.particles.size()); ++p)
        for (int axis = 0; axis < 3; ++axis)
            gram.block<3, 1>(placeOf(p), placeOf(p) + axis) +=
                largest * heldPart(r, p, Vec3::Unit(axis));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
    Index count = 0; // eigenvalues ascend
    while (count < gram.rows() && solver.eigenvalues()[count] < soft * largest)
        ++count;
    return solver.eigenvectors().leftCols(count);
}

// Those of the six motions of a rigid body that leave pins where they are and guides alone.
MatrixXd rigidMotionsOf(const Rigidity& r)
{
    const auto count = int(r.particles.size());
    MatrixXd all = MatrixXd::Zero(placeOf(count), 6);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : r.position)
        middle += place / count;
    double size = 0.0;
    for (const Vec3& place : r.position)
        size = std::max(size, (place - middle).norm());
    for (int p = 0; p < count; ++p) {
        const Vec3 arm = (r.position[std::size_t(p)] - middle) / std::max(size, 1e-300);
        for (int axis = 0; axis < 3; ++axis) {
            all.col(axis).segment<3>(placeOf(p)) = Vec3::Unit(axis);
            all.col(3 + axis).segment<3>(placeOf(p)) = Vec3::Unit(axis).cross(arm);
        }
    }
    MatrixXd atPins = MatrixXd::Zero(all.rows(), 6);
    for (int p = 0; p < count; ++p)
        for (int motion = 0; motion < 6; ++motion)
            atPins.block<3, 1>(placeOf(p), motion) =
                heldPart(r, p, all.block<3, 1>(placeOf(p), motion));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(atPins.transpose() * atPins);
    Index left = 0;
    while (left < 6 && solver.eigenvalues()[left] < soft * std::max(1.0, double(count)))
        ++left;
    return spanOf(all * solver.eigenvectors().leftCols(left));
}

// A base of the span of the columns, each as local as can be: 1 in a place of its own where the
// others are 0.
MatrixXd localised(const MatrixXd& base)
{
    if (base.cols() == 0)
        return base;
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(base.transpose());
    MatrixXd pivots(base.cols(), base.cols());
    for (Index i = 0; i < base.cols(); ++i)
        pivots.row(i) = base.row(qr.colsPermutation().indices()[i]);
    return base * pivots.inverse();
}

std::vector<Vec3> modeFrom(const VectorXd& column)
{
    std::vector<Vec3> mode(std::size_t(column.size() / 3));
    double largest = 0.0;
    for (std::size_t p = 0; p < mode.size(); ++p) {
        mode[p] = column.segment<3>(placeOf(int(p)));
        largest = std::max(largest, mode[p].norm());
    }
    for (Vec3& velocity : mode) {
        velocity /= largest;
        if (velocity.norm() < 1e-7)
            velocity.setZero();
    }
    return mode;
}

std::optional<std::array<int, 2>> endsOf(const std::vector<Id>& particles, const Link& link)
{
    const auto from = std::ranges::lower_bound(particles, link.from);
    const auto to = std::ranges::lower_bound(particles, link.to);
    if (from == particles.end() || *from != link.from || to == particles.end() || *to != link.to
        || from == to)
        return std::nullopt;
    return std::array{int(from - particles.begin()), int(to - particles.begin())};
}

} // namespace

Result<Rigidity> rigidityOf(const Scene& scene, const std::vector<Id>& ids)
{
    const Movable movable = movableOf(scene, ids, Ties::Left);
    if (movable.particles.empty())
        return Failure{"Nothing is selected that links could hold. Select particles, links or a "
                       "part."};
    if (movable.particles.size() > mostForRigidity)
        return Failure(
            "%1 particles are too many to look at together. Select at most %2, such as the "
            "frame without the sail.",
            movable.particles.size(), mostForRigidity);
    Rigidity rigidity{movable.particles, movable.position, {}, {}, {}, 0, 0, {}};
    for (const Id id : rigidity.particles) {
        const Particle& row = *std::get<const Particle*>(*find(scene, id));
        rigidity.pinned.push_back(row.pinned);
        const bool isGuided = row.guide != Guide::None && row.guideAxis.norm() > 0.0;
        rigidity.guides.push_back({int(rigidity.guides.size()), isGuided ? row.guide : Guide::None,
                                   row.guideAxis.normalized()});
    }
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links)
            if (const auto ends = endsOf(rigidity.particles, link))
                rigidity.links.push_back(*ends);
    });

    const MatrixXd free = freeOf(stretchesOf(rigidity), rigidity);
    const MatrixXd whole = rigidMotionsOf(rigidity);
    MatrixXd rest = free - whole * (whole.transpose() * free);
    const MatrixXd modes = localised(spanOf(rest));
    rigidity.rigidMotions = int(whole.cols());
    for (Index m = 0; m < modes.cols(); ++m)
        rigidity.modes.push_back(modeFrom(modes.col(m)));
    int ways = 0;
    for (int p = 0; p < int(rigidity.particles.size()); ++p)
        ways += waysOf(rigidity, p);
    const int rank = int(ways - free.cols());
    rigidity.redundant = int(rigidity.links.size()) - rank;
    return rigidity;
}

std::vector<Brace> bracesFor(const Rigidity& rigidity)
{
    const auto count = int(rigidity.particles.size());
    const auto modes = Index(rigidity.modes.size());
    MatrixXd columns(placeOf(count), modes);
    for (Index m = 0; m < modes; ++m)
        for (int p = 0; p < count; ++p)
            columns.col(m).segment<3>(placeOf(p)) = rigidity.modes[std::size_t(m)][std::size_t(p)];
    MatrixXd left = spanOf(columns); // modes that no brace has stopped yet
    std::vector<Brace> braces;
    while (left.cols() > 0) {
        Brace best{-1, -1};
        VectorXd stretch; // of each mode, by the best
        double most = 1e-6;
        for (int a = 0; a < count; ++a)
            for (int b = a + 1; b < count; ++b) {
                const Vec3 between =
                    rigidity.position[std::size_t(b)] - rigidity.position[std::size_t(a)];
                const double length = between.norm();
                if (length == 0.0
                    || (rigidity.pinned[std::size_t(a)] && rigidity.pinned[std::size_t(b)]))
                    continue;
                const VectorXd row =
                    (left.middleRows<3>(placeOf(b)) - left.middleRows<3>(placeOf(a))).transpose()
                    * (between / length);
                const double size = 1.0 + length; // long rods are heavy and in the way
                if (row.norm() > 1e-6 && row.norm() / size > most) {
                    most = row.norm() / size;
                    best = {a, b};
                    stretch = row;
                }
            }
        if (best.from < 0)
            break;
        braces.push_back(best);
        // what is left is orthogonal to what the brace stops
        const MatrixXd stopped = stretch.normalized();
        const Eigen::HouseholderQR<MatrixXd> qr(stopped);
        left = (left * qr.householderQ()).rightCols(left.cols() - 1).eval();
    }
    return braces;
}

Braced withBraces(const Scene& scene, const Rigidity& rigidity, const std::vector<Brace>& braces)
{
    Drawing drawing(scene);
    const Id there = linkMaterialAt(scene, rigidity.particles);
    const LinkStroke stroke{there == noId ? drawing.material(plainCord("braces")) : there,
                            LinkKind::Rod, Resists::Both};
    for (const Brace& brace : braces)
        drawing.link(rigidity.particles[std::size_t(brace.from)],
                     rigidity.particles[std::size_t(brace.to)], stroke);
    std::vector<Id> rods = drawing.made();
    return {drawing.finish(Message("Add braces")), std::move(rods)};
}

} // namespace ripstop
