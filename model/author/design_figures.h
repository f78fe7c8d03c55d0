// What a design comes to, in numbers that follow from it: counts, mass, areas, lengths and the
// cost of its time step. The dialog of builders shows them while parameters change; it calls this
// on a built scene without errors. Nothing here depends on a simulation.
#pragma once

#include "builders/builder.h"

#include <optional>

namespace ripstop {

struct DesignFigures
{
    std::size_t particles = 0;
    std::size_t links = 0;
    std::size_t panels = 0;
    double mass = 0.0;            // kg
    double area = 0.0;            // m^2, of all panels laid out flat
    Vec3 size = Vec3::Zero();     // m, of the box around the particles
    double lineLength = 0.0;      // m, of links that only pull, are seen and edge no panel
    double span = 0.0;            // m, of the panels, along z
    std::optional<double> aspect; // 1, of wings: span^2 over the area seen along the lift
    int substeps = 0;             // of a time step; 0 where the solver chooses them
    double timeStep = 0.0;        // s
};

DesignFigures designFiguresOf(const Scene& scene, Family family);

} // namespace ripstop
