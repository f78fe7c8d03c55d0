#include "measure/wing_forces.h"

#include "forces/wind.h"
#include "measure/motion.h"

#include <limits>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// With the corners of the panels and the ends of the links for particles where it has none.
ProbeSpec withParticles(const ProbeSpec& probe, const System& system)
{
    ProbeSpec whole = probe;
    if (!whole.particles.empty())
        return whole;
    for (const int panel : probe.panels)
        for (const int corner : system.panels[std::size_t(panel)].corner)
            whole.particles.push_back(corner);
    for (const int link : probe.links)
        for (const int end : {system.links[std::size_t(link)].a, system.links[std::size_t(link)].b})
            whole.particles.push_back(end);
    return whole;
}

} // namespace

Vec3 windOver(const ProbeSpec& probe, Readings& readings)
{
    const System& system = readings.system();
    const State& state = readings.state();
    const Vec3 place = meanOf(withParticles(probe, system), system, state.position);
    return place.allFinite() ? windAt(system, state, place) : place;
}

Vec3 relativeWind(const ProbeSpec& probe, Readings& readings)
{
    const System& system = readings.system();
    const ProbeSpec whole = withParticles(probe, system);
    return windOver(whole, readings) - meanOf(whole, system, readings.state().velocity);
}

LiftAndDrag liftAndDrag(const ProbeSpec& probe, Readings& readings)
{
    const Vec3 wind = relativeWind(probe, readings);
    if (!(wind.norm() > 0.0))
        return {nothing, nothing};
    const Vec3 along = wind.normalized();
    const Vec3 across = Vec3::UnitY() - along.y() * along; // of length 0 where the wind is vertical
    const Vec3 force = readings.airForceOf(probe);
    const double lift = across.norm() > 1e-9 ? force.dot(across.normalized()) : nothing;
    return {lift, force.dot(along)};
}

Vec3 centreOfPressure(const ProbeSpec& probe, Readings& readings)
{
    Vec3 force = Vec3::Zero();
    for (const int panel : probe.panels)
        force += readings.panelLoad()[std::size_t(panel)];
    Vec3 moment = Vec3::Zero();
    double sum = 0.0;
    for (const int panel : probe.panels) {
        const auto i = std::size_t(panel);
        const double share = readings.panelLoad()[i].dot(force);
        Vec3 middle = Vec3::Zero();
        for (const int corner : readings.system().panels[i].corner)
            middle += readings.state().position[std::size_t(corner)] / 3.0;
        moment += share * middle;
        sum += share;
    }
    return sum > 0.0 ? Vec3(moment / sum) : Vec3(Vec3::Constant(nothing));
}

} // namespace ripstop
