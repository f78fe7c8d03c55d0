// Wings with the vortex law: lift slope, induced drag, camber, symmetry, power.
//
// In order: lift slope and induced drag of plan forms, camber, symmetry and rest, power, and stall.
// Wings are panels of fixed shape whose places and velocities are given; nothing is stepped, so
// that only the law of the air is judged.
#include "assembly/finish.h"
#include "base/angle.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;
constexpr double speed = 10.0; // m/s

// A wing in calm air, nose to -x, span along z, at rest unless said.
struct Sail
{
    System system;
    double span = 0.0; // m
    double area = 0.0; // m^2
};

MaterialAir wingAir(double stall = 15.0)
{
    MaterialAir air;
    air.saturation = air.normalCoefficient / 1.17 - 1.0;
    air.stall = std::sin(stall * degrees);
    return air;
}

void close(Sail& sail)
{
    sail.system.airDensity = airDensity;
    sail.system.wind = {speed, 0.0, 0.0};
    finish(sail.system);
    sail.area = fabricArea(sail.system, sail.system.start);
}

// `across` times `along` cells; front(y) and rear(y) say where the edges are, m. `height` is that
// of the camber line at a share of the chord, over the chord. The halves are mirror images.
template <typename Front, typename Rear, typename Height>
Sail sheet(double span, const Front& front, const Rear& rear, const Height& height,
           int across = wingStrips, int along = 4)
{
    Sail sail{emptySystem(0.01), span};
    for (int i = 0; i <= across; ++i)
        for (int j = 0; j <= along; ++j) {
            const double z = span * (double(i) / across - 0.5);
            const double x = double(j) / along;
            const double chord = rear(z) - front(z);
            addParticle(sail.system, {front(z) + x * chord, height(x) * chord, z}, 1.0);
        }
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < along; ++j) {
            const int a = i * (along + 1) + j;
            const int b = a + along + 1;
            const bool left = i < across / 2;
            addPanel(sail.system, a, b, left ? b + 1 : a + 1, wingAir());
            addPanel(sail.system, left ? a : b, b + 1, a + 1, wingAir());
        }
    close(sail);
    return sail;
}

double flat(double) { return 0.0; }

Sail rectangle(double aspect, int across = wingStrips)
{
    return sheet(
        aspect, flat, [](double) { return 1.0; }, flat, across);
}

Sail ellipse(double aspect)
{
    const double span = aspect * pi / 4.0;
    const auto chord = [=](double z) {
        return std::sqrt(std::max(0.0, 1.0 - 4.0 * z * z / (span * span)));
    };
    return sheet(
        span, [=](double z) { return -0.25 * chord(z); }, [=](double z) { return 0.75 * chord(z); },
        flat, 4 * wingStrips);
}

// The triangular lattice of the gliders, keel 1 m, flat.
Sail delta(double aspect, int rows)
{
    Sail sail{emptySystem(0.01), 0.5 * aspect};
    const auto at = [](int row, int column) { return row * (row + 1) / 2 + column; };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= row; ++column)
            addParticle(sail.system,
                        {double(row) / rows, 0.0, sail.span / rows * (column - 0.5 * row)}, 1.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column <= row; ++column) {
            addPanel(sail.system, at(row, column), at(row + 1, column), at(row + 1, column + 1),
                     wingAir());
            if (column < row)
                addPanel(sail.system, at(row, column), at(row + 1, column + 1), at(row, column + 1),
                         wingAir());
        }
    close(sail);
    return sail;
}

Vec3 windAt(double angle) // rad
{
    return speed * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

struct Wing // over the dynamic pressure and the area
{
    Vec3 force;    // 1
    Vec3 moment;   // m, about the origin
    double lift;   // 1
    double drag;   // 1
    double centre; // m, behind the origin
};

Wing inWind(Sail sail, const Vec3& wind)
{
    sail.system.wind = wind;
    const State& state = sail.system.start;
    const std::vector<Vec3> loads = panelLoads(sail.system, state);
    Wing wing{Vec3::Zero(), Vec3::Zero(), 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const auto [a, b, c] = sail.system.panels[i].corner;
        const Vec3 middle = (state.position[std::size_t(a)] + state.position[std::size_t(b)]
                             + state.position[std::size_t(c)])
                            / 3.0;
        wing.force += loads[i];
        wing.moment += middle.cross(loads[i]);
    }
    const double pressure = 0.5 * airDensity * wind.squaredNorm() * sail.area;
    wing.force /= pressure;
    wing.moment /= pressure;
    const Vec3 along = wind.normalized();
    const Vec3 up = Vec3::UnitZ().cross(along).normalized();
    wing.lift = wing.force.dot(up);
    wing.drag = wing.force.dot(along);
    wing.centre = wing.moment.z() / wing.force.y();
    return wing;
}

double slope(const Sail& sail) // 1/rad
{
    const double angle = 2.0 * degrees;
    return inWind(sail, windAt(angle)).lift / std::sin(angle);
}

double efficiency(const Sail& sail) // 1, of the span
{
    const Wing wing = inWind(sail, windAt(4.0 * degrees));
    return wing.lift * wing.lift * sail.area / (pi * sail.span * sail.span * wing.drag);
}

// --- slopes and induced drag

void addPlanforms(std::vector<Case>& cases)
{
    char title[100];
    for (const double aspect : {4.0, 6.0, 8.0}) {
        std::snprintf(title, sizeof title, "elliptic wing of aspect ratio %g, CDi pi A / CL^2",
                      aspect);
        cases.push_back({"T-A9", title, 1.0, relative(0.02), "", "Prandtl 1918: CL^2 / (pi A)",
                         [=] { return 1.0 / efficiency(ellipse(aspect)); }});
    }
    const struct
    {
        double aspect, slope, efficiency;
    } rectangles[] = {{2.0, 2.474, 0.999}, {4.0, 3.611, 0.994}, {6.0, 4.214, 0.984}};
    const char* source = "vortex lattice of 32 x 8 (tests/model/vortex_lattice.h)";
    for (const auto& wing : rectangles) {
        std::snprintf(title, sizeof title, "rectangular wing of aspect ratio %g", wing.aspect);
        cases.push_back({"T-A9", title + std::string(", lift slope"), wing.slope, relative(0.03),
                         "1/rad", source, [=] { return slope(rectangle(wing.aspect)); }});
        cases.push_back({"T-A9", title + std::string(", span efficiency"), wing.efficiency,
                         relative(0.02), "", source,
                         [=] { return efficiency(rectangle(wing.aspect)); }});
    }
    for (const int rows : {8, 14}) {
        std::snprintf(title, sizeof title, "equilateral delta of %d segments, lift slope", rows);
        cases.push_back({"T-A9", title, 2.425, relative(0.03), "1/rad",
                         "vortex lattice of 24 x 12 (tests/model/vortex_lattice.h)",
                         [=] { return slope(delta(4.0 / std::sqrt(3.0), rows)); }});
    }
    cases.push_back({"T-A9", "rectangle of 4 x 4 cells, lift slope over that of 16 x 4", 1.0,
                     relative(1e-9), "", "the strips do not depend on the mesh",
                     [] { return slope(rectangle(6.0, 4)) / slope(rectangle(6.0)); }});
    cases.push_back({"T-A9", "rectangular wing, centre of pressure", 0.25, within(1e-6), "m",
                     "a quarter of the chord, thin plates",
                     [] { return inWind(rectangle(6.0), windAt(2.0 * degrees)).centre; }});
}

// --- camber

// A wing with a parabolic camber line of this height over the chord.
Sail cambered(double height)
{
    return sheet(
        6.0, flat, [](double) { return 1.0; },
        [=](double x) { return 4.0 * height * x * (1.0 - x); }, wingStrips, 16);
}

void addCamber(std::vector<Case>& cases)
{
    const double height = 0.02;
    const auto noLift = shared([=] {
        const Sail sail = cambered(height);
        double low = -10.0 * degrees, high = 0.0;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (inWind(sail, windAt(middle)).lift > 0.0 ? high : low) = middle;
        }
        return low;
    });
    cases.push_back({"T-A10", "wing with 2 % of parabolic camber, angle without lift",
                     -2.0 * height, relative(0.03), "rad", "-2 h / c, thin sections (Glauert 1926)",
                     [=] { return noLift(); }});
    cases.push_back({"T-A10", "the same, moment without lift over q S c", -pi * height,
                     relative(0.03), "", "-pi h / c, thin sections (Glauert 1926)",
                     [=] { return -inWind(cambered(height), windAt(noLift())).moment.z(); }});
}

// --- symmetry, rest, power

void shake(Sail& sail, std::uint32_t seed, double most)
{
    Dice dice(seed);
    for (PaddedVec3& velocity : sail.system.start.velocity)
        velocity = dice.vector(most);
}

double mirrorError() // 1, of a wing that slips, beside its mirror image
{
    const Sail sail = delta(4.0, 8);
    const Wing one = inWind(sail, {9.0, 1.5, 3.0});
    const Wing other = inWind(sail, {9.0, 1.5, -3.0});
    const Vec3 mirrored(other.force.x(), other.force.y(), -other.force.z());
    const Vec3 turned(-other.moment.x(), -other.moment.y(), other.moment.z());
    return (one.force - mirrored).norm() + (one.moment - turned).norm();
}

double loadAtRest() // N, the largest
{
    Sail sail = delta(4.0, 8);
    sail.system.wind = {3.0, -1.0, 7.0};
    for (PaddedVec3& velocity : sail.system.start.velocity)
        velocity = sail.system.wind;
    double most = 0.0;
    for (const Vec3& load : panelLoads(sail.system, sail.system.start))
        most = std::max(most, load.norm());
    return most;
}

// W, what the wind loses to the fabric as heat or wake, the least over winds from all sides and
// over fabric that is shaken at up to `most`, m/s.
double leastPower(const Sail& from, double most)
{
    double least = 1e9;
    Dice dice(3);
    for (int i = 0; i < 400; ++i) {
        Sail sail = from;
        shake(sail, std::uint32_t(i + 1), most);
        sail.system.wind = dice.vector(10.0);
        const State& state = sail.system.start;
        const std::vector<Vec3> loads = panelLoads(sail.system, state);
        double power = 0.0;
        for (std::size_t p = 0; p < loads.size(); ++p) {
            const auto [a, b, c] = sail.system.panels[p].corner;
            const Vec3 motion = (state.velocity[std::size_t(a)] + state.velocity[std::size_t(b)]
                                 + state.velocity[std::size_t(c)])
                                / 3.0;
            power += loads[p].dot(sail.system.wind - motion);
        }
        least = std::min(least, power);
    }
    return least;
}

double roll(double rate) // m, moment over q S of the wing that rolls at `rate`, rad/s
{
    Sail sail = rectangle(6.0);
    for (std::size_t i = 0; i < sail.system.start.position.size(); ++i)
        sail.system.start.velocity[i] =
            Vec3(rate, 0.0, 0.0).cross(Vec3(sail.system.start.position[i]));
    return inWind(sail, windAt(0.0)).moment.x();
}

void addWingInvariants(std::vector<Case>& cases)
{
    cases.push_back({"T-A11", "wing with the vortex law, mirror image of force and moment", 0.0,
                     within(1e-12), "", "symmetry", mirrorError});
    cases.push_back({"T-A11", "wing that moves with the wind, largest load", 0.0, within(1e-12),
                     "N", "no apparent wind", loadAtRest});
    const Sail wings[] = {rectangle(4.0), delta(4.0, 8), cambered(0.05)};
    const char* names[] = {"rectangle", "delta", "cambered rectangle"};
    for (std::size_t i = 0; i < 3; ++i)
        for (const double most : {0.0, 3.0})
            cases.push_back({"T-A11",
                             std::string(names[i]) + (most > 0.0 ? ", shaken," : ", at rest,")
                                 + " least power that it takes from 400 winds",
                             -1e-9, atLeast, "W", "the air gives no power",
                             [=, wing = wings[i]] { return leastPower(wing, most); }});
    cases.push_back({"T-A11", "wing that rolls, damping moment over rate, sign", -1.0, exactly, "",
                     "the wing that sinks meets more wind",
                     [] { return roll(0.2) < 0.0 ? -1.0 : 1.0; }});
}

// --- stall

void addStall(std::vector<Case>& cases)
{
    cases.push_back({"T-A12", "wing at 90 degrees, C_N", 1.17, relative(1e-9), "",
                     "the plate that it is when stalled",
                     [] { return inWind(rectangle(6.0), windAt(90.0 * degrees)).force.y(); }});
    cases.push_back({"T-A12", "wing of aspect ratio 6 at 60 degrees over the blended plate", 1.0,
                     relative(1e-9), "", "too far from the chord: 2 sin / (1 + (2 / 1.17 - 1) sin)",
                     [] {
                         const double s = std::sin(60.0 * degrees);
                         const double plate = 2.0 * s / (1.0 + (2.0 / 1.17 - 1.0) * s);
                         return inWind(rectangle(6.0), windAt(60.0 * degrees)).force.y() / plate;
                     }});
    cases.push_back({"T-A12", "wing of aspect ratio 6, greatest lift coefficient, at most", 1.5,
                     atMost, "", "2 pi sin(1.2 x 15 degrees) less what is stalled", [] {
                         double most = 0.0;
                         for (double angle = 0.0; angle < 60.0; angle += 1.0)
                             most = std::max(most,
                                             inWind(rectangle(6.0), windAt(angle * degrees)).lift);
                         return most;
                     }});
}

} // namespace

std::vector<Case> wingCases()
{
    std::vector<Case> cases;
    addPlanforms(cases);
    addCamber(cases);
    addWingInvariants(cases);
    addStall(cases);
    return cases;
}

} // namespace ripstop
