// When the value of a property counts: the conditions that rows of the table of properties name
// (property.cpp, which is all that includes this), each with the half sentence that a form shows
// where it does not hold: idle::pinned.
#pragma once

#include "base/quantity.h"
#include "scene/idle_reasons.h"
#include "scene/usage.h"
#include "shapes/solid.h"

#include <algorithm>
#include <type_traits>

namespace ripstop {

namespace needs {

template <typename Condition>
struct Asked; // of a condition on a thing: its type
template <typename Condition, typename Thing_>
struct Asked<bool (Condition::*)(const Thing_&, const Circumstances&) const>
{
    using Thing = Thing_;
};

// A condition on a thing and what is around it, or only on what is around it.
template <typename Condition>
constexpr Need need(Condition, const char* otherwise)
{
    if constexpr (std::is_invocable_v<Condition, const Circumstances&>) {
        const auto holds = [](const ConstRef&, const Circumstances& around) {
            return Condition{}(around);
        };
        return {std::nullopt, holds, otherwise};
    } else {
        using Thing = typename Asked<decltype(&Condition::operator())>::Thing;
        const auto holds = [](const ConstRef& thing, const Circumstances& around) {
            return Condition{}(*std::get<const Thing*>(thing), around);
        };
        return {kindOfType<Thing>, holds, otherwise};
    }
}

using Around = Circumstances;

// clang-format off

// the solver and what it works on
inline constexpr Need someRod = need([](const Around& a) { return a.all.rods > 0; }, "no link is a rod");
inline constexpr Need someLinkOrElasticPanel = need([](const Around& a) { return a.all.links() > 0 || a.all.elasticPanels > 0; }, "there are no links, and no panel is elastic");
inline constexpr Need aimsAtStrain = need([](const Settings& s, const Around&) { return s.solver == Solver::Auto; }, idle::notAutomatic);
inline constexpr Need sweeps = need([](const Settings& s, const Around&) { return s.solver != Solver::SmallSteps && s.solver != Solver::Auto; }, "this solver makes one sweep in each substep; give it more substeps");
inline constexpr Need softRods = need([](const Around& a) { return a.scene.settings.solver != Solver::PaperJacobi; }, idle::stiffSolver);
inline constexpr Need someTear = need([](const Around& a) {
    return std::ranges::any_of(a.scene.items, [](const Entry& entry) {
        const Material* material = std::get_if<Material>(&entry.item);
        return material && material->tearRule != TearRule::Never;
    });
}, "no material tears");

// particles
inline constexpr Need isFree = need([](const Particle& p, const Around&) { return !p.pinned; }, idle::pinned);
inline constexpr Need isGuided = need([](const Particle& p, const Around&) { return p.guide != Guide::None; }, "it has no guide");

// links
inline constexpr Need isSpring = need([](const Link& l, const Around&) { return l.kind == LinkKind::Spring; }, idle::linkIsRod);
inline constexpr Need isRod = need([](const Link& l, const Around&) { return l.kind == LinkKind::Rod; }, idle::linkIsSpring);
inline constexpr Need takesStiffness = need([](const Link& l, const Around&) { return !(l.kind == LinkKind::Rod ? l.compliance : l.stiffness); }, "the link has a stiffness of its own");
inline constexpr Need isThread = need([](const Link& l, const Around&) { return l.role == LinkRole::Thread && l.width > 0.0; }, "the link is no thread with a width");
inline constexpr Need isNoLine = need([](const Link& l, const Around&) { return l.role != LinkRole::Line; }, "a line has none");
inline constexpr Need canTear = need([](const Link& l, const Around& a) {
    const Material* material = findItem<Material>(a.scene, l.material);
    return material && material->tearRule != TearRule::Never;
}, "its material never tears");

// parts
inline constexpr Need touchesItself = need([](const Part& p, const Around&) { return p.selfContact > 0.0; }, "the part has no self-contact");
inline constexpr Need hasPanels = need([](const Part& p, const Around&) { return !p.panels.empty(); }, "the part has no panels");
inline constexpr Need holdsAir = need([](const Part& p, const Around&) { return p.canopyPressure > 0.0; }, "the part has no canopy pressure");

// materials: what is made of them
inline constexpr Need ofLinks = need([](const Around& a) { return a.made.links() > 0; }, "no link is made of it");
inline constexpr Need ofWhatTears = need([](const Around& a) { return a.made.links() > 0 || a.made.elasticPanels > 0; }, "no link is made of it, and no panel of it carries the pull of a fabric");
inline constexpr Need ofPanels = need([](const Around& a) { return a.made.panels > 0; }, "no panel is made of it");
inline constexpr Need ofSprings = need([](const Around& a) { return a.made.springs > 0; }, idle::onlyRods);
inline constexpr Need ofRods = need([](const Around& a) { return a.made.rods > 0; }, idle::onlySprings);
inline constexpr Need ofCloth = need([](const Around& a) { return a.made.panels > 0 || a.made.links() > a.made.lines; }, "no panel is made of it, and its links are all lines");
inline constexpr Need ofLines = need([](const Around& a) { return a.made.lines > 0; }, "no link of it has the role line");
inline constexpr Need bends = need([](const Around& a) { return a.made.held < a.made.links(); }, idle::heldInShape);
inline constexpr Need ofFabric = need([](const Around& a) { return a.made.threads > 0 || a.made.elasticPanels > 0; }, idle::noThread);
inline constexpr Need ofShearingFabric = need([](const Around& a) { return a.made.biases > 0 || a.made.elasticPanels > 0; }, idle::noBias);
inline constexpr Need ofElasticPanels = need([](const Around& a) { return a.made.elasticPanels > 0; }, idle::noElasticPanel);
inline constexpr Need ofStretching = need([](const Around& a) { return a.made.rods > 0 || a.made.elasticPanels > 0; }, "its links are all springs, which have a damping of their own");
inline constexpr Need hasMembrane = need([](const Material& m, const Around&) { return m.membraneStiffness.has_value(); }, "it has no membrane stiffness");
inline constexpr Need isElasticFabric = need([](const Around& a) { return a.all.elasticPanels > 0; }, "no part has a fabric that panels carry");
inline constexpr Need notOnlyStiffRods = need([](const Around& a) {
    return a.scene.settings.solver != Solver::PaperJacobi || a.made.springs > 0 || a.made.rods == 0 || a.made.elasticPanels > 0;
}, softRods.otherwise);

// materials: who asks them
inline constexpr Need givesStiffness = need([](const Around& a) { return a.made.ownStiffness < a.made.springs; }, idle::ownOfSprings);
inline constexpr Need givesDamping = need([](const Around& a) { return a.made.ownDamping < a.made.springs; }, idle::ownOfSprings);
inline constexpr Need givesCompliance = need([](const Around& a) { return a.made.ownCompliance < a.made.rods; }, idle::ownOfRods);
inline constexpr Need isAbstract = need([](const Material& m, const Around& a) {
    const std::size_t physical = (m.axialStiffness ? a.made.lines : 0) + (m.membraneStiffness ? a.made.threads : 0)
                                 + (m.shearStiffness ? a.made.biases : 0);
    return physical < a.made.links();
}, idle::physicalCounts);
inline constexpr Need tears = need([](const Material& m, const Around&) { return m.tearRule != TearRule::Never; }, idle::neverTears);
inline constexpr Need hasTearLimit = need([](const Material& m, const Around&) { return !isByStrength(m.tearRule); }, "its strengths are the limits");
inline constexpr Need givesTearLimit = need([](const Around& a) { return a.made.ownTearLimit < a.made.links() || a.made.elasticPanels > 0; }, idle::ownOfLinks);
inline constexpr Need hasPicture = need([](const Material& m, const Around&) { return !m.picture.empty(); }, "it has no picture");
inline constexpr Need hasDiameter = need([](const Material& m, const Around&) { return m.diameter != 0.0; }, "the line diameter is 0");

// air and wind
inline constexpr Need inAir = need([](const Around& a) { return a.scene.settings.airDensity > 0.0; }, idle::noAir);
inline constexpr Need someCloth = need([](const Around& a) { return a.all.panels > 0 || a.all.links() > 0; }, "there is nothing for the air to act on");
template <AirLaw... laws>
inline constexpr Need law = need([](const Material& m, const Around&) { return ((m.airLaw == laws) || ...); }, "the air law does not ask for it");
template <AirLaw... laws>
inline constexpr Need lawOtherThan = need([](const Material& m, const Around&) { return ((m.airLaw != laws) && ...); }, law<>.otherwise);
template <WindKind... kinds>
constexpr Need wind(const char* otherwise)
{
    return need([](const Wind& w, const Around&) { return ((w.kind == kinds) || ...); }, otherwise);
}
inline constexpr Need hasVelocity = need([](const Wind& w, const Around&) { return w.kind != WindKind::Gusts && w.kind != WindKind::Measured; }, "gusts after Dryden and measured winds have none of their own");
inline constexpr Need hasHeight = wind<WindKind::PowerLaw, WindKind::LogLaw, WindKind::Gusts>("this wind does not depend on the height");
inline constexpr Need isPowerLaw = wind<WindKind::PowerLaw>("only the power law has one");
inline constexpr Need isLogLaw = wind<WindKind::LogLaw>("only the logarithmic law has one");
inline constexpr Need isGusts = wind<WindKind::Gusts>("only gusts after Dryden have it");
inline constexpr Need isDiscreteGust = wind<WindKind::DiscreteGust>("only a discrete gust has it");
inline constexpr Need isRepeated = need([](const Wind& w, const Around&) { return w.kind == WindKind::DiscreteGust && w.interval > 0.0; }, "only a discrete gust that comes again has it");
inline constexpr Need isMeasured = wind<WindKind::Measured>("only a measured wind has them");
inline constexpr Need isJet = wind<WindKind::Jet>("only jets have it");

// colliders: the table of shapes (shapes/solid.h) knows which shape has what
template <bool ShapeUses::*use>
constexpr Need shape(const char* otherwise)
{
    return need([](const Collider& c, const Around&) { return rowOf(c.shape).uses.*use; }, otherwise);
}
inline constexpr Need hasNormal = shape<&ShapeUses::normal>("only planes have one");
inline constexpr Need hasRadius = shape<&ShapeUses::radius>("only round shapes have one");
inline constexpr Need hasSize = shape<&ShapeUses::size>("this shape has none");
inline constexpr Need turns = shape<&ShapeUses::turn>("planes and spheres do not turn");
inline constexpr Need hasFile = shape<&ShapeUses::file>("only height fields and meshes come from files");
inline constexpr Need isScaled = shape<&ShapeUses::scale>("only meshes are scaled");
inline constexpr Need isGenerated = need([](const Collider& c, const Around&) { return rowOf(c.shape).uses.hills && c.file.empty(); }, "only generated hills, a height field without a file, have it");
inline constexpr Need hasNoPath = need([](const Collider& c, const Around&) { return c.path.empty(); }, "the path says where it is");
inline constexpr Need bounces = need([](const Collider& c, const Around&) { return c.response == Response::Contact; }, "only the response contact bounces and rubs");

// probes and plots
inline constexpr Need isOfThings = need([](const Probe& p, const Around&) {
    const QuantityRow::Of of = rowOf(p.quantity).of;
    return of != QuantityRow::Of::Whole && of != QuantityRow::Of::Probes;
}, "the quantity is that of the whole scene");
inline constexpr Need hasOrigin = need([](const Probe& p, const Around&) { return rowOf(p.quantity).points >= 2; }, "the quantity is not measured from somewhere");
inline constexpr Need hasSide = need([](const Probe& p, const Around&) { return rowOf(p.quantity).points >= 3; }, "only roll and angle of attack need a third particle");
inline constexpr Need isFormula = need([](const Probe& p, const Around&) { return rowOf(p.quantity).of == QuantityRow::Of::Probes; }, "the quantity is measured, not made of others");
inline constexpr Need isAgainstProbe = need([](const Plot& p, const Around&) { return p.axis == PlotAxis::Probe; }, "the curves are not against a probe");
inline constexpr Need isAgainstTime = need([](const Plot& p, const Around&) { return p.axis == PlotAxis::Time; }, "the curves are not against time");
// clang-format on

} // namespace needs

} // namespace ripstop
