// Which of the discrete gusts of a scene blows at a time: so that what tears can be told with the
// gust that tore it. forces/discrete_gust.h has the formula of a gust.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace ripstop {

struct GustNow
{
    Id wind;
    int number;   // in its train, from 1
    bool repeats; // one of a train
    double peak;  // m/s, of this gust
};

// The strongest, where several blow at the time, s; none without any.
std::optional<GustNow> gustNow(const Scene& scene, double time);

} // namespace ripstop
