// Ropes: the catenary, the rope that stretches under its weight, its longitudinal mode, and lines
// that carry no compression.
//
// In order: the catenary between two pins (R1), the rope that stretches under its own weight (R2),
// its longitudinal mode (R5), and lines that go slack rather than push (R6).
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/by_default.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// --- R1: 10 m of rope over a span of 8 m --------------------------------------------------------

// Rope of `count` rods between pins, at rest; starts as a V, which has the right length.
struct HungRope
{
    double sag;                       // m
    double least;                     // N, smallest tension
    double end;                       // N, of the first rod
    std::array<double, 2> horizontal; // N, smallest and largest of the horizontal force
};

HungRope hungRope(double span, int count, SolvedBy by, Resists resists)
{
    const double length = 10.0 / count;
    const double depth = std::sqrt(25.0 - 0.25 * span * span);
    System system = heavySystem(1.0 / 1000.0);
    system.viscosity = 3.0;
    solve(system, by, 60);
    for (int i = 0; i <= count; ++i) {
        const double x = span * (double(i) / count - 0.5);
        const Vec3 place(x, depth * (std::abs(x) / (0.5 * span) - 1.0), 0.0);
        if (i == 0 || i == count)
            addPin(system, place);
        else
            addParticle(system, place, 0.2 * length);
        if (i > 0)
            addRod(system, i - 1, i, length).resists = resists;
    }
    finish(system);
    const State state = runFor(system, 8.0);
    const std::vector<double> tension = tensions(system, state);
    HungRope result{-state.position[std::size_t(count / 2)].y(),
                    *std::min_element(tension.begin(), tension.end()),
                    tension[0],
                    {1e9, -1e9}};
    for (int i = 0; i < count; ++i) {
        const Vec3 along = state.position[std::size_t(i) + 1] - state.position[std::size_t(i)];
        const double force = tension[std::size_t(i)] * along.x() / along.norm();
        result.horizontal[0] = std::min(result.horizontal[0], force);
        result.horizontal[1] = std::max(result.horizontal[1], force);
    }
    return result;
}

void addRopeCatenaries(std::vector<Case>& cases)
{
    const double w = 0.2 * standardGravity; // N/m
    const double a = 3.38201879;            // m, from 8 = 2 a asinh(5 / a)
    const std::pair<SolvedBy, Resists> ways[] = {
        {Solver::GaussSeidel, Resists::Both},    {Solver::AveragedJacobi, Resists::Both},
        {Solver::GaussSeidel, Resists::Tension}, {Solver::Direct, Resists::Tension},
        {std::nullopt, Resists::Both},           {std::nullopt, Resists::Tension}};
    for (const auto& [solver, resists] : ways) {
        const auto rope =
            shared([by = solver, resists = resists] { return hungRope(8.0, 40, by, resists); });
        const std::string by = std::string(", 10 m over 8 m, 40 ")
                               + (resists == Resists::Both ? "rods, " : "lines, ") + nameOf(solver);
        cases.push_back({"T-R1", "catenary sag" + by, 2.65437509, relative(0.01), "m",
                         "a cosh(4/a) - a", [=] { return rope().sag; }});
        // the default wants no accuracy of the pull of rods that never stretch
        if (!solver)
            continue;
        cases.push_back({"T-R1", "catenary, least H / w" + by, a, relative(0.01), "m",
                         "8 = 2 a asinh(5 / a)", [=] { return rope().horizontal[0] / w; }});
        cases.push_back({"T-R1", "catenary, largest H / w" + by, a, relative(0.01), "m",
                         "8 = 2 a asinh(5 / a)", [=] { return rope().horizontal[1] / w; }});
        // the end rod carries the weight of 39 of 40 nodes
        cases.push_back({"T-R1", "catenary, end tension / w" + by, std::hypot(a, 5.0 * 39.0 / 40.0),
                         relative(0.01), "m", "sqrt(H^2 + (39/80 w L)^2) / w",
                         [=] { return rope().end / w; }});
    }
    for (const auto& [count, sag] : {std::pair(10, 2.668644), {20, 2.657916}, {40, 2.655259}})
        cases.push_back(
            {"T-R1", "sag of " + std::to_string(count) + " rods with lumped masses, direct", sag,
             relative(1e-3), "m", "statics of the discrete chain", [count = count] {
                 return hungRope(8.0, count, Solver::Direct, Resists::Tension).sag;
             }});
}

// --- R2: 1 kg, 10 m, EA = 1e4 N -----------------------------------------------------------------

struct Stretched
{
    double longer; // m
    double top;    // N
};

Stretched stretched(LinkKind kind, SolvedBy by)
{
    const int count = 10;
    const double stiffness = 1e4 / 1.0; // N/m of a link of 1 m
    System system = heavySystem(1.0 / 2000.0);
    system.viscosity = 4.0;
    solve(system, by, 200);
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= count; ++i) {
        addParticle(system, {0.0, -1.0 * i, 0.0}, 0.1);
        if (kind == LinkKind::Spring)
            addSpring(system, i - 1, i, 1.0, stiffness, 20.0);
        else
            addRod(system, i - 1, i, 1.0, 1.0 / stiffness);
    }
    finish(system);
    const State state = runFor(system, 5.0);
    return {-state.position[count].y() - 10.0, tensions(system, state)[0]};
}

void addElasticRopes(std::vector<Case>& cases)
{
    const std::pair<LinkKind, SolvedBy> ways[] = {
        {LinkKind::Spring, Solver::GaussSeidel}, {LinkKind::Spring, std::nullopt},
        {LinkKind::Rod, Solver::GaussSeidel},    {LinkKind::Rod, Solver::AveragedJacobi},
        {LinkKind::Rod, Solver::Direct},         {LinkKind::Rod, std::nullopt}};
    for (const auto& [kind, solver] : ways) {
        const auto rope = shared([kind = kind, by = solver] { return stretched(kind, by); });
        const std::string by = kind == LinkKind::Rod ? ", elastic rods, " + nameOf(solver)
                               : solver              ? ", springs"
                                                     : ", springs, " + nameOf(solver);
        const Tolerance tolerance = relative(solver ? 1e-3 : 0.01); // a new scene wants 1 %
        cases.push_back({"T-R2", "1 kg of rope, 10 m, EA 10 kN, longer by" + by, 5.393657e-3,
                         tolerance, "m", "M g L / (2 EA) (N+1)/N, N 10",
                         [=] { return rope().longer; }});
        cases.push_back({"T-R2", "1 kg of rope, tension at the top" + by, standardGravity,
                         tolerance, "N", "M g", [=] { return rope().top; }});
    }
}

// --- R5: fixed at one end, free at the other -----------------------------------------------------

// 40 links with masses between and half a mass at the free end, let go in its lowest mode. The
// frequency, Hz, from the times at which the free end passes its place.
double longitudinalMode(LinkKind kind, Stepping stepping)
{
    const int count = 40;
    const double length = 10.0;  // m
    const double ea = 1e4;       // N
    const double perMetre = 0.1; // kg/m
    const double spacing = length / count;
    System system = emptySystem(2e-5, Integrator::VelocityVerlet);
    if (stepping == Stepping::ByDefault)
        solveByDefault(system);
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= count; ++i) {
        const double off = 1e-4 * std::sin(0.5 * std::numbers::pi * i / count);
        addParticle(system, {spacing * i + off, 0.0, 0.0},
                    perMetre * spacing * (i == count ? 0.5 : 1.0));
        if (kind == LinkKind::Spring)
            addSpring(system, i - 1, i, spacing, ea / spacing);
        else
            addRod(system, i - 1, i, spacing, spacing / ea);
    }
    finish(system);
    if (stepping == Stepping::ByDefault)
        takeSubstepsForSprings(system);
    Stepper stepper;
    State state = system.start;
    double before = 1.0;
    std::vector<double> passages; // s
    while (passages.size() < 5 && state.time < 2.0) {
        stepper.step(system, state);
        const double now = state.position[count].x() - length;
        if ((before > 0.0) != (now > 0.0))
            passages.push_back(state.time - system.timeStep * now / (now - before));
        before = now;
    }
    return passages.size() < 5 ? std::nan("") : 2.0 / (passages[4] - passages[0]);
}

// --- R6 ------------------------------------------------------------------------------------------

double sagOver(double span) // m, of 10 m of rope
{
    double low = 1e-3; // a, m
    double high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (2.0 * middle * std::asinh(5.0 / middle) < span ? low : high) = middle;
    }
    return low * (std::cosh(0.5 * span / low) - 1.0);
}

double pressed(Solver solver, Resists resists, double length) // m, after projection
{
    System system = emptySystem(0.01);
    system.solver = solver;
    addParticle(system, Vec3::Zero(), 1.0);
    addParticle(system, {length, 0.0, 0.0}, 1.0);
    addRod(system, 0, 1, 1.0).resists = resists;
    finish(system);
    const State state = run(system, 1);
    return (state.position[1] - state.position[0]).norm();
}

void addOneWay(std::vector<Case>& cases)
{
    const auto rope =
        shared([] { return hungRope(5.0, 40, Solver::GaussSeidel, Resists::Tension); });
    cases.push_back({"T-R6", "10 m of line between anchors 5 m apart, sag", sagOver(5.0),
                     relative(0.01), "m", "5 = 2 a asinh(5 / a), a cosh(2.5/a) - a",
                     [=] { return rope().sag; }});
    cases.push_back({"T-R6", "10 m of line between anchors 5 m apart, least tension", 0.0, atLeast,
                     "N", "a line cannot push", [=] { return rope().least; }});
    for (const Solver solver :
         {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel, Solver::Direct}) {
        const std::string by = ", length after a step, " + nameOf(solver);
        // the direct solver's rods keep a softness of at most 1e-4 of the inverse masses
        const Tolerance held = within(solver == Solver::Direct ? 1e-4 * 0.2 : 1e-12);
        cases.push_back({"T-R6", "line of 1 m pressed to 0.8 m" + by, 0.8, within(1e-12), "m",
                         "a line cannot push",
                         [=] { return pressed(solver, Resists::Tension, 0.8); }});
        cases.push_back({"T-R6", "line of 1 m drawn to 1.2 m" + by, 1.0, held, "m", "a line holds",
                         [=] { return pressed(solver, Resists::Tension, 1.2); }});
        cases.push_back({"T-R6", "strut of 1 m pressed to 0.8 m" + by, 1.0, held, "m",
                         "a strut holds",
                         [=] { return pressed(solver, Resists::Compression, 0.8); }});
        cases.push_back({"T-R6", "strut of 1 m drawn to 1.2 m" + by, 1.2, within(1e-12), "m",
                         "a strut cannot pull",
                         [=] { return pressed(solver, Resists::Compression, 1.2); }});
    }
}

} // namespace

std::vector<Case> ropeCases()
{
    std::vector<Case> cases;
    addRopeCatenaries(cases);
    addElasticRopes(cases);
    cases.push_back({"T-R5", "longitudinal mode of 10 m of rope, one end free, 40 springs",
                     std::sqrt(1e4 / 0.1) / 40.0, relative(1e-3), "Hz", "sqrt(EA/mu) / (4 L)",
                     [] { return longitudinalMode(LinkKind::Spring, Stepping::Fine); }});
    for (const LinkKind kind : {LinkKind::Spring, LinkKind::Rod})
        cases.push_back({"T-R5",
                         "longitudinal mode of 10 m of rope, one end free, 40 " + nameOf(kind) + "s"
                             + (kind == LinkKind::Rod ? ", by default" : withSubsteps),
                         std::sqrt(1e4 / 0.1) / 40.0, relative(0.01), "Hz", "sqrt(EA/mu) / (4 L)",
                         [=] { return longitudinalMode(kind, Stepping::ByDefault); }});
    addOneWay(cases);
    return cases;
}

} // namespace ripstop
