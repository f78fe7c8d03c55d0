#include "derived/link_stiffness.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// N/m, c of the header.
double alongOrAcross(double whole, double shear)
{
    return 0.5 * (whole + std::sqrt(whole * whole + 4.0 * shear * shear));
}

// N/m, Y of the header; what is left where the diagonals alone are too stiff keeps a link a link.
double threadStiffness(double whole, double shear, double aspect)
{
    constexpr double least = 1e-3; // of what it is along square cells
    const double c = alongOrAcross(whole, shear);
    return std::max(c - shear * aspect * aspect, least * (c - shear));
}

// N: tension per strain of the link; nothing when the material does not say.
std::optional<double> tensionPerStrain(const Material& material, const FabricStrip& strip)
{
    if (strip.role == LinkRole::Line)
        return material.axialStiffness;
    if (strip.width == 0.0)
        return std::nullopt;
    const double shear = material.shearStiffness.value_or(0.0);
    if (strip.role == LinkRole::Bias)
        return material.shearStiffness ? std::optional(shear * strip.width) : std::nullopt;
    if (!material.membraneStiffness)
        return std::nullopt;
    return threadStiffness(*material.membraneStiffness, shear, strip.cellAspect) * strip.width;
}

} // namespace

FabricStrip stripOf(const Link& link) { return {link.role, link.width, link.cellAspect}; }

double springStiffness(const Material& material, const FabricStrip& strip, double restLength)
{
    const auto tension = tensionPerStrain(material, strip);
    // a spring without length has no strain
    return tension && restLength > 0.0 ? *tension / restLength : material.stiffness;
}

double rodCompliance(const Material& material, const FabricStrip& strip, double restLength)
{
    const auto tension = tensionPerStrain(material, strip);
    return tension && restLength > 0.0 ? restLength / *tension : material.compliance;
}

double springStiffness(const Material& material, const Link& link)
{
    return link.stiffnessFactor * springStiffness(material, stripOf(link), link.restLength);
}

double rodCompliance(const Material& material, const Link& link)
{
    return rodCompliance(material, stripOf(link), link.restLength) / link.stiffnessFactor;
}

double aspectOfCells(double along, double across)
{
    constexpr double rounding = 1e-9;
    const double aspect = along / across;
    const bool isThere = aspect > 0.0 && std::isfinite(aspect);
    return isThere && std::abs(aspect - 1.0) >= rounding ? aspect : 1.0;
}

std::optional<double> fabricModulus(const Material& material, double cellAspect)
{
    if (!material.membraneStiffness)
        return std::nullopt;
    const double shear = material.shearStiffness.value_or(0.0);
    const double square = cellAspect * cellAspect;
    const double whole = *material.membraneStiffness;
    const double along = threadStiffness(whole, shear, cellAspect) + shear * square;
    const double across = threadStiffness(whole, shear, 1.0 / cellAspect) + shear / square;
    return along - shear * shear / across;
}

double biasWidth(double p, double q)
{
    const double diagonal = std::sqrt(p * p + q * q);
    return diagonal * diagonal * diagonal / (2.0 * p * q);
}

} // namespace ripstop
