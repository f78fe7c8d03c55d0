// How the cost of a sweep grows with the number of particles.
//
// Each solver is timed at a fixed effort on cloths of growing size; the exponent is the slope of a
// line through the logarithms of time over those of the number of particles.
#include "bench/races.h"
#include "bench/report.h"
#include "bench/search.h"

#include <cmath>

namespace ripstop {
namespace {

const std::vector<Column> growthColumns{{"network", -12}, {"particles", 10},
                                        {"solver", -16},  {"ms/sweep quiet", 14},
                                        {"median", 10},   {"ns/particle", 11}};

struct Point
{
    double particles;
    double seconds; // of a sweep
};

// Slope of the least-squares line through log(seconds) over log(particles), from `least` particles
// on.
double exponentOf(const std::vector<Point>& points, double least)
{
    double n = 0.0;
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    for (const Point& point : points) {
        if (point.particles < least)
            continue;
        const double x = std::log(point.particles);
        const double y = std::log(point.seconds);
        n += 1.0;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return n > 1.0 ? (n * sxy - sx * sy) / (n * sxx - sx * sx) : std::nan("");
}

constexpr int effort = 10; // sweeps, or substeps of one

} // namespace

std::optional<Json> growthRace(const BenchOptions& options)
{
    const std::vector<Choice>& choices = allChoices();
    std::vector<std::vector<Point>> quiet(choices.size());
    std::vector<std::vector<Point>> middle(choices.size());
    Json rows = Json::array();
    {
        Table table("Growth: time of one sweep, its share of the step included", growthColumns,
                    !options.json);
        for (const int side : {10, 18, 32, 56, 100, 178, 316, 562, 1000}) {
            if (options.quick && side > 100)
                break;
            if (!isWanted(options, "cloth_" + std::to_string(side)))
                continue;
            const BenchNetwork network = clothNetwork(side);
            const auto particles = double(network.system->key.size());
            std::vector<BenchRunner> runners;
            std::vector<std::size_t> racing;
            for (std::size_t i = 0; i < choices.size(); ++i) {
                const Setup setup = choices[i].at(effort);
                if (particles > choices[i].mostParticles || setup.solver == Solver::Auto)
                    continue;
                runners.push_back(engineRunner(
                    choices[i].ownSystem ? clothNetwork(side, setup.solver) : network, setup));
                racing.push_back(i);
            }
            const auto times = timeInRounds(network.name, runners,
                                            options.seconds > 0.0 ? options.seconds
                                            : options.quick       ? 0.2
                                                                  : 1.0,
                                            3);
            if (interrupted())
                return std::nullopt;
            for (std::size_t k = 0; k < racing.size(); ++k) {
                const std::size_t i = racing[k];
                const TimingSummary perSweep = scaled(timingSummaryOf(times[k]), 1.0 / effort);
                quiet[i].push_back({particles, perSweep.quiet});
                middle[i].push_back({particles, perSweep.median});
                rows.push_back({{"network", network.name},
                                {"particles", network.system->key.size()},
                                {"solver", choices[i].name},
                                {"seconds_per_sweep", jsonOf(perSweep)}});
                table.row({network.name, rate(particles), choices[i].name,
                           fixed(1e3 * perSweep.quiet, 4), fixed(1e3 * perSweep.median, 4),
                           fixed(1e9 * perSweep.median / particles, 1)});
            }
        }
    }
    if (rows.empty())
        return Json::object();
    Json exponents = Json::array();
    Table table("Exponent of the cost of a sweep against particles, least squares in log-log",
                {{"solver", -16}, {"from 100", 8}, {"from 1000", 9}, {"from 1000, quiet", 16}},
                !options.json);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (middle[i].empty())
            continue;
        exponents.push_back({{"solver", choices[i].name},
                             {"from_100", exponentOf(middle[i], 0.0)},
                             {"from_1000", exponentOf(middle[i], 1000.0)},
                             {"from_1000_quiet", exponentOf(quiet[i], 1000.0)}});
        table.row({choices[i].name, fixed(exponents.back()["from_100"], 3),
                   fixed(exponents.back()["from_1000"], 3),
                   fixed(exponents.back()["from_1000_quiet"], 3)});
    }
    return Json{{"growth", rows}, {"exponents", exponents}};
}

} // namespace ripstop
