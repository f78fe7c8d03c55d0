// The loads of a wing in one state, in the order of fillWingLoads():
//
//   meetPanels, layLine, meetWind   the head-on wind of panels and strips, and the lifting line
//   findCirculations                a linear system of one unknown for each strip
//   stall                           circulation is taken from strips that meet the air too steeply
//   addStripForces, addPanelForces  Kutta and Joukowski for strips, the moment of camber for panels
//   keepPowerPositive               what the whole would gain from the air is taken out as drag
//
// It returns early, with loads of zero, where there is no wing to speak of: without wind or area,
// in wind at a large angle to the chord, or when the system is singular. Panels then keep the loads
// of plates. Elimination is written out here, so that every machine does the same operations.
#include "laws/vortex_wing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int N = wingStrips;
constexpr double camberSlope = 1.5 * pi; // 1/rad, for a moment of -pi h at camber h over the chord

using Row = std::array<double, N>;
using Square = std::array<Row, N>;

// Solves in place, by elimination with pivots; the same operations on every machine. Returns false
// when the matrix is singular.
template <std::size_t rows>
bool solve(std::array<std::array<double, rows>, rows>& matrix, std::array<double, rows>& value)
{
    for (std::size_t k = 0; k < rows; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < rows; ++i)
            if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k]))
                pivot = i;
        if (!(std::abs(matrix[pivot][k]) > 1e-12))
            return false;
        std::swap(matrix[k], matrix[pivot]);
        std::swap(value[k], value[pivot]);
        for (std::size_t i = k + 1; i < rows; ++i) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (std::size_t j = k + 1; j < rows; ++j)
                matrix[i][j] -= factor * matrix[k][j];
            value[i] -= factor * value[k];
        }
    }
    for (std::size_t k = rows; k-- > 0;) {
        for (std::size_t j = k + 1; j < rows; ++j)
            value[k] -= matrix[k][j] * value[j];
        value[k] /= matrix[k][k];
    }
    return true;
}

// sin(pi m / 32), m of any size.
double sineOf(std::size_t m)
{
    m %= 4 * N;
    const bool second = m > 2 * N;                               // half of the circle
    const std::size_t turned = (second ? m - 2 * N : m) + 3 * N; // cos(t - pi / 2)
    const std::size_t place = turned % (4 * N);
    const double value = stationCosines()[place > 2 * N ? 4 * N - place : place];
    return second ? -value : value;
}

// The matrix from circulations to downwash times the span. The circulations are taken as a sum of
// sines, whose coefficients are 2/N sum of G_i sin(k t_i) but half of that for the last; Glauert
// gives the downwash of each.
Square downwashMatrix()
{
    Square result{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            for (std::size_t k = 1; k <= N; ++k)
                result[i][j] += (k < N ? 1.0 : 0.5) * double(k) / N * sineOf(k * (2 * i + 1))
                                * sineOf(k * (2 * j + 1)) / sineOf(2 * i + 1);
    return result;
}

// A place as seen from an end of a vortex.
struct VortexView
{
    Vec3 from;     // m
    double length; // m
};

// Velocity at the place, times 4 pi, of a vortex of unit circulation from a to b, and from a to
// infinity along the unit vector d. `core`, m^2, keeps it finite at the vortex.
Vec3 ofBound(const VortexView& a, const VortexView& b, double core)
{
    const double both = a.length * b.length;
    return ((a.length + b.length)
            / (both * (both + a.from.dot(b.from)) + core * both + core * core))
           * a.from.cross(b.from);
}

Vec3 ofTrailing(const VortexView& a, const Vec3& d, double core)
{
    return d.cross(a.from) / (a.length * (a.length - d.dot(a.from)) + core);
}

double smoothStep(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

struct Strip
{
    Vec3 bound;               // m, the bound vortex
    Vec3 check;               // m, where the air flows along the sail
    Vec3 normal;              // unit
    double chord;             // m
    Vec3 wind = Vec3::Zero(); // m/s
    double area = 0.0;        // m^2, twice
    double wash = 0.0;        // m/s, W
    double mean = 0.0;        // m/s, head-on wind, plain mean over the area
    double stall = 0.0;       // 1, sine
    double held = 1.0;        // 1, share that is not stalled
    double circulation = 0.0; // m^2/s
};

struct Line // the lifting line
{
    std::array<Strip, N> strip;
    std::array<Vec3, N + 1> quarter; // m, ends of the bound vortices
    Vec3 chord = Vec3::Zero();       // m, sum over the strips
    Vec3 span;                       // m, from tip to tip
    Vec3 wind = Vec3::Zero();        // m/s, mean
};

void layLine(const WingRim& front, const WingRim& rear, Line& line)
{
    for (std::size_t i = 0; i <= N; ++i)
        line.quarter[i] = front[2 * i] + 0.25 * (rear[2 * i] - front[2 * i]);
    for (std::size_t i = 0; i < N; ++i) {
        Strip& strip = line.strip[i];
        const Vec3& first = front[2 * i + 1];
        const Vec3 chord = rear[2 * i + 1] - first;
        strip.bound = line.quarter[i + 1] - line.quarter[i];
        strip.check = first + 0.75 * chord;
        strip.chord = chord.norm();
        strip.normal = chord.cross(strip.bound);
        strip.normal /= std::max(strip.normal.norm(), 1e-300);
        line.chord += chord;
    }
    line.span = line.quarter[N] - line.quarter[0];
}

void meetPanels(const WingStrips& wing, std::span<WingPanel> panels)
{
    for (std::size_t i = 0; i < panels.size(); ++i) {
        WingPanel& panel = panels[i];
        panel.load = Vec3::Zero();
        panel.held = 0.0;
        panel.more = 0.0;
        panel.size = panel.normal.norm();
        panel.headOn =
            panel.size > 0.0 ? wing.side[i] * panel.normal.dot(panel.wind) / panel.size : 0.0;
    }
}

void meetWind(const WingStrips& wing, std::span<const WingPanel> panels, Line& line)
{
    double all = 0.0;
    for (const StripPart& part : wing.parts) {
        const WingPanel& panel = panels[std::size_t(part.panel)];
        Strip& strip = line.strip[std::size_t(part.strip)];
        if (panel.gone)
            strip.held = 0.0;
        const double size = part.area * panel.size;
        strip.area += size;
        strip.wind += size * panel.wind;
        strip.mean += size * panel.headOn;
        strip.stall += size * panel.stall;
        strip.wash += part.wash * panel.headOn;
    }
    for (Strip& strip : line.strip) {
        line.wind += strip.wind;
        all += strip.area;
        const double share = 1.0 / std::max(strip.area, 1e-300);
        strip.wind *= share;
        strip.mean *= share;
        strip.stall *= share;
    }
    line.wind /= std::max(all, 1e-300);
}

// Returns false when there are none. The wake leaves along the chord, as it does up to the trailing
// edge: then neither incidence nor slip takes it over a place where the flow is checked.
bool findCirculations(Line& line)
{
    const Vec3 rearward = line.chord.normalized();
    const double width = line.span.norm() / N; // of strips, on average
    const double core = 1e-6 * width * width;
    Square matrix;
    Row value;
    for (std::size_t i = 0; i < N; ++i) {
        const Strip& strip = line.strip[i];
        const auto sight = [&](std::size_t end) {
            const Vec3 from = strip.check - line.quarter[end];
            return VortexView{from, from.norm()};
        };
        VortexView here = sight(0);
        Vec3 last = ofTrailing(here, rearward, core);
        for (std::size_t j = 0; j < N; ++j) {
            const VortexView there = sight(j + 1);
            const Vec3 next = ofTrailing(there, rearward, core);
            matrix[i][j] = (ofBound(here, there, core) + next - last).dot(strip.normal) * width;
            here = there;
            last = next;
        }
        value[i] = -4.0 * pi * strip.wash * width;
    }
    if (!solve(matrix, value))
        return false;
    for (std::size_t i = 0; i < N; ++i)
        line.strip[i].circulation = value[i];
    return true;
}

void stall(double attached, Line& line)
{
    for (Strip& strip : line.strip) {
        const double speed = strip.wind.norm();
        const double reach = pi * strip.chord * speed;
        const double sine = reach > 0.0 ? std::abs(strip.circulation) / reach : 1.0;
        strip.held *= attached * (1.0 - smoothStep(0.8 * strip.stall, 1.2 * strip.stall, sine));
        strip.circulation *= strip.held;
    }
}

void addStripForces(const WingStrips& wing, const Vec3& downwind, double airDensity,
                    const Line& line, std::span<WingPanel> panels)
{
    static const Square downwash = downwashMatrix();
    double span = 0.0;
    for (const Strip& strip : line.strip)
        span += downwind.cross(strip.bound).norm();
    std::array<Vec3, N> force;
    for (std::size_t i = 0; i < N; ++i) {
        const Strip& strip = line.strip[i];
        double w = 0.0;
        for (std::size_t j = 0; j < N; ++j)
            w += downwash[i][j] * line.strip[j].circulation;
        Vec3 up = downwind.cross(strip.bound);
        up /= std::max(up.norm(), 1e-300);
        force[i] = airDensity * strip.circulation
                   * (strip.wind - (w / std::max(span, 1e-300)) * up).cross(strip.bound);
    }
    for (const StripPart& part : wing.parts)
        panels[std::size_t(part.panel)].load += part.load * force[std::size_t(part.strip)];
}

// What panels get by themselves: the moment of camber, and less of the load of a plate where they
// hold.
void addPanelForces(const WingStrips& wing, double airDensity, const Line& line,
                    std::span<WingPanel> panels)
{
    for (const StripPart& part : wing.parts) {
        WingPanel& panel = panels[std::size_t(part.panel)];
        const Strip& strip = line.strip[std::size_t(part.strip)];
        panel.held += part.area * strip.held;
        panel.more += part.area * strip.held * (panel.headOn - strip.mean);
    }
    for (std::size_t i = 0; i < panels.size(); ++i) {
        WingPanel& panel = panels[i];
        if (panel.gone)
            continue;
        const double speed = panel.wind.norm();
        // across the wind: in thin sections the suction at the edge takes the drag of camber away
        const Vec3 along = panel.wind / std::max(speed, 1e-300);
        const Vec3 across = panel.normal - panel.normal.dot(along) * along;
        const double bend = 0.25 * airDensity * camberSlope * speed * wing.side[i] * panel.more;
        panel.load += bend * across - panel.held * plateLoad(panel, airDensity);
    }
}

// Power that the air would give to the wing as a whole is taken out as drag.
void keepPowerPositive(double airDensity, std::span<WingPanel> panels)
{
    double power = 0.0;
    double squares = 0.0;
    for (const WingPanel& panel : panels) {
        if (panel.gone)
            continue;
        power += (panel.load + plateLoad(panel, airDensity)).dot(panel.wind);
        squares += panel.wind.squaredNorm();
    }
    if (power >= 0.0 || squares == 0.0)
        return;
    for (WingPanel& panel : panels)
        if (!panel.gone)
            panel.load -= (power / squares) * panel.wind;
}

} // namespace

Vec3 plateLoad(const WingPanel& panel, double airDensity)
{
    const double through = panel.normal.dot(panel.wind);
    const double square = panel.normal.squaredNorm();
    if (panel.gone || through == 0.0 || square == 0.0)
        return Vec3::Zero();
    const double pace = std::sqrt(square * panel.wind.squaredNorm());
    const double blended = pace * pace / (pace + panel.saturation * std::abs(through));
    return (0.25 * airDensity * panel.plate * blended * through / square) * panel.normal;
}

void fillWingLoads(const WingStrips& wing, const WingRim& front, const WingRim& rear,
                   double airDensity, std::span<WingPanel> panels)
{
    meetPanels(wing, panels);
    Line line;
    layLine(front, rear, line);
    meetWind(wing, panels, line);
    const double speed = line.wind.norm();
    const double chord = line.chord.norm();
    const double across = line.span.norm();
    if (!(speed > 0.0 && chord > 0.0 && across > 0.0))
        return;
    const double attached = smoothStep(0.6, 0.8, line.wind.dot(line.chord) / (speed * chord));
    if (attached == 0.0)
        return;
    if (!findCirculations(line))
        return;
    // far behind the wake runs with the wind, but for slip
    Vec3 downwind = line.wind - (line.wind.dot(line.span) / (across * across)) * line.span;
    downwind /= std::max(downwind.norm(), 1e-300);
    stall(attached, line);
    addStripForces(wing, downwind, airDensity, line, panels);
    addPanelForces(wing, airDensity, line, panels);
    keepPowerPositive(airDensity, panels);
}

} // namespace ripstop
