// The second half of the property table: what a change of each property does, and when its value
// counts. The first half, what the property is, stands in property.cpp, which is all that includes
// this; everybody else reads the rows in property.h.
//
// Columns of a row:
//   meaning  what the value stands for, beyond its type
//   traits   what a change touches beside the number: structure, looks, counts; or that the value
//            is the thing's own, without a default worth going back to
//   usual    the slider that a form shows without being asked; none for what is seldom tuned
//   needs    the conditions under which the value does something, each with the half sentence that
//            a form shows where it does not hold; the first that fails speaks. Empty for what
//            always counts, so that whoever adds a property has to think of it.
#pragma once

#include "base/quantity.h"
#include "scene/usage.h"
#include "shapes/solid.h"

#include <algorithm>
#include <type_traits>

namespace ripstop {

namespace uses {

// --- conditions ----------------------------------------------------------------------------------

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
inline constexpr Need someRod = need([](const Around& a) { return a.all.rods > 0; }, "no link is a rod, and springs need no solver");
inline constexpr Need aimsAtStrain = need([](const Settings& s, const Around&) { return s.solver == Solver::Auto; }, "only the automatic solver aims at a strain");
inline constexpr Need sweeps = need([](const Settings& s, const Around&) { return s.solver != Solver::SmallSteps && s.solver != Solver::Auto; }, "this solver makes one sweep in each substep; give it more substeps");
inline constexpr Need softRods = need([](const Around& a) { return a.scene.settings.solver != Solver::PaperJacobi; }, "the paper's solver takes every rod as stiff");
inline constexpr Need someTear = need([](const Around& a) {
    return std::ranges::any_of(a.scene.items, [](const Entry& entry) {
        const Material* material = std::get_if<Material>(&entry.item);
        return material && material->tearRule != TearRule::Never;
    });
}, "no material tears");

// particles
inline constexpr Need isFree = need([](const Particle& p, const Around&) { return !p.pinned; }, "the particle is pinned");
inline constexpr Need isGuided = need([](const Particle& p, const Around&) { return p.guide != Guide::None; }, "it has no guide");

// links
inline constexpr Need isSpring = need([](const Link& l, const Around&) { return l.kind == LinkKind::Spring; }, "the link is a rod, which has a compliance");
inline constexpr Need isRod = need([](const Link& l, const Around&) { return l.kind == LinkKind::Rod; }, "the link is a spring, which has a stiffness");
inline constexpr Need isNoLine = need([](const Link& l, const Around&) { return l.role != LinkRole::Line; }, "a line has none");
inline constexpr Need canTear = need([](const Link& l, const Around& a) {
    const Material* material = findItem<Material>(a.scene, l.material);
    return material && material->tearRule != TearRule::Never;
}, "its material never tears");

// parts
inline constexpr Need touchesItself = need([](const Part& p, const Around&) { return p.selfContact > 0.0; }, "the part has no self-contact");
inline constexpr Need holdsAir = need([](const Part& p, const Around&) { return p.canopyPressure > 0.0; }, "the part has no canopy pressure");

// materials: what is made of them
inline constexpr Need ofLinks = need([](const Around& a) { return a.made.links() > 0; }, "no link is made of it");
inline constexpr Need ofPanels = need([](const Around& a) { return a.made.panels > 0; }, "no panel is made of it");
inline constexpr Need ofSprings = need([](const Around& a) { return a.made.springs > 0; }, "its links are all rods, which take the compliance");
inline constexpr Need ofRods = need([](const Around& a) { return a.made.rods > 0; }, "its links are all springs, which take the stiffness");
inline constexpr Need ofLines = need([](const Around& a) { return a.made.lines > 0; }, "no link of it has the role line");
inline constexpr Need ofThreads = need([](const Around& a) { return a.made.threads > 0; }, "no link of it is a thread with a width");
inline constexpr Need ofBiases = need([](const Around& a) { return a.made.biases > 0; }, "no link of it is a bias with a width");
inline constexpr Need notOnlyStiffRods = need([](const Around& a) {
    return a.scene.settings.solver != Solver::PaperJacobi || a.made.springs > 0 || a.made.rods == 0;
}, softRods.otherwise);

// materials: who asks them
inline constexpr Need givesStiffness = need([](const Around& a) { return a.made.ownStiffness < a.made.springs; }, "each of its springs has its own");
inline constexpr Need givesDamping = need([](const Around& a) { return a.made.ownDamping < a.made.springs; }, "each of its springs has its own");
inline constexpr Need givesCompliance = need([](const Around& a) { return a.made.ownCompliance < a.made.rods; }, "each of its rods has its own");
inline constexpr Need isAbstract = need([](const Material& m, const Around& a) {
    const std::size_t physical = (m.axialStiffness ? a.made.lines : 0) + (m.membraneStiffness ? a.made.threads : 0)
                                 + (m.shearStiffness ? a.made.biases : 0);
    return physical < a.made.links();
}, "its axial, membrane or shear stiffness counts instead");
inline constexpr Need tears = need([](const Material& m, const Around&) { return m.tearRule != TearRule::Never; }, "the material never tears; choose what it tears by");
inline constexpr Need givesTearLimit = need([](const Around& a) { return a.made.ownTearLimit < a.made.links(); }, "each of its links has its own");
inline constexpr Need hasDiameter = need([](const Material& m, const Around&) { return m.diameter != 0.0; }, "the line diameter is 0");

// air and wind
inline constexpr Need inAir = need([](const Around& a) { return a.scene.settings.airDensity > 0.0; }, "the air density is 0");
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
inline constexpr Need isNoGust = need([](const Wind& w, const Around&) { return w.kind != WindKind::Gusts; }, "gusts have none of their own");
inline constexpr Need hasHeight = need([](const Wind& w, const Around&) { return w.kind != WindKind::Uniform && w.kind != WindKind::Jet; }, "this wind does not depend on the height");
inline constexpr Need isPowerLaw = wind<WindKind::PowerLaw>("only the power law has one");
inline constexpr Need isLogLaw = wind<WindKind::LogLaw>("only the logarithmic law has one");
inline constexpr Need isGusts = wind<WindKind::Gusts>("only gusts have it");
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

// --- rows ----------------------------------------------------------------------------------------

using enum Meaning;
using enum Trait;

constexpr SliderRange even(double low, double high) { return {low, high, false}; }
constexpr SliderRange decades(double low, double high) { return {low, high, true}; }

template <auto member>
consteval PropertyUse use(Meaning meaning, Traits traits, std::optional<SliderRange> usual,
                          NeedList needs)
{
    for (const Need& need : needs)
        if (need.kind.value_or(memberPlace<member>.kind) != memberPlace<member>.kind)
            throw "a condition on a thing of another kind";
    return {memberPlace<member>, meaning, traits, usual, needs};
}

// clang-format off
inline constexpr std::array table{
    //                                    meaning traits              usual                needs
    use<&Settings::title>                (Plain, {Own},               {},                  {}),
    use<&Settings::notes>                (Notes, {Own},               {},                  {}),
    use<&Settings::timeStep>             (Plain, {},                  {},                  {}),
    use<&Settings::substeps>             (Plain, {},                  decades(1.0, 64.0),  {}),
    use<&Settings::sweeps>               (Plain, {},                  decades(1.0, 256.0), {sweeps, someRod}),
    use<&Settings::integrator>           (Plain, {},                  {},                  {}),
    use<&Settings::solver>               (Plain, {},                  {},                  {someRod}),
    use<&Settings::strainGoal>           (Plain, {},                  {},                  {aimsAtStrain, someRod}),
    use<&Settings::tearsPerStep>         (Plain, {},                  {},                  {someTear}),
    use<&Settings::tearMesh>             (Plain, {},                  {},                  {someTear}),
    use<&Settings::gravity>              (Plain, {},                  {},                  {}),
    use<&Settings::airDensity>           (Plain, {},                  even(0.0, 2.0),      {someCloth}),
    use<&Settings::viscosity>            (Plain, {},                  even(0.0, 5.0),      {}),
    use<&Settings::speedLimit>           (Plain, {},                  {},                  {}),

    use<&Particle::position>             (Plain, {Own},               {},                  {}),
    use<&Particle::velocity>             (Plain, {},                  {},                  {isFree}),
    use<&Particle::mass>                 (Plain, {},                  {},                  {isFree}),
    use<&Particle::pinned>               (Plain, {},                  {},                  {}),
    use<&Particle::guide>                (Plain, {},                  {},                  {isFree}),
    use<&Particle::guideAxis>            (Plain, {},                  {},                  {isFree, isGuided}),
    use<&Particle::textureU>             (Plain, {},                  {},                  {}),
    use<&Particle::textureV>             (Plain, {},                  {},                  {}),

    use<&Link::from>                     (Plain, {Structure},         {},                  {}),
    use<&Link::to>                       (Plain, {Structure},         {},                  {}),
    use<&Link::material>                 (Plain, {Looks, Counts},     {},                  {}),
    use<&Link::kind>                     (Plain, {Structure, Counts}, {},                  {}),
    use<&Link::resists>                  (Plain, {},                  {},                  {}),
    use<&Link::restLength>               (Plain, {Own},               {},                  {}),
    use<&Link::role>                     (Plain, {Looks, Counts},     {},                  {}),
    use<&Link::width>                    (Plain, {Looks, Counts},     {},                  {isNoLine}),
    use<&Link::stiffness>                (Plain, {Counts},            {},                  {isSpring}),
    use<&Link::damping>                  (Plain, {Counts},            {},                  {isSpring}),
    use<&Link::compliance>               (Plain, {Counts},            {},                  {isRod, softRods}),
    use<&Link::tearLimit>                (Plain, {Looks, Counts},     {},                  {canTear}),

    use<&Panel::a>                       (Plain, {Structure},         {},                  {}),
    use<&Panel::b>                       (Plain, {Structure},         {},                  {}),
    use<&Panel::c>                       (Plain, {Structure},         {},                  {}),
    use<&Panel::material>                (Plain, {Looks, Counts},     {},                  {}),

    use<&Part::name>                     (Name,  {Own},               {},                  {}),
    use<&Part::shown>                    (Shown, {},                  {},                  {}),
    use<&Part::selfContact>              (Plain, {},                  {},                  {}),
    use<&Part::selfFriction>             (Plain, {},                  {},                  {touchesItself}),
    use<&Part::canopyPressure>           (Plain, {Structure},         {},                  {}),
    use<&Part::fillEfficiency>           (Plain, {},                  {},                  {holdsAir}),
    use<&Part::addedMass>                (Plain, {},                  {},                  {holdsAir}),
    use<&Part::massTarget>               (Plain, {},                  {},                  {}),
    use<&Part::lengthTarget>             (Plain, {},                  {},                  {}),
    use<&Part::areaTarget>               (Plain, {},                  {},                  {}),
    use<&Part::builder>                  (Plain, {Own},               {},                  {}),

    use<&Material::name>                 (Name,  {Own},               {},                  {}),
    use<&Material::color>                (Color, {},                  {},                  {}),
    use<&Material::shown>                (Shown, {},                  {},                  {}),
    use<&Material::stiffness>            (Plain, {},                  decades(1.0, 1e5),   {ofLinks, ofSprings, givesStiffness, isAbstract}),
    use<&Material::damping>              (Plain, {},                  decades(1e-3, 10.0), {ofLinks, ofSprings, givesDamping}),
    use<&Material::compliance>           (Plain, {},                  decades(1e-8, 1e-2), {ofLinks, ofRods, softRods, givesCompliance, isAbstract}),
    use<&Material::axialStiffness>       (Plain, {},                  {},                  {notOnlyStiffRods, ofLines}),
    use<&Material::membraneStiffness>    (Plain, {},                  {},                  {notOnlyStiffRods, ofThreads}),
    use<&Material::shearStiffness>       (Plain, {},                  {},                  {notOnlyStiffRods, ofBiases}),
    use<&Material::bendingStiffness>     (Plain, {},                  {},                  {ofPanels}),
    use<&Material::flexuralRigidity>     (Plain, {},                  {},                  {ofLines}),
    use<&Material::arealDensity>         (Plain, {},                  {},                  {}),
    use<&Material::linearDensity>        (Plain, {},                  {},                  {}),
    use<&Material::tearRule>             (Plain, {Looks},             {},                  {ofLinks}),
    use<&Material::tearLimit>            (Plain, {Looks},             decades(1e-2, 1e3),  {tears, givesTearLimit}),
    use<&Material::airLaw>               (Plain, {},                  {},                  {ofPanels, inAir}),
    use<&Material::normalCoefficient>    (Plain, {},                  even(0.0, 4.0),      {law<AirLaw::Paper, AirLaw::LinearNormal, AirLaw::Vortex>, ofPanels, inAir}),
    use<&Material::broadsideCoefficient> (Plain, {},                  {},                  {law<AirLaw::LinearNormal, AirLaw::Vortex>, ofPanels, inAir}),
    use<&Material::polar>                (Polar, {},                  {},                  {law<AirLaw::LiftDrag>, ofPanels, inAir}),
    use<&Material::stallAngle>           (Plain, {},                  {},                  {law<AirLaw::Vortex>, ofPanels, inAir}),
    use<&Material::skinFriction>         (Plain, {},                  even(0.0, 0.2),      {lawOtherThan<AirLaw::None>, ofPanels, inAir}),
    use<&Material::porosity>             (Plain, {},                  even(0.0, 0.2),      {lawOtherThan<AirLaw::None, AirLaw::Vortex>, ofPanels, inAir}),
    use<&Material::diameter>             (Plain, {},                  {},                  {ofLinks}),
    use<&Material::dragCoefficient>      (Plain, {},                  {},                  {hasDiameter, ofLinks}),

    use<&Group::name>                    (Name,  {Own},               {},                  {}),
    use<&Group::members>                 (Plain, {},                  {},                  {}),
    use<&Group::massTarget>              (Plain, {},                  {},                  {}),
    use<&Group::lengthTarget>            (Plain, {},                  {},                  {}),
    use<&Group::areaTarget>              (Plain, {},                  {},                  {}),

    use<&Collider::name>                 (Name,  {Own},               {},                  {}),
    use<&Collider::shape>                (Plain, {Looks},             {},                  {}),
    use<&Collider::position>             (Plain, {Looks, Own},        {},                  {hasNoPath}),
    use<&Collider::normal>               (Plain, {Looks},             {},                  {hasNormal}),
    use<&Collider::radius>               (Plain, {Looks},             {},                  {hasRadius}),
    use<&Collider::size>                 (Plain, {Looks},             {},                  {hasSize}),
    use<&Collider::turn>                 (Plain, {Looks},             {},                  {turns}),
    use<&Collider::thickness>            (Plain, {Looks},             even(0.0, 0.05),     {}),
    use<&Collider::response>             (Plain, {Looks},             {},                  {}),
    use<&Collider::restitution>          (Plain, {Looks},             even(0.0, 1.0),      {bounces}),
    use<&Collider::friction>             (Plain, {Looks},             even(0.0, 1.5),      {bounces}),
    use<&Collider::path>                 (Path,  {Looks},             {},                  {}),
    use<&Collider::file>                 (File,  {Looks},             {},                  {hasFile}),
    use<&Collider::scale>                (Plain, {Looks},             {},                  {isScaled}),
    use<&Collider::grid>                 (Plain, {Looks},             {},                  {isGenerated}),
    use<&Collider::seed>                 (Plain, {Looks},             {},                  {isGenerated}),
    use<&Collider::hillLength>           (Plain, {Looks},             decades(0.02, 2.0),  {isGenerated}),
    use<&Collider::shown>                (Shown, {},                  {},                  {}),

    use<&Wind::name>                     (Name,  {Own},               {},                  {}),
    use<&Wind::kind>                     (Plain, {Structure, Looks},  {},                  {inAir, someCloth}),
    use<&Wind::velocity>                 (Plain, {Looks},             even(0.0, 25.0),     {inAir, someCloth, isNoGust}),
    use<&Wind::referenceHeight>          (Plain, {Looks},             {},                  {inAir, someCloth, hasHeight}),
    use<&Wind::exponent>                 (Plain, {Looks},             {},                  {inAir, someCloth, isPowerLaw}),
    use<&Wind::roughness>                (Plain, {Looks},             {},                  {inAir, someCloth, isLogLaw}),
    use<&Wind::gustiness>                (Plain, {Looks},             even(0.0, 25.0),     {inAir, someCloth, isGusts}),
    use<&Wind::seed>                     (Plain, {Looks},             {},                  {inAir, someCloth, isGusts}),
    use<&Wind::position>                 (Plain, {Looks, Own},        {},                  {inAir, someCloth, isJet}),
    use<&Wind::radius>                   (Plain, {Looks},             {},                  {inAir, someCloth, isJet}),
    use<&Wind::spread>                   (Plain, {Looks},             {},                  {inAir, someCloth, isJet}),

    use<&Control::name>                  (Name,  {Own},               {},                  {}),
    use<&Control::kind>                  (Plain, {},                  {},                  {}),
    use<&Control::targets>               (Plain, {},                  {},                  {}),
    use<&Control::axis>                  (Plain, {},                  {},                  {}),
    use<&Control::keyLess>               (Keys,  {},                  {},                  {}),
    use<&Control::keyMore>               (Keys,  {},                  {},                  {}),
    use<&Control::step>                  (Plain, {},                  {},                  {}),
    use<&Control::limit>                 (Plain, {},                  {},                  {}),
    use<&Control::rate>                  (Plain, {},                  {},                  {}),
    use<&Control::automaticRate>         (Plain, {},                  {},                  {}),

    use<&Probe::name>                    (Name,  {Own},               {},                  {}),
    use<&Probe::quantity>                (Plain, {},                  {},                  {}),
    use<&Probe::target>                  (Plain, {},                  {},                  {isOfThings}),
    use<&Probe::from>                    (Plain, {},                  {},                  {hasOrigin}),
    use<&Probe::side>                    (Plain, {},                  {},                  {hasSide}),
    use<&Probe::formula>                 (Plain, {},                  {},                  {isFormula}),
    use<&Probe::plotted>                 (Plain, {},                  {},                  {}),

    use<&Plot::name>                     (Name,  {Own},               {},                  {}),
    use<&Plot::axis>                     (Plain, {},                  {},                  {}),
    use<&Plot::against>                  (Plain, {},                  {},                  {isAgainstProbe}),
    use<&Plot::probes>                   (Plain, {},                  {},                  {}),
    use<&Plot::seconds>                  (Plain, {},                  {},                  {isAgainstTime}),
    use<&Plot::logarithmic>              (Plain, {},                  {},                  {}),
    use<&Plot::low>                      (Plain, {},                  {},                  {}),
    use<&Plot::high>                     (Plain, {},                  {},                  {}),
};
// clang-format on

} // namespace uses

inline constexpr const auto& propertyUses = uses::table;

} // namespace ripstop
