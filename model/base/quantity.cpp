#include "base/quantity.h"

#include <array>

namespace ripstop {
namespace {

using Of = QuantityRow::Of;

// clang-format off
constexpr std::array table{
    QuantityRow{Quantity::PositionX,       "m", Of::Particles, 1, "Where the centre of mass is, along x."},
    QuantityRow{Quantity::PositionY,       "m", Of::Particles, 1, "How high the centre of mass is."},
    QuantityRow{Quantity::PositionZ,       "m", Of::Particles, 1, "Where the centre of mass is, along z."},
    QuantityRow{Quantity::Speed,           "m/s", Of::Particles, 1, "Of the centre of mass over the ground."},
    QuantityRow{Quantity::SinkRate,        "m/s", Of::Particles, 1, "How fast the centre of mass falls."},
    QuantityRow{Quantity::Tension,         "N", Of::Links, 1, "Of a link; the largest where there are several."},
    QuantityRow{Quantity::Strain,          "", Of::Links, 1, "Of a link, its length over that at rest less one; the largest where there are several."},
    QuantityRow{Quantity::MaxStrain,       "", Of::LinksAndPanels, 1, "The largest of all links and of all threads of elastic panels."},
    QuantityRow{Quantity::MaxTension,      "N", Of::Links, 1, "The largest of all links."},
    QuantityRow{Quantity::Distance,        "m", Of::Particles, 2, "From a particle."},
    QuantityRow{Quantity::Elevation,       "deg", Of::Particles, 2, "Of the line from a particle, above the horizon."},
    QuantityRow{Quantity::GlideRatio,      "", Of::Particles, 1, "Way over height lost, now."},
    QuantityRow{Quantity::MeanGlideRatio,  "", Of::Particles, 1, "Way over height lost, since the start."},
    QuantityRow{Quantity::AirForce,        "N", Of::Panels, 1, "Of all panels and lines together."},
    QuantityRow{Quantity::KineticEnergy,   "J", Of::Whole, 1, "Of all that moves."},
    QuantityRow{Quantity::PotentialEnergy, "J", Of::Whole, 1, "Of weight, zero at the origin."},
    QuantityRow{Quantity::ElasticEnergy,   "J", Of::Whole, 1, "In springs, rods that give and bends."},
    QuantityRow{Quantity::TotalEnergy,     "J", Of::Whole, 1, "Kinetic, potential and elastic."},
    QuantityRow{Quantity::TornLinks,       "", Of::LinksAndPanels, 1, "How many have torn, and elastic panels among them."},
    QuantityRow{Quantity::CanopyPressure,  "Pa", Of::Canopy, 1, "Above that of the air around."},
    QuantityRow{Quantity::CanopyVolume,    "m\u00b3", Of::Canopy, 1, "Of the air under the canopy."},
    QuantityRow{Quantity::VelocityX,       "m/s", Of::Particles, 1, "Of the centre of mass, along x."},
    QuantityRow{Quantity::VelocityY,       "m/s", Of::Particles, 1, "Of the centre of mass, upwards."},
    QuantityRow{Quantity::VelocityZ,       "m/s", Of::Particles, 1, "Of the centre of mass, along z."},
    QuantityRow{Quantity::Acceleration,    "m/s\u00b2", Of::Particles, 1, "Of the centre of mass, over the last time step."},
    QuantityRow{Quantity::Airspeed,        "m/s", Of::Particles, 1, "Of the centre of mass through the air there."},
    QuantityRow{Quantity::MeanStrain,      "", Of::Links, 1, "The mean of all links that have not torn."},
    QuantityRow{Quantity::HighStrain,      "", Of::Links, 1, "What 95 of 100 links that have not torn stay below."},
    QuantityRow{Quantity::Length,          "m", Of::Links, 1, "Of all links together, as they are stretched."},
    QuantityRow{Quantity::Area,            "m\u00b2", Of::Fabric, 1, "Of all panels together, as they are stretched."},
    QuantityRow{Quantity::Reaction,        "N", Of::Particles, 1, "What holds the pinned particles against links, panels, air and weight."},
    QuantityRow{Quantity::Lift,            "N", Of::Panels, 1, "Air force across the relative wind, upwards."},
    QuantityRow{Quantity::Drag,            "N", Of::Panels, 1, "Air force along the relative wind."},
    QuantityRow{Quantity::LiftToDrag,      "", Of::Panels, 1, "Lift over drag."},
    QuantityRow{Quantity::DragArea,        "m\u00b2", Of::Panels, 1, "Drag over the dynamic pressure of the relative wind."},
    QuantityRow{Quantity::PressureX,       "m", Of::Panels, 1, "Where the air force acts: the mean of the panels by the force on each, along x."},
    QuantityRow{Quantity::PressureY,       "m", Of::Panels, 1, "Where the air force acts: the mean of the panels by the force on each, upwards."},
    QuantityRow{Quantity::PressureZ,       "m", Of::Panels, 1, "Where the air force acts: the mean of the panels by the force on each, along z."},
    QuantityRow{Quantity::AngleOfAttack,   "deg", Of::Particles, 3, "Between the chord, from tail to nose, and the relative wind, in the plane across the span."},
    QuantityRow{Quantity::Pitch,           "deg", Of::Particles, 2, "How far the nose is above the tail."},
    QuantityRow{Quantity::Roll,            "deg", Of::Particles, 3, "How far the right side is below the left one."},
    QuantityRow{Quantity::Heading,         "deg", Of::Particles, 2, "Where the nose points, from +x towards +z."},
    QuantityRow{Quantity::Momentum,        "kg m/s", Of::Particles, 1, "Of all that can move, its length."},
    QuantityRow{Quantity::EnergyChange,    "J", Of::Whole, 1, "Total energy less that of the start: what air, hands and the solver have brought or taken."},
    QuantityRow{Quantity::WorkOfAir,       "J", Of::Whole, 1, "What the air has brought (above 0) or taken."},
    QuantityRow{Quantity::WorkOfHands,     "J", Of::Whole, 1, "What hands and controls have brought or taken."},
    QuantityRow{Quantity::WorkOfDamping,   "J", Of::Whole, 1, "What dampers and viscosity have taken, at most 0."},
    QuantityRow{Quantity::WorkOfContact,   "J", Of::Whole, 1, "What impacts and friction have taken; what moves may bring some."},
    QuantityRow{Quantity::WorkOfTearing,   "J", Of::Whole, 1, "What torn links held and took along, at most 0."},
    QuantityRow{Quantity::EnergyResidual,  "J", Of::Whole, 1, "Energy change that no work explains: what the solver has made (above 0) or lost."},
    QuantityRow{Quantity::Formula,         "", Of::Probes, 1, "A number made of what other probes read."},
    QuantityRow{Quantity::StepsPerSecond,  "1/s", Of::Whole, 1, "Time steps for each second of the clock, lately: only while it runs in the window, and nothing in files."},
    QuantityRow{Quantity::Margin,          "", Of::LinksAndPanels, 1, "Load over strength, of the link or panel that is nearest to breaking: 1 breaks. Strength is that of the material times its joint efficiency over the safety factor of the scene."},
    QuantityRow{Quantity::FabricStress,    "N/m", Of::Fabric, 1, "Pull per width of fabric, the largest of all directions and places: of elastic panels their principal tension, of threads their tension over their width."},
    QuantityRow{Quantity::MeanStress,      "N/m", Of::Fabric, 1, "Largest principal tension of elastic panels, the mean by their area at rest."},
    QuantityRow{Quantity::WarpStress,      "N/m", Of::Fabric, 1, "Pull of the warp threads of elastic panels per width, the mean by their area at rest."},
    QuantityRow{Quantity::WeftStress,      "N/m", Of::Fabric, 1, "Pull of the weft threads of elastic panels per width, the mean by their area at rest."},
    QuantityRow{Quantity::WrinkledShare,   "", Of::Fabric, 1, "Share of the area of elastic panels that is wrinkled or slack."},
    QuantityRow{Quantity::BendingMoment,   "N m", Of::Links, 1, "Of spars, where two links meet; the largest where there are several places."},
    QuantityRow{Quantity::Camber,          "", Of::Particles, 2, "How deep the fabric is arched between the nose and the tail, over their distance."},
    QuantityRow{Quantity::CamberPosition,  "", Of::Particles, 2, "Where the fabric is arched deepest between the nose and the tail, from the nose, over their distance."},
    QuantityRow{Quantity::WindSpeed,       "m/s", Of::Particles, 1, "Of the air at the centre of mass, over the ground, with its gusts."},
};
// clang-format on

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].quantity != Quantity(i))
            return false;
    return table.size() == choiceNames<Quantity>.size();
}
static_assert(isInOrder());

} // namespace

const QuantityRow& rowOf(Quantity quantity) { return table[std::size_t(quantity)]; }

std::string_view unitOf(Quantity quantity) { return rowOf(quantity).unit; }

} // namespace ripstop
