// Makes the polar of a material and keeps the published curves.
//
// platePolar() turns the wind instead of the plate and divides the force by dynamic pressure and
// area. A material without stall is one triangle, as its law looks at each panel by itself. With
// stall, the vortex law needs a span: rectangle() builds a plate with the strips of a wing, once,
// and wingLoad() adds what the wing gives to the loads of its panels. The references are normal
// coefficients, from which rowOf() makes lift and drag.
#include "measure/polar.h"

#include "forces/panel_load.h"
#include "laws/vortex_wing.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double aspectRatio = 2.0; // of the curves for finite plates

double separated(double alpha)
{
    const double s = std::sin(alpha);
    return 1.98 * s / (0.56 + 0.44 * s);
}

constexpr std::array references{
    PolarReference{"paper", "4 sin^2 a (Beaudry, Egli and Patenaude 2005)", 90.0,
                   [](double a) { return 4.0 * std::sin(a) * std::sin(a); }},
    PolarReference{"nasa", "1.28 sin^2 a (kite pages of NASA Glenn)", 90.0,
                   [](double a) { return 1.28 * std::sin(a) * std::sin(a); }},
    PolarReference{"kirchhoff", "2 pi sin a / (4 + pi sin a) (Kirchhoff 1869)", 90.0,
                   [](double a) { return 2.0 * pi * std::sin(a) / (4.0 + pi * std::sin(a)); }},
    PolarReference{"lindenburg", "separated plate, infinite span (Lindenburg 2003)", 90.0,
                   separated},
    PolarReference{"lindenburg_ar2", "separated plate, aspect ratio 2 (Lindenburg 2003)", 90.0,
                   [](double a) {
                       const double lost = 0.41 * (1.0 - std::exp(-17.0 / aspectRatio));
                       return separated(a) - 1.98 * lost * std::sin(a);
                   }},
    PolarReference{"wing_ar2", "2 pi a / (1 + 2 / A), aspect ratio 2 (lifting line, to stall)",
                   20.0, [](double a) { return 2.0 * pi * a / (1.0 + 2.0 / aspectRatio); }},
    PolarReference{"plate", "2 sin a (Moore, Cory and Tedrake 2014)", 90.0,
                   [](double a) { return 2.0 * std::sin(a); }},
};

// A rectangle in y = 0 with the wind along x, of the aspect ratio of the curves above.
struct Rectangle
{
    std::vector<PaddedVec3> position; // m
    std::vector<std::array<int, 3>> corners;
    WingStrips strips;
};

Rectangle rectangle()
{
    constexpr int along = 4;
    constexpr int across = wingStrips;
    Rectangle plate;
    for (int i = 0; i <= across; ++i)
        for (int j = 0; j <= along; ++j)
            plate.position.push_back(
                {double(j) / along, 0.0, aspectRatio * (double(i) / across - 0.5)});
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < along; ++j) {
            const int first = i * (along + 1) + j;
            const int next = first + along + 1;
            plate.corners.push_back({first, next, first + 1});
            plate.corners.push_back({next, next + 1, first + 1});
        }
    const std::vector<std::uint8_t> all(plate.corners.size(), 1);
    const std::vector<Vec3> chord(plate.corners.size(), Vec3::UnitX());
    plate.strips = wingsOf(plate.corners, all, plate.position, chord).front();
    return plate;
}

Vec3 wingLoad(const MaterialAir& air, const Vec3& wind, double density) // N
{
    static const Rectangle plate = rectangle();
    const WingStrips& wing = plate.strips;
    std::vector<WingPanel> panels(plate.corners.size());
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Vec3& a = plate.position[std::size_t(plate.corners[i][0])];
        const Vec3& b = plate.position[std::size_t(plate.corners[i][1])];
        const Vec3& c = plate.position[std::size_t(plate.corners[i][2])];
        sum += panelLoad(air, a, b, c, wind, density);
        panels[i].normal = (b - a).cross(c - a);
        panels[i].wind = wind;
        panels[i].plate = air.normalCoefficient;
        panels[i].saturation = air.saturation;
        panels[i].stall = air.stall;
    }
    fillWingLoads(wing, rimOf(wing.front, plate.position), rimOf(wing.rear, plate.position),
                  density, panels);
    for (const WingPanel& panel : panels)
        sum += panel.load;
    return sum;
}

} // namespace

std::vector<PolarRow> platePolar(const MaterialAir& air, double step)
{
    constexpr double speed = 10.0;  // m/s
    constexpr double density = 1.0; // kg/m^3
    constexpr double area = 0.5;    // m^2
    std::vector<PolarRow> rows;
    const int count = int(std::floor(90.0 / step + 1e-9));
    for (int i = 0; i <= count; ++i) {
        const double degrees = i * step;
        const double s = std::sin(degrees * pi / 180.0);
        const double c = std::cos(degrees * pi / 180.0);
        const Vec3 wind = speed * Vec3(c, s, 0.0);
        const bool wing = air.stall > 0.0;
        const Vec3 force =
            wing ? wingLoad(air, wind, density)
                 : panelLoad(air, Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), wind, density);
        const Vec3 load = force / (0.5 * density * speed * speed * (wing ? aspectRatio : area));
        rows.push_back(
            {degrees, load.y(), load.y() * c - load.x() * s, load.y() * s + load.x() * c});
    }
    return rows;
}

std::span<const PolarReference> polarReferences() { return references; }

PolarRow rowOf(const PolarReference& reference, double degrees)
{
    const double alpha = degrees * pi / 180.0;
    const double normal = reference.normal(alpha);
    return {degrees, normal, normal * std::cos(alpha), normal * std::sin(alpha)};
}

} // namespace ripstop
