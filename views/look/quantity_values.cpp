// valuesOf() has one case for each quantity. Quantities of links go through takeLinks(), which also
// gives each particle the largest value of the links that end there, so that panels can be shaded
// between their corners; takePanels() adds those of panels that carry a pull, which are alike all
// over a panel. Arrays of a frame may be shorter than its layout, so loops go as far as
// both reach. peakOf() looks for the largest value in the array that the quantity belongs to.
#include "look/quantity_values.h"

#include "run/has_margins.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ripstop {
namespace {

void takeLinks(const Frame& frame, const std::vector<double>& source, QuantityValues& values)
{
    constexpr double none = std::numeric_limits<double>::lowest();
    const std::vector<Layout::Link>& links = frame.layout->links;
    values.link.assign(links.size(), 0.0);
    values.particle.assign(frame.position.size(), none);
    for (std::size_t i = 0; i < std::min(links.size(), source.size()); ++i) {
        if (frame.torn[i])
            continue;
        values.link[i] = source[i];
        for (const int end : {links[i].a, links[i].b})
            values.particle[end] = std::max(values.particle[end], source[i]);
    }
    std::ranges::replace(values.particle, none, 0.0);
}

// To what links have brought: the value of each panel that carries the pull of a fabric.
//   valueOf  (place of the panel)
template <typename ValueOf>
void takePanels(const Frame& frame, QuantityValues& values, ValueOf valueOf)
{
    if (frame.panelPull.empty())
        return;
    const auto& corners = frame.layout->panelCorners;
    values.panel.assign(corners.size(), 0.0);
    for (std::size_t i = 0; i < std::min(corners.size(), frame.panelPull.size()); ++i) {
        const PanelPull& pull = frame.panelPull[i];
        for (const int corner : corners[i]) {
            double& there = values.particle[std::size_t(corner)];
            if (pull.carries)
                there = std::max(there, valueOf(i));
            else
                values.panel[i] = std::max(values.panel[i], there);
        }
        if (pull.carries)
            values.panel[i] = valueOf(i);
    }
}

void takePanels(const Frame& frame, double PanelPull::*value, QuantityValues& values)
{
    takePanels(frame, values, [&](std::size_t i) { return frame.panelPull[i].*value; });
}

// Of each panel that carries the pull of a fabric its own, of each other one the mean of the links
// that end at its corners.
void takePainted(const Frame& frame, const Look& look, double Look::PaintedFactors::*factor,
                 QuantityValues& values)
{
    const auto valueOf = [factor](const Look::PaintedFactors& painted) { return painted.*factor; };
    const auto& links = frame.layout->links;
    std::vector<double> ends(frame.position.size(), 0.0);
    values.particle.assign(frame.position.size(), 0.0);
    std::ranges::transform(look.linkPainted, std::back_inserter(values.link), valueOf);
    for (std::size_t i = 0; i < std::min(links.size(), values.link.size()); ++i)
        for (const int end : {links[i].a, links[i].b}) {
            values.particle[std::size_t(end)] += values.link[i];
            ends[std::size_t(end)] += 1.0;
        }
    for (std::size_t i = 0; i < ends.size(); ++i)
        values.particle[i] = ends[i] > 0.0 ? values.particle[i] / ends[i] : 1.0;
    for (std::size_t i = 0; i < look.panelPainted.size(); ++i) {
        const auto [a, b, c] = frame.layout->panelCorners[i];
        const auto at = [&](int corner) { return values.particle[std::size_t(corner)]; };
        values.panel.push_back(look.panelWarp[i].isThere ? valueOf(look.panelPainted[i])
                                                         : (at(a) + at(b) + at(c)) / 3.0);
    }
    const auto isPainted = [](double value) { return value != 1.0; };
    values.isKnown =
        std::ranges::any_of(values.link, isPainted) || std::ranges::any_of(values.panel, isPainted);
}

bool carriesAny(const Frame& frame)
{
    return std::ranges::any_of(frame.panelPull, &PanelPull::carries);
}

double area(const Frame& frame, const std::array<int, 3>& corners)
{
    const auto& x = frame.position;
    const auto [a, b, c] = corners;
    return 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
}

double tearLoad(const Frame& frame, std::size_t link, const TearLimit& bound)
{
    if (!(bound.limit > 0.0))
        return 0.0;
    switch (bound.rule) {
    case TearRule::Never:
        break;
    case TearRule::Length:
        return frame.layout->links[link].restLength * (1.0 + frame.strain[link]) / bound.limit;
    case TearRule::Strain:
        return std::max(frame.strain[link], 0.0) / bound.limit;
    case TearRule::Force:
        return std::max(frame.tension[link], 0.0) / bound.limit;
    case TearRule::Tension: // of fabric; links have a force instead
    case TearRule::Strength:
    case TearRule::Energy:
        break;
    }
    return 0.0;
}

} // namespace

QuantityValues valuesOf(const Frame& frame, ColorBy colorBy, const Look& look)
{
    QuantityValues values;
    switch (colorBy) {
    case ColorBy::Material:
        break;
    case ColorBy::Strain:
        values.isKnown = !frame.layout->links.empty() || carriesAny(frame);
        takeLinks(frame, frame.strain, values);
        takePanels(frame, &PanelPull::strain, values);
        break;
    case ColorBy::Tension:
        values.isKnown = !frame.layout->links.empty();
        takeLinks(frame, frame.tension, values);
        break;
    case ColorBy::Speed:
        values.isKnown = !frame.velocity.empty();
        values.particle.reserve(frame.velocity.size());
        for (const Vec3& velocity : frame.velocity)
            values.particle.push_back(velocity.norm());
        break;
    case ColorBy::TearLoad: {
        std::vector<double> loads;
        const std::size_t count = std::min(look.linkTear.size(), frame.strain.size());
        for (std::size_t i = 0; i < count; ++i)
            loads.push_back(tearLoad(frame, i, look.linkTear[i]));
        values.isKnown = std::ranges::any_of(
            look.linkTear, [](const TearLimit& bound) { return bound.rule != TearRule::Never; });
        values.isKnown |=
            carriesAny(frame) && std::ranges::any_of(look.panelTear, [](const FabricTear& bound) {
                return bound.rule != TearRule::Never;
            });
        takeLinks(frame, loads, values);
        takePanels(frame, values, [&](std::size_t i) {
            return i < look.panelTear.size()
                       ? threadLoad(frame.panelPull[i], look.panelTear[i]).ratio
                       : 0.0;
        });
        break;
    }
    case ColorBy::Stress: {
        std::vector<double> stresses(frame.tension.size(), 0.0);
        for (std::size_t i = 0; i < std::min(look.linkWidth.size(), stresses.size()); ++i)
            if (look.linkWidth[i] > 0.0)
                stresses[i] = frame.tension[i] / look.linkWidth[i];
        values.isKnown = carriesAny(frame) || std::ranges::any_of(look.linkWidth, [](double width) {
                             return width > 0.0;
                         });
        takeLinks(frame, stresses, values);
        takePanels(frame, &PanelPull::tension, values);
        break;
    }
    case ColorBy::Margin: {
        const auto orZero = [](double margin) { return std::isnan(margin) ? 0.0 : margin; };
        std::vector<double> ofLinks(frame.linkMargin.size());
        std::ranges::transform(frame.linkMargin, ofLinks.begin(), orZero);
        takeLinks(frame, ofLinks, values);
        takePanels(frame, values, [&](std::size_t i) {
            return i < frame.panelMargin.size() ? orZero(frame.panelMargin[i]) : 0.0;
        });
        values.isKnown = hasMargins(frame);
        break;
    }
    case ColorBy::Wrinkles:
        values.panel.assign(frame.layout->panelCorners.size(),
                            std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = 0; i < std::min(values.panel.size(), frame.panelPull.size()); ++i)
            if (frame.panelPull[i].carries)
                values.panel[i] = double(frame.panelPull[i].state);
        values.isKnown = carriesAny(frame);
        break;
    case ColorBy::Stiffness:
        takePainted(frame, look, &Look::PaintedFactors::stiffness, values);
        break;
    case ColorBy::Strength:
        takePainted(frame, look, &Look::PaintedFactors::strength, values);
        break;
    case ColorBy::Grain: {
        const auto isThere = [](const Look::Warp& warp) { return warp.isThere; };
        values.isKnown = std::ranges::any_of(look.panelWarp, isThere);
        for (const Look::Warp& warp : look.panelWarp)
            values.panel.push_back(isThere(warp) ? warp.turn
                                                 : std::numeric_limits<double>::quiet_NaN());
        break;
    }
    case ColorBy::PanelLoad: {
        const auto& panels = frame.layout->panelCorners;
        values.isKnown = !panels.empty();
        values.panel.assign(panels.size(), 0.0);
        for (std::size_t i = 0; i < std::min(panels.size(), frame.panelLoad.size()); ++i)
            if (const double a = area(frame, panels[i]); a > 0.0 && !frame.gone[i])
                values.panel[i] = frame.panelLoad[i].norm() / a;
        break;
    }
    }
    return values;
}

Peak peakOf(const Frame& frame, const QuantityValues& values)
{
    const auto isLess = [](double a, double b) { // what is no number is less than all
        return std::isnan(b) ? false : std::isnan(a) || a < b;
    };
    const auto largest = [&](const std::vector<double>& all) {
        return std::size_t(std::ranges::max_element(all, isLess) - all.begin());
    };
    const Layout& layout = *frame.layout;
    Peak peak;
    if (!values.link.empty()) {
        const std::size_t i = largest(values.link);
        peak = {layout.links[i].id, values.link[i]};
    }
    if (!values.panel.empty()) {
        const std::size_t i = largest(values.panel);
        if (peak.id == 0 || values.panel[i] > peak.value)
            peak = {layout.panelId[i], values.panel[i]};
    }
    if (peak.id != 0)
        return peak;
    if (!values.particle.empty()) {
        const std::size_t i = largest(values.particle);
        return {layout.particleId[i], values.particle[i]};
    }
    return {};
}

std::vector<double> rangedValues(const QuantityValues& values)
{
    std::vector<double> all = values.link;
    all.insert(all.end(), values.panel.begin(), values.panel.end());
    return all.empty() ? values.particle : all;
}

ValueRange extentOf(const QuantityValues& values)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ValueRange extent{infinity, -infinity};
    const auto take = [&extent](const std::vector<double>& some) {
        for (const double value : some) { // neither takes what is not a number
            extent.low = std::fmin(extent.low, value);
            extent.high = std::fmax(extent.high, value);
        }
    };
    take(values.link);
    take(values.panel);
    if (values.link.empty() && values.panel.empty())
        take(values.particle);
    return extent.low <= extent.high ? extent : ValueRange{0.0, 0.0};
}

} // namespace ripstop
