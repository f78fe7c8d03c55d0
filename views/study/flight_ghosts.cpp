// Side by side they stand in their order on both sides of the current one, in steps that are wider
// than the widest of them where they begin.
#include "study/flight_ghosts.h"

#include "study/flight_curves.h"

#include <algorithm>

namespace ripstop {
namespace {

// From one flight to the next one beside it: along the level axis along which it is narrower.
Vec3 sideStep(const Recording& recording)
{
    const auto frame = recording.frame(0);
    if (!frame || (*frame)->position.empty())
        return {0.0, 0.0, 0.0};
    Vec3 least = (*frame)->position.front();
    Vec3 most = least;
    for (const Vec3& position : (*frame)->position) {
        least = least.cwiseMin(position);
        most = most.cwiseMax(position);
    }
    const Vec3 size = most - least;
    constexpr double room = 1.4;                 // of the width, from middle to middle
    const double thickness = 0.05 * size.norm(); // of what has none, as a pendulum
    return size.z() <= size.x() ? Vec3(0.0, 0.0, room * std::max(size.z(), thickness))
                                : Vec3(room * std::max(size.x(), thickness), 0.0, 0.0);
}

} // namespace

std::vector<Recordings::Ghost> ghostsOf(const FlightCurves& compared,
                                        const std::shared_ptr<Recording>& current)
{
    std::vector<Recordings::Ghost> ghosts;
    if (compared.ghosts() == FlightCurves::Ghosts::None)
        return ghosts;
    Vec3 step(0.0, 0.0, 0.0);
    if (compared.ghosts() == FlightCurves::Ghosts::Beside)
        for (const FlightCurve& one : compared.curves())
            step = step.cwiseMax(sideStep(*one.flight->recording));
    const auto isCurrent = [&](const FlightCurve& one) { return one.flight->recording == current; };
    const auto middle = std::ranges::find_if(compared.curves(), isCurrent);
    const auto first =
        middle == compared.curves().end() ? std::ptrdiff_t(-1) : middle - compared.curves().begin();
    for (std::size_t i = 0; i < compared.curves().size(); ++i)
        if (!isCurrent(compared.curves()[i])) {
            const double steps = double(std::ptrdiff_t(i) - first);
            ghosts.push_back({compared.curves()[i].flight->recording, Vec3(steps * step),
                              compared.colorOf(i).rgb()});
        }
    return ghosts;
}

} // namespace ripstop
