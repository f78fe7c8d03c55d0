// Looks at a scene before its first step. Look holds what all questions need: an index and a net,
// made once. Each question is a function that makes one finding or none: particles without mass,
// loose ones, double links, the substep against its limit, the mass ratio of rods, the sweeps
// against the length of the network, and lengths at the start; what is wrong with fabric is in
// fabric_findings.h. A finding that can be repaired has the edit with it. Warnings are sorted to
// the front.
#include "author/stability.h"

#include "author/fabric_findings.h"
#include "check/step_check.h"
#include "check/step_limits.h"
#include "derived/link_stiffness.h"
#include "derived/tear_bounds.h"
#include "select/net.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Three digits are enough for the figures here.
Message shortNumber(double value) { return Message::number("%.3g", value); }

Finding about(Message subject, std::string_view sort = {})
{
    return {Severity::Fine, {}, {}, sort, std::move(subject)};
}

Edit setting(Message label, const Property& property, std::vector<Id> ids,
             std::vector<Value> values)
{
    return {std::move(label), {SetValues{&property, std::move(ids), std::move(values)}}};
}

// What all questions look at, made once.
struct Look
{
    explicit Look(const Scene& which)
        : scene(which)
        , index(which)
        , net(which)
    {}

    const Particle& end(std::size_t link, std::size_t k) const
    {
        return *net.all.particles[std::size_t(net.ends[link][k])];
    }
    bool isTied(std::size_t link) const { return net.ends[link][0] >= 0 && net.ends[link][1] >= 0; }

    const Scene& scene;
    ElementIndex index;
    Net net;
};

std::optional<Finding> timeStep(const Look& look)
{
    const Settings& settings = look.scene.settings;
    const StepLimits limits = stepLimitsOf(look.scene, look.index);
    const double substep = settings.timeStep / settings.substeps;
    Finding finding = about(Message("Time step"), "step");
    double least = INFINITY;
    std::size_t i = 0;
    Id worst = noId;
    forEachPart(look.scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const double limit = limits.timeStep[i++];
            if (limit < least) {
                least = limit;
                worst = particle.id;
            }
            if (limit < substep)
                finding.culprits.push_back(particle.id);
        }
    });
    if (!std::isfinite(least))
        return std::nullopt;
    const bool adapts = limits.cause.bending && settings.solver == Solver::Auto;
    if (finding.culprits.empty() || adapts) {
        finding.message =
            settings.solver == Solver::Auto
                ? Message("The time step is %1 s. Substeps may be up to %2 s for %3, and the "
                          "automatic solver keeps to it.",
                          shortNumber(settings.timeStep), shortNumber(least), limits.cause.said())
                : Message("The substep is %1 s and may be up to %2 s for %3.", shortNumber(substep),
                          shortNumber(least), limits.cause.said());
        finding.culprits = {worst};
        return finding;
    }
    std::ranges::sort(finding.culprits);
    finding.severity = Severity::Warning;
    const std::size_t count = finding.culprits.size();
    finding.message = count == 1
                          ? Message("1 particle needs a shorter substep than %1 s, down to %2 s.",
                                    shortNumber(substep), shortNumber(least))
                          : Message("%1 particles need a shorter substep than %2 s, down to %3 s.",
                                    count, shortNumber(substep), shortNumber(least));
    const int wanted = substepsWithin({least, worst, limits.cause}, settings);
    if (settings.timeStep / wanted <= least)
        finding.repair = setting(Message("Take %1 substeps", wanted),
                                 propertyOf<&Settings::substeps>(), {settingsId}, {wanted});
    return finding;
}

bool sweeps(Solver solver) { return solver != Solver::Auto && solver != Solver::Direct; }

std::optional<Finding> massRatio(const Look& look)
{
    double worst = 0.0;
    Finding finding = about(Message("Masses"));
    for (std::size_t k = 0; k < look.net.ends.size(); ++k) {
        const Link& link = *look.net.all.links[k];
        if (link.kind != LinkKind::Rod || !look.isTied(k))
            continue;
        const Particle &a = look.end(k, 0), &b = look.end(k, 1);
        const auto [light, heavy] = std::minmax(a.mass, b.mass);
        if (a.pinned || b.pinned || !(light > 0.0))
            continue;
        worst = std::max(worst, heavy / light);
        if (heavy / light > mostMassRatio)
            finding.culprits.push_back(link.id);
    }
    if (worst == 0.0)
        return std::nullopt;
    const Solver solver = look.scene.settings.solver;
    if (finding.culprits.empty() || !sweeps(solver)) {
        finding.message =
            finding.culprits.empty()
                ? Message("The ends of a rod differ in mass by a factor of up to %1.",
                          shortNumber(worst))
                : Message("The ends of a rod differ in mass by a factor of up to %1, which this "
                          "solver can follow.",
                          shortNumber(worst));
        return finding;
    }
    std::ranges::sort(finding.culprits);
    finding.severity = Severity::Warning;
    finding.message =
        Message("The ends of a rod differ in mass by a factor of up to %1, and sweeps lift a heavy "
                "end by a light one only slowly: even the masses out, or choose the automatic "
                "solver.",
                shortNumber(worst));
    finding.repair = setting(Message("Choose the automatic solver"),
                             propertyOf<&Settings::solver>(), {settingsId}, {std::string("auto")});
    return finding;
}

// Sweeps find the pull of a rod with compliance c too soft by about (wa + wb) h^2 / c, w being the
// inverse masses of its ends and h the substep; more sweeps in a substep bring it down.
std::optional<Finding> softness(const Look& look)
{
    const Settings& settings = look.scene.settings;
    const double h = settings.timeStep / settings.substeps;
    const int passes = settings.solver == Solver::SmallSteps ? 1 : settings.sweeps;
    double worst = 0.0;
    bool some = false;
    Finding finding = about(Message("Stiffness"));
    for (std::size_t k = 0; k < look.net.ends.size(); ++k) {
        const Link& link = *look.net.all.links[k];
        const int place = look.index.material(link.material);
        if (link.kind != LinkKind::Rod || !look.isTied(k) || place < 0)
            continue;
        const auto& material = std::get<Material>(look.scene.items[std::size_t(place)].item);
        const double compliance = link.compliance.value_or(rodCompliance(material, link));
        double weight = 0.0; // 1/kg
        for (const Particle* end : {&look.end(k, 0), &look.end(k, 1)})
            weight += end->pinned || !(end->mass > 0.0) ? 0.0 : 1.0 / end->mass;
        if (!(compliance > 0.0) || weight == 0.0)
            continue;
        some = true;
        const double share = weight * h * h / (compliance * passes);
        worst = std::max(worst, share);
        if (share > settings.accuracy / 100.0)
            finding.culprits.push_back(link.id);
    }
    if (!some || settings.solver == Solver::PaperJacobi)
        return std::nullopt;
    const Message wanted = shortNumber(settings.accuracy);
    if (!sweeps(settings.solver) || finding.culprits.empty()) {
        finding.culprits.clear();
        finding.message =
            sweeps(settings.solver)
                ? Message("Sweeps keep the stiffness of links to about %1 %.",
                          shortNumber(100.0 * worst))
                : Message("This solver takes what it needs to keep the stiffness of links to %1 %; "
                          "the bar of the run shows what it reaches.",
                          wanted);
        return finding;
    }
    std::ranges::sort(finding.culprits);
    finding.severity = Severity::Warning;
    const Message softer = shortNumber(1.0 + worst);
    finding.message =
        finding.culprits.size() == 1
            ? Message("1 link is too stiff for these sweeps, which make it up to %1 times as soft "
                      "as it says.",
                      softer)
            : Message("%1 links are too stiff for these sweeps, which make them up to %2 times as "
                      "soft as they say.",
                      finding.culprits.size(), softer);
    finding.repair = setting(Message("Choose the automatic solver"),
                             propertyOf<&Settings::solver>(), {settingsId}, {std::string("auto")});
    return finding;
}

// The farthest particle from `start` by links, and how many links away it is.
std::pair<int, int> farthest(const Net& net, const Lists& links, int start, std::vector<int>& seen,
                             int mark)
{
    std::vector<int> queue{start};
    std::vector<int> steps{0};
    seen[std::size_t(start)] = mark;
    for (std::size_t head = 0; head < queue.size(); ++head)
        for (const int link : links[queue[head]]) {
            const auto& ends = net.ends[std::size_t(link)];
            const int other = ends[0] == queue[head] ? ends[1] : ends[0];
            if (other < 0 || seen[std::size_t(other)] == mark)
                continue;
            seen[std::size_t(other)] = mark;
            queue.push_back(other);
            steps.push_back(steps[head] + 1);
        }
    return {queue.back(), steps.back()};
}

int lengthOf(const Net& net)
{
    const Lists links = linksOfParticles(net);
    const auto count = net.all.particles.size();
    std::vector<int> seen(count, 0);
    std::vector<int> again(count, 0);
    int longest = 0;
    for (std::size_t start = 0; start < count; ++start) {
        if (seen[start] || links[int(start)].empty())
            continue;
        const int far = farthest(net, links, int(start), seen, 1).first;
        longest = std::max(longest, farthest(net, links, far, again, 1).second);
    }
    return longest;
}

std::optional<Finding> iterations(const Look& look)
{
    const Settings& settings = look.scene.settings;
    const bool hasRods = std::ranges::any_of(
        look.net.all.links, [](const Link* link) { return link->kind == LinkKind::Rod; });
    if (!hasRods)
        return std::nullopt;
    const int length = lengthOf(look.net);
    const Message links = length == 1 ? Message("1 link") : Message("%1 links", length);
    const bool isJacobi =
        settings.solver == Solver::AveragedJacobi || settings.solver == Solver::PaperJacobi;
    Finding finding = about(Message("Iterations"));
    if (!isJacobi) {
        finding.message =
            settings.solver == Solver::Direct
                ? Message("A pull has to pass %1 to cross the network; the direct solver takes it "
                          "there at once.",
                          links)
                : Message("A pull has to pass %1 to cross the network; this solver takes it far in "
                          "each sweep.",
                          links);
        return finding;
    }
    const long long reach = 1LL * settings.sweeps * settings.substeps;
    const Message substeps =
        settings.substeps == 1 ? Message("1 substep") : Message("%1 substeps", settings.substeps);
    if (reach >= length) {
        finding.message = Message("A pull has to pass %1 to cross the network, and %2 sweeps in %3 "
                                  "take it past %4 in each time step.",
                                  links, settings.sweeps, substeps, reach);
        return finding;
    }
    const int wanted = (length + settings.substeps - 1) / settings.substeps;
    finding.severity = Severity::Warning;
    finding.message =
        Message("A pull has to pass %1 to cross the network, and %2 sweeps in %3 take "
                "it past %4 in each time step: it will look elastic.",
                links, settings.sweeps, substeps, reach);
    finding.repair = setting(Message("Make %1 sweeps", wanted), propertyOf<&Settings::sweeps>(),
                             {settingsId}, {wanted});
    return finding;
}

// What a link resists of its length at the start, as a share of that at rest.
double strainAtStart(const Link& link, double stretch)
{
    switch (link.resists) {
    case Resists::Tension:
        return std::max(stretch, 0.0);
    case Resists::Compression:
        return std::max(-stretch, 0.0);
    case Resists::Both:
        break;
    }
    return std::abs(stretch);
}

std::vector<Finding> lengths(const Look& look)
{
    double worst = 0.0;
    Finding strained = about(Message("Lengths")), torn = about(Message("Tearing"));
    std::vector<Value> starts; // m, [strained.culprits]
    std::vector<std::pair<Id, double>> found;
    for (std::size_t k = 0; k < look.net.ends.size(); ++k) {
        const Link& link = *look.net.all.links[k];
        if (!look.isTied(k) || !(link.restLength > 0.0))
            continue;
        const double start = (look.end(k, 0).position - look.end(k, 1).position).norm();
        const double strain = strainAtStart(link, start / link.restLength - 1.0);
        worst = std::max(worst, strain);
        if (strain > mostStartStrain)
            found.emplace_back(link.id, start);
        const int place = look.index.material(link.material);
        if (place >= 0 && link.resists != Resists::Compression
            && isBeyondLimit(std::get<Material>(look.scene.items[std::size_t(place)].item), link,
                             start))
            torn.culprits.push_back(link.id);
    }
    std::ranges::sort(found);
    for (const auto& [id, start] : found) {
        strained.culprits.push_back(id);
        starts.emplace_back(start);
    }
    std::vector<Finding> findings;
    if (!found.empty()) {
        const Message most = shortNumber(100.0 * mostStartStrain);
        const Message largest = shortNumber(100.0 * worst);
        strained.severity = Severity::Warning;
        strained.message =
            found.size() == 1
                ? Message("1 link is longer or shorter at the start than at rest by more than "
                          "%1 %, up to %2 %.",
                          most, largest)
                : Message("%1 links are longer or shorter at the start than at rest by more than "
                          "%2 %, up to %3 %.",
                          found.size(), most, largest);
        strained.repair = setting(Message("Rest as they start"), propertyOf<&Link::restLength>(),
                                  strained.culprits, std::move(starts));
    } else if (!look.net.ends.empty()) {
        strained.message =
            worst < 1e-4 ? Message("Links are as long at the start as at rest, or slack.")
                         : Message("Links are at most %1 % longer or shorter at the start than at "
                                   "rest.",
                                   shortNumber(100.0 * worst));
    }
    if (!strained.message.empty())
        findings.push_back(std::move(strained));
    if (!torn.culprits.empty()) {
        std::ranges::sort(torn.culprits);
        torn.severity = Severity::Warning;
        torn.message =
            torn.culprits.size() == 1
                ? Message("1 link is beyond the tear limit at the start: the first step tears it, "
                          "or throws its ends together.")
                : Message("%1 links are beyond the tear limit at the start: the first step tears "
                          "them, or throws their ends together.",
                          torn.culprits.size());
        findings.push_back(std::move(torn));
    }
    return findings;
}

std::optional<Finding> massless(const Look& look)
{
    Finding finding = about(Message("Masses"));
    double sum = 0.0;
    std::size_t weighed = 0;
    for (const Particle* particle : look.net.all.particles)
        if (particle->mass > 0.0) {
            sum += particle->mass;
            ++weighed;
        } else if (!particle->pinned) {
            finding.culprits.push_back(particle->id);
        }
    if (finding.culprits.empty())
        return std::nullopt;
    std::ranges::sort(finding.culprits);
    const double mean = weighed > 0 ? sum / double(weighed) : 1e-3; // kg
    finding.severity = Severity::Warning;
    finding.message = finding.culprits.size() == 1
                          ? Message("1 free particle has no mass.")
                          : Message("%1 free particles have no mass.", finding.culprits.size());
    finding.repair = setting(Message("Give %1 g each", shortNumber(1e3 * mean)),
                             propertyOf<&Particle::mass>(), finding.culprits, {mean});
    return finding;
}

std::optional<Finding> doubles(const Look& look)
{
    Finding finding = about(Message("Double links"), "double");
    std::vector<std::array<int, 3>> ties; // lower end, upper end, link
    for (std::size_t k = 0; k < look.net.ends.size(); ++k)
        if (look.isTied(k)) {
            const auto [low, high] = std::minmax(look.net.ends[k][0], look.net.ends[k][1]);
            ties.push_back({low, high, int(k)});
        }
    std::ranges::sort(ties);
    for (std::size_t k = 1; k < ties.size(); ++k)
        if (ties[k][0] == ties[k - 1][0] && ties[k][1] == ties[k - 1][1])
            finding.culprits.push_back(look.net.all.links[std::size_t(ties[k][2])]->id);
    if (finding.culprits.empty())
        return std::nullopt;
    std::ranges::sort(finding.culprits);
    finding.severity = Severity::Warning;
    finding.message =
        finding.culprits.size() == 1
            ? Message(
                "1 link joins particles that are joined already, so that they are as stiff as "
                "two.")
            : Message("%1 links join particles that are joined already, so that they are as stiff "
                      "as two.",
                      finding.culprits.size());
    finding.repair = removal(look.scene, finding.culprits);
    finding.repair->label = Message("Remove the double links");
    return finding;
}

std::optional<Finding> loose(const Look& look)
{
    Finding finding = about(Message("Loose particles"), "loose");
    if (look.net.ends.empty())
        return std::nullopt; // a cloud of particles is meant
    std::vector<char> tied(look.net.all.particles.size(), 0);
    for (const auto& ends : look.net.ends)
        for (const int end : ends)
            if (end >= 0)
                tied[std::size_t(end)] = 1;
    for (const auto& corners : look.net.corners)
        for (const int corner : corners)
            if (corner >= 0)
                tied[std::size_t(corner)] = 1;
    for (std::size_t i = 0; i < tied.size(); ++i)
        if (!tied[i] && !look.net.all.particles[i]->pinned)
            finding.culprits.push_back(look.net.all.particles[i]->id);
    if (finding.culprits.empty())
        return std::nullopt;
    std::ranges::sort(finding.culprits);
    finding.severity = Severity::Warning;
    finding.message =
        finding.culprits.size() == 1
            ? Message("1 particle hangs on no link and no panel.")
            : Message("%1 particles hang on no link and no panel.", finding.culprits.size());
    finding.repair = removal(look.scene, finding.culprits);
    finding.repair->label = Message("Remove the loose particles");
    return finding;
}

} // namespace

std::vector<Finding> stabilityOf(const Scene& scene)
{
    const Look look(scene);
    std::vector<Finding> findings;
    for (Finding& finding : fabricFindings(scene))
        findings.push_back(std::move(finding));
    for (auto examine : {massless, loose, doubles, timeStep, softness, massRatio, iterations})
        if (auto finding = examine(look))
            findings.push_back(std::move(*finding));
    for (Finding& finding : lengths(look))
        findings.push_back(std::move(finding));
    std::ranges::stable_sort(findings, {}, &Finding::severity);
    return findings;
}

int networkLength(const Scene& scene) { return lengthOf(Net(scene)); }

} // namespace ripstop
