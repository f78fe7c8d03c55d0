// A round parachute (Beaudry, Egli, Patenaude 2005, section 8).
//
// A flat circular canopy of nominal diameter D0, in the shape that it takes when it is full: a
// spherical cap whose arc is D0 long and whose mouth is `fullness` D0 wide. With 6 rings and 24
// sectors: 1 + 6 S = 145 particles, 17 S = 408 rods, 11 S = 264 panels, then S lines and the
// payload. With a vent the first row of nodes is its rim: 1 + 7 S particles. A hem runs around
// it, and lines that go on where the seams between the gores end cross it, tied where they meet.
// The paper holds the mouth open with a hoop: two virtual particles tied to the whole skirt, which
// makes a rigid double pyramid of 3 S rods.
//
// The air law's coefficient is chosen such that the drag is that of the wanted coefficient CD0 on
// the nominal area: Cn sum(A ny^2) = CD0 pi D0^2 / 4, less the vent. The payload then sinks at
// v = sqrt(2 m g / (rho CD0 S0)) (Knacke 1991, page 5-128).
//
// With `pressure` the canopy is cut as it is sewn, a flat disc of cloth whose threads resist
// tension only, so that it can fold, and holds the air that comes in by its mouth
// (forces/canopy_air.h). It starts in the shape of above, which has the width of a full canopy, or
// as a tube in folds with a round crown. Its air is at no pressure then: it has met no wind yet.
//
// Of a cloth that one can buy (builders/craft_materials.h), panels carry the canopy, cut as it is
// sewn: the warp along the middle of each gore, or at an angle to it. Skirt and seams between the
// gores are rods that pull only, of the cloth turned in or of a tape sewn into it. Nothing of it
// pushes, so it stays open by the air in it alone, or by the hoop.
#include "builders/craft_materials.h"
#include "builders/descent.h"
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr auto ownParameters = std::to_array<Parameter>({
    {"rings",         "",       6,      2, 40,    true,  "Rings of fabric from the apex to the skirt.", "Mesh"},
    {"sectors",       "",       24,     6, 120,   true,  "Gores, and suspension lines."},
    {"hoop",          "",       1,      0, 1,     true,  "1 holds the skirt open with a rigid hoop where there is no canopy pressure, 0 leaves it to the air.", {}, {}, {}, isZero("pressure")},
    {"diameter",      "m",      5,      0.3, 60,  false, "Nominal diameter D0: that of the canopy laid out flat.", "Canopy"},
    {"fullness",      "",       0.67,   0.5, 0.95, false, "Width of the open mouth over the nominal diameter; 0.67 to 0.70 for flat circular canopies."},
    {"vent_diameter", "m",      0,      0, 12,    false, "Diameter of the hole in the crown, laid out flat, with lines across it; 5 to 10 % of the nominal diameter are usual and half of it is the most, 0 has none."},
    {"drag",          "",       0.775,  0.05, 2,  false, "Drag coefficient CD0 on the nominal area; 0.75 to 0.80 for flat circular canopies.", {}, {}, {}, isZero("pressure")},
    {"cloth",         "",       0,      0, canopyCloths.size() - 1, true, "Cloth of the canopy; ideal cloth never stretches and is as heavy and porous as is said below, a real one is carried by panels, wrinkles and does not push.", "Materials", canopyCloths, 1},
    {"cord",          "",       0,      0, canopyCords.size() - 1, true, "What the suspension lines are made of; ideal ones never stretch.", {}, canopyCords, 1},
    {"tape",          "",       0,      0, canopyTapes.size() - 1, true, "What is sewn into the skirt, the rim of a vent and onto the seams between the gores of real cloth; a hem is the cloth itself, turned in twice over 1 cm.", {}, canopyTapes, {}, isNotZero("cloth")},
    {"grain",         "deg",    0,      0, 90,    false, "Angle between the warp of real cloth and the middle of its gore; 45 is a bias cut.", {}, {}, {}, isNotZero("cloth")},
    {"payload",       "kg",     25,     0.01, 2000, false, "Mass that hangs below.", "Load and lines"},
    {"line_length",   "m",      4.5,    0.3, 60,  false, "From the skirt to the payload; 0.8 to 1 nominal diameter is usual."},
    {"line_segments", "",       4,      1, 40,    true,  "Segments of each suspension line."},
    {"line_density",  "kg/m",   0.004,  1e-5, 0.2, false, "Mass of a line per length.", {}, {}, {}, isZero("cord")},
    {"line_diameter", "m",      0.003,  0, 0.05,  false, "Thickness of a line, which the wind drags."},
    {"fabric",        "kg/m^2", 0.0373, 0.005, 1, false, "Mass of the fabric per area; 0.0373 is parachute nylon MIL-C-7020 type I.", "Fabric", {}, {}, isZero("cloth")},
    {"hoop_mass",     "kg",     0.4,    0.01, 50, false, "Mass of the hoop.", {}, {}, {}, isNotZero("hoop")},
    {"equal_masses",  "",       0,      0, 1,     true,  "1 gives all particles but the payload the same mass, as the paper on kites did; 0 weighs cloth, lines and hoop where they are."},
    {"friction",      "",       0.02,   0, 0.5,   false, "Coefficient of the air's force along the fabric."},
    {"altitude",      "m",      150,    1, 5000,  false, "Height of the payload at the start; the density of the air does not follow it, settings.airDensity sets it: 0.736 kg/m^3 at 5000 m in the standard atmosphere.", "Start"},
    {"wind",          "m/s",    0,      0, 30,    false, "Speed of the wind."},
    {"pressure",      "",       0,      0, 4,     false, "Canopy pressure coefficient, 1.68 for round canopies: the air fills the canopy and holds it open, without a hoop, and the drag is what comes of it; 0 has each panel meet the wind by itself.", "Air in the canopy", {}, 1.68},
    {"mouth",         "",       0,      0, 0.6,   false, "Width of the mouth at the start over the nominal diameter, the cloth in folds, with canopy pressure only; 0 starts in the shape of a full canopy. The wind brings the pressure.", {}, {}, {}, isNotZero("pressure")},
    {"porosity",      "",       0,      0, 0.5,   false, "Porosity of ideal cloth; about 0.03 for parachute nylon. Real cloth has its own.", {}, {}, {}, isZero("cloth")},
    {"speed",         "m/s",    0,      0, 200,   false, "Sinks this fast at the start."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, patchParameters(canopyPatches, 0.4));

// m, of the vent; a larger one would leave no canopy.
double ventOf(const Parameters& p)
{
    return std::min(p.at("vent_diameter"), 0.5 * p.at("diameter"));
}

// Half the angle that the cap spans at its centre: sin(a) / a = fullness.
double capAngle(double fullness)
{
    return root([&](double a) { return std::sin(a) / a - fullness; }, 0.01, 3.0);
}

// m, twice from the apex to the skirt along the flat cloth. Gores are triangles, whose polygon is
// smaller than the disc around it; of real cloth it has the area of the nominal diameter, which
// defines that (Knacke 1991), so that it is the same canopy at any number of gores.
double laidOut(const Parameters& p)
{
    const double gore = 2.0 * pi / p.at("sectors");
    return isIdeal(p, "cloth") ? p.at("diameter")
                               : p.at("diameter") * std::sqrt(gore / std::sin(gore));
}

// Length at the start over that of the cloth. A gore is shorter along its middle than along its
// seams, and folded up between them it is sheared as well. With less than this, seams that are as
// long as they were cut pull their cloth by a percent or two before anything has moved.
double slackOfGores(double sectors)
{
    const double middle = std::cos(pi / sectors); // over the length of a seam
    return middle * middle;
}

// Nodes of a polar mesh: the first is the apex, which all gores share, or with a vent the crossing
// of the lines over it; then rings from the apex, or the rim of the vent, to the skirt.
class Canopy
{
public:
    Canopy(Network& network, const Parameters& p)
        : m_rings(int(p.at("rings")))
        , m_sectors(int(p.at("sectors")))
        , m_hasVent(p.at("vent_diameter") > 0.0)
    {
        const double vent = ventOf(p) / p.at("diameter"); // 1
        const double angle = capAngle(p.at("fullness"));
        const double diameter = laidOut(p);
        const double radius = 0.5 * diameter / angle;
        const bool folded = p.at("pressure") > 0.0;
        m_radius = folded ? 0.0 : radius;
        const double slack = folded && !isIdeal(p, "cloth") ? slackOfGores(m_sectors) : 1.0;
        // `steps` rings from the apex, along the cloth
        const auto addNode = [&](double steps, int sector, bool isOnAxis) {
            const double polar = angle * steps / m_rings;
            const double turn = 2.0 * pi * sector / m_sectors;
            const Vec3 out(std::cos(turn), 0.0, std::sin(turn));
            const double reach = 0.5 * steps / m_rings;
            const double along = reach * diameter;
            const Vec3 full = radius * (std::sin(polar) * out + std::cos(polar) * Vec3::UnitY());
            const Vec3 start = p.at("mouth") > 0.0
                                   ? tube(0.5 * p.at("mouth") * diameter, slack * along, out)
                                   : Vec3(slack * full);
            const auto placed = [&](const Vec3& place) {
                return isOnAxis ? Vec3(0.0, place.y(), 0.0) : place;
            };
            const double drawn = isOnAxis ? 0.0 : reach;
            const Id node = network.particle(placed(folded ? Vec3(along * out) : full));
            network.texture(node, 0.5 + drawn * out.x(), 0.5 + drawn * out.z());
            m_nodes.push_back(node);
            m_start.push_back(placed(start));
        };
        const double rim = vent * m_rings; // 0 without a vent: then it is the apex
        addNode(rim, 0, true);
        for (int ring = m_hasVent ? 0 : 1; ring <= m_rings; ++ring)
            for (int sector = 0; sector < m_sectors; ++sector)
                addNode(rim + (1.0 - vent) * ring, sector, false);
        m_resists = folded || !isIdeal(p, "cloth") ? Resists::Tension : Resists::Both;
    }

    // From where it is cut to where it starts.
    void shape(Network& network) const
    {
        for (std::size_t i = 0; i < m_nodes.size(); ++i)
            network.row(m_nodes[i]).position = m_start[i];
    }

    // Has panels carry the cloth as it is cut, with the warp at the angle `grain`, rad, to the
    // middle of their gore.
    void cut(Network& network, double grain) const
    {
        network.carryByPanels([&](const Vec3& middle) -> Vec3 {
            const double gore = 2.0 * pi / m_sectors;
            const double turn = std::floor(std::atan2(middle.z(), middle.x()) / gore) * gore;
            const double half = turn + 0.5 * gore;
            const Vec3 out(std::cos(half), 0.0, std::sin(half));
            const Vec3 around(-std::sin(half), 0.0, std::cos(half));
            // from the apex to the skirt, which is down where the cap is steep
            const double reach = std::hypot(middle.x(), middle.z());
            const double polar = m_radius > 0.0 ? std::atan2(reach, middle.y()) : 0.0;
            const Vec3 along = std::cos(polar) * out - std::sin(polar) * Vec3::UnitY();
            return std::cos(grain) * along + std::sin(grain) * around;
        });
    }

    Id at(int ring, int sector) const
    {
        const int row = m_hasVent ? ring : ring - 1;
        return row < 0 ? m_nodes[0]
                       : m_nodes[1 + row * m_sectors + (sector + m_sectors) % m_sectors];
    }
    const std::vector<Id>& nodes() const { return m_nodes; }
    std::vector<Id> skirt() const { return {m_nodes.end() - m_sectors, m_nodes.end()}; }

    // `seam` and `skirt` are what is sewn along the gores, and around the mouth and the vent.
    void weave(Network& network, const CanopyMaterials& materials, Id seam, Id skirt) const
    {
        for (int ring = 1; ring <= m_rings; ++ring)
            for (int sector = 0; sector < m_sectors; ++sector) {
                const Id cloth = materials.cloth[sector % 2];
                const Id a = at(ring, sector);
                const Id b = at(ring, sector + 1);
                const Id c = at(ring - 1, sector);
                const Id d = at(ring - 1, sector + 1);
                network.rod(a, c, seam, m_resists);
                network.rod(a, b, ring == m_rings ? skirt : materials.seams, m_resists);
                if (ring == 1 && !m_hasVent) {
                    network.panel(c, b, a, cloth);
                    continue;
                }
                // diagonals lean to and fro, or the canopy would turn like a screw
                const bool leanRight = (ring + sector) % 2 == 0;
                network.rod(leanRight ? a : b, leanRight ? d : c, materials.seams, m_resists);
                network.panel(c, leanRight ? d : b, a, cloth);
                network.panel(leanRight ? a : c, d, b, cloth);
            }
        for (int sector = 0; m_hasVent && sector < m_sectors; ++sector)
            network.rod(at(0, sector), at(0, sector + 1), skirt, m_resists);
    }

    // Ties the rim of the vent over the middle; `density` in kg/m.
    void crossVent(Network& network, Id lines, double density) const
    {
        for (int sector = 0; m_hasVent && sector < m_sectors; ++sector) {
            const Id rim = at(0, sector);
            const double length = (network.position(rim) - network.position(m_nodes[0])).norm();
            network.line(m_nodes[0], rim, 1, length * density, lines, Resists::Tension);
        }
    }

private:
    // A place `along` a gore from the apex, m, of a tube with a round crown.
    static Vec3 tube(double radius, double along, const Vec3& out)
    {
        const double polar = along / radius;
        if (polar < 0.5 * pi)
            return radius * (std::sin(polar) * out + std::cos(polar) * Vec3::UnitY());
        return radius * out - (along - 0.5 * pi * radius) * Vec3::UnitY();
    }

    int m_rings;
    int m_sectors;
    bool m_hasVent;
    double m_radius; // m, of the sphere that it is a cap of; 0 for one that is cut flat
    Resists m_resists;
    std::vector<Id> m_nodes;
    std::vector<Vec3> m_start; // [nodes] m
};

Id addPayload(Network& network, const std::vector<Id>& skirt, const Parameters& p,
              const CanopyMaterials& materials)
{
    const Vec3 edge = network.position(skirt.front());
    const double length = std::max(p.at("line_length"), 1.05 * edge.x());
    const double depth = std::sqrt(length * length - edge.x() * edge.x());
    const Id payload = network.particle({0.0, edge.y() - depth, 0.0}, p.at("payload"));
    for (const Id node : skirt)
        network.line(node, payload, int(p.at("line_segments")),
                     length * cordDensity(p, canopyChoices), materials.lines, Resists::Tension);
    return payload;
}

// Weaves and weighs the canopy; real cloth is cut before it is bent to where it starts.
void layCloth(Scene& scene, Network& network, const Canopy& canopy, const Parameters& p,
              const CanopyMaterials& materials, CraftMaterials& craft)
{
    if (isIdeal(p, "cloth")) {
        canopy.weave(network, materials, materials.seams, materials.seams);
        network.addFabricMass(p.at("fabric"));
        canopy.crossVent(network, materials.lines, cordDensity(p, canopyChoices));
        return;
    }
    Material sewn;
    sewn.name = "gore seams";
    sewn.color = "#b5b2a6";
    craft.hems.push_back(addItem(scene, sewn));
    sewn.name = "skirt";
    craft.hems.push_back(addItem(scene, sewn));
    canopy.weave(network, materials, craft.hems[0], craft.hems[1]);
    canopy.cut(network, p.at("grain") * degrees);
    network.addFabricMass(clothDensity(p, canopyChoices));
    for (const Id hem : craft.hems)
        network.addLinkMass(hem, hemDensity(p, canopyChoices));
    canopy.crossVent(network, materials.lines, cordDensity(p, canopyChoices));
}

Result<Scene> buildParachute(const Parameters& p)
{
    Scene scene;
    addGround(scene);
    addWind(scene, Vec3(p.at("wind"), 0.0, 0.0));
    Material cloth;
    cloth.porosity = p.at("porosity");
    const CanopyMaterials materials =
        addCanopyMaterials(scene, p, cloth, {"odd gores", "even gores"}, {"#d1495b", "#f2f0e6"});

    Network network(scene, "parachute");
    const Canopy canopy(network, p);
    CraftMaterials craft;
    craft.cloth = {materials.cloth.begin(), materials.cloth.end()};
    craft.seams = {materials.seams};
    craft.lines = {materials.lines};
    layCloth(scene, network, canopy, p, materials, craft);
    std::vector<Id> pulledAt = canopy.skirt();
    pulledAt.push_back(canopy.nodes().front());
    const Result<std::vector<Id>> patches = addPatches(p, pulledAt, scene, network, canopyChoices);
    if (!patches)
        return patches.failure();
    craft.patches = *patches;
    const bool holdsAir = p.at("pressure") > 0.0;
    if (holdsAir) {
        canopy.shape(network);
    } else {
        setDrag(scene, network, craft.allCloth(), p.at("drag"),
                0.25 * pi * p.at("diameter") * p.at("diameter")
                    - 0.25 * pi * ventOf(p) * ventOf(p));
    }

    const std::size_t firstLineRod = network.part().links.size();
    const Id payload = addPayload(network, canopy.skirt(), p, materials);
    const Id lineRod = network.part().links[firstLineRod].id;
    std::vector<Id> hubs;
    if (p.at("hoop") > 0.0 && !holdsAir)
        hubs = addHoop(network, canopy.skirt(), 0.25 * p.at("diameter"), p.at("hoop_mass"),
                       materials.frame, !isIdeal(p, "cloth"));
    if (p.at("equal_masses") > 0.0)
        network.shareMass(payload);
    makeOf(p, craft, scene, network, canopyChoices);
    network.place(Eigen::Matrix3d::Identity(),
                  {0.0, p.at("altitude") - network.position(payload).y(), 0.0},
                  {0.0, 0.0 - p.at("speed"), 0.0}); // no -0 in files

    addGroup(scene, "canopy", canopy.nodes());
    addGroup(scene, "skirt", canopy.skirt());
    addGroup(scene, "rigidity", hubs);
    addGroup(scene, "payload", {payload});
    const Id part = network.finish("parachute", p);
    std::get<Part>(*findItem(scene, part)).canopyPressure = p.at("pressure");
    addProbe(scene, "height", Quantity::PositionY, payload);
    addProbe(scene, "sink rate", Quantity::SinkRate, part);
    addProbe(scene, "air force", Quantity::AirForce, part);
    addProbe(scene, "line tension", Quantity::Tension, lineRod);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);

    scene.settings.title = "Round parachute";
    scene.settings.notes = "The payload sinks at sqrt(2 m g / (rho CD0 S0)).";
    if (holdsAir) {
        addProbe(scene, "canopy pressure", Quantity::CanopyPressure, part);
        scene.settings.notes = "Air fills the canopy through its mouth and holds it open.";
    }
    return scene;
}

} // namespace

const Builder parachuteBuilder{
    "parachute", "Parachute",    "A round canopy with suspension lines and a payload.",
    parameters,  buildParachute, Family::Canopies};

} // namespace ripstop
