// Spars sorts the ends of links by particle and material, and joins at each particle first the
// links of one material and then those that are left. The sorting makes the order of the bends
// depend on the network alone.
#include "laws/joined_spars.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>

namespace ripstop {
namespace {

// The lesser breaking moment, N m; 0 is none.
double weakerOf(double one, double other)
{
    return one > 0.0 && other > 0.0 ? std::min(one, other) : std::max(one, other);
}

class Spars
{
public:
    Spars(const BendingNet& net, std::vector<Bend>& bends)
        : m_net(net)
        , m_bends(bends)
    {}

    void addBends()
    {
        const std::vector<End> all = endsInOrder();
        for (auto first = all.begin(); first != all.end();) {
            const int particle = first->particle;
            std::vector<int> alone; // links that none of their own material continues
            while (first != all.end() && first->particle == particle) {
                std::vector<int> links;
                for (const std::uint32_t material = first->material;
                     first != all.end() && first->particle == particle
                     && first->material == material;
                     ++first)
                    links.push_back(first->link);
                std::ranges::copy(join(particle, links), std::back_inserter(alone));
            }
            join(particle, alone);
        }
    }

private:
    struct End
    {
        int particle;
        std::uint32_t material;
        int link;
    };

    std::vector<End> endsInOrder() const
    {
        std::vector<End> all;
        for (std::size_t i = 0; i < m_net.links.size(); ++i) {
            const BendingNet::Link& link = m_net.links[i];
            if (link.bending.spar > 0.0 && link.restLength > 0.0)
                for (const int particle : {link.a, link.b})
                    all.push_back({particle, link.material, int(i)});
        }
        std::sort(all.begin(), all.end(), [](const End& one, const End& other) {
            return std::tie(one.particle, one.material, one.link)
                   < std::tie(other.particle, other.material, other.link);
        });
        return all;
    }

    int otherEnd(int link, int particle) const
    {
        const BendingNet::Link& row = m_net.links[std::size_t(link)];
        return row.a == particle ? row.b : row.a;
    }

    Vec3 away(int link, int particle) const // unit, along the link, or zero
    {
        const Vec3 d = m_net.position[std::size_t(otherEnd(link, particle))]
                       - m_net.position[std::size_t(particle)];
        const double length = d.norm();
        return length > 0.0 ? Vec3(d / length) : Vec3(Vec3::Zero());
    }

    // Pairs links that meet in a particle, the straightest first; returns those that are left.
    std::vector<int> join(int particle, std::vector<int> links)
    {
        struct Pair
        {
            double straightness; // 1 is straight
            int one;
            int other;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < links.size(); ++i)
            for (std::size_t j = i + 1; j < links.size(); ++j) {
                const double along = -away(links[i], particle).dot(away(links[j], particle));
                if (along >= leastAlongOfSpars
                    && otherEnd(links[i], particle) != otherEnd(links[j], particle))
                    pairs.push_back({along, links[i], links[j]});
            }
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& one, const Pair& other) {
            return one.straightness > other.straightness;
        });
        const auto isFree = [&](int link) { return std::ranges::find(links, link) != links.end(); };
        for (const Pair& pair : pairs)
            if (isFree(pair.one) && isFree(pair.other)) {
                std::erase_if(links, [&](int l) { return l == pair.one || l == pair.other; });
                addBend(particle, pair.one, pair.other);
            }
        return links;
    }

    // m, of the spar that turns at an end of a link
    double turningOf(const BendingNet::Link& link) const
    {
        const bool clamped = m_net.pinned[std::size_t(link.a)] && m_net.pinned[std::size_t(link.b)];
        return clamped ? 0.0 : 0.5 * link.restLength;
    }

    // N m^2, of what turns: the turns of two halves add up.
    double rigidityOf(const BendingNet::Link& one, const BendingNet::Link& other) const
    {
        if (one.bending.spar == other.bending.spar)
            return one.bending.spar;
        const double p = turningOf(one), q = turningOf(other);
        return (p + q) / (p / one.bending.spar + q / other.bending.spar);
    }

    void addBend(int particle, int one, int other)
    {
        const BendingNet::Link& first = m_net.links[std::size_t(one)];
        const BendingNet::Link& second = m_net.links[std::size_t(other)];
        const double turning = turningOf(first) + turningOf(second);
        if (turning == 0.0)
            return;
        const double u = turning / first.restLength;
        const double v = turning / second.restLength;
        const int a = otherEnd(one, particle);
        const int b = otherEnd(other, particle);
        Bend bend{};
        bend.corner = {particle, a, b, particle};
        bend.weight = {-(u + v), u, v, 0.0};
        bend.stiffness = rigidityOf(first, second) / (turning * turning * turning);
        bend.breaking = weakerOf(first.bending.breaking, second.bending.breaking);
        bend.length = {first.restLength, second.restLength};
        const Vec3 turn = away(one, particle) + away(other, particle);
        bend.restTurn = turn.norm() > 1e-9 ? turning * turn.norm() : 0.0; // rounding is no bend
        bend.beside.fill(-1);
        bend.of = {one, other};
        bend.ofSpar = true;
        bend.withRods = m_net.solvesTogether && first.isRod && second.isRod;
        m_bends.push_back(bend);
    }

    const BendingNet& m_net;
    std::vector<Bend>& m_bends;
};

} // namespace

void addSparBends(const BendingNet& net, std::vector<Bend>& bends) { Spars(net, bends).addBends(); }

} // namespace ripstop
