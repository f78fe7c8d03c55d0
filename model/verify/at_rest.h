// A scene that has come to rest, and what its panels carry then.
#pragma once

#include "builders/network.h"
#include "system/membrane.h"

#include <memory>
#include <vector>

namespace ripstop {

// A scene after a while. A run that did not get that far is not a number anywhere.
struct AtRest
{
    std::shared_ptr<const System> system;
    State state;

    // The mean of what `of` is of the tension in panels, N/m; x and y are those of the flat cloth
    // where `warp` is 0.
    template <typename Of> // of(tension, middle of the panel)
    double mean(Of of) const
    {
        double sum = 0.0, area = 0.0;
        for (const Membrane& membrane : system->membranes) {
            const Corners corners = cornersOf(*system, membrane, state.position);
            const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            sum += membrane.area * of(tensionIn(*system, membrane, corners).tension, middle);
            area += membrane.area;
        }
        return sum / area;
    }

    // What the panels pull back with against a small motion of the particles, N: the work that it
    // takes, per metre of it.
    double against(const std::vector<Vec3>& way) const; // [particles] 1
};

AtRest restOf(const Scene& scene, double seconds);
AtRest restOf(std::shared_ptr<const System> system, const State& from, double seconds);

} // namespace ripstop
