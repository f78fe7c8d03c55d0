// The undamped oscillator, k/m = (2 pi)^2, against theory.
//
// Of the schemes on the list the engine offers explicit Euler (I1), semi-implicit Euler (I3),
// Verlet (I4), Verlet with a naive start (I5), velocity Verlet (I6) and Runge and Kutta's of fourth
// order (I7); and, where the spring is a rod with a compliance that the direct solver holds, which
// makes it implicit, Euler's (I2) and BDF2. Implicit midpoint is not offered, so it has no row.
//
// In order: energies after many steps, from the recurrences of the schemes; bands in which the
// energy stays; quantities that a scheme keeps exactly; period, order and stability limit; and
// places: a particle at rest stays there, and a system moved by a kilometre moves alike.
#include "assembly/finish.h"
#include "builders/network.h"
#include "compile/compile.h"
#include "simulation/simulation.h"
#include "verify/oscillator.h"

#include <algorithm>
#include <array>
#include <complex>

namespace ripstop {
namespace {

double energy(const OscillatorTrace& motion, std::size_t i)
{
    return 0.5 * motion.v[i] * motion.v[i] + 0.5 * omega * omega * motion.x[i] * motion.x[i];
}

const char* idOf(Scheme scheme)
{
    constexpr std::array ids{"T-I1", "T-I3", "T-I4", "T-I5", "T-I6", "T-I7"};
    return ids[std::size_t(scheme)];
}

// E / E0 after 1000 steps with cos(theta) = 1 - h^2/2, h = omega dt, from the recurrences.
double energyRatioOf(Scheme scheme)
{
    const double h = omega * 0.01;
    const double theta = 2.0 * std::asin(h / 2.0);
    const double n = 1000.0;
    double x = 0.0;
    double v = 0.0; // over omega
    switch (scheme) {
    case Scheme::ExplicitEuler:
        x = std::pow(1.0 + h * h, n / 2.0); // all of the amplitude; phase does not matter
        break;
    case Scheme::SemiImplicitEuler: // x(1) = 1 - h^2, v(n) = (x(n) - x(n-1)) / dt
        x = std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
        v = (x - std::cos((n - 0.5) * theta) / std::cos(0.5 * theta)) / h;
        break;
    case Scheme::RungeKutta4: // each step by the series of exp(i h) up to h^4
        return std::pow(1.0 - std::pow(h, 6.0) / 72.0 + std::pow(h, 8.0) / 576.0, n);
    case Scheme::Verlet:
    case Scheme::VelocityVerlet:
        x = std::cos(n * theta);
        v = -std::sin(n * theta) * std::sin(theta) / h;
        break;
    case Scheme::NaiveVerlet:
        x = std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
        v = -std::sin((n + 0.5) * theta) / std::cos(0.5 * theta) * std::sin(theta) / h;
        break;
    }
    return x * x + v * v;
}

// Norm of the error in (x, v / omega) at t = 1.1 s, where x is far from zero.
double orderOf(Scheme scheme, bool reported)
{
    const auto error = [&](int perSecond) {
        const int steps = perSecond * 11 / 10;
        const System system = oscillator(scheme, 1.0 / perSecond);
        const OscillatorTrace motion = follow(system, steps);
        const double v = reported ? run(system, steps).velocity[1].x() : motion.v.back();
        return std::hypot(motion.x.back() - std::cos(omega * 1.1),
                          v / omega + std::sin(omega * 1.1));
    };
    return std::log2(error(400) / error(800));
}

void addEnergies(std::vector<Case>& cases)
{
    // as published, and what the recurrences give with all digits
    constexpr double published[] = {51.4222, 0.99935,      0.9999998945,
                                    1.00099, 0.9999998945, 0.9999991459};
    constexpr double digits[] = {0.5e-4, 0.5e-5, 0.5e-9, 0.5e-5, 0.5e-9, 0.5e-9};
    constexpr double orders[] = {1.02, 1.007, 2.0, 1.005, 2.0, 4.0};
    for (const Scheme scheme : allSchemes) {
        const std::size_t i = std::size_t(scheme);
        const auto ratio = shared([=] {
            const OscillatorTrace motion = follow(oscillator(scheme, 0.01), 1000);
            return energy(motion, 1000) / energy(motion, 0);
        });
        cases.push_back({idOf(scheme), "energy after ten periods of 100 steps, " + nameOf(scheme),
                         energyRatioOf(scheme), relative(1e-6), "", "closed form of the recurrence",
                         [=] { return ratio(); }});
        cases.push_back({idOf(scheme), "the same beside another program's, " + nameOf(scheme),
                         published[i], within(digits[i]), "",
                         "independent small program, double precision", [=] { return ratio(); }});
        cases.push_back({idOf(scheme), "order of the error at 1.1 s, " + nameOf(scheme), orders[i],
                         within(0.1), "", "order of the scheme",
                         [=] { return orderOf(scheme, false); }});
        cases.push_back(
            {idOf(scheme), "order with the velocity that is reported, " + nameOf(scheme), orders[i],
             within(0.1), "", "order of the scheme", [=] { return orderOf(scheme, true); }});
    }
}

// 1000 periods: the energy swings in a band and does not leave it.
void addBands(std::vector<Case>& cases)
{
    struct Band
    {
        Scheme scheme;
        double low, high, digit;
    };
    for (const Band& band : {Band{Scheme::SemiImplicitEuler, 0.9695, 1.0324, 0.5e-4},
                             Band{Scheme::VelocityVerlet, 0.999013, 1.0, 0.5e-6}}) {
        const auto range = shared([scheme = band.scheme] {
            const OscillatorTrace motion = follow(oscillator(scheme, 0.01), 100000);
            std::array<double, 2> held{1.0, 0.0};
            for (std::size_t i = 0; i < motion.x.size(); ++i) {
                held[0] = std::min(held[0], energy(motion, i) / energy(motion, 0));
                held[1] = std::max(held[1], energy(motion, i) / energy(motion, 0));
            }
            return held;
        });
        const std::string by = " energy in 1000 periods, " + nameOf(band.scheme);
        const std::string source =
            band.scheme == Scheme::VelocityVerlet ? "1 - h^2/4 to 1" : "1 -+ h/2";
        cases.push_back({idOf(band.scheme), "lowest" + by, band.low, within(band.digit), "", source,
                         [=] { return range()[0]; }});
        cases.push_back({idOf(band.scheme), "highest" + by, band.high, within(band.digit), "",
                         source, [=] { return range()[1]; }});
    }
}

// The quantity that the recurrence of the scheme keeps exactly.
double invariantOf(Scheme scheme, const OscillatorTrace& motion, std::size_t i)
{
    const double h = omega * 0.01;
    const double x = motion.x[i];
    const double v = motion.v[i];
    if (scheme == Scheme::SemiImplicitEuler)
        return v * v + omega * omega * x * x - omega * omega * 0.01 * x * v;
    if (scheme == Scheme::VelocityVerlet)
        return v * v + omega * omega * x * x * (1.0 - h * h / 4.0);
    const double y = motion.x[i + 1];
    return x * x + y * y - 2.0 * (1.0 - h * h / 2.0) * x * y;
}

// T = 2 pi dt / theta; the angle of one step from x(n+1) + x(n-1) = 2 cos(theta) x(n), by least
// squares over ten periods.
double periodOf(Scheme scheme)
{
    const OscillatorTrace motion = follow(oscillator(scheme, 0.01), 1002);
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 1; i <= 1000; ++i) {
        // difference form: 1 - cos(theta) would lose its digits in x + x
        products += motion.x[i] * (2.0 * motion.x[i] - motion.x[i + 1] - motion.x[i - 1]);
        squares += motion.x[i] * motion.x[i];
    }
    return omega * 0.01 / (2.0 * std::asin(0.5 * std::sqrt(products / squares)));
}

double largestOf(Scheme scheme, double h)
{
    double most = 0.0;
    for (const double x : follow(oscillator(scheme, h / omega), 2000).x)
        most = std::max(most, std::abs(x));
    return most;
}

void addInvariants(std::vector<Case>& cases)
{
    const std::string rk4 = nameOf(Scheme::RungeKutta4);
    cases.push_back({"T-I9", "largest amplitude at h = 2.82, " + rk4, 1.1, atMost, "m",
                     "stable below h = 2.8284",
                     [] { return largestOf(Scheme::RungeKutta4, 2.82); }});
    cases.push_back({"T-I9", "largest amplitude at h = 2.84, " + rk4, 1e3, atLeast, "m",
                     "unstable above h = 2.8284",
                     [] { return largestOf(Scheme::RungeKutta4, 2.84); }});
    for (const Scheme scheme :
         {Scheme::SemiImplicitEuler, Scheme::Verlet, Scheme::VelocityVerlet}) {
        cases.push_back({idOf(scheme), "invariant of the recurrence, change, " + nameOf(scheme),
                         0.0, within(scheme == Scheme::Verlet ? 1e-10 : 1e-12), "",
                         "kept exactly; Verlet's is a difference of near numbers", [=] {
                             const OscillatorTrace motion = follow(oscillator(scheme, 0.01), 1000);
                             double most = 0.0;
                             for (std::size_t i = 1; i < 1000; ++i)
                                 most = std::max(most, std::abs(invariantOf(scheme, motion, i)
                                                                    / invariantOf(scheme, motion, 0)
                                                                - 1.0));
                             return most;
                         }});
        cases.push_back({idOf(scheme), "period with 100 steps, " + nameOf(scheme), 0.9998354606,
                         within(1e-9), "s", "2 pi dt / (2 asin(h/2))",
                         [=] { return periodOf(scheme); }});
        cases.push_back({"T-I9", "largest amplitude at h = 1.99, " + nameOf(scheme), 10.1, atMost,
                         "m", "1 / sqrt(1 - h^2/4) = 10.01",
                         [=] { return largestOf(scheme, 1.99); }});
        cases.push_back({"T-I9", "largest amplitude at h = 2.01, " + nameOf(scheme), 1e100, atLeast,
                         "m", "unstable above h = 2", [=] { return largestOf(scheme, 2.01); }});
    }
}

// --- implicit: the spring is a rod ------------------------------------------------------------

// The particle of 1 kg on a rod of 1 m whose compliance makes it swing at omega, along the rod.
System rodOscillator(Integrator integrator, double timeStep)
{
    System system = emptySystem(timeStep, integrator);
    system.solver = Solver::Direct;
    addPin(system, Vec3::Zero());
    addParticle(system, Vec3(1.1, 0.0, 0.0), 1.0);
    addRod(system, 0, 1, 1.0).compliance = 1.0 / (omega * omega);
    finish(system);
    return system;
}

double energyOfRod(const State& state)
{
    const double x = state.position[1].x() - 1.0;
    const double v = state.velocity[1].x();
    return 0.5 * v * v + 0.5 * omega * omega * x * x;
}

// |z|^2 for a step of z' = i h z: (3 - 2 i h) z^2 - 4 z + 1 = 0 of BDF2, of its larger root.
double bdf2Keeps(double h)
{
    const std::complex<double> i(0.0, 1.0);
    return std::norm((2.0 + std::sqrt(1.0 + 2.0 * i * h)) / (3.0 - 2.0 * i * h));
}

// E after so many steps over E after others, which the smaller root has died away in.
double keptByRod(Integrator integrator, double timeStep, int from, int to)
{
    const System system = rodOscillator(integrator, timeStep);
    return energyOfRod(run(system, to)) / energyOfRod(run(system, from));
}

double orderOfRod(Integrator integrator)
{
    const auto error = [&](int perSecond) {
        const System system = rodOscillator(integrator, 1.0 / perSecond);
        const State end = run(system, perSecond * 11 / 10);
        return std::hypot(end.position[1].x() - 1.0 - 0.1 * std::cos(omega * 1.1),
                          end.velocity[1].x() / omega + 0.1 * std::sin(omega * 1.1));
    };
    return std::log2(error(400) / error(800));
}

// x and v of the spring of a scene that names implicit Euler, which its compile makes a rod of.
std::array<double, 2> endOfSpring(double timeStep, int steps)
{
    Scene scene;
    scene.settings.integrator = Integrator::ImplicitEuler;
    scene.settings.timeStep = timeStep;
    scene.settings.substeps = 1;
    scene.settings.gravity = Vec3::Zero();
    scene.settings.airDensity = 0.0;
    Network network(scene, "oscillator");
    const Id pin = network.particle(Vec3::Zero(), 1.0);
    network.row(pin).pinned = true;
    const Id mass = network.particle({1.1, 0.0, 0.0}, 1.0);
    network.spring(pin, mass, noId);
    network.setRestLength(1.0);
    const Id part = network.finish({}, {});
    std::get<Part>(*findItem(scene, part)).links[0].stiffness = omega * omega;
    Simulation simulation(*compile(scene));
    for (int step = 0; step < steps; ++step)
        (void)simulation.step();
    const State& end = simulation.state();
    return {end.position[1].x() - 1.0, end.velocity[1].x()};
}

double keptBySpring(int steps)
{
    const auto [x, v] = endOfSpring(0.01, steps);
    return (x * x + v * v / (omega * omega)) / 0.01;
}

double orderOfSpring()
{
    const auto error = [](int perSecond) {
        const auto [x, v] = endOfSpring(1.0 / perSecond, perSecond * 11 / 10);
        return std::hypot(x - 0.1 * std::cos(omega * 1.1), v / omega + 0.1 * std::sin(omega * 1.1));
    };
    return std::log2(error(400) / error(800));
}

void addImplicit(std::vector<Case>& cases)
{
    const double h = omega * 0.01;
    cases.push_back({"T-I2", "energy after ten periods of 100 steps, implicit_euler by name",
                     0.0194469, relative(1e-4), "", "(1 + h^2)^-1000; steps 0 to 1000",
                     [] { return keptBySpring(1000); }});
    cases.push_back({"T-I2", "order of the error at 1.1 s, implicit_euler by name", 0.98,
                     within(0.1), "", "order of the scheme", orderOfSpring});
    cases.push_back({"T-I2", "energy after ten periods of 100 steps, implicit Euler", 0.0194469,
                     relative(1e-4), "", "(1 + h^2)^-1000; steps 0 to 1000",
                     [=] { return keptByRod(Integrator::SemiImplicitEuler, 0.01, 0, 1000); }});
    cases.push_back({"T-I2", "order of the error at 1.1 s, implicit Euler", 0.98, within(0.1), "",
                     "order of the scheme",
                     [] { return orderOfRod(Integrator::SemiImplicitEuler); }});
    cases.push_back({"T-I2", "energy that nine periods of 100 steps leave, bdf2",
                     std::pow(bdf2Keeps(h), 900.0), relative(1e-6), "",
                     "Curtiss and Hirschfelder 1952: root of (3 - 2 i h) z^2 - 4 z + 1",
                     [] { return keptByRod(Integrator::Bdf2, 0.01, 100, 1000); }});
    cases.push_back({"T-I2", "order of the error at 1.1 s, bdf2", 2.0, within(0.1), "",
                     "order of the scheme", [] { return orderOfRod(Integrator::Bdf2); }});
    cases.push_back({"T-I2", "energy after 20 steps at h = 100, bdf2", 1e-12, atMost, "",
                     "stable and damping at any step",
                     [=] { return keptByRod(Integrator::Bdf2, 100.0 / omega, 0, 20); }});
}

// The second paper's recurrence 2 (x - previous) + a dt^2 would give 0, -2, -4, -4, 0, 8, ...
double restlessness(Scheme scheme)
{
    System system = emptySystem(0.01, integratorOf(scheme));
    addParticle(system, {1.0, 1.0, 1.0}, 1.0);
    finish(system);
    if (scheme == Scheme::NaiveVerlet)
        system.start.driftSubstep = system.timeStep / system.substeps;
    return (run(system, 8).position[0] - Vec3(1.0, 1.0, 1.0)).norm();
}

void addPlaces(std::vector<Case>& cases)
{
    for (const Scheme scheme : allSchemes) {
        cases.push_back({"T-I8", "rest at x = 1 stays at rest, way, " + nameOf(scheme), 0.0,
                         exactly, "m", "Verlet 1967, not figure 5 of the paper",
                         [=] { return restlessness(scheme); }});
        cases.push_back({"T-I10", "moved by a kilometre, difference, " + nameOf(scheme), 0.0,
                         within(1e-7), "m", "invariance; 1000 steps", [=] {
                             const Vec3 far(1e3, -1e3, 1e3);
                             const State here = run(oscillator(scheme, 0.01), 1000);
                             const State there =
                                 run(oscillator(scheme, 0.01, omega, 0.0, far), 1000);
                             return (there.position[1] - far - here.position[1]).norm();
                         }});
    }
}

} // namespace

std::vector<Case> integratorCases()
{
    std::vector<Case> cases;
    addEnergies(cases);
    addBands(cases);
    addInvariants(cases);
    addPlaces(cases);
    addImplicit(cases);
    return cases;
}

} // namespace ripstop
