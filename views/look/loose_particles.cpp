#include "look/loose_particles.h"

namespace ripstop {

std::vector<std::uint8_t> looseParticles(const Frame& frame)
{
    const Layout& layout = *frame.layout;
    std::vector<std::uint8_t> loose(layout.particleId.size(), 1);
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!frame.torn[i])
            loose[std::size_t(layout.links[i].a)] = loose[std::size_t(layout.links[i].b)] = 0;
    for (std::size_t i = 0; i < layout.panelCorners.size(); ++i)
        if (!frame.gone[i])
            for (const int corner : layout.panelCorners[i])
                loose[std::size_t(corner)] = 0;
    return loose;
}

} // namespace ripstop
