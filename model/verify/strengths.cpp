// What is loaded until it breaks: at the load that its strength says, at three resolutions and as a
// new scene solves it.
//
// In order: a strip of parachute nylon, as in the test of its strength (RF-27); a slit in a sheet,
// which runs at the load of fracture mechanics (T-T6); a carbon rod that is bent far until it snaps
// (T-T7); a line that a falling weight jerks (T-T8).
#include "compile/compile.h"
#include "materials/presets.h"
#include "simulation/simulation.h"
#include "verify/by_default.h"
#include "verify/flat_cloth.h"
#include "verify/slit_sheet.h"
#include "verify/text.h"

#include <cmath>
#include <limits>

namespace ripstop {
namespace {

Material fromLibrary(const char* name)
{
    Material material;
    give(material, **findPreset(name));
    material.tearRule = TearRule::Strength;
    return material;
}

// The share of the weights of a scene under which it tears first, as gravity grows: to 0.95 of it
// within the time of one and a half swings, then slowly on to `last`; not a number when it does
// not. Viscosity, which lets what swings with `slowest`, 1/s, lag by 1 / slowest, makes this 0.25 %
// too much.
double shareAtTear(Scene scene, double slowest, double last = 1.1)
{
    constexpr double quick = 0.95, slowRate = 0.0025; // 1, of 1 / slowest
    scene.settings.viscosity = slowest;
    System system = **compile(scene);
    const Vec3 gravity = system.gravity;
    Stepper stepper;
    State state = system.start;
    for (double share = 0.0; share < last;) {
        share += (share < quick ? 0.1 : slowRate) * slowest * system.timeStep;
        system.gravity = share * gravity;
        stepper.step(system, state);
        if (!state.tears.empty())
            return share;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

// --- a strip ------------------------------------------------------------------------------------

constexpr double testWidth = 0.05, testLength = 0.2; // m, of ISO 13934-1

// N. Its mesh does not lie along its yarns, as none of a sail does.
double strengthOfStrip(double warp, double cell, double efficiency, SolvedBy by)
{
    Material nylon = fromLibrary("mil_7020_1");
    nylon.jointEfficiency = efficiency;
    const double load = efficiency * 7355.0 * testWidth;
    Scene scene =
        hungByRollers(turnedRectangle(testLength, testWidth, cell, 17.0), nylon, warp, load);
    if (by)
        scene.settings.solver = *by;
    // of the weight on the strip, as stiff as at rest
    const double slowest =
        std::sqrt(*nylon.membraneStiffness * testWidth / testLength * standardGravity / load);
    return load * shareAtTear(scene, slowest);
}

void addTestStrips(std::vector<Case>& cases)
{
    const auto add = [&](double warp, double cell, double efficiency, SolvedBy by) {
        cases.push_back({"RF-27",
                         "strip of 1.1 oz nylon, 50 mm, drawn along its "
                             + std::string(warp == 0.0 ? "warp" : "weft")
                             + (efficiency < 1.0 ? " at a seam of 0.8" : "") + ", cells of "
                             + digits(1e3 * cell, 3) + " mm, " + nameOf(by) + ", breaks at",
                         efficiency * 367.75, relative(0.01), "N", "MIL-C-7020 I: 7355 N/m x width",
                         [=] { return strengthOfStrip(warp, cell, efficiency, by); }});
    };
    for (const double cell : {0.025, 0.0125, 0.008}) {
        add(0.0, cell, 1.0, {});
        add(90.0, cell, 1.0, {});
        add(0.0, cell, 0.8, {});
    }
    for (const Solver solver : {Solver::Direct, Solver::SmallSteps, Solver::GaussSeidel,
                                Solver::AveragedJacobi, Solver::PaperJacobi})
        for (const double cell : {0.025, 0.0125, 0.008})
            add(0.0, cell, 1.0, solver);
}

// --- a slit --------------------------------------------------------------------------------------

void addSlitSheets(std::vector<Case>& cases)
{
    for (const TearMesh mesh : {TearMesh::Vanish, TearMesh::Split})
        for (const int cells : {42, 54, 66}) {
            const auto torn = shared([=] { return drawnApart({cells, mesh, false, true}); });
            const std::string title = "sheet of 0.6 m with a slit of 0.2 m, "
                                      + std::to_string(cells) + " x " + std::to_string(cells) + ", "
                                      + nameOf(mesh) + ", ";
            const auto add = [&](const char* what, auto measure) {
                cases.push_back({"T-T6", title + what, SlitSheet::expected(), relative(0.1), "N/m",
                                 "sqrt(2 F E t cos(pi a / W) / (pi a)), Griffith 1921; Rivlin and "
                                 "Thomas 1953; Feddersen 1966",
                                 measure});
            };
            add("tears on at", [=] { return torn().began; });
            add("bears at most", [=] { return torn().most; });
            cases.push_back({"T-T6", title + "left of that when it is through", 0.4, atMost, "",
                             "nothing stops it", [=] { return torn().left / torn().began; }});
        }
}

// --- a spar --------------------------------------------------------------------------------------

// A rod of the library that is as long as to have its breaking moment at its clamp when
// P L^2 / EI = 2: the load has come nearer to the clamp by 0.16064 L by then, so that
// M = 2 EI / L (1 - 0.16064).
struct SnappedRod
{
    static constexpr double shape = 2.0, nearer = 0.16064; // 1

    Material carbon = fromLibrary("carbon_rod_4");
    double length = shape * carbon.flexuralRigidity * (1.0 - nearer) / *carbon.breakingMoment; // m
    double load = shape * carbon.flexuralRigidity / (length * length);                         // N

    double perMetre() const { return carbon.linearDensity.value_or(0.0); }
    double slowest() const // 1/s
    {
        return std::sqrt(3.0 * carbon.flexuralRigidity * standardGravity
                         / (load * std::pow(length, 3)));
    }
    Scene scene(int links) const;
};

// A link before the clamp, x = 0, is held. Half of its own weight counts as if it were at the tip.
Scene SnappedRod::scene(int links) const
{
    Scene scene;
    scene.settings.airDensity = 0.0;
    const Id material = addItem(scene, carbon);
    Network network(scene, "rod");
    const double cell = length / links, own = perMetre() * (length + cell);
    const Id from = network.particle({-cell, 0.0, 0.0}), to = network.particle({length, 0.0, 0.0});
    const std::vector<Id> nodes = network.line(from, to, links + 1, own, material, Resists::Both);
    network.row(nodes[0]).pinned = network.row(nodes[1]).pinned = true;
    network.row(to).mass = load / standardGravity - 0.5 * perMetre() * (length - cell);
    network.finish({}, {});
    return scene;
}

void addSnappedRods(std::vector<Case>& cases)
{
    const char* source = "M = P x; Bisshopp and Drucker 1945; Mattiasson 1981";
    for (const SolvedBy by : {SolvedBy(), SolvedBy(Solver::Direct)})
        for (const int links : {8, 16, 32}) {
            const SnappedRod rod;
            const auto tear = [=](double last) {
                Scene scene = rod.scene(links);
                if (by)
                    scene.settings.solver = *by;
                return shareAtTear(scene, rod.slowest(), last);
            };
            const std::string title = "carbon rod of 4 mm, bent to a drop of half its length, "
                                      + std::to_string(links) + " links, " + nameOf(by) + ", ";
            cases.push_back({"T-T7", title + "snaps at", rod.load, relative(0.01), "N", source,
                             [=] { return rod.load * tear(1.1); }});
            cases.push_back({"T-T7", title + "snaps below 0.985 of that", 0.0, exactly, "", source,
                             [=] { return std::isnan(tear(0.985)) ? 0.0 : 1.0; }});
        }
}

// --- a line --------------------------------------------------------------------------------------

// N, of a line of 2 m that 2 kg jerk after a fall of 1 m, with twice of what its knots bear.
double loadAtBreak(int links, double timeStep)
{
    Scene scene;
    scene.settings.airDensity = 0.0;
    scene.settings.timeStep = timeStep;
    const Id cord = addItem(scene, fromLibrary("dyneema_1"));
    Network network(scene, "line");
    const Id from = network.particle({0.0, 0.0, 0.0}), to = network.particle({2.0, 0.0, 0.0});
    network.line(from, to, links, 0.00114, cord, Resists::Tension); // kg, of the line
    network.row(from).pinned = true;
    network.row(to).mass = 2.0;
    network.finish({}, {});
    for (Entry& entry : scene.items)
        if (auto* part = std::get_if<Part>(&entry.item))
            for (Particle& particle : part->particles) // it is slack
                particle.position = {0.0, -0.5 * particle.position.x(), 0.0};
    Simulation simulation(*compile(scene));
    while (simulation.state().tears.empty())
        if (!simulation.step() || simulation.state().time > 1.0)
            return std::numeric_limits<double>::quiet_NaN();
    return simulation.state().tears[0].force;
}

void addJerkedLines(std::vector<Case>& cases)
{
    for (const int links : {1, 8})
        for (const double rate : {120.0, 240.0, 480.0})
            cases.push_back({"T-T8",
                             "line of 1 mm Dyneema, " + std::to_string(links)
                                 + (links == 1 ? " link" : " links") + ", jerked by 2 kg, "
                                 + digits(rate, 3) + " steps a second, breaks at",
                             0.6 * 785.0, relative(0.01), "N",
                             "its strength, 785 N, x 0.6 of knots",
                             [=] { return loadAtBreak(links, 1.0 / rate); }});
}

} // namespace

std::vector<Case> strengthCases()
{
    std::vector<Case> cases;
    addTestStrips(cases);
    addSlitSheets(cases);
    addSnappedRods(cases);
    addJerkedLines(cases);
    return cases;
}

} // namespace ripstop
