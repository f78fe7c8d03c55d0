// A function for each question, which makes one finding or none for the whole scene.
#include "author/fabric_findings.h"

#include "check/flutter_check.h"
#include "derived/panel_fabric.h"
#include "derived/scattered_warps.h"
#include "derived/thread_fabric.h"

#include <algorithm>

namespace ripstop {
namespace {

Finding warningOf(std::string_view sort, std::vector<Id> parts)
{
    std::ranges::sort(parts);
    return {Severity::Warning, {}, std::move(parts), sort, Message("Fabric")};
}

std::optional<Finding> carriedTwice(const Scene& scene)
{
    std::vector<Id> parts;
    std::size_t threads = 0;
    forEachPart(scene, [&](Id id, const Part& part) {
        const auto count =
            part.carrier == FabricKind::Panels ? std::ranges::count_if(part.links, isOfFabric) : 0;
        threads += std::size_t(count);
        if (count > 0)
            parts.push_back(id);
    });
    if (parts.empty())
        return std::nullopt;
    Finding finding = warningOf("both", std::move(parts));
    finding.message =
        threads == 1
            ? Message("1 thread carries the pull of fabric that panels carry as well.")
            : Message("%1 threads carry the pull of fabric that panels carry as well.", threads);
    if (Result<PanelFabric> made = carriedByPanels(scene, finding.culprits)) {
        finding.repair = std::move(made->edit);
        finding.repair->label = Message("Remove the threads");
    }
    return finding;
}

std::optional<Finding> carriedByNothing(const Scene& scene)
{
    std::vector<Id> parts = partsWithoutThreads(scene);
    if (parts.empty())
        return std::nullopt;
    Finding finding = warningOf("threadless", std::move(parts));
    finding.message =
        finding.culprits.size() == 1
            ? Message("The fabric of 1 part pulls by threads and has none, so that nothing holds "
                      "it together.")
            : Message("The fabric of %1 parts pulls by threads and has none, so that nothing "
                      "holds it together.",
                      finding.culprits.size());
    finding.repair = Edit{Message("Make threads of its sides"), {}};
    finding.repair->changes = threadsFor(scene, finding.culprits);
    return finding;
}

std::optional<Finding> warpsEveryWay(const Scene& scene)
{
    const std::vector<ScatteredWarps> scattered = scatteredWarps(scene);
    if (scattered.empty())
        return std::nullopt;
    std::vector<Id> parts;
    double most = 0.0; // degrees
    for (const ScatteredWarps& warps : scattered) {
        parts.push_back(warps.part);
        most = std::max(most, warps.apart);
    }
    Finding finding = warningOf("scattered warps", std::move(parts));
    finding.message =
        Message("All panels of a fabric have one grain, which each counts from its own side ab, so "
                "that warps lie up to %1 degrees apart.",
                Message::number("%.0f", most));
    finding.repair = turnedOneWay(scene, scattered);
    return finding;
}

// Symmetry tells it no side to which it could go, so that the solver never moves it aside.
std::optional<Finding> staysFlat(const Scene& scene)
{
    std::vector<Id> parts = partsThatStayFlat(scene);
    if (parts.empty())
        return std::nullopt;
    std::ranges::sort(parts);
    Finding finding{Severity::Fine, {}, std::move(parts), "flat", Message("Fabric")};
    finding.message = Message(
        "All of it lies in one upright plane, to the last digit, and without a wind nothing "
        "moves it aside: it stays there. A wind of 0.1 m/s across it, or a little speed of "
        "one particle, lets it swing and fold.");
    return finding;
}

} // namespace

std::vector<Finding> fabricFindings(const Scene& scene)
{
    std::vector<Finding> findings;
    for (auto examine : {carriedByNothing, carriedTwice, warpsEveryWay, staysFlat})
        if (auto finding = examine(scene))
            findings.push_back(std::move(*finding));
    return findings;
}

} // namespace ripstop
