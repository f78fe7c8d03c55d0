#include "measure/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Mean over the particles of the probe, weighted by mass; the plain mean when nothing has mass.
Vec3 mean(const ProbeSpec& probe, const System& system, const std::vector<PaddedVec3>& values)
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

double ofLinks(const ProbeSpec& probe, const std::vector<double>& values)
{
    double largest = nothing;
    for (const int link : probe.links) {
        const double value = values[std::size_t(link)];
        if (std::isnan(largest) || value > largest)
            largest = value;
    }
    return largest;
}

double horizontal(const Vec3& v) { return std::hypot(v.x(), v.z()); }

double glideRatio(const Vec3& motion)
{
    return motion.y() < 0.0 ? horizontal(motion) / -motion.y() : nothing;
}

// Links that the mesh has parted at are whole again.
double tornCount(const ProbeSpec& probe, const System& system, const State& state)
{
    if (!state.splits.empty()) {
        std::set<Key> torn;
        for (const State::Tear& tear : state.tears)
            torn.insert(tear.link);
        return double(std::count_if(probe.links.begin(), probe.links.end(), [&](int l) {
            return torn.contains(system.links[std::size_t(l)].key);
        }));
    }
    return double(std::count_if(probe.links.begin(), probe.links.end(), [&](int l) {
        return isTorn(system.links[std::size_t(l)], state);
    }));
}

} // namespace

std::string_view unitOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::PositionX:
    case Quantity::PositionY:
    case Quantity::PositionZ:
    case Quantity::Distance:
        return "m";
    case Quantity::Speed:
    case Quantity::SinkRate:
        return "m/s";
    case Quantity::Tension:
    case Quantity::MaxTension:
    case Quantity::AirForce:
        return "N";
    case Quantity::Elevation:
        return "deg";
    case Quantity::KineticEnergy:
    case Quantity::PotentialEnergy:
    case Quantity::ElasticEnergy:
    case Quantity::TotalEnergy:
        return "J";
    case Quantity::CanopyPressure:
        return "Pa";
    case Quantity::CanopyVolume:
        return "m\u00b3";
    case Quantity::Strain:
    case Quantity::MaxStrain:
    case Quantity::GlideRatio:
    case Quantity::MeanGlideRatio:
    case Quantity::TornLinks:
        break;
    }
    return "";
}

const std::vector<double>& Readings::strain()
{
    if (!m_strain)
        m_strain = strains(m_system, m_state);
    return *m_strain;
}

const std::vector<double>& Readings::tension()
{
    if (!m_tension)
        m_tension = tensions(m_system, m_state);
    return *m_tension;
}

const std::vector<Vec3>& Readings::panelLoad()
{
    if (!m_panelLoad)
        m_panelLoad = panelLoads(m_system, m_state);
    return *m_panelLoad;
}

const Energies& Readings::energy()
{
    if (!m_energy)
        m_energy = energies(m_system, m_state);
    return *m_energy;
}

Vec3 Readings::lineDragOf(const ProbeSpec& probe)
{
    Vec3 sum = Vec3::Zero();
    if (m_system.dragLines.empty())
        return sum;
    if (!m_lineDrag)
        m_lineDrag = lineDrags(m_system, m_state);
    const std::vector<Vec3>& drag = *m_lineDrag;
    std::vector<std::uint8_t> wanted(m_system.links.size(), 0);
    for (const int link : probe.links)
        wanted[std::size_t(link)] = 1;
    for (std::size_t i = 0; i < drag.size(); ++i)
        if (wanted[std::size_t(m_system.dragLines[i].link)])
            sum += drag[i];
    return sum;
}

double Readings::value(const ProbeSpec& probe)
{
    const System& system = m_system;
    const State& state = m_state;
    const auto position = [&] { return mean(probe, system, state.position); };
    const auto velocity = [&] { return mean(probe, system, state.velocity); };
    const auto line = [&]() -> Vec3 {
        return probe.from < 0 ? Vec3(Vec3::Constant(nothing))
                              : Vec3(position() - state.position[std::size_t(probe.from)]);
    };

    switch (probe.quantity) {
    case Quantity::PositionX:
        return position().x();
    case Quantity::PositionY:
        return position().y();
    case Quantity::PositionZ:
        return position().z();
    case Quantity::Speed:
        return velocity().norm();
    case Quantity::SinkRate:
        return -velocity().y();
    case Quantity::Tension:
    case Quantity::MaxTension:
        return ofLinks(probe, tension());
    case Quantity::Strain:
    case Quantity::MaxStrain:
        return ofLinks(probe, strain());
    case Quantity::Distance:
        return line().norm();
    case Quantity::Elevation: {
        const Vec3 l = line();
        return std::atan2(l.y(), horizontal(l)) * 180.0 / std::numbers::pi;
    }
    case Quantity::GlideRatio:
        return glideRatio(velocity());
    case Quantity::MeanGlideRatio:
        return glideRatio(position() - mean(probe, system, system.start.position));
    case Quantity::AirForce: {
        Vec3 sum = Vec3::Zero();
        for (const int panel : probe.panels)
            sum += panelLoad()[std::size_t(panel)];
        return (sum + lineDragOf(probe)).norm();
    }
    case Quantity::KineticEnergy:
        return energy().kinetic;
    case Quantity::PotentialEnergy:
        return energy().potential;
    case Quantity::ElasticEnergy:
        return energy().elastic;
    case Quantity::TotalEnergy:
        return energy().total();
    case Quantity::TornLinks:
        return tornCount(probe, system, state);
    case Quantity::CanopyPressure:
    case Quantity::CanopyVolume: {
        // the volumes of all canopies add up; of their pressures it is the highest
        double reading = nothing;
        for (std::size_t i = 0; i < system.canopies.size(); ++i) {
            const int panel = system.canopies[i].facets.front().panel;
            if (std::find(probe.panels.begin(), probe.panels.end(), panel) == probe.panels.end())
                continue;
            const CanopyAir& air = state.canopies[i];
            const double before = std::isnan(reading) ? 0.0 : reading;
            reading = probe.quantity == Quantity::CanopyVolume ? before + air.volume
                                                               : std::max(before, air.pressure);
        }
        return reading;
    }
    }
    return nothing;
}

} // namespace ripstop
