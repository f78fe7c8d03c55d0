// The damped oscillator, the damper alone, and the longest time step of springs.
//
// In order: turning points of the damped oscillator and its step limits; a damper alone between two
// masses, which must keep momentum; and the longest stable step of a chain of springs, against the
// rule of the endless chain.
#include "assembly/finish.h"
#include "laws/step_limit.h"
#include "measure/diagnostics.h"
#include "verify/by_default.h"
#include "verify/oscillator.h"

#include <algorithm>

namespace ripstop {
namespace {

// Turning points of the oscillator with zeta = 0.1: where the velocity falls through zero.
struct Turns
{
    std::vector<double> time;   // s
    std::vector<double> height; // m
};

Turns turnsOf(std::optional<Scheme> scheme) // none is by default
{
    System system =
        oscillator(scheme.value_or(Scheme::SemiImplicitEuler), 1e-4, omega, 2.0 * 0.1 * omega);
    if (!scheme)
        solveByDefault(system);
    const double dt = system.timeStep;
    const OscillatorTrace motion = follow(system, int(std::lround(2.1 / dt)));
    Turns turns{{0.0}, {1.0}};
    for (std::size_t i = 1; i + 1 < motion.v.size(); ++i)
        if (motion.v[i] > 0.0 && motion.v[i + 1] <= 0.0) {
            const double part = motion.v[i] / (motion.v[i] - motion.v[i + 1]);
            turns.time.push_back((double(i) + part) * dt);
            turns.height.push_back(motion.x[i] + 0.5 * part * motion.v[i] * dt);
        }
    return turns;
}

void addDamped(std::vector<Case>& cases)
{
    for (const Scheme scheme : {Scheme::Verlet, Scheme::VelocityVerlet}) {
        const auto turns = shared([=] { return turnsOf(scheme); });
        const std::string by = ", zeta 0.1, " + nameOf(scheme);
        // the scheme's own period is off by h^2/24 = 1.6e-8 at this step
        cases.push_back({"T-S1", "damped period" + by, 1.00503782, relative(1e-6), "s",
                         "T / sqrt(1 - zeta^2)", [=] { return turns().time.at(1); }});
        cases.push_back({"T-S1", "amplitude over that of a period before" + by, 0.53180208,
                         within(1e-6), "", "exp(-delta)",
                         [=] { return turns().height.at(2) / turns().height.at(1); }});
        cases.push_back({"T-S1", "logarithmic decrement" + by, 0.63148388, within(2e-6), "",
                         "2 pi zeta / sqrt(1 - zeta^2)",
                         [=] { return std::log(turns().height.at(1) / turns().height.at(2)); }});
    }
    const auto turns = shared([] { return turnsOf(std::nullopt); });
    cases.push_back({"T-S1", "damped period, zeta 0.1, by default", 1.00503782, relative(0.01), "s",
                     "T / sqrt(1 - zeta^2)", [=] { return turns().time.at(1); }});
    cases.push_back({"T-S1", "logarithmic decrement, zeta 0.1, by default", 0.63148388,
                     relative(0.01), "", "2 pi zeta / sqrt(1 - zeta^2)",
                     [=] { return std::log(turns().height.at(1) / turns().height.at(2)); }});
}

// Bounded for 20 000 steps; 1 / sqrt(1 - h^2/4) is at most 70 where this is asked.
bool isStable(double damping, double dt)
{
    const System system = oscillator(Scheme::SemiImplicitEuler, dt, 10.0, damping);
    Stepper stepper;
    State state = system.start;
    for (int i = 0; i < 20000; ++i) {
        stepper.step(system, state);
        if (!(std::abs(state.position[1].x()) < 1e3))
            return false;
    }
    return true;
}

void addDampedLimits(std::vector<Case>& cases)
{
    for (const double c : {0.0, 1.0, 5.0, 20.0}) {
        const double limit = (-c + std::sqrt(c * c + 400.0)) / 100.0;
        char title[80];
        std::snprintf(title, sizeof title, "longest stable step of a spring, w 10 /s, c %g /s", c);
        cases.push_back({"T-S2", title, limit, relative(1e-3), "s",
                         "(-c + sqrt(c^2 + 4 w^2)) / w^2, semi-implicit Euler", [=] {
                             return limitOf([=](double dt) { return isStable(c, dt); }, 0.9 * limit,
                                            1.1 * limit);
                         }});
    }
}

// A damper of 0.4 N s/m between 2 kg and 0.5 kg, without spring, over one second.
struct Damped
{
    double speed; // m/s, relative
    double rise;  // 1, largest of the relative speed in a step
    double drift; // kg m/s, of momentum
};

Damped damperAlone(Scheme scheme)
{
    System system = emptySystem(1e-4, integratorOf(scheme));
    addParticle(system, Vec3::Zero(), 2.0, {0.3, 0.0, 0.0});
    addParticle(system, {10.0, 0.0, 0.0}, 0.5, {-1.0, 0.0, 0.0});
    addSpring(system, 0, 1, 10.0, 0.0, 0.4);
    finish(system);
    if (scheme == Scheme::NaiveVerlet) {
        system.start.driftSubstep = system.timeStep / system.substeps;
        system.start.drift = system.start.velocity;
    }
    Stepper stepper;
    State state = system.start;
    Damped damped{1.3, 0.0, 0.0};
    for (int i = 0; i < 10000; ++i) {
        stepper.step(system, state);
        const double relative = std::abs((state.velocity[1] - state.velocity[0]).x());
        damped.rise = std::max(damped.rise, relative / damped.speed - 1.0);
        damped.speed = relative;
    }
    damped.drift = (momentum(system, state) - Vec3(0.1, 0.0, 0.0)).norm();
    return damped;
}

void addDampers(std::vector<Case>& cases)
{
    const double rate = 0.4 * (1.0 / 2.0 + 1.0 / 0.5);
    for (const Scheme scheme : allSchemes) {
        const auto damped = shared([=] { return damperAlone(scheme); });
        // (1 - r dt)^n = exp(-r t) (1 - r^2 t dt / 2): 5e-5 for the schemes of first order
        cases.push_back({"T-S3", "damper alone, relative speed after 1 s, " + nameOf(scheme),
                         1.3 * std::exp(-rate), relative(1e-4), "m/s", "v exp(-nu t (1/ma + 1/mb))",
                         [=] { return damped().speed; }});
        cases.push_back(
            {"T-S3", "damper alone, largest rise of the relative speed, " + nameOf(scheme), 1e-15,
             atMost, "", "a damper takes energy only", [=] { return damped().rise; }});
        cases.push_back({"T-S3", "damper alone, change of momentum, " + nameOf(scheme), 0.0,
                         within(1e-12), "kg m/s", "action and reaction",
                         [=] { return damped().drift; }});
    }
}

// A line of springs between pins with the middle node off by a micrometre.
bool chainIsStable(int nodes, double mass, double stiffness, double spacing, double dt)
{
    System system = emptySystem(dt);
    for (int i = 0; i <= nodes; ++i) {
        const Vec3 place(spacing * i + (i == nodes / 2 ? 1e-6 : 0.0), 0.0, 0.0);
        if (i == 0 || i == nodes)
            addPin(system, place);
        else
            addParticle(system, place, mass);
        if (i > 0)
            addSpring(system, i - 1, i, spacing, stiffness);
    }
    finish(system);
    Stepper stepper;
    State state = system.start;
    for (int i = 0; i < 4000; ++i) {
        stepper.step(system, state);
        const double off = state.position[std::size_t(nodes / 2)].x() - spacing * (nodes / 2);
        if (!(std::abs(off) < 1e-3))
            return false;
    }
    return true;
}

// Dyneema of 4 mm: EA 614600 N, 9.10 g/m. Between pins the highest mode of N springs has
// w = 2 sqrt(k/m) cos(pi / 2N), a hair below that of the endless chain that the rule is for.
void addStepLimits(std::vector<Case>& cases)
{
    for (const double length : {10.0, 1.0, 0.1}) {
        const double mass = 9.10e-3 * length;
        const double stiffness = 614600.0 / length;
        const double endless = std::sqrt(mass / stiffness);
        char title[80];
        std::snprintf(title, sizeof title, "step limit of 4 mm Dyneema, segments of %g m, ",
                      length);
        cases.push_back({"2.4", title + std::string("rule"), endless, relative(1e-12), "s",
                         "sqrt(2 m / sum k) = 1.22e-4 s per m", [=] {
                             return springStepLimit(mass, 2.0 * stiffness, 0.0,
                                                    Integrator::SemiImplicitEuler);
                         }});
        cases.push_back(
            {"2.4", title + std::string("20 springs that run"),
             endless / std::cos(std::numbers::pi / 40.0), relative(1e-3), "s",
             "2 / w of the highest mode", [=] {
                 return limitOf(
                     [=](double dt) { return chainIsStable(20, mass, stiffness, length, dt); },
                     0.9 * endless, 1.1 * endless);
             }});
    }
}

} // namespace

std::vector<Case> dampingCases()
{
    std::vector<Case> cases;
    addDamped(cases);
    addDampedLimits(cases);
    addDampers(cases);
    addStepLimits(cases);
    return cases;
}

} // namespace ripstop
