// Which ways a network gives way without any link growing longer or shorter, to first order.
//
// A link between i and j keeps its length as long as (p_i - p_j) . (v_i - v_j) = 0. Velocities that
// all links allow, less those of the whole as a rigid body, are floppy modes; links that say
// nothing new are redundant. With n free particles and b links: modes - redundant = 3 n - b - rigid
// motions (Maxwell 1864; Calladine 1978, with states of self-stress for the redundant ones).
//
// A particle on a guide (laws/guide.h) has one way to go along a line, two in a plane.
//
// Every link counts as one that resists both ways. A flat network always gives way across its
// plane: only something out of the plane, as rigidity particles are, can hold it.
#pragma once

#include "base/result.h"
#include "laws/guide.h"
#include "scene/edit.h"

#include <Eigen/Core>

#include <vector>

namespace ripstop {

struct Rigidity
{
    std::vector<Id> particles;             // ascending
    std::vector<Vec3> position;            // [particles] m
    std::vector<char> pinned;              // [particles]
    std::vector<GuidedParticle> guides;    // [particles] what is not pinned may be on one
    std::vector<std::array<int, 2>> links; // indices of particles
    int rigidMotions = 0;                  // of the whole, that pins leave: 6 of a free body
    int redundant = 0;                     // links

    // Each of largest displacement 1 and moving as little else as can be.
    std::vector<std::vector<Vec3>> modes; // [modes][particles]
};

// Above this many particles it is refused: what it takes grows with their cube.
inline constexpr std::size_t mostForRigidity = 300;

// Of the selected particles and all links among them. Fails with a sentence when there are too
// many, or none.
Result<Rigidity> rigidityOf(const Scene& scene, const std::vector<Id>& ids);

struct Brace
{
    int from; // indices of particles
    int to;

    friend bool operator==(const Brace&, const Brace&) = default;
};

// Rods that take the modes away, one for each, which is the least there can be; short ones first.
// Fewer when no rod between these particles can stop the rest.
std::vector<Brace> bracesFor(const Rigidity& rigidity);

struct Braced
{
    Edit edit;
    std::vector<Id> rods;
};

// Draws the braces, of what the links there are made of.
Braced withBraces(const Scene& scene, const Rigidity& rigidity, const std::vector<Brace>& braces);

} // namespace ripstop
