// What has the widest gaps is found once: the part whose panels, or whose lines of three links and
// more, have the longest in the mean. Of a panel the longest side counts, as the gap of a cell is
// its diagonal. Lines of less are not made to lie on anything.
#include "check/gap_check.h"

#include "derived/collider_shape.h"
#include "derived/panel_sides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ripstop {
namespace {

class Mean
{
public:
    void add(double value)
    {
        m_sum += value;
        ++m_count;
    }
    double value() const { return m_count > 0 ? m_sum / double(m_count) : 0.0; }

private:
    double m_sum = 0.0;
    std::size_t m_count = 0;
};

struct Gaps
{
    const Part* part = nullptr;
    bool ofLinks = false;
    double width = 0.0; // m
};

double lengthOf(const Part& part, const PanelSide& side) // m, 0 where an end is missing
{
    const Particle* a = findRow(part.particles, side.first);
    const Particle* b = findRow(part.particles, side.second);
    return a && b ? (b->position - a->position).norm() : 0.0;
}

Gaps widestOf(const Part& part)
{
    Mean ofPanels;
    std::vector<Id> corners;
    for (const Panel& panel : part.panels) {
        double longest = 0.0;
        for (const PanelSide& side : sidesOf(panel))
            longest = std::max(longest, lengthOf(part, side));
        ofPanels.add(longest);
        corners.insert(corners.end(), {panel.a, panel.b, panel.c});
    }
    std::ranges::sort(corners);
    std::vector<Id> ends;
    for (const Link& link : part.links)
        ends.insert(ends.end(), {link.from, link.to});
    std::ranges::sort(ends);
    const auto goesOn = [&](Id id) { // a line, by one other link
        return !std::ranges::binary_search(corners, id)
               && std::ranges::equal_range(ends, id).size() == 2;
    };
    Mean ofLinks;
    for (const Link& link : part.links)
        if (goesOn(link.from) && goesOn(link.to))
            ofLinks.add(lengthOf(part, sideOf(link.from, link.to)));
    return ofLinks.value() > ofPanels.value() ? Gaps{&part, true, ofLinks.value()}
                                              : Gaps{&part, false, ofPanels.value()};
}

Gaps widestOf(const Scene& scene)
{
    Gaps widest;
    forEachPart(scene, [&](Id, const Part& part) {
        if (const Gaps gaps = widestOf(part); gaps.width > widest.width)
            widest = gaps;
    });
    return widest;
}

Message warningOf(const Collider& collider, const Gaps& gaps)
{
    const Message width = Message::number("%.3g", widthOf(collider));
    const Message gap = Message::number("%.3g", gaps.width);
    return gaps.ofLinks
               ? Message("Collider %1 is %2 m wide and the links of %4 are %3 m long: it fits "
                         "between particles, which are what touches; take shorter links, or a "
                         "larger collider.",
                         collider.name, width, gap, gaps.part->name)
               : Message("Collider %1 is %2 m wide and the panels of %4 have sides of %3 m: it "
                         "fits between particles, which are what touches; make the mesh finer, or "
                         "the collider larger.",
                         collider.name, width, gap, gaps.part->name);
}

} // namespace

void checkGaps(const Scene& scene, const AddFinding& add)
{
    std::optional<Gaps> gaps; // found once at most, since it walks all panels
    for (const Entry& entry : scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (!collider || !std::isfinite(widthOf(*collider)))
            continue;
        if (!gaps)
            gaps = widestOf(scene);
        if (widthOf(*collider) < gaps->width)
            add("gap", Severity::Warning, warningOf(*collider, *gaps), entry.id);
    }
}

} // namespace ripstop
