// What a link is, which loads it bears, and when and how it tears. The scene says it for each link
// or material; forces, constraints and tearing obey it.
#pragma once

#include "base/choice_names.h"

#include <cstdint>

namespace ripstop {

enum class LinkKind : std::uint8_t { Spring, Rod }; // a force, a constraint
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<LinkKind>{"spring", "rod"};

enum class LinkRole : std::uint8_t {
    Line,   // a link by itself
    Thread, // of a woven fabric, along its threads
    Bias    // of a woven fabric, across its cells
};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<LinkRole>{"line", "thread", "bias"};

enum class Resists : std::uint8_t { Both, Tension, Compression }; // a batten, a line, a strut
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<Resists>{"both", "tension",
                                                                      "compression"};

// Whether a link that resists so gives no force at this stretch, m.
constexpr bool isSlack(Resists resists, double stretch)
{
    return (resists == Resists::Tension && stretch < 0.0)
           || (resists == Resists::Compression && stretch > 0.0);
}

// Tension is per width of fabric, N/m; Strength takes its limits from the strengths of the
// material; Energy does too, and where fabric has a notch or has torn already, a tear goes on when
// that lets go of more energy than the tear strength says.
enum class TearRule { Never, Length, Strain, Force, Tension, Strength, Energy };
template <>
inline constexpr std::array<std::string_view, 7> choiceNames<TearRule>{
    "never", "length", "strain", "force", "tension", "strength", "energy"};

constexpr bool isByStrength(TearRule rule)
{
    return rule == TearRule::Strength || rule == TearRule::Energy;
}

enum class TearMesh { Vanish, Split }; // what panels do beside a link that tears
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<TearMesh>{"vanish", "split"};

} // namespace ripstop
