// What a row of the scene becomes, item by item: settings, particles, links, materials, winds,
// obstacles, inputs, probes and the rods that weight shifts move. Probes collect the elements of
// parts and groups by ranges of indices.
#include "compile/resolve.h"

#include "base/quantity.h"
#include "derived/collider_shape.h"
#include "derived/formula.h"
#include "derived/link_stiffness.h"
#include "derived/tear_bounds.h"
#include "scene/collider_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ripstop {
namespace {

enum Own : std::uint8_t { OwnStiffness = 1, OwnDamping = 2, OwnCompliance = 4, OwnTearLimit = 8 };

void takeTear(const Material& material, const LinkStuff& stuff, const ElementFactors& factors,
              TearLimit& tear)
{
    tear = linkTearOf(material, stuff.role, stuff.width,
                      stuff.own & OwnTearLimit ? std::optional(tear.limit) : std::nullopt,
                      factors.strength);
}

template <typename T, typename Visit>
void forEachItem(const Scene& scene, Visit visit)
{
    for (const Entry& entry : scene.items)
        if (const T* item = std::get_if<T>(&entry.item))
            visit(entry.id, *item);
}

// Linear in the angle between the author's rows; the first and the last hold beyond them.
PolarPoint polarAt(const NumberRows& table, double degrees)
{
    const auto above = std::find_if(table.begin(), table.end(),
                                    [&](const auto& row) { return row[0] >= degrees; });
    if (above == table.begin() || above == table.end()) {
        const auto& row = above == table.end() ? table.back() : table.front();
        return {row[1], row[2]};
    }
    const auto& high = *above;
    const auto& low = *std::prev(above);
    const double share = (degrees - low[0]) / (high[0] - low[0]);
    return {low[1] + share * (high[1] - low[1]), low[2] + share * (high[2] - low[2])};
}

std::vector<PolarPoint> polarOf(const NumberRows& table)
{
    std::vector<PolarPoint> polar;
    for (int i = 0; i <= polarCells; ++i)
        polar.push_back(
            polarAt(table, 2.0 * std::atan(double(i) / polarCells) * 180.0 / std::numbers::pi));
    return polar;
}

// Adds what ids stand for to a probe: elements themselves, elements of parts and of groups.
class Collector
{
public:
    Collector(const Scene& scene, const ElementIndex& index)
        : m_scene(scene)
        , m_index(index)
    {
        Range next{};
        forEachPart(scene, [&](Id id, const Part& part) {
            const Range end{next.particle + int(part.particles.size()),
                            next.link + int(part.links.size()),
                            next.panel + int(part.panels.size())};
            m_parts.push_back({id, next, end});
            next = end;
        });
    }

    void addAll(ProbeSpec& spec) const
    {
        for (const PartRange& part : m_parts)
            addPart(part, spec);
    }

    void add(Id id, ProbeSpec& spec) const
    {
        if (const int particle = m_index.particle(id); particle >= 0)
            spec.particles.push_back(particle);
        else if (const int link = m_index.link(id); link >= 0)
            spec.links.push_back(link);
        else if (const int panel = m_index.panel(id); panel >= 0)
            spec.panels.push_back(panel);
        else if (const Group* group = findItem<Group>(m_scene, id))
            for (const Id member : group->members)
                add(member, spec);
        else
            for (const PartRange& part : m_parts)
                if (part.id == id)
                    addPart(part, spec);
    }

private:
    struct Range
    {
        int particle = 0;
        int link = 0;
        int panel = 0;
    };
    struct PartRange
    {
        Id id;
        Range first;
        Range last;
    };

    static void addRange(std::vector<int>& list, int first, int last)
    {
        const std::size_t middle = list.size();
        list.resize(middle + std::size_t(last - first));
        std::iota(list.begin() + std::ptrdiff_t(middle), list.end(), first);
    }

    static void addPart(const PartRange& part, ProbeSpec& spec)
    {
        addRange(spec.particles, part.first.particle, part.last.particle);
        addRange(spec.links, part.first.link, part.last.link);
        addRange(spec.panels, part.first.panel, part.last.panel);
    }

    const Scene& m_scene;
    const ElementIndex& m_index;
    std::vector<PartRange> m_parts;
};

} // namespace

void takeSettings(const Settings& settings, System& system)
{
    system.timeStep = settings.timeStep;
    system.substeps = settings.substeps;
    system.sweeps = settings.sweeps;
    system.integrator = settings.integrator;
    system.solver = settings.solver;
    system.accuracy = settings.accuracy / 100.0;
    system.strainGoal = settings.strainGoal / 100.0;
    system.rampTime = settings.rampTime;
    system.tearsPerStep = settings.tearsPerStep;
    system.tearMesh = settings.tearMesh;
    system.gravity = settings.gravity;
    system.airDensity = settings.airDensity;
    system.viscosity = settings.viscosity;
    system.speedLimit = settings.speedLimit;
    system.safetyFactor = settings.safetyFactor;
}

void takeParticle(const Particle& row, int place, System& system)
{
    const auto take = [&](const auto& value, auto& all) {
        if (std::size_t(place) == all.size())
            all.push_back(value);
        else
            all[std::size_t(place)] = value;
    };
    const Vec3 velocity =
        row.pinned ? Vec3(Vec3::Zero()) : guidedOf(row, place).freePart(row.velocity);
    take(Key(row.id), system.key);
    take(row.mass, system.mass);
    take(row.pinned ? 0.0 : 1.0 / row.mass, system.inverseMass);
    take(PaddedVec3(row.position), system.start.position);
    take(PaddedVec3(velocity), system.start.velocity);
}

GuidedParticle guidedOf(const Particle& row, int place)
{
    if (row.pinned)
        return {place, Guide::None, Vec3::UnitX()};
    return {place, row.guide, row.guideAxis.normalized()};
}

LinkStuff stuffOf(const Link& row)
{
    const int own = (row.stiffness ? OwnStiffness : 0) | (row.damping ? OwnDamping : 0)
                    | (row.compliance ? OwnCompliance : 0) | (row.tearLimit ? OwnTearLimit : 0);
    return {Key(row.material), std::uint8_t(own), row.role, row.width};
}

Spring springOf(const Link& row, const Material& material, int a, int b)
{
    Spring spring{a,
                  b,
                  row.restLength,
                  row.stiffness.value_or(0.0),
                  row.damping.value_or(0.0),
                  row.resists,
                  {TearRule::Never, row.tearLimit.value_or(0.0)}};
    takeMaterial(material, stuffOf(row), factorsOf(row), spring);
    return spring;
}

Rod rodOf(const Link& row, const Material& material, int a, int b)
{
    if (row.kind == LinkKind::Spring)
        return asRod(springOf(row, material, a, b));
    Rod rod{a,
            b,
            row.restLength,
            row.compliance.value_or(0.0),
            row.resists,
            {TearRule::Never, row.tearLimit.value_or(0.0)}};
    takeMaterial(material, stuffOf(row), factorsOf(row), rod);
    return rod;
}

MaterialAir airOf(Id id, const Material& material)
{
    MaterialAir air;
    air.key = Key(id);
    // a wing that stalls is a plate
    const bool wing = material.airLaw == AirLaw::Vortex;
    air.law = wing ? AirLaw::LinearNormal : material.airLaw;
    if (wing)
        air.stall = std::sin(material.stallAngle * std::numbers::pi / 180.0);
    air.normalCoefficient = material.normalCoefficient;
    if (material.broadsideCoefficient && air.law == AirLaw::LinearNormal
        && material.normalCoefficient > 0.0)
        air.saturation = material.normalCoefficient / *material.broadsideCoefficient - 1.0;
    air.skinFriction = material.skinFriction;
    air.porosity = wing ? 0.0 : material.porosity;
    air.lineWidth = material.dragCoefficient * material.diameter;
    if (material.airLaw == AirLaw::LiftDrag)
        air.polar = polarOf(material.polar);
    return air;
}

std::vector<MaterialAir> materialAirOf(const Scene& scene)
{
    std::vector<MaterialAir> airs{airOf(noId, Material())};
    forEachItem<Material>(scene, [&](Id id, const Material& m) { airs.push_back(airOf(id, m)); });
    return airs;
}

Bending bendingOf(const Material& material)
{
    return {material.bendingStiffness, material.flexuralRigidity, snapMomentOf(material)};
}

std::vector<Bending> bendingsOf(const Scene& scene)
{
    std::vector<Bending> bendings{Bending()};
    forEachItem<Material>(scene, [&](Id, const Material& m) { bendings.push_back(bendingOf(m)); });
    return isLimp(bendings) ? std::vector<Bending>() : bendings;
}

bool isLimp(const std::vector<Bending>& bendings)
{
    return std::all_of(bendings.begin(), bendings.end(), [](const Bending& bending) {
        return bending.fabric == 0.0 && bending.spar == 0.0;
    });
}

Strength strengthOf(const Material& material)
{
    const double joints = shareLeftByJoints(material);
    return {joints * material.lineStrength.value_or(0.0),
            joints * material.warpStrength.value_or(0.0),
            joints * material.weftStrength.value_or(0.0),
            joints * material.breakingMoment.value_or(0.0)};
}

std::vector<Strength> strengthsOf(const Scene& scene)
{
    std::vector<Strength> strengths{Strength()};
    forEachItem<Material>(scene,
                          [&](Id, const Material& m) { strengths.push_back(strengthOf(m)); });
    return hasNone(strengths) ? std::vector<Strength>() : strengths;
}

bool hasNone(const std::vector<Strength>& strengths)
{
    return std::ranges::all_of(strengths, [](const Strength& s) { return s == Strength(); });
}

ClothLaw clothOf(const Material& material)
{
    if (!material.membraneStiffness)
        return {};
    const double warp = *material.membraneStiffness;
    const double weft = material.weftStiffness.value_or(warp);
    const double ofSheet = std::sqrt(warp * weft) / (2.0 * (1.0 + material.poissonRatio));
    ClothLaw law =
        ClothLaw::of(warp, weft, material.poissonRatio, material.shearStiffness.value_or(ofSheet));
    law.dampingTime = material.dampingTime;
    law.pushes = material.resistsPushing;
    return law;
}

std::vector<ClothLaw> clothsOf(const Scene& scene)
{
    bool isElastic = false;
    forEachPart(scene, [&](Id, const Part& part) {
        isElastic |= part.carrier == FabricKind::Panels && !part.panels.empty();
    });
    if (!isElastic)
        return {};
    std::vector<ClothLaw> cloths{ClothLaw()};
    forEachItem<Material>(scene, [&](Id, const Material& m) { cloths.push_back(clothOf(m)); });
    return cloths;
}

std::vector<FabricTear> fabricTearsOf(const Scene& scene)
{
    std::vector<FabricTear> tears{FabricTear()};
    forEachItem<Material>(scene, [&](Id, const Material& m) { tears.push_back(fabricTearOf(m)); });
    return tears;
}

void takeMaterial(const Material& material, const LinkStuff& stuff, const LinkFactors& factors,
                  Spring& spring)
{
    if (!(stuff.own & OwnStiffness))
        spring.stiffness =
            factors.stiffness
            * springStiffness(material, {stuff.role, stuff.width, factors.cellAspect},
                              spring.restLength);
    if (!(stuff.own & OwnDamping))
        spring.damping = material.damping;
    takeTear(material, stuff, factors, spring.tear);
}

void takeMaterial(const Material& material, const LinkStuff& stuff, const LinkFactors& factors,
                  Rod& rod)
{
    if (!(stuff.own & OwnCompliance))
        rod.compliance =
            rodCompliance(material, {stuff.role, stuff.width, factors.cellAspect}, rod.restLength)
            / factors.stiffness;
    rod.dampingTime = material.dampingTime;
    takeTear(material, stuff, factors, rod.tear);
}

std::vector<Obstacle> obstaclesOf(const Scene& scene)
{
    std::vector<Obstacle> obstacles;
    forEachItem<Collider>(scene, [&](Id id, const Collider& collider) {
        Obstacle obstacle{collider.shape,    collider.position,  collider.normal.normalized(),
                          collider.radius,   collider.response,  collider.restitution,
                          collider.friction, collider.thickness, collider.size,
                          turnOf(collider)};
        obstacle.key = Key(id);
        obstacle.scale = collider.scale;
        // What fails here was found by the check before.
        if (const auto path = pathFromText(collider.path))
            obstacle.path = *path;
        if (const auto data = shapeDataOf(scene, collider)) {
            obstacle.grid = data->grid;
            obstacle.mesh = data->mesh;
        }
        obstacles.push_back(std::move(obstacle));
    });
    return obstacles;
}

std::vector<FabricLayer> fabricLayersOf(const Scene& scene)
{
    std::vector<FabricLayer> layers;
    bool any = false;
    forEachPart(scene, [&](Id, const Part& part) {
        layers.resize(layers.size() + part.particles.size(), {part.selfContact, part.selfFriction});
        any |= part.selfContact > 0.0;
    });
    return any ? layers : std::vector<FabricLayer>();
}

std::vector<Input> inputsOf(const Scene& scene, const ElementIndex& index)
{
    std::vector<Id> colliders;
    forEachItem<Collider>(scene, [&](Id id, const Collider&) { colliders.push_back(id); });
    std::vector<Input> inputs;
    forEachItem<Control>(scene, [&](Id id, const Control& control) {
        Input input{Key(id),
                    control.kind,
                    control.axis.normalized(),
                    control.limit,
                    control.rate,
                    control.automaticRate,
                    {}};
        for (const Id target : control.targets)
            if (const int particle = index.particle(target); particle >= 0)
                input.targets.push_back(particle);
            else
                input.obstacles.push_back(
                    int(std::find(colliders.begin(), colliders.end(), target) - colliders.begin()));
        inputs.push_back(std::move(input));
    });
    return inputs;
}

std::vector<ProbeSpec> probesOf(const Scene& scene, const ElementIndex& index)
{
    const Collector collector(scene, index);
    const std::vector<ProbeFormula> formulas = formulasOf(scene);
    std::vector<ProbeSpec> probes;
    forEachItem<Probe>(scene, [&](Id id, const Probe& probe) {
        ProbeSpec spec{Key(id),
                       probe.name,
                       probe.quantity,
                       {},
                       {},
                       {},
                       -1,
                       -1,
                       probe.plotted,
                       std::string(unitOf(probe.quantity)),
                       {}};
        if (probe.quantity == Quantity::Formula) {
            const auto found = std::ranges::find(formulas, id, &ProbeFormula::probe);
            if (const auto& formula = found->formula) {
                spec.formula = probe.formula;
                spec.unit = formula->unit();
            }
        }
        if (probe.target == noId)
            collector.addAll(spec);
        else
            collector.add(probe.target, spec);
        if (probe.from != noId)
            spec.from = index.particle(probe.from);
        if (probe.side != noId)
            spec.side = index.particle(probe.side);
        probes.push_back(std::move(spec));
    });
    return probes;
}

std::vector<ShiftedRod> shiftedRodsOf(const System& system)
{
    std::vector<int> weights;
    for (const Input& input : system.inputs)
        if (input.kind == ControlKind::WeightShift)
            weights.insert(weights.end(), input.targets.begin(), input.targets.end());
    std::sort(weights.begin(), weights.end());
    weights.erase(std::unique(weights.begin(), weights.end()), weights.end());

    std::vector<ShiftedRod> shifted;
    const auto& position = system.start.position;
    for (const int weight : weights) {
        const auto first = system.rodsAt.items.begin() + system.rodsAt.start[std::size_t(weight)];
        const auto last =
            system.rodsAt.items.begin() + system.rodsAt.start[std::size_t(weight) + 1];
        std::vector<int> rods(first, last);
        std::sort(rods.begin(), rods.end(), [&](int a, int b) { // the author's order
            return system.rodLink[std::size_t(a)] < system.rodLink[std::size_t(b)];
        });
        for (const int r : rods) {
            const Rod& rod = system.rods[std::size_t(r)];
            const int other = rod.a == weight ? rod.b : rod.a;
            shifted.push_back(
                {r, weight, position[std::size_t(other)] - position[std::size_t(weight)]});
        }
    }
    return shifted;
}

} // namespace ripstop
