#include "scene/usage.h"

#include "base/quantity.h"
#include "shapes/solid.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

using Reason = std::optional<std::string>;

constexpr auto used = std::nullopt;

struct Around
{
    const Scene& scene;
    const Usage& usage;
    Id id;
};

Reason unless(bool holds, const char* reason) { return holds ? Reason() : Reason(reason); }

Reason idle(const Settings& settings, std::string_view key, const Around& around)
{
    const Use& all = around.usage.ofAll;
    if (key == "strainGoal" && settings.solver != Solver::Auto)
        return "only the automatic solver aims at a strain";
    if (key == "sweeps"
        && (settings.solver == Solver::SmallSteps || settings.solver == Solver::Auto))
        return "this solver makes one sweep in each substep; give it more substeps";
    if (key == "sweeps" || key == "solver" || key == "strainGoal")
        return unless(all.rods > 0, "no link is a rod, and springs need no solver");
    if (key == "airDensity")
        return unless(all.panels > 0 || all.links() > 0, "there is nothing for the air to act on");
    if (key == "tearsPerStep" || key == "tearMesh") {
        const auto tears = [](const Entry& entry) {
            const Material* material = std::get_if<Material>(&entry.item);
            return material && material->tearRule != TearRule::Never;
        };
        return unless(std::ranges::any_of(around.scene.items, tears), "no material tears");
    }
    return used;
}

Reason idle(const Part& part, std::string_view key, const Around&)
{
    if (key == "fillEfficiency" || key == "addedMass")
        return unless(part.canopyPressure > 0.0, "the part has no canopy pressure");
    if (key == "selfFriction")
        return unless(part.selfContact > 0.0, "the part has no self-contact");
    return used;
}

Reason idle(const Collider& collider, std::string_view key, const Around&)
{
    const ShapeUses& uses = rowOf(collider.shape).uses;
    if (key == "position")
        return unless(collider.path.empty(), "the path says where it is");
    if (key == "normal")
        return unless(uses.normal, "only planes have one");
    if (key == "radius")
        return unless(uses.radius, "only round shapes have one");
    if (key == "size")
        return unless(uses.size, "this shape has none");
    if (key == "turn")
        return unless(uses.turn, "planes and spheres do not turn");
    if (key == "file")
        return unless(uses.file, "only height fields and meshes come from files");
    if (key == "scale")
        return unless(uses.scale, "only meshes are scaled");
    if (key == "grid" || key == "seed" || key == "hillLength")
        return unless(uses.hills && collider.file.empty(),
                      "only generated hills, a height field without a file, have it");
    if (key == "restitution" || key == "friction")
        return unless(collider.response == Response::Contact,
                      "only the response contact bounces and rubs");
    return used;
}

Reason idle(const Wind& wind, std::string_view key, const Around& around)
{
    const auto isKind = [&](auto... kinds) { return ((wind.kind == kinds) || ...); };
    using enum WindKind;
    if (key == "name")
        return used;
    if (around.scene.settings.airDensity == 0.0)
        return "the air density is 0";
    if (around.usage.ofAll.panels == 0 && around.usage.ofAll.links() == 0)
        return "there is nothing for the air to act on";
    if (key == "velocity")
        return unless(!isKind(Gusts), "gusts have none of their own");
    if (key == "referenceHeight")
        return unless(!isKind(Uniform, Jet), "this wind does not depend on the height");
    if (key == "exponent")
        return unless(isKind(PowerLaw), "only the power law has one");
    if (key == "roughness")
        return unless(isKind(LogLaw), "only the logarithmic law has one");
    if (key == "gustiness" || key == "seed")
        return unless(isKind(Gusts), "only gusts have it");
    if (key == "position" || key == "radius" || key == "spread")
        return unless(isKind(Jet), "only jets have it");
    return used;
}

Reason idle(const Link& link, std::string_view key, const Around& around)
{
    if (key == "stiffness" || key == "damping")
        return unless(link.kind == LinkKind::Spring, "the link is a rod, which has a compliance");
    if (key == "width")
        return unless(link.role != LinkRole::Line, "a line has none");
    if (key == "compliance") {
        if (link.kind != LinkKind::Rod)
            return "the link is a spring, which has a stiffness";
        return unless(around.scene.settings.solver != Solver::PaperJacobi,
                      "the paper's solver takes every rod as stiff");
    }
    if (key == "tearLimit") {
        const Material* material = findItem<Material>(around.scene, link.material);
        return unless(material && material->tearRule != TearRule::Never,
                      "its material never tears");
    }
    return used;
}

Reason idleStrength(const Material& material, std::string_view key, const Use& use,
                    const Settings& settings)
{
    const auto physical = [&] {
        return (material.axialStiffness ? use.lines : 0)
               + (material.membraneStiffness ? use.threads : 0)
               + (material.shearStiffness ? use.biases : 0);
    };
    if (key == "stiffness" || key == "damping") {
        if (use.springs == 0)
            return use.rods > 0 ? "its links are all rods, which take the compliance"
                                : "no link is made of it";
        const std::size_t own = key == "stiffness" ? use.ownStiffness : use.ownDamping;
        if (own == use.springs)
            return "each of its springs has its own";
        return unless(key == "damping" || physical() < use.links(),
                      "its axial, membrane or shear stiffness counts instead");
    }
    if (key == "compliance") {
        if (use.rods == 0)
            return use.springs > 0 ? "its links are all springs, which take the stiffness"
                                   : "no link is made of it";
        if (settings.solver == Solver::PaperJacobi)
            return "the paper's solver takes every rod as stiff";
        if (use.ownCompliance == use.rods)
            return "each of its rods has its own";
        return unless(physical() < use.links(),
                      "its axial, membrane or shear stiffness counts instead");
    }
    if (settings.solver == Solver::PaperJacobi && use.springs == 0 && use.rods > 0
        && (key == "axialStiffness" || key == "membraneStiffness" || key == "shearStiffness"))
        return "the paper's solver takes every rod as stiff";
    if (key == "axialStiffness")
        return unless(use.lines > 0, "no link of it has the role line");
    if (key == "membraneStiffness")
        return unless(use.threads > 0, "no link of it is a thread with a width");
    if (key == "shearStiffness")
        return unless(use.biases > 0, "no link of it is a bias with a width");
    if (key == "flexuralRigidity")
        return unless(use.lines > 0, "no link of it has the role line");
    if (key == "bendingStiffness")
        return unless(use.panels > 0, "no panel is made of it");
    return used;
}

Reason idle(const Material& material, std::string_view key, const Around& around)
{
    const auto found = around.usage.ofMaterial.find(around.id);
    const Use use = found == around.usage.ofMaterial.end() ? Use() : found->second;
    const Settings& settings = around.scene.settings;
    const auto isLaw = [&](auto... laws) { return ((material.airLaw == laws) || ...); };
    if (key == "tearLimit") {
        if (material.tearRule == TearRule::Never)
            return "the material never tears; choose what it tears by";
        return unless(use.ownTearLimit < use.links(), "each of its links has its own");
    }
    if (key == "tearRule")
        return unless(use.links() > 0, "no link is made of it");
    if (key == "diameter" || key == "dragCoefficient") {
        if (key == "dragCoefficient" && material.diameter == 0.0)
            return "the line diameter is 0";
        return unless(use.links() > 0, "no link is made of it");
    }
    constexpr std::array<std::string_view, 7> ofAir{
        "airLaw",       "normalCoefficient", "broadsideCoefficient", "stallAngle", "polar",
        "skinFriction", "porosity"};
    if (std::ranges::find(ofAir, key) == ofAir.end())
        return idleStrength(material, key, use, settings);

    if ((key == "normalCoefficient" && !isLaw(AirLaw::Paper, AirLaw::LinearNormal, AirLaw::Vortex))
        || (key == "broadsideCoefficient" && !isLaw(AirLaw::LinearNormal, AirLaw::Vortex))
        || (key == "stallAngle" && !isLaw(AirLaw::Vortex))
        || (key == "polar" && !isLaw(AirLaw::LiftDrag))
        || (key == "skinFriction" && isLaw(AirLaw::None))
        || (key == "porosity" && isLaw(AirLaw::None, AirLaw::Vortex)))
        return "the air law does not ask for it";
    if (use.panels == 0)
        return "no panel is made of it";
    return unless(settings.airDensity > 0.0, "the air density is 0");
}

Reason idle(const Probe& probe, std::string_view key, const Around&)
{
    const QuantityRow& row = rowOf(probe.quantity);
    if (key == "from")
        return unless(row.points >= 2, "the quantity is not measured from somewhere");
    if (key == "side")
        return unless(row.points >= 3, "only roll and angle of attack need a third particle");
    if (key == "formula")
        return unless(row.of == QuantityRow::Of::Probes,
                      "the quantity is measured, not made of others");
    if (key == "target")
        return unless(row.of != QuantityRow::Of::Whole && row.of != QuantityRow::Of::Probes,
                      "the quantity is that of the whole scene");
    return used;
}

Reason idle(const Plot& plot, std::string_view key, const Around&)
{
    if (key == "against")
        return unless(plot.axis == PlotAxis::Probe, "the curves are not against a probe");
    if (key == "seconds")
        return unless(plot.axis == PlotAxis::Time, "the curves are not against time");
    return used;
}

Reason idle(const Particle& particle, std::string_view key, const Around&)
{
    if (key == "mass" || key == "velocity")
        return unless(!particle.pinned, "the particle is pinned");
    if (key == "guide" || key == "guideAxis") {
        if (particle.pinned)
            return "the particle is pinned";
        return unless(key == "guide" || particle.guide != Guide::None, "it has no guide");
    }
    return used;
}

Reason idle(const Panel&, std::string_view, const Around&) { return used; }
Reason idle(const Group&, std::string_view, const Around&) { return used; }
Reason idle(const Control&, std::string_view, const Around&) { return used; }

void count(const Link& link, Use& use)
{
    const bool isRod = link.kind == LinkKind::Rod;
    ++(isRod ? use.rods : use.springs);
    use.ownStiffness += !isRod && link.stiffness;
    use.ownDamping += !isRod && link.damping;
    use.ownCompliance += isRod && link.compliance;
    use.ownTearLimit += link.tearLimit.has_value();
    use.lines += link.role == LinkRole::Line;
    use.threads += link.role == LinkRole::Thread && link.width > 0.0;
    use.biases += link.role == LinkRole::Bias && link.width > 0.0;
}

} // namespace

Usage usageOf(const Scene& scene)
{
    Usage usage;
    forEachPart(scene, [&](Id, const Part& part) {
        Id last = noId; // neighbours share their material
        Use* use = &usage.ofMaterial[noId];
        const auto at = [&](Id material) -> Use& {
            if (material != last)
                use = &usage.ofMaterial[last = material];
            return *use;
        };
        for (const Link& link : part.links) {
            count(link, at(link.material));
            count(link, usage.ofAll);
        }
        for (const Panel& panel : part.panels)
            ++at(panel.material).panels;
        usage.ofAll.panels += part.panels.size();
    });
    return usage;
}

bool changesUsage(const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [](const Change& change) {
        const auto* values = std::get_if<SetValues>(&change);
        if (!values)
            return true;
        const Property& property = *values->property;
        return (property.kind == Kind::Link && property.key != "restLength"
                && property.key != "resists")
               || (property.kind == Kind::Panel && property.key == "material");
    });
}

std::optional<std::string> whyIdle(const Scene& scene, const Usage& usage, const Property& property,
                                   Id id)
{
    const auto ref = find(scene, id);
    if (!ref)
        return std::nullopt;
    return std::visit(
        [&](const auto* thing) {
            return idle(*thing, property.key, Around{scene, usage, id});
        },
        *ref);
}

} // namespace ripstop
