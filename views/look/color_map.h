// Colours for values, even to the eye: equal steps of the value look like equal steps of colour.
//
// They are made in the OKLab space (Ottosson 2020), where lightness and hue are what we see. The
// sequential map climbs evenly in lightness from violet over teal to yellow, so it reads in grey as
// well; the diverging map is blue below zero, pale at zero and red above.
#pragma once

#include "look/look.h"
#include "look/steady_range.h"

namespace ripstop {

class ColorMap
{
public:
    static constexpr int steps = 256;

    static const ColorMap& sequential();
    static const ColorMap& diverging();

    Color at(double share) const; // 0 .. 1, clamped; NaN is grey
    Color at(double value, const ValueRange& range) const
    {
        return at((value - range.low) / (range.high - range.low));
    }

private:
    ColorMap() = default;
    std::array<Color, steps> m_colors{};
};

} // namespace ripstop
