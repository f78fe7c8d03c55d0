// Air on fabric of fixed shape: plates, caps, spheres, cylinders, cones.
//
// In order: terminal velocities of a triangle that falls flat (A1); bodies of revolution and
// cylinders made of many panels, against integrals of the law over their surface (A3); plates at
// other angles (A4); and the descent of a hemispherical canopy. Fabric is held or falls without
// turning, so that only the law of the air is judged.
#include "assembly/finish.h"
#include "forces/panel_load.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;
constexpr std::array laws{AirLaw::Paper, AirLaw::LinearNormal};

// A right triangle with two legs of this length in the xz plane.
std::array<Vec3, 3> triangle(double leg)
{
    return {Vec3::Zero(), Vec3(0.0, 0.0, leg), Vec3(leg, 0.0, 0.0)};
}

// --- A1 -----------------------------------------------------------------------------------------

double sinkRate(AirLaw law, double mass, double area, double coefficient)
{
    System system = heavySystem(1.0 / 1000.0);
    for (const Vec3& corner : triangle(std::sqrt(2.0 * area)))
        addParticle(system, corner, mass / 3.0);
    addPanel(system, 0, 1, 2, law, coefficient);
    finish(system);
    return -run(system, 5000).velocity[0].y();
}

void addTerminals(std::vector<Case>& cases)
{
    struct Plate
    {
        const char* title;
        double mass, area, coefficient, speed, digit;
    };
    const Plate plates[] = {{"1 kg, 1 m2, C 4", 1.0, 1.0, 4.0, 2.000678, 1e-6},
                            {"1 kg, 1 m2, C 2", 1.0, 1.0, 2.0, 2.829387, 1e-6},
                            {"1 kg, 1 m2, C 1.28", 1.0, 1.0, 1.28, 3.536733, 1e-6},
                            {"1 kg, 1 m2, C 1.17", 1.0, 1.0, 1.17, 3.699256, 1e-6},
                            {"1 kg, 1 m2, C 1", 1.0, 1.0, 1.0, 4.001357, 1e-6},
                            {"50 g, legs of 1 m, C 4", 0.05, 0.5, 4.0, 0.63267, 0.5e-5},
                            {"50 g, legs of 1 m, C 2", 0.05, 0.5, 2.0, 0.89473, 0.5e-5},
                            {"50 g, legs of 1 m, C 1.17", 0.05, 0.5, 1.17, 1.16981, 0.5e-5},
                            {"100 g, disc of 1 m, C 1.17", 0.1, pi / 4.0, 1.17, 1.319986, 1e-6}};
    for (const AirLaw law : laws)
        for (const Plate& plate : plates)
            cases.push_back(
                {"T-A1", std::string("terminal speed, ") + plate.title + ", " + nameOf(law),
                 plate.speed, within(plate.digit), "m/s", "sqrt(2 m g / (rho C A))",
                 [=] { return sinkRate(law, plate.mass, plate.area, plate.coefficient); }});
    for (const AirLaw law : laws)
        cases.push_back(
            {"T-A1", "plate broadside to 7 m/s, 0.5 m2, C 1.17, " + nameOf(law),
             0.5 * airDensity * 1.17 * 0.5 * 49.0, relative(1e-12), "N", "rho C A V^2 / 2", [=] {
                 const auto [a, b, c] = triangle(1.0);
                 return panelLoad(airOf(law, 1.17), a, b, c, {0.0, 7.0, 0.0}, airDensity).y();
             }});
}

// --- A3, A4: bodies in wind along the axis -------------------------------------------------------

// Drag coefficient on pi R^2 of a surface of revolution about x with radius 1: `profile` gives
// (x, r) for s from 0 to 1, in rings and sectors; the first ring may be a point.
template <typename Profile>
double dragOfRevolution(AirLaw law, double coefficient, int rings, int sectors,
                        const Profile& profile, const Vec3& wind = Vec3(1.0, 0.0, 0.0))
{
    const auto node = [&](int i, int j) {
        const auto [x, r] = profile(double(i) / rings);
        const double angle = 2.0 * pi * j / sectors;
        return Vec3(x, r * std::cos(angle), r * std::sin(angle));
    };
    const MaterialAir panel = airOf(law, coefficient);
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const Vec3 a = node(i, j);
            const Vec3 b = node(i + 1, j);
            const Vec3 c = node(i + 1, j + 1);
            const Vec3 d = node(i, j + 1);
            force += panelLoad(panel, a, b, c, wind, airDensity);
            force += panelLoad(panel, a, c, d, wind, airDensity);
        }
    return force.dot(wind) / (0.5 * airDensity * wind.squaredNorm() * wind.norm());
}

double capDrag(AirLaw law, double halfAngle, int rings, int sectors) // on pi R^2, C = 1
{
    return dragOfRevolution(law, 1.0, rings, sectors,
                            [=](double s) {
                                return std::pair(1.0 - std::cos(s * halfAngle),
                                                 std::sin(s * halfAngle));
                            })
           / (pi * std::pow(std::sin(std::min(halfAngle, 0.5 * pi)), 2));
}

// Drag of a hemisphere of flat trapezoids under the paper's law, on pi R^2, C = 1: with the area
// vector (p, q) of a trapezoid along the axis and along its radius, sum of p^3 / (p^2 + q^2). 6 x
// 12 gives 0.46657, 6 x 24 0.49151, 24 x 48 0.49786 with another program.
double polygonDrag(int rings, int sectors)
{
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double from = 0.5 * pi * i / rings;
        const double to = 0.5 * pi * (i + 1) / rings;
        const double p = 0.5 * std::sin(2.0 * pi / sectors)
                         * (std::pow(std::sin(to), 2) - std::pow(std::sin(from), 2));
        const double q = std::sin(pi / sectors) * (std::cos(from) - std::cos(to))
                         * (std::sin(from) + std::sin(to));
        sum += sectors * p * p * p / (p * p + q * q);
    }
    return sum / pi;
}

double coneDrag(AirLaw law, double wall) // wall at this angle to the axis
{
    return dragOfRevolution(law, 1.0, 1, 360,
                            [=](double s) { return std::pair(s / std::tan(wall), s); })
           / pi;
}

// Length 2 across the wind, ends open: per side, on the frontal area.
double cylinderDrag(AirLaw law)
{
    return dragOfRevolution(
               law, 1.0, 1, 360, [](double s) { return std::pair(2.0 * s, 1.0); },
               Vec3(0.0, 1.0, 0.0))
           / (2.0 * 2.0) / 2.0;
}

void addBodies(std::vector<Case>& cases)
{
    for (const auto& [rings, sectors] : {std::pair(6, 12), {6, 16}, {6, 24}, {24, 48}, {48, 96}})
        cases.push_back({"T-A3",
                         "hemisphere of " + std::to_string(rings) + " rings, "
                             + std::to_string(sectors) + " sectors, CD / C, paper",
                         polygonDrag(rings, sectors), relative(1e-9), "",
                         "sum of trapezoids; 1/2 in the limit", [rings = rings, sectors = sectors] {
                             return capDrag(AirLaw::Paper, 0.5 * pi, rings, sectors);
                         }});
    for (const AirLaw law : laws) {
        const bool paper = law == AirLaw::Paper;
        const char* id = paper ? "T-A3" : "T-A4";
        const std::string by = ", CD / C, " + nameOf(law);
        const auto row = [&](const char* body, double expected, const char* source,
                             std::function<double()> measure) {
            cases.push_back(
                {id, body + by, expected, relative(1e-3), "", source, std::move(measure)});
        };
        const char* capFormula = paper ? "(1 + cos^2 b) / 2" : "(2/3) (1 - cos^3 b) / sin^2 b";
        for (const double b : {30.0, 60.0, 90.0}) {
            const double cosine = std::cos(b * pi / 180.0);
            const double expected =
                paper ? 0.5 * (1.0 + cosine * cosine)
                      : 2.0 / 3.0 * (1.0 - cosine * cosine * cosine) / (1.0 - cosine * cosine);
            row(("cap of half angle " + std::to_string(int(b)) + " degrees").c_str(), expected,
                capFormula, [=] { return capDrag(law, b * pi / 180.0, 96, 192); });
        }
        row("sphere", paper ? 1.0 : 4.0 / 3.0, paper ? "1: both halves" : "4/3: both halves",
            [=] { return capDrag(law, pi, 192, 192); });
        row("cylinder across, per side", paper ? 2.0 / 3.0 : pi / 4.0,
            paper ? "mean of cos^2" : "mean of cos", [=] { return cylinderDrag(law); });
        for (const double wall : {15.0, 45.0})
            row(("cone with walls at " + std::to_string(int(wall)) + " degrees").c_str(),
                std::pow(std::sin(wall * pi / 180.0), paper ? 2 : 1), paper ? "sin^2 e" : "sin e",
                [=] { return coneDrag(law, wall * pi / 180.0); });
    }
}

void addIncidences(std::vector<Case>& cases)
{
    for (const AirLaw law : laws)
        for (const double angle : {5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0}) {
            const double alpha = angle * pi / 180.0;
            const double s = std::sin(alpha);
            const bool paper = law == AirLaw::Paper;
            cases.push_back(
                {"T-A4",
                 "CN of a plate at " + std::to_string(int(angle)) + " degrees, " + nameOf(law),
                 paper ? 4.0 * s * s : 2.0 * s, within(1e-12), "",
                 paper ? "4 sin^2 (paper)" : "2 sin (Moore, Cory, Tedrake 2014)", [=] {
                     const auto [a, b, c] = triangle(1.0);
                     const Vec3 wind = 10.0 * Vec3(std::cos(alpha), s, 0.0);
                     const Vec3 load =
                         panelLoad(airOf(law, paper ? 4.0 : 2.0), a, b, c, wind, airDensity);
                     return load.y() / (0.5 * airDensity * 100.0 * 0.5);
                 }});
        }
}

// A hemispherical canopy with the drag of CD0 = 0.775 on its nominal area pi D0^2 / 4, which is its
// surface: R = D0 / sqrt(8), CD0 = C / 4 under the paper's law.
double canopySpeed(double nominal, double mass)
{
    const double radius = nominal / std::sqrt(8.0);
    const double perPressure =
        capDrag(AirLaw::Paper, 0.5 * pi, 192, 384) * 4.0 * 0.775 * pi * radius * radius; // m^2
    return std::sqrt(2.0 * mass * standardGravity / (airDensity * perPressure));
}

void addCanopies(std::vector<Case>& cases)
{
    const char* source = "sqrt(2 m g / (rho CD0 S0)), CD0 0.775 (Knacke 1991)";
    for (const auto& [nominal, speed] :
         {std::pair(8.53, 6.013), {10.257, 5.0}, {8.548, 6.0}, {7.327, 7.0}}) {
        char title[80];
        std::snprintf(title, sizeof title, "hemisphere canopy, D0 %g m, 100 kg, descent", nominal);
        cases.push_back({"T-A8", title, speed, within(0.5e-3), "m/s", source,
                         [nominal = nominal] { return canopySpeed(nominal, 100.0); }});
    }
}

} // namespace

std::vector<Case> airCases()
{
    std::vector<Case> cases;
    addTerminals(cases);
    addIncidences(cases);
    addBodies(cases);
    addCanopies(cases);
    return cases;
}

} // namespace ripstop
