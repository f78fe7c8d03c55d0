// Sheets of one material at several resolutions, for tests that say that a mesh must not change
// what a material does.
//
// The sheets come from the builder of cloth, 1 m x 1 m; units stand beside the constants. NEAR
// compares with a relative tolerance and prints both numbers.
#pragma once

#include "model/systems.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cstdlib>

namespace ripstop {

inline constexpr double gravity = 9.80665; // m/s^2
inline constexpr double density = 0.25;    // kg/m^2
inline constexpr double membrane = 1000.0; // N/m

// A sheet of 1 m x 1 m of the same material at any resolution.
inline Parameters sheet(int cells, double hang, double shear)
{
    return {{"columns", cells},   {"rows", cells}, {"hang", hang},         {"shear", shear},
            {"density", density}, {"bend", 0},     {"membrane", membrane}, {"stiffness", 1},
            {"sphere", 0},        {"level", 2}};
}

inline Part& partOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

inline std::vector<Id> materialsOf(const Scene& scene)
{
    std::vector<Id> ids;
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Material>(entry.item))
            ids.push_back(entry.id);
    return ids;
}

inline State settled(const Scene& scene, double seconds)
{
    Simulation simulation(*compile(scene, 1, 1));
    (void)simulation.runUntil(seconds);
    return simulation.state();
}

inline void addResolutions()
{
    QTest::addColumn<int>("cells");
    QTest::newRow("10 x 10") << 10;
    QTest::newRow("20 x 20") << 20;
    QTest::newRow("40 x 40") << 40;
}

#define NEAR(got, expected, share)                                                                 \
    QVERIFY2(isNear(got, expected, (share)*std::abs(expected)), told(got, expected))

} // namespace ripstop
