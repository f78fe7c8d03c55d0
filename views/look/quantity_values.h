// The quantities that the view can be coloured by, taken from a frame.
//
// A choice (ColorBy) becomes an array of values, in SI units, for particles, links or panels;
// layers map them to colours, the legend names them, and peakOf() says where the largest one is.
// They are taken once per picture by the stage, in the thread of the window.
#pragma once

#include "look/look.h"
#include "look/steady_range.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ripstop {

enum class ColorBy {
    Material,
    Strain,
    Tension,
    Speed,
    PanelLoad,
    TearLoad,
    Stress,
    Wrinkles,
    Margin,
    Stiffness,
    Strength,
    Grain
};
// as the command line has them, in the order of the enumeration; never changed
inline constexpr std::array<std::string_view, 12> colorByNames{
    "material", "strain", "tension",          "speed",           "load", "tear", "stress",
    "wrinkles", "margin", "stiffness_factor", "strength_factor", "warp"};
inline constexpr std::size_t colorByCount = colorByNames.size();

// One quantity of one frame. Only the arrays that it has are filled; the others are empty.
struct QuantityValues
{
    std::vector<double> particle; // [particles]
    std::vector<double> link;     // [links]
    std::vector<double> panel;    // [panels]; not a number where it has none
    bool isKnown = true;          // false when nothing has what the quantity is measured by
};

// Strain (1) and tension (N) belong to links; a particle gets the largest of the links that end
// there. Strain belongs to panels besides, where those carry the pull of a fabric; panels among
// them that do not have the largest of their corners. Speed (m/s) belongs to particles. Panel load
// is per area (N/m^2), so that it does not depend on how fine the mesh is. Tear load (1) is how
// much of what it tears at a link bears; links that never tear read 0, and so do torn links and
// panels that are gone. Stress (N/m) is the tension of a thread or bias over the width of the strip
// of fabric that it stands for: the membrane force per width, as the strength of fabrics is given;
// links without a width read 0. A panel that carries the pull of a fabric has the largest principal
// tension. Wrinkles tell how such a panel lies: 0 slack, 1 wrinkled, 2 taut; others have none.
// Margin (1) is load over strength (laws/load_margin.h); what has no strength reads 0.
// Stiffness and strength (1) are the factors that elements have of their materials; a panel that
// does not carry the pull has the mean of the links at its corners. Grain (degrees, -90 to
// 90) is how far the warp of a panel that does is turned from the way that the picture on it goes
// up.
QuantityValues valuesOf(const Frame& frame, ColorBy colorBy, const Look& look);

// The largest value of a frame, and where it is.
struct Peak
{
    std::uint32_t id = 0; // of a link, panel or particle; 0 when there is none
    double value = 0.0;
};
Peak peakOf(const Frame& frame, const QuantityValues& values);

// What the range of the colours is taken from: the values of links and panels, or of particles
// where those have none.
std::vector<double> rangedValues(const QuantityValues& values);
ValueRange extentOf(const QuantityValues& values); // the smallest and the largest; zeros for none

// True for quantities that are names rather than numbers: their colours have a fixed range and no
// peak.
constexpr bool isState(ColorBy colorBy) { return colorBy == ColorBy::Wrinkles; }
constexpr double highestState = 2.0;
constexpr double farthestGrain = 90.0; // degrees, either way

// True for quantities whose values mean something else below zero than above: pressed or pulled.
constexpr bool isSigned(ColorBy colorBy)
{
    return colorBy == ColorBy::Strain || colorBy == ColorBy::Tension || colorBy == ColorBy::Stress;
}

} // namespace ripstop
