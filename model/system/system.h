// The two values of a simulation: the System that stays and the State (state.h) that moves.
//
// A System is a scene made ready to run: dense arrays, indices instead of ids, every number
// resolved. compile() builds it; then it is constant and shared freely between threads. It knows
// no scene.
#pragma once

#include "base/airflow.h"
#include "base/quantity.h"
#include "base/rows.h"
#include "base/vec3.h"
#include "laws/cloth_law.h"
#include "laws/guide.h"
#include "laws/load_margin.h"
#include "laws/solver_laws.h"
#include "system/canopy.h"
#include "system/force_lists.h"
#include "system/gust_spec.h"
#include "system/input.h"
#include "system/key.h"
#include "system/links.h"
#include "system/obstacle.h"
#include "system/panels.h"
#include "system/state.h"
#include "system/wind_record.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ripstop {

// A probe made ready to run: what it measures, and on what (base/quantity.h).
struct ProbeSpec
{
    Key key;
    std::string name;
    Quantity quantity;
    std::vector<int> particles; // what is averaged or summed over; a single one for a particle
    std::vector<int> links;     // indices into System::links
    std::vector<int> panels;
    int from = -1; // particle index
    int side = -1; // particle index
    bool plotted = true;
    std::string unit;
    std::string formula; // of other probes, when the quantity is one

    friend bool operator==(const ProbeSpec&, const ProbeSpec&) = default;
};

// Particles stand part by part; those that tears have added come last and are of no part here.
struct PartPlace
{
    Key key;
    int first; // particle index

    friend bool operator==(const PartPlace&, const PartPlace&) = default;
};

// What changed in place lately, for solvers that keep something of their own about each rod. A
// solver that has seen valuesSerial at `since` or later has to look at no more than these again;
// any other has to look at all rods.
struct Touched
{
    std::uint64_t since = 0;
    std::vector<int> particles; // whose inverse mass or guide may have changed
    std::vector<int> rods;      // whose numbers may have changed
};

// What stays while a simulation runs. Arrays of particles, springs, panels and links keep the order
// of the author; rods stand in that of the sweeps.
struct System
{
    std::uint64_t generation = 0;   // counts compiles; copied into every Frame
    std::uint64_t run = 0;          // counts resets; motion carries over within a run
    std::uint64_t serial = 0;       // of finish(); tells solvers when to prepare themselves anew
    std::uint64_t valuesSerial = 0; // of the numbers of rods and of inverse masses: solvers keep
                                    // their order and read them again
    Touched touched;

    double timeStep = 1.0 / 240.0; // s
    int substeps = 4;
    int sweeps = 8; // passes over the rods per substep
    Integrator integrator = Integrator::SemiImplicitEuler;
    Solver solver = Solver::GaussSeidel;
    double accuracy = 0.01;   // 1, error of pulls that is wanted
    double strainGoal = 0.01; // 1, the strain that stands for it in rods without compliance
    double rampTime = 0.0;    // s, over which links and panels take over edits in flight
    int tearsPerStep = 0;     // breaks that a time step may have, 0 for any number
    TearMesh tearMesh = TearMesh::Vanish;
    Vec3 gravity = Vec3(0.0, -9.80665, 0.0); // m/s^2
    double airDensity = 1.225;               // kg/m^3
    Vec3 wind = Vec3::Zero();                // m/s, what is the same everywhere and always
    std::vector<Airflow> airflows;           // winds that depend on the place
    std::vector<GustSpec> gusts;
    std::vector<DiscreteGust> discreteGusts;
    std::vector<WindRecord> windRecords;
    double viscosity = 0.0;     // 1/s
    double speedLimit = 1000.0; // m/s
    double safetyFactor = 1.0;  // 1, of margins

    std::vector<Key> key;               // [particles]
    std::vector<PartPlace> parts;       // in ascending order of their first particles
    std::vector<double> mass;           // [particles] kg, the true mass even when pinned
    std::vector<double> inverseMass;    // [particles] 1/kg, 0 when pinned
    std::vector<GuidedParticle> guided; // in ascending order of particle

    std::vector<Spring> springs;
    std::size_t springsAsRods = 0;        // springs of the author that stand in rods
    std::vector<Rod> rods;                // in the order of rod_order.h
    std::vector<int> colorStart;          // [colours + 1] places in rods
    std::vector<int> chunkStart;          // [chunks + 1] colours
    std::vector<int> chunkClass;          // [chunks] no two of a class share a particle
    int chunkReach = 0;                   // those that do are numbered at most this far apart
    std::vector<std::uint8_t> direct;     // [rods] solved as one block (direct_choice.h), or empty
    std::vector<MaterialAir> materialAir; // the first is that of no material
    std::vector<Bending> bending;         // [materialAir], or empty when nothing bends stiffly
    std::vector<Strength> strength;       // [materialAir], or empty when nothing has one
    ForceLists forces;                    // what each force derives from all else
    std::vector<FabricPanel> panels;
    std::vector<Key> panelKey;            // [panels]
    std::vector<ClothLaw> cloth;          // [materialAir], or empty when no panel carries a pull
    std::vector<FabricTear> clothTear;    // [cloth] at what those panels tear
    std::vector<Membrane> membranes;      // panels that do, in ascending order
    std::vector<LinkPlace> links;         // in the author's order
    std::vector<LinkStuff> linkStuff;     // [links], or empty when made by hand
    std::vector<LinkFactors> linkFactors; // [links], or empty when all are 1
    std::vector<int> springLink;          // [springs] index into links
    std::vector<int> rodLink;             // [rods] index into links
    std::vector<int> tearableSprings;     // indices into springs, ascending
    std::vector<int> tearableRods;        // indices into rods, ascending

    Rows springsAt;    // [particles] springs that end there
    Rows rodsAt;       // [particles] rods that end there
    Rows panelsAt;     // [particles] panels that have it as a corner
    Rows panelsBeside; // [links] panels that have both ends as corners

    std::vector<Obstacle> obstacles;
    std::vector<FabricLayer> fabricLayer; // [particles], or empty when all goes through
    std::vector<Canopy> canopies;
    std::vector<Input> inputs;
    std::vector<ShiftedRod> shiftedRods;
    std::vector<ProbeSpec> probes;

    State start;

    // What one force derives, asked by its type: of<BendLists>().
    template <typename Lists>
    Lists& of()
    {
        return std::get<Lists>(forces);
    }
    template <typename Lists>
    const Lists& of() const
    {
        return std::get<Lists>(forces);
    }

    LinkFactors factorsOf(std::size_t link) const
    {
        return linkFactors.empty() ? LinkFactors() : linkFactors[link];
    }
};

// Makes the system what System() is, and keeps the memory of its arrays.
void clear(System& system);

// Whether two systems are equal in all that a simulation reads; the serials are passed over.
bool operator==(const System& a, const System& b);

} // namespace ripstop
