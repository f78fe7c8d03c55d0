// Motions and their edits:
// 1. shifted(), turned() and scaled() make an affine map; a scaling is not rigid.
// 2. placed() moves a collider: its place and path by the map, its normal by the inverse
//    transpose, its angles by the turn, and its sizes by the factors where its axes allow that,
//    else evenly.
// 3. moved() and relocated() make the edit: positions, guide axes, rest lengths of links that
//    change, and for colliders every property that such a motion may change, since only edits of
//    the same targets merge into one gesture.
#include "shaping/transform.h"

#include "derived/collider_shape.h"
#include "scene/collider_path.h"

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// The inverse of turnOf(): degrees about x, then y, then z.
Vec3 anglesOf(const Eigen::Matrix3d& turn)
{
    const double y = std::asin(std::clamp(-turn(2, 0), -1.0, 1.0));
    const bool upright = std::abs(turn(2, 0)) > 1.0 - 1e-12; // then x and z turn about one axis
    const double x = upright ? 0.0 : std::atan2(turn(2, 1), turn(2, 2));
    const double z =
        upright ? std::atan2(-turn(0, 1), turn(1, 1)) : std::atan2(turn(1, 0), turn(0, 0));
    return degrees * Vec3(x, y, z);
}

std::string pathText(const std::vector<PathKey>& path)
{
    std::string text;
    for (const PathKey& key : path) {
        text.append(text.empty() ? "" : "; ").append(textFromValue(key.time)).append(":");
        for (int axis = 0; axis < 3; ++axis)
            text.append(" ").append(textFromValue(key.place[axis]));
    }
    return text;
}

// The properties that a motion changes beside the place.
std::vector<const Property*> shapeProperties(const Collider& collider, bool rigid)
{
    const ShapeUses& uses = rowOf(collider.shape).uses;
    std::vector<const Property*> properties;
    if (uses.normal)
        properties.push_back(&propertyOf<&Collider::normal>());
    if (rigid && uses.turn)
        properties.push_back(&propertyOf<&Collider::turn>());
    if (!rigid && uses.radius)
        properties.push_back(&propertyOf<&Collider::radius>());
    if (!rigid && uses.size)
        properties.push_back(&propertyOf<&Collider::size>());
    if (!rigid && uses.scale)
        properties.push_back(&propertyOf<&Collider::scale>());
    return properties;
}

// By how much a radius grows when the axes of the shape grow by these factors, whose mean for all
// three is `growth`.
double radiusGrowth(Round round, const Vec3& factors, double growth)
{
    switch (round) {
    case Round::Everywhere:
        break;
    case Round::AboutY:
        return std::sqrt(std::abs(factors.x() * factors.z()));
    }
    return growth;
}

// Sets everything that a motion may change, also what stays as it is, because steps of one gesture
// merge only when they set the same things.
void addCollider(Edit& edit, const MovableCollider& one, const Motion& motion)
{
    const Collider now = placed(one.collider, motion);
    const auto set = [&](const Property& property) {
        edit.changes.emplace_back(SetValues{&property, {one.id}, {property.get(&now)}});
    };
    set(propertyOf<&Collider::position>());
    if (!now.path.empty())
        set(propertyOf<&Collider::path>());
    for (const Property* property : shapeProperties(now, motion.rigid))
        set(*property);
}

void bind(SetValues& lengths, const std::vector<Tie>& ties, const std::vector<Vec3>& places)
{
    for (const Tie& tie : ties) {
        const Vec3& from = tie.from < 0 ? tie.fromPosition : places[std::size_t(tie.from)];
        const Vec3& to = tie.to < 0 ? tie.toPosition : places[std::size_t(tie.to)];
        lengths.targets.push_back(tie.link);
        lengths.values.emplace_back((to - from).norm());
    }
}

enum class Among { Left, Bound }; // rest lengths of links among what moves

Edit edited(const Movable& movable, const std::vector<Vec3>& places, RestLengths restLengths,
            Among among, Message label)
{
    Edit edit{std::move(label), {}};
    if (!places.empty())
        edit.changes.emplace_back(SetValues{&propertyOf<&Particle::position>(), movable.particles,
                                            std::vector<Value>(places.begin(), places.end())});
    SetValues lengths{&propertyOf<&Link::restLength>(), {}, {}};
    if (restLengths == RestLengths::Rebind) {
        bind(lengths, movable.crossing, places);
        if (among == Among::Bound)
            bind(lengths, movable.inside, places);
    }
    if (!lengths.targets.empty())
        edit.changes.emplace_back(std::move(lengths));
    return edit;
}

} // namespace

Motion shifted(const Vec3& by)
{
    Motion motion;
    motion.map.translate(by);
    return motion;
}

Motion turned(const Vec3& pivot, const Vec3& axis, double angle)
{
    Motion motion;
    motion.map.translate(pivot)
        .rotate(Eigen::AngleAxisd(angle, axis.normalized()))
        .translate(-pivot);
    return motion;
}

Motion scaled(const Vec3& pivot, const Vec3& factors, const Eigen::Matrix3d& axes)
{
    Motion motion;
    const Eigen::Matrix3d stretch = axes * factors.asDiagonal() * axes.transpose();
    motion.map.linear() = stretch;
    motion.map.translation() = pivot - stretch * pivot;
    motion.rigid = false;
    return motion;
}

Collider placed(const Collider& was, const Motion& motion)
{
    Collider now = was;
    const Eigen::Matrix3d linear = motion.map.linear();
    now.position = motion.map * was.position;
    if (const auto path = pathFromText(was.path); path && !path->empty()) {
        std::vector<PathKey> keys = *path;
        for (PathKey& key : keys)
            key.place = motion.map * key.place;
        now.path = pathText(keys);
    }
    const ShapeRow& row = rowOf(was.shape);
    if (row.uses.normal)
        now.normal = (linear.inverse().transpose() * was.normal).normalized();
    if (motion.rigid) {
        // most shapes are their own mirror image, so that a mirrored one is a turned one
        const double hand = linear.determinant() < 0.0 ? -1.0 : 1.0;
        now.turn = anglesOf(linear * turnOf(was) * Vec3(hand, 1.0, 1.0).asDiagonal());
        return now;
    }
    const double growth = std::cbrt(std::abs(linear.determinant()));
    const bool upright = was.turn.isZero() && linear.isDiagonal();
    const Vec3 factors = upright ? Vec3(linear.diagonal()) : Vec3::Constant(growth);
    now.radius = radiusGrowth(row.round, factors, growth) * was.radius;
    now.scale = growth * was.scale;
    now.size = factors.cwiseProduct(was.size);
    return now;
}

Edit relocated(const Movable& movable, const std::vector<Vec3>& places, RestLengths restLengths,
               Message label)
{
    return edited(movable, places, restLengths, Among::Bound, std::move(label));
}

Vec3 turnedAxis(Guide guide, const Vec3& axis, const Eigen::Matrix3d& linear)
{
    if (guide == Guide::None || linear.isIdentity(0.0))
        return axis;
    if (guide == Guide::Line)
        return linear * axis;
    return (linear.inverse().transpose() * axis).normalized() * axis.norm();
}

Edit moved(const Movable& movable, const Motion& motion, RestLengths restLengths, Message label)
{
    std::vector<Vec3> places;
    places.reserve(movable.position.size());
    for (const Vec3& was : movable.position)
        places.push_back(motion.map * was);
    Edit edit = edited(movable, places, restLengths, motion.rigid ? Among::Left : Among::Bound,
                       std::move(label));
    SetValues axes{&propertyOf<&Particle::guideAxis>(), {}, {}};
    for (const MovableGuide& one : movable.guides) {
        axes.targets.push_back(one.particle);
        axes.values.emplace_back(turnedAxis(one.guide, one.axis, motion.map.linear()));
    }
    if (!axes.targets.empty())
        edit.changes.emplace_back(std::move(axes));
    for (const MovableCollider& one : movable.colliders)
        addCollider(edit, one, motion);
    return edit;
}

Message movingLabel(const Message& verb, const Movable& movable)
{
    const std::size_t ofParticles = movable.particles.size();
    const std::size_t ofColliders = movable.colliders.size();
    const Message particles =
        ofParticles == 1 ? Message("1 particle") : Message("%1 particles", ofParticles);
    const Message colliders =
        ofColliders == 1 ? Message("1 collider") : Message("%1 colliders", ofColliders);
    return verb.with(ofColliders == 0   ? particles
                     : ofParticles == 0 ? colliders
                                        : Message("%1 and %2", particles, colliders));
}

} // namespace ripstop
