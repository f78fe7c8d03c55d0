#include "derived/gust_now.h"

#include "laws/gust_train.h"

#include <algorithm>

namespace ripstop {

std::optional<GustNow> gustNow(const Scene& scene, double time)
{
    constexpr double mostCounted = 1e9;
    std::optional<GustNow> strongest;
    for (const Entry& entry : scene.items) {
        const Wind* const wind = std::get_if<Wind>(&entry.item);
        const auto now =
            wind && wind->kind == WindKind::DiscreteGust ? gustAt(*wind, time) : std::nullopt;
        if (!now)
            continue;
        const double peak = now->strength * wind->velocity.norm();
        if (!strongest || peak > strongest->peak)
            strongest = {entry.id, int(std::min(now->before, mostCounted)) + 1,
                         wind->interval > 0.0, peak};
    }
    return strongest;
}

} // namespace ripstop
