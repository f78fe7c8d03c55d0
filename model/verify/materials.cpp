// Sheets and ropes whose links follow from numbers of their material: the same at every
// resolution.
//
// A sheet and a rope are compiled at several resolutions from the same material, and modulus, mass,
// sag and growth are measured: each must be that of the material, whatever the number of cells.
#include "builders/builder.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"
#include "verify/by_default.h"

#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

constexpr double sheetDensity = 0.25;     // kg/m^2
constexpr double sheetStiffness = 1000.0; // N/m

constexpr double loose = 2; // what holds the sheet
constexpr double byTwoEdges = 3;

// 1 m x 1 m; `shear` is G / (E t).
Scene sheet(int columns, int rows, double hang, double shear)
{
    return *build(*findBuilder("cloth"), {{"columns", columns},
                                          {"rows", rows},
                                          {"hang", hang},
                                          {"density", sheetDensity},
                                          {"membrane", sheetStiffness},
                                          {"shear", shear},
                                          {"bend", 0},
                                          {"sphere", 0},
                                          {"level", 2}});
}

// N/m: what strains a loose sheet evenly by e along and -nu e across, over e, at its left edge.
double modulus(int columns, int rows)
{
    constexpr double shear = 0.3;
    Scene scene = sheet(columns, rows, loose, shear);
    scene.settings.integrator = Integrator::SemiImplicitEuler; // forces say at once what they are
    const auto system = *compile(scene);
    State state = system->start;
    const double e = 1e-6;
    // C12 / C11 for G = C12 and C11 - C12^2 / C11 = E t
    const double nu = shear / (0.5 * (1.0 + std::sqrt(1.0 + 4.0 * shear * shear)));
    for (auto& x : state.position)
        x = Vec3(x.x() * (1.0 + e), x.y(), x.z() * (1.0 - nu * e));
    const std::vector<double> tension = tensions(*system, state);
    double pull = 0.0;
    for (std::size_t i = 0; i < tension.size(); ++i) {
        const LinkPlace& link = system->links[i];
        const Vec3 along =
            state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)];
        if (link.a % (columns + 1) == 0 || link.b % (columns + 1) == 0)
            pull += tension[i] * std::abs(along.x()) / along.norm();
    }
    return pull / e;
}

double mass(int cells) // kg
{
    const auto system = *compile(sheet(cells, cells, loose, 0.3));
    return std::accumulate(system->mass.begin(), system->mass.end(), 0.0);
}

// m, in the middle, held level by two edges.
double sag(int cells)
{
    Scene scene = sheet(cells, cells, byTwoEdges, 0.05);
    scene.settings.viscosity = 20.0;
    scene.settings.airDensity = 0.0;
    Simulation simulation(*compile(scene));
    (void)simulation.runUntil(2.0);
    return 2.0 - simulation.state().position[std::size_t((cells + 2) * (cells / 2))].y();
}

// m, by its own weight: 1 kg on 10 m, EA 10 kN, half a share of mass at the lower end.
double growth(int segments, SolvedBy by)
{
    Scene scene = *build(
        *findBuilder("rope"),
        {{"segments", segments}, {"length", 10}, {"density", 0.1}, {"axial", 1e4}, {"angle", 0}});
    scene.settings.viscosity = 50.0;
    scene.settings.airDensity = 0.0;
    if (by) {
        scene.settings.substeps = 20;
        scene.settings.solver = *by;
    }
    Simulation simulation(*compile(scene));
    (void)simulation.runUntil(1.0);
    const auto& position = simulation.state().position; // the rope's ends come first
    return Vec3(position[0] - position[1]).norm() - 10.0;
}

} // namespace

std::vector<Case> materialCases()
{
    std::vector<Case> cases;
    const std::string woven = "woven sheet, E t 1000 N/m, ";
    const auto by = [](int columns, int rows) {
        return ", " + std::to_string(columns) + " x " + std::to_string(rows);
    };
    for (const auto& [columns, rows] :
         {std::pair(10, 10), std::pair(20, 20), std::pair(40, 40), std::pair(20, 34),
          std::pair(34, 20)}) // the latter with cells of 1.7 to 1, either way
        cases.push_back({"M-E", woven + "pulled along a thread" + by(columns, rows), sheetStiffness,
                         relative(1e-3), "N/m", "F = E t W strain",
                         [=] { return modulus(columns, rows); }});
    for (const int cells : {10, 20, 40}) {
        cases.push_back({"M-W", "sheet of 0.25 kg/m^2" + by(cells, cells), sheetDensity,
                         relative(1e-12), "kg", "density x area", [=] { return mass(cells); }});
        cases.push_back({"M-S", woven + "sag between two edges" + by(cells, cells),
                         std::cbrt(3.0 * sheetDensity * standardGravity / (64.0 * sheetStiffness)),
                         relative(0.03), "m", "s^3 = 3 w W^4 / (64 E t), parabola",
                         [=] { return sag(cells); }});
    }
    for (const SolvedBy by : {SolvedBy(Solver::Direct), SolvedBy()})
        for (const int segments : {5, 20, 80})
            cases.push_back({"T-R2",
                             "rope of EA 10 kN as a material, longer by, "
                                 + std::to_string(segments) + " rods"
                                 + (by ? "" : ", " + nameOf(by)),
                             4.903325e-3, relative(by ? 1e-3 : 0.01), "m", "M g L / (2 EA)",
                             [=] { return growth(segments, by); }});
    return cases;
}

} // namespace ripstop
