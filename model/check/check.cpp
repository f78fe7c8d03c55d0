// Looks for the problems of a scene in this order:
// 1. Errors: ids that are used twice, references that dangle or point at the wrong kind, free
//    particles without mass or guide axis, and items whose numbers or files cannot work.
// 2. Warnings of the mesh: links that join the same two particles, particles without links
//    (network_check.h), and fabric that is there twice or too heavy (fabric_check.h).
// 3. Warnings of the run: what the step has to bear (step_check.h), colliders that fit between the
//    particles of the fabric, and particles that begin inside one.
// Elements that pass isSound() skip the walk over the property table, so that large tables stay
// cheap. The result is sorted by severity and keeps the order of finding within each.
#include "check/check.h"

#include "base/quantity.h"
#include "check/elastic_check.h"
#include "check/fabric_check.h"
#include "check/flutter_check.h"
#include "check/gap_check.h"
#include "check/hinge_check.h"
#include "check/network_check.h"
#include "check/start_check.h"
#include "check/step_check.h"
#include "check/tear_check.h"
#include "check/thread_check.h"
#include "check/unknown.h"
#include "check/weight_check.h"
#include "derived/canopy_shape.h"
#include "derived/collider_shape.h"
#include "derived/fabric_picture.h"
#include "derived/formula.h"
#include "scene/element_index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ripstop {
namespace {

bool hasParticles(const Scene& scene)
{
    bool has = false;
    forEachPart(scene, [&](Id, const Part& part) { has |= !part.particles.empty(); });
    return has;
}

bool hasDirection(const Particle& row)
{
    return row.pinned || row.guide == Guide::None || row.guideAxis.norm() > 0.0;
}

bool isSound(const Particle& row) { return hasDirection(row) && (row.pinned || row.mass > 0.0); }

bool hasEnds(const Link& row) { return row.from != noId && row.to != noId && row.from != row.to; }

bool hasCorners(const Panel& row)
{
    return row.a != noId && row.b != noId && row.c != noId && row.a != row.b && row.b != row.c
           && row.a != row.c;
}

bool isMaterial(const ElementIndex& index, Id id) { return id == noId || index.material(id) >= 0; }

bool isSound(const Link& row, const ElementIndex& index)
{
    return hasEnds(row) && index.particle(row.from) >= 0 && index.particle(row.to) >= 0
           && isMaterial(index, row.material);
}

bool isSound(const Panel& row, const ElementIndex& index)
{
    return hasCorners(row) && index.particle(row.a) >= 0 && index.particle(row.b) >= 0
           && index.particle(row.c) >= 0 && isMaterial(index, row.material);
}

class Checker
{
public:
    Checker(const Scene& scene, const ElementIndex& index, std::size_t most)
        : m_scene(scene)
        , m_index(index)
        , m_most(most)
    {}

    std::vector<Finding> run()
    {
        errors();
        if (!hasErrors(m_problems))
            checkRestLengths(m_scene, m_index, adding());
        checkNetwork(m_scene, m_index, adding());
        checkFabric(m_scene, m_index, adding());
        names();
        checkStep(m_scene, m_index, adding());
        checkGaps(m_scene, adding());
        checkHinges(m_scene, m_index, adding());
        checkStart(m_scene, adding());
        checkTearing(m_scene, adding());
        checkThreads(m_scene, adding());
        checkWeights(m_scene, m_index, adding());
        checkFlutter(m_scene, adding());
        checkUnknown(m_scene, m_index, adding());
        if (!hasParticles(m_scene))
            add("empty", Severity::Warning,
                Message("The scene has no particles: insert a part or import a mesh."), noId);
        std::stable_sort(
            m_problems.begin(), m_problems.end(),
            [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
        return std::move(m_problems);
    }

    std::optional<Finding> firstError()
    {
        errors();
        return first();
    }

    std::optional<Finding> firstErrorOfItems()
    {
        for (const Entry& entry : m_scene.items)
            std::visit([&](const auto& item) { pointing(entry.id, &item); }, entry.item);
        shapes();
        return first();
    }

private:
    void errors()
    {
        for (const Id id : m_index.repeated())
            add("twice", Severity::Error,
                Message("The id %1 is used twice; give one of the two another id.",
                        std::uint32_t(id)),
                id);
        references();
        masses();
        shapes();
        checkElasticPanels(m_scene, m_index, adding());
    }

    AddFinding adding()
    {
        return [this](const char* sort, Severity severity, Message message, Id id) {
            add(sort, severity, std::move(message), id);
        };
    }

    std::optional<Finding> first() const
    {
        for (const Finding& problem : m_problems)
            if (problem.severity == Severity::Error)
                return problem;
        return std::nullopt;
    }

    void add(const char* sort, Severity severity, Message message, Id culprit)
    {
        if (++m_count[sort] > m_most)
            return;
        Finding problem{severity, std::move(message), {}, sort};
        if (culprit != noId)
            problem.culprits = {culprit};
        m_problems.push_back(std::move(problem));
    }

    void pointing(Id holder, const ConstRef& ref)
    {
        for (const Property& property : propertiesOf(kindOf(ref))) {
            if (property.pointsAt.empty())
                continue;
            const auto check = [&](Id id) {
                const std::optional<Kind> found = m_index.kindOf(id);
                if ((found && property.pointsAt.contains(*found)) || m_count["dangling"] >= m_most)
                    return;
                const Message name = subjectOf(kindOf(ref), holder);
                const auto number = std::uint32_t(id);
                const UnknownItem* unknown = findUnknownItem(m_scene, id);
                add("dangling", Severity::Error,
                    found     ? Message("%1: %2 points at %3, which is a %4.", name, property.key,
                                        number, Message::word(kindName(*found)))
                    : unknown ? Message("%1: %2 points at %3 of the type %4, which this version "
                                        "does not know; choose another or remove it.",
                                        name, property.key, number, unknown->type)
                              : Message("%1: %2 points at %3, which does not exist; choose another "
                                        "or remove it.",
                                        name, property.key, number),
                    holder);
            };
            const Value value = property.get(ref);
            if (const Id* id = std::get_if<Id>(&value); id && *id != noId)
                check(*id);
            if (const auto* ids = std::get_if<std::vector<Id>>(&value))
                for (const Id member : *ids) // noId is no valid member of a list
                    check(member);
        }
    }

    void references()
    {
        for (const Entry& entry : m_scene.items) {
            std::visit([&](const auto& item) { pointing(entry.id, &item); }, entry.item);
            if (const Part* part = std::get_if<Part>(&entry.item)) {
                for (const Link& row : part->links) {
                    if (isSound(row, m_index))
                        continue;
                    pointing(row.id, &row);
                    if (!hasEnds(row))
                        add("ends", Severity::Error,
                            Message("%1 needs two different particles as its ends; remove it.",
                                    subjectOf(Kind::Link, row.id)),
                            row.id);
                }
                for (const Panel& row : part->panels) {
                    if (isSound(row, m_index))
                        continue;
                    pointing(row.id, &row);
                    if (!hasCorners(row))
                        add("corners", Severity::Error,
                            Message("%1 needs three different particles as its corners; remove "
                                    "it.",
                                    subjectOf(Kind::Panel, row.id)),
                            row.id);
                }
            }
        }
    }

    void masses()
    {
        forEachPart(m_scene, [&](Id, const Part& part) {
            for (const Particle& row : part.particles) {
                if (isSound(row))
                    continue;
                const Message name = subjectOf(Kind::Particle, row.id);
                if (!hasDirection(row))
                    add("guide", Severity::Error,
                        Message("%1 of %2 needs a guide axis that is not zero.", name, part.name),
                        row.id);
                else
                    add("massless", Severity::Error,
                        Message("%1 of %2 is free and has no mass: give it a mass or pin it.", name,
                                part.name),
                        row.id);
            }
        });
    }

    // Of elastic panels, elastic_check.h looks at more.
    void checkMaterial(const Material& material, Id id)
    {
        constexpr double stiffest = 1e12; // N, N/m, N m, N m^2; a bar of steel of 5 m^2
        for (const Property* property :
             {&propertyOf<&Material::stiffness>(), &propertyOf<&Material::axialStiffness>(),
              &propertyOf<&Material::membraneStiffness>(),
              &propertyOf<&Material::bendingStiffness>(),
              &propertyOf<&Material::flexuralRigidity>()}) {
            const Value value = property->get(&material);
            const double* const number = std::get_if<double>(&value);
            if (number && *number > stiffest)
                add("stiff", Severity::Error,
                    Message("%1 of material %2 is above %3 %4, which no step can solve and nothing "
                            "is: check the unit.",
                            Message::word(property->label), material.name,
                            Message::number("%.0e", stiffest), property->unit),
                    id);
        }
        if (auto warning = pictureWarning(m_scene, material))
            add("picture", Severity::Warning, std::move(*warning), id);
    }

    // A step has the wind of its end, so a gust that is over in few of them is not what was typed.
    void checkGust(const Wind& wind, Id id)
    {
        constexpr double fewest = 10.0; // steps
        const double step = m_scene.settings.timeStep;
        if (wind.interval > 0.0 && wind.interval < wind.duration)
            add("gust-interval", Severity::Error,
                Message("Wind %1 comes again after %2 s, before it has ended at %3 s: make the "
                        "interval as long as the duration or longer, or 0 for one gust.",
                        wind.name, Message::number("%.4g", wind.interval),
                        Message::number("%.4g", wind.duration)),
                id);
        if (wind.duration < fewest * step)
            add("gust-duration", Severity::Warning,
                Message("Wind %1 is over in %2 s, less than ten steps of %3 s: make it longer, or "
                        "the time step shorter.",
                        wind.name, Message::number("%.4g", wind.duration),
                        Message::number("%.4g", step)),
                id);
    }

    static double fastest(const Wind& wind) // m/s
    {
        if (wind.kind != WindKind::Measured)
            return wind.velocity.norm();
        double most = 0.0;
        for (const std::vector<double>& row : wind.velocities)
            most = std::max(most, Vec3(row[1], row[2], row[3]).norm());
        return most;
    }

    void checkWind(const Wind& wind, Id id)
    {
        if (wind.kind == WindKind::LogLaw && !(wind.roughness < wind.referenceHeight))
            add("roughness", Severity::Error,
                Message("Wind %1 needs a roughness that is below its reference height.", wind.name),
                id);
        if (wind.kind == WindKind::DiscreteGust)
            checkGust(wind, id);
        if (wind.kind == WindKind::Measured && wind.velocities.size() < 2)
            add("wind-record", Severity::Warning,
                Message("Wind %1 has one row of velocities, and blows by it all the time: read a "
                        "table of more.",
                        wind.name),
                id);
        constexpr double latest = 60.0; // s, of a table that does not count by a clock
        if (wind.kind == WindKind::Measured && wind.velocities.front()[0] > latest)
            add("wind-clock", Severity::Warning,
                Message("Wind %1 blows by its first row until %2 s of the run: let the times of "
                        "its table count from the start of the run.",
                        wind.name, Message::number("%.7g", wind.velocities.front()[0])),
                id);
        const double speed = fastest(wind), limit = m_scene.settings.speedLimit;
        if (speed > limit)
            add("storm", Severity::Warning,
                Message("Wind %1 blows with %2 m/s, and a run stops where something goes faster "
                        "than the speed limit of %3 m/s: check the unit.",
                        wind.name, Message::number("%.4g", speed), Message::number("%.4g", limit)),
                id);
    }

    void checkControl(const Control& control, Id id)
    {
        if (!(control.axis.norm() > 0.0))
            add("axis", Severity::Error,
                Message("Control %1 needs an axis that is not zero.", control.name), id);
        const auto isCollider = [&](Id target) { return m_index.kindOf(target) == Kind::Collider; };
        if (control.kind == ControlKind::WeightShift
            && std::ranges::any_of(control.targets, isCollider))
            add("weight", Severity::Warning,
                Message(
                    "Control %1 shifts weights, and a collider has none: make it move, or remove "
                    "the collider from its targets.",
                    control.name),
                id);
        if (control.targets.empty())
            add("idle", Severity::Warning,
                Message("Control %1 has no targets and does nothing.", control.name), id);
        if (std::abs(control.automaticRate) > control.rate)
            add("slow-control", Severity::Warning,
                Message(
                    "Control %1 is to move by itself at %2 m/s, and its rate lets it move at %3 "
                    "m/s: raise the rate, or lower the automatic one.",
                    control.name, Message::number("%.4g", std::abs(control.automaticRate)),
                    Message::number("%.4g", control.rate)),
                id);
    }

    void shapes()
    {
        for (const Entry& entry : m_scene.items) {
            if (const Part* part = std::get_if<Part>(&entry.item); part && part->canopyPressure > 0)
                if (auto pieces = canopyPieces(*part); !pieces)
                    add("canopy", Severity::Error, pieces.message(), entry.id);
            if (const Collider* collider = std::get_if<Collider>(&entry.item))
                if (auto error = colliderError(m_scene, *collider))
                    add("collider", Severity::Error, std::move(*error), entry.id);
            if (const Material* material = std::get_if<Material>(&entry.item))
                checkMaterial(*material, entry.id);
            if (const Wind* wind = std::get_if<Wind>(&entry.item))
                checkWind(*wind, entry.id);
            if (const Control* control = std::get_if<Control>(&entry.item))
                checkControl(*control, entry.id);
            if (const Probe* probe = std::get_if<Probe>(&entry.item))
                checkProbe(*probe, entry.id);
            if (const Plot* plot = std::get_if<Plot>(&entry.item))
                checkPlot(*plot, entry.id);
        }
        for (const ProbeFormula& probe : formulasOf(m_scene))
            if (!probe.formula)
                add("formula", Severity::Warning,
                    Message("The formula of probe %1 cannot be worked out: %2.",
                            nameOf(*findItem(m_scene, probe.probe)), probe.formula.message()),
                    probe.probe);
    }

    void checkProbe(const Probe& probe, Id id)
    {
        const int points = rowOf(probe.quantity).points;
        if (points >= 2 && (probe.target == noId || probe.from == noId))
            add("probe", Severity::Warning,
                Message("Probe %1 needs a target and a particle to measure from.", probe.name), id);
        else if (points >= 3 && probe.side == noId)
            add("probe", Severity::Warning,
                Message("Probe %1 needs a third particle, on the right.", probe.name), id);
    }

    void checkPlot(const Plot& plot, Id id)
    {
        if (plot.axis == PlotAxis::Probe && plot.against == noId)
            add("plot", Severity::Warning,
                Message("Plot %1 needs the probe that its curves are against.", plot.name), id);
        if (plot.low && plot.high && *plot.low >= *plot.high)
            add("plot", Severity::Warning,
                Message("Plot %1 shows no values: its lowest has to be below its highest.",
                        plot.name),
                id);
    }

    // Materials are told apart by their names, in lists as in paths.
    void names()
    {
        std::map<std::string_view, Id> first;
        for (const Entry& entry : m_scene.items) {
            const Material* const material = std::get_if<Material>(&entry.item);
            if (!material)
                continue;
            const auto [known, isNew] = first.try_emplace(material->name, entry.id);
            if (!isNew)
                add("namesake", Severity::Warning,
                    Message("Materials #%1 and #%2 are both called %3, and a path of that name "
                            "means the first: rename one.",
                            std::uint32_t(known->second), std::uint32_t(entry.id), material->name),
                    entry.id);
        }
    }

    const Scene& m_scene;
    const ElementIndex& m_index;
    std::size_t m_most;
    std::map<std::string_view, std::size_t> m_count;
    std::vector<Finding> m_problems;
};

} // namespace

std::vector<Finding> problemsOf(const Scene& scene, std::size_t most)
{
    const ElementIndex index(scene);
    return Checker(scene, index, most).run();
}

std::optional<Finding> firstError(const Scene& scene, const ElementIndex& index)
{
    return Checker(scene, index, 1).firstError();
}

std::optional<Finding> firstErrorOfItems(const Scene& scene, const ElementIndex& index)
{
    return Checker(scene, index, 1).firstErrorOfItems();
}

bool isSound(const ConstRef& ref, const ElementIndex& index)
{
    if (const auto* particle = std::get_if<const Particle*>(&ref))
        return isSound(**particle);
    if (const auto* link = std::get_if<const Link*>(&ref))
        return isSound(**link, index);
    if (const auto* panel = std::get_if<const Panel*>(&ref))
        return isSound(**panel, index);
    return true;
}

bool hasErrors(const std::vector<Finding>& problems)
{
    return std::any_of(problems.begin(), problems.end(),
                       [](const Finding& p) { return p.severity == Severity::Error; });
}

} // namespace ripstop
