// Reads the value of a probe.
//
// The first functions of Readings compute strains, tensions, loads and energies when they are first
// asked for, as several probes may share them. value() then goes by the quantity: simple ones are
// read here, those of motion, attitude, sections, structure and wings in the files of these names.
// A formula and the steps per second are not a number here, as they need other probes and the
// clock.
#include "measure/probe.h"

#include "measure/attitude.h"
#include "measure/diagnostics.h"
#include "measure/motion.h"
#include "measure/section.h"
#include "measure/structure.h"
#include "measure/wing_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

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

// Of the links and panels of the probe, the largest; not a number where none has a strength.
double marginOf(const ProbeSpec& probe, const Margins& margins)
{
    double largest = nothing;
    const auto take = [&](const std::vector<int>& places, const std::vector<double>& values) {
        for (const int place : places)
            largest = std::fmax(largest, values[std::size_t(place)]); // passes over no numbers
    };
    if (!margins.link.empty() || !margins.panel.empty()) {
        take(probe.links, margins.link);
        take(probe.panels, margins.panel);
    }
    return largest;
}

// Links and panels that the mesh has parted at are whole again.
double tornCount(const ProbeSpec& probe, const System& system, const State& state)
{
    const auto count = [](const std::vector<int>& places, auto hasTorn) {
        return std::count_if(places.begin(), places.end(), hasTorn);
    };
    const auto isTornNow = [&](int l) { return isTorn(system.links[std::size_t(l)], state); };
    if (state.splits.empty() && system.membranes.empty())
        return double(count(probe.links, isTornNow));
    std::set<Key> torn;
    for (const State::Tear& tear : state.tears)
        torn.insert(tear.element);
    const auto links =
        state.splits.empty() ? count(probe.links, isTornNow) : count(probe.links, [&](int l) {
            return torn.contains(system.links[std::size_t(l)].key);
        });
    if (system.membranes.empty()) // then only links tear
        return double(links);
    return double(links + count(probe.panels, [&](int p) {
                      return torn.contains(system.panelKey[std::size_t(p)]);
                  }));
}

} // namespace

bool isLoad(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Tension:
    case Quantity::MaxTension:
    case Quantity::Strain:
    case Quantity::MaxStrain:
    case Quantity::Margin:
    case Quantity::FabricStress:
    case Quantity::BendingMoment:
        return true;
    default:
        return false;
    }
}

void Readings::goTo(const System& system, const State& state)
{
    m_system = &system;
    m_state = &state;
    m_before = nullptr;
    m_strain.isKnown = false;
    m_tension.isKnown = false;
    m_panelLoad.isKnown = false;
    m_lineDrag.isKnown = false;
    m_panelPull.isKnown = false;
    m_energy.isKnown = false;
    m_margin.isKnown = false;
    m_judged.isKnown &= m_serial == system.serial && m_valuesSerial == system.valuesSerial;
}

const std::vector<double>& Readings::strain()
{
    if (!std::exchange(m_strain.isKnown, true))
        fillStrains(system(), state(), m_restLength, m_strain.value);
    return m_strain.value;
}

const std::vector<double>& Readings::tension()
{
    if (!std::exchange(m_tension.isKnown, true))
        fillTensions(system(), state(), m_tension.value);
    return m_tension.value;
}

const std::vector<Vec3>& Readings::panelLoad()
{
    if (!std::exchange(m_panelLoad.isKnown, true))
        m_panelLoad.value = panelLoads(system(), state());
    return m_panelLoad.value;
}

const std::vector<PanelPull>& Readings::panelPull()
{
    if (!std::exchange(m_panelPull.isKnown, true))
        fillPanelPulls(system(), state(), m_panelPull.value);
    return m_panelPull.value;
}

const Energies& Readings::energy()
{
    if (!std::exchange(m_energy.isKnown, true))
        m_energy.value = energies(system(), state());
    return m_energy.value;
}

const Margins& Readings::margin()
{
    if (!std::exchange(m_judged.isKnown, true)) {
        m_judged.value = unnamedPlacesOf(system());
        m_serial = system().serial;
        m_valuesSerial = system().valuesSerial;
    }
    if (!std::exchange(m_margin.isKnown, true))
        fillMargins(system(), state(), m_judged.value, m_margin.value);
    return m_margin.value;
}

const std::vector<std::uint8_t>& Readings::isOf(const ProbeSpec& probe)
{
    m_isOf.assign(system().links.size(), 0);
    for (const int link : probe.links)
        m_isOf[std::size_t(link)] = 1;
    return m_isOf;
}

Vec3 Readings::lineDragOf(const ProbeSpec& probe)
{
    Vec3 sum = Vec3::Zero();
    const std::vector<DragLine>& lines = system().of<LineLists>().list;
    if (lines.empty())
        return sum;
    if (!std::exchange(m_lineDrag.isKnown, true))
        m_lineDrag.value = lineDrags(system(), state());
    const std::vector<Vec3>& drag = m_lineDrag.value;
    const std::vector<std::uint8_t>& wanted = isOf(probe);
    for (std::size_t i = 0; i < drag.size(); ++i)
        if (wanted[std::size_t(lines[i].link)])
            sum += drag[i];
    return sum;
}

Vec3 Readings::airForceOf(const ProbeSpec& probe)
{
    Vec3 sum = Vec3::Zero();
    for (const int panel : probe.panels)
        sum += panelLoad()[std::size_t(panel)];
    return sum + lineDragOf(probe);
}

double Readings::value(const ProbeSpec& probe)
{
    const System& system = *m_system;
    const State& state = *m_state;
    const auto position = [&] { return meanOf(probe, system, state.position); };
    const auto velocity = [&] { return meanOf(probe, system, state.velocity); };
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
        return ofLinks(probe, strain());
    case Quantity::MaxStrain: {
        const double links = ofLinks(probe, strain());
        if (system.membranes.empty() || probe.panels.empty())
            return links;
        const double panels = largestPanelStrain(system, state, probe.panels);
        return links > panels ? links : panels; // links may be none, which is no number
    }
    case Quantity::Distance:
        return line().norm();
    case Quantity::Elevation: {
        const Vec3 l = line();
        return std::atan2(l.y(), horizontal(l)) * 180.0 / std::numbers::pi;
    }
    case Quantity::GlideRatio:
        return glideRatio(velocity());
    case Quantity::MeanGlideRatio:
        return glideRatio(position() - meanOf(probe, system, system.start.position));
    case Quantity::AirForce:
        return airForceOf(probe).norm();
    case Quantity::KineticEnergy:
        return energy().kinetic;
    case Quantity::PotentialEnergy:
        return energy().potential;
    case Quantity::ElasticEnergy:
        return energy().elastic;
    case Quantity::TotalEnergy:
        return energy().total();
    case Quantity::EnergyChange:
        return energy().total() - energies(system, system.start).total();
    case Quantity::WorkOfAir:
        return state.work.air;
    case Quantity::WorkOfHands:
        return state.work.hands;
    case Quantity::WorkOfDamping:
        return state.work.damping;
    case Quantity::WorkOfContact:
        return state.work.contact;
    case Quantity::WorkOfTearing:
        return state.work.tearing;
    case Quantity::EnergyResidual:
        return state.work.residual;
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
    case Quantity::VelocityX:
        return velocity().x();
    case Quantity::VelocityY:
        return velocity().y();
    case Quantity::VelocityZ:
        return velocity().z();
    case Quantity::Acceleration:
        return acceleration(probe, *this).norm();
    case Quantity::Momentum:
        return momentumOf(probe, *this).norm();
    case Quantity::Reaction:
        return reaction(probe, *this).norm();
    case Quantity::MeanStrain:
        return meanStrain(probe, *this);
    case Quantity::HighStrain:
        return highStrain(probe, *this);
    case Quantity::Length:
        return lengthOf(probe, *this);
    case Quantity::Area:
        return areaOf(probe, *this);
    case Quantity::Airspeed:
        return relativeWind(probe, *this).norm();
    case Quantity::WindSpeed:
        return windOver(probe, *this).norm();
    case Quantity::Lift:
        return liftAndDrag(probe, *this).lift;
    case Quantity::Drag:
        return liftAndDrag(probe, *this).drag;
    case Quantity::LiftToDrag: {
        const LiftAndDrag force = liftAndDrag(probe, *this);
        return force.drag > 0.0 ? force.lift / force.drag : nothing;
    }
    case Quantity::DragArea: {
        const double speed = relativeWind(probe, *this).norm();
        const double pressure = 0.5 * system.airDensity * speed * speed;
        return pressure > 0.0 ? liftAndDrag(probe, *this).drag / pressure : nothing;
    }
    case Quantity::PressureX:
        return centreOfPressure(probe, *this).x();
    case Quantity::PressureY:
        return centreOfPressure(probe, *this).y();
    case Quantity::PressureZ:
        return centreOfPressure(probe, *this).z();
    case Quantity::Pitch:
        return pitch(probe, *this);
    case Quantity::Heading:
        return heading(probe, *this);
    case Quantity::Roll:
        return roll(probe, *this);
    case Quantity::AngleOfAttack:
        return angleOfAttack(probe, *this);
    case Quantity::Margin:
        return marginOf(probe, margin());
    case Quantity::FabricStress:
        return fabricStress(probe, *this);
    case Quantity::MeanStress:
        return meanOfPanels(probe, *this, &PanelPull::tension);
    case Quantity::WarpStress:
        return meanOfPanels(probe, *this, &PanelPull::warp);
    case Quantity::WeftStress:
        return meanOfPanels(probe, *this, &PanelPull::weft);
    case Quantity::WrinkledShare:
        return wrinkledShare(probe, *this);
    case Quantity::BendingMoment:
        return bendingMoment(probe, *this);
    case Quantity::Camber:
        return camberOf(probe, *this).height;
    case Quantity::CamberPosition:
        return camberOf(probe, *this).position;
    case Quantity::Formula:
    case Quantity::StepsPerSecond:
        break; // known when the others are; of the clock, that the runner alone looks at
    }
    return nothing;
}

} // namespace ripstop
