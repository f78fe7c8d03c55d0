#include "derived/link_thickness.h"

#include <cmath>
#include <numbers>

namespace ripstop {

double linkThickness(const Material& material)
{
    constexpr double solidDensity = 1400.0; // kg/m^3, of polyester and of carbon in resin
    if (material.diameter > 0.0)
        return material.diameter;
    if (material.flexuralRigidity > 0.0 && material.axialStiffness.value_or(0.0) > 0.0)
        return std::sqrt(8.0 * material.flexuralRigidity / *material.axialStiffness);
    return std::sqrt(4.0 * material.linearDensity.value_or(0.0)
                     / (std::numbers::pi * solidDensity));
}

} // namespace ripstop
