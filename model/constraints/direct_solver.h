// Solves rods together by Newton's method: all of a system's, or a block of them; and with them the
// panels that carry a pull (elastic_panels.h), the bends of spars (spar_bends.h) and those of
// fabric that bends too stiffly to be a force (fabric_bends.h).
//
// In a substep it looks for the positions x that minimise
//
//     sum of 1/2 (x - y)^T M (x - y)  +  sum of C^2 / (2 s),      C = |d| - L,
//
// y being where the particles are without these rods: implicit Euler for what the rods do (Baraff
// and Witkin 1998), and XPBD's functional (Macklin, Mueller and Chentanez 2016) solved at once
// instead of rod by rod. M is the mass m, and where forces take from motion m + h D, D being what
// they fall by for each m/s: so air on light cloth bounds no step. A rod's block of the matrix is
// (n n^T + g s (1 - n n^T)) / s, n along the rod; g = multiplier / length is the stiffness that its
// pull gives it across. The multiplier in g is the one that the linear system gave before, at first
// that of the substep before: taken from the stretch of the guess it would freeze all swinging, and
// without g a heavy load on a light line diverges. Pushing rods count as g = 0, which keeps the
// matrix positive definite.
//
// s is the compliance of a rod over h^2. Rods without compliance get one that cannot be seen: ten
// times the weight of the block stretches them by 1e-4. That much is needed where frames have more
// rods than they can obey to rounding errors; it is 1e-8 to 1e-4 of the inverse masses of the ends.
//
// Each iteration goes only as far as it brings the sum down. Iterations end when no rod is further
// than `tolerance` of its length from where the linear system put it: one is enough in most
// substeps, and what it leaves is of second order. Which lines and struts act is decided anew in
// each (primal-dual active sets: Hintermueller, Ito and Kunisch 2002).
//
// Where a particle touches an obstacle, that is an element as well (held_contacts.h).
//
// A particle on a guide (laws/guide.h) moves by P: its rows and columns of the matrix are
// multiplied by P on either side but for its mass. What the system gives is exact for it as well.
//
// Heavy loads on light lines, where sweeps converge slowly, cost nothing extra. Chains, small
// frames and craft of up to some thousand particles are factorised (block_cholesky.h), which costs
// n for chains and n^1.5 for sheets; larger ones, and sheets of threads from some hundred particles
// on and of panels from a thousand on, are iterated with coarser networks in a time that grows like
// n (multigrid.h), as far as the pulls need it. Where cloth folds at each of its cells coarser
// networks tell little of it, and iterations are many: sheets of up to some thousand particles are
// then factorised for the rest of the substep. Implicit Euler damps what swings fast: a motion x''
// = -w^2 x loses the share w^2 h of its energy per second, for waves on tight lines all of it at
// once. Explicit forces beside it, air above all, keep their own limit of the step.
#pragma once

#include "constraints/bar.h"
#include "constraints/block_cholesky.h"
#include "constraints/elastic_panels.h"
#include "constraints/fabric_bends.h"
#include "constraints/held_contacts.h"
#include "constraints/multigrid.h"
#include "constraints/spar_bends.h"
#include "parallel/simd_pack.h"
#include "system/system.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct RodTask;

class DirectSolver
{
public:
    enum class Triples { Left, Taken };

    // Takes over `rods`, places in System::rods; others do not exist for it. It takes over all
    // panels that carry a pull and all bends that are solved with rods, or none. This takes memory,
    // and so does refresh() when pins, guides or bends have changed, or rods have got or lost all
    // compliance; nothing else does.
    void prepare(const System& system, std::span<const int> rods, Triples triples = Triples::Left);

    // Reads the numbers of the rods and the masses again, after they changed in place.
    void refresh(const System& system);

    // Reads what the block's rods start from: what is torn, rest lengths, and the multipliers of
    // the substep before.
    //   multiplier  [rods of the system]  kg m
    void start(const RodTask& task, std::span<const double> multiplier, ThreadPool& pool);

    // Moves the block's particles from where they are and fills the multipliers of its rods, in at
    // most so many iterations; returns how many it took. Fewer than two cannot follow a sudden
    // load.
    int project(const RodTask& task, std::span<double> multiplier, int iterations, ThreadPool& pool,
                double tolerance = 3e-4);

    // What the last project() has left unsolved, as an error of the pulls, 1: that of iterations,
    // and what pulls of panels differ by from their law.
    double residual() const { return m_residual; }

    // J, twice the energy that errors are compared with at least: they matter by a tenth of the
    // weight where pulls are less.
    double leastEnergy() const { return m_h > 0.0 ? m_leastPulls / (m_h * m_h) : 0.0; }
    bool isEmpty() const
    {
        return m_bars.empty() && m_panels.empty() && m_bends.empty() && m_fabricBends.empty();
    }

    // Whether something met its load in the last project(): a line or a strut, one that resists one
    // way only and stopped its ends (bar.h), or a particle an obstacle.
    bool hasImpact() const;
    bool hasOneWay() const { return m_hasOneWay; } // lines or struts

    // With the obstacles that the task lets it look for.
    std::span<const HeldContact> contacts() const { return m_contacts.list(); }

    std::span<const int> rods() const { return m_rods; }         // as given to prepare()
    std::size_t nodes() const { return m_mass.size(); }          // particles that are not pinned
    std::size_t products() const { return m_factor.products(); } // of blocks, in an iteration

private:
    struct Arrival // where a move has led
    {
        double worst = 0.0;  // 1, of the lengths, how far a rod misses where it was to be
        double errors = 0.0; // kg m^2, the sum of energyOfError()
        double pulls = 0.0;  // kg m^2, the sum of energyOfPull()
    };
    struct NodeRange // that something is added to
    {
        std::uint32_t first, last;
        bool has(std::uint32_t row) const { return row >= first && row < last; }
    };
    struct Starts // kg m^2, twice the sum that is minimised
    {
        double here = 0.0;
        double nearer = 0.0;
    };

    std::vector<std::uint32_t> numberRows(const System& system);
    void takeBars(const System& system, std::span<const std::uint32_t> row);
    std::vector<std::pair<int, int>> numberPairs();
    std::vector<std::pair<int, int>> prepareGrid(const System& system,
                                                 std::vector<std::uint32_t>& row);
    bool isElastic(const System& system) const; // all rods have compliance
    bool hasSamePins(const System& system) const;
    void takeGuides(const System& system);
    void shareOutStripes();
    void takeValues(const System& system);
    void soften(const System& system, double h);
    void measure(ThreadPool& pool);
    double assemble(ThreadPool& pool);
    double addMasses(std::size_t first, std::size_t last);
    double addBars(std::size_t first, std::size_t last);
    void addPanelsByNodes(ThreadPool& pool);
    void addPanels(std::size_t first, std::size_t last, const NodeRange& to);
    void addTriple(const Triple& triple, const TripleBlock& block, const NodeRange& to);
    void addFreeTriple(const Triple& triple, const TripleBlock& block, const NodeRange& to);
    NodeRange allNodes() const { return {0, std::uint32_t(nodes())}; }
    Mat3 onGuides(std::uint32_t row) const;
    void addContacts();
    void foresee(Bar& bar) const;
    Arrival arrive(ThreadPool& pool);
    Arrival arriveOf(std::size_t first, std::size_t last);
    void takeShare(double share);
    void takePositions(std::span<const PaddedVec3> position, ThreadPool& pool);
    void startNearer(const RodTask& task, ThreadPool& pool);
    Starts startsOf(std::size_t first, std::size_t last);
    double startBars(const RodTask& task, std::span<const double> multiplier, std::size_t first,
                     std::size_t last);
    double foreseenPull(const Bar& bar, const RodTask& task) const; // kg m
    bool solveForMoves(ThreadPool& pool);
    bool iterate(ThreadPool& pool);
    void solveWithBends(ThreadPool& pool);
    double addBeyond(std::span<const Row> x, std::span<Row> y, ThreadPool& pool);
    void keepOnGuides(std::span<Row> rows) const;
    double goalOfIterations() const; // sqrt(kg) m
    double scaleOfErrors() const;    // sqrt(kg) m
    double pullsThatMatter(const System& system) const;
    double pulls() const { return std::max(m_pulls, m_leastPulls); } // kg m^2
    double energyOfWay(std::size_t node) const;
    template <typename Visit> // visit(triple)
    void forEachTriple(Visit visit) const
    {
        for (const ElasticPanel& panel : m_panels.panels())
            visit(panel);
        for (const SparBend& bend : m_bends.bends())
            visit(bend);
    }
    BlockCholesky::Block& diagonal(std::size_t node)
    {
        return m_iterates ? m_grid.diagonal(node) : m_factor.diagonal(node);
    }
    BlockCholesky::Block& pair(std::size_t index)
    {
        return m_iterates ? m_grid.pair(index) : m_factor.pair(index);
    }
    void go(double share, ThreadPool& pool);
    double goDown(double before, ThreadPool& pool);
    double merit() const;
    void findIslands();
    void keepCenters();
    void keepDraggedCenters();
    void leaveHeldIslands();
    void guessPushes(const RodTask& task);
    double energyLeft(double share) const;
    std::span<const int> rowsThatMove() const { return {m_particle.data(), nodes()}; }
    void takeDamping(const RodTask& task);
    void addOnGuides(const Bar& bar);
    void moveAlongGuides();
    void moveAlongGuide(std::size_t row, Row& move) const;

    std::vector<int> m_rods;   // as given to prepare()
    double m_h = 0.0;          // s, for which softness is right
    double m_accuracy = 0.01;  // 1, System::accuracy
    double m_pulls = 0.0;      // kg m^2, the sum of energyOfPull()
    double m_leastPulls = 0.0; // kg m^2, what errors are compared with where pulls are less
    double m_loads = 0.0;      // kg m^2, twice the energy of what loads would move in the substep
    double m_left = 0.0;       // sqrt(kg) m, the root of the energy of what iterations have left
    double m_residual = 0.0;   // 1
    bool m_isElastic = false;  // when it was prepared
    bool m_hasGrid = false;
    bool m_hasFactor = true;
    int m_worthIterating = 0; // iterations that cost less than a factorisation
    bool m_iterates = false;  // now
    BlockCholesky m_factor;   // of the matrix, or
    Multigrid m_grid;         // for a large one
    std::vector<Bar> m_bars;
    std::vector<std::size_t> m_barsOf, m_panelsOf; // [stripes of the grid + 1] first of each
    std::vector<double> m_energyOf;                // [stripes] scratch
    bool m_hasOneWay = false;                      // a line or a strut among them
    bool m_takesTriples = false;
    ElasticPanels m_panels;
    SparBends m_bends;
    FabricBends m_fabricBends;
    HeldContacts m_contacts;
    double m_tripleErrors = 0.0; // kg m^2, the sum of what their pulls differ by from their law
    std::vector<int> m_particle; // [rows] particle; nodes first, then pins
    std::vector<double> m_mass;  // [nodes] kg
    std::vector<Mat3> m_drag;    // [nodes] kg, h D above, or empty
    std::vector<GuidedParticle> m_guides; // [rows] by row instead of particle; empty without any
    std::vector<int> m_island;            // [nodes] what rods join, or -1 when a pin is among it
    std::vector<double> m_islandMass;     // [islands] kg
    std::vector<Row> m_drift;             // [islands] kg m
    std::vector<Mat3> m_islandDrag;       // [islands] kg
    std::vector<Row> m_position;          // [rows] m
    std::vector<Row> m_guess;             // [nodes] m, y above
    std::vector<Row> m_from;              // [nodes] m, before the iteration
    std::vector<Row> m_move;              // [rows] the right-hand side, then m
    std::vector<Row> m_rest, m_way, m_held, m_sum; // [nodes] of solveWithBends()
};

// Twice what a node is of the sum that is minimised, kg m^2.
RIPSTOP_INLINE double DirectSolver::energyOfWay(std::size_t i) const
{
    Row way;
    pack(way.v) = pack(m_position[i].v) - pack(m_guess[i].v);
    double twice = m_mass[i] * dot(way, way);
    if (!m_drag.empty()) {
        const Vec3 w(way.v[0], way.v[1], way.v[2]);
        twice += w.dot(m_drag[i] * w);
    }
    return twice;
}

} // namespace ripstop
