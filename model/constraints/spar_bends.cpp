// Each bend is looked at by itself, in the order of the list; sums are added in that order.
#include "constraints/spar_bends.h"

#include <algorithm>

namespace ripstop {
namespace {

Vec3 vec(const Row& row) { return {row.v[0], row.v[1], row.v[2]}; }

// Where the rows are.
void takeTurn(SparBend& bend, const Bend& law, std::span<const Row> x)
{
    const Vec3 at = vec(x[bend.row[0]]);
    const SparTurn spar =
        turnOf(law, {Vec3(vec(x[bend.row[1]]) - at), Vec3(vec(x[bend.row[2]]) - at)});
    bend.turn = spar.turn;
    bend.slope = {-(spar.slope[0] + spar.slope[1]), spar.slope[0], spar.slope[1]};
}

// 1, what is left of the stiffness for the moment, which is as long as the turn is over y_0.
double shareOfMoment(const SparBend& bend)
{
    if (bend.rest == 0.0)
        return 1.0;
    const double size = bend.turn.norm();
    return size > 0.0 ? 1.0 - bend.rest / size : 0.0;
}

// kg, how the moment changes with the turn.
Mat3 stiffnessOf(const SparBend& bend)
{
    const double share = shareOfMoment(bend);
    if (share == 1.0)
        return bend.stiffness * Mat3::Identity();
    const Vec3 along = bend.turn.normalized();
    const double across = std::max(share, 0.0);
    return bend.stiffness
           * ((1.0 - across) * along * along.transpose() + across * Mat3::Identity());
}

std::array<int, 3> cornersOf(const Bend& bend)
{
    return {bend.corner[0], bend.corner[1], bend.corner[2]};
}

} // namespace

void SparBends::prepare(const System& system, std::span<const std::uint32_t> row)
{
    m_bends.clear();
    m_corners.clear();
    const std::span all = system.of<BendLists>().withRods();
    m_laws.assign(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        m_corners.push_back(cornersOf(all[i]));
        SparBend bend;
        bend.bend = i;
        for (std::size_t k = 0; k < 2; ++k)
            bend.rod[k] = system.links[std::size_t(all[i].of[k])].index;
        bool moves = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto particle = std::size_t(all[i].corner[k]);
            bend.row[k] = row[particle];
            moves |= system.inverseMass[particle] > 0.0;
        }
        if (moves)
            m_bends.push_back(bend);
    }
}

bool SparBends::areOf(const System& system) const
{
    return std::ranges::equal(m_corners, system.of<BendLists>().withRods(), {}, {}, cornersOf);
}

void SparBends::numberPairs(std::size_t nodes, std::vector<std::pair<int, int>>& pairs)
{
    for (SparBend& bend : m_bends)
        ripstop::numberPairs(bend, nodes, pairs);
}

void SparBends::start(const System& system, std::span<const std::uint8_t> torn, double h)
{
    const std::span all = system.of<BendLists>().withRods();
    for (SparBend& bend : m_bends) {
        bend.gone = torn[std::size_t(bend.rod[0])] || torn[std::size_t(bend.rod[1])];
        bend.stiffness = h * h * all[bend.bend].stiffness;
        bend.rest = all[bend.bend].restTurn;
    }
    std::ranges::copy(all, m_laws.begin());
}

double SparBends::energy() const
{
    double twice = 0.0;
    for (const SparBend& bend : m_bends) {
        const double over = bend.turn.norm() - bend.rest;
        if (!bend.gone)
            twice += bend.stiffness * over * over;
    }
    return twice;
}

double SparBends::measure(std::span<const Row> position)
{
    for (SparBend& bend : m_bends) {
        takeTurn(bend, m_laws[bend.bend], position);
        bend.moment = bend.stiffness * shareOfMoment(bend) * bend.turn;
    }
    return energy();
}

TripleBlock SparBends::block(const SparBend& bend) const
{
    const Mat3 stiffness = stiffnessOf(bend);
    TripleBlock block;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [from, to] = sidesOfTriple[k];
        block.corner[k] = blockOf(bend.slope[k] * stiffness * bend.slope[k]);
        block.pair[k] = blockOf(bend.slope[from] * stiffness * bend.slope[to]);
        const Vec3 pull = -bend.slope[k] * bend.moment;
        block.pull[k] = {{pull[0], pull[1], pull[2], 0.0}};
    }
    return block;
}

void SparBends::foresee(std::span<const Row> move)
{
    for (SparBend& bend : m_bends) {
        bend.before = bend.moment;
        Vec3 turn = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            turn += bend.slope[k] * vec(move[bend.row[k]]);
        bend.foreseen = bend.moment + stiffnessOf(bend) * turn;
    }
}

void SparBends::settle(double share)
{
    for (SparBend& bend : m_bends)
        bend.foreseen = bend.before + share * (bend.foreseen - bend.before);
}

double SparBends::errors() const
{
    double twice = 0.0;
    for (const SparBend& bend : m_bends)
        if (!bend.gone)
            twice += (bend.moment - bend.foreseen).squaredNorm() / bend.stiffness;
    return twice;
}

} // namespace ripstop
