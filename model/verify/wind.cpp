// Wind over height, and what gusts of a known size and measured winds give to a thing that they
// blow at.
#include "base/airflow.h"
#include "compile/compile.h"
#include "simulation/simulation.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ripstop {
namespace {

// Speed at a height over that at 10 m.
double profile(WindKind kind, double height)
{
    Airflow flow;
    flow.kind = kind;
    flow.velocity = {5.0, 0.0, 0.0};
    return velocityAt(flow, {3.0, height, -2.0}).x() / 5.0;
}

constexpr double gustPeak = 12.0;    // m/s
constexpr double gustDuration = 3.0; // s
constexpr double gustGrowth = 0.5;   // 1

// Speed of a square of 1 m2 that a wind has blown at head-on until a time, m/s, so heavy that it
// hardly gives way, times its mass: N s.
double momentumBy(const Wind& wind, double until)
{
    Scene scene;
    scene.settings.gravity = Vec3::Zero();
    const Id material{1};
    Part part;
    constexpr double mass = 1e6; // kg, of each corner
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        const Id id = Id(unsigned(part.particles.size()) + 2);
        part.particles.push_back({.id = id, .position = {x, y, 0.0}, .mass = mass});
    }
    part.panels = {{Id{6}, Id{2}, Id{3}, Id{4}, material}, {Id{7}, Id{2}, Id{4}, Id{5}, material}};
    scene.items = {{material, Material{}}, {Id{8}, part}, {Id{9}, wind}};
    scene.nextId = Id(10);
    Simulation simulation(*compile(scene));
    (void)simulation.runUntil(until);
    Vec3 momentum = Vec3::Zero();
    for (const Vec3& velocity : simulation.state().velocity)
        momentum += mass * velocity;
    return momentum.z();
}

double momentumOfGusts(int gusts)
{
    Wind wind{"gust", {0.0, 0.0, gustPeak}, WindKind::DiscreteGust};
    wind.duration = gustDuration;
    wind.interval = 4.0;
    wind.growth = gustGrowth;
    return momentumBy(wind, wind.onset + gusts * wind.interval);
}

// The same peak in the same time, straight up and straight down, in a wind of half of it.
double momentumOfRecord()
{
    Wind wind{"measured", Vec3::Zero(), WindKind::Measured};
    const double steady = 0.5 * gustPeak;
    wind.velocities = {{1.0, 0.0, 0.0, steady},
                       {1.0 + 0.5 * gustDuration, 0.0, 0.0, gustPeak},
                       {1.0 + gustDuration, 0.0, 0.0, steady}};
    return momentumBy(wind, 2.0 + gustDuration);
}

// The force goes with the square of the wind, and the mean of (1 - cos)^2 / 4 is 3/8.
std::vector<Case> gustCases()
{
    std::vector<Case> cases;
    double squares = 0.0;
    for (int gusts = 1; gusts <= 3; ++gusts) {
        squares += std::pow(1.0 + (gusts - 1) * gustGrowth, 2);
        cases.push_back(
            {"A-G",
             "momentum that a sheet of 1 m2 takes from discrete gusts, " + std::to_string(gusts),
             3.0 / 8.0 * squares * 0.5 * airDensity * Material{}.normalCoefficient * gustPeak
                 * gustPeak * gustDuration,
             relative(1e-3), "N s", "3/8 T rho/2 Ca A U^2, summed over peaks U",
             [=] { return momentumOfGusts(gusts); }});
    }
    // 1 s before and after at U / 2, and of what goes straight from U / 2 to U the mean square is
    // 7/12 U^2
    cases.push_back({"A-M", "momentum that a sheet of 1 m2 takes from a measured wind",
                     (2.0 / 4.0 + 7.0 / 12.0 * gustDuration) * 0.5 * airDensity
                         * Material{}.normalCoefficient * gustPeak * gustPeak,
                     relative(1e-3), "N s", "rho/2 Ca A U^2 (1/2 s + 7/12 T)",
                     [] { return momentumOfRecord(); }});
    return cases;
}

} // namespace

std::vector<Case> windCases()
{
    std::vector<Case> cases;
    const double rows[][3] = {{2.0, 0.7229, 0.7946},
                              {20.0, 1.1193, 1.1041},
                              {50.0, 1.2771, 1.2585},
                              {100.0, 1.3964, 1.3895}};
    for (const auto& [height, log, power] : rows) {
        const std::string at = " at " + std::to_string(int(height)) + " m over that at 10 m";
        cases.push_back({"3.7", "wind over grass, log law," + at, log, within(0.5e-4), "",
                         "ln(z/z0) / ln(10/z0), z0 0.03 m",
                         [height = height] { return profile(WindKind::LogLaw, height); }});
        cases.push_back({"3.7", "wind, power law 1/7," + at, power, within(0.5e-4), "",
                         "(z/10)^(1/7)",
                         [height = height] { return profile(WindKind::PowerLaw, height); }});
    }
    std::ranges::move(gustCases(), std::back_inserter(cases));
    return cases;
}

} // namespace ripstop
