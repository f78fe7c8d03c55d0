// The two values of a simulation: the System that stays and the State that moves.
//
// A System is a scene made ready to run: dense arrays, indices instead of ids, every number
// resolved. compile() builds it; then it is constant and shared freely between threads. It knows
// no scene. Keys are the ids of the scene's elements, opaque here: they tell which particle of an
// edited system is which.
#pragma once

#include "base/airflow.h"
#include "base/bend.h"
#include "base/hands.h"
#include "base/laws.h"
#include "base/path_key.h"
#include "base/vec3.h"
#include "base/wing_strips.h"
#include "shapes/height_grid.h"
#include "shapes/triangle_tree.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ripstop {

using Key = std::uint32_t;

struct TearLimit
{
    TearRule rule = TearRule::Never;
    double limit = 0.0; // m, 1 or N

    friend bool operator==(const TearLimit&, const TearLimit&) = default;
};

// A link that is a force: F = k (|d| - l) + nu (vb - va).u along u = d/|d|, on `a` towards `b`.
struct Spring
{
    int a; // particle index
    int b;
    double restLength; // m
    double stiffness;  // N/m
    double damping;    // N s/m
    Resists resists;
    TearLimit tear;

    friend bool operator==(const Spring&, const Spring&) = default;
};

// A link that is a constraint.
struct Rod
{
    int a; // particle index
    int b;
    double restLength; // m
    double compliance; // m/N, 0 never stretches
    Resists resists;
    TearLimit tear;

    friend bool operator==(const Rod&, const Rod&) = default;
};

inline constexpr int polarCells = 256;

struct PolarPoint
{
    double lift; // 1, CL
    double drag; // 1, CD

    friend bool operator==(const PolarPoint&, const PolarPoint&) = default;
};

// What the air does to things of one material: to its panels (panel_load.h) and to its links as
// lines (line_drag.h).
struct MaterialAir
{
    Key key = 0; // of the material; 0 for none
    AirLaw law = AirLaw::LinearNormal;
    double normalCoefficient = 2.0; // 1, Ca
    double saturation = 0.0;        // 1, Ca / C90 - 1; linear normal only
    double skinFriction = 0.0;      // 1, Cs
    double porosity = 0.0;          // 1, c
    double stall = 0.0;             // 1, sine of the stall of a wing; 0 for what is none
    double lineWidth = 0.0;         // m, drag coefficient times diameter
    std::vector<PolarPoint> polar;  // [polarCells + 1] at equal steps of tan(alpha / 2) from 0 to 1

    friend bool operator==(const MaterialAir&, const MaterialAir&) = default;
};

struct FabricPanel // one triangle of fabric
{
    std::array<int, 3> corner;
    int air; // index into System::materialAir

    friend bool operator==(const FabricPanel&, const FabricPanel&) = default;
};

// What an obstacle shares with others of the same shape; equal when what it points at is.
template <typename T>
struct Shared : std::shared_ptr<const T>
{
    using std::shared_ptr<const T>::shared_ptr;
    Shared(std::shared_ptr<const T> other)
        : std::shared_ptr<const T>(std::move(other))
    {}

    friend bool operator==(const Shared& a, const Shared& b)
    {
        return a.get() == b.get() || (a.get() && b.get() && *a.get() == *b.get());
    }
};

// What keeps the particles of a part from its panels and those of others; see fabric_contact.h.
struct FabricLayer
{
    double thickness = 0.0; // m, 0 goes through
    double friction = 0.0;  // 1

    friend bool operator==(const FabricLayer&, const FabricLayer&) = default;
};

// What stops particles. In its own frame a shape lies around the origin; a point p of that frame
// is at position + turn p.
struct Obstacle
{
    ColliderShape shape;
    Vec3 position; // m
    Vec3 normal;   // unit
    double radius; // m
    Response response;
    double restitution;
    double friction;
    double thickness = 0.0;                             // m, added to the surface
    Vec3 size = Vec3::Ones();                           // m, of boxes and height fields
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); // of boxes, height fields and meshes
    std::vector<PathKey> path = {};                     // empty: stays at `position`
    Shared<HeightGrid> grid = {};                       // of a height field
    Shared<TriangleTree> mesh = {};                     // of a mesh
    double scale = 1.0;                                 // m per unit of the mesh
    Key key = 0;

    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

// A link as the author sees it: which spring or rod it became, and whom it joins.
struct LinkPlace
{
    Key key;
    LinkKind kind;
    int index; // in springs or rods
    int a;     // particle indices
    int b;

    friend bool operator==(const LinkPlace&, const LinkPlace&) = default;
};

// What a link takes its numbers from, so that an edit of a material finds the links made of it and
// what it makes of them.
struct LinkStuff
{
    Key material = 0;
    std::uint8_t own = 0; // bits, one for each number that is the link's own
    LinkRole role = LinkRole::Line;
    double width = 0.0; // m, of the strip of fabric

    friend bool operator==(const LinkStuff&, const LinkStuff&) = default;
};

struct DragLine // a link that the wind drags
{
    int link; // index into System::links
    int a;    // particle indices
    int b;
    double width; // m, drag coefficient times diameter

    friend bool operator==(const DragLine&, const DragLine&) = default;
};

// One scalar input.
struct Input
{
    Key key;
    ControlKind kind;
    Vec3 axis;                       // unit
    double limit;                    // m
    double rate;                     // m/s
    double automaticRate;            // m/s
    std::vector<int> targets;        // particle indices
    std::vector<int> obstacles = {}; // that it moves, indices

    friend bool operator==(const Input&, const Input&) = default;
};

// A rod whose rest length follows the weight shift of one of its ends:
// it is scaled by |anchor - sum of (value x axis) over the inputs that shift `weight`| / |anchor|.
struct ShiftedRod
{
    int rod;
    int weight;  // the particle that is shifted
    Vec3 anchor; // m, from the weight to the other end, in the design

    friend bool operator==(const ShiftedRod&, const ShiftedRod&) = default;
};

// Gusts after Dryden (gusts.h).
struct GustSpec
{
    Key key = 0;
    Vec3 along = Vec3::UnitX();  // unit, level, with the mean wind
    Vec3 across = Vec3::UnitZ(); // unit, level
    double speed = 1.0;          // m/s, of the mean wind
    double lengthAlong = 1.0;    // m, across as well
    double lengthUp = 1.0;       // m
    double sigmaAlong = 0.0;     // m/s, across as well
    double sigmaUp = 0.0;        // m/s
    int seed = 1;

    friend bool operator==(const GustSpec&, const GustSpec&) = default;
};

// In standard deviations, so that it goes on when the gusts become stronger.
struct GustState
{
    double along = 0.0;
    std::array<double, 2> across{};
    std::array<double, 2> up{};

    friend bool operator==(const GustState&, const GustState&) = default;
};

// Fabric that holds air; see canopy_air.h.
struct Canopy
{
    struct Facet
    {
        int panel;
        std::array<int, 3> corner; // places in `particles`; normal (b - a) x (c - a) points out
        double share;              // of the cloth

        friend bool operator==(const Facet&, const Facet&) = default;
    };
    Key part = 0;
    int piece = 0;                    // of the fabric of that part
    double pressureCoefficient = 0.0; // 1, inside to outside over the dynamic pressure
    double fillEfficiency = 0.0;      // 1
    double addedMass = 0.0;           // 1, over the air in a hemisphere on the mouth
    double area = 0.0;                // m^2, of the cloth
    std::vector<int> particles;       // particle indices
    std::vector<Facet> facets;
    std::vector<int> mouth;              // places in `particles`, once around
    std::vector<std::vector<int>> vents; // the same, wound as the mouth is

    friend bool operator==(const Canopy&, const Canopy&) = default;
};

// The air of a canopy.
struct CanopyAir
{
    bool started = false;
    double volume = 0.0;      // m^3, of the air; that of the canopy is a little less
    double pressure = 0.0;    // Pa, inside over outside
    double fullness = 0.0;    // 1, that pressure over the most that there can be
    double addedMass = 0.0;   // kg
    double momentum = 0.0;    // kg m/s of the added mass relative to the wind, towards the crown
    Vec3 push = Vec3::Zero(); // N, of the added mass on all panels together

    friend bool operator==(const CanopyAir&, const CanopyAir&) = default;
};

struct ProbeSpec
{
    Key key;
    std::string name;
    Quantity quantity;
    std::vector<int> particles; // what is averaged or summed over; a single one for a particle
    std::vector<int> links;     // indices into System::links
    std::vector<int> panels;
    int from = -1; // particle index
    bool plotted = true;

    friend bool operator==(const ProbeSpec&, const ProbeSpec&) = default;
};

// Lists of lists in two arrays: row i is items[start[i]] .. items[start[i + 1]].
struct Rows
{
    std::vector<int> start; // [rows + 1]
    std::vector<int> items;

    friend bool operator==(const Rows&, const Rows&) = default;
};

// A particle that a tear has parted (tear_opening.h). All by keys, so that it outlives edits: what
// it names and is no longer there is passed over.
struct Split
{
    struct Cut // a link along the tear: each lip has one afterwards
    {
        Key link;     // of the lip of `from`
        Key twin;     // of the lip of `twin`
        double share; // 1, of stiffness, damping and breaking force, that the twin takes

        friend bool operator==(const Cut&, const Cut&) = default;
    };
    Key from;                // particle; keeps pins and hands, and what the torn link leaves behind
    Key twin;                // particle; new, at the same place with the same velocity
    double share;            // 1, of the mass, that the twin takes
    std::vector<Key> panels; // whose corner is the twin from now on
    std::vector<Key> links;  // whose end is
    std::vector<Cut> cut;

    friend bool operator==(const Split&, const Split&) = default;
};

// A link where the mesh has just opened: it has let go and has to be given time to shrink.
struct TearHold
{
    int link;     // index into System::links
    double ratio; // 1, over its limit, of the link that tore

    friend bool operator==(const TearHold&, const TearHold&) = default;
};

// What changes while a system runs. Copying a State is a checkpoint.
struct State
{
    double time = 0.0;         // s
    std::int64_t step = 0;     // time steps since the start
    std::int64_t substep = 0;  // substeps since the start
    int substeps = 0;          // of the next step, where the solver chooses; 0 for its first choice
    double driftSubstep = 0.0; // s, of the substep that `drift` is of; 0 when it is of none

    std::vector<PaddedVec3> position; // [particles] m
    std::vector<PaddedVec3> velocity; // [particles] m/s
    std::vector<PaddedVec3> drift;    // [particles] m/s, (x - previous x) / h: Verlet's memory

    std::vector<double> inputCommand; // [inputs] m, where the input is told to go
    std::vector<double> inputValue;   // [inputs] m, where it is

    Hands hands;               // as they were told
    std::vector<Vec3> carried; // [hands.carries] m, how far each has come

    std::vector<GustState> gusts;    // [gusts]
    std::vector<CanopyAir> canopies; // [canopies]

    std::vector<std::uint8_t> springTorn; // [springs]
    std::vector<std::uint8_t> rodTorn;    // [rods]
    std::vector<std::uint8_t> panelGone;  // [panels]
    std::vector<double> rodTension;       // [rods] N, mean over the last step

    struct Tear
    {
        double time;         // s
        Key link;            // key of the link
        double length;       // m, at the break
        double strain;       // 1
        double force;        // N
        Vec3 place;          // m, middle of the link
        double energy = 0.0; // J, that the link held and no longer does

        friend bool operator==(const Tear&, const Tear&) = default;
    };
    std::vector<Tear> tears; // in order of time

    std::vector<Split> splits; // in order of time; the system is one that was split by them
    std::vector<TearHold> tearHolds;

    friend bool operator==(const State&, const State&) = default;
};

// What changed in place lately, for solvers that keep something of their own about each rod: who
// has seen valuesSerial at `since` or later has to look at no more than these again. Who has not,
// looks at all.
struct Touched
{
    std::uint64_t since = 0;
    std::vector<int> particles; // whose inverse mass may have changed
    std::vector<int> rods;      // whose numbers may have changed
};

inline bool isTorn(const LinkPlace& link, const State& state)
{
    return link.kind == LinkKind::Rod ? state.rodTorn[std::size_t(link.index)]
                                      : state.springTorn[std::size_t(link.index)];
}

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
    double strainGoal = 0.01; // 1, for Solver::Auto
    int tearsPerStep = 0;     // links that a time step may break, 0 for any number
    TearMesh tearMesh = TearMesh::Vanish;
    Vec3 gravity = Vec3(0.0, -9.80665, 0.0); // m/s^2
    double airDensity = 1.225;               // kg/m^3
    Vec3 wind = Vec3::Zero();                // m/s, what is the same everywhere and always
    std::vector<Airflow> airflows;           // winds that depend on the place
    std::vector<GustSpec> gusts;
    double viscosity = 0.0;     // 1/s
    double speedLimit = 1000.0; // m/s

    std::vector<Key> key;            // [particles]
    std::vector<double> mass;        // [particles] kg, the true mass even when pinned
    std::vector<double> inverseMass; // [particles] 1/kg, 0 when pinned

    std::vector<Spring> springs;
    std::vector<Rod> rods;                // in the order of rod_order.h
    std::vector<int> colorStart;          // [colours + 1] places in rods
    std::vector<int> chunkStart;          // [chunks + 1] colours
    std::vector<int> chunkClass;          // [chunks] no two of a class share a particle
    int chunkReach = 0;                   // those that do are numbered at most this far apart
    std::vector<std::uint8_t> direct;     // [rods] solved as one block (direct_choice.h), or empty
    std::vector<MaterialAir> materialAir; // the first is that of no material
    std::vector<Bending> bending;         // [materialAir], or empty when nothing bends stiffly
    std::vector<DragLine> dragLines;      // in the order of their links
    std::vector<Bend> bends;              // where what bends stiffly can bend
    std::vector<FabricPanel> panels;
    std::vector<Key> panelKey;        // [panels]
    std::vector<WingStrips> wings;    // pieces of fabric with the vortex law
    std::vector<LinkPlace> links;     // in the author's order
    std::vector<LinkStuff> linkStuff; // [links], or empty when made by hand
    std::vector<int> springLink;      // [springs] index into links
    std::vector<int> rodLink;         // [rods] index into links
    std::vector<int> tearableSprings; // indices into springs, ascending
    std::vector<int> tearableRods;    // indices into rods, ascending

    Rows springsAt;    // [particles] springs that end there
    Rows rodsAt;       // [particles]
    Rows panelsAt;     // [particles]
    Rows dragLinesAt;  // [particles], or empty when there are none
    Rows bendsAt;      // [particles] 4 x bend + which of its corners, or empty
    Rows panelsBeside; // [links] panels that have both ends as corners

    std::vector<Obstacle> obstacles;
    std::vector<FabricLayer> fabricLayer; // [particles], or empty when all goes through
    std::vector<Canopy> canopies;
    std::vector<Input> inputs;
    std::vector<ShiftedRod> shiftedRods;
    std::vector<ProbeSpec> probes;

    State start;
};

// Fills what follows from the rest: the order of `rods` (and of the indices that point into it),
// incidence lists, the sizes of `start`. Call it once, last. Needs inverseMass, springs, rods,
// panels and start.position. Keys and links that are left empty are numbered; masses that are left
// empty follow from inverseMass; velocities are zero.
void finish(System& system);

// As a system starts, with the memory of its arrays kept.
void clear(System& system);

// Equal in all that a simulation reads; the serials are passed over.
bool operator==(const System& a, const System& b);

// Whoever changes a finished system in place, and is its only owner, says so with these.
void listTearable(System& system);  // after a tear rule
void startGusts(System& system);    // after another seed
void listDragLines(System& system); // after the air or the material of a link
void listBends(System& system);     // after bending, lengths, pins or where particles start
void touch(System& system, const Touched& changed); // after these inverse masses and rods
void touchAll(System& system);

} // namespace ripstop
