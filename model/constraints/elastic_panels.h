// Panels that carry the pull of a fabric, as the direct solver has them (direct_solver.h):
// triangles of constant strain with the law of laws/cloth_law.h.
//
// A panel adds h^2 A w(e) to the sum that is minimised, w being the energy per area at Green's
// strain e. Its block of the matrix is that of Newton's method: B^T C B for the law, and the
// tension across the way of each corner, g_i . s g_j. Tension that pushes counts as 0 in the
// latter, and what is wrinkled or slack keeps a share of its taut stiffness (setKeptByFolds()): the
// matrix stays positive.
//
// Four panels are computed at a time (elastic_kernel.inl), by as many threads as there are: what a
// panel gets depends on no other. Sums are added panel by panel, in their order.
//
// Damping is Kelvin and Voigt's, as of rods (rod_damping.h): the strain that the threads had, e_b,
// is looked back to, and the law is that of e - r e_b, stiffer by 1 / (1 - r).
#pragma once

#include "constraints/rod_damping.h"
#include "constraints/triple.h"
#include "laws/cloth_pack.h"
#include "parallel/thread_pool.h"
#include "system/membrane.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ripstop {

struct ElasticPanel : Triple
{
    int membrane = 0; // in System::membranes
};

// The numbers of four panels side by side. The last four are filled up with panels that have no
// weight and no law, as those have that are gone.
struct FourPanels
{
    std::array<std::array<std::uint32_t, 4>, 3> row{}; // by corner, then panel
    Pack shape[4]{};                                   // 1/m, PanelCut::shape
    Pack weight{};                                     // kg m^2 over N m: h^2 A, stiffer by damping
    ClothLawPack law;
    Coordinates offset{};              // 1, r e_b above
    std::array<Coordinates, 2> axes{}; // 1, where the warp and the weft have gone
    ClothTensionPack now{};            // where the corners are, without what damping adds
    Coordinates tension{};             // N/m, that the linear system gave
    Coordinates before{};              // N/m, of the law where the move began
};

// What a panel that gives way has in the matrix beside its law, as a share of what it has when it
// is taut: cloth that folds switches between the two from one iteration to the next, and with
// nothing to resist that it goes too far each time.
struct KeptByFolds
{
    double most = 0.0;
    double least = 0.0;
};

class ElasticPanels
{
public:
    // Takes memory; nothing else does.
    //   row  [particles]  of the solver
    void prepare(const System& system, std::span<const std::uint32_t> row);

    // Whether these are still the panels of the system that carry something; their laws and cuts
    // may have changed.
    bool areOf(const System& system) const;

    // Puts panels in the order of their first rows, for large networks.
    void sortByRow();

    // Adds the pairs of nodes, of the first `nodes` rows, to those of the matrix.
    void numberPairs(std::size_t nodes, std::vector<std::pair<int, int>>& pairs);

    bool empty() const { return m_panels.empty(); }
    std::span<const ElasticPanel> panels() const { return m_panels; }

    // Before a substep: which panels are left, and what damping looks back to.
    void start(const System& system, std::span<const std::uint8_t> gone, const RodPast& past,
               ThreadPool& pool);

    // From the next measure() on: how much folds keep; less or more, within what was set.
    void setKeptByFolds(const KeptByFolds& kept) { m_kept = kept.most, m_mayKeep = kept; }

    // A quarter where the search goes astray, and sixteen times as much again once it has come to
    // its end: folds that keep little are true to the law, and folds that keep much are calm.
    void keepLess() { m_kept = std::max(0.25 * m_kept, m_mayKeep.least); }
    void keepMore() { m_kept = std::min(16.0 * m_kept, m_mayKeep.most); }

    // Where the rows are now; returns twice the energy of the law there, kg m^2.
    double measure(std::span<const Row> position, ThreadPool& pool);
    double energy() const; // that again

    // Whether twice the energy there is surely more than this, kg m^2; mostly told by a few panels.
    bool hasMoreThan(double twice, std::span<const Row> position) const;

    // What one adds to the matrix, by its place in panels().
    void fillBlock(std::size_t panel, TripleBlock& block) const;

    // Foresees the tension at the end of a move, as if the corners moved little; before measure().
    void foresee(std::span<const Row> move, ThreadPool& pool);

    // After measure(): what of the move was foreseen, as a share of it.
    void settle(double share);

    // After measure(): twice the energies of the pulls that were foreseen, and of what they differ
    // by from those of the law, kg m^2.
    struct Account
    {
        double pulls = 0.0;
        double errors = 0.0;
    };
    Account account() const;

    // How a panel gives way to a force in the plane, along its stiffer threads, over the square of
    // a substep `h`; 1/kg, 0 for one that has no stiffness.
    double softness(const System& system, const ElasticPanel& panel, double h) const;

private:
    void takeFours();
    void startFour(const System& system, std::span<const std::uint8_t> gone, const RodPast& past,
                   FourPanels& four);
    template <typename Body>
    void inParallel(ThreadPool& pool, Body body);

    std::vector<ElasticPanel> m_panels;
    std::vector<FourPanels> m_fours;
    KeptByFolds m_mayKeep;
    double m_kept = 0.0; // 1
};

} // namespace ripstop
