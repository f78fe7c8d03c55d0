// Steady flight: what plates do in theory, and whether flying designs balance their forces.
//
// First plates by themselves, whose polars and glides follow from the law of the air; then a kite,
// a glider and a parachute of the builders in trim, whose forces must balance.
#include "assembly/finish.h"
#include "base/angle.h"
#include "builders/builder.h"
#include "compile/compile.h"
#include "forces/panel_load.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace ripstop {
namespace {

// --- plates --------------------------------------------------------------------------------------

// Lift and drag on 1 m^2 in a wind of 1 m/s at this angle of attack, over the dynamic pressure.
struct Polar
{
    double lift;
    double drag;
};

Polar polarOf(const MaterialAir& panel, double angle)
{
    const double leg = std::sqrt(2.0);
    const Vec3 wind(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 load =
        panelLoad(panel, Vec3::Zero(), Vec3(0.0, 0.0, leg), Vec3(leg, 0.0, 0.0), wind, airDensity)
        / (0.5 * airDensity);
    return {load.dot(Vec3(-wind.y(), wind.x(), 0.0)), load.dot(wind)};
}

// The sink rate, m/s, at which a level plate ends that was thrown level at this speed, m/s.
struct Glide
{
    double sink;
    double speed; // level
};

Glide glideOf(AirLaw law, double coefficient, double mass, double area, double speed)
{
    System system = heavySystem(1.0 / 1000.0);
    const double leg = std::sqrt(2.0 * area);
    for (const Vec3& corner : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, leg), Vec3(leg, 0.0, 0.0)})
        addParticle(system, corner, mass / 3.0, {speed, 0.0, 0.0});
    addPanel(system, 0, 1, 2, law, coefficient);
    finish(system);
    const State state = run(system, 10000);
    return {-state.velocity[0].y(), state.velocity[0].x()};
}

// Linear normal law with skin friction, C 3.1 and CD0 0.06, as the formula has it.
Polar lawPolar(double a)
{
    const double normal = 3.1 * std::sin(a);
    const double tangent = 0.06 * std::cos(a) * std::cos(a);
    return {normal * std::cos(a) - tangent * std::sin(a),
            normal * std::sin(a) + tangent * std::cos(a)};
}

// The least sink rate of 90 kg on 18 m^2 over all angles of attack, m/s.
template <typename PolarAt>
double leastSink(const PolarAt& polarAt)
{
    double least = 1e9;
    for (double angle = 1.0; angle < 60.0; angle += 0.01) {
        const Polar polar = polarAt(angle * degrees);
        const double size = std::hypot(polar.lift, polar.drag);
        const double speed = std::sqrt(2.0 * 90.0 * standardGravity / (airDensity * 18.0 * size));
        least = std::min(least, speed * polar.drag / size);
    }
    return least;
}

void addPlates(std::vector<Case>& cases)
{
    for (const double angle : {10.0, 20.0, 30.0})
        cases.push_back(
            {"T-F1",
             "normal force only, L/D of a plate at " + std::to_string(int(angle)) + " degrees",
             1.0 / std::tan(angle * degrees), relative(1e-12), "",
             "cot(alpha): the line stands at 90 - alpha", [=] {
                 const Polar polar = polarOf(airOf(AirLaw::LinearNormal, 2.0), angle * degrees);
                 return polar.lift / polar.drag;
             }});
    const struct
    {
        double coefficient, speed, sink;
    } glides[] = {{4.0, 10.0, 4.95}, {4.0, 30.0, 4.95}, {2.0, 10.0, 7.01}, {1.17, 10.0, 9.16}};
    for (const auto& glide : glides) {
        char title[80];
        std::snprintf(title, sizeof title,
                      "paper's law, level plate of 92 kg, 15 m2, C %g, at %g m/s",
                      glide.coefficient, glide.speed);
        cases.push_back(
            {"T-F3", title + std::string(", sink"), glide.sink, within(0.005), "m/s",
             "sqrt(2 W / (rho C S)) at any speed", [=] {
                 return glideOf(AirLaw::Paper, glide.coefficient, 92.0, 15.0, glide.speed).sink;
             }});
    }
    for (const double speed : {8.0, 12.0, 20.0}) {
        const double k = 2.0 * 90.0 * standardGravity / (airDensity * 3.1 * 18.0);
        const double v2 = speed * speed;
        cases.push_back({"T-F4",
                         "linear-normal law, level plate of 90 kg, 18 m2, C 3.1, at "
                             + std::to_string(int(speed)) + " m/s, sink",
                         std::sqrt(0.5 * (std::sqrt(v2 * v2 + 4.0 * k * k) - v2)), relative(1e-6),
                         "m/s", "2 W / (rho C S V)", [=] {
                             return glideOf(AirLaw::LinearNormal, 3.1, 90.0, 18.0, speed).sink;
                         }});
    }
    const MaterialAir sail = airOf(AirLaw::LinearNormal, 3.1, 0.06);
    cases.push_back({"T-F4", "first Rogallos, C 3.1, CD0 0.06, best L/D", 3.54, within(0.005), "",
                     "closed form; 3.5 measured", [=] {
                         double best = 0.0;
                         for (double angle = 1.0; angle < 45.0; angle += 0.01) {
                             const Polar polar = polarOf(sail, angle * degrees);
                             best = std::max(best, polar.lift / polar.drag);
                         }
                         return best;
                     }});
    cases.push_back({"T-F4", "first Rogallos, 90 kg, 18 m2, least sink", leastSink(lawPolar),
                     relative(1e-6), "m/s", "CN = C sin, CT = CD0 cos^2 in closed form",
                     [=] { return leastSink([&](double a) { return polarOf(sail, a); }); }});
}

// --- designs that fly ----------------------------------------------------------------------------

// Of ideal cloth and rods, as in the papers.
Simulation flying(const char* builder)
{
    const Result<Scene> scene = build(*findBuilder(builder), {{"cloth", 0.0}});
    return Simulation(*compile(*scene));
}

Vec3 airForce(const System& system, const State& state)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& load : panelLoads(system, state))
        sum += load;
    for (const Vec3& drag : lineDrags(system, state))
        sum += drag;
    return sum;
}

struct Kite
{
    double angle = 0.0;   // rad, of the line at the kite
    double tension = 0.0; // N, there
    double wantedAngle = 0.0;
    double wantedTension = 0.0;
};

// Means over a second after 20 s. The line is what resists tension only; its upper end, the tow
// point, belongs to the kite.
Kite kiteInTrim()
{
    Simulation simulation = flying("delta_kite");
    const System& system = simulation.system();
    const auto first =
        std::find_if(system.links.begin(), system.links.end(), [&](const auto& link) {
            return system.rods[std::size_t(link.index)].resists == Resists::Tension;
        });
    std::vector<std::uint8_t> ofLine(system.mass.size(), 0);
    for (const Rod& rod : system.rods)
        if (rod.resists == Resists::Tension)
            ofLine[std::size_t(rod.a)] = ofLine[std::size_t(rod.b)] = 1;
    const std::size_t tow = std::size_t(first->a);
    ofLine[tow] = 0;
    double weight = 0.0;
    for (std::size_t i = 0; i < system.mass.size(); ++i)
        if (!ofLine[i] && system.inverseMass[i] > 0.0)
            weight += system.mass[i] * standardGravity;
    simulation.runUntil(20.0);
    Vec3 air = Vec3::Zero();
    Vec3 along = Vec3::Zero();
    Kite kite;
    const int steps = 240;
    for (int i = 0; i < steps && simulation.step(); ++i) {
        const State& state = simulation.state();
        for (const Vec3& load : panelLoads(system, state))
            air += load / steps;
        const std::vector<Vec3> drags = lineDrags(system, state);
        for (std::size_t l = 0; l < drags.size();
             ++l) // half of the first segment hangs on the kite
            for (const int end :
                 {system.of<LineLists>().list[l].a, system.of<LineLists>().list[l].b})
                if (std::size_t(end) == tow)
                    air += 0.5 * drags[l] / steps;
        along += (state.position[tow] - state.position[std::size_t(first->b)]) / steps;
        kite.tension += tensions(system, state)[std::size_t(first - system.links.begin())] / steps;
    }
    kite.angle = std::atan2(along.y(), along.x());
    kite.wantedAngle = std::atan2(air.y() - weight, air.x());
    kite.wantedTension = std::hypot(air.y() - weight, air.x());
    return kite;
}

struct Glider
{
    double support = 0.0; // 1, air force less what accelerates, over the weight
    double lean = 0.0;    // 1, the horizontal rest of it, over the weight
    double path = 0.0;    // 1, way over height lost
    double loads = 0.0;   // 1, lift over drag
};

// Means over the flight from 15 to 20 s.
Glider gliderInTrim()
{
    Simulation simulation = flying("hang_glider");
    const System& system = simulation.system();
    simulation.runUntil(15.0);
    const State from = simulation.state();
    Vec3 air = Vec3::Zero();
    int steps = 0;
    while (simulation.state().time < 20.0 && simulation.step()) {
        air += airForce(system, simulation.state());
        ++steps;
    }
    air /= steps;
    const State& to = simulation.state();
    const Vec3 gained = (momentum(system, to) - momentum(system, from)) / (to.time - from.time);
    const Vec3 way = centerOfMass(system, to.position) - centerOfMass(system, from.position);
    const double weight = totalMass(system) * standardGravity;
    const Vec3 forward = way.normalized();
    const double drag = -air.dot(forward);
    Glider glider;
    glider.support = (air - gained).y() / weight;
    glider.lean = std::hypot((air - gained).x(), (air - gained).z()) / weight;
    glider.path = -std::hypot(way.x(), way.z()) / way.y();
    glider.loads = (air + drag * forward).norm() / drag;
    return glider;
}

struct HungCanopy
{
    double rate = 0.0; // m/s
    double drag = 0.0; // 1, air force over weight
};

HungCanopy canopyInTrim() // means from 15 to 20 s
{
    Simulation simulation = flying("parachute");
    const System& system = simulation.system();
    simulation.runUntil(15.0);
    const State from = simulation.state();
    double air = 0.0;
    int steps = 0;
    while (simulation.state().time < 20.0 && simulation.step()) {
        air += airForce(system, simulation.state()).y();
        ++steps;
    }
    const State& to = simulation.state();
    const double way =
        (centerOfMass(system, to.position) - centerOfMass(system, from.position)).y();
    return {-way / (to.time - from.time), air / steps / (totalMass(system) * standardGravity)};
}

void addDesigns(std::vector<Case>& cases)
{
    const auto kite = shared(kiteInTrim);
    cases.push_back({"T-F1",
                     "delta kite in trim, angle of the line at the kite, over that of the loads",
                     1.0, within(0.01), "", "tan(beta) = (L - W) / D",
                     [=] { return kite().angle / kite().wantedAngle; }});
    cases.push_back({"T-F1", "delta kite in trim, tension at the kite, over that of the loads", 1.0,
                     within(0.01), "", "T^2 = (L - W)^2 + D^2",
                     [=] { return kite().tension / kite().wantedTension; }});
    const auto glider = shared(gliderInTrim);
    cases.push_back({"T-F2", "hang glider, air force less what accelerates, over the weight", 1.0,
                     within(1e-3), "", "Newton", [=] { return glider().support; }});
    cases.push_back({"T-F2", "hang glider, horizontal rest of it, over the weight", 0.0,
                     within(1e-3), "", "Newton", [=] { return glider().lean; }});
    cases.push_back({"T-F2", "hang glider, way over height lost, over L/D of the loads", 1.0,
                     within(0.02), "", "L/D = 1 / tan(gamma)",
                     [=] { return glider().path / glider().loads; }});
    const auto canopy = shared(canopyInTrim);
    cases.push_back({"T-A8", "parachute in steady descent, air force over weight", 1.0,
                     within(0.01), "", "m g = D", [=] { return canopy().drag; }});
    // D0 5 m, CD0 0.775; what hangs on lines counts with its mass, 26.6 kg in all
    cases.push_back({"T-A8", "parachute, D0 5 m, descent over that of CD0 0.775", 1.0, within(0.03),
                     "", "sqrt(2 m g / (rho CD0 S0)), Knacke 1991", [=] {
                         const double mass = totalMass(flying("parachute").system());
                         const double area = 25.0 * std::numbers::pi / 4.0;
                         return canopy().rate
                                / std::sqrt(2.0 * mass * standardGravity
                                            / (airDensity * 0.775 * area));
                     }});
}

} // namespace

std::vector<Case> flightCases()
{
    std::vector<Case> cases;
    addPlates(cases);
    addDesigns(cases);
    return cases;
}

} // namespace ripstop
