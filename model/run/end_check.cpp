#include "run/end_check.h"

#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <cmath>

namespace ripstop {
namespace {

template <typename Values, typename SizeOf>
std::size_t worstOf(const Values& values, const SizeOf& sizeOf)
{
    std::size_t worst = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(sizeOf(values[i]) <= sizeOf(values[worst])))
            worst = i;
    return worst;
}

} // namespace

std::vector<Message> absurdities(const Simulation& simulation)
{
    std::vector<Message> found;
    const std::shared_ptr<const Frame> frame = simulation.frame();
    const Layout& layout = *frame->layout;

    const auto& strain = frame->strain;
    const std::size_t link = worstOf(strain, [](double one) { return one; });
    if (!strain.empty() && !(strain[link] <= absurdStrain))
        found.push_back(
            Message("The strain of link %1 is %2 at the end, and no material bears %3: look "
                    "for what pulls it out of its place, like a collider that it is in.",
                    layout.links[link].id, Message::number("%.3g", strain[link]),
                    Message::number("%.3g", absurdStrain)));
    const double panels = largestPanelStrain(simulation.system(), simulation.state());
    if (!(panels <= absurdStrain))
        found.push_back(
            Message("The largest strain of a panel is %1 at the end, and no material bears "
                    "%2: look for what pulls it out of its place.",
                    Message::number("%.3g", panels), Message::number("%.3g", absurdStrain)));

    const auto distance = [](const Vec3& place) { return place.norm(); };
    const std::size_t far = worstOf(frame->position, distance);
    if (!frame->position.empty() && !(distance(frame->position[far]) <= absurdPlace))
        found.push_back(
            Message("Particle %1 is %2 m away from the origin at the end, farther than %3 m, "
                    "where weight would be another one: look for what drives it away.",
                    layout.particleId[far], Message::number("%.3g", distance(frame->position[far])),
                    Message::number("%.3g", absurdPlace)));

    const Energies energy = energies(simulation.system(), simulation.state());
    if (!std::isfinite(energy.total()))
        found.push_back(
            Message("The energies are not finite at the end: look for stiffnesses and masses "
                    "that are far too large."));
    return found;
}

} // namespace ripstop
