// Lines things up in three stages: bodiesOf() decides what moves as a whole (each item when two or
// more are selected, otherwise each particle and collider) and its interval along the axis; align
// and distribute compute a shift for each body; shiftedBodies() makes one edit of all shifts, with
// rest lengths as asked. Flattening works on particles alone: the eigenvector of least spread is
// the normal of the plane.
#include "shaping/align.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

// What moves as a whole: places in Movable::particles, and a collider.
struct Body
{
    std::vector<int> particles;
    int collider = -1; // place in Movable::colliders
    double low = 0.0;  // m, along the axis
    double high = 0.0;

    double middle() const { return 0.5 * (low + high); }
};

std::vector<Body> bodiesOf(const Scene& scene, const Movable& movable, const std::vector<Id>& ids,
                           int axis)
{
    std::vector<Body> bodies;
    const auto items =
        std::ranges::count_if(ids, [&](Id id) { return findItem(scene, id) != nullptr; });
    if (items < 2) {
        for (std::size_t i = 0; i < movable.particles.size(); ++i)
            bodies.push_back({{int(i)}, -1, movable.position[i][axis], movable.position[i][axis]});
        for (std::size_t i = 0; i < movable.colliders.size(); ++i) {
            const double at = movable.colliders[i].collider.position[axis];
            bodies.push_back({{}, int(i), at, at});
        }
        return bodies;
    }
    for (const Id id : ids) {
        Body body;
        for (const Id particle : particlesOf(scene, {id})) {
            const auto found = std::ranges::lower_bound(movable.particles, particle);
            const int place = int(found - movable.particles.begin());
            const double at = movable.position[std::size_t(place)][axis];
            body.low = body.particles.empty() ? at : std::min(body.low, at);
            body.high = body.particles.empty() ? at : std::max(body.high, at);
            body.particles.push_back(place);
        }
        for (std::size_t i = 0; i < movable.colliders.size(); ++i)
            if (movable.colliders[i].id == id) {
                body.collider = int(i);
                body.low = body.high = movable.colliders[i].collider.position[axis];
            }
        if (!body.particles.empty() || body.collider >= 0)
            bodies.push_back(std::move(body));
    }
    return bodies;
}

//   shift  [bodies]  m along the axis
Edit shiftedBodies(const Movable& movable, const std::vector<Body>& bodies,
                   const std::vector<double>& shift, int axis, RestLengths restLengths,
                   Message label)
{
    std::vector<Vec3> places = movable.position;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (const int particle : bodies[i].particles) {
            // from where it stood: a particle of two groups moves with the last
            Vec3& place = places[std::size_t(particle)];
            place[axis] = movable.position[std::size_t(particle)][axis] + shift[i];
        }
    Edit edit = relocated(movable, places, restLengths, std::move(label));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].collider < 0)
            continue;
        Movable one;
        one.colliders = {movable.colliders[std::size_t(bodies[i].collider)]};
        Edit along = moved(one, shifted(shift[i] * Vec3::Unit(axis)), restLengths, {});
        std::ranges::move(along.changes, std::back_inserter(edit.changes));
    }
    return edit;
}

} // namespace

Edit aligned(const Scene& scene, const std::vector<Id>& ids, int axis, Side side,
             RestLengths restLengths)
{
    const Movable movable = movableOf(scene, ids);
    const std::vector<Body> bodies = bodiesOf(scene, movable, ids, axis);
    if (bodies.size() < 2)
        return {Message("Align"), {}};
    const double low = std::ranges::min_element(bodies, {}, &Body::low)->low;
    const double high = std::ranges::max_element(bodies, {}, &Body::high)->high;
    std::vector<double> shift;
    for (const Body& body : bodies)
        shift.push_back(side == Side::Least  ? low - body.low
                        : side == Side::Most ? high - body.high
                                             : 0.5 * (low + high) - body.middle());
    return shiftedBodies(movable, bodies, shift, axis, restLengths, Message("Align"));
}

Edit distributed(const Scene& scene, const std::vector<Id>& ids, int axis, RestLengths restLengths)
{
    const Movable movable = movableOf(scene, ids);
    const std::vector<Body> bodies = bodiesOf(scene, movable, ids, axis);
    if (bodies.size() < 3)
        return {Message("Distribute"), {}};
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return bodies[i].middle(); });
    const double first = bodies[order.front()].middle();
    const double step = (bodies[order.back()].middle() - first) / double(bodies.size() - 1);
    std::vector<double> shift(bodies.size(), 0.0);
    for (std::size_t k = 1; k + 1 < order.size(); ++k)
        shift[order[k]] = first + double(k) * step - bodies[order[k]].middle();
    return shiftedBodies(movable, bodies, shift, axis, restLengths, Message("Distribute"));
}

Edit flattened(const Scene& scene, const std::vector<Id>& ids, RestLengths restLengths)
{
    Movable movable = movableOf(scene, ids);
    if (movable.particles.size() < 3)
        return {Message("Flatten"), {}};
    Vec3 mean = Vec3::Zero();
    for (const Vec3& place : movable.position)
        mean += place / double(movable.position.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& place : movable.position)
        spread += (place - mean) * (place - mean).transpose();
    const Vec3 normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
    std::vector<Vec3> places;
    for (const Vec3& place : movable.position)
        places.push_back(place - normal.dot(place - mean) * normal);
    return relocated(movable, places, restLengths, Message("Flatten"));
}

} // namespace ripstop
