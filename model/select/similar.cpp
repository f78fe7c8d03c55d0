// Elements like others: similar() of select.h. Each kind of likeness is a key (type, material,
// role, part) that is spread from marked rows to all rows that have it, or a measure that is
// compared within 1 % by halving in the sorted measures. Groups are resolved by their members
// instead.
#include "select/net.h"
#include "select/select.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

constexpr double sameMeasure = 0.01; // 1, how far measures that count as the same may lie apart

double areaOf(const Net& net, std::size_t panel) // m^2
{
    const auto& corners = net.corners[panel];
    if (!net.isWhole(corners))
        return 0.0;
    const auto at = [&](int k) -> const Vec3& {
        return net.all.particles[std::size_t(corners[std::size_t(k)])]->position;
    };
    return 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
}

// Marks the rows whose key is that of a marked one.
template <typename KeyOf>
void spread(std::vector<char>& marks, KeyOf keyOf)
{
    std::set<decltype(keyOf(std::size_t(0)))> keys;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (marks[i])
            keys.insert(keyOf(i));
    for (std::size_t i = 0; !keys.empty() && i < marks.size(); ++i)
        marks[i] |= char(keys.contains(keyOf(i)));
}

// Marks the rows whose measure is that of a marked one.
template <typename MeasureOf>
void spreadMeasure(std::vector<char>& marks, MeasureOf measureOf)
{
    std::vector<double> measures;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (marks[i])
            measures.push_back(measureOf(i));
    std::ranges::sort(measures);
    for (std::size_t i = 0; !measures.empty() && i < marks.size(); ++i) {
        const double value = measureOf(i);
        const double slack = sameMeasure * std::abs(value);
        const auto near = std::ranges::lower_bound(measures, value - slack);
        marks[i] |= char(near != measures.end() && *near <= value + slack);
    }
}

// [rows] the place of its part among the parts
template <typename Row>
std::vector<int> partsOf(const Scene& scene, const std::vector<const Row*>& rows,
                         std::vector<Row> Part::*table)
{
    struct Stretch
    {
        const Row* first;
        int part;
    };
    std::vector<Stretch> stretches;
    int count = 0;
    forEachPart(scene, [&](Id, const Part& part) {
        if (!(part.*table).empty())
            stretches.push_back({(part.*table).data(), count});
        ++count;
    });
    std::ranges::sort(stretches, std::less<const Row*>(), &Stretch::first);
    std::vector<int> parts;
    parts.reserve(rows.size());
    for (const Row* row : rows) {
        const auto after =
            std::ranges::upper_bound(stretches, row, std::less<const Row*>(), &Stretch::first);
        parts.push_back(std::prev(after)->part);
    }
    return parts;
}

void spreadParts(const Net& net, const Scene& scene, Marks& marks)
{
    const auto spreadTable = [&]<typename Row>(const std::vector<const Row*>& rows,
                                               std::vector<Row> Part::*table,
                                               std::vector<char>& rowMarks) {
        const std::vector<int> parts = partsOf(scene, rows, table);
        spread(rowMarks, [&](std::size_t i) { return parts[i]; });
    };
    spreadTable(net.all.particles, &Part::particles, marks.particles);
    spreadTable(net.all.links, &Part::links, marks.links);
    spreadTable(net.all.panels, &Part::panels, marks.panels);
}

std::vector<Id> ofSameGroups(const Scene& scene, const std::vector<Id>& elements)
{
    std::vector<Id> groups;
    for (const Entry& entry : scene.items)
        if (const Group* group = std::get_if<Group>(&entry.item))
            if (std::ranges::any_of(group->members, [&](Id id) {
                    return std::ranges::binary_search(elements, id);
                }))
                groups.push_back(entry.id);
    std::vector<Id> all = elementsOf(scene, groups);
    all.insert(all.end(), elements.begin(), elements.end());
    std::ranges::sort(all);
    return elementsOf(scene, all);
}

} // namespace

std::vector<Id> similar(Alike alike, const Scene& scene, const std::vector<Id>& selected)
{
    if (alike == Alike::Group)
        return ofSameGroups(scene, elementsOf(scene, selected));
    const Net net(scene);
    Marks marks(net, scene, selected);
    const auto& particles = net.all.particles;
    const auto& links = net.all.links;
    const auto& panels = net.all.panels;
    switch (alike) {
    case Alike::Type:
        spread(marks.particles, [&](std::size_t i) { return particles[i]->pinned; });
        spread(marks.links, [&](std::size_t i) { return links[i]->kind; });
        spread(marks.panels, [](std::size_t) { return 0; });
        break;
    case Alike::Material:
        spread(marks.links, [&](std::size_t i) { return links[i]->material; });
        spread(marks.panels, [&](std::size_t i) { return panels[i]->material; });
        break;
    case Alike::Role:
        spread(marks.links, [&](std::size_t i) { return links[i]->role; });
        break;
    case Alike::Measure:
        spreadMeasure(marks.particles, [&](std::size_t i) { return particles[i]->mass; });
        spreadMeasure(marks.links, [&](std::size_t i) { return links[i]->restLength; });
        spreadMeasure(marks.panels, [&](std::size_t i) { return areaOf(net, i); });
        break;
    case Alike::Part:
        spreadParts(net, scene, marks);
        break;
    case Alike::Group:
        break;
    }
    return marks.ids(net);
}

} // namespace ripstop
