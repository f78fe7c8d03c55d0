// Region sorts the sides of its outline by line of pixels, so that a place asks only the few that
// cross its line, and counts windings.
//
// Taker projects all particles once, notes which lie inside, and prepares the occlusion unless all
// that lies there is wanted. It then takes particles, links and panels: those whose particles are
// all inside and of which some place can be seen (three places on a link, four on a panel). Each
// kind is shared out among threads and collected in order, so that the answer does not depend on
// how many there are.
#include "tools/region_select.h"

#include "camera/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

namespace ripstop {

Region::Region(std::vector<Eigen::Vector2d> outline)
{
    for (const Eigen::Vector2d& corner : outline)
        m_box.extend(corner);
    if (outline.empty())
        return;
    const auto lineOf = [this](double y) { return std::size_t(std::floor(y - m_box.min().y())); };
    m_sides.resize(lineOf(m_box.max().y()) + 1);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Side side{outline[i], outline[(i + 1) % outline.size()]};
        const auto [top, bottom] = std::minmax(side.from.y(), side.to.y());
        for (std::size_t line = lineOf(top); line <= lineOf(bottom); ++line)
            m_sides[line].push_back(side);
    }
}

// The winding number decides: how often the outline crosses the line to the right of the place
// upwards, less how often downwards.
bool Region::contains(double x, double y) const
{
    if (!m_box.contains(Eigen::Vector2d(x, y)))
        return false;
    int winding = 0;
    for (const Side& side : m_sides[std::size_t(std::floor(y - m_box.min().y()))]) {
        const bool fromAbove = side.from.y() <= y;
        if (fromAbove == (side.to.y() <= y))
            continue;
        const double share = (y - side.from.y()) / (side.to.y() - side.from.y());
        if (side.from.x() + share * (side.to.x() - side.from.x()) > x)
            winding += fromAbove ? 1 : -1;
    }
    return winding != 0;
}

namespace {

class Taker
{
public:
    Taker(const CameraView& view, bool panelsHide, const Region& region, Depth depth)
        : m_view(view)
        , m_layout(*view.frame.layout)
        , m_through(depth == Depth::Through)
        , m_points(projected(view))
        , m_occlusion(view, m_points, region.box(), panelsHide && !m_through)
    {
        m_inside.reserve(m_points.size());
        for (const OnScreen& point : m_points)
            m_inside.push_back(point.isSeen() && region.contains(point.x, point.y));
    }

    void takeParticles(std::vector<Id>& ids) const
    {
        const auto takes = [this](std::size_t i) {
            const int own[]{int(i)};
            return m_inside[i] && m_view.look.particleShown[i]
                   && isSeen({m_view.frame.position[i], own});
        };
        collect(m_points.size(), takes,
                [&](std::size_t i) { ids.push_back(Id(m_layout.particleId[i])); });
    }

    void takeLinks(std::vector<Id>& ids) const
    {
        const auto takes = [this](std::size_t i) {
            const std::array own{m_layout.links[i].a, m_layout.links[i].b};
            if (m_view.frame.torn[i] || !m_view.look.linkShown[i] || !areInside(own))
                return false;
            const Vec3& a = place(own[0]);
            const Vec3& b = place(own[1]);
            return isAnySeen(
                std::array<Vec3, 3>{0.5 * (a + b), 0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b}, own,
                Occlusion::foldOf((b - a).norm()));
        };
        collect(m_layout.links.size(), takes,
                [&](std::size_t i) { ids.push_back(Id(m_layout.links[i].id)); });
    }

    void takePanels(std::vector<Id>& ids) const
    {
        const auto takes = [this](std::size_t i) {
            const std::array<int, 3>& own = m_layout.panelCorners[i];
            if (m_view.frame.gone[i] || !m_view.look.panelShown[i] || !areInside(own))
                return false;
            const Vec3 middle = (place(own[0]) + place(own[1]) + place(own[2])) / 3.0;
            return isAnySeen(std::array<Vec3, 4>{middle, 0.5 * (middle + place(own[0])),
                                                 0.5 * (middle + place(own[1])),
                                                 0.5 * (middle + place(own[2]))},
                             own, 0.0);
        };
        collect(m_layout.panelId.size(), takes,
                [&](std::size_t i) { ids.push_back(Id(m_layout.panelId[i])); });
    }

private:
    const Vec3& place(int particle) const { return m_view.frame.position[std::size_t(particle)]; }

    // Calls add(i) for each row that is taken, in order; many are looked at on all processors.
    template <typename Takes, typename Add>
    void collect(std::size_t count, Takes takes, Add add) const
    {
        std::vector<char> taken(count, 0);
        const auto look = [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                taken[i] = takes(i);
        };
        constexpr std::size_t share = 20000; // rows that are worth a thread
        const std::size_t most = m_through ? 1 : std::max(1U, std::thread::hardware_concurrency());
        const std::size_t shares = std::clamp<std::size_t>(count / share, 1, most);
        {
            std::vector<std::jthread> others;
            for (std::size_t i = 1; i < shares; ++i)
                others.emplace_back(look, count * i / shares, count * (i + 1) / shares);
            look(0, count / shares);
        }
        for (std::size_t i = 0; i < count; ++i)
            if (taken[i])
                add(i);
    }

    bool areInside(std::span<const int> particles) const
    {
        return std::ranges::all_of(particles,
                                   [this](int i) { return m_inside[std::size_t(i)] != 0; });
    }
    bool isSeen(const Occlusion::Spot& spot) const { return m_through || !m_occlusion.hides(spot); }
    bool isAnySeen(std::span<const Vec3> places, std::span<const int> own, double slack) const
    {
        return std::ranges::any_of(places, [&](const Vec3& at) {
            return isSeen({at, own, slack});
        });
    }

    CameraView m_view;
    const Layout& m_layout;
    bool m_through;
    std::vector<OnScreen> m_points;
    std::vector<char> m_inside; // [particles]
    Occlusion m_occlusion;
};

} // namespace

std::vector<Id> elementsIn(const CameraView& view, const Pickable& pickable, const Region& region,
                           Depth depth)
{
    const Taker taker(view, pickable.drawn.panels, region, depth);
    std::vector<Id> ids;
    if (pickable.wanted.particles)
        taker.takeParticles(ids);
    if (pickable.links())
        taker.takeLinks(ids);
    if (pickable.panels())
        taker.takePanels(ids);
    std::ranges::sort(ids); // a tear may have doubled some ids
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

} // namespace ripstop
