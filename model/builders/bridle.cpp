// A bridle cascade: rows of lines that fork level by level, from a riser to the points of a wing.
//
// Level 1 of a row is one line from the riser; each line ends in two of the next level. With R rows
// and L levels: R (2^L - 1) + 1 particles and as many lines less one. The points of the wing are
// pinned, in R rows along the chord and 2^(L-1) across the span, and the load hangs from the riser.
//
// Without a table the forks lie on the straight lines from the riser to the middle of the points
// above them, and the lengths are what they come to. With a table, row by row of the bridle and
// from the riser up, the lengths are those of the table: each fork hangs below the middle of its
// two points, and the riser where the first row is taut. At rest a line of a single row that
// carries the load F at a fork of half angle a carries F / (2 cos a).
#include "builders/craft_materials.h"
#include "builders/designs.h"
#include "builders/network.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr CraftChoices bridleChoices{{}, {}, cordChoices};

// clang-format off
constexpr Parameter parameters[]{
    {"rows",     "",     3,    1, 8,     true,  "Rows of lines along the chord, A, B, C and so on; the table takes their place.", "Cascade"},
    {"levels",   "",     3,    1, 7,     true,  "Levels of lines from the riser to the wing, each with twice the lines of the one below; the table takes their place."},
    {"span",     "m",    2,    0, 40,    false, "Distance of the outermost points of a row."},
    {"chord",    "m",    0.8,  0, 10,    false, "Distance of the first row from the last."},
    {"height",   "m",    2,    0.05, 60, false, "From the riser to the wing, where no table says so."},
    {"level",    "m",    4,    0.1, 1000, false, "Height of the wing over the ground."},
    {"load",     "kg",   5,    0.001, 2000, false, "Mass that hangs from the riser.", "Load and lines"},
    {"cord",     "",     0,    0, cordChoices.size() - 1, true, "What the lines are made of; ideal ones never stretch.", {}, cordChoices, 3},
    {"line_density", "kg/m", 0.001, 1e-6, 0.2, false, "Mass of a line per length.", {}, {}, {}, isZero("cord")},
    {"line_diameter", "m", 0.001, 0, 0.02, false, "Thickness of a line, which the wind drags.", {}, {}, {}, isZero("cord")},
    {"wind",     "m/s",  0,    0, 40,    false, "Speed of the wind.", "Air"},
};

constexpr TableParameter lengths{
    "lengths", "m", 0.01, 100,
    "A row for each row of lines, a column for each level from the riser up, in metres. Paste it from a spreadsheet; it takes the place of rows, levels and height."};
// clang-format on

struct Cascade
{
    int rows;
    int levels;
    NumberRows table; // empty without one

    double length(int row, int level) const { return table[std::size_t(row)][std::size_t(level)]; }
};

// Nodes of one row: [level][index] from the fork over level 1 to the points of the wing.
using Forks = std::vector<std::vector<Vec3>>;

Failure tooShort(int row, int level, double length, double needed)
{
    const double enough = (std::floor(1e3 * needed) + 1.0) * 1e-3; // m, in whole millimetres
    return Failure("lengths, row %1, column %2: %3 m do not reach; it takes %4 m.", row + 1,
                   level + 1, Message::number("%g", length), Message::number("%.3f", enough));
}

double across(const Parameters& p, int index, int count)
{
    return count > 1 ? (double(index) / (count - 1) - 0.5) * p.at("span") : 0.0;
}

double along(const Parameters& p, const Cascade& cascade, int row)
{
    return cascade.rows > 1 ? (0.5 - double(row) / (cascade.rows - 1)) * p.at("chord") : 0.0;
}

// The middle of all the points that hang on a fork, m.
double meanAcross(const Parameters& p, const Cascade& cascade, int level, int fork)
{
    const int points = 1 << (cascade.levels - 1);
    const int own = points >> level; // of a fork at the upper end of this level
    return 0.5 * (across(p, fork * own, points) + across(p, (fork + 1) * own - 1, points));
}

Result<Forks> forksOf(const Parameters& p, const Cascade& cascade, int row)
{
    const int levels = cascade.levels;
    const int points = 1 << (levels - 1);
    Forks forks(static_cast<std::size_t>(levels));
    const double x = along(p, cascade, row);
    for (int i = 0; i < points; ++i)
        forks.back().push_back({x, p.at("level"), across(p, i, points)});
    for (int level = levels - 2; level >= 0; --level) {
        const std::vector<Vec3>& above = forks[std::size_t(level) + 1];
        for (std::size_t i = 0; i < above.size(); i += 2) {
            const Vec3 middle = 0.5 * (above[i] + above[i + 1]);
            if (cascade.table.empty()) {
                const Vec3 riser(0.0, p.at("level") - p.at("height"), 0.0);
                const Vec3 mean(x, p.at("level"), meanAcross(p, cascade, level, int(i / 2)));
                const double share = double(level + 1) / levels;
                forks[std::size_t(level)].push_back(riser + share * (mean - riser));
                continue;
            }
            const double half = 0.5 * (above[i + 1] - above[i]).norm();
            const double length = cascade.length(row, level + 1);
            if (length <= half)
                return tooShort(row, level + 1, length, half);
            forks[std::size_t(level)].push_back(
                middle - std::sqrt(length * length - half * half) * Vec3::UnitY());
        }
    }
    return forks;
}

Result<Vec3> riserOf(const Parameters& p, const Cascade& cascade, const std::vector<Forks>& rows)
{
    if (cascade.table.empty())
        return Vec3(0.0, p.at("level") - p.at("height"), 0.0);
    double height = -1e9; // m, the highest that some row asks for; the others are slack
    for (int row = 0; row < cascade.rows; ++row) {
        const Vec3 fork = rows[std::size_t(row)].front().front();
        const double away = std::hypot(fork.x(), fork.z());
        const double length = cascade.length(row, 0);
        if (length <= away)
            return tooShort(row, 0, length, away);
        height = std::max(height, fork.y() - std::sqrt(length * length - away * away));
    }
    return Vec3(0.0, height, 0.0);
}

struct Laid
{
    std::vector<Id> points; // of the wing
    std::vector<Id> mains;  // lines of level 1
};

Laid layRow(Network& network, const Parameters& p, const Cascade& cascade, const Forks& forks,
            int row, Id riser, Id material)
{
    std::vector<Id> below{riser};
    Laid laid;
    for (int level = 0; level < cascade.levels; ++level) {
        std::vector<Id> nodes;
        for (const Vec3& place : forks[std::size_t(level)])
            nodes.push_back(network.particle(place));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Id from = below[level == 0 ? 0 : i / 2];
            const double wanted = cascade.table.empty() ? 0.0 : cascade.length(row, level);
            const Id line = network.rod(from, nodes[i], material, Resists::Tension);
            if (wanted > 0.0)
                network.setRestLength(wanted);
            const double mass =
                cordDensity(p, bridleChoices) * network.part().links.back().restLength;
            network.row(from).mass += 0.5 * mass;
            network.row(nodes[i]).mass += 0.5 * mass;
            if (level == 0)
                laid.mains.push_back(line);
        }
        below = std::move(nodes);
    }
    for (const Id point : below)
        network.row(point).pinned = true;
    laid.points = std::move(below);
    return laid;
}

Result<Scene> buildBridle(const Parameters& p)
{
    Cascade cascade{int(p.at("rows")), int(p.at("levels")), tableOf(p, lengths)};
    if (!cascade.table.empty()) {
        cascade.rows = int(cascade.table.size());
        cascade.levels = int(cascade.table[0].size());
        if (cascade.levels > 10)
            return Failure{"lengths, row 1, column 11: more than 10 levels would be more than a "
                           "thousand lines in each row."};
    }
    std::vector<Forks> rows;
    for (int row = 0; row < cascade.rows; ++row) {
        Result<Forks> forks = forksOf(p, cascade, row);
        if (!forks)
            return forks.failure();
        rows.push_back(std::move(*forks));
    }
    const Result<Vec3> place = riserOf(p, cascade, rows);
    if (!place)
        return place.failure();

    Scene scene;
    scene.settings.title = "Bridle cascade";
    // grams of line carry kilograms: no number of sweeps holds that through the forks
    if (isIdeal(p, "cord"))
        scene.settings.solver = Solver::Direct;
    addGround(scene);
    addWind(scene, Vec3(p.at("wind"), 0.0, 0.0));
    Material material;
    material.diameter = p.at("line_diameter");
    material.linearDensity = p.at("line_density");
    constexpr const char* colors[]{"#d1495b", "#30638e", "#edae49", "#00798c"};
    std::vector<Id> materials;
    for (int row = 0; row < cascade.rows; ++row) {
        material.name = std::string("lines ") + char('A' + row % 26)
                        + (row < 26 ? "" : std::to_string(row / 26));
        material.color = colors[row % 4];
        materials.push_back(addItem(scene, material));
    }

    Network network(scene, "bridle");
    const Id riser = network.particle(*place, p.at("load"));
    std::vector<Id> points;
    std::vector<Id> mains;
    for (int row = 0; row < cascade.rows; ++row) {
        const Laid laid = layRow(network, p, cascade, rows[std::size_t(row)], row, riser,
                                 materials[std::size_t(row)]);
        points.insert(points.end(), laid.points.begin(), laid.points.end());
        mains.insert(mains.end(), laid.mains.begin(), laid.mains.end());
    }
    CraftMaterials craft;
    craft.lines = materials;
    makeOf(p, craft, scene, network, bridleChoices);
    const Id part = network.finish("bridle", p);
    addGroup(scene, "wing points", points);
    addGroup(scene, "riser", {riser});
    addProbe(scene, "riser height", Quantity::PositionY, riser);
    for (std::size_t row = 0; row < mains.size(); ++row)
        addProbe(scene, "main " + std::to_string(row + 1), Quantity::Tension, mains[row]);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    return scene;
}

} // namespace

const Builder bridleBuilder{"bridle",
                            "Bridle cascade",
                            "Rows of lines that fork from a riser to the points of a wing, with "
                            "lengths from a table.",
                            parameters,
                            buildBridle,
                            Family::Lines,
                            &lengths};

} // namespace ripstop
