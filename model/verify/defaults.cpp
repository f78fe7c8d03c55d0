// What a new scene gets without choosing anything: the solver, steps and accuracy are those that
// Settings begins with, so that a stiffness that is typed is the stiffness that is flown.
//
// Sheets of kite cloth and lines hang loads that stretch them by little; the stretch follows from
// the stiffness alone. Viscosity lets them come to rest and changes nothing of where that is.
#include "builders/builder.h"
#include "compile/compile.h"
#include "simulation/simulation.h"
#include "verify/sections.h"
#include "verify/small_systems.h"
#include "verify/text.h"

namespace ripstop {
namespace {

constexpr double clothStiffness = 40e3; // N/m, of kite cloth
constexpr double clothDensity = 0.047;  // kg/m^2

// 1 m x 1 m of threads, hung by its upper edge, with a load along the lower one; each thread
// carries as much as the width that it stands for.
Scene hungSheet(int cells, double load)
{
    Scene scene;
    scene.settings.viscosity = 1.0;
    scene.settings.airDensity = 0.0;
    Material cloth;
    cloth.membraneStiffness = clothStiffness;
    Part part;
    std::uint32_t next = 1;
    const Id material = Id(next++);
    const double cell = 1.0 / cells;
    const auto share = [&](int k) { return k == 0 || k == cells ? 0.5 * cell : cell; }; // m
    const auto at = [&](int column, int row) {
        return part.particles[std::size_t(row * (cells + 1) + column)].id;
    };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            Particle particle;
            particle.id = Id(next++);
            particle.position = Vec3(column * cell, 2.0 - row * cell, 0.0);
            particle.mass = clothDensity * share(column) * share(row);
            if (row == cells)
                particle.mass += load * share(column);
            particle.pinned = row == 0;
            part.particles.push_back(particle);
        }
    const auto thread = [&](Id from, Id to, double width) {
        Link link;
        link.id = Id(next++);
        link.from = from;
        link.to = to;
        link.material = material;
        link.kind = LinkKind::Rod;
        link.restLength = cell;
        link.role = LinkRole::Thread;
        link.width = width;
        part.links.push_back(link);
    };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            if (row < cells)
                thread(at(column, row), at(column, row + 1), share(column));
            if (column < cells)
                thread(at(column, row), at(column + 1, row), share(row));
        }
    scene.items.push_back({material, cloth});
    scene.items.push_back({Id(next++), part});
    scene.nextId = Id(next);
    return scene;
}

double drop(int cells, double load) // m, of the middle of the lower edge
{
    Simulation simulation(*compile(hungSheet(cells, load)));
    (void)simulation.runUntil(2.0);
    const auto middle = std::size_t((cells + 1) * cells + cells / 2);
    return 1.0 - simulation.state().position[middle].y();
}

struct HungLine
{
    int segments;
    double length, mass, load, axial; // m, kg, kg, N
};

double growth(const HungLine& line) // m
{
    Scene scene = *build(*findBuilder("rope"), {{"segments", line.segments},
                                                {"length", line.length},
                                                {"density", line.mass / line.length},
                                                {"axial", line.axial},
                                                {"end_mass", line.load},
                                                {"angle", 0}});
    scene.settings.viscosity = 1.0;
    scene.settings.airDensity = 0.0;
    Simulation simulation(*compile(scene));
    (void)simulation.runUntil(16.0);
    const auto& position = simulation.state().position; // the rope's ends come first
    return Vec3(position[0] - position[1]).norm() - line.length;
}

} // namespace

std::vector<Case> defaultCases()
{
    std::vector<Case> cases;
    constexpr double load = 10.0;
    for (const int cells : {8, 40})
        cases.push_back({"D-S",
                         "kite cloth of E t 40 kN/m hangs 10 kg by default, "
                             + std::to_string(cells) + " x " + std::to_string(cells),
                         standardGravity * (load + 0.5 * clothDensity) / clothStiffness,
                         relative(0.01), "m", "(M + m / 2) g L / (E t W)",
                         [=] { return drop(cells, load); }});
    const HungLine pilot{50, 10.0, 0.5, 65.0, 1e5};
    std::vector<HungLine> lines{pilot};
    for (const double axial : {100.0, 1e4, 1e6, 1e8})
        lines.push_back({30, 10.0, 0.03, 1.0, axial});
    for (const HungLine& line : lines)
        cases.push_back({"D-L",
                         "line of EA " + digits(line.axial, 4) + " N hangs " + digits(line.load, 4)
                             + " kg by default, " + std::to_string(line.segments) + " rods",
                         standardGravity * (line.load + 0.5 * line.mass) * line.length / line.axial,
                         relative(0.01), "m", "(M + m / 2) g L / (EA)",
                         [=] { return growth(line); }});
    return cases;
}

} // namespace ripstop
