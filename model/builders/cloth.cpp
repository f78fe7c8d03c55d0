// The cloth paper's sheet (Millet): masses and springs, hung by two corners, over ground and
// sphere.
//
// Structural springs run along rows and columns, shear springs across both diagonals of each cell,
// bend springs to second neighbours in rows and columns. Stiffness is that of the fabric: a spring
// stands for the strip of cloth around it, so its stiffness does not depend on the resolution of a
// square mesh. A torn spring takes the panels beside it out of the air. A cloth of the library is
// carried by panels in place of springs (craft_materials.h).
#include "builders/craft_materials.h"
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/statics.h"
#include "derived/link_stiffness.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::string_view hangs[]{"two_corners", "left_edge",    "nothing",
                                   "both_edges",  "clamped_edge", "rail"};

constexpr auto sheetCloths = std::to_array<std::string_view>(
    {"ideal", "ripstop_050", "ripstop_075", "ripstop_150", "icarex_p31", "teijin_d2", "skytex_32",
     "mil_7020_1", "dacron_sail", "royal_target", "denim_11oz"});
constexpr CraftChoices sheetChoices{sheetCloths, {}, {}};
constexpr ParameterNeed ofSprings = isZero("cloth");

// clang-format off
constexpr Parameter parameters[]{
    {"columns",   "",       20,   1, 400,  true,  "Cells across.", "Mesh"},
    {"rows",      "",       20,   1, 400,  true,  "Cells down."},
    {"width",     "m",      1.0,  0.01, 50, false, "From corner to corner across.", "Size"},
    {"height",    "m",      1.0,  0.01, 50, false, "From the top edge to the bottom edge."},
    {"cloth",     "",       0,    0, sheetCloths.size() - 1, true, "What the sheet is made of; ideal cloth is as stiff and heavy as said below, a real one is carried by panels and wrinkles.", "Fabric", sheetCloths, 2},
    {"density",   "kg/m^2", 0.25, 0.005, 10, false, "Mass of the fabric per area; 0.25 is a knit, 0.045 a kite fabric.", {}, {}, {}, ofSprings},
    {"stiffness", "N/m",    100,  0, 1e6,  false, "Of structural springs: the tension of the fabric per strain; light knits have 25 to 130.", {}, {}, {}, ofSprings},
    {"membrane",  "N/m",    0,    0, 1e7,  false, "Membrane stiffness E t of the fabric along its threads; above 0 it replaces the stiffness, and the sheet stretches alike at every resolution.", {}, {}, {}, ofSprings},
    {"panels",    "",       0,    0, 1,    true,  "1 has panels carry the fabric's pull instead of springs: with warp, weft, shear and wrinkles, and the same on every mesh.", {}, {}, {}, ofSprings},
    {"shear",     "",       0.3,  0, 2,    false, "Stiffness of shear springs over that of structural ones; of the membrane, shear stiffness over membrane stiffness.", {}, {}, {}, ofSprings},
    {"bend",      "",       0.02, 0, 2,    false, "Stiffness of bend springs over that of structural ones.", {}, {}, {}, ofSprings},
    {"bending",   "N m",    0,    0, 10,   false, "Bending stiffness of the fabric, its moment per width and curvature; garments have 1e-5 to 1e-4.", {}, {}, {}, ofSprings},
    {"damping",   "N s/m",  0.01, 0, 100,  false, "Of all springs; takes speed from stretching only.", {}, {}, {}, ofSprings},
    {"tear",      "",       0,    0, 10,   false, "Strain at which a spring tears; 0 never.", {}, {}, {}, ofSprings},
    {"hang",      "",       0,    0, 5,    true,  "What holds the sheet: 0 two corners, 1 the left edge like a flag, 2 nothing, 3 the left and the right edge, of which the right one can be drawn away, 4 the left edge clamped, 5 rings along a rail, of which the last one can be drawn.", "Set-up", hangs},
    {"slit",      "",       0,    0, 0.9,  false, "A cut from the middle of the lower edge upwards, over the height; tears start there."},
    {"level",     "m",      1.6,  0.01, 1000, false, "Height of the top edge over the ground."},
    {"flat",      "",       1,    0, 1,    true,  "1 starts with the sheet lying level, 0 hanging."},
    {"sphere",    "m",      0.25,    0, 20,   false, "Radius of a sphere below the sheet; 0 leaves it out."},
    {"boxes",     "",       0,    0, 9,    true,  "Boxes on the ground in a ring below the sheet, each turned another way."},
    {"thickness", "m",      0,    0, 0.2,  false, "Distance that the sheet keeps from itself and from sphere and boxes; 0 lets it pass through itself."},
    {"wind",      "m/s",    0,    -50, 50, false, "Speed of the wind, across the sheet when it is hung by corners and along it when by an edge.", "Air"},
    {"lift_slope", "1/rad", 2,    0, 8,    false, "Normal force coefficient of the fabric in the wind."},
    {"friction",  "",       0.02, 0, 0.5,  false, "Coefficient of the air's force along the fabric."},
    {"balance",   "",       0,    0, 1,    true,  "1 adds probes that tell where the energy comes from and where it goes, and a plot of them.", "Measuring"},
};
// clang-format on

constexpr int byCorners = 0;
constexpr int byEdge = 1;
constexpr int byTwoEdges = 3;
constexpr int clamped = 4;   // the first two columns
constexpr int byRail = 5;    // as a curtain
constexpr int ringEvery = 4; // columns

struct Materials
{
    Id cloth{};
    Id structural{}; // of springs, where there are any
    Id shear{};
    Id bend{};
};

Materials addMaterials(Scene& scene, const Parameters& p)
{
    Material material;
    material.name = "cloth";
    material.color = "#3d7ea6";
    material.normalCoefficient = p.at("lift_slope");
    material.skinFriction = p.at("friction");
    if (!isIdeal(p, "cloth")) // the library has the rest
        return {.cloth = addItem(scene, material)};
    material.damping = p.at("damping");
    material.tearRule = p.at("tear") > 0.0 ? TearRule::Strain : TearRule::Never;
    material.tearLimit = p.at("tear") > 0.0 ? p.at("tear") : material.tearLimit;
    const bool byPanels = p.at("panels") > 0.0;
    const double membrane =
        p.at("membrane") > 0.0 || !byPanels ? p.at("membrane") : p.at("stiffness");
    if (membrane > 0.0) {
        material.membraneStiffness = membrane;
        if (p.at("shear") > 0.0)
            material.shearStiffness = p.at("shear") * membrane;
    }
    if (byPanels && membrane > 0.0)
        material.dampingTime = p.at("damping") / membrane;
    material.arealDensity = p.at("density");
    material.bendingStiffness = p.at("bending");
    const auto add = [&](const char* name, const char* color, double share) {
        material.name = name;
        material.color = color;
        material.stiffness = share * p.at("stiffness");
        material.shown = share == 1.0;
        return addItem(scene, material);
    };
    Materials materials{};
    materials.cloth = add("cloth", "#3d7ea6", 1.0);
    if (byPanels)
        return materials;
    materials.structural = add("structural", "#2c5d7c", 1.0);
    materials.shear = add("shear", "#5c96b8", p.at("shear"));
    materials.bend = add("bend", "#a8c5d6", p.at("bend"));
    return materials;
}

void addBalance(Scene& scene)
{
    Plot plot;
    plot.name = "energy balance";
    plot.seconds = 0.0; // the whole run
    plot.probes = {addProbe(scene, "energy change", Quantity::EnergyChange),
                   addProbe(scene, "work of air", Quantity::WorkOfAir),
                   addProbe(scene, "work of hands", Quantity::WorkOfHands),
                   addProbe(scene, "work of damping", Quantity::WorkOfDamping),
                   addProbe(scene, "work of contact", Quantity::WorkOfContact),
                   addProbe(scene, "work of tearing", Quantity::WorkOfTearing),
                   addProbe(scene, "energy residual", Quantity::EnergyResidual)};
    addItem(scene, plot);
}

class Sheet
{
public:
    Sheet(Network& network, const Parameters& p)
        : m_columns(int(p.at("columns")))
        , m_rows(int(p.at("rows")))
        , m_cellWidth(p.at("width") / m_columns)
        , m_cellHeight(p.at("height") / m_rows)
        , m_slitTop(m_rows - int(std::lround(p.at("slit") * m_rows)))
    {
        const bool flat = p.at("flat") > 0.0;
        for (int row = 0; row <= m_rows; ++row)
            for (int column = 0; column <= m_columns; ++column) {
                const double u = double(column) / m_columns;
                const double v = double(row) / m_rows;
                const double down = v * p.at("height");
                const Id node =
                    network.particle({(u - 0.5) * p.at("width"),
                                      p.at("level") - (flat ? 0.0 : down), flat ? down : 0.0});
                network.texture(node, u, 1.0 - v);
                m_nodes.push_back(node);
            }
    }

    std::vector<Id> edge(int column) const
    {
        std::vector<Id> nodes;
        for (int row = 0; row <= m_rows; ++row)
            nodes.push_back(at(row, column));
        return nodes;
    }

    // Both nodes exist, and the slit does not run between them.
    bool joins(int row, int column, int otherRow, int otherColumn) const
    {
        const int left = std::min(column, otherColumn);
        const int right = std::max(column, otherColumn);
        const bool isCut =
            std::max(row, otherRow) > m_slitTop && left <= m_columns / 2 && right > m_columns / 2;
        return otherRow <= m_rows && left >= 0 && right <= m_columns && !isCut;
    }
    Id at(int row, int column) const { return m_nodes[row * (m_columns + 1) + column]; }
    int rows() const { return m_rows; }
    int columns() const { return m_columns; }

    void weave(Network& network, const Materials& materials) const
    {
        struct Reach
        {
            int rows;
            int columns;
            Id material;
        };
        const Reach reaches[]{{0, 1, materials.structural}, {1, 0, materials.structural},
                              {1, 1, materials.shear},      {1, -1, materials.shear},
                              {0, 2, materials.bend},       {2, 0, materials.bend}};
        for (const Reach& reach : reaches)
            for (int row = 0; row <= m_rows && reach.material != noId; ++row)
                for (int column = 0; column <= m_columns; ++column)
                    if (joins(row, column, row + reach.rows, column + reach.columns)) {
                        network.spring(at(row, column),
                                       at(row + reach.rows, column + reach.columns),
                                       reach.material);
                        standFor(network, row, column, reach.rows, reach.columns);
                    }
        for (int row = 0; row < m_rows; ++row)
            for (int column = 0; column < m_columns; ++column)
                if (joins(row, column, row + 1, column + 1))
                    cover(network, row, column, materials.cloth);
    }

    // Sets off one wave along the sheet, of this speed at the free edge, m/s.
    void nudge(Network& network, double speed) const
    {
        for (const Id node : m_nodes) {
            Particle& particle = network.row(node);
            const double u = particle.textureU;
            particle.velocity.z() = speed * u * std::sin(2.0 * pi * u);
        }
    }

private:
    // Half a cell of fabric on either side where there is one; a diagonal has the width for which
    // the two of a cell resist shear as fabric does (link_stiffness.h).
    void standFor(Network& network, int row, int column, int rows, int columns) const
    {
        const auto cell = [&](int r, int c) {
            return r >= 0 && c >= 0 && joins(r, c, r + 1, c + 1) ? 0.5 : 0.0;
        };
        if (rows == 0 && columns == 1)
            network.asFabric({LinkRole::Thread,
                              m_cellHeight * (cell(row - 1, column) + cell(row, column)),
                              aspectOfCells(m_cellWidth, m_cellHeight)});
        else if (rows == 1 && columns == 0)
            network.asFabric({LinkRole::Thread,
                              m_cellWidth * (cell(row, column - 1) + cell(row, column)),
                              aspectOfCells(m_cellHeight, m_cellWidth)});
        else if (rows == 1)
            network.asFabric({LinkRole::Bias, biasWidth(m_cellWidth, m_cellHeight)});
    }

    // diagonals alternate, so that the sheet has no grain
    void cover(Network& network, int row, int column, Id cloth) const
    {
        const Id a = at(row, column);
        const Id b = at(row, column + 1);
        const Id c = at(row + 1, column);
        const Id d = at(row + 1, column + 1);
        if ((row + column) % 2 == 0) {
            network.panel(a, c, d, cloth);
            network.panel(a, d, b, cloth);
        } else {
            network.panel(a, c, b, cloth);
            network.panel(b, c, d, cloth);
        }
    }

    int m_columns;
    int m_rows;
    double m_cellWidth;  // m
    double m_cellHeight; // m
    int m_slitTop;       // the last row that is whole
    std::vector<Id> m_nodes;
};

void addSphere(Scene& scene, const Parameters& p)
{
    Collider sphere;
    sphere.name = "sphere";
    sphere.shape = ColliderShape::Sphere;
    sphere.radius = p.at("sphere");
    sphere.thickness = 0.5 * p.at("thickness");
    const bool flat = p.at("flat") > 0.0;
    const double gap = 1.15 * sphere.radius;
    sphere.position = flat ? Vec3(0.0, p.at("level") - gap, 0.5 * p.at("height"))
                           : Vec3(0.0, p.at("level") - 0.8 * p.at("height"), gap);
    addItem(scene, sphere);
}

void addBoxes(Scene& scene, const Parameters& p)
{
    const int count = int(p.at("boxes"));
    const double width = std::min(p.at("width"), p.at("height"));
    const Vec3 middle(0.0, 0.0, p.at("flat") > 0.0 ? 0.5 * p.at("height") : 0.0);
    for (int i = 0; i < count; ++i) {
        Collider box;
        box.name = "box " + std::to_string(i + 1);
        box.shape = ColliderShape::Box;
        box.size = width * Vec3(0.24, 0.2 + 0.1 * (i % 3), 0.24);
        box.turn = Vec3(0.0, 40.0 * i, i % 2 == 1 ? 45.0 : 0.0); // every other one on an edge
        const double angle = 2.0 * pi * i / count;
        const double away = count > 1 ? 0.3 * width : 0.0;
        const double reach =
            i % 2 == 1 ? (box.size.x() + box.size.y()) * std::sqrt(0.125) : 0.5 * box.size.y();
        box.position = middle + Vec3(away * std::cos(angle), reach, away * std::sin(angle));
        box.thickness = 0.5 * p.at("thickness");
        addItem(scene, box);
    }
}

// What is held is moved by keys as in the cloth paper; up is away from the viewer.
void addControls(Scene& scene, const std::string& name, const std::vector<Id>& targets)
{
    Control control;
    control.targets = targets;
    control.name = name + " x";
    control.axis = Vec3::UnitX();
    control.keyLess = "Left";
    control.keyMore = "Right";
    addItem(scene, control);
    control.name = name + " z";
    control.axis = Vec3::UnitZ();
    control.keyLess = "Up";
    control.keyMore = "Down";
    addItem(scene, control);
}

Result<Scene> buildCloth(const Parameters& p)
{
    if (p.at("flat") == 0.0 && p.at("level") < p.at("height"))
        return Failure("The sheet hangs %1 m down from a level of %2 m, into the ground: give it a "
                       "level of at least its height, or start it flat.",
                       Message::number("%.4g", p.at("height")),
                       Message::number("%.4g", p.at("level")));
    Scene scene;
    scene.settings.title = "Cloth";
    const int hang = int(p.at("hang"));
    addGround(scene);
    if (p.at("sphere") > 0.0)
        addSphere(scene, p);
    addBoxes(scene, p);
    addWind(scene, p.at("wind") * (hang == byEdge ? Vec3::UnitX() : Vec3::UnitZ()));
    const Materials materials = addMaterials(scene, p);

    Network network(scene, "sheet");
    const Sheet sheet(network, p);
    sheet.weave(network, materials);
    const bool isOfSprings = isIdeal(p, "cloth");
    network.addFabricMass(clothDensity(p, sheetChoices, "density"));
    if (p.at("panels") > 0.0)
        network.carryByPanels();
    CraftMaterials made;
    made.cloth = {materials.cloth};
    makeOf(p, made, scene, network, sheetChoices);

    std::vector<Id> held;
    if (hang == byCorners)
        held = {sheet.at(0, 0), sheet.at(0, sheet.columns())};
    else if (hang == byEdge || hang == byTwoEdges)
        held = sheet.edge(0);
    if (hang == byTwoEdges)
        for (const Id node : sheet.edge(sheet.columns()))
            held.push_back(node);
    if (hang == clamped) {
        held = sheet.edge(0);
        for (const Id node : sheet.edge(1))
            held.push_back(node);
    }
    if (hang == byRail)
        held = {sheet.at(0, 0), sheet.at(0, sheet.columns())};
    for (const Id node : held)
        network.row(node).pinned = true;
    for (int column = ringEvery; hang == byRail && column < sheet.columns(); column += ringEvery) {
        Particle& ring = network.row(sheet.at(0, column));
        ring.guide = Guide::Line; // along x
    }
    if (hang == byEdge || hang == byRail) // what is exactly plane would stay so for ever
        sheet.nudge(network, 0.3);

    const Id middle = sheet.at(sheet.rows(), sheet.columns() / 2);
    const Id part = network.finish("cloth", p);
    std::get<Part>(*findItem(scene, part)).selfContact = p.at("thickness");
    addGroup(scene, "held", held);
    if (hang == byCorners)
        addControls(scene, "corner", {sheet.at(0, 0)});
    if (hang == byTwoEdges)
        addControls(scene, "edge", sheet.edge(sheet.columns()));
    if (hang == byRail)
        addControls(scene, "curtain", {sheet.at(0, sheet.columns())});
    addProbe(scene, "lower edge", Quantity::PositionY, middle);
    addProbe(scene, "speed", Quantity::Speed, part);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    addProbe(scene, "torn", Quantity::TornLinks, part);
    addProbe(scene, "energy", Quantity::TotalEnergy);
    if (p.at("balance") > 0.0)
        addBalance(scene);

    if (isOfSprings)
        takeShortSubsteps(scene);
    return scene;
}

} // namespace

const Builder clothBuilder{"cloth",    "Cloth",    "A sheet of cloth, hung by corners or an edge.",
                           parameters, buildCloth, Family::Cloth};

} // namespace ripstop
