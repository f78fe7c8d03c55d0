// made() builds the scene of the parachute builder, with its payload pinned where it is held in the
// wind. fly() runs it and notes the drag area, m^2, and the speed after each step; both drag and
// pull are means over 1/40 s. The canopy at the end gives its size, and fitFilling() the way to the
// full drag area and the exponent of its growth, by least squares on logarithmic scales along lines
// through the point where it is full.
#include "verify/opening.h"

#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "verify/reference_sections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ripstop {
namespace {

// Widest radius of the canopy about its middle, m, and how far the crown is above it.
struct Size
{
    double radius = 0.0;
    double height = 0.0;
};

Size sizeOf(const Canopy& canopy, const State& state, int sectors)
{
    const auto at = [&](int place) -> Vec3 {
        return state.position[std::size_t(canopy.particles[std::size_t(place)])];
    };
    Vec3 middle = Vec3::Zero();
    for (const int place : canopy.mouth)
        middle += at(place) / double(canopy.mouth.size());
    const Vec3 crown = at(0);
    const Vec3 axis = (crown - middle).normalized();
    Size size;
    for (std::size_t ring = 0; 1 + (ring + 1) * std::size_t(sectors) <= canopy.particles.size();
         ++ring) {
        Size mean;
        for (int sector = 0; sector < sectors; ++sector) {
            const Vec3 off = at(int(1 + ring * std::size_t(sectors)) + sector) - crown;
            mean.height -= off.dot(axis) / sectors;
            mean.radius += (off - off.dot(axis) * axis).norm() / sectors;
        }
        if (mean.radius > size.radius)
            size = mean;
    }
    return size;
}

// From the drag area after each step, m^2: what it is in the end, when it is that for the first
// time, and the line through that point on logarithmic scales. `stepLength` is the way of a step
// over the nominal diameter.
void fitFilling(const std::vector<double>& dragArea, double stepLength, Flight& flight)
{
    const std::size_t count = dragArea.size();
    double full = 0.0; // mean of the last sixth
    for (std::size_t i = count - count / 6; i < count; ++i)
        full += dragArea[i] / double(count / 6);
    const auto end = std::size_t(
        std::find_if(dragArea.begin(), dragArea.end(), [&](double now) { return now >= full; })
        - dragArea.begin());
    double xx = 0.0, xy = 0.0;
    for (std::size_t i = end / 5; i < end; ++i) {
        const double x = std::log(double(i + 1) / double(end + 1));
        xx += x * x;
        xy += x * std::log(dragArea[i] / full);
    }
    flight.drag = full;
    flight.filled = double(end + 1) * stepLength;
    flight.growth = xy / xx;
}

} // namespace

std::unique_ptr<Simulation> made(const Chute& chute)
{
    Parameters parameters = chute.parameters;
    parameters.emplace("cloth", 0.0); // ideal, as heavy and porous as the chute says
    parameters["speed"] = chute.held ? 0.0 : chute.speed;
    Scene scene = *build(*findBuilder("parachute"), parameters);
    scene.settings.gravity = {0.0, -chute.gravity, 0.0};
    scene.settings.viscosity = chute.viscosity;
    for (Entry& entry : scene.items) {
        if (Part* part = std::get_if<Part>(&entry.item))
            for (Particle& particle : part->particles)
                particle.pinned = chute.held && particle.mass >= parameters.at("payload");
        if (Wind* wind = std::get_if<Wind>(&entry.item); wind && chute.held)
            wind->velocity = {0.0, chute.speed, 0.0};
    }
    return std::make_unique<Simulation>(*compile(scene));
}

Flight fly(const Chute& chute)
{
    const auto simulation = made(chute);
    const System& system = simulation->system();
    const auto nominal = [&](const char* name, double other) {
        const auto found = chute.parameters.find(name);
        return found == chute.parameters.end() ? other : found->second;
    };
    const double diameter = nominal("diameter", 5.0);
    const double area = 0.25 * std::numbers::pi * diameter * diameter;
    const auto payload =
        std::size_t(std::max_element(system.mass.begin(), system.mass.end()) - system.mass.begin());

    constexpr std::size_t over = 6; // steps, 1/40 s
    std::vector<double> raw;        // m^2, drag area after each step
    std::vector<double> dragArea;   // m^2, mean over the last 1/40 s
    std::vector<double> speed;      // m/s, of the payload
    Flight flight;
    while (simulation->state().time < chute.until) {
        if (!simulation->step())
            return flight;
        const State& state = simulation->state();
        Vec3 load = Vec3::Zero();
        for (const Vec3& one : panelLoads(system, state))
            load += one;
        const double wind = chute.held ? chute.speed : -state.velocity[payload].y();
        raw.push_back(load.y() / (0.5 * system.airDensity * wind * wind));
        dragArea.push_back(
            std::accumulate(raw.end() - std::min<std::ptrdiff_t>(over, std::ssize(raw)), raw.end(),
                            0.0)
            / double(std::min(over, raw.size())));
        speed.push_back(-state.velocity[payload].y());
    }
    const Size size =
        sizeOf(system.canopies.front(), simulation->state(), int(nominal("sectors", 24)));
    flight.width = 2.0 * size.radius / diameter;
    flight.height = size.height / diameter;
    flight.volume = simulation->state().canopies.front().volume / std::pow(diameter, 3);

    fitFilling(dragArea, system.timeStep * chute.speed / diameter, flight);
    flight.drag /= area;
    flight.highest = 0.0;
    for (std::size_t i = over; i < speed.size(); ++i)
        flight.highest =
            std::max(flight.highest, system.mass[payload] * (speed[i - over] - speed[i])
                                         / (double(over) * system.timeStep));
    return flight;
}

Parameters sizeOfC9()
{
    return {{"diameter", 8.53},   {"sectors", 28},      {"rings", 8},
            {"line_length", 7.3}, {"line_segments", 1}, {"payload", 100.0},
            {"mouth", 0.05},      {"pressure", 1.68},   {"altitude", 1000.0}};
}

Parameters nylonOfC9()
{
    return {{"cloth", choiceOf("parachute", "cloth", "mil_7020_1")},
            {"cord", choiceOf("parachute", "cord", "mil_5040_3")}};
}

Parameters joined(Parameters one, const Parameters& other)
{
    one.insert(other.begin(), other.end());
    return one;
}

Chute heldC9(double speed, const Parameters& materials)
{
    Chute chute;
    chute.parameters = joined(sizeOfC9(), materials);
    chute.speed = speed;
    chute.held = true;
    chute.until = 12.0 * 8.53 / speed;
    return chute;
}

} // namespace ripstop
