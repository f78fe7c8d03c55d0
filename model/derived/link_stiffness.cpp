#include "derived/link_stiffness.h"

#include <cmath>

namespace ripstop {
namespace {

// N: tension per strain of the link; nothing when the material does not say.
std::optional<double> tensionPerStrain(const Material& material, LinkRole role, double width)
{
    if (role == LinkRole::Line)
        return material.axialStiffness;
    if (width == 0.0)
        return std::nullopt;
    const double shear = material.shearStiffness.value_or(0.0);
    if (role == LinkRole::Bias)
        return material.shearStiffness ? std::optional(shear * width) : std::nullopt;
    if (!material.membraneStiffness)
        return std::nullopt;
    const double whole = *material.membraneStiffness;
    return (0.5 * (whole + std::sqrt(whole * whole + 4.0 * shear * shear)) - shear) * width;
}

} // namespace

double springStiffness(const Material& material, LinkRole role, double width, double restLength)
{
    const auto tension = tensionPerStrain(material, role, width);
    // a spring without length has no strain
    return tension && restLength > 0.0 ? *tension / restLength : material.stiffness;
}

double rodCompliance(const Material& material, LinkRole role, double width, double restLength)
{
    const auto tension = tensionPerStrain(material, role, width);
    return tension && restLength > 0.0 ? restLength / *tension : material.compliance;
}

double springStiffness(const Material& material, const Link& link)
{
    return link.stiffnessFactor * springStiffness(material, link.role, link.width, link.restLength);
}

double rodCompliance(const Material& material, const Link& link)
{
    return rodCompliance(material, link.role, link.width, link.restLength) / link.stiffnessFactor;
}

double biasWidth(double p, double q)
{
    const double diagonal = std::sqrt(p * p + q * q);
    return diagonal * diagonal * diagonal / (2.0 * p * q);
}

} // namespace ripstop
