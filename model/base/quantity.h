// What probes can measure: the quantities with their names, units and what they are measured on.
//
// A new one comes at the end of the enumeration, with its name here, its row in quantity.cpp and
// its reading in measure/probe.cpp. Constant tables: any thread may read them.
#pragma once

#include "base/choice_names.h"

#include <string_view>

namespace ripstop {

enum class Quantity {
    PositionX,
    PositionY,
    PositionZ,
    Speed,
    SinkRate,
    Tension,
    Strain,
    MaxStrain,
    MaxTension,
    Distance,
    Elevation,
    GlideRatio,
    MeanGlideRatio,
    AirForce,
    KineticEnergy,
    PotentialEnergy,
    ElasticEnergy,
    TotalEnergy,
    TornLinks,
    CanopyPressure,
    CanopyVolume,
    VelocityX,
    VelocityY,
    VelocityZ,
    Acceleration,
    Airspeed,
    MeanStrain,
    HighStrain, // the strain that 95 of 100 links stay below
    Length,
    Area,
    Reaction,
    Lift,
    Drag,
    LiftToDrag,
    DragArea,
    PressureX, // of the centre of pressure
    PressureY,
    PressureZ,
    AngleOfAttack,
    Pitch,
    Roll,
    Heading,
    Momentum,
    EnergyChange,
    WorkOfAir,
    WorkOfHands,
    WorkOfDamping,
    WorkOfContact,
    WorkOfTearing,
    EnergyResidual,
    Formula,
    StepsPerSecond, // of the clock, while it runs in the window
    Margin,         // load over strength
    FabricStress,   // the largest of the target
    MeanStress,     // by flat area, as those of the warp and the weft
    WarpStress,
    WeftStress,
    WrinkledShare, // of the flat area
    BendingMoment,
    Camber, // of the section of a sail
    CamberPosition,
    WindSpeed
};

// clang-format off
template <>
inline constexpr std::array<std::string_view, 62> choiceNames<Quantity>{
    "position_x",       "position_y",     "position_z",       "speed",       "sink_rate",
    "tension",          "strain",         "max_strain",       "max_tension", "distance",
    "elevation",        "glide_ratio",    "mean_glide_ratio", "air_force",   "kinetic_energy",
    "potential_energy", "elastic_energy", "total_energy",     "torn_links",  "canopy_pressure",
    "canopy_volume",    "velocity_x",     "velocity_y",       "velocity_z",  "acceleration",
    "airspeed",         "mean_strain",    "high_strain",      "length",      "area",
    "reaction",         "lift",           "drag",             "lift_to_drag", "drag_area",
    "pressure_x",       "pressure_y",     "pressure_z",       "angle_of_attack", "pitch",
    "roll",             "heading",        "momentum",         "energy_change",
    "work_of_air",      "work_of_hands",  "work_of_damping",  "work_of_contact", "work_of_tearing",
    "energy_residual",  "formula",        "steps_per_second", "margin",           "fabric_stress",
    "mean_stress",      "warp_stress",    "weft_stress",      "wrinkled_share", "bending_moment",
    "camber",           "camber_position", "wind_speed"};
// clang-format on

struct QuantityRow
{
    enum class Of { Particles, Links, LinksAndPanels, Fabric, Panels, Canopy, Whole, Probes };

    Quantity quantity;
    std::string_view unit; // "m", "deg", "N", ...; empty when dimensionless. Angles are in degrees,
                           // because that is how fliers speak of them.
    Of of;                 // what of its target is measured
    int points;            // that it takes: 1 the target, 2 with `from`, 3 with `side`
    std::string_view help; // one sentence
};

const QuantityRow& rowOf(Quantity quantity);

std::string_view unitOf(Quantity quantity);

} // namespace ripstop
