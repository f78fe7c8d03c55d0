// How hard a hand pulls and blows.
//
// What nobody has set follows the scene: a kite of 40 g and a parachute with its load are not to be
// pulled alike. The settings belong to the viewport and are not saved with a scene; tools read them
// with each move, and the wheel changes those of the fan.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace ripstop {

struct HandSettings
{
    std::optional<double> stiffness;                              // N/m
    std::optional<double> most;                                   // N
    static constexpr double slowestFan = 0.5, fastestFan = 60.0;  // m/s
    static constexpr double narrowestFan = 0.02, widestFan = 1.0; // 1
    double fanSpeed = 8.0;                                        // m/s, in the nozzle
    double fanWidening = 0.2; // 1, tangent of half the angle of the jet

    // The most that a hand pulls with, N: five times the weight of all that is free, and 5 N or
    // more. The stiffness of its spring, N/m, is such that the spring is then as long as a fifth of
    // the fabric. A number that somebody has set comes back as it is.
    double mostIn(const Scene& scene) const;
    double stiffnessIn(const Scene& scene) const;
};

} // namespace ripstop
