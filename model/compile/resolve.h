// What a row of a scene becomes in a System: every number resolved. A full compile and an edit in
// place both go through these, so that they cannot differ.
#pragma once

#include "scene/element_index.h"
#include "system/system.h"

namespace ripstop {

void takeSettings(const Settings& settings, System& system);

// Puts a particle at its place in the arrays of a system, or behind all that are there. One that is
// pinned starts at rest, one on a guide along it.
void takeParticle(const Particle& row, int place, System& system);

// What a particle at this place cannot leave; what is pinned has no guide.
GuidedParticle guidedOf(const Particle& row, int place);

LinkStuff stuffOf(const Link& row);
inline LinkFactors factorsOf(const Link& row)
{
    return {{row.stiffnessFactor, row.strengthFactor}, row.cellAspect};
}
inline ElementFactors factorsOf(const Panel& row)
{
    return {row.stiffnessFactor, row.strengthFactor};
}
Spring springOf(const Link& row, const Material& material, int a, int b); // particle indices
Rod rodOf(const Link& row, const Material& material, int a, int b); // or of a spring held as one
MaterialAir airOf(Id id, const Material& material);
std::vector<MaterialAir> materialAirOf(const Scene& scene);
Bending bendingOf(const Material& material);
std::vector<Bending> bendingsOf(const Scene& scene); // [materialAir], empty when all are limp
bool isLimp(const std::vector<Bending>& bendings);
Strength strengthOf(const Material& material);         // with its joints
std::vector<Strength> strengthsOf(const Scene& scene); // [materialAir], empty when none has any
bool hasNone(const std::vector<Strength>& strengths);
ClothLaw clothOf(const Material& material);
std::vector<ClothLaw> clothsOf(const Scene& scene); // [materialAir], empty when no panel needs them
std::vector<FabricTear> fabricTearsOf(const Scene& scene); // [materialAir]

// The numbers that come from the material, but for those that the link has itself.
void takeMaterial(const Material& material, const LinkStuff& stuff, const LinkFactors& factors,
                  Spring& spring);
void takeMaterial(const Material& material, const LinkStuff& stuff, const LinkFactors& factors,
                  Rod& rod);

struct Winds
{
    Vec3 uniform = Vec3::Zero();   // m/s, with the means of those that were measured
    std::vector<Airflow> airflows; // those that depend on the place
    std::vector<GustSpec> gusts;
    std::vector<DiscreteGust> discreteGusts;
    std::vector<WindRecord> records;
};
Winds windsOf(const Scene& scene);
void takeWinds(const Winds& winds, System& system);
std::vector<Obstacle> obstaclesOf(const Scene& scene);
std::vector<FabricLayer> fabricLayersOf(const Scene& scene);
std::vector<Canopy> canopiesOf(const Scene& scene, const ElementIndex& index);
std::vector<Input> inputsOf(const Scene& scene, const ElementIndex& index);
std::vector<ProbeSpec> probesOf(const Scene& scene, const ElementIndex& index);

// Of a finished system: the rods that hold the targets of weight shifts.
std::vector<ShiftedRod> shiftedRodsOf(const System& system);

} // namespace ripstop
