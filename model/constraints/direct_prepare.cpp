// What DirectSolver works on.
//
// prepare() numbers the particles (those that move first, then pins), chooses whether the matrix is
// factorised, iterated, or either, analyses its pattern and finds islands that nothing holds.
// refresh() reads changed numbers and prepares anew only where more than numbers has changed.
// soften() follows the substep.
#include "constraints/direct_choice.h"
#include "constraints/direct_solver.h"
#include "constraints/guides.h"
#include "constraints/rod_damping.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ripstop {
namespace {

// Products of blocks for each node that take as long as an iteration; above which a few iterations
// cost less than a factorisation, of threads and where there are panels, and above which any number
// does (measured on sheets of 16, 32, 64 and 100 particles a side); and the nodes of blocks that
// are factorised in any case. A few iterations are enough for cloth, but where it folds. Rods
// without compliance are harder than their coarser networks can tell, so that canopies and kites of
// 500 to 5 000 particles fly up to twice as fast when they are factorised.
constexpr double productsOfIteration = 17.0;
constexpr double manyOfThreads = 100.0;
constexpr double manyOfPanels = 250.0;
constexpr double tooManyProducts = 700.0;
constexpr std::size_t fewNodes = 300;

constexpr double strainOfRigid = 1e-4; // under `greatLoad`
constexpr double greatLoad = 100.0;    // m/s^2, ten times gravity on all masses
constexpr double leastSoftness = 1e-8; // of the inverse masses of the ends, where none is given
constexpr double leastOfGiven = 1e-13; // below which rounding would decide how ends move
constexpr double shareOfWeight = 0.1;  // that pulls are compared with where they are less

} // namespace

void DirectSolver::prepare(const System& system, std::span<const int> rods, Triples triples)
{
    m_rods.assign(rods.begin(), rods.end());
    m_takesTriples = triples == Triples::Taken;
    std::vector<std::uint32_t> row = numberRows(system);
    takeBars(system, row);
    auto pairs = numberPairs();
    const double products = BlockCholesky::countProducts(nodes(), pairs);
    m_isElastic = isElastic(system);
    const double most = !m_isElastic       ? tooManyProducts
                        : m_panels.empty() ? manyOfThreads
                                           : manyOfPanels;
    m_hasGrid = nodes() > fewNodes && products > most * double(nodes());
    m_hasFactor = !m_hasGrid || products < tooManyProducts * double(nodes());
    m_worthIterating = m_hasGrid ? int(products / (productsOfIteration * double(nodes()))) : 0;
    if (m_hasGrid)
        pairs = prepareGrid(system, row);
    if (m_hasFactor)
        m_factor.analyze(nodes(), pairs);
    takeGuides(system);
    findIslands();
    takeValues(system);
    m_position.assign(m_particle.size(), Row{});
    m_move.assign(m_particle.size(), Row{});
    m_guess.assign(nodes(), Row{});
    m_from.assign(nodes(), Row{});
    for (std::vector<Row>* rows : {&m_rest, &m_way, &m_held, &m_sum})
        rows->assign(m_fabricBends.empty() ? 0 : nodes(), Row{});
    m_contacts.reserve(system.obstacles.empty() ? 0 : nodes());
}

// Numbers the rows anew, and returns the pairs of nodes by their new numbers.
std::vector<std::pair<int, int>> DirectSolver::prepareGrid(const System& system,
                                                           std::vector<std::uint32_t>& row)
{
    // Rows in the order of the particles and bars in the order of rows: a walk along either is
    // one through memory.
    std::sort(m_particle.begin(), m_particle.begin() + std::ptrdiff_t(nodes()));
    std::sort(m_particle.begin() + std::ptrdiff_t(nodes()), m_particle.end());
    for (std::size_t i = 0; i < m_particle.size(); ++i)
        row[std::size_t(m_particle[i])] = std::uint32_t(i);
    takeBars(system, row);
    std::ranges::stable_sort(m_bars, {}, [](const Bar& bar) { return std::minmax(bar.a, bar.b); });
    m_panels.sortByRow();
    const auto pairs = numberPairs();
    std::vector<std::pair<int, int>> anchors;
    const auto anchor = [&](std::uint32_t a, std::uint32_t b) {
        if (const auto [low, high] = std::minmax(a, b); low < nodes() && high >= nodes())
            anchors.emplace_back(low, high);
    };
    for (const Bar& bar : m_bars)
        anchor(bar.a, bar.b);
    forEachTriple([&](const Triple& triple) {
        for (const auto& [from, to] : sidesOfTriple)
            anchor(triple.row[from], triple.row[to]);
    });
    std::vector<Row> place;
    for (const int p : m_particle) {
        const Vec3& x = system.start.position[std::size_t(p)];
        place.push_back({{x.x(), x.y(), x.z(), 0.0}});
    }
    m_grid.analyze(nodes(), pairs, anchors, place, m_panels.empty());
    shareOutStripes();
    return pairs;
}

// Each particle gets its row where a rod, a panel or a bend first names it.
std::vector<std::uint32_t> DirectSolver::numberRows(const System& system)
{
    m_particle.clear();
    m_mass.clear();
    constexpr auto none = std::uint32_t(-1);
    std::vector<std::uint32_t> row(system.inverseMass.size(), none);
    for (const bool pins : {false, true}) {
        const auto number = [&](int particle) {
            const auto p = std::size_t(particle);
            if (row[p] != none || (system.inverseMass[p] == 0.0) != pins)
                return;
            row[p] = std::uint32_t(m_particle.size());
            m_particle.push_back(particle);
            if (!pins)
                m_mass.push_back(0.0);
        };
        for (const int r : m_rods) {
            number(system.rods[std::size_t(r)].a);
            number(system.rods[std::size_t(r)].b);
        }
        if (!m_takesTriples)
            continue;
        for (const Membrane& membrane : system.membranes)
            for (const int corner : system.panels[std::size_t(membrane.panel)].corner)
                number(corner);
        for (const Bend& bend : system.of<BendLists>().withRods())
            for (const int corner : bend.corner)
                number(corner);
    }
    return row;
}

void DirectSolver::takeBars(const System& system, std::span<const std::uint32_t> row)
{
    m_panels = {};
    m_bends = {};
    m_fabricBends = {};
    if (m_takesTriples) {
        m_panels.prepare(system, row);
        m_bends.prepare(system, row);
        m_fabricBends.prepare(system, row);
    }
    m_bars.clear();
    for (const int r : m_rods) {
        const Rod& rod = system.rods[std::size_t(r)];
        Bar bar;
        bar.rod = r;
        bar.a = row[std::size_t(rod.a)];
        bar.b = row[std::size_t(rod.b)];
        if (bar.a != bar.b && std::min(bar.a, bar.b) < nodes()) // something to move
            m_bars.push_back(bar);
    }
}

bool DirectSolver::isElastic(const System& system) const
{
    return std::ranges::all_of(
        m_bars, [&](const Bar& bar) { return system.rods[std::size_t(bar.rod)].compliance > 0.0; });
}

// Numbers the bars and sides of triples between two nodes and returns their ends.
std::vector<std::pair<int, int>> DirectSolver::numberPairs()
{
    std::vector<std::pair<int, int>> pairs;
    for (Bar& bar : m_bars)
        if (bar.a < nodes() && bar.b < nodes()) {
            bar.pair = int(pairs.size());
            pairs.emplace_back(bar.a, bar.b);
        }
    m_panels.numberPairs(nodes(), pairs);
    m_bends.numberPairs(nodes(), pairs);
    return pairs;
}

// Bars and panels go with the stripe of their first row.
void DirectSolver::shareOutStripes()
{
    const auto& stripes = m_grid.stripes().list;
    m_energyOf.assign(stripes.size(), 0.0);
    m_barsOf.assign(1, 0);
    m_panelsOf.assign(1, 0);
    for (const Stripe& stripe : stripes) {
        const auto rowOf = [](const Bar& bar) { return std::min(bar.a, bar.b); };
        m_barsOf.push_back(
            std::size_t(std::ranges::lower_bound(m_bars, stripe.last, {}, rowOf) - m_bars.begin()));
        const auto panels = m_panels.panels();
        m_panelsOf.push_back(std::size_t(std::ranges::lower_bound(panels, stripe.last, {}, firstRow)
                                         - panels.begin()));
    }
}

void DirectSolver::takeGuides(const System& system)
{
    m_guides.clear();
    if (system.guided.empty())
        return;
    m_guides.resize(m_particle.size());
    for (std::size_t i = 0; i < m_particle.size(); ++i)
        if (const GuidedParticle* guide = guideOf(system, m_particle[i]))
            m_guides[i] = {int(i), guide->guide, guide->axis};
    for (Bar& bar : m_bars)
        bar.guided = m_guides[bar.a].guide != Guide::None || m_guides[bar.b].guide != Guide::None;
}

void DirectSolver::refresh(const System& system)
{
    if (hasSamePins(system) && m_isElastic == isElastic(system)
        && (!m_takesTriples
            || (m_bends.areOf(system) && m_fabricBends.areOf(system) && m_panels.areOf(system))))
        takeValues(system);
    else
        prepare(system, std::vector<int>(m_rods), m_takesTriples ? Triples::Taken : Triples::Left);
}

bool DirectSolver::hasSamePins(const System& system) const
{
    for (std::size_t i = 0; i < m_particle.size(); ++i)
        if ((system.inverseMass[std::size_t(m_particle[i])] == 0.0) != (i >= nodes()))
            return false;
    const auto sameGuide = [&](std::size_t i) {
        const GuidedParticle* guide = guideOf(system, m_particle[i]);
        const Guide now = guide ? guide->guide : Guide::None;
        return m_guides.empty()
                   ? now == Guide::None
                   : m_guides[i].guide == now && (!guide || m_guides[i].axis == guide->axis);
    };
    for (std::size_t i = 0; i < m_particle.size(); ++i)
        if (!sameGuide(i))
            return false;
    return true;
}

void DirectSolver::takeValues(const System& system)
{
    m_h = 0.0;
    m_hasOneWay = false;
    std::fill(m_islandMass.begin(), m_islandMass.end(), 0.0);
    for (std::size_t i = 0; i < nodes(); ++i) {
        m_mass[i] = 1.0 / system.inverseMass[std::size_t(m_particle[i])];
        if (m_island[i] >= 0)
            m_islandMass[std::size_t(m_island[i])] += m_mass[i];
    }
    for (Bar& bar : m_bars) {
        const Rod& rod = system.rods[std::size_t(bar.rod)];
        bar.resists = rod.resists;
        m_hasOneWay |= rod.resists != Resists::Both;
        bar.isElastic = rod.compliance > 0.0;
        bar.weight =
            system.inverseMass[std::size_t(rod.a)] + system.inverseMass[std::size_t(rod.b)];
    }
}

void DirectSolver::soften(const System& system, double h)
{
    m_h = h;
    const double load = greatLoad * std::accumulate(m_mass.begin(), m_mass.end(), 0.0);
    for (Bar& bar : m_bars) {
        const Rod& rod = system.rods[std::size_t(bar.rod)];
        const double unseen = strainOfRigid * rod.restLength / load;
        bar.softness = bar.isElastic
                           ? std::max(complianceOver(rod, h) / (h * h), leastOfGiven * bar.weight)
                           : std::clamp(unseen / (h * h), leastSoftness * bar.weight,
                                        greatestSoftness * bar.weight);
    }
    m_fabricBends.takeValues(system, h);
    m_leastPulls = pullsThatMatter(system);
}

// The stiffest element under a tenth of all weight. What hangs, or is held by the air, pulls more
// than that in each of its rows. What falls freely has next to no pulls, of which no error would
// ever be a small enough share; and light scraps that fold as they fall would take all of the time.
double DirectSolver::pullsThatMatter(const System& system) const
{
    double softness = std::numeric_limits<double>::max();
    for (const Bar& bar : m_bars)
        if (bar.isElastic)
            softness = std::min(softness, bar.softness);
    for (const ElasticPanel& panel : m_panels.panels())
        softness = std::min(softness, m_panels.softness(system, panel, m_h));
    if (softness == std::numeric_limits<double>::max())
        return 0.0;
    const double mass = std::accumulate(m_mass.begin(), m_mass.end(), 0.0);
    const double pull = shareOfWeight * mass * loadingGravity(system) * m_h * m_h; // kg m
    return softness * pull * pull;
}

} // namespace ripstop
