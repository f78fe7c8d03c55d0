// What a scene is made of: many elements that are alike, few items that differ.
//
// Every field here is authored, nothing is derived. Units, ranges and explanations of the fields
// stand in the property table (property.cpp), which files, forms and the manual are made from.
#pragma once

#include "base/control_kind.h"
#include "base/plot_axis.h"
#include "base/quantity.h"
#include "base/vec3.h"
#include "base/wind_kind.h"
#include "laws/air_laws.h"
#include "laws/cloth_law.h"
#include "laws/contact_laws.h"
#include "laws/guide.h"
#include "laws/link_laws.h"
#include "laws/solver_laws.h"
#include "scene/id.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ripstop {

using NumberRows = std::vector<std::vector<double>>; // rows of a table

// --- elements: rows of the tables of a part, in ascending order of id -----------------------

struct Particle
{
    Id id{};
    Vec3 position = Vec3::Zero(); // m, where the run starts
    Vec3 velocity = Vec3::Zero(); // m/s, when the run starts
    double mass = 0.01;           // kg
    bool pinned = false;
    Guide guide = Guide::None;
    Vec3 guideAxis = Vec3(1.0, 0.0, 0.0); // any length but 0
    double textureU = 0.0;
    double textureV = 0.0;

    friend bool operator==(const Particle&, const Particle&) = default;
};

// Two particles tied to each other. A number that is absent comes from the material.
struct Link
{
    Id id{};
    Id from{};
    Id to{};
    Id material{};
    LinkKind kind = LinkKind::Rod;
    Resists resists = Resists::Both;
    LinkRole role = LinkRole::Line;
    double restLength = 1.0;          // m
    double width = 0.0;               // m, of the strip of fabric that a thread or bias stands for
    double cellAspect = 1.0;          // 1, length over width of the cells beside a thread
    std::optional<double> stiffness;  // N/m, springs
    std::optional<double> damping;    // N s/m, springs
    std::optional<double> compliance; // m/N, rods
    std::optional<double> tearLimit;  // as the material's tear rule says (derived/tear_bounds.h)
    double stiffnessFactor = 1.0;     // 1, of what the material gives, as are strengths
    double strengthFactor = 1.0;      // 1

    friend bool operator==(const Link&, const Link&) = default;
};

// One triangle of fabric. In a part of which panels carry the pull it is flat at rest, with sides
// as long as they are told to be, or as they are in the scene.
struct Panel
{
    Id id{};
    Id a{};
    Id b{};
    Id c{};
    Id material{};
    double restAB = 0.0; // m, 0 takes what the particles are apart
    double restBC = 0.0;
    double restCA = 0.0;
    double grain = 0.0;           // degrees, from the side ab towards c, where the warp runs
    double stiffnessFactor = 1.0; // 1, of what the material gives, as are strengths
    double strengthFactor = 1.0;  // 1

    friend bool operator==(const Panel&, const Panel&) = default;
};

// --- items -----------------------------------------------------------------------------------

// A named network. The builder and its parameters are kept so that the part can be built again.
struct Part
{
    std::string name = "part";
    bool shown = true;
    FabricKind carrier = FabricKind::Threads;
    double selfContact = 0.0;     // m, distance that fabric keeps from fabric; 0 lets it through
    double selfFriction = 0.3;    // 1
    double canopyPressure = 0.0;  // 1, over the dynamic pressure; 0 holds no air
    double fillEfficiency = 0.07; // 1, of a canopy
    double addedMass = 1.0;       // 1, of a canopy, over the air in a hemisphere on its mouth
    std::optional<double> massTarget;         // kg, what it is meant to weigh
    std::optional<double> lengthTarget;       // m, of links with the role line, rest lengths
    std::optional<double> areaTarget;         // m^2, of panels
    std::string builder;                      // empty when drawn by hand
    std::map<std::string, double> parameters; // of the builder
    std::vector<Particle> particles;
    std::vector<Link> links;
    std::vector<Panel> panels;

    friend bool operator==(const Part&, const Part&) = default;
};

// Angle of attack (degrees), CL and CD of a flat plate of high aspect ratio, stalled from the
// first: C_N = 1.98 sin(a) / (0.56 + 0.44 sin(a)), Lindenburg 2003.
NumberRows flatPlatePolar();

// What links and panels are made of.
struct Material
{
    std::string name = "material";
    std::string color = "#c8553d";
    bool shown = true;
    std::string picture;                     // on the fabric, a PNG or JPEG; beside the scene file
    double pictureWidth = 0.0;               // m; 0 lays it once over the u and v of the mesh
    double pictureRight = 0.0;               // 1, of its width, from the middle
    double pictureUp = 0.0;                  // 1, of its height
    double pictureTurn = 0.0;                // degrees, counter-clockwise
    double stiffness = 100.0;                // N/m, springs
    double damping = 0.0;                    // N s/m, springs
    double compliance = 0.0;                 // m/N, rods
    double dampingTime = 0.0;                // s, rods; see system/links.h
    std::optional<double> axialStiffness;    // N, EA of lines and spars; see link_stiffness.h
    std::optional<double> membraneStiffness; // N/m, E t of fabric along its threads
    std::optional<double> shearStiffness;    // N/m, G t of fabric
    std::optional<double> weftStiffness;     // N/m, E t across it, of panels; absent, as along
    double poissonRatio = 0.2;               // 1, of panels pulled along the warp
    bool resistsPushing = false;             // panels do, instead of wrinkling
    double bendingStiffness = 0.0;           // N m, B of fabric; see laws/bend.h
    double flexuralRigidity = 0.0;           // N m^2, EI of spars
    std::optional<double> arealDensity;      // kg/m^2, of fabric, as weighed into the particles
    std::optional<double> linearDensity;     // kg/m, of lines and spars, as weighed into them
    TearRule tearRule = TearRule::Never;
    double tearLimit = 0.5; // m, 1, N or N/m, as the rule says
    AirLaw airLaw = AirLaw::LinearNormal;
    double normalCoefficient = 2.0;             // 1
    std::optional<double> broadsideCoefficient; // 1; absent, that of small angles holds
    NumberRows polar = flatPlatePolar();        // degrees, CL, CD
    double stallAngle = 15.0;                   // degrees, of the vortex law
    double skinFriction = 0.02;                 // 1
    double porosity = 0.0;                      // 1
    double diameter = 0.0;                      // m, of links as lines in the wind
    double dragCoefficient = 1.1;               // 1, of lines across the wind
    // At what load it breaks, for margins (laws/load_margin.h). A run depends on it where the tear
    // rule is strength or energy (derived/tear_bounds.h).
    std::optional<double> warpStrength;    // N/m, of fabric pulled along its warp
    std::optional<double> weftStrength;    // N/m, of fabric pulled across it
    std::optional<double> tearStrength;    // N, that a tear in the fabric needs to go on
    std::optional<double> lineStrength;    // N, of a line without knots
    std::optional<double> breakingMoment;  // N m, of a spar
    std::optional<double> jointEfficiency; // 1, of it that its seams or knots keep

    friend bool operator==(const Material&, const Material&) = default;
};

struct Group
{
    std::string name = "group";
    std::vector<Id> members;
    std::optional<double> massTarget = {};   // kg, as those of a part
    std::optional<double> lengthTarget = {}; // m
    std::optional<double> areaTarget = {};   // m^2

    friend bool operator==(const Group&, const Group&) = default;
};

struct Collider
{
    std::string name = "collider";
    ColliderShape shape = ColliderShape::Plane;
    Vec3 position = Vec3::Zero();      // m
    Vec3 normal = Vec3(0.0, 1.0, 0.0); // the shape says which of the numbers count (shapes/solid.h)
    double radius = 1.0;               // m
    Vec3 size = Vec3::Ones();          // m, width, height and depth
    Vec3 turn = Vec3::Zero();          // degrees about x, then y, then z
    double thickness = 0.0;            // m, what touches stays this far from the surface
    Response response = Response::Contact;
    double restitution = 0.0; // 1
    double friction = 0.3;    // 1
    std::string path;         // "0: 0 1 0; 2.5: 3 1 0", s and m; empty stays at `position`
    std::string file;         // height field: a picture; mesh: a mesh; beside the scene file
    double scale = 1.0;       // m per unit of a mesh file
    int grid = 256;           // points along each side of generated hills
    int seed = 1;             // of generated hills
    double hillLength = 0.25; // of generated hills, over the width of the field
    bool shown = true;

    friend bool operator==(const Collider&, const Collider&) = default;
};

struct Wind
{
    std::string name = "wind";
    Vec3 velocity = Vec3::Zero(); // m/s
    WindKind kind = WindKind::Uniform;
    double referenceHeight = 10.0; // m over y = 0
    double exponent = 1.0 / 7.0;   // 1, power law
    double roughness = 0.03;       // m, log law
    double gustiness = 7.7;        // m/s, wind at 20 ft that the gusts are those of
    int seed = 1;
    Vec3 position = Vec3::Zero(); // m, nozzle of a jet
    double radius = 0.5;          // m, of the nozzle
    double spread = 12.0;         // degrees, half the angle of a jet
    double onset = 5.0;           // s, of a discrete gust
    double duration = 3.0;        // s
    double interval = 0.0;        // s, from one discrete gust to the next; 0 has one only
    double growth = 0.0;          // 1, of the first, that each is stronger than the one before
    NumberRows velocities = {{0.0, 0.0, 0.0, 0.0}}; // s, m/s along x, y, z; of a measured wind

    friend bool operator==(const Wind&, const Wind&) = default;
};

// One input with one value, m: how far its targets are moved along `axis`, or how far the weight
// is shifted along it inside the rods that hold it.
struct Control
{
    std::string name = "control";
    ControlKind kind = ControlKind::Move;
    std::vector<Id> targets; // particles, and colliders that are moved
    Vec3 axis = Vec3(1.0, 0.0, 0.0);
    std::string keyLess; // "Left"; "Ctrl+Left" and the like as Qt writes key sequences
    std::string keyMore;
    double step = 0.01;         // m, per key press
    double limit = 1.0;         // m, either way
    double rate = 0.5;          // m/s, how fast the value follows its command
    double automaticRate = 0.0; // m/s, how fast the command moves by itself

    friend bool operator==(const Control&, const Control&) = default;
};

struct Probe
{
    std::string name = "probe";
    Quantity quantity = Quantity::PositionY;
    Id target{};         // particle, link, part or group; none is the whole scene
    Id from{};           // the other particle, for distance and elevation; the tail, for attitudes
    Id side{};           // a third particle, on the right, for attitudes
    std::string formula; // of other probes, by name
    bool plotted = true;

    friend bool operator==(const Probe&, const Probe&) = default;
};

// What a panel of the plots dock shows.
struct Plot
{
    std::string name = "plot";
    PlotAxis axis = PlotAxis::Time;
    Id against{};              // the probe across, where the axis is one
    std::vector<Id> probes;    // its curves; empty has all that are plotted
    double seconds = 30.0;     // s, the latest in sight; 0 shows the whole run
    bool logarithmic = false;  // the axes of values
    std::optional<double> low; // of the values in sight, in the unit of each curve
    std::optional<double> high;

    friend bool operator==(const Plot&, const Plot&) = default;
};

// How the scene is run.
struct Settings
{
    std::string title;
    std::string notes;
    double timeStep = 1.0 / 240.0; // s
    int substeps = 4;
    int sweeps = 8;
    Integrator integrator = Integrator::Auto;
    Solver solver = Solver::Auto;
    double accuracy = 1.0;   // %, error of pulls that is wanted
    double strainGoal = 1.0; // %, largest strain of rods that Solver::Auto aims at
    double rampTime = 0.1;   // s, over which links and panels take over edits in flight
    int tearsPerStep = 0;    // links that a time step may break, 0 for any number
    TearMesh tearMesh = TearMesh::Vanish;
    Vec3 gravity = Vec3(0.0, -9.80665, 0.0); // m/s^2
    double airDensity = 1.225;               // kg/m^3
    double viscosity = 0.0;                  // 1/s
    double speedLimit = 1000.0;              // m/s
    double safetyFactor = 1.0;               // 1, by which margins lower every strength

    friend bool operator==(const Settings&, const Settings&) = default;
};

using Item = std::variant<Part, Material, Group, Collider, Wind, Control, Probe, Plot>;

} // namespace ripstop
