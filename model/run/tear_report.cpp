#include "run/tear_report.h"

#include <algorithm>
#include <set>

namespace ripstop {

TearReport tearReport(std::span<const Tear> tears)
{
    TearReport report;
    report.count = int(tears.size());
    for (const Tear& tear : tears) {
        report.energy += tear.energy;
        const double distance = (tear.place - tears[0].place).norm();
        if (report.front.empty() || distance > report.front.back().distance)
            report.front.push_back({tear.time, distance});
    }
    return report;
}

std::size_t tornElements(const Frame& frame)
{
    std::set<std::uint32_t> torn;
    for (std::size_t i = 0; i < frame.torn.size(); ++i)
        if (frame.torn[i])
            torn.insert(frame.layout->links[i].id);
    for (const Tear& tear : frame.tears)
        torn.insert(tear.element);
    return torn.size();
}

bool isOfPanel(const Tear& tear, const Layout& layout)
{
    return std::ranges::find(layout.panelId, tear.element) != layout.panelId.end();
}

bool isSnap(const Tear& tear) { return tear.length == 0.0; }

const char* loadUnit(const Tear& tear, const Layout& layout)
{
    return isSnap(tear) ? "N m" : isOfPanel(tear, layout) ? "N/m" : "N";
}

} // namespace ripstop
