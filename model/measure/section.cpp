#include "measure/section.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::size_t at(int index) { return std::size_t(index); }

// The particles of a part. Those that tears have added come last, and count as of the last one.
class Members
{
public:
    Members(const System& system, int particle)
    {
        const auto next = std::ranges::upper_bound(system.parts, particle, {}, &PartPlace::first);
        m_first = next == system.parts.begin() ? 0 : std::prev(next)->first;
        m_last = next == system.parts.end() ? std::numeric_limits<int>::max() : next->first;
    }
    bool has(const FabricPanel& panel) const
    {
        return std::ranges::any_of(panel.corner, [&](int p) { return p >= m_first && p < m_last; });
    }

private:
    int m_first;
    int m_last;
};

// Visits the corners of all panels that are left of the nose's part.
template <typename Visit> // visit(corners)
void forEachPanel(const System& system, const State& state, int nose, Visit visit)
{
    const Members members(system, nose);
    for (std::size_t p = 0; p < system.panels.size(); ++p) {
        if (state.panelGone[p] || !members.has(system.panels[p]))
            continue;
        const auto& [a, b, c] = system.panels[p].corner;
        visit(std::array<Vec3, 3>{state.position[at(a)], state.position[at(b)],
                                  state.position[at(c)]});
    }
}

Vec3 meanNormal(const System& system, const State& state, int nose)
{
    Vec3 sum = Vec3::Zero();
    forEachPanel(system, state, nose, [&](const std::array<Vec3, 3>& corner) {
        sum += (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    });
    return sum;
}

} // namespace

Camber camberOf(const ProbeSpec& probe, Readings& readings)
{
    const Camber none{nothing, nothing};
    if (probe.from < 0 || probe.particles.empty())
        return none;
    const System& system = readings.system();
    const State& state = readings.state();
    const int front = probe.particles.front();
    const Vec3 nose = state.position[at(front)];
    const Vec3 way = state.position[at(probe.from)] - nose;
    const Vec3 side = way.cross(meanNormal(system, state, front));
    if (!(side.norm() > 0.0))
        return none;
    const double length = way.norm();
    const Vec3 along = way / length;
    const Vec3 up = side.cross(way).normalized();
    Camber found = none;
    const auto take = [&](const Vec3& place) {
        const double position = (place - nose).dot(along) / length;
        const double height = std::abs((place - nose).dot(up)) / length;
        if (position >= 0.0 && position <= 1.0 && !(height <= found.height))
            found = {height, position};
    };
    forEachPanel(system, state, front, [&](const std::array<Vec3, 3>& corner) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = corner[k];
            const Vec3& b = corner[(k + 1) % 3];
            const double before = side.dot(a - nose), after = side.dot(b - nose);
            if (before == 0.0)
                take(a);
            if (before * after < 0.0)
                take(a + before / (before - after) * (b - a));
        }
    });
    return found;
}

} // namespace ripstop
