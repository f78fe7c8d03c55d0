#include "document/reading.h"

#include "document/words.h"
#include "run/frame.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

// Three digits: what is read in passing changes with each step.
QString brief(double value, const char* unit)
{
    return compactNumber(QString::number(value, 'g', 3).toDouble()) + ' ' + unit;
}

QString ofLink(const Frame& frame, std::size_t link)
{
    if (frame.torn[link])
        return {};
    return brief(frame.tension[link], "N") + QStringLiteral(" · ")
           + brief(100.0 * frame.strain[link], "%");
}

QString ofPanel(const Frame& frame, std::size_t panel)
{
    const auto& [a, b, c] = frame.layout->panelCorners[panel];
    const auto place = [&](int particle) { return frame.position[std::size_t(particle)]; };
    const double area = 0.5 * (place(b) - place(a)).cross(place(c) - place(a)).norm();
    if (frame.gone[panel] || !(area > 0.0))
        return {};
    return brief(frame.panelLoad[panel].norm() / area, "Pa");
}

} // namespace

QString readingOf(const Frame& frame, Id element)
{
    const Layout& layout = *frame.layout;
    const auto id = std::uint32_t(element);
    if (const auto found = std::ranges::find(layout.links, id, &Layout::Link::id);
        found != layout.links.end())
        return ofLink(frame, std::size_t(found - layout.links.begin()));
    if (const auto found = std::ranges::find(layout.particleId, id);
        found != layout.particleId.end())
        return brief(frame.velocity[std::size_t(found - layout.particleId.begin())].norm(), "m/s");
    if (const auto found = std::ranges::find(layout.panelId, id); found != layout.panelId.end())
        return ofPanel(frame, std::size_t(found - layout.panelId.begin()));
    return {};
}

} // namespace ripstop
