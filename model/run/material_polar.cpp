#include "run/material_polar.h"

#include "compile/resolve.h"

namespace ripstop {

std::vector<PolarRow> platePolar(const Material& material, double step)
{
    return platePolar(airOf(Id{1}, material), step); // the polar is the same for any id
}

} // namespace ripstop
