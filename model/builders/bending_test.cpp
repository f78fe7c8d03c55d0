// The tester of Peirce 1930: strips of fabric reach over the edge of a table, and droop.
//
// The bending length of a fabric, c = (B / (rho g))^(1/3), says how: a strip that reaches 2 c over
// the edge hangs 41.5 degrees below level, whatever it is made of. So each strip here, of a fabric
// whose bending stiffness B and density rho were measured, reaches as far as its own c says, and
// all come to rest on one plane; narrow ramps beside the strips show it.
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/statics.h"
#include "materials/presets.h"
#include "scene/weigh.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr Parameter parameters[]{
    {"cells",  "",    16,    4, 64,       true,  "Cells from the edge of the table to the tip.", "Mesh"},
    {"across", "",    4,     1, 40,       true,  "Cells across a strip."},
    {"reach",  "",    2,     0.2, 4,      false, "Overhang of a strip over its bending length; with 2 strips come to 41.5 degrees.", "Test"},
    {"gap",    "m",   0.012, 0.001, 1,    false, "Between strips, with a ramp in it."},
    {"angle",  "deg", 41.5,  0, 80,       false, "Of the ramps, below level."},
    {"panels", "",    0,     0, 1,        true,  "1 has panels carry the pull, with the stretch that was measured; with 0 threads do, which never stretch.", "Fabric", {}, 1},
};
// clang-format on

constexpr double level = 0.1;      // m, of the edge above the ground
constexpr double depth = 0.06;     // m, of the table
constexpr double thickness = 2e-3; // m, of ramps
constexpr const char* fabrics[]{"gray_interlock", "denim_11oz", "royal_target"};
constexpr const char* colors[]{"#8d99a6", "#34507a", "#b0413e"};

double numberOf(const Preset& preset, const Property& property)
{
    const PresetNumber* number = findNumber(preset, property);
    return number ? std::get<double>(number->value) : 0.0;
}

// All that is known of the fabric, or of one of threads, which do not stretch, its weight and
// bending.
Material fabricOf(const Preset& preset, const char* color, bool byPanels)
{
    Material material;
    material.name = preset.name;
    material.color = color;
    if (byPanels) {
        give(material, preset);
        return material;
    }
    material.arealDensity = numberOf(preset, propertyOf<&Material::arealDensity>());
    material.bendingStiffness = numberOf(preset, propertyOf<&Material::bendingStiffness>());
    return material;
}

class Strip
{
public:
    Strip(Network& network, const Parameters& p, double overhang, double start)
        : m_cells(int(p.at("cells")))
        , m_across(int(p.at("across")))
        , m_cell(overhang / m_cells)
    {
        for (int i = -1; i <= m_cells; ++i)
            for (int j = 0; j <= m_across; ++j) {
                const Id node = network.particle({i * m_cell, level, start + j * m_cell});
                network.row(node).pinned = i <= 0;
                network.texture(node, double(i + 1) / (m_cells + 1), double(j) / m_across);
                m_nodes.push_back(node);
            }
    }

    void cover(Network& network, Id fabric) const
    {
        for (int i = -1; i < m_cells; ++i)
            for (int j = 0; j < m_across; ++j) {
                const Id a = at(i, j), b = at(i + 1, j);
                const Id c = at(i, j + 1), d = at(i + 1, j + 1);
                const bool rising = (i + j) % 2 == 0;
                network.panel(a, b, rising ? d : c, fabric);
                network.panel(rising ? a : b, d, c, fabric);
            }
    }

    // Threads along and across, which do not stretch, and what shears little.
    void weave(Network& network, Id fabric, Id bias) const
    {
        for (int i = -1; i <= m_cells; ++i)
            for (int j = 0; j <= m_across; ++j) {
                if (i < m_cells)
                    network.rod(at(i, j), at(i + 1, j), fabric);
                if (j < m_across)
                    network.rod(at(i, j), at(i, j + 1), fabric);
                if (i == m_cells || j == m_across)
                    continue;
                network.spring(at(i, j), at(i + 1, j + 1), bias);
                network.spring(at(i + 1, j), at(i, j + 1), bias);
            }
    }

    double width() const { return m_across * m_cell; }
    Id edge() const { return at(0, m_across / 2); }
    Id tip() const { return at(m_cells, m_across / 2); }

private:
    Id at(int i, int j) const { return m_nodes[std::size_t((i + 1) * (m_across + 1) + j)]; }

    int m_cells;
    int m_across;
    double m_cell; // m
    std::vector<Id> m_nodes;
};

Id addBias(Scene& scene)
{
    Material bias;
    bias.name = "bias";
    bias.stiffness = 2.0;
    bias.shown = false;
    return addItem(scene, bias);
}

void addBox(Scene& scene, std::string name, const Vec3& position, const Vec3& size, double angle)
{
    Collider box;
    box.name = std::move(name);
    box.shape = ColliderShape::Box;
    box.position = position;
    box.size = size;
    box.turn = Vec3(0.0, 0.0, angle);
    addItem(scene, box);
}

// Its upper side goes down from the edge.
void addRamp(Scene& scene, int number, double angle, double length, double from, double width)
{
    const double a = angle * degrees;
    const Vec3 along(std::cos(a), -std::sin(a), 0.0);
    const Vec3 under(-std::sin(a), -std::cos(a), 0.0);
    const Vec3 edge(0.0, level, from + 0.5 * width);
    addBox(scene, "ramp " + std::to_string(number),
           edge + 0.5 * length * along + 0.5 * thickness * under, {length, thickness, width},
           -angle);
}

Result<Scene> buildBendingTest(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Bending test";
    scene.settings.viscosity = 3.0; // as the air between strips and table would
    addGround(scene);
    const bool byPanels = p.at("panels") > 0.0;
    const Id bias = byPanels ? Id() : addBias(scene);

    Network network(scene, "strips");
    struct Tip
    {
        std::string name;
        Id tip;
        Id edge;
    };
    std::vector<Tip> tips;
    const double gap = p.at("gap");
    double z = 0.0; // m, where the next ramp begins
    double longest = 0.0;
    std::vector<double> ramps;
    for (std::size_t i = 0; i < std::size(fabrics); ++i) {
        const Material fabric = fabricOf(**findPreset(fabrics[i]), colors[i], byPanels);
        const double weight = *fabric.arealDensity * scene.settings.gravity.norm(); // N/m^2
        const double overhang = p.at("reach") * std::cbrt(fabric.bendingStiffness / weight);
        const Id material = addItem(scene, fabric);
        const Strip strip(network, p, overhang, z + gap);
        strip.cover(network, material);
        if (!byPanels)
            strip.weave(network, material, bias);
        tips.push_back({fabric.name, strip.tip(), strip.edge()});
        ramps.push_back(z);
        z += gap + strip.width();
        longest = std::max(longest, overhang);
    }
    ramps.push_back(z);
    // strips lie on the table, not in it
    addBox(scene, "table", {-0.5 * depth, 0.5 * level - 5e-4, 0.5 * (z + gap)},
           {depth, level - 1e-3, z + gap}, 0.0);
    for (std::size_t i = 0; i < ramps.size(); ++i)
        addRamp(scene, int(i) + 1, p.at("angle"), longest, ramps[i] + 0.25 * gap, 0.5 * gap);

    if (byPanels)
        network.carryByPanels([](const Vec3&) { return Vec3::UnitX(); });
    (void)network.finish("bending_test", p);
    (void)apply(scene, weighing(scene));
    for (const Tip& tip : tips)
        addProbe(scene, tip.name + " slope", Quantity::Elevation, tip.tip, tip.edge);

    if (!byPanels)
        takeShortSubsteps(scene);
    return scene;
}

} // namespace

const Builder bendingTestBuilder{
    "bending_test", "Bending test",   "Strips of fabric that droop over the edge of a table.",
    parameters,     buildBendingTest, Family::Cloth};

} // namespace ripstop
