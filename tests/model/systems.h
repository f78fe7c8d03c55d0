// The small systems of the cases (verify/small_systems.h) for tests of the engine, with obstacles
// that cost as much as any, comparisons by an absolute tolerance, and the words with which a test
// reports a number. Lengths are in m.
#pragma once

#include "verify/small_systems.h"

#include <cstdio>

namespace ripstop {

// A box, hills and a roof of two triangles around this place, each 1 m wide; the box moves.
inline void addCostlyObstacles(System& system, const Vec3& place)
{
    Obstacle box{ColliderShape::Box, place, Vec3::UnitY(), 0.0, Response::Contact, 0.3, 0.4};
    box.thickness = 0.02;
    box.turn << 0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0;
    box.path = {{0.0, place}, {1.0, place + Vec3(0.5, 0.0, 0.0)}};
    Obstacle hills = box;
    hills.shape = ColliderShape::HeightField;
    hills.path.clear();
    hills.position += Vec3(1.0, -0.5, 0.0);
    hills.grid = std::make_shared<const HeightGrid>(generatedHills(32, 5, 0.3));
    Obstacle roof = hills;
    roof.shape = ColliderShape::Mesh;
    roof.position += Vec3(1.0, 0.0, 0.0);
    roof.mesh = std::make_shared<const TriangleTree>(
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0.3, 1}},
        std::vector<std::array<int, 3>>{{0, 2, 1}, {1, 2, 3}});
    for (const Obstacle& obstacle : {box, hills, roof})
        system.obstacles.push_back(obstacle);
}

// Has the residual measured, so that the ledger is kept.
inline void askForLedger(System& system)
{
    system.probes.push_back({.key = Key(99),
                             .name = "residual",
                             .quantity = Quantity::EnergyResidual,
                             .particles = {},
                             .links = {},
                             .panels = {},
                             .unit = "J",
                             .formula = {}});
}

inline bool isNear(double got, double expected, double tolerance)
{
    return std::abs(got - expected) <= tolerance;
}

inline bool isNear(const Vec3& got, const Vec3& expected, double tolerance)
{
    return (got - expected).norm() <= tolerance;
}

// The text is for QVERIFY2 and lives until the next call.
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
