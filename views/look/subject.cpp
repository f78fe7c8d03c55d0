#include "look/subject.h"

#include <algorithm>
#include <map>
#include <set>

namespace ripstop {
namespace {

constexpr int fewestLinks = 3; // that meet in a bridle point; a line has two

} // namespace

std::vector<Id> bridlePoints(const Scene& scene, const Part& part)
{
    std::map<Id, int> links;
    for (const Link& link : part.links) {
        const Material* material = findItem<Material>(scene, link.material);
        if (material && !material->shown)
            continue; // a frame of rigidity particles is no bridle
        ++links[link.from];
        ++links[link.to];
    }
    std::set<Id> fabric;
    for (const Panel& panel : part.panels)
        fabric.insert({panel.a, panel.b, panel.c});
    std::vector<Id> points;
    for (const auto& [particle, count] : links)
        if (count >= fewestLinks && !fabric.contains(particle))
            points.push_back(particle);
    return points;
}

std::vector<Id> subjectOf(const Scene& scene, const std::vector<Id>& bodies)
{
    std::vector<Id> subject;
    for (const Id body : bodies) {
        const Part* part = findItem<Part>(scene, body);
        if (!part || part->panels.empty())
            continue;
        for (const Panel& panel : part->panels)
            subject.push_back(panel.id);
        const std::vector<Id> points = bridlePoints(scene, *part);
        subject.insert(subject.end(), points.begin(), points.end());
    }
    std::ranges::sort(subject);
    return subject.empty() ? bodies : subject;
}

} // namespace ripstop
