// What a selection moves: particles, and colliders.
//
// Links and panels mean the particles at their ends and corners, items all that they contain: a
// part its particles, a group its members, a material what is made of it, a control or a probe
// what it acts on.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// The particles that the ids mean, in ascending order, each once. Ids of nothing are left out.
std::vector<Id> particlesOf(const Scene& scene, const std::vector<Id>& ids);

// A link that has an end or both among the particles that move.
struct Tie
{
    Id link;
    int from;          // place in Movable::particles, -1 when this end stays where it is
    int to;            // place in Movable::particles, or -1
    Vec3 fromPosition; // m
    Vec3 toPosition;   // m
    double restLength; // m
};

struct MovableCollider
{
    Id id;
    Collider collider;
};

struct MovableGuide
{
    Id particle;
    Guide guide;
    Vec3 axis;
};

// Where everything stood when a gesture began, so that each of its steps starts from there and
// sets the same things.
struct Movable
{
    std::vector<Id> particles;        // ascending
    std::vector<Vec3> position;       // [particles] m
    std::vector<double> mass;         // [particles] kg
    std::vector<MovableGuide> guides; // of those particles that have one
    std::vector<MovableCollider> colliders;
    std::vector<Tie> crossing; // links with one end among the particles
    std::vector<Tie> inside;   // links with both

    bool isEmpty() const { return particles.empty() && colliders.empty(); }
};

enum class Ties { Found, Left };
Movable movableOf(const Scene& scene, const std::vector<Id>& ids, Ties ties = Ties::Found);

enum class Pivot { Mass, Median, Box, Particle };

// m. Of colliders, their positions count, without mass. Where nothing has mass, the centre of mass
// is the median; the origin when there is nothing.
// `particle` is what Pivot::Particle turns about; the median when it is not there.
Vec3 pivotOf(const Scene& scene, const Movable& movable, Pivot pivot, Id particle = noId);

// How far it spreads along each of its principal axes, the root of the mean square, m; the most
// first.
Vec3 spreadOf(const Movable& movable);

// The principal axes, as columns: x along which it spreads most, as a link or a spar; z across what
// it lies in, as a panel; each so that its largest component is positive but the third, which
// follows from the others. Those of the world for a single particle.
Eigen::Matrix3d ownAxes(const Movable& movable);

} // namespace ripstop
