// plainTearOf() turns the rule of a material into that of one link; joints and factors come on top.
// Then what asks for it: a link at a length, panels, and spars.
#include "derived/tear_bounds.h"

#include "derived/link_stiffness.h"

namespace ripstop {
namespace {

TearLimit never(std::optional<double> own) { return {TearRule::Never, own.value_or(0.0)}; }

double joined(const Material& material, double strength)
{
    return shareLeftByJoints(material) * strength;
}

// As the material has it.
TearLimit plainTearOf(const Material& material, LinkRole role, double width,
                      std::optional<double> own)
{
    switch (material.tearRule) {
    case TearRule::Never:
    case TearRule::Length:
    case TearRule::Strain:
    case TearRule::Force:
        return {material.tearRule, own.value_or(material.tearLimit)};
    case TearRule::Tension:
        if (!own && (role != LinkRole::Thread || !(width > 0.0)))
            return never(own);
        return {TearRule::Force, own.value_or(material.tearLimit * width)};
    case TearRule::Strength:
    case TearRule::Energy:
        if (!own && (role != LinkRole::Line || !material.lineStrength))
            return never(own);
        return {TearRule::Force, own ? *own : joined(material, *material.lineStrength)};
    }
    return never(own);
}

} // namespace

double shareLeftByJoints(const Material& material)
{
    return material.jointEfficiency.value_or(1.0);
}

TearLimit linkTearOf(const Material& material, LinkRole role, double width,
                     std::optional<double> own, double factor)
{
    const TearLimit tear = plainTearOf(material, role, width, own);
    return own ? tear : timesStrength(tear, factor);
}

bool isBeyondLimit(const Material& material, const Link& link, double length)
{
    const double longer = length - link.restLength;
    const TearLimit tear =
        linkTearOf(material, link.role, link.width, link.tearLimit, link.strengthFactor);
    switch (tear.rule) {
    case TearRule::Length:
        return length > tear.limit;
    case TearRule::Strain:
        return longer > tear.limit * link.restLength;
    case TearRule::Force: {
        if (link.kind == LinkKind::Spring)
            return longer * link.stiffness.value_or(springStiffness(material, link)) > tear.limit;
        const double compliance = link.compliance.value_or(rodCompliance(material, link));
        return compliance > 0.0 && longer > tear.limit * compliance;
    }
    default:
        return false;
    }
}

FabricTear fabricTearOf(const Material& material)
{
    constexpr double unbreakable = FabricTear::unbreakable;
    switch (material.tearRule) {
    case TearRule::Strain:
    case TearRule::Tension:
        return {material.tearRule, material.tearLimit, material.tearLimit};
    case TearRule::Strength:
    case TearRule::Energy: {
        const double energy = material.tearRule == TearRule::Energy ? tearEnergyOf(material) : 0.0;
        if (!material.warpStrength && !material.weftStrength && !(energy > 0.0))
            return {};
        return {TearRule::Tension, joined(material, material.warpStrength.value_or(unbreakable)),
                joined(material, material.weftStrength.value_or(unbreakable)), energy};
    }
    case TearRule::Never:
    case TearRule::Length:
    case TearRule::Force:
        break;
    }
    return {};
}

double tearEnergyOf(const Material& material) { return 2.0 * material.tearStrength.value_or(0.0); }

double snapMomentOf(const Material& material)
{
    return isByStrength(material.tearRule) ? joined(material, material.breakingMoment.value_or(0.0))
                                           : 0.0;
}

} // namespace ripstop
