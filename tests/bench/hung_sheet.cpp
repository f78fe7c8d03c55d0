#include "hung_sheet.h"

#include "builders/network.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double membrane = 40e3; // N/m
constexpr double density = 0.047; // kg/m^2
constexpr double load = 10.0;     // kg
constexpr double viscosity = 6.0; // 1/s

} // namespace

Scene HungSheet::scene() const
{
    Scene scene;
    scene.settings.timeStep = 0.01;
    scene.settings.viscosity = viscosity;
    scene.settings.airDensity = 0.0;
    Material cloth;
    cloth.membraneStiffness = membrane;
    cloth.dampingTime = dampingTime;
    const Id made = addItem(scene, cloth);
    Network network(scene, "sheet");
    std::vector<Id> ids;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const double below = row == cells ? load : 0.0;
            ids.push_back(network.particle(Vec3(double(column) / cells, -double(row) / cells, 0.0),
                                           share(column) * (density * share(row) + below)));
            network.row(ids.back()).pinned = row == 0;
        }
    const auto thread = [&](int from, int to, double width) {
        network.rod(ids[std::size_t(from)], ids[std::size_t(to)], made);
        network.asFabric({LinkRole::Thread, width});
    };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const int node = row * (cells + 1) + column;
            if (row < cells)
                thread(node, node + cells + 1, share(column));
            if (column < cells)
                thread(node, node + 1, share(row));
        }
    network.finish({}, {});
    return scene;
}

double HungSheet::dropAt(double time) const
{
    const double square = membrane / (load + density / 3.0); // rad^2/s^2
    const double decay = 0.5 * (viscosity + square * dampingTime);
    const double swing = std::sqrt(square - decay * decay); // rad/s
    return 1.0
           - std::exp(-decay * time)
                 * (std::cos(swing * time) + decay / swing * std::sin(swing * time));
}

double HungSheet::pullOf(int particle) const
{
    const int row = particle / (cells + 1);
    const double below = 1.0 - (row + 0.5) / cells; // m, of cloth
    return share(particle % (cells + 1)) * standardGravity * (load + density * below);
}

HungSheet::Instant HungSheet::instant(const System& system,
                                      const std::function<double(int)>& height,
                                      const std::function<double(std::size_t)>& tension) const
{
    Instant now;
    for (int column = 0; column <= cells; ++column)
        now.drop -= share(column) * (height(cells * (cells + 1) + column) + 1.0);
    now.drop /= standardGravity * (load + 0.5 * density) / membrane;
    int threads = 0;
    for (std::size_t i = 0; i < system.links.size(); ++i) {
        const LinkPlace& link = system.links[i];
        if (link.b != link.a + cells + 1)
            continue;
        const double error = std::abs(tension(i) / pullOf(link.a) - 1.0);
        now.pull += error * error;
        now.worstPull = std::max(now.worstPull, error);
        ++threads;
    }
    now.pull = std::sqrt(now.pull / threads);
    return now;
}

} // namespace ripstop
