// Cloths and ropes are put together as systems by hand, because their figures are about the solver
// alone; glider and kite are built and compiled as scenes, as a user gets them, and lose panels and
// ground when they are wanted without air. Every network has the same step and viscosity.
// largestStrain() at the end is what the race for quality judges by.
#include "bench/networks.h"

#include "assembly/finish.h"
#include "builders/builder.h"
#include "compile/compile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double stepOfAll = 0.01;     // s
constexpr double viscosityOfAll = 0.2; // 1/s

void addRod(System& system, int a, int b)
{
    const double length =
        (system.start.position[std::size_t(b)] - system.start.position[std::size_t(a)]).norm();
    system.rods.push_back({a, b, length, 0.0, Resists::Both, {}});
}

std::shared_ptr<System> emptySystem(Solver solver)
{
    auto system = std::make_shared<System>();
    system->timeStep = stepOfAll;
    system->viscosity = viscosityOfAll;
    system->substeps = 1;
    system->solver = solver;
    return system;
}

// Rods between all particles that are `right` columns and `down` rows apart.
void tie(System& system, int side, int right, int down)
{
    for (int row = 0; row + down < side; ++row)
        for (int column = std::max(0, -right); column + std::max(0, right) < side; ++column)
            addRod(system, row * side + column, (row + down) * side + column + right);
}

} // namespace

NetworkSize clothSize(int side)
{
    const auto n = std::size_t(side);
    return {n * n, 2 * n * (n - 1) + 2 * (n - 1) * (n - 1) + 2 * n * (n - 2)};
}

BenchNetwork clothNetwork(int side, Solver solver)
{
    auto system = emptySystem(solver);
    const NetworkSize size = clothSize(side);
    const double spacing = 1.0 / (side - 1);
    system->start.position.reserve(size.particles);
    system->inverseMass.assign(size.particles, double(size.particles) / 0.2);
    system->mass.assign(size.particles, 0.2 / double(size.particles));
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            system->start.position.emplace_back(column * spacing - 0.5, 0.0, row * spacing);
    system->inverseMass[0] = 0.0;
    system->inverseMass[std::size_t(side - 1)] = 0.0;

    system->rods.reserve(size.rods);
    tie(*system, side, 1, 0);
    tie(*system, side, 0, 1);
    const std::size_t structural = system->rods.size();
    tie(*system, side, 1, 1);
    tie(*system, side, -1, 1);
    tie(*system, side, 2, 0);
    tie(*system, side, 0, 2);
    finish(*system);
    return {"cloth_" + std::to_string(side), structural, false, std::move(system)};
}

BenchNetwork ropeNetwork(Solver solver)
{
    constexpr int segments = 100;
    const double angle = std::acos(0.5); // 60 degrees
    auto system = emptySystem(solver);
    for (int i = 0; i <= segments; ++i) {
        system->start.position.push_back(0.1 * i * Vec3(std::sin(angle), -std::cos(angle), 0.0));
        system->mass.push_back(i < segments ? 0.001 : 65.0);
        system->inverseMass.push_back(i > 0 ? 1.0 / system->mass.back() : 0.0);
    }
    for (int i = 0; i < segments; ++i)
        system->rods.push_back({i, i + 1, 0.1, 0.0, Resists::Tension, {}});
    finish(*system);
    return {"rope_pilot", segments, false, std::move(system)};
}

Result<BenchNetwork> craftNetwork(std::string_view name, Air air, Solver solver)
{
    const Builder* builder = findBuilder(name == "kite" ? "delta_kite" : "hang_glider");
    Result<Scene> scene = build(*builder, {});
    if (!scene)
        return scene.failure();
    scene->settings.timeStep = stepOfAll;
    scene->settings.viscosity = viscosityOfAll;
    scene->settings.substeps = 1;
    scene->settings.solver = solver;
    if (air == Air::Without) {
        for (Entry& entry : scene->items)
            if (Part* part = std::get_if<Part>(&entry.item))
                part->panels.clear();
        std::erase_if(scene->items, [](const Entry& entry) {
            return std::holds_alternative<Collider>(entry.item);
        });
    }
    Result<std::shared_ptr<const System>> system = compile(*scene);
    if (!system)
        return system.failure();
    return BenchNetwork{std::string(name) + (air == Air::With ? "_air" : ""),
                        (*system)->links.size(), air == Air::With,
                        std::make_shared<System>(**system)};
}

BenchNetwork networkCalled(const std::string& name, Solver solver)
{
    if (name == "rope_pilot")
        return ropeNetwork(solver);
    if (name.starts_with("cloth_"))
        return clothNetwork(std::stoi(name.substr(6)), solver);
    const Air air = name.ends_with("_air") ? Air::With : Air::Without;
    return *craftNetwork(name.substr(0, name.find('_')), air, solver);
}

double largestStrain(const BenchNetwork& network, const State& state)
{
    const System& system = *network.system;
    double largest = 0.0;
    for (std::size_t i = 0; i < network.judged; ++i) {
        const LinkPlace& link = system.links[i];
        if (link.kind != LinkKind::Rod)
            continue;
        const Rod& rod = system.rods[std::size_t(link.index)];
        const double length =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm();
        const double strain = length / rod.restLength - 1.0;
        const double resisted = rod.resists == Resists::Tension       ? strain
                                : rod.resists == Resists::Compression ? -strain
                                                                      : std::abs(strain);
        if (!std::isfinite(strain))
            return std::numeric_limits<double>::infinity();
        largest = std::max(largest, resisted);
    }
    return largest;
}

} // namespace ripstop
