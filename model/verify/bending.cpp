// Strips of fabric and spars that bend by their own weight or under a load.
//
// In order: strips of fabric clamped at one or both ends, which come to rest under their weight or
// an end load; the angle that a tester after Peirce looks for; spars, with their sag and their
// lowest vibration; and what must not be there, forces that are left over within a crumpled strip.
#include "assembly/finish.h"
#include "builders/builder.h"
#include "compile/compile.h"
#include "forces/bend_force.h"
#include "forces/forces.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"
#include "verify/by_default.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double length = 0.2; // m, of what bends

enum class BentWeave { Alternating, OneWay, Equilateral };

// Fabric along x from 0 to `length`, `across` cells wide, and one column of cells before it that is
// pinned; with `bothEnds` one behind it as well.
struct BentStrip
{
    int along = 20; // cells
    int across = 2;
    BentWeave weave = BentWeave::Alternating;
    double stiffness = 0.2; // N m, B
    double density = 0.2;   // kg/m^2
    bool bothEnds = false;
    Stepping stepping = Stepping::Fine;

    double cell() const { return length / along; }
    double depth() const
    {
        return cell() * (weave == BentWeave::Equilateral ? std::sqrt(4.0 / 3.0) : 1.0);
    }
    double width() const { return across * depth(); }
    int at(int i, int j) const { return (i + 1) * (across + 1) + j; }
};

void addCell(const BentStrip& strip, int i, int j, System& system)
{
    const int a = strip.at(i, j), b = strip.at(i + 1, j);
    const int c = strip.at(i, j + 1), d = strip.at(i + 1, j + 1);
    const bool rising = strip.weave == BentWeave::Alternating   ? (i + j) % 2 == 0
                        : strip.weave == BentWeave::Equilateral ? i % 2 != 0
                                                                : true;
    const MaterialAir air = airOf(AirLaw::None, 0.0);
    addPanel(system, a, b, rising ? d : c, air);
    addPanel(system, rising ? a : b, d, c, air);
    const double stretch = 1000.0; // N/m
    for (const auto& [from, to] : {std::pair(a, b), std::pair(a, c), std::pair(a, d),
                                   std::pair(b, c), std::pair(c, d), std::pair(b, d)})
        addSpring(system, from, to, distance(system, from, to), stretch);
}

System strung(const BentStrip& strip)
{
    System system = heavySystem(1.0);
    const int last = strip.bothEnds ? strip.along + 1 : strip.along;
    for (int i = -1; i <= last; ++i)
        for (int j = 0; j <= strip.across; ++j) {
            const double shift = strip.weave == BentWeave::Equilateral && i % 2 != 0 ? 0.5 : 0.0;
            const Vec3 place(i * strip.cell(), 0.0, (j + shift) * strip.depth());
            const bool held = i <= 0 || (strip.bothEnds && i >= strip.along);
            held ? addPin(system, place, 0.0) : addParticle(system, place, 1.0);
        }
    for (int i = -1; i < last; ++i)
        for (int j = 0; j < strip.across; ++j)
            addCell(strip, i, j, system);
    std::fill(system.mass.begin(), system.mass.end(), 0.0);
    const double share = strip.density * 0.5 * strip.cell() * strip.depth() / 3.0;
    for (const FabricPanel& panel : system.panels)
        for (const int corner : panel.corner)
            system.mass[std::size_t(corner)] += share;
    for (std::size_t i = 0; i < system.mass.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            system.inverseMass[i] = 1.0 / system.mass[i];
    system.bending = {{strip.stiffness, 0.0}};
    return system;
}

// The state in which things have come to rest. `slowest` is the lowest angular frequency, 1/s.
State settled(System& system, double slowest, Stepping stepping)
{
    system.viscosity = 2.0 * slowest;
    if (stepping == Stepping::ByDefault)
        solveByDefault(system); // the solver says which bends are forces
    finish(system);
    if (stepping == Stepping::Fine)
        system.timeStep = 0.9 * stiffStepLimit(system);
    return runFor(system, 12.0 / slowest);
}

double cantileverFrequency(const BentStrip& strip) // 1/s
{
    return 3.516 * std::sqrt(strip.stiffness / (strip.density * std::pow(length, 4)));
}

// Mean sag of column i, m.
double sag(const BentStrip& strip, const State& state, int i)
{
    double sum = 0.0;
    for (int j = 0; j <= strip.across; ++j)
        sum -= state.position[std::size_t(strip.at(i, j))].y();
    return sum / (strip.across + 1);
}

double droopByWeight(const BentStrip& strip) // m, at the tip or in the middle
{
    System system = strung(strip);
    const State state =
        settled(system, (strip.bothEnds ? 6.36 : 1.0) * cantileverFrequency(strip), strip.stepping);
    return sag(strip, state, strip.bothEnds ? strip.along / 2 : strip.along);
}

constexpr double endLoad = 0.01; // N

// A kilometre of soft spring pulls with the same force however the end moves.
void pull(System& system, int particle, double force)
{
    const Vec3 far = system.start.position[std::size_t(particle)] - Vec3(0.0, 1000.0, 0.0);
    addSpring(system, particle, addPin(system, far), 0.0, force / 1000.0);
}

double droopByEndLoad(const BentStrip& strip) // m
{
    System system = strung(strip);
    system.gravity = Vec3::Zero();
    double total = 0.0; // as an even load: half at the corners
    for (int j = 0; j <= strip.across; ++j)
        total += j == 0 || j == strip.across ? 0.5 : 1.0;
    for (int j = 0; j <= strip.across; ++j)
        pull(system, strip.at(strip.along, j),
             endLoad * (j == 0 || j == strip.across ? 0.5 : 1.0) / total);
    return sag(strip, settled(system, cantileverFrequency(strip), strip.stepping), strip.along);
}

// Degrees below level, of the line from the edge to the tip of a strip twice its bending length
// long: what a tester after Peirce looks for.
double peirceAngle(BentStrip strip)
{
    const double c = 0.5 * length; // (B / (density g))^(1/3)
    strip.stiffness = c * c * c * strip.density * standardGravity;
    System system = strung(strip);
    const State state = settled(system, cantileverFrequency(strip), strip.stepping);
    const Vec3& tip = state.position[std::size_t(strip.at(strip.along, 0))];
    return std::atan2(-tip.y(), tip.x()) * 180.0 / std::numbers::pi;
}

// --- spars -----------------------------------------------------------------------------------

struct Spar
{
    int links = 20;
    double rigidity = 5.09; // N m^2, EI: Skyshark P100
    double density = 0.025; // kg/m
    LinkKind kind = LinkKind::Spring;
    Stepping stepping = Stepping::Fine;
    double cell() const { return length / links; }
};

int tipOf(const Spar& spar) { return spar.links + 1; } // particle

// A spar along x, clamped by one link before it whose ends are pinned.
System clamped(const Spar& spar)
{
    System system = emptySystem(1.0);
    for (int i = -1; i <= spar.links; ++i) {
        const Vec3 place(i * spar.cell(), 0.0, 0.0);
        const double mass = spar.density * spar.cell() * (i == spar.links ? 0.5 : 1.0);
        i <= 0 ? addPin(system, place) : addParticle(system, place, mass);
    }
    for (int i = 0; i <= spar.links; ++i) {
        if (spar.kind == LinkKind::Rod)
            addRod(system, i, i + 1, spar.cell(), 1e-5);
        else
            addSpring(system, i, i + 1, spar.cell(), 1e5);
        system.links.push_back({Key(i), spar.kind, i, i, i + 1});
        system.linkStuff.push_back({1, 0, LinkRole::Line, 0.0});
    }
    system.materialAir = {MaterialAir(), MaterialAir()};
    system.materialAir[1].key = 1;
    system.bending = {Bending(), {0.0, spar.rigidity}};
    return system;
}

double cantileverFrequency(const Spar& spar) // 1/s
{
    return 3.51602 * std::sqrt(spar.rigidity / (spar.density * std::pow(length, 4)));
}

double beamByEndLoad(const Spar& spar, double load) // m
{
    System system = clamped(spar);
    pull(system, tipOf(spar), load);
    const auto spring = int(system.springs.size()) - 1;
    system.links.push_back(
        {1000, LinkKind::Spring, spring, system.springs.back().a, system.springs.back().b});
    system.linkStuff.push_back({});
    const State state = settled(system, cantileverFrequency(spar), spar.stepping);
    return -state.position[std::size_t(tipOf(spar))].y();
}

double beamByWeight(const Spar& spar) // m
{
    System system = clamped(spar);
    system.gravity = {0.0, -standardGravity, 0.0};
    const State state = settled(system, cantileverFrequency(spar), spar.stepping);
    return -state.position[std::size_t(tipOf(spar))].y();
}

struct Vibration
{
    double frequency; // 1/s, angular
    double damping;   // 1, of the critical
};

// The tip, let go from the shape of the first mode.
Vibration vibration(const Spar& spar)
{
    System system = clamped(spar);
    if (spar.stepping == Stepping::ByDefault)
        solveByDefault(system);
    finish(system);
    const double b = 1.875104 / length; // 1/m, cos cosh = -1
    const double ratio = (std::cosh(b * length) + std::cos(b * length))
                         / (std::sinh(b * length) + std::sin(b * length));
    for (int i = 1; i <= spar.links; ++i) {
        const double x = b * i * spar.cell();
        system.start.position[std::size_t(i) + 1].y() =
            1e-4 * 0.5 * (std::cosh(x) - std::cos(x) - ratio * (std::sinh(x) - std::sin(x)));
    }
    if (spar.stepping == Stepping::Fine)
        system.timeStep = 0.5 * stiffStepLimit(system);
    State state = system.start;
    Stepper stepper;
    std::vector<double> turns; // s, when the tip goes up through rest
    std::vector<double> peaks;
    double peak = 0.0;
    while (turns.size() < 6 && state.time < 1.0) {
        const double before = state.position[std::size_t(tipOf(spar))].y();
        stepper.step(system, state);
        const double after = state.position[std::size_t(tipOf(spar))].y();
        peak = std::max(peak, after);
        if (before < 0.0 && after >= 0.0) {
            turns.push_back(state.time - system.timeStep * after / (after - before));
            peaks.push_back(std::exchange(peak, 0.0));
        }
    }
    if (turns.size() < 6)
        return {0.0, 0.0};
    const double turn = (turns[5] - turns[0]) / 5.0;
    // the peaks noted are those before each turn; the first is the start
    const double decrement = std::log(peaks[1] / peaks[5]) / 4.0;
    return {2.0 * std::numbers::pi / turn, decrement / (2.0 * std::numbers::pi)};
}

// --- what must not be there ------------------------------------------------------------------

enum class Leftover { Force, Torque };

// The sum of the internal forces of a crumpled strip, or of their moments, over their sizes.
double leftover(Leftover what)
{
    System system = strung({6, 4});
    finish(system);
    Dice dice(3);
    State state = system.start;
    for (PaddedVec3& x : state.position)
        x += dice.vector(0.01);
    const BendLists& lists = system.of<BendLists>();
    BendScratch bends;
    bends.size(lists);
    ThreadPool alone(1);
    fillBends(system, state, alone, bends);
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    double size = 0.0;
    for (std::size_t p = 0; p < state.position.size(); ++p)
        for (int k = lists.at.start[p]; k < lists.at.start[p + 1]; ++k) {
            const Vec3 one = bends.load[std::size_t(lists.at.items[std::size_t(k)])];
            force += one;
            torque += Vec3(state.position[p]).cross(one);
            size += one.norm();
        }
    return (what == Leftover::Force ? force.norm() : torque.norm() / length) / size;
}

void addStrips(Stepping stepping, std::vector<Case>& cases)
{
    BentStrip usual;
    usual.stepping = stepping;
    const std::string by = stepping == Stepping::Fine ? "" : ", by default";
    const double weight = usual.density * standardGravity; // N/m^2
    const double tip = weight * std::pow(length, 4) / (8.0 * usual.stiffness);
    const auto row = [&](const std::string& title, double expected, Tolerance tolerance,
                         const char* source, auto measure, auto change) {
        BentStrip strip = usual;
        change(strip);
        const bool slope = tolerance.rule == Rule::Absolute;
        cases.push_back({"M6", title + by, expected, tolerance, slope ? "deg" : "m", source,
                         [=] { return measure(strip); }});
    };
    for (const int along : {10, 20, 40})
        row("strip droops by its weight, " + std::to_string(along) + " cells", tip, relative(0.02),
            "w L^4 / (8 B)", droopByWeight, [=](BentStrip& strip) { strip.along = along; });
    row("strip droops by its weight, all diagonals one way", tip, relative(0.02), "w L^4 / (8 B)",
        droopByWeight, [](BentStrip& strip) {
            strip.across = 3;
            strip.weave = BentWeave::OneWay;
        });
    row("strip droops by its weight, equilateral cells", tip, relative(0.03), "w L^4 / (8 B)",
        droopByWeight, [](BentStrip& strip) {
            strip.across = 6;
            strip.weave = BentWeave::Equilateral;
        });
    row("strip clamped at both ends", weight * std::pow(length, 4) / (384.0 * usual.stiffness),
        relative(0.025), "w L^4 / (384 B)", droopByWeight,
        [](BentStrip& strip) { strip.bothEnds = true; });
    row("load at the end of a strip",
        endLoad * std::pow(length, 3) / (3.0 * usual.stiffness * usual.width()), relative(0.02),
        "F L^3 / (3 B W)", droopByEndLoad, [](BentStrip&) {});
    // heavy elastica, B t'' = -w (L - s) cos t with t(0) = t'(L) = 0, for w L^3 = 8 B
    row("Peirce: slope of a strip twice its bending length", 41.4873, within(0.5),
        "heavy elastica; Peirce 1930: 41.5", peirceAngle, [](BentStrip&) {});
    row("Peirce: slope of that strip with equilateral cells", 41.4873, within(0.5),
        "heavy elastica; Peirce 1930: 41.5", peirceAngle, [](BentStrip& strip) {
            strip.across = 12;
            strip.weave = BentWeave::Equilateral;
        });
}

void addSpars(Stepping stepping, std::vector<Case>& cases)
{
    Spar usual;
    usual.stepping = stepping;
    const std::string by = stepping == Stepping::Fine ? "" : ", by default";
    // Where springs make the spar its bending is a force. By default no step has more than 2000
    // substeps, and those of a new scene are 240 a second: such a spar of links of 2.5 mm, or one
    // whose vibration is to be seen, has to be a limp one.
    constexpr double limpness = 1e-3;
    for (const int links : {5, 20, 80}) {
        Spar spar = usual;
        spar.links = links;
        const bool limp = stepping == Stepping::ByDefault && links == 80;
        const double load = limp ? limpness : 1.0; // N
        if (limp)
            spar.rigidity *= limpness;
        cases.push_back({"M-EI",
                         "load at the end of a " + std::string(limp ? "limp spar, " : "spar, ")
                             + std::to_string(links) + " links" + by,
                         std::pow(length, 3) / (3.0 * usual.rigidity), relative(0.025), "m",
                         "F L^3 / (3 EI)", [=] { return beamByEndLoad(spar, load); }});
    }
    for (const int links : {20, 80, 200}) {
        if (stepping == Stepping::Fine)
            break;
        Spar spar = usual;
        spar.links = links;
        spar.kind = LinkKind::Rod;
        cases.push_back({"M-EI",
                         "load at the end of a spar of " + std::to_string(links) + " rods" + by,
                         std::pow(length, 3) / (3.0 * usual.rigidity), relative(0.025), "m",
                         "F L^3 / (3 EI)", [=] { return beamByEndLoad(spar, 1.0); }});
    }
    cases.push_back({"M-EI", "spar droops by its weight" + by,
                     usual.density * standardGravity * std::pow(length, 4) / (8.0 * usual.rigidity),
                     relative(0.01), "m", "w L^4 / (8 EI)", [=] { return beamByWeight(usual); }});
    Spar swinging = usual;
    if (stepping == Stepping::ByDefault)
        swinging.rigidity *= limpness;
    const double frequency = cantileverFrequency(swinging);
    const auto free = shared([=] { return vibration(swinging); });
    cases.push_back({"M-EI", "vibration of a clamped spar" + by, frequency, relative(0.01), "1/s",
                     "3.516 sqrt(EI / (m L^4))", [=] { return free().frequency; }});
    cases.push_back({"M-EI", "its damping, which is none" + by, 0.0, within(1e-3), "",
                     "energy is kept", [=] { return free().damping; }});
}

} // namespace

std::vector<Case> bendingCases()
{
    std::vector<Case> cases;
    for (const Stepping stepping : {Stepping::Fine, Stepping::ByDefault}) {
        addStrips(stepping, cases);
        addSpars(stepping, cases);
    }
    const char* crumpled = "of a crumpled strip, over the sum of their sizes";
    cases.push_back({"C1", std::string("sum of bending forces ") + crumpled, 0.0, within(1e-12), "",
                     "action and reaction", [] { return leftover(Leftover::Force); }});
    cases.push_back({"C1", std::string("torque of bending forces ") + crumpled, 0.0, within(1e-12),
                     "", "action and reaction", [] { return leftover(Leftover::Torque); }});
    return cases;
}

} // namespace ripstop
