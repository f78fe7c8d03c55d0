// Links that join the same two particles are found by counting sort, in two passes over all links.
#include "check/network_check.h"

#include "derived/link_stiffness.h"
#include "derived/material_of.h"
#include "derived/thread_fabric.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace ripstop {
namespace {

std::size_t particleCount(const Scene& scene)
{
    std::size_t count = 0;
    forEachPart(scene, [&](Id, const Part& part) { count += part.particles.size(); });
    return count;
}

//   again  numbers of links, ascending
void reportDoubles(const Scene& scene, const std::vector<int>& again, const AddFinding& add)
{
    int start = 0;
    auto link = again.begin();
    forEachPart(scene, [&](Id, const Part& part) {
        const int end = start + int(part.links.size());
        for (; link != again.end() && *link < end; ++link)
            add("double", Severity::Warning,
                Message("%1 of %2 joins two particles that are joined already.",
                        subjectOf(Kind::Link, part.links[std::size_t(*link - start)].id),
                        part.name),
                part.links[std::size_t(*link - start)].id);
        start = end;
    });
}

std::vector<const Particle*> particlesOf(const Scene& scene) // as the index counts them
{
    std::vector<const Particle*> particles;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            particles.push_back(&particle);
    });
    return particles;
}

// Rods that never stretch and are held at both ends, at a distance that is not theirs: no solver
// can make anything of them, and so none tells how far off they are.
void reportMisfits(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    const std::vector<const Particle*> ends = particlesOf(scene);
    const auto isRigid = [&](const Link& link) {
        const Material& material = materialOf(scene, index, link.material);
        return link.kind == LinkKind::Rod
               && link.compliance.value_or(rodCompliance(material, link)) == 0.0;
    };
    forEachPart(scene, [&](Id, const Part& part) {
        std::size_t count = 0;
        double worst = 0.0; // %, strain
        Id culprit = noId;
        for (const Link& link : part.links) {
            const int from = index.particle(link.from), to = index.particle(link.to);
            if (from < 0 || to < 0 || !ends[std::size_t(from)]->pinned
                || !ends[std::size_t(to)]->pinned || !(link.restLength > 0.0) || !isRigid(link))
                continue;
            const double stretch =
                (ends[std::size_t(to)]->position - ends[std::size_t(from)]->position).norm()
                - link.restLength;
            const double strain = 100.0 * std::abs(stretch) / link.restLength;
            if (isSlack(link.resists, stretch) || !(strain > scene.settings.strainGoal))
                continue;
            ++count;
            if (strain > worst) {
                worst = strain;
                culprit = link.id;
            }
        }
        if (count == 0)
            return;
        const Message off = Message::number("%.3g", worst);
        add("misfit", Severity::Warning,
            count == 1
                ? Message(
                    "%1 of %2 never stretches, and the fixed particles at its ends are %3 % "
                    "off from its length: what it pulls is not known. Give it that length, or "
                    "a stiffness.",
                    subjectOf(Kind::Link, culprit), part.name, off)
                : Message(
                    "%1 links of %2 never stretch, and the fixed particles at their ends are "
                    "off from their lengths, at link %3 by %4 %: what they pull is not known. "
                    "Give them these lengths, or a stiffness.",
                    count, part.name, std::uint32_t(culprit), off),
            culprit);
    });
}

//   bare  parts whose particles need not be named one by one
void reportThreadless(const Scene& scene, const std::vector<Id>& bare, const AddFinding& add)
{
    for (const Id part : bare)
        add("threadless", Severity::Warning,
            Message("The fabric of %1 pulls by threads and has none, so that nothing holds it "
                    "together: have panels carry its pull (carrier=panels), or make threads of the "
                    "sides of its panels (ripstop-cli convert --fabric threads).",
                    findItem<Part>(scene, part)->name),
            part);
}

//   tied  [particles] 1 where something holds it
//   bare  parts that are told of as a whole
void reportLoose(const Scene& scene, const ElementIndex& index,
                 const std::vector<std::uint8_t>& tied, const std::vector<Id>& bare,
                 const AddFinding& add)
{
    forEachPart(scene, [&](Id id, const Part& part) {
        if (part.links.empty() || std::ranges::count(bare, id) > 0)
            return;
        for (const Particle& row : part.particles) {
            const int place = index.particle(row.id);
            if (place >= 0 && !tied[std::size_t(place)] && !row.pinned)
                add("loose", Severity::Warning,
                    Message("%1 of %2 has no links and will fly by itself.",
                            subjectOf(Kind::Particle, row.id), part.name),
                    row.id);
        }
    });
}

} // namespace

void checkNetwork(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    // Links sorted by their lower end, by counting: those that join the same two particles
    // are found where the lists of one end name the other end again.
    struct Tie
    {
        int high; // particle
        int link; // number of the row
    };
    const std::size_t particles = particleCount(scene);
    std::vector<std::uint8_t> tied(particles, 0);
    std::vector<int> first(particles + 1, 0);
    const auto eachTie = [&](auto visit) {
        int link = -1;
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& row : part.links) {
                ++link;
                const int from = index.particle(row.from);
                const int to = index.particle(row.to);
                if (from >= 0 && to >= 0)
                    visit(std::size_t(std::min(from, to)), Tie{std::max(from, to), link});
            }
        });
    };
    eachTie([&](std::size_t low, const Tie& tie) {
        tied[low] = tied[std::size_t(tie.high)] = 1;
        ++first[low + 1];
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Tie> ties(std::size_t(first.back()));
    std::vector<int> next(first.begin(), first.end() - 1);
    eachTie([&](std::size_t low, const Tie& tie) { ties[std::size_t(next[low]++)] = tie; });

    std::vector<int> again; // links
    std::vector<int> lastLow(particles, -1);
    for (std::size_t low = 0; low < particles; ++low)
        for (int k = first[low]; k < first[low + 1]; ++k) {
            const Tie& tie = ties[std::size_t(k)];
            if (std::exchange(lastLow[std::size_t(tie.high)], int(low)) == int(low))
                again.push_back(tie.link);
        }
    std::sort(again.begin(), again.end());
    reportDoubles(scene, again, add);
    reportMisfits(scene, index, add);
    forEachPart(scene, [&](Id, const Part& part) {
        if (part.carrier != FabricKind::Panels)
            return;
        for (const Panel& panel : part.panels)
            for (const Id corner : {panel.a, panel.b, panel.c})
                if (const int place = index.particle(corner); place >= 0)
                    tied[std::size_t(place)] = 1;
    });
    const std::vector<Id> bare = partsWithoutThreads(scene);
    reportThreadless(scene, bare, add);
    reportLoose(scene, index, tied, bare, add);
}

void checkRestLengths(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    constexpr double odd = 2.0; // times as long, or as short
    const std::vector<const Particle*> ends = particlesOf(scene);
    forEachPart(scene, [&](Id, const Part& part) {
        std::size_t count = 0;
        double worst = odd;
        double length = 0.0; // m, of the worst
        const Link* culprit = nullptr;
        for (const Link& link : part.links) {
            const int from = index.particle(link.from), to = index.particle(link.to);
            if (from < 0 || to < 0 || !(link.restLength > 0.0))
                continue;
            const double now =
                (ends[std::size_t(to)]->position - ends[std::size_t(from)]->position).norm();
            const double off = std::max(now / link.restLength, link.restLength / now);
            if (isSlack(link.resists, now - link.restLength) || !(off > odd))
                continue;
            ++count;
            if (off > worst) {
                worst = off;
                length = now;
                culprit = &link;
            }
        }
        if (count == 0)
            return;
        const Message now = Message::number("%.4g", length);
        const Message rest = Message::number("%.4g", culprit->restLength);
        add("rest-length", Severity::Warning,
            count == 1
                ? Message("%1 of %2 begins %3 m long, and its rest length is %4 m: it pulls or "
                          "pushes hard from the first moment. Give it the length that it has "
                          "without load.",
                          subjectOf(Kind::Link, culprit->id), part.name, now, rest)
                : Message("%1 links of %2 begin more than twice or less than half as long as their "
                          "rest lengths, link %3 with %4 m for %5 m: they pull or push hard from "
                          "the first moment. Give them the lengths that they have without load.",
                          count, part.name, std::uint32_t(culprit->id), now, rest),
            culprit->id);
    });
}

} // namespace ripstop
