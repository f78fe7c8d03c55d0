// The fields of System and State, said once (base/fields.h). Equality, clearing, bytes, the hash,
// what goes over into another system and what sizes arrays have follow from these lists; a new
// field needs its line here and nothing else. Lists that name too few fields do not compile.
#pragma once

#include "base/fields.h"
#include "base/hand_fields.h"
#include "system/system.h"

#include <cstddef>

namespace ripstop {

// What a field of a State is about. Arrays have an entry for each of the particles, springs, ... of
// the system and go over into another system entry by entry, with the particle or spring that the
// entry is of; what is of the run goes over as it is.
enum class Per { Run, Particle, Spring, Rod, Panel, Input, Gusts, Canopy };

// Whether stateHash() takes the field in.
enum class Hash { Out, In };

// How many of these the system has: the size of an array of a State.
inline std::size_t count(const System& system, Per per)
{
    switch (per) {
    case Per::Run:
        return 1;
    case Per::Particle:
        return system.key.size();
    case Per::Spring:
        return system.springs.size();
    case Per::Rod:
        return system.rods.size();
    case Per::Panel:
        return system.panels.size();
    case Per::Input:
        return system.inputs.size();
    case Per::Gusts:
        return system.gusts.size();
    case Per::Canopy:
        return system.canopies.size();
    }
    return 0;
}

template <>
inline constexpr auto fieldsOf<Rows> = fields<Rows, &Rows::start, &Rows::items>;

template <>
inline constexpr auto fieldsOf<GustState> =
    fields<GustState, &GustState::along, &GustState::across, &GustState::up>;

template <>
inline constexpr auto fieldsOf<CanopyAir> =
    fields<CanopyAir, &CanopyAir::started, &CanopyAir::volume, &CanopyAir::pressure,
           &CanopyAir::fullness, &CanopyAir::addedMass, &CanopyAir::momentum, &CanopyAir::push>;

template <>
inline constexpr auto fieldsOf<Split::Cut> =
    fields<Split::Cut, &Split::Cut::link, &Split::Cut::twin, &Split::Cut::share>;

template <>
inline constexpr auto fieldsOf<Split> = fields<Split, &Split::from, &Split::twin, &Split::share,
                                               &Split::panels, &Split::links, &Split::cut>;

template <>
inline constexpr auto fieldsOf<TearHold> = fields<TearHold, &TearHold::link, &TearHold::ratio>;

template <>
inline constexpr auto fieldsOf<State::Tear> =
    fields<State::Tear, &State::Tear::time, &State::Tear::element, &State::Tear::length,
           &State::Tear::strain, &State::Tear::force, &State::Tear::place, &State::Tear::energy>;

template <>
inline constexpr auto fieldsOf<Ramp::Numbers> =
    fields<Ramp::Numbers, &Ramp::Numbers::restLength, &Ramp::Numbers::stiffness,
           &Ramp::Numbers::damping, &Ramp::Numbers::limit>;

template <>
inline constexpr auto fieldsOf<Ramp> =
    fields<Ramp, &Ramp::link, &Ramp::began, &Ramp::lasts, &Ramp::from, &Ramp::to>;

template <>
inline constexpr auto fieldsOf<ClothLaw> =
    fields<ClothLaw, &ClothLaw::warp, &ClothLaw::weft, &ClothLaw::coupling, &ClothLaw::shear,
           &ClothLaw::dampingTime, &ClothLaw::pushes>;

template <>
inline constexpr auto fieldsOf<PanelCut> = fields<PanelCut, &PanelCut::area, &PanelCut::shape>;

template <>
inline constexpr auto fieldsOf<ClothRamp> =
    fields<ClothRamp, &ClothRamp::material, &ClothRamp::began, &ClothRamp::lasts, &ClothRamp::from,
           &ClothRamp::to>;

template <>
inline constexpr auto fieldsOf<PanelRamp> =
    fields<PanelRamp, &PanelRamp::panel, &PanelRamp::began, &PanelRamp::lasts, &PanelRamp::from,
           &PanelRamp::to>;

template <>
inline constexpr auto fieldsOf<FactorRamp> =
    fields<FactorRamp, &FactorRamp::panel, &FactorRamp::began, &FactorRamp::lasts,
           &FactorRamp::from, &FactorRamp::to>;

template <>
inline constexpr auto fieldsOf<Work> = fields<Work, &Work::air, &Work::hands, &Work::damping,
                                              &Work::contact, &Work::tearing, &Work::residual>;

// In the bytes of a recording, run_chunk.cpp puts what came since version 3 after all else.
// clang-format off
template <>
inline constexpr auto fieldsOf<State> = fields<State,
    &State::time,
    field<&State::step, Hash::In>,
    &State::substep,
    &State::substeps,
    &State::driftSubstep,
    field<&State::position, Per::Particle, Hash::In>,
    field<&State::velocity, Per::Particle, Hash::In>,
    field<&State::drift, Per::Particle>,
    field<&State::velocityBefore, Per::Particle, Since{4}>,
    field<&State::inputCommand, Per::Input>,
    field<&State::inputValue, Per::Input, Hash::In>,
    &State::hands,
    field<&State::carried, Hash::In>,
    field<&State::gusts, Per::Gusts, Hash::In>,
    field<&State::canopies, Per::Canopy>,
    field<&State::springTorn, Per::Spring, Hash::In>,
    field<&State::rodTorn, Per::Rod, Hash::In>,
    field<&State::panelGone, Per::Panel, Hash::In>,
    field<&State::panelHold, Per::Panel, Since{5}>,
    field<&State::rodTension, Per::Rod>,
    &State::tears,
    &State::splits,
    &State::tearHolds, // name links by their places, which carryOver() finds again
    field<&State::work, Since{3}>,
    field<&State::ramps, Since{4}>,
    field<&State::clothRamps, Since{5}>,
    field<&State::panelRamps, Since{5}>,
    field<&State::factorRamps, Since{6}>>;
// clang-format on

// The serials and what goes with them say when a solver looks again: two systems may be equal
// without them.
template <>
inline constexpr auto fieldsOf<System> = fields<
    System, &System::generation, &System::run, field<&System::serial, Compared::No>,
    field<&System::valuesSerial, Compared::No>, field<&System::touched, Compared::No>,
    &System::timeStep, &System::substeps, &System::sweeps, &System::integrator, &System::solver,
    &System::accuracy, &System::strainGoal, &System::rampTime, &System::tearsPerStep,
    &System::tearMesh, &System::gravity, &System::airDensity, &System::wind, &System::airflows,
    &System::gusts, &System::discreteGusts, &System::windRecords, &System::viscosity,
    &System::speedLimit, &System::safetyFactor, &System::key, &System::parts, &System::mass,
    &System::inverseMass, &System::guided, &System::springs, &System::springsAsRods, &System::rods,
    &System::colorStart, &System::chunkStart, &System::chunkClass, &System::chunkReach,
    &System::direct, &System::materialAir, &System::bending, &System::strength, &System::forces,
    &System::panels, &System::panelKey, &System::cloth, &System::clothTear, &System::membranes,
    &System::links, &System::linkStuff, &System::linkFactors, &System::springLink, &System::rodLink,
    &System::tearableSprings, &System::tearableRods, &System::springsAt, &System::rodsAt,
    &System::panelsAt, &System::panelsBeside, &System::obstacles, &System::fabricLayer,
    &System::canopies, &System::inputs, &System::shiftedRods, &System::probes, &System::start>;

// Calls visit(array, the same array in the next state, ...) for each array that has an entry for
// each of these.
template <Per per, typename Visit, typename... States>
void forEachPer(Visit&& visit, States&... states)
{
    forEachField<State>([&](auto field) {
        if constexpr (field.mark(Per::Run) == per)
            visit(field.of(states)...);
    });
}

// Calls visit(array, how many entries it has for this system) for each array of the state that has
// its size from the system.
template <typename S, typename Visit>
void forEachSized(const System& system, S& state, Visit&& visit)
{
    forEachField<State>([&](auto field) {
        constexpr Per per = field.mark(Per::Run);
        if constexpr (per != Per::Run)
            visit(field.of(state), count(system, per));
    });
}

} // namespace ripstop
