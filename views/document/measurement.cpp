// In order: the table of what can be measured, of which kinds of elements; the value of one element
// (valueOf), which the two uses below share so that a condition and a label never disagree; a list
// of all elements of a kind for conditions (read); and the text about one element (readingOf).
// Links that are torn and panels that have lost an edge are left out everywhere, because they are
// no longer part of the design.
#include "document/measurement.h"

#include "document/spoken.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace ripstop {
namespace {

constexpr Kinds everything{Kind::Particle, Kind::Link, Kind::Panel};

constexpr std::array keys{
    Measurement::Key{"x", "m", "Where it is now, across; of links and panels their middle.",
                     everything},
    Measurement::Key{"y", "m", "Where it is now, up; of links and panels their middle.",
                     everything},
    Measurement::Key{"z", "m", "Where it is now, along z; of links and panels their middle.",
                     everything},
    Measurement::Key{"speed", "m/s", "How fast a particle moves now.", Kinds{Kind::Particle}},
    Measurement::Key{"strain", "%",
                     "How far a link is stretched now, or what stretches most of an elastic panel.",
                     Kinds{Kind::Link, Kind::Panel}},
    Measurement::Key{"tension", "N", "How hard a link pulls now; below 0 it pushes.",
                     Kinds{Kind::Link}},
    Measurement::Key{"length", "m", "How long a link is now.", Kinds{Kind::Link}},
    Measurement::Key{"area", "m\u00b2", "How large a panel is now.", Kinds{Kind::Panel}},
    Measurement::Key{"load", "Pa", "How hard the air pushes a panel now, per area.",
                     Kinds{Kind::Panel}},
};

using Row = std::size_t;

const Vec3& placeOf(const Frame& frame, int particle)
{
    return frame.position[std::size_t(particle)];
}

double areaOf(const Frame& frame, Row panel) // m^2
{
    const auto [a, b, c] = frame.layout->panelCorners[panel];
    const Vec3& origin = placeOf(frame, a);
    return 0.5 * (placeOf(frame, b) - origin).cross(placeOf(frame, c) - origin).norm();
}

Vec3 middleOf(const Frame& frame, Kind kind, Row row)
{
    if (kind == Kind::Particle)
        return frame.position[row];
    if (kind == Kind::Link) {
        const Layout::Link& link = frame.layout->links[row];
        return 0.5 * (placeOf(frame, link.a) + placeOf(frame, link.b));
    }
    const auto [a, b, c] = frame.layout->panelCorners[row];
    return (placeOf(frame, a) + placeOf(frame, b) + placeOf(frame, c)) / 3.0;
}

double strainOf(const Frame& frame, Kind kind, Row row) // %
{
    if (kind == Kind::Link)
        return 100.0 * frame.strain[row];
    const bool carries = !frame.panelPull.empty() && frame.panelPull[row].carries;
    return carries ? 100.0 * frame.panelPull[row].strain : std::numeric_limits<double>::quiet_NaN();
}

// Not a number where there is nothing of it.
double valueOf(const Frame& frame, std::string_view key, Kind kind, Row row)
{
    if (key.size() == 1)
        return middleOf(frame, kind, row)[key[0] - 'x'];
    if (key == "speed")
        return frame.velocity[row].norm();
    if (key == "strain")
        return strainOf(frame, kind, row);
    if (key == "tension")
        return frame.tension[row];
    if (key == "length") {
        const Layout::Link& link = frame.layout->links[row];
        return (placeOf(frame, link.b) - placeOf(frame, link.a)).norm();
    }
    const double area = areaOf(frame, row);
    if (key == "area")
        return area;
    return area > 0.0 ? frame.panelLoad[row].norm() / area : 0.0;
}

struct Place
{
    Kind kind;
    Row row;
};

// Finds nothing for a link that is torn or a panel that is gone with its edges.
std::optional<Place> find(const Frame& frame, Id element)
{
    const Layout& layout = *frame.layout;
    const auto id = std::uint32_t(element);
    const auto rowIn = [id](const auto& table, auto idOf) -> std::optional<Row> {
        const auto found = std::ranges::find(table, id, idOf);
        return found == table.end() ? std::nullopt : std::optional(Row(found - table.begin()));
    };
    if (const auto row = rowIn(layout.links, &Layout::Link::id))
        return frame.torn[*row] ? std::nullopt : std::optional(Place{Kind::Link, *row});
    if (const auto row = rowIn(layout.particleId, std::identity()))
        return Place{Kind::Particle, *row};
    if (const auto row = rowIn(layout.panelId, std::identity()); row && !frame.gone[*row])
        return Place{Kind::Panel, *row};
    return std::nullopt;
}

Measurement::Reading read(const Frame& frame, const Measurement::Key& key, Kind kind)
{
    const Layout& layout = *frame.layout;
    Measurement::Reading reading;
    const auto add = [&](std::uint32_t id, Row row) {
        const double value = valueOf(frame, key.key, kind, row);
        if (std::isnan(value))
            return; // it would differ from any number
        reading.ids.push_back(Id(id));
        reading.values.push_back(value);
    };
    if (kind == Kind::Particle)
        for (Row i = 0; i < layout.particleId.size(); ++i)
            add(layout.particleId[i], i);
    if (kind == Kind::Link)
        for (Row i = 0; i < layout.links.size(); ++i)
            if (!frame.torn[i])
                add(layout.links[i].id, i);
    if (kind == Kind::Panel)
        for (Row i = 0; i < layout.panelId.size(); ++i)
            if (!frame.gone[i])
                add(layout.panelId[i], i);
    return reading;
}

} // namespace

Measurement measurementOf(std::shared_ptr<const Frame> frame)
{
    Measurement measurement{keys, {}};
    if (frame)
        measurement.read = [frame = std::move(frame)](const Measurement::Key& key, Kind kind) {
            return read(*frame, key, kind);
        };
    return measurement;
}

QString readingOf(const Frame& frame, Id element)
{
    const auto place = find(frame, element);
    QStringList texts;
    for (const std::string_view told : {"speed", "tension", "strain", "load"}) {
        const Measurement::Key& key = *std::ranges::find(keys, told, &Measurement::Key::key);
        if (!place || !key.kinds.contains(place->kind))
            continue;
        const double value = valueOf(frame, told, place->kind, place->row);
        if (!std::isnan(value))
            texts << spokenText(value, key.unit, 3);
    }
    return texts.join(QStringLiteral(" · "));
}

} // namespace ripstop
