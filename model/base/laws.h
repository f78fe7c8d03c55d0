// The choices of law that a design makes and the solver obeys.
//
// Both sides share these enumerations; the names below are the ones that files, the command line
// and the screen use, in the order of the enumerators. They are never renamed.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ripstop {

enum class Integrator { ExplicitEuler, SemiImplicitEuler, Verlet, VelocityVerlet };

enum class Solver {
    AveragedJacobi, // mass-split: conserves momentum (Tonge 2012)
    PaperJacobi, // each end averages its own corrections (Beaudry, Egli, Patenaude 2005, figure 8)
    GaussSeidel, // in colours, with compliance (Macklin, Mueller, Chentanez 2016)
    SmallSteps,  // Gauss-Seidel with one sweep per substep, the order of colours shuffled in each
                 // (Macklin, Storey, Lu, Terdiman, Chentanez, Jeschke and Mueller 2019)
    Direct,      // all rods together, by Newton's method; for lines, frames and heavy loads
    Auto         // small steps, as many as the wanted strain needs, and direct blocks
};

enum class Guide : std::uint8_t { None, Line, Plane }; // what a particle cannot leave
enum class LinkKind { Spring, Rod };                   // a force; a constraint
enum class LinkRole : std::uint8_t {
    Line,
    Thread,
    Bias
};                                                 // one by itself; of a woven fabric, along
                                                   // its threads or across its cells
enum class Resists { Both, Tension, Compression }; // a batten, a line, a strut
enum class TearRule { Never, Length, Strain, Force };
enum class TearMesh { Vanish, Split }; // what panels do beside a link that tears
enum class AirLaw { None, Paper, LinearNormal, LiftDrag, Vortex };
enum class WindKind { Uniform, PowerLaw, LogLaw, Gusts, Jet };
enum class ColliderShape { Plane, Sphere, Box, Cylinder, HeightField, Mesh };
enum class Response { Stop, Slide, Contact };
enum class ControlKind { Move, WeightShift };

// What a probe reads; its unit stands in measure/probe.h.
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
    HighStrain, // that 95 of 100 links stay below
    Length,
    Area,
    Reaction,
    Lift,
    Drag,
    LiftToDrag,
    DragArea,
    PressureX, // centre of it
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
    StepsPerSecond // of the clock, while it runs in the window
};

enum class PlotAxis { Time, Probe, Frequency }; // what a plot shows its curves against

template <typename E>
inline constexpr std::array<std::string_view, 0> choiceNames{};

template <>
inline constexpr std::array<std::string_view, 4> choiceNames<Integrator>{
    "explicit_euler", "semi_implicit_euler", "verlet", "velocity_verlet"};
template <>
inline constexpr std::array<std::string_view, 6> choiceNames<Solver>{
    "averaged_jacobi", "paper_jacobi", "gauss_seidel", "small_steps", "direct", "auto"};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Guide>{"none", "line", "plane"};
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<LinkKind>{"spring", "rod"};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<LinkRole>{"line", "thread", "bias"};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Resists>{"both", "tension",
                                                                      "compression"};
template <>
inline constexpr std::array<std::string_view, 4> choiceNames<TearRule>{"never", "length", "strain",
                                                                       "force"};
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<TearMesh>{"vanish", "split"};
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<AirLaw>{
    "none", "paper", "linear_normal", "lift_drag", "vortex"};
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<WindKind>{"uniform", "power_law",
                                                                       "log_law", "gusts", "jet"};
template <>
inline constexpr std::array<std::string_view, 6> choiceNames<ColliderShape>{
    "plane", "sphere", "box", "cylinder", "height_field", "mesh"};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Response>{"stop", "slide", "contact"};
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<ControlKind>{"move", "weight_shift"};
// clang-format off
template <>
inline constexpr std::array<std::string_view, 52> choiceNames<Quantity>{
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
    "energy_residual",  "formula",        "steps_per_second"};
// clang-format on
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<PlotAxis>{"time", "probe",
                                                                       "frequency"};

} // namespace ripstop
