// Fabric that holds air: exact values of a rigid cup, the shape under uniform pressure, and how a
// round parachute of the size of a C-9 opens.
//
// In order: a rigid cup of four panels, whose pressure, drag and added mass follow from its shape;
// parachutes of the builder under uniform pressure, whose shape is that of a mylar balloon; the
// opening of a C-9 (verify/opening.h); and the descent of porous canopies.
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/opening.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace ripstop {
namespace {

// --- a rigid cup: a pyramid of four panels, 0.5 m high, its mouth a square of 1 m x 1 m, down

constexpr double cupHeight = 0.5;
constexpr double cupSide = 1.0;
constexpr double releaseGravity = 0.01; // m/s^2, so small that there is no drag to speak of

struct Cup
{
    double mass = 0.1;     // kg
    double pressure = 1.6; // 1, coefficient
    double porosity = 0.0;
    double addedMass = 0.0;
    bool held = false;
    double timeStep = 1.0 / 2000.0; // s
};

// Masses lie as the cloth does, so that what moves it moves all of it alike.
System cup(const Cup& given)
{
    System system = emptySystem(given.timeStep);
    const double half = 0.5 * cupSide;
    const std::array<Vec3, 5> corners{Vec3(0.0, cupHeight, 0.0), Vec3(half, 0.0, half),
                                      Vec3(half, 0.0, -half), Vec3(-half, 0.0, -half),
                                      Vec3(-half, 0.0, half)};
    for (int i = 0; i < 5; ++i) {
        addParticle(system, corners[std::size_t(i)], given.mass * (i == 0 ? 1.0 / 3.0 : 1.0 / 6.0));
        if (given.held)
            system.inverseMass.back() = 0.0;
    }
    Canopy canopy;
    canopy.pressureCoefficient = given.pressure;
    canopy.fillEfficiency = 0.07;
    canopy.addedMass = given.addedMass;
    canopy.particles = {0, 1, 2, 3, 4};
    for (int i = 0; i < 4; ++i) {
        const int a = 1 + i;
        const int b = 1 + (i + 1) % 4;
        addRod(system, 0, a, distance(system, 0, a));
        addRod(system, a, b, distance(system, a, b));
        MaterialAir air = airOf(AirLaw::LinearNormal, 2.0);
        air.porosity = given.porosity;
        addPanel(system, 0, a, b, air);
        canopy.facets.push_back({i, {0, a, b}, 0.25});
        canopy.mouth.push_back(a);
    }
    addRod(system, 1, 3, distance(system, 1, 3));
    addRod(system, 2, 4, distance(system, 2, 4));
    canopy.area = 2.0 * cupSide * std::hypot(cupHeight, half);
    system.canopies.push_back(canopy);
    finish(system);
    return system;
}

State cupInWind(double porosity)
{
    Cup given;
    given.porosity = porosity;
    given.held = true;
    System system = cup(given);
    system.wind = {0.0, 10.0, 0.0};
    return run(system, 4000);
}

double dragOfCup() // N, tight, held in 10 m/s
{
    Cup given;
    given.held = true;
    System system = cup(given);
    system.wind = {0.0, 10.0, 0.0};
    double sum = 0.0;
    for (const Vec3& load : panelLoads(system, run(system, 4000)))
        sum += load.y();
    return sum;
}

// Over the weight: of a cup let go at rest, between two early moments.
double releaseOfCup(double addedMass)
{
    Cup given;
    given.addedMass = addedMass;
    given.timeStep = 1e-4;
    System system = cup(given);
    system.gravity = {0.0, -releaseGravity, 0.0};
    const State early = run(system, 1000);
    const State later = run(system, early, 100);
    const double change = later.velocity[0].y() - early.velocity[0].y();
    return -change / (100.0 * system.timeStep) / releaseGravity;
}

double addedMassOfCup()
{
    return airDensity * 2.0 / 3.0 * std::numbers::pi
           * std::pow(cupSide * cupSide / std::numbers::pi, 1.5);
}

// --- parachutes of the builder

Chute thrownC9(const Parameters& materials)
{
    Chute chute;
    chute.parameters = joined(sizeOfC9(), materials);
    chute.speed = 60.0;
    chute.until = 1.0;
    return chute;
}

// So far from what it carries that its lines are parallel.
Chute underEvenPressure()
{
    Chute chute;
    chute.parameters = {{"diameter", 1.0},    {"rings", 12},        {"line_length", 50.0},
                        {"line_segments", 1}, {"line_diameter", 0}, {"line_density", 1e-5},
                        {"friction", 0.0},    {"pressure", 1.68},   {"payload", 10.0}};
    chute.speed = 10.0;
    chute.held = true;
    chute.until = 3.0;
    chute.viscosity = 2.0;
    return chute;
}

double sinkRate(double porosity) // m/s
{
    Chute chute;
    chute.parameters = {
        {"pressure", 1.68}, {"porosity", porosity}, {"payload", 25.0}, {"altitude", 1000.0}};
    chute.gravity = standardGravity;
    const auto simulation = made(chute);
    if (!simulation->runUntil(10.0))
        return noResult;
    const double height = centerOfMass(simulation->system(), simulation->state().position).y();
    if (!simulation->runUntil(20.0))
        return noResult;
    return 0.1 * (height - centerOfMass(simulation->system(), simulation->state().position).y());
}

void addCups(std::vector<Case>& cases)
{
    const std::string pyramid = "rigid cup, ";
    const double q = 0.5 * airDensity * 100.0;
    cases.push_back({"T-C1", pyramid + "volume at the start", cupHeight * cupSide * cupSide / 3.0,
                     relative(1e-12), "m\u00b3", "pyramid",
                     [] { return run(cup({}), 1).canopies[0].volume; }});
    cases.push_back({"T-C2", pyramid + "pressure in 10 m/s, tight", 1.6 * q, relative(1e-6), "Pa",
                     "Cp q", [] { return cupInWind(0.0).canopies[0].pressure; }});
    cases.push_back({"T-C2", pyramid + "drag in 10 m/s, tight", 1.6 * q * cupSide * cupSide,
                     relative(1e-6), "N", "pressure times mouth, divergence theorem", dragOfCup});
    // The inflow is what leaks: sqrt(1 - s) = sqrt(s P / q) c S / A, S / A = sqrt(2) here.
    for (const double c : {0.03, 0.1}) {
        const double most = 1.6 / std::pow(1.0 + c * std::sqrt(1.6), 2); // P / q
        const double leak = c * std::sqrt(2.0);
        cases.push_back({"T-C3",
                         pyramid + "pressure in 10 m/s, porosity " + (c < 0.05 ? "0.03" : "0.1"),
                         q * most / (1.0 + most * leak * leak), relative(1e-3), "Pa",
                         "what comes in by the mouth leaks",
                         [c] { return cupInWind(c).canopies[0].pressure; }});
    }
    for (const double k : {0.0, 1.0, 10.0}) {
        cases.push_back({"T-C4",
                         pyramid + "release from rest, 0.1 kg, added mass "
                             + (k == 0.0   ? "none"
                                : k == 1.0 ? "of a hemisphere"
                                           : "ten times that"),
                         0.1 / (0.1 + k * addedMassOfCup()), relative(0.01), "g",
                         "a0 = g m / (m + ma)", [k] { return releaseOfCup(k); }});
    }
}

// What porous nylon has for CD0 is beside Knacke's in the references; here it is of tight cloth.
void addOpenings(std::vector<Case>& cases, const std::string& canopy, const Parameters& materials,
                 std::initializer_list<double> speeds)
{
    const std::string knacke = "Knacke 1991, chapter 5, flat circular";
    for (const double speed : speeds) {
        const auto held = shared([=] { return fly(heldC9(speed, materials)); });
        const std::string c9 = canopy + "held in " + std::to_string(int(speed)) + " m/s, ";
        cases.push_back({"T-C5", c9 + "width over D0", 0.695, within(0.065), "", knacke,
                         [held] { return held().width; }});
        if (materials.empty())
            cases.push_back({"T-C5", c9 + "CD0", 0.75, within(0.10), "", knacke,
                             [held] { return held().drag; }});
        cases.push_back({"T-C5", c9 + "fill constant n", 8.0, within(3.0), "", knacke,
                         [held] { return held().filled; }});
        cases.push_back({"T-C5", c9 + "growth exponent j", 2.0, within(0.5), "", knacke,
                         [held] { return held().growth; }});
    }
    cases.push_back({"T-C6", canopy + "100 kg at 60 m/s without weight, highest pull", 8127.4,
                     relative(0.30), "N",
                     "drag area as (t / tf)^2, CD0 0.775, n 8: X1 = 4/9 (1.5 A)^(2/3)",
                     [=] { return fly(thrownC9(materials)).highest; }});
}

} // namespace

std::vector<Case> canopyCases()
{
    std::vector<Case> cases;
    addCups(cases);

    const auto taylor = shared([] { return fly(underEvenPressure()); });
    const std::string even = "flat canopy under uniform pressure, parallel lines, ";
    const std::string mylar = "G. I. Taylor, R&M 862; mylar balloon";
    cases.push_back({"T-M4", even + "width over D0", 0.762760, relative(0.03), "", mylar,
                     [taylor] { return taylor().width; }});
    cases.push_back({"T-M4", even + "height over D0", 0.456947 / 2.0, relative(0.03), "", mylar,
                     [taylor] { return taylor().height; }});
    cases.push_back({"T-M4", even + "volume over D0^3", 0.609262 / 8.0, relative(0.03), "", mylar,
                     [taylor] { return taylor().volume; }});

    addOpenings(cases, "C-9 without hoop, ", {}, {20.0, 60.0});
    addOpenings(cases, "C-9 of nylon, ", nylonOfC9(), {20.0});
    const auto tight = shared([] { return sinkRate(0.0); });
    const auto nylon = shared([] { return sinkRate(0.03); });
    cases.push_back({"T-C7", "sink rate of nylon of porosity 0.03 over that of tight cloth", 1.0,
                     atLeast, "", "porous cloth has less drag", [=] { return nylon() / tight(); }});
    cases.push_back({"T-C7", "sink rate at porosity 0.1 over that at 0.03", 1.0, atLeast, "",
                     "porous cloth has less drag", [=] { return sinkRate(0.1) / nylon(); }});
    return cases;
}

} // namespace ripstop
