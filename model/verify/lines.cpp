// Cables between two anchors of one height, each of two numbers of pieces.
//
// In order: the elastic catenary (RF-20), and the cable of a suspension bridge under the load that
// it was cut for and under more (RF-21). Viscosity, which changes nothing of where they end, brings
// them to rest. Weight is along -y.
#include "measure/diagnostics.h"
#include "verify/at_rest.h"
#include "verify/line_scenes.h"

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

struct Cable
{
    double span;     // m
    double axial;    // N
    double perMetre; // kg/m, of its unstressed length
};

struct Hung
{
    double horizontal = 0.0; // N, in the middle
    double end = 0.0;        // N, on the anchor
    double sag = 0.0;        // m
};

// What hangs between the anchors at rest. Half the weight of the first piece stands on its anchor,
// which carries it with the pull of that piece.
//   place  m, of its nodes, of which the outer two are pinned
//   cut    m, of the pieces between
//   mass   kg, of the nodes
Hung hung(Scene scene, const Id cord, const std::vector<Vec3>& place,
          const std::vector<double>& cut, const std::vector<double>& mass, double seconds)
{
    Network network(scene, "cable");
    std::vector<Id> nodes;
    for (std::size_t i = 0; i < place.size(); ++i) {
        nodes.push_back(network.particle(place[i], mass[i]));
        if (i == 0)
            continue;
        network.rod(nodes[i - 1], nodes[i], cord, Resists::Tension);
        network.setRestLength(cut[i - 1]);
    }
    network.row(nodes.front()).pinned = network.row(nodes.back()).pinned = true;
    network.finish({}, {});
    const AtRest rest = restOf(scene, seconds);
    const auto pull = [&](std::size_t piece) -> Vec3 {
        const Vec3 along = rest.state.position[piece + 1] - rest.state.position[piece];
        return tensions(*rest.system, rest.state)[piece] * along.normalized();
    };
    const std::size_t middle = cut.size() / 2;
    return {pull(middle).x(), (pull(0) - Vec3(0.0, standardGravity * mass[0], 0.0)).norm(),
            -rest.state.position[middle].y()};
}

// Irvine 1981, Cable Structures, 2.1: a level span l, unstressed length L0, weight w of a metre of
// it.
Hung irvine(const Cable& cable, double length)
{
    const double w = cable.perMetre * standardGravity; // N/m
    double low = 1e-3, high = 1e6;                     // N
    for (int i = 0; i < 200; ++i) {
        const double h = std::sqrt(low * high);
        const double span =
            h * length / cable.axial + 2.0 * h / w * std::asinh(0.5 * w * length / h);
        (span < cable.span ? low : high) = h;
    }
    const double end = std::hypot(low, 0.5 * w * length);
    return {low, end, w * length * length / (8.0 * cable.axial) + (end - low) / w};
}

Hung catenary(const Cable& cable, double length, int pieces, SolvedBy by)
{
    const double mass = cable.perMetre * length / pieces;
    const double slowest = std::numbers::pi / cable.span
                           * std::sqrt(irvine(cable, length).horizontal / cable.perMetre);
    Scene scene = emptyScene(by, slowest);
    const Id cord = addCord(scene, cable.axial);
    const double depth = 0.5 * std::sqrt(length * length - cable.span * cable.span);
    std::vector<Vec3> place; // on a V of the right length
    for (int i = 0; i <= pieces; ++i) {
        const double x = 2.0 * i / pieces - 1.0;
        place.emplace_back(0.5 * cable.span * x, depth * (std::abs(x) - 1.0), 0.0);
    }
    std::vector<double> masses(place.size(), mass);
    masses.front() = masses.back() = 0.5 * mass;
    return hung(std::move(scene), cord, place,
                std::vector<double>(std::size_t(pieces), length / pieces), masses, 16.0 / slowest);
}

void addCatenaries(std::vector<Case>& cases)
{
    struct Row
    {
        const char* title;
        Cable cable;
        double length; // m
    };
    const Row rows[]{{"1 mm of Dyneema over 50 m", {50.0, 43197.0, 0.5686e-3}, 50.1},
                     {"rope of 1 kg/m over 10 m", {10.0, 1e5, 1.0}, 12.0},
                     {"cord 550 over 20 m", {20.0, 4900.0, 6.61e-3}, 20.5}};
    for (const Row& row : rows)
        for (const int pieces : {20, 40})
            for (const SolvedBy by : solvers) {
                const auto rope =
                    shared([=] { return catenary(row.cable, row.length, pieces, by); });
                const Hung known = irvine(row.cable, row.length);
                const std::string title = std::string(row.title) + ", " + std::to_string(pieces)
                                          + " pieces, " + nameOf(by) + ", ";
                cases.push_back({"RF-20", title + "horizontal pull", known.horizontal,
                                 relative(0.003), "N", "Irvine 1981, elastic catenary",
                                 [=] { return rope().horizontal; }});
                cases.push_back({"RF-20", title + "pull on the anchor", known.end, relative(0.003),
                                 "N", "Irvine 1981, elastic catenary", [=] { return rope().end; }});
                cases.push_back({"RF-20", title + "sag", known.sag, relative(0.003), "m",
                                 "Irvine 1981, elastic catenary", [=] { return rope().sag; }});
            }
}

// A cable that was cut to sag by 2 m over 20 m under 50 N per metre of plan, under `load`, N/m.
Hung bridge(double load, int pieces, SolvedBy by)
{
    constexpr double span = 20.0, sag = 2.0, cutFor = 50.0, axial = 172788.0;
    constexpr double horizontal = cutFor * span * span / (8.0 * sag); // N
    const double step = span / pieces;
    const double slowest =
        std::numbers::pi / span * std::sqrt(horizontal / cutFor * standardGravity);
    Scene scene = emptyScene(by, slowest);
    const Id cord = addCord(scene, axial);
    std::vector<Vec3> place; // too high by a tenth
    std::vector<double> cut, mass;
    for (int i = 0; i <= pieces; ++i) {
        const double x = 2.0 * i / pieces - 1.0;
        place.emplace_back(0.5 * span * x, 0.9 * sag * (x * x - 1.0), 0.0);
        mass.push_back(load * step / standardGravity * (i % pieces == 0 ? 0.5 : 1.0));
        if (i == 0)
            continue;
        const double slope = 4.0 * sag / span * (x - 1.0 / pieces); // of the chord of a parabola
        const double stretch = std::hypot(1.0, slope);              // 1, of its plan
        cut.push_back(step * stretch / (1.0 + horizontal * stretch / axial));
    }
    return hung(std::move(scene), cord, place, cut, mass, 16.0 / slowest);
}

void addBridges(std::vector<Case>& cases)
{
    const char* source = "parabola w l^2 / 8 H of a cable that stretches";
    for (const int pieces : {20, 40})
        for (const SolvedBy by : solvers) {
            const auto usual = shared([=] { return bridge(50.0, pieces, by); });
            const auto heavy = shared([=] { return bridge(80.0, pieces, by); });
            const std::string title = "suspension cable cut for 50 N/m, " + std::to_string(pieces)
                                      + " pieces, " + nameOf(by) + ", under ";
            const auto row = [&](const std::string& what, double expected, const char* unit,
                                 auto measure) {
                cases.push_back({"RF-21", title + what, expected,
                                 *unit == 'N' ? ofPull(by, 0.003) : relative(0.003), unit, source,
                                 measure});
            };
            row("50 N/m, horizontal pull", 1250.0, "N", [=] { return usual().horizontal; });
            row("50 N/m, pull on the anchor", 1346.29, "N", [=] { return usual().end; });
            row("50 N/m, sag", 2.0, "m", [=] { return usual().sag; });
            row("80 N/m, horizontal pull", 1866.25, "N", [=] { return heavy().horizontal; });
            row("80 N/m, sag", 2.1433, "m", [=] { return heavy().sag; });
        }
}

} // namespace

std::vector<Case> lineCases()
{
    std::vector<Case> cases;
    addCatenaries(cases);
    addBridges(cases);
    return cases;
}

} // namespace ripstop
