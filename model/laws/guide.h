// Particles that are free along a line or in a plane only: rings on a rail, beads on a wire, the
// feet of a frame on ice.
//
// A guide takes up all force across it and gives no friction. With P = t t^T along a line, or
// 1 - n n^T in a plane, a particle of mass m on one obeys
//
//     a = P f / m,
//
// as if its inverse mass were the matrix P / m. It does no work, and momentum along it is kept. A
// guide runs through wherever its particle is: nothing across it ever moves the particle but a
// control, which moves the guide along.
#pragma once

#include "base/choice_names.h"
#include "base/vec3.h"

#include <cstdint>

namespace ripstop {

enum class Guide : std::uint8_t { None, Line, Plane }; // what a particle cannot leave
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Guide>{"none", "line", "plane"};

struct GuidedParticle
{
    int particle = -1; // index
    Guide guide = Guide::None;
    Vec3 axis = Vec3::UnitX(); // unit vector, along the line or across the plane

    Vec3 freePart(const Vec3& vector) const // P times the vector
    {
        switch (guide) {
        case Guide::Line:
            return vector.dot(axis) * axis;
        case Guide::Plane:
            return vector - vector.dot(axis) * axis;
        case Guide::None:
            break;
        }
        return vector;
    }

    friend bool operator==(const GuidedParticle&, const GuidedParticle&) = default;
};

} // namespace ripstop
