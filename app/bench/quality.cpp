// First the references: the path of the rope from the equation of a compound pendulum, those of
// cloths from a file or computed with very small steps. Then qualityOf() runs a network frame by
// frame, times each, and takes the strain only after the first quarter of the frames. It keeps
// medians of strain and time, and the RMS distance of the mass centre from the reference.
#include "bench/quality.h"

#include "base/new_file.h"
#include "measure/diagnostics.h"
#include "step/stepper.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

namespace ripstop {
namespace {

constexpr int framesOfPath = 100;
constexpr Setup converged{Solver::GaussSeidel, 1500, 1, 1};

Vec3 centerOf(const BenchNetwork& network, const State& state)
{
    return centerOfMass(*network.system, state.position);
}

// Theta'' = -g (sum m r) / (sum m r^2) sin theta - viscosity theta': the rope stays taut, and its
// nodes are light. Runge-Kutta of fourth order.
Path pendulumPath(const BenchNetwork& network)
{
    const System& system = *network.system;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t i = 0; i < system.mass.size(); ++i) {
        const double r = system.start.position[i].norm();
        first += system.mass[i] * r;
        second += system.mass[i] * r * r;
    }
    const double pull = -system.gravity.y() * first / second;
    const Vec3 start = centerOf(network, network.system->start);
    double angle = std::atan2(start.x(), -start.y());
    double speed = 0.0;
    const auto turn = [&](double a, double s) {
        return -pull * std::sin(a) - system.viscosity * s;
    };
    Path path{start};
    const double h = 1e-4; // s
    for (int i = 1; i <= framesOfPath * 100; ++i) {
        const double k1 = turn(angle, speed);
        const double k2 = turn(angle + 0.5 * h * speed, speed + 0.5 * h * k1);
        const double k3 = turn(angle + 0.5 * h * (speed + 0.5 * h * k1), speed + 0.5 * h * k2);
        const double k4 = turn(angle + h * (speed + 0.5 * h * k2), speed + h * k3);
        angle += h * speed + h * h / 6.0 * (k1 + k2 + k3);
        speed += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        if (i % 100 == 0)
            path.push_back(start.norm() * Vec3(std::sin(angle), -std::cos(angle), 0.0));
    }
    return path;
}

Path computedPath(const BenchNetwork& network)
{
    apply(converged, *network.system);
    Stepper stepper(1);
    State state = network.system->start;
    Path path{centerOf(network, state)};
    ProgressLine progress("reference of " + network.name);
    for (int i = 1; i <= framesOfPath && !interrupted(); ++i) {
        stepper.step(*network.system, state);
        path.push_back(centerOf(network, state));
        progress.show(double(i) / framesOfPath);
    }
    return path;
}

std::string fileOf(const BenchNetwork& network, const std::string& folder)
{
    return (std::filesystem::path(folder) / (network.name + ".csv")).string();
}

bool writePath(const Path& path, const std::string& file)
{
    Result<NewFile> made = NewFile::open(file);
    if (!made)
        return false;
    std::ostream& out = made->out();
    out << "time_s,x_m,y_m,z_m\n";
    for (std::size_t i = 0; i < path.size(); ++i) {
        char line[96];
        std::snprintf(line, sizeof line, "%.2f,%.7f,%.7f,%.7f\n", 0.01 * double(i),
                      path[i].x() + 0.0, path[i].y(), path[i].z());
        out << line;
    }
    return !made->commit();
}

double rmsDistance(const Path& a, const Path& b)
{
    double sum = 0.0;
    const std::size_t count = std::min(a.size(), b.size());
    for (std::size_t i = 1; i < count; ++i)
        sum += (a[i] - b[i]).squaredNorm();
    return count > 1 ? std::sqrt(sum / double(count - 1)) : 0.0;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

} // namespace

Path pathFromFile(const std::string& file)
{
    std::ifstream in(file);
    Path path;
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
        Vec3 place;
        double time = 0.0;
        if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &place.x(), &place.y(), &place.z())
            == 4)
            path.push_back(place);
    }
    return path;
}

Path referencePath(const BenchNetwork& network, const std::string& folder)
{
    if (network.name == "rope_pilot")
        return pendulumPath(network);
    if (Path path = pathFromFile(fileOf(network, folder)); path.size() == framesOfPath + 1)
        return path;
    return computedPath(network);
}

bool makeReferences(const std::string& folder)
{
    for (const int side : {32, 100}) {
        const BenchNetwork network = clothNetwork(side);
        const Path path = computedPath(network);
        if (interrupted() || !writePath(path, fileOf(network, folder)))
            return false;
    }
    return true;
}

int qualityFrames(const BenchNetwork& network)
{
    return network.system->key.size() < 10000 ? 200 : 120;
}

std::optional<Quality> qualityOf(const BenchNetwork& network, const Setup& setup,
                                 const Path& reference)
{
    apply(setup, *network.system);
    Stepper stepper(setup.threads);
    State state = network.system->start;
    Path path{centerOf(network, state)};
    std::vector<double> strain;
    std::vector<double> seconds;
    const int frames = qualityFrames(network);
    for (int frame = 1; frame <= frames; ++frame) {
        if (interrupted())
            return std::nullopt;
        const auto start = std::chrono::steady_clock::now();
        stepper.step(*network.system, state);
        seconds.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        if (frame <= framesOfPath)
            path.push_back(centerOf(network, state));
        if (frame > frames / 4)
            strain.push_back(largestStrain(network, state));
    }
    const double error = rmsDistance(path, reference);
    return Quality{median(strain),
                   std::isfinite(error) ? error : std::numeric_limits<double>::infinity(),
                   median(seconds)};
}

} // namespace ripstop
