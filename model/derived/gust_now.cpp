#include "derived/gust_now.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

std::optional<GustNow> gustNow(const Scene& scene, double time)
{
    constexpr double mostCounted = 1e9;
    std::optional<GustNow> strongest;
    for (const Entry& entry : scene.items) {
        const Wind* const wind = std::get_if<Wind>(&entry.item);
        if (!wind || wind->kind != WindKind::DiscreteGust || !(time >= wind->onset))
            continue;
        const double since = time - wind->onset;
        const bool repeats = wind->interval > 0.0;
        const double before =
            repeats ? std::min(std::floor(since / wind->interval), mostCounted) : 0.0;
        const double peak = (1.0 + before * wind->growth) * wind->velocity.norm();
        if (since - before * wind->interval <= wind->duration
            && (!strongest || peak > strongest->peak))
            strongest = {entry.id, int(before) + 1, repeats, peak};
    }
    return strongest;
}

} // namespace ripstop
