#include "constraints/rod_damping.h"

#include "laws/link_laws.h"

namespace ripstop {
namespace {

// B of the header.
double stretchBack(const Rod& rod, double restLength, const RodPast& past)
{
    const auto a = std::size_t(rod.a);
    const auto b = std::size_t(rod.b);
    const Vec3 separation = past.before[b] - past.before[a];
    const double last = separation.norm() - restLength;
    const bool isSlackNow = isSlack(rod.resists, last);
    if (past.drift.empty())
        return isSlackNow ? 0.0 : last;
    const Vec3 way = past.h * (past.drift[b] - past.drift[a]);
    const double earlier = (separation - way).norm() - restLength;
    const double back = ((isSlackNow ? 2.0 : 4.0) * last - earlier) / 3.0;
    return isSlack(rod.resists, back) ? 0.0 : back;
}

} // namespace

double complianceOver(const Rod& rod, double reach)
{
    return rod.compliance / (1.0 + rod.dampingTime / reach);
}

void RodDamping::prepare(const System& system)
{
    if (system.serial == m_serial && system.valuesSerial == m_valuesSerial)
        return;
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
    m_rods.clear();
    for (std::size_t r = 0; r < system.rods.size(); ++r)
        if (system.rods[r].dampingTime > 0.0 && system.rods[r].compliance > 0.0)
            m_rods.push_back(int(r));
}

std::span<const double> RodDamping::lengthsFor(const System& system,
                                               std::span<const double> restLength,
                                               const RodPast& past, ThreadPool& pool)
{
    if (m_rods.empty())
        return restLength;
    if (m_rods.size() < restLength.size())
        m_length.assign(restLength.begin(), restLength.end());
    m_length.resize(restLength.size());
    pool.parallelFor(m_rods.size(), [&](std::size_t first, std::size_t last) {
        for (const int rod : std::span(m_rods).subspan(first, last - first)) {
            const auto r = std::size_t(rod);
            const double time = system.rods[r].dampingTime;
            m_length[r] =
                restLength[r]
                + time / (time + past.reach) * stretchBack(system.rods[r], restLength[r], past);
        }
    });
    return m_length;
}

} // namespace ripstop
