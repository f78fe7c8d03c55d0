// Cloth and spars that bend far, by default and on two meshes each.
//
// In order: strips of cloth that hang over an edge by their weight, are bent to an arc by their
// clamps or have buckled between hinges (RF-16), and the 4 mm carbon rod as a cantilever with a
// load at its tip (RF-17), as a column that has buckled (RF-18) and strung to a bow (RF-19).
// Expected numbers are those of the inextensible elastica. Viscosity, which changes nothing of
// where they end, brings them to rest.
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "verify/at_rest.h"
#include "verify/flat_cloth.h"
#include "verify/sections.h"
#include "verify/small_systems.h"
#include "verify/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// --- strips that hang over an edge ------------------------------------------------------------

struct Overhang
{
    double drop = 0.0;  // 1, of the tip, over the length
    double reach = 0.0; // 1, level distance of the tip from the edge
};

enum class Pushed { Wrinkles, Resists };

// A strip of 0.2 m whose weight w and stiffness B make w L^3 / B = `heaviness`. A column of cells
// before the edge holds it. Its weight pulls on it everywhere: what it does when it is pushed must
// not matter.
Overhang overhang(double heaviness, int cells, Pushed pushed)
{
    constexpr double length = 0.2, density = 0.2; // m, kg/m^2
    constexpr int across = 2;
    const double cell = length / cells;
    Material cloth = isotropic(1e4, 0.0);
    cloth.resistsPushing = pushed == Pushed::Resists;
    cloth.bendingStiffness = density * standardGravity * length * length * length / heaviness;
    Scene scene =
        sceneOf(rectangle(length + cell, across * cell, cells + 1, across), cloth, 0.0, density);
    scene.settings.gravity = Vec3(0.0, 0.0, -standardGravity);
    const double slowest =
        3.516 * std::sqrt(cloth.bendingStiffness / (density * std::pow(length, 4))); // 1/s
    scene.settings.viscosity = 2.0 * slowest;
    for (Particle& particle : particlesOf(scene))
        particle.pinned = particle.position.x() < 1.5 * cell;
    const AtRest rest = restOf(scene, 14.0 / slowest);
    Overhang result;
    for (int row = 0; row <= across; ++row) {
        const Vec3 tip = rest.state.position[std::size_t((row + 1) * (cells + 2) - 1)];
        result.drop -= tip.z() / length / (across + 1);
        result.reach += (tip.x() - cell) / length / (across + 1);
    }
    return result;
}

void addOverhangs(std::vector<Case>& cases)
{
    struct Row
    {
        double heaviness, drop, reach; // 1
    };
    for (const Row& known :
         {Row{1.0, 0.12347, 0.99125}, Row{8.0, 0.64063, 0.72443}, Row{20.0, 0.82988, 0.44523}})
        for (const int cells : {10, 20})
            for (const Pushed pushed : {Pushed::Wrinkles, Pushed::Resists}) {
                const auto strip = shared([=] { return overhang(known.heaviness, cells, pushed); });
                const std::string title =
                    (pushed == Pushed::Wrinkles ? "strip over an edge, w L^3 / B = "
                                                : "strip that resists pushing, w L^3 / B = ")
                    + digits(known.heaviness, 3) + ", " + std::to_string(cells) + " cells, ";
                cases.push_back({"RF-16", title + "drop over length", known.drop, relative(0.02),
                                 "", "heavy elastica", [=] { return strip().drop; }});
                cases.push_back({"RF-16", title + "reach over length", known.reach, relative(0.02),
                                 "", "heavy elastica", [=] { return strip().reach; }});
            }
}

// --- a strip between clamps that are turned -----------------------------------------------------

// A strip of 0.2 m without weight, held by a column of cells at either end. The clamps are turned
// so that it is an arc of a circle, the shape without a force along it, as long as it was at rest.
// What it is long then, over that. A force of 1 N/m along it would show; B over the square of the
// radius is 0.1 N/m at most.
double lengthOfArc(double degrees, int cells)
{
    constexpr double length = 0.2, density = 0.2; // m, kg/m^2
    constexpr int across = 2;
    const double cell = length / cells;
    Material cloth = isotropic(1e4, 0.0);
    cloth.bendingStiffness = 1e-3;
    Scene scene = sceneOf(rectangle(length + 2.0 * cell, across * cell, cells + 2, across), cloth,
                          0.0, density);
    const double slowest =
        std::sqrt(cloth.bendingStiffness / density) * std::pow(std::numbers::pi / length, 2); // 1/s
    scene.settings.viscosity = 2.0 * slowest;
    std::vector<Particle>& particles = particlesOf(scene);
    for (Particle& particle : particles)
        particle.pinned =
            particle.position.x() < 1.5 * cell || particle.position.x() > length + 0.5 * cell;
    const std::shared_ptr<const System> system = *compile(scene);
    // each cell is a chord, and turns by as much as it does at the clamps' own
    const double turn = degrees * std::numbers::pi / 180.0 / cells;
    const double radius = 0.5 * cell / std::sin(0.5 * turn);
    State start = system->start;
    for (PaddedVec3& x : start.position) {
        const double angle = turn * x.x() / cell;
        x = Vec3(radius * std::sin(angle), x.y(), radius * (1.0 - std::cos(angle)));
    }
    const AtRest rest = restOf(system, start, 14.0 / slowest);
    double sum = 0.0;
    for (int row = 0; row <= across; ++row)
        for (int i = 1; i <= cells; ++i) {
            const auto at = std::size_t(row * (cells + 3) + i);
            sum += (rest.state.position[at + 1] - rest.state.position[at]).norm();
        }
    return sum / length / (across + 1);
}

void addArcs(std::vector<Case>& cases)
{
    for (const double degrees : {60.0, 120.0})
        for (const int cells : {10, 20})
            cases.push_back({"RF-16",
                             "strip bent to an arc of " + digits(degrees, 3) + " degrees, "
                                 + std::to_string(cells) + " cells, length",
                             1.0, relative(1e-4), "", "an arc has no force along it",
                             [=] { return lengthOfArc(degrees, cells); }});
}

// --- what has buckled between hinges -----------------------------------------------------------

struct Buckled
{
    double slope, push, shortening, rise; // degrees at the ends, 1 over Euler's, 1, 1 over length
};

constexpr Buckled buckledRows[] = {{20.0, 1.01540, 0.03027, 0.10971},
                                   {40.0, 1.06366, 0.11880, 0.21112},
                                   {60.0, 1.15172, 0.25898, 0.29660},
                                   {90.0, 1.39320, 0.54305, 0.38138}};
constexpr char sourceOfBuckled[] = "elastica; Timoshenko and Gere 1961, 2.7";

// An arc of a circle as long as 1, over a chord along x from the origin: z is its height.
struct Arc
{
    double half; // rad, of the angle

    explicit Arc(double chord)
    {
        double low = 1e-6, high = std::numbers::pi;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (std::sin(middle) / middle > chord ? low : high) = middle;
        }
        half = low;
    }

    Vec3 at(double share) const // of its length
    {
        const double angle = half * (2.0 * share - 1.0), radius = 0.5 / half;
        return {radius * (std::sin(half) + std::sin(angle)), 0.0,
                radius * (std::cos(angle) - std::cos(half))};
    }
};

// A strip of cloth without weight whose ends have come nearer to each other by this share of its
// length. Its panels give way to a push, but folds as short as they are cost more than the bow of
// the whole.
double riseOfCloth(double shortening, int cells)
{
    constexpr double length = 0.2, density = 0.2; // m, kg/m^2
    constexpr int across = 2;
    Material cloth = isotropic(1e4, 0.0);
    cloth.bendingStiffness = 1e-3;
    Scene scene =
        sceneOf(rectangle(length, across * length / cells, cells, across), cloth, 0.0, density);
    const double slowest =
        std::sqrt(cloth.bendingStiffness / density) * std::pow(std::numbers::pi / length, 2); // 1/s
    scene.settings.viscosity = 2.0 * slowest;
    for (Particle& particle : particlesOf(scene)) {
        const double share = particle.position.x() / length;
        particle.pinned = share < 1e-3 || share > 1.0 - 1e-3;
    }
    const std::shared_ptr<const System> system = *compile(scene);
    const Arc arc(1.0 - shortening);
    State start = system->start;
    for (PaddedVec3& x : start.position)
        x = length * arc.at(x.x() / length) + Vec3(0.0, x.y(), 0.0);
    const AtRest rest = restOf(system, start, 40.0 / slowest);
    double sum = 0.0;
    for (int row = 0; row <= across; ++row)
        sum += rest.state.position[std::size_t(row * (cells + 1) + cells / 2)].z();
    return sum / length / (across + 1);
}

void addBuckledCloth(std::vector<Case>& cases)
{
    for (const Buckled& known : buckledRows)
        for (const int cells : {20, 40})
            if (known.slope < 70.0)
                cases.push_back({"RF-16",
                                 "strip of cloth buckled between hinges, ends at "
                                     + digits(known.slope, 3) + " degrees, " + std::to_string(cells)
                                     + " cells, rise over length",
                                 known.rise, relative(0.01), "", sourceOfBuckled,
                                 [=] { return riseOfCloth(known.shortening, cells); }});
}

// --- a carbon rod of 4 mm ---------------------------------------------------------------------

constexpr double rigidity = 1.54;   // N m^2, measured
constexpr double axial = 1508e3;    // N
constexpr double perMetre = 0.0195; // kg/m

// A straight rod along x from the origin, without weight; its scene is made ready by `finish`.
struct RodScene
{
    Scene scene;
    Network network;
    std::vector<Id> nodes;

    RodScene(double length, int links, double slowest)
        : scene(calm(slowest))
        , network(scene, "rod")
    {
        Material carbon;
        carbon.axialStiffness = axial;
        carbon.flexuralRigidity = rigidity;
        const Id material = addItem(scene, carbon);
        const Id from = network.particle(Vec3::Zero());
        const Id to = network.particle(Vec3(length, 0.0, 0.0));
        nodes = network.line(from, to, links, perMetre * length, material, Resists::Both);
    }

    static Scene calm(double slowest) // 1/s, the lowest angular frequency
    {
        Scene scene;
        scene.settings.airDensity = 0.0;
        scene.settings.gravity = Vec3::Zero();
        scene.settings.viscosity = 2.0 * slowest;
        return scene;
    }

    // The place of each node is known from here on by its key.
    std::shared_ptr<const System> system()
    {
        network.finish({}, {});
        return *compile(scene);
    }
};

std::size_t indexOf(const System& system, Id id)
{
    return std::size_t(std::ranges::find(system.key, Key(id)) - system.key.begin());
}

struct Tip
{
    double drop = 0.0;   // m
    double nearer = 0.0; // m, how much nearer to the clamp, along the rod
};

// Clamped by one link before it, whose ends are pinned; a kilometre of soft spring pulls with the
// same force wherever the tip goes.
Tip cantilever(double load, int links) // N
{
    constexpr double length = 0.8; // m
    constexpr double far = 1000.0; // m
    const double cell = length / links;
    const double slowest = 3.516 * std::sqrt(rigidity / (perMetre * std::pow(length, 4)));
    RodScene rod(length + cell, links + 1, slowest);
    rod.network.row(rod.nodes[0]).pinned = rod.network.row(rod.nodes[1]).pinned = true;
    const Id tip = rod.nodes.back();
    const Id anchor = rod.network.particle(rod.network.position(tip) - Vec3(0.0, far, 0.0), 1.0);
    rod.network.row(anchor).pinned = true;
    Material elastic;
    elastic.stiffness = load / far;
    rod.network.spring(tip, anchor, addItem(rod.scene, elastic));
    rod.network.setRestLength(0.0);
    const auto system = rod.system();
    const AtRest rest = restOf(system, system->start, 20.0 / slowest);
    const Vec3 place = rest.state.position[indexOf(*system, tip)];
    return {-place.y(), length + cell - place.x()};
}

void addCantilevers(std::vector<Case>& cases)
{
    constexpr double length = 0.8;
    struct Row
    {
        double a, drop, nearer; // 1: P L^2 / EI, over the length
    };
    for (const Row& known :
         {Row{1.0, 0.30172, 0.05643}, Row{5.0, 0.71379, 0.38763}, Row{10.0, 0.81061, 0.55500}})
        for (const int links : {20, 40}) {
            const auto rod =
                shared([=] { return cantilever(known.a * rigidity / (length * length), links); });
            const std::string title =
                "carbon rod, load at the tip, P L^2 / EI = " + digits(known.a, 3) + ", "
                + std::to_string(links) + " links, ";
            cases.push_back({"RF-17", title + "drop over length", known.drop, relative(0.01), "",
                             "Bisshopp and Drucker 1945; Mattiasson 1981",
                             [=] { return rod().drop / length; }});
            cases.push_back({"RF-17", title + "shortening over length", known.nearer,
                             relative(0.01), "", "Bisshopp and Drucker 1945; Mattiasson 1981",
                             [=] { return rod().nearer / length; }});
        }
    for (const int links : {20, 40})
        cases.push_back(
            {"RF-17",
             "carbon rod of 0.8 m, 5 N at the tip, " + std::to_string(links) + " links, drop",
             0.40346, relative(0.01), "m", "Bisshopp and Drucker 1945",
             [=] { return cantilever(5.0, links).drop; }});
}

// Puts the rod on an arc of a circle over a chord along x. It was built straight, and straight it
// wants to be.
State arched(const System& system, const std::vector<Id>& nodes, double length, double chord)
{
    const Arc arc(chord / length);
    State state = system.start;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3 at = length * arc.at(double(i) / double(nodes.size() - 1));
        state.position[indexOf(system, nodes[i])] = Vec3(at.x(), at.z(), 0.0);
    }
    return state;
}

double pinnedFrequency(double length) // 1/s, of a beam on two hinges
{
    return std::pow(std::numbers::pi / length, 2.0) * std::sqrt(rigidity / perMetre);
}

struct Arch
{
    double push = 0.0; // N, along the chord
    double rise = 0.0; // m
};

// Hinged ends nearer to each other than the rod is long.
Arch buckled(double shortening, int links) // 1
{
    constexpr double length = 0.8; // m
    RodScene rod(length, links, pinnedFrequency(length));
    rod.network.row(rod.nodes.front()).pinned = rod.network.row(rod.nodes.back()).pinned = true;
    const auto system = rod.system();
    const AtRest rest =
        restOf(system, arched(*system, rod.nodes, length, length * (1.0 - shortening)),
               40.0 / pinnedFrequency(length));
    // Hinges push along the chord. A link there carries the part along itself, but for a share of
    // its bend that is of second order in its length; the rest is shear, of the bends.
    const auto at = [&](int node) -> Vec3 {
        return rest.state.position[indexOf(*system, rod.nodes[std::size_t(node)])];
    };
    return {-tensions(*rest.system, rest.state)[0] / (at(1) - at(0)).normalized().x(),
            at(links / 2).y()};
}

void addColumns(std::vector<Case>& cases)
{
    constexpr double length = 0.8;
    const double euler = std::pow(std::numbers::pi / length, 2.0) * rigidity; // N
    for (const Buckled& known : buckledRows)
        for (const int links : {20, 40}) {
            const auto rod = shared([=] { return buckled(known.shortening, links); });
            const std::string title = "buckled carbon rod, ends at " + digits(known.slope, 3)
                                      + " degrees, " + std::to_string(links) + " links, ";
            if (known.slope < 50.0) // the link at a hinge tells the push of flat arches only
                cases.push_back({"RF-18", title + "push over Euler's", known.push, relative(0.01),
                                 "", sourceOfBuckled, [=] { return rod().push / euler; }});
            cases.push_back({"RF-18", title + "rise over length", known.rise, relative(0.01), "",
                             sourceOfBuckled, [=] { return rod().rise / length; }});
        }
}

struct Bow
{
    double pull = 0.0;  // N, in the string
    double rise = 0.0;  // m
    double slope = 0.0; // degrees, of the last link
};

// 1.2 m of rod, strung to 1.0 m.
Bow bow(int links)
{
    constexpr double length = 1.2, chord = 1.0; // m
    RodScene rod(length, links, pinnedFrequency(length));
    rod.network.row(rod.nodes.front()).pinned = true;
    Material line;
    line.axialStiffness = 43197.0; // 1 mm of Dyneema
    rod.network.rod(rod.nodes.front(), rod.nodes.back(), addItem(rod.scene, line),
                    Resists::Tension);
    rod.network.setRestLength(chord);
    const auto system = rod.system();
    const AtRest rest =
        restOf(system, arched(*system, rod.nodes, length, chord), 40.0 / pinnedFrequency(length));
    const auto at = [&](std::size_t node) -> Vec3 {
        return rest.state.position[indexOf(*system, rod.nodes[node])];
    };
    const Vec3 string = (at(std::size_t(links)) - at(0)).normalized();
    const Vec3 middle = at(std::size_t(links / 2)) - at(0), first = (at(1) - at(0)).normalized();
    return {tensions(*rest.system, rest.state).back(),
            (middle - middle.dot(string) * string).norm(),
            std::acos(first.dot(string)) * 180.0 / std::numbers::pi};
}

void addBows(std::vector<Case>& cases)
{
    for (const int links : {20, 40}) {
        const auto strung = shared([=] { return bow(links); });
        const std::string title =
            "carbon rod of 1.2 m strung to 1 m, " + std::to_string(links) + " links, ";
        const auto row = [&](const char* what, double expected, const char* unit, auto measure) {
            cases.push_back(
                {"RF-19", title + what, expected, relative(0.01), unit, sourceOfBuckled, measure});
        };
        row("string", 11.526, "N", [=] { return strung().pull; });
        row("rise", 0.2952, "m", [=] { return strung().rise; });
        row("slope at its ends", 47.63, "deg", [=] { return strung().slope; });
    }
}

} // namespace

std::vector<Case> elasticaCases()
{
    std::vector<Case> cases;
    addOverhangs(cases);
    addArcs(cases);
    addBuckledCloth(cases);
    addCantilevers(cases);
    addColumns(cases);
    addBows(cases);
    return cases;
}

} // namespace ripstop
