#include "system/system.h"

#include <tuple>
#include <type_traits>

namespace ripstop {
namespace {

// All but the serials. A field that is new has to be named here, or this does not compile.
template <typename S>
requires std::is_same_v<std::remove_const_t<S>, System>
auto fieldsOf(S& system)
{
    auto& [generation, run, serial, valuesSerial, touched, timeStep, substeps, sweeps, integrator,
           solver, strainGoal, tearsPerStep, tearMesh, gravity, airDensity, wind, airflows, gusts,
           viscosity, speedLimit, key, parts, mass, inverseMass, guided, springs, rods, colorStart,
           chunkStart, chunkClass, chunkReach, direct, materialAir, bending, forces, panels,
           panelKey, links, linkStuff, springLink, rodLink, tearableSprings, tearableRods,
           springsAt, rodsAt, panelsAt, panelsBeside, obstacles, fabricLayer, canopies, inputs,
           shiftedRods, probes, start] = system;
    return std::tie(generation, run, timeStep, substeps, sweeps, integrator, solver, strainGoal,
                    tearsPerStep, tearMesh, gravity, airDensity, wind, airflows, gusts, viscosity,
                    speedLimit, key, parts, mass, inverseMass, guided, springs, rods, colorStart,
                    chunkStart, chunkClass, chunkReach, direct, materialAir, bending, forces,
                    panels, panelKey, links, linkStuff, springLink, rodLink, tearableSprings,
                    tearableRods, springsAt, rodsAt, panelsAt, panelsBeside, obstacles, fabricLayer,
                    canopies, inputs, shiftedRods, probes, start);
}

template <typename S>
requires std::is_same_v<std::remove_const_t<S>, State>
auto fieldsOf(S& state)
{
    auto& [time, step, substep, substeps, driftSubstep, position, velocity, drift, inputCommand,
           inputValue, hands, carried, gusts, canopies, springTorn, rodTorn, panelGone, rodTension,
           tears, splits, tearHolds, work] = state;
    return std::tie(time, step, substep, substeps, driftSubstep, position, velocity, drift,
                    inputCommand, inputValue, hands, carried, gusts, canopies, springTorn, rodTorn,
                    panelGone, rodTension, tears, splits, tearHolds, work);
}

// Arrays are emptied and keep their memory; anything else starts as `fresh` does.
template <typename T>
void renew(T& field, const T& fresh)
{
    field = fresh;
}

template <typename T>
void renew(std::vector<T>& field, const std::vector<T>&)
{
    field.clear();
}

void renew(Rows& field, const Rows&)
{
    field.start.clear();
    field.items.clear();
}

void renew(State& field, const State& fresh);

template <typename Record>
void renewFields(Record& record, const Record& fresh)
{
    std::apply(
        [&](auto&... field) {
            std::apply([&](const auto&... value) { (renew(field, value), ...); }, fieldsOf(fresh));
        },
        fieldsOf(record));
}

void renew(State& field, const State& fresh) { renewFields(field, fresh); }

} // namespace

void clear(System& system)
{
    renewFields(system, System());
    system.serial = 0;
    system.valuesSerial = 0;
    system.touched = {};
}

bool operator==(const System& a, const System& b) { return fieldsOf(a) == fieldsOf(b); }

} // namespace ripstop
