// Counts of lattices and designs against the formulas and the papers' tables.
//
// First lattices of fabric by their formulas, then the designs of the builders by the numbers of
// particles, links and panels that are published.
#include "builders/builder.h"
#include "builders/network.h"
#include "verify/sections.h"

namespace ripstop {
namespace {

void addLatticeCounts(std::vector<Case>& cases)
{
    for (const int n : {3, 5, 8, 14}) {
        std::uint32_t made = 0;
        const Lattice lattice(n, [&](int, int) { return Id(++made); });
        const auto row = [&](const char* what, double expected, std::size_t got,
                             const char* formula) {
            cases.push_back(
                {"1.3", "triangular lattice, " + std::to_string(n) + " segments per side, " + what,
                 expected, exactly, "", formula, [got] { return double(got); }});
        };
        row("nodes", (n + 1) * (n + 2) / 2, made, "(n+1)(n+2)/2");
        row("edges", 3 * n * (n + 1) / 2, lattice.edges().size(), "3n(n+1)/2");
        row("panels", n * n, lattice.cells().size(), "n^2");
        row("nodes of the two sides", 2 * n + 1, lattice.sides().size(), "2n+1");
        row("nodes of the perimeter", 3 * n, lattice.perimeter().size(), "3n");
        row("nodes of the median, tip left out", n / 2, lattice.median().size(), "n/2");
        row("nodes - edges + panels", 1, made + lattice.cells().size() - lattice.edges().size(),
            "Euler");
    }
}

struct BuiltDesign
{
    const char* id;
    const char* title;
    const char* builder;
    Parameters given;
    int particles, links, panels;
    const char* source;
};

const Part* onlyPart(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = &part; });
    return found;
}

void addDesignCounts(std::vector<Case>& cases)
{
    const char* glider = "Beaudry, Egli, Patenaude 2005, 6.3";
    const char* kite = "Beaudry, Egli, Patenaude 2005, 7.3";
    const char* canopy = "V 1 + 6 S, E 17 S, T 11 S; lines 3 S + 1, 4 S; hoop 2, 2 S";
    const Parameters ideal{{"cloth", 0}}; // as the papers have it
    const BuiltDesign designs[] = {
        {"1.4", "hang glider", "hang_glider", ideal, 49, 198, 64, glider},
        {"1.4",
         "hang glider of figure 12",
         "hang_glider",
         {{"segments", 3}, {"cloth", 0}},
         14,
         52,
         9,
         "V + 4, E + 2 (2n+1 + n/2) + 6n, n^2"},
        {"1.5", "delta kite", "delta_kite", ideal, 152, 458, 221, kite},
        {"1.6", "parachute, 24 sectors, hoop", "parachute", ideal, 220, 552, 264, canopy},
        {"1.6",
         "parachute, 24 sectors",
         "parachute",
         {{"hoop", 0}, {"cloth", 0}},
         218,
         504,
         264,
         canopy},
        {"1.6",
         "parachute, 12 sectors, hoop",
         "parachute",
         {{"sectors", 12}, {"cloth", 0}},
         112,
         276,
         132,
         canopy},
        {"1.6",
         "parachute, 28 sectors of the C-9",
         "parachute",
         {{"sectors", 28}, {"hoop", 0}, {"cloth", 0}},
         254,
         588,
         308,
         canopy},
        {"1.7",
         "stiffened rod",
         "stiffened_rod",
         {},
         6,
         11,
         0,
         "4 + 2 particles, 3 + 8 rods (paper of 2005)"},
        {"1.7",
         "rope of 14, second neighbours",
         "rope",
         {{"segments", 14}, {"stiffened", 1}},
         15,
         27,
         0,
         "n + 1; n + (n - 1)"},
        {"1.7",
         "cloth 4 x 3",
         "cloth",
         {{"columns", 4}, {"rows", 3}},
         20,
         77,
         24,
         "(c+1)(r+1); structural 31, shear 24, bend 22; 2 c r"},
    };
    for (const BuiltDesign& design : designs) {
        const auto part = shared([name = design.builder, given = design.given] {
            const Result<Scene> scene = build(*findBuilder(name), given);
            const Part* found = scene ? onlyPart(*scene) : nullptr;
            return found ? *found : Part{};
        });
        const auto row = [&](const char* what, int expected, std::function<double()> measure) {
            cases.push_back({design.id, design.title + std::string(", ") + what, double(expected),
                             exactly, "", design.source, std::move(measure)});
        };
        row("particles", design.particles, [=] { return double(part().particles.size()); });
        row("links", design.links, [=] { return double(part().links.size()); });
        row("panels", design.panels, [=] { return double(part().panels.size()); });
    }
}

} // namespace

std::vector<Case> countCases()
{
    std::vector<Case> cases;
    addLatticeCounts(cases);
    addDesignCounts(cases);
    return cases;
}

} // namespace ripstop
