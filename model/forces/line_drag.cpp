// Wind on the lines of a system.
//
// LineDragForce::list() finds the links whose material has a width for the wind, and the rows of
// lines at each particle. fillLineDrags() goes over the lines in parallel: a torn line has no drag,
// any other gets that of the wind at its middle less the mean velocity of its ends. Each end then
// takes half, as the lane says.
#include "forces/line_drag.h"

#include "base/key_index.h"
#include "forces/force.h"
#include "forces/wind.h"

#include <array>
#include <cmath>
#include <vector>

namespace ripstop {
namespace {

class LineDragForce final : public Force
{
public:
    Message name() const override { return Message("line drag"); }
    ForceKind kind() const override { return ForceKind::Air; }
    bool acts(const System& system, const State&) const override
    {
        return !system.of<LineLists>().list.empty() && system.airDensity > 0.0;
    }
    bool hangsOn(const Edited& e) const override { return e.materials || e.linkStuff; }
    void list(System& system) const override;
    void prepare(const System& system, const State&) override
    {
        m_drag.resize(system.of<LineLists>().list.size());
    }
    Lane fill(const System& system, const State& state, ThreadPool& pool) override
    {
        fillLineDrags(system, state, pool, m_drag);
        return {.load = m_drag.data(), .at = &system.of<LineLists>().at, .parts = 2.0};
    }

private:
    std::vector<PaddedVec3> m_drag; // [lines] N
};

// Lines of a system that was made by hand, which has no materials of links, stay as they are.
void LineDragForce::list(System& system) const
{
    auto& [lines, at] = system.of<LineLists>();
    if (!system.linkStuff.empty())
        lines.clear();
    KeyIndex airOf(system.materialAir.size());
    bool some = false;
    for (std::size_t i = 0; i < system.materialAir.size(); ++i) {
        airOf.add(system.materialAir[i].key, int(i));
        some |= system.materialAir[i].lineWidth > 0.0;
    }
    for (std::size_t i = 0; some && i < system.linkStuff.size(); ++i) {
        const int air = airOf(system.linkStuff[i].material);
        const double width = air < 0 ? 0.0 : system.materialAir[std::size_t(air)].lineWidth;
        if (width > 0.0)
            lines.push_back({int(i), system.links[i].a, system.links[i].b, width});
    }
    at.start.clear();
    at.items.clear();
    if (!lines.empty())
        fillIncidence(at, system.start.position.size(), lines, [](const DragLine& line) {
            return std::array{line.a, line.b};
        });
}

} // namespace

Vec3 lineDrag(double width, const Vec3& a, const Vec3& b, const Vec3& apparentWind,
              double airDensity)
{
    const Vec3 line = b - a;
    const double square = line.squaredNorm();
    if (square == 0.0)
        return Vec3::Zero();
    const Vec3 across = apparentWind - (apparentWind.dot(line) / square) * line;
    return (0.5 * airDensity * width * std::sqrt(square) * across.norm()) * across;
}

void fillLineDrags(const System& system, const State& state, ThreadPool& pool,
                   std::span<PaddedVec3> drag)
{
    const Vec3 common = commonWind(system, state);
    const bool isLocal = hasLocalWind(system, state);
    const std::vector<DragLine>& lines = system.of<LineLists>().list;
    pool.parallelFor(lines.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const DragLine& line = lines[i];
            if (isTorn(system.links[std::size_t(line.link)], state)) {
                drag[i] = PaddedVec3();
                continue;
            }
            const auto a = std::size_t(line.a);
            const auto b = std::size_t(line.b);
            Vec3 wind = common - 0.5 * (state.velocity[a] + state.velocity[b]);
            if (isLocal)
                wind += localWind(system, state, 0.5 * (state.position[a] + state.position[b]));
            drag[i] =
                lineDrag(line.width, state.position[a], state.position[b], wind, system.airDensity);
        }
    });
}

std::unique_ptr<Force> LineLists::makeForce() { return std::make_unique<LineDragForce>(); }

} // namespace ripstop
