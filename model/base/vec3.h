// Vectors of three numbers: Vec3 for all of the program, PaddedVec3 for the arrays of the solver.
//
// Both are points, displacements, velocities or forces, in SI units; y is up. A Vec3 that is given
// no value holds anything; a PaddedVec3 starts as zero.
#pragma once

#include <Eigen/Core>

namespace ripstop {

// 24 bytes without padding, so that the viewport can show an array of them in place.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

static_assert(sizeof(Vec3) == 3 * sizeof(double));

// A Vec3 that fills one vector register, so that the solver loads and stores it at once. The fourth
// number is zero and stays zero.
struct alignas(32) PaddedVec3 : Vec3
{
    PaddedVec3()
        : Vec3(Vec3::Zero())
    {}
    PaddedVec3(double x, double y, double z)
        : Vec3(x, y, z)
    {}
    template <typename Derived>
    PaddedVec3(const Eigen::MatrixBase<Derived>& value) // NOLINT: as Eigen's own vectors
        : Vec3(value)
    {}

    double padding = 0.0;
};

static_assert(sizeof(PaddedVec3) == 4 * sizeof(double));

} // namespace ripstop
