// What is still whole in a frame, for formats that leave out torn links and panels that are gone.
#pragma once

#include "simulation/frame.h"

#include <vector>

namespace ripstop {

// What is still whole in a frame, as indices into its layout.
struct Standing
{
    std::vector<std::size_t> links;
    std::vector<std::size_t> panels;
};

inline Standing standing(const Frame& frame)
{
    Standing whole;
    for (std::size_t i = 0; i < frame.layout->links.size(); ++i)
        if (!frame.torn[i])
            whole.links.push_back(i);
    for (std::size_t i = 0; i < frame.layout->panelCorners.size(); ++i)
        if (!frame.gone[i])
            whole.panels.push_back(i);
    return whole;
}

} // namespace ripstop
