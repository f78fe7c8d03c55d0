// A cruciform parachute: a square of cloth with an arm on each side; without arms a square one.
//
// With n cells along a side of the square and m along an arm: (n+1)^2 + 4 m (n+1) canopy particles
// and 2 n^2 + 8 m n panels. It is built as it is when it is full: the square level, the arms
// hanging down by `droop`. Lines run from the ends of the arms, or from the rim of the square, to
// the payload, and two rigidity particles hold these ends apart as the air would, and the corners
// of the square.
//
// As for the round parachute, the coefficient of the cloth is chosen such that the drag is that of
// the wanted CD0 on the area of the cloth S0 = w^2 (1 + 4 arms); Knacke 1991, table 5-1, has 0.60
// to 0.85 for cross parachutes. With `pressure` the air in the canopy holds it open and nothing
// else does, and the drag is what comes of it.
//
// Of a cloth that one can buy (builders/craft_materials.h), panels carry the canopy, which is cut
// flat as two strips that cross: the warp along each. Along the rim of the square and of the arms
// runs a hem, of the cloth turned in or of a tape, that pulls only.
#include "builders/craft_materials.h"
#include "builders/descent.h"
#include "builders/designs.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <array>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr auto ownParameters = std::to_array<Parameter>({
    {"cells",         "",       6,      2, 40,    true,  "Cells along each side of the square in the middle.", "Mesh"},
    {"width",         "m",      1.5,    0.1, 20,  false, "Side of the square, and width of the arms.", "Canopy"},
    {"arms",          "",       1,      0, 2,     false, "Length of an arm over the width; 0 is a square canopy without arms."},
    {"droop",         "deg",    50,     0, 80,    false, "How far the arms hang below level when the canopy is full."},
    {"drag",          "",       0.7,    0.05, 2,  false, "Drag coefficient CD0 on the area of the cloth; 0.60 to 0.85 for cross parachutes.", {}, {}, {}, isZero("pressure")},
    {"cloth",         "",       0,      0, canopyCloths.size() - 1, true, "Cloth of the canopy; ideal cloth never stretches and is as heavy and porous as is said below, a real one is carried by panels, wrinkles and does not push.", "Materials", canopyCloths, 1},
    {"cord",          "",       0,      0, canopyCords.size() - 1, true, "What the suspension lines are made of; ideal ones never stretch.", {}, canopyCords, 1},
    {"tape",          "",       0,      0, canopyTapes.size() - 1, true, "What is sewn along the edges of square and arms of real cloth; a hem is the cloth itself, turned in twice over 1 cm.", {}, canopyTapes, {}, isNotZero("cloth")},
    {"grain",         "deg",    0,      0, 90,    false, "Angle between the warp of real cloth and the arm that it is cut for; 45 is a bias cut.", {}, {}, {}, isNotZero("cloth")},
    {"payload",       "kg",     10,     0.01, 2000, false, "Mass that hangs below.", "Load and lines"},
    {"line_length",   "m",      4,      0.2, 60,  false, "From the canopy to the payload; made longer where it would not reach."},
    {"line_segments", "",       4,      1, 40,    true,  "Segments of each suspension line."},
    {"line_density",  "kg/m",   0.002,  1e-5, 0.2, false, "Mass of a line per length.", {}, {}, {}, isZero("cord")},
    {"line_diameter", "m",      0.002,  0, 0.05,  false, "Thickness of a line, which the wind drags."},
    {"fabric",        "kg/m^2", 0.0373, 0.005, 1, false, "Mass of the fabric per area; 0.0373 is parachute nylon MIL-C-7020 type I.", "Fabric", {}, {}, isZero("cloth")},
    {"hoop_mass",     "kg",     0.1,    0.01, 50, false, "Mass of the two particles that hold the canopy open.", {}, {}, {}, isZero("pressure")},
    {"friction",      "",       0.02,   0, 0.5,   false, "Coefficient of the air's force along the fabric."},
    {"altitude",      "m",      100,    1, 5000,  false, "Height of the payload at the start; the density of the air does not follow it, settings.airDensity sets it: 0.736 kg/m^3 at 5000 m in the standard atmosphere.", "Start"},
    {"wind",          "m/s",    0,      0, 30,    false, "Speed of the wind."},
    {"pressure",      "",       0,      0, 4,     false, "Canopy pressure coefficient: the air fills the canopy and holds it open, without a frame, and the drag is what comes of it; 0 has each panel meet the wind by itself.", "Air in the canopy"},
    {"speed",         "m/s",    0,      0, 200,   false, "Sinks this fast at the start."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, patchParameters(canopyPatches, 0.2));

// Rows of n + 1 nodes; row 0 may be nodes that are there already.
using Rows = std::vector<std::vector<Id>>;

// Rods of the cloth, and of what is sewn along the rim of a square or an arm.
struct Threads
{
    Id seams;
    Id hem;
    Resists resists;
};

void weave(Network& network, const Rows& rows, Id cloth, const Threads& threads, bool withFirst)
{
    const auto rod = [&](Id from, Id to, bool onRim) {
        network.rod(from, to, onRim ? threads.hem : threads.seams, threads.resists);
    };
    for (std::size_t row = withFirst ? 0 : 1; row < rows.size(); ++row)
        for (std::size_t i = 1; i < rows[row].size(); ++i)
            rod(rows[row][i - 1], rows[row][i], row == 0 || row + 1 == rows.size());
    for (std::size_t row = 1; row < rows.size(); ++row)
        for (std::size_t i = 0; i < rows[row].size(); ++i) {
            rod(rows[row - 1][i], rows[row][i], i == 0 || i + 1 == rows[row].size());
            if (i == 0)
                continue;
            const Id a = rows[row - 1][i - 1], b = rows[row - 1][i];
            const Id c = rows[row][i - 1], d = rows[row][i];
            const bool leansRight = (row + i) % 2 == 0; // no grain
            rod(leansRight ? a : b, leansRight ? d : c, false);
            network.panel(a, leansRight ? d : b, c, cloth);
            network.panel(leansRight ? a : c, b, d, cloth);
        }
}

struct Canopy
{
    std::vector<Id> ends;    // where lines are tied
    std::vector<Id> corners; // of the square, where it has arms
};

Canopy addCanopy(Network& network, const Parameters& p, const CanopyMaterials& materials,
                 const Threads& threads)
{
    const int n = int(p.at("cells"));
    const int m = int(std::lround(p.at("arms") * n));
    const double width = p.at("width");
    const double droop = p.at("droop") * degrees;
    const double arm = m > 0 ? p.at("arms") * width / m : 0.0; // m, of one cell
    const auto node = [&](double x, double y, double z) {
        const Id id = network.particle({x, y, z});
        const double whole = width * (1.0 + 2.0 * p.at("arms"));
        network.texture(id, 0.5 + x / whole, 0.5 + z / whole);
        return id;
    };
    Rows square;
    for (int row = 0; row <= n; ++row) {
        square.emplace_back();
        for (int i = 0; i <= n; ++i)
            square.back().push_back(
                node((double(i) / n - 0.5) * width, 0.0, (double(row) / n - 0.5) * width));
    }
    weave(network, square, materials.cloth[0], threads, true);

    // the four sides, in turn, each as one sees it from outside from left to right
    std::vector<Id> ends;
    for (int side = 0; side < 4; ++side) {
        Rows rows(1);
        for (int i = 0; i <= n; ++i) {
            const int j = n - i;
            const std::array<Id, 4> nodes{square[std::size_t(n)][std::size_t(i)],
                                          square[std::size_t(j)][std::size_t(n)],
                                          square[0][std::size_t(j)], square[std::size_t(i)][0]};
            rows[0].push_back(nodes[std::size_t(side)]);
        }
        const std::array<Vec3, 4> outs{Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitZ(),
                                       -Vec3::UnitX()};
        const Vec3 along =
            std::cos(droop) * outs[std::size_t(side)] - std::sin(droop) * Vec3::UnitY();
        for (int row = 1; row <= m; ++row) {
            std::vector<Id> next;
            for (const Id above : rows[0]) {
                const Vec3 place = network.position(above) + row * arm * along;
                next.push_back(node(place.x(), place.y(), place.z()));
            }
            rows.push_back(std::move(next));
        }
        weave(network, rows, materials.cloth[1], threads, false);
        const std::vector<Id>& last = rows.back();
        // corners of a square canopy belong to two sides
        ends.insert(ends.end(), last.begin() + (m == 0 ? 1 : 0), last.end());
    }
    Canopy canopy{ends, {}};
    if (m > 0)
        for (const std::vector<Id>* row : {&square.front(), &square.back()})
            canopy.corners.insert(canopy.corners.end(), {row->front(), row->back()});
    return canopy;
}

Id addPayload(Network& network, const std::vector<Id>& ends, const Parameters& p,
              const CanopyMaterials& materials)
{
    double reach = 0.0; // m, of the ends from the axis
    for (const Id end : ends)
        reach = std::max(reach, std::hypot(network.position(end).x(), network.position(end).z()));
    const double level = network.position(ends.front()).y();
    const double length = std::max(p.at("line_length"), 1.05 * reach);
    const double depth = std::sqrt(length * length - reach * reach);
    const Id payload = network.particle({0.0, level - depth, 0.0}, p.at("payload"));
    for (const Id end : ends) {
        const double own = (network.position(end) - network.position(payload)).norm();
        network.line(end, payload, int(p.at("line_segments")), own * cordDensity(p, canopyChoices),
                     materials.lines, Resists::Tension);
    }
    return payload;
}

// Cuts and weighs real cloth: the warp along the strip, or at the grain to it. The strip along z
// goes through the square.
void cut(Network& network, const Parameters& p, Id hem)
{
    const double half = 0.5 * p.at("width");
    const double grain = p.at("grain") * degrees;
    network.carryByPanels([&](const Vec3& middle) -> Vec3 {
        const bool alongX = std::abs(middle.x()) > half;
        const Vec3 along = alongX ? Vec3::UnitX() : Vec3::UnitZ();
        const Vec3 across = alongX ? Vec3::UnitZ() : Vec3::UnitX();
        return std::cos(grain) * along + std::sin(grain) * across;
    });
    network.addFabricMass(clothDensity(p, canopyChoices));
    network.addLinkMass(hem, hemDensity(p, canopyChoices));
}

// Bends a flat square into a bowl, along whose meridians the cloth is as long as it is cut, so that
// it has an inside that air can fill.
void hollow(Network& network, const std::vector<Id>& canopy, double width)
{
    const double radius = width / 1.2; // m: the corners hang down by 0.85 rad
    for (const Id id : canopy) {
        Vec3& place = network.row(id).position;
        const double reach = std::hypot(place.x(), place.z());
        const double polar = reach / radius;
        const double share = reach > 0.0 ? radius * std::sin(polar) / reach : 1.0;
        place = {share * place.x(), radius * (std::cos(polar) - 1.0), share * place.z()};
    }
}

// The hubs that hold the canopy open where no air does.
std::vector<Id> addHubs(Network& network, const std::vector<Id>& held, const Parameters& p,
                        const CanopyMaterials& materials)
{
    constexpr bool isTied = true; // no cloth runs from arm to arm
    return addHoop(network, held, 0.75 * p.at("width"), p.at("hoop_mass"), materials.frame, isTied);
}

Result<Scene> buildCrossParachute(const Parameters& p)
{
    Scene scene;
    const bool holdsAir = p.at("pressure") > 0.0;
    const bool isReal = !isIdeal(p, "cloth");
    scene.settings.title = p.at("arms") > 0.0 ? "Cruciform parachute" : "Square parachute";
    scene.settings.notes = holdsAir ? "Air fills the canopy and holds it open."
                                    : "The payload sinks at sqrt(2 m g / (rho CD0 S0)).";
    addGround(scene);
    addWind(scene, Vec3(p.at("wind"), 0.0, 0.0));
    const CanopyMaterials materials =
        addCanopyMaterials(scene, p, {}, {"square", "arms"}, {"#f2f0e6", "#3a7ca5"});

    CraftMaterials craft;
    craft.cloth = {materials.cloth.begin(), materials.cloth.end()};
    craft.seams = {materials.seams};
    craft.lines = {materials.lines};
    if (isReal) {
        Material hem;
        hem.name = "hem";
        hem.color = "#b5b2a6";
        craft.hems = {addItem(scene, hem)};
    }

    Network network(scene, "parachute");
    const Threads threads{materials.seams, isReal ? craft.hems[0] : materials.seams,
                          isReal || holdsAir ? Resists::Tension : Resists::Both};
    const auto [ends, corners] = addCanopy(network, p, materials, threads);
    std::vector<Id> canopy;
    for (const Particle& row : network.part().particles)
        canopy.push_back(row.id);
    std::vector<Id> held = ends;
    held.insert(held.end(), corners.begin(), corners.end());
    if (isReal)
        cut(network, p, craft.hems[0]);
    else
        network.addFabricMass(p.at("fabric"));
    const Result<std::vector<Id>> patches = addPatches(p, held, scene, network, canopyChoices);
    if (!patches)
        return patches.failure();
    craft.patches = *patches;
    if (holdsAir && corners.empty())
        hollow(network, canopy, p.at("width"));
    const int n = int(p.at("cells"));
    const double arms = std::lround(p.at("arms") * n) > 0 ? p.at("arms") : 0.0;
    if (!holdsAir)
        setDrag(scene, network, craft.allCloth(), p.at("drag"),
                p.at("width") * p.at("width") * (1.0 + 4.0 * arms));
    const std::size_t firstLineRod = network.part().links.size();
    const Id payload = addPayload(network, ends, p, materials);
    const Id lineRod = network.part().links[firstLineRod].id;
    std::vector<Id> hubs;
    if (!holdsAir)
        hubs = addHubs(network, held, p, materials);
    makeOf(p, craft, scene, network, canopyChoices);
    network.place(Eigen::Matrix3d::Identity(),
                  {0.0, p.at("altitude") - network.position(payload).y(), 0.0},
                  {0.0, 0.0 - p.at("speed"), 0.0}); // no -0 in files

    addGroup(scene, "canopy", canopy);
    addGroup(scene, "skirt", ends);
    addGroup(scene, "rigidity", hubs);
    addGroup(scene, "payload", {payload});
    const Id part = network.finish("cross_parachute", p);
    std::get<Part>(*findItem(scene, part)).canopyPressure = p.at("pressure");
    addProbe(scene, "height", Quantity::PositionY, payload);
    addProbe(scene, "sink rate", Quantity::SinkRate, part);
    addProbe(scene, "air force", Quantity::AirForce, part);
    addProbe(scene, "line tension", Quantity::Tension, lineRod);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    if (holdsAir)
        addProbe(scene, "canopy pressure", Quantity::CanopyPressure, part);
    return scene;
}

} // namespace

const Builder crossParachuteBuilder{"cross_parachute",
                                    "Cruciform or square parachute",
                                    "A square of cloth with four arms, or without, over a payload.",
                                    parameters,
                                    buildCrossParachute,
                                    Family::Canopies};

} // namespace ripstop
