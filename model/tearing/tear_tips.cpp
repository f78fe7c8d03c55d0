// look() goes over the particles of fabric that has a tear energy; addTip() lays the panels around
// one out in a plane, by the sides that they share, so that gradients of panels with different
// grains can be added up.
#include "tearing/tear_tips.h"

#include "system/membrane.h"
#include "tearing/panel_tearing.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using Plane = Eigen::Vector2d;
using FlatCorners = std::array<Plane, 3>;

FlatCorners flatCorners(const Membrane& membrane) // m, in the frame of the panel
{
    const auto& s = membrane.shape;
    const double scale = 1.0 / (s[0] * s[3] - s[1] * s[2]);
    return {Plane(0.0, 0.0), Plane(scale * s[3], -scale * s[2]),
            Plane(-scale * s[1], scale * s[0])};
}

double cross(const Plane& a, const Plane& b) { return a.x() * b.y() - a.y() * b.x(); }

double angleAt(const FlatCorners& flat, std::size_t k)
{
    const Plane a = flat[(k + 1) % 3] - flat[k], b = flat[(k + 2) % 3] - flat[k];
    return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

std::span<const int> panelsAt(const System& system, int particle)
{
    const Rows& rows = system.panelsAt;
    const int first = rows.start[std::size_t(particle)];
    return std::span(rows.items)
        .subspan(std::size_t(first), std::size_t(rows.start[std::size_t(particle) + 1] - first));
}

} // namespace

bool TearTips::isNear(const System& system, int panel) const
{
    return !m_near.empty() && m_near[std::size_t(panel)]
           && tearOf(system, system.membranes[std::size_t(m_membrane[std::size_t(panel)])]).energy
                  > 0.0;
}

bool TearTips::isTip(const System& system, const State& state, int particle) const
{
    constexpr double notched = 220.0 / 180.0 * std::numbers::pi; // rad, of fabric around it
    double around = 0.0;
    std::array<int, 64> ends{};
    std::size_t count = 0;
    for (const int panel : panelsAt(system, particle)) {
        const int membrane = m_membrane[std::size_t(panel)];
        if (membrane < 0 || state.panelGone[std::size_t(panel)])
            continue;
        const auto& corner = system.panels[std::size_t(panel)].corner;
        const auto k = std::size_t(std::ranges::find(corner, particle) - corner.begin());
        around += angleAt(flatCorners(system.membranes[std::size_t(membrane)]), k);
        if (count + 2 > ends.size())
            return false;
        ends[count++] = corner[(k + 1) % 3];
        ends[count++] = corner[(k + 2) % 3];
    }
    if (around < notched)
        return false;
    std::sort(ends.begin(), ends.begin() + std::ptrdiff_t(count));
    int open = 0; // sides that a single panel has
    for (std::size_t i = 0; i < count;) {
        const std::size_t first = i;
        while (i < count && ends[i] == ends[first])
            ++i;
        open += i - first == 1;
    }
    return open == 2;
}

// The panel is turned, and turned over if need be, so that its corners a and b come to where they
// are and its third one to the other side.
TearTips::Placed TearTips::layBeside(int panel, const FlatCorners& flat, std::size_t a,
                                     std::size_t b, const Plane& placeA, const Plane& placeB,
                                     const Plane& other)
{
    const Plane from = (flat[b] - flat[a]).normalized(), to = (placeB - placeA).normalized();
    Turn along;
    along << from.x(), -from.y(), from.y(), from.x();
    Turn ahead;
    ahead << to.x(), -to.y(), to.y(), to.x();
    const std::size_t c = 3 - a - b;
    const double side = cross(from, flat[c] - flat[a]);
    const double sideOfOther = cross(to, other - placeA);
    Turn over = Turn::Identity();
    if ((side > 0.0) == (sideOfOther > 0.0))
        over(1, 1) = -1.0;
    Placed placed{panel, ahead * over * along.transpose(), {}};
    for (std::size_t k = 0; k < 3; ++k)
        placed.at[k] = placeA + placed.turn * (flat[k] - flat[a]);
    return placed;
}

std::vector<int> TearTips::panelsHere(const System& system, const State& state, int particle) const
{
    std::vector<int> panels;
    for (const int panel : panelsAt(system, particle))
        if (m_membrane[std::size_t(panel)] >= 0 && !state.panelGone[std::size_t(panel)])
            panels.push_back(panel);
    return panels;
}

FlatCorners TearTips::flatOf(const System& system, int panel) const
{
    return flatCorners(system.membranes[std::size_t(m_membrane[std::size_t(panel)])]);
}

// Lays the panels out, each beside one that is laid, from one at the tip on.
std::vector<TearTips::Placed> TearTips::laidOut(const System& system, std::vector<int> panels,
                                                int particle) const
{
    const auto cornersOfPanel = [&](int panel) -> const std::array<int, 3>& {
        return system.panels[std::size_t(panel)].corner;
    };
    std::vector<Placed> placed;
    const auto first = std::ranges::find_if(
        panels, [&](int panel) { return std::ranges::count(cornersOfPanel(panel), particle) > 0; });
    if (first == panels.end())
        return placed;
    placed.push_back({*first, Turn::Identity(), flatOf(system, *first)});
    panels.erase(first);
    for (std::size_t n = 0; n < placed.size(); ++n) {
        const Placed from = placed[n];
        std::erase_if(panels, [&](int panel) {
            const auto& theirs = cornersOfPanel(from.panel);
            const auto& corner = cornersOfPanel(panel);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t l = (k + 1) % 3;
                const auto a = std::size_t(std::ranges::find(corner, theirs[k]) - corner.begin());
                const auto b = std::size_t(std::ranges::find(corner, theirs[l]) - corner.begin());
                if (a == 3 || b == 3)
                    continue;
                placed.push_back(layBeside(panel, flatOf(system, panel), a, b, from.at[k],
                                           from.at[l], from.at[(k + 2) % 3]));
                return true;
            }
            return false;
        });
    }
    return placed;
}

void TearTips::addTip(const System& system, const State& state, int particle)
{
    const auto sortOnce = [](std::vector<int>& numbers) {
        std::ranges::sort(numbers);
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    };
    std::vector<int> moved{particle}; // particles that are set on with it
    for (const int panel : panelsHere(system, state, particle))
        for (const int corner : system.panels[std::size_t(panel)].corner)
            moved.push_back(corner);
    sortOnce(moved);
    std::vector<int> panels;
    for (const int p : moved)
        for (const int panel : panelsHere(system, state, p))
            panels.push_back(panel);
    sortOnce(panels);

    Tip tip;
    for (const Placed& one : laidOut(system, std::move(panels), particle)) {
        const int membrane = m_membrane[std::size_t(one.panel)];
        const auto& corner = system.panels[std::size_t(one.panel)].corner;
        RingPanel ring{membrane, one.turn, Plane::Zero(), std::ranges::count(corner, particle) > 0};
        for (int k = 0; k < 3; ++k)
            if (std::ranges::binary_search(moved, corner[std::size_t(k)])) {
                const auto slope = gradient(system.membranes[std::size_t(membrane)], k);
                ring.slope += one.turn * Plane(slope[0], slope[1]);
            }
        tip.push_back(ring);
        m_near[std::size_t(one.panel)] = 1;
    }
    m_tips.push_back(std::move(tip));
}

void TearTips::look(const System& system, const State& state)
{
    const auto runs = [](const FabricTear& tear) { return tear.energy > 0.0; };
    const bool looks = std::ranges::any_of(system.clothTear, runs);
    if (m_looks == looks && m_serial == system.serial && (!looks || m_gone == state.panelGone))
        return;
    m_looks = looks;
    m_serial = system.serial;
    m_gone = state.panelGone;
    m_tips.clear();
    m_near.clear();
    if (!looks)
        return;
    m_membrane.assign(system.panels.size(), -1);
    for (std::size_t i = 0; i < system.membranes.size(); ++i)
        if (lawOf(system, system.membranes[i]).isElastic())
            m_membrane[std::size_t(system.membranes[i].panel)] = int(i);
    m_near.assign(system.panels.size(), 0);
    for (std::size_t p = 0; p < system.key.size(); ++p)
        if (isTip(system, state, int(p)))
            addTip(system, state, int(p));
}

double TearTips::forceAt(const System& system, const State& state, const Tip& tip) const
{
    using Gradient = Eigen::Matrix<double, 3, 2>;
    const auto gradientOf = [&](const RingPanel& panel) -> Gradient {
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const Corners at = cornersOf(system, membrane, state.position);
        const ClothAxes axes = axesOf(membrane, at[1] - at[0], at[2] - at[0]);
        Gradient own;
        own << axes[0], axes[1];
        return own * panel.turn.transpose();
    };
    Gradient mean = Gradient::Zero();
    for (const RingPanel& panel : tip)
        if (panel.atTip)
            mean += system.membranes[std::size_t(panel.membrane)].area * gradientOf(panel);
    const Vec3 one = mean.col(0).normalized(), other = mean.col(1).normalized();
    const Vec3 sum = (one + other).normalized(), difference = (one - other).normalized();
    Gradient turned;
    turned << std::numbers::sqrt2 / 2.0 * (sum + difference),
        std::numbers::sqrt2 / 2.0 * (sum - difference);

    Plane force = Plane::Zero();
    for (const RingPanel& panel : tip) {
        if (panel.slope.squaredNorm() == 0.0)
            continue;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const ClothTension now =
            tensionIn(system, membrane, cornersOf(system, membrane, state.position));
        Turn own;
        own << now.tension[0], now.tension[2], now.tension[2], now.tension[1];
        const Turn tension = panel.turn * own * panel.turn.transpose();
        const Gradient went = gradientOf(panel);
        force += membrane.area
                 * (now.energy * panel.slope
                    - (went - turned).transpose() * (went * (tension * panel.slope)));
    }
    return force.norm();
}

int TearTips::weakestOf(const System& system, const State& state, const Tip& tip) const
{
    int weakest = -1;
    double most = 0.0; // N/m, over how strong the panel is of its material
    for (const RingPanel& panel : tip) {
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        if (!panel.atTip || !(tearOf(system, membrane).energy > 0.0))
            continue;
        const PanelPull pull =
            pullOf(system, membrane, cornersOf(system, membrane, state.position));
        if (const double pulls = std::max(pull.warp, pull.weft) / membrane.factors.strength;
            pulls > most) {
            most = pulls;
            weakest = panel.membrane;
        }
    }
    return weakest;
}

const std::vector<TearTips::Driven>& TearTips::overdriven(const System& system, const State& state)
{
    struct Hard
    {
        double ratio;
        const Tip* tip;
        Driven driven;
    };
    m_driven.clear();
    std::vector<Hard> hard;
    for (const Tip& tip : m_tips) {
        const double force = forceAt(system, state, tip);
        const auto bearsIt = [&](const RingPanel& panel) {
            return force <= tearOf(system, system.membranes[std::size_t(panel.membrane)]).energy;
        };
        if (std::ranges::all_of(tip, bearsIt))
            continue; // without a search for what pulls most
        const int weakest = weakestOf(system, state, tip);
        if (weakest < 0)
            continue;
        const double bears = tearOf(system, system.membranes[std::size_t(weakest)]).energy;
        if (force > bears)
            hard.push_back({force / bears, &tip, {weakest, std::sqrt(force / bears)}});
    }
    std::ranges::stable_sort(hard, std::ranges::greater(), &Hard::ratio);
    std::vector<int> taken; // membranes
    for (const Hard& one : hard) {
        const auto isTaken = [&](const RingPanel& panel) {
            return std::ranges::count(taken, panel.membrane) > 0;
        };
        if (std::ranges::any_of(*one.tip, isTaken))
            continue;
        for (const RingPanel& panel : *one.tip)
            taken.push_back(panel.membrane);
        m_driven.push_back(one.driven);
    }
    return m_driven;
}

} // namespace ripstop
