// The small systems of the cases (verify/small_systems.h), and the words with which a test reports
// a number.
#pragma once

#include "verify/small_systems.h"

#include <cstdio>

namespace ripstop {

inline bool isNear(double got, double expected, double tolerance)
{
    return std::abs(got - expected) <= tolerance;
}

inline bool isNear(const Vec3& got, const Vec3& expected, double tolerance)
{
    return (got - expected).norm() <= tolerance;
}

// For QVERIFY2: lives until the next call.
inline const char* told(double got, double expected)
{
    static char text[120];
    std::snprintf(text, sizeof text, "got %.12g, expected %.12g, difference %.3g", got, expected,
                  got - expected);
    return text;
}

inline const char* told(const Vec3& got, const Vec3& expected)
{
    static char text[240];
    std::snprintf(text, sizeof text,
                  "got (%.12g, %.12g, %.12g), expected (%.12g, %.12g, %.12g), difference %.3g",
                  got.x(), got.y(), got.z(), expected.x(), expected.y(), expected.z(),
                  (got - expected).norm());
    return text;
}

} // namespace ripstop
