// What probes can measure.
#pragma once

#include "base/laws.h"

#include <string_view>

namespace ripstop {

struct QuantityRow
{
    enum class Of { Particles, Links, Panels, Canopy, Whole, Probes };

    Quantity quantity;
    std::string_view unit; // "m", "deg", "N", ...; empty when dimensionless. Angles are in degrees,
                           // because that is how fliers speak of them.
    Of of;                 // what of its target is measured
    int points;            // that it takes: 1 the target, 2 with `from`, 3 with `side`
    std::string_view help; // one sentence
};

const QuantityRow& rowOf(Quantity quantity);

std::string_view unitOf(Quantity quantity);

} // namespace ripstop
