// Each panel is looked at by itself, in the order of System::membranes or of rows. What all of them
// need at every place is the kernel's; what the matrix gets of a panel, once in an iteration, is
// found here, with vectors of the plane in one pack. Gradients of the corners are the rows of the
// inverse of the panel's shape, that of the first corner being minus the sum of the others.
#include "constraints/elastic_panels.h"

#include <algorithm>
#include <cmath>

#define RIPSTOP_KERNEL "constraints/elastic_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {
namespace {

struct Tension // N/m
{
    double warp, weft, shear;
};

struct Tangent // N/m, symmetric
{
    double warp, weft, shear, warpWeft, warpShear, weftShear;
};

RIPSTOP_INLINE Tension laneOf(const Coordinates& tension, int lane)
{
    return {tension.x[lane], tension.y[lane], tension.z[lane]};
}

RIPSTOP_INLINE Tangent laneOf(const ClothStiffnessPack& s, int lane)
{
    return {s.warp[lane],     s.weft[lane],      s.shear[lane],
            s.warpWeft[lane], s.warpShear[lane], s.weftShear[lane]};
}

struct Square // of warp and weft, by row and column
{
    double ww, wf, fw, ff;
};

// How the strain changes as a corner moves, in the frame of where the warp and the weft have gone,
// 1/m: that of the warp by `a`, of the weft by `b`, the shear by both, crosswise.
struct StrainPerMove
{
    double a, b;

    // In the places of one corner and of another, L^T C L'.
    RIPSTOP_INLINE Square between(const Tangent& c, const StrainPerMove& other) const
    {
        const double p = other.a, q = other.b;
        return {a * (c.warp * p + c.warpShear * q) + b * (c.warpShear * p + c.shear * q),
                a * (c.warpWeft * q + c.warpShear * p) + b * (c.weftShear * q + c.shear * p),
                b * (c.warpWeft * p + c.weftShear * q) + a * (c.warpShear * p + c.shear * q),
                b * (c.weft * q + c.weftShear * p) + a * (c.weftShear * q + c.shear * p)};
    }

    // What a tension resists with where the panel turns, g_i . s g_j.
    RIPSTOP_INLINE double across(const Tension& s, const StrainPerMove& other) const
    {
        return a * (s.warp * other.a + s.shear * other.b)
               + b * (s.shear * other.a + s.weft * other.b);
    }

    RIPSTOP_INLINE Pack pull(const Pack& warp, const Pack& weft, const Tension& s) const
    {
        return (a * s.warp + b * s.shear) * warp + (b * s.weft + a * s.shear) * weft;
    }
};

// The nearest tension that pushes nowhere.
RIPSTOP_INLINE Tension pullingPart(const Tension& s)
{
    const double mean = 0.5 * (s.warp + s.weft);
    const double half = 0.5 * (s.warp - s.weft);
    const double radius = __builtin_sqrt(half * half + s.shear * s.shear);
    if (mean >= radius)
        return s;
    if (mean + radius <= 0.0)
        return {0.0, 0.0, 0.0};
    const double most = 0.5 * (mean + radius);
    return {most * (1.0 + half / radius), most * (1.0 - half / radius), most * s.shear / radius};
}

struct PlacedPanel
{
    Pack warp; // 1, where it has gone
    Pack weft;
    double weight; // kg m^2 over N m
    Tension pulling;
    Tangent tangent;

    RIPSTOP_INLINE PlacedPanel(const FourPanels& four, int lane)
        : warp{four.axes[0].x[lane], four.axes[0].y[lane], four.axes[0].z[lane], 0.0}
        , weft{four.axes[1].x[lane], four.axes[1].y[lane], four.axes[1].z[lane], 0.0}
        , weight(four.weight[lane])
        , pulling(pullingPart(laneOf(four.now.tension, lane)))
        , tangent(laneOf(four.now.stiffness, lane))
    {}

    // Between two corners: the law, and the tension across their ways.
    RIPSTOP_INLINE void fill(BlockCholesky::Block& block, const StrainPerMove& one,
                             const StrainPerMove& other) const
    {
        const Square m = one.between(tangent, other);
        const double across = weight * one.across(pulling, other);
        const Pack alongWarp = weight * m.ww * warp + weight * m.fw * weft;
        const Pack alongWeft = weight * m.wf * warp + weight * m.ff * weft;
        for (int c = 0; c < 3; ++c)
            pack(block.column[c]) =
                alongWarp * warp[c] + alongWeft * weft[c] + BlockCholesky::diagonalPart(c, across);
    }
};

// sum <- -(a + b)
RIPSTOP_INLINE void takeBoth(BlockCholesky::Block& sum, const BlockCholesky::Block& a,
                             const BlockCholesky::Block& b)
{
    for (int c = 0; c < 3; ++c)
        pack(sum.column[c]) = -(pack(a.column[c]) + pack(b.column[c]));
}

// Whether there is something to pull and something to move.
bool takesPart(const System& system, const Membrane& membrane)
{
    return lawOf(system, membrane).isElastic()
           && std::ranges::any_of(
               system.panels[std::size_t(membrane.panel)].corner,
               [&](int corner) { return system.inverseMass[std::size_t(corner)] > 0.0; });
}

} // namespace

void ElasticPanels::prepare(const System& system, std::span<const std::uint32_t> row)
{
    m_panels.clear();
    for (std::size_t m = 0; m < system.membranes.size(); ++m) {
        const Membrane& membrane = system.membranes[m];
        if (!takesPart(system, membrane))
            continue;
        ElasticPanel panel;
        panel.membrane = int(m);
        for (std::size_t k = 0; k < 3; ++k)
            panel.row[k] = row[std::size_t(system.panels[std::size_t(membrane.panel)].corner[k])];
        m_panels.push_back(panel);
    }
    takeFours();
}

bool ElasticPanels::areOf(const System& system) const
{
    const auto carries = [&](const Membrane& membrane) { return takesPart(system, membrane); };
    const auto stays = [&](const ElasticPanel& panel) {
        return std::size_t(panel.membrane) < system.membranes.size()
               && carries(system.membranes[std::size_t(panel.membrane)]);
    };
    return std::size_t(std::ranges::count_if(system.membranes, carries)) == m_panels.size()
           && std::ranges::all_of(m_panels, stays);
}

void ElasticPanels::sortByRow()
{
    std::ranges::stable_sort(m_panels, {}, firstRow);
    takeFours();
}

void ElasticPanels::takeFours()
{
    FourPanels none;
    for (int lane = 0; lane < 4; ++lane)
        none.law.clear(lane);
    m_fours.assign((m_panels.size() + 3) / 4, none);
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            m_fours[i / 4].row[k][i % 4] = m_panels[i].row[k];
}

void ElasticPanels::numberPairs(std::size_t nodes, std::vector<std::pair<int, int>>& pairs)
{
    for (ElasticPanel& panel : m_panels)
        ripstop::numberPairs(panel, nodes, pairs);
}

// Goes over the fours of a range of panels.
template <typename Body> // body(fours)
void ElasticPanels::inParallel(ThreadPool& pool, Body body)
{
    pool.parallelFor(m_panels.size(), [&](std::size_t first, std::size_t last) {
        const std::size_t from = (first + 3) / 4, to = (last + 3) / 4;
        body(std::span(m_fours).subspan(from, to - from));
    });
}

void ElasticPanels::start(const System& system, std::span<const std::uint8_t> gone,
                          const RodPast& past, ThreadPool& pool)
{
    inParallel(pool, [&](std::span<FourPanels> fours) {
        for (FourPanels& four : fours)
            startFour(system, gone, past, four);
    });
}

void ElasticPanels::startFour(const System& system, std::span<const std::uint8_t> gone,
                              const RodPast& past, FourPanels& four)
{
    const std::size_t first = 4 * std::size_t(&four - m_fours.data());
    bool isDamped = false;
    Pack share{}; // r
    Coordinates last{}, back{};
    for (std::size_t k = 0; k < std::min<std::size_t>(4, m_panels.size() - first); ++k) {
        ElasticPanel& panel = m_panels[first + k];
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const int lane = int(k);
        panel.gone = gone[std::size_t(membrane.panel)] != 0;
        four.weight[lane] = panel.gone ? 0.0 : past.reach * past.reach * membrane.area;
        const PieceLaw law = lawOf(system, membrane);
        if (panel.gone)
            four.law.clear(lane);
        else
            four.law.set(lane, law);
        for (std::size_t i = 0; i < 4; ++i)
            four.shape[i][lane] = membrane.shape[i];
        if (panel.gone || law.dampingTime == 0.0)
            continue;
        isDamped = true;
        share[lane] = law.dampingTime / (law.dampingTime + past.reach);
        four.weight[lane] /= 1.0 - share[lane];
        Corners corners = cornersOf(system, membrane, past.before);
        last.set(lane, strainAt(membrane, corners));
        if (past.drift.empty())
            continue;
        const Corners way = cornersOf(system, membrane, past.drift);
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners[corner] -= past.h * way[corner];
        back.set(lane, strainAt(membrane, corners));
    }
    four.offset = Coordinates{};
    if (!isDamped)
        return;
    const auto leaveThreads = wideMachine ? wide::leaveThreads : anywhere::leaveThreads;
    leaveThreads(four.law, last);
    if (!past.drift.empty()) {
        leaveThreads(four.law, back);
        last = {(4.0 * last.x - back.x) / 3.0, (4.0 * last.y - back.y) / 3.0,
                (4.0 * last.z - back.z) / 3.0};
    }
    four.offset = {share * last.x, share * last.y, share * last.z};
    four.law.bucklingLoad *= 1.0 - share; // in all, with the weight: folds are not damped
}

double ElasticPanels::energy() const
{
    double twice = 0.0;
    for (const FourPanels& four : m_fours)
        for (int lane = 0; lane < 4; ++lane)
            twice += 2.0 * four.weight[lane] * four.now.energy[lane];
    return twice;
}

bool ElasticPanels::hasMoreThan(double twice, std::span<const Row> position) const
{
    return (wideMachine ? wide::takeAll : anywhere::takeAll)(m_fours, position.data(), twice);
}

double ElasticPanels::measure(std::span<const Row> position, ThreadPool& pool)
{
    inParallel(pool, [&](std::span<FourPanels> fours) {
        (wideMachine ? wide::measureFours : anywhere::measureFours)(fours, position.data(), m_kept);
    });
    return energy();
}

// What the first corner has is minus what the two others have together, in each row and column.
RIPSTOP_CLONES
void ElasticPanels::fillBlock(std::size_t panel, TripleBlock& block) const
{
    const FourPanels& four = m_fours[panel / 4];
    const int lane = int(panel % 4);
    const PlacedPanel at(four, lane);
    const Tension tension = laneOf(four.now.tension, lane);
    const StrainPerMove second{four.shape[0][lane], four.shape[1][lane]};
    const StrainPerMove third{four.shape[2][lane], four.shape[3][lane]};
    at.fill(block.corner[1], second, second);
    at.fill(block.corner[2], third, third);
    at.fill(block.pair[1], second, third);
    takeBoth(block.pair[0], block.corner[1], transposed(block.pair[1])); // first and second
    takeBoth(block.pair[2], block.corner[2], transposed(block.pair[1])); // third and first
    takeBoth(block.corner[0], block.pair[0], transposed(block.pair[2]));

    pack(block.pull[1].v) = -at.weight * second.pull(at.warp, at.weft, tension);
    pack(block.pull[2].v) = -at.weight * third.pull(at.warp, at.weft, tension);
    pack(block.pull[0].v) = -(pack(block.pull[1].v) + pack(block.pull[2].v));
}

void ElasticPanels::foresee(std::span<const Row> move, ThreadPool& pool)
{
    inParallel(pool, [&](std::span<FourPanels> fours) {
        (wideMachine ? wide::foreseeFours : anywhere::foreseeFours)(fours, move.data());
    });
}

void ElasticPanels::settle(double share)
{
    for (FourPanels& four : m_fours) {
        Coordinates& tension = four.tension;
        tension.x = four.before.x + share * (tension.x - four.before.x);
        tension.y = four.before.y + share * (tension.y - four.before.y);
        tension.z = four.before.z + share * (tension.z - four.before.z);
    }
}

ElasticPanels::Account ElasticPanels::account() const
{
    Account account;
    (wideMachine ? wide::addUp : anywhere::addUp)(m_fours, account);
    return account;
}

double ElasticPanels::softness(const System& system, const ElasticPanel& panel, double h) const
{
    const PieceLaw law = lawOf(system, system.membranes[std::size_t(panel.membrane)]);
    const double stiffness = std::max(law.warp, law.weft); // N/m
    return stiffness > 0.0 ? 1.0 / (stiffness * h * h) : 0.0;
}

} // namespace ripstop
