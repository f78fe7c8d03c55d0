// Most functions go once over the particles, links or panels that a probe names.
//
// Torn links and panels that are gone are left out of strains, lengths and areas. reaction() marks
// the pinned particles of the probe first, then adds up what acts on them: their weight, the
// tension of links with one marked end (of one with two it cancels itself), the pull of elastic
// panels and of what bends, and a third of the air load of a panel for each marked corner. What
// holds them is the opposite of that.
#include "measure/motion.h"

#include "forces/bend_force.h"
#include "system/membrane.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<double> strainsOf(const ProbeSpec& probe, Readings& readings)
{
    std::vector<double> strains;
    for (const int link : probe.links)
        if (!isTorn(readings.system().links[std::size_t(link)], readings.state()))
            strains.push_back(readings.strain()[std::size_t(link)]);
    return strains;
}

Vec3 along(const LinkPlace& link, const State& state)
{
    return state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)];
}

} // namespace

Vec3 meanOf(const ProbeSpec& probe, const System& system, const std::vector<PaddedVec3>& values)
{
    if (probe.particles.empty())
        return Vec3::Constant(nothing);
    Vec3 weighted = Vec3::Zero();
    Vec3 plain = Vec3::Zero();
    double mass = 0.0;
    for (const int particle : probe.particles) {
        const auto i = std::size_t(particle);
        weighted += system.mass[i] * values[i];
        plain += values[i];
        mass += system.mass[i];
    }
    return mass > 0.0 ? Vec3(weighted / mass) : Vec3(plain / double(probe.particles.size()));
}

Vec3 acceleration(const ProbeSpec& probe, Readings& readings)
{
    if (!readings.before())
        return Vec3::Constant(nothing);
    const System& system = readings.system();
    return (meanOf(probe, system, readings.state().velocity)
            - meanOf(probe, system, readings.before()->velocity))
           / system.timeStep;
}

Vec3 momentumOf(const ProbeSpec& probe, Readings& readings)
{
    const System& system = readings.system();
    Vec3 sum = Vec3::Zero();
    for (const int particle : probe.particles)
        if (const auto i = std::size_t(particle); system.inverseMass[i] > 0.0)
            sum += system.mass[i] * readings.state().velocity[i];
    return sum;
}

Vec3 reaction(const ProbeSpec& probe, Readings& readings)
{
    const System& system = readings.system();
    const State& state = readings.state();
    std::vector<std::uint8_t> held(system.mass.size(), 0);
    Vec3 load = Vec3::Zero();
    for (const int particle : probe.particles)
        if (const auto i = std::size_t(particle); system.inverseMass[i] == 0.0) {
            held[i] = 1;
            load += system.mass[i] * system.gravity;
        }
    for (std::size_t l = 0; l < system.links.size(); ++l) {
        const LinkPlace& link = system.links[l];
        const int ends = held[std::size_t(link.a)] - held[std::size_t(link.b)];
        if (ends != 0) // a link between two held particles pulls at both
            load += ends * readings.tension()[l] * along(link, state).normalized();
    }
    for (std::size_t p = 0; p < system.panels.size(); ++p)
        for (const int corner : system.panels[p].corner)
            if (held[std::size_t(corner)])
                load += readings.panelLoad()[p] / 3.0;
    const auto isHeld = [&](int particle) { return held[std::size_t(particle)] != 0; };
    for (const Membrane& membrane : system.membranes) {
        const auto& corner = system.panels[std::size_t(membrane.panel)].corner;
        if (state.panelGone[std::size_t(membrane.panel)] || std::ranges::none_of(corner, isHeld))
            continue;
        const Corners pulls =
            pullsOnCorners(system, membrane, cornersOf(system, membrane, state.position));
        for (std::size_t i = 0; i < 3; ++i)
            if (isHeld(corner[i]))
                load += pulls[i];
    }
    if (!system.of<BendLists>().list.empty()) {
        const std::vector<Vec3> pulls = pullsOfBends(system, state);
        for (std::size_t p = 0; p < pulls.size(); ++p)
            if (held[p])
                load += pulls[p];
    }
    return -load;
}

double meanStrain(const ProbeSpec& probe, Readings& readings)
{
    const std::vector<double> strains = strainsOf(probe, readings);
    double sum = 0.0;
    for (const double strain : strains)
        sum += strain;
    return strains.empty() ? nothing : sum / double(strains.size());
}

double highStrain(const ProbeSpec& probe, Readings& readings)
{
    constexpr double share = 0.95;
    std::vector<double> strains = strainsOf(probe, readings);
    if (strains.empty())
        return nothing;
    const auto rank = std::size_t(std::ceil(share * double(strains.size()))) - 1;
    std::ranges::nth_element(strains, strains.begin() + std::ptrdiff_t(rank));
    return strains[rank];
}

double lengthOf(const ProbeSpec& probe, Readings& readings)
{
    double sum = 0.0;
    for (const int l : probe.links)
        if (const LinkPlace& link = readings.system().links[std::size_t(l)];
            !isTorn(link, readings.state()))
            sum += along(link, readings.state()).norm();
    return sum;
}

double areaOf(const ProbeSpec& probe, Readings& readings)
{
    const State& state = readings.state();
    double sum = 0.0;
    for (const int p : probe.panels) {
        if (state.panelGone[std::size_t(p)])
            continue;
        const auto& [a, b, c] = readings.system().panels[std::size_t(p)].corner;
        const Vec3& corner = state.position[std::size_t(a)];
        sum += 0.5
               * Vec3(state.position[std::size_t(b)] - corner)
                     .cross(Vec3(state.position[std::size_t(c)] - corner))
                     .norm();
    }
    return sum;
}

} // namespace ripstop
