#include "run/tear_report.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace ripstop {
namespace {

// The middle of an element of these particles, by index, in the design.
template <std::size_t N>
std::optional<Vec3> middleOf(const std::array<int, N>& particles, const Layout& layout,
                             const PlaceInDesign& place)
{
    Vec3 sum = Vec3::Zero();
    for (const int particle : particles) {
        const std::optional<Vec3> there = place(layout.particleId[std::size_t(particle)]);
        if (!there)
            return std::nullopt;
        sum += *there;
    }
    return sum / double(N);
}

// By element. What a split has doubled is of the same ids, and was at the same place.
std::map<std::uint32_t, std::optional<Vec3>>
middlesOf(std::span<const Tear> tears, const Layout& layout, const PlaceInDesign& place)
{
    std::map<std::uint32_t, std::optional<Vec3>> middles;
    for (const Tear& tear : tears)
        middles[tear.element];
    const auto note = [&](std::uint32_t element, const auto& particles) {
        if (const auto torn = middles.find(element); torn != middles.end() && !torn->second)
            torn->second = middleOf(particles, layout, place);
    };
    for (const Layout::Link& link : layout.links)
        note(link.id, std::array{link.a, link.b});
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        note(layout.panelId[i], layout.panelCorners[i]);
    return middles;
}

} // namespace

PlaceInDesign placesIn(const Scene& scene)
{
    return [&scene](std::uint32_t id) -> std::optional<Vec3> {
        for (const Entry& entry : scene.items)
            if (const Part* part = std::get_if<Part>(&entry.item))
                if (const Particle* particle = findRow(part->particles, Id{id}))
                    return particle->position;
        return std::nullopt;
    };
}

TearReport tearReport(std::span<const Tear> tears, const Layout& layout, const PlaceInDesign& place)
{
    const auto middles = middlesOf(tears, layout, place);
    TearReport report;
    report.count = int(tears.size());
    std::optional<Vec3> first;
    for (const Tear& tear : tears) {
        report.energy += tear.energy;
        const std::optional<Vec3>& middle = middles.at(tear.element);
        if (!first)
            first = middle;
        const double distance = middle ? (*middle - *first).norm() : 0.0;
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
