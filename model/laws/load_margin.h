// What a place of a design bears, and what it could bear. The margin is one over the other:
//
//     margin = load / strength,   strength = that of the material x joint efficiency / safety
//     factor
//
// so that a place breaks at 1, and with a safety factor still has that much in hand there. The
// engine finds loads (measure/margins.h), frames have them.
#pragma once

#include "base/choice_names.h"
#include "base/vec3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ripstop {

// What is loaded, which says the unit of load and strength.
enum class LoadKind : std::uint8_t {
    Line,   // N, pull of a line or along a spar
    Thread, // N/m, pull of a thread over the width of its strip of fabric
    Cloth,  // N/m, of the warp or the weft of an elastic panel, whichever is nearer to its strength
    Spar    // N m, bending moment
};
template <>
inline constexpr std::array<std::string_view, 4> choiceNames<LoadKind>{"line", "thread", "cloth",
                                                                       "spar"};

constexpr std::string_view unitOf(LoadKind kind)
{
    return kind == LoadKind::Line ? "N" : kind == LoadKind::Spar ? "N m" : "N/m";
}

// The strengths of one material with its joints; 0 where it has none.
struct Strength
{
    double line = 0.0;   // N
    double warp = 0.0;   // N/m
    double weft = 0.0;   // N/m
    double moment = 0.0; // N m

    friend bool operator==(const Strength&, const Strength&) = default;
};

struct LoadedPlace
{
    std::uint32_t element = 0;  // id of a link or a panel; of a moment, of a link beside it
    std::uint32_t whole = 0;    // id of the first link of its line or spar, or that of the element
    std::uint32_t material = 0; // id, or 0 for none
    std::array<std::uint32_t, 3> corners{}; // ids of the particles of a panel
    LoadKind kind = LoadKind::Line;
    double load = 0.0;         // N, N/m or N m, as the kind says
    double strength = 0.0;     // the same; 0 of what has broken by a rule that knows none
    double time = 0.0;         // s
    Vec3 place = Vec3::Zero(); // m
    bool torn = false;         // by this load
    double shortfall = 0.0;    // 1, how much higher it may have been (simulation/snatch_loads.h)

    double margin() const { return load / strength; } // 1

    // Whether it may be so much more that it is not sure enough to be judged by.
    bool isAtLeast() const
    {
        constexpr double mostShortfall = 0.05;
        constexpr double leastMargin = 0.001; // below which it is no load that counts
        return shortfall > mostShortfall && margin() > leastMargin && !torn;
    }

    friend bool operator==(const LoadedPlace&, const LoadedPlace&) = default;
};

// The places that are loaded most for what they bear, the worst first, each with the most that it
// was seen to bear. No place fills the list alone: a line or spar of many links counts once for its
// pull and once for its moment, of panels with a corner in common the worst stands for all, and of
// one material and kind, as the lines of a canopy are, there are three. Takes nothing from the
// heap.
class WorstPlaces
{
public:
    static constexpr std::size_t most = 10;
    static constexpr std::size_t mostAlike = 3; // of one material and kind

    std::span<const LoadedPlace> all() const { return std::span(m_places).first(m_count); }

    bool wants(double margin) const
    {
        return margin > 0.0 && (m_count < most || margin > m_places[m_count - 1].margin());
    }

    void offer(const LoadedPlace& place)
    {
        if (!wants(place.margin()))
            return;
        const LoadedPlace* lastAlike = nullptr; // where there are as many as may be
        std::size_t alike = 0;
        for (const LoadedPlace& held : all()) {
            if (areOne(held, place)) {
                if (held.margin() >= place.margin())
                    return;
            } else if (held.material == place.material && held.kind == place.kind
                       && ++alike == mostAlike) {
                lastAlike = &held;
            }
        }
        if (lastAlike && lastAlike->margin() >= place.margin())
            return;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_count; ++i)
            if (!areOne(m_places[i], place) && &m_places[i] != lastAlike)
                m_places[kept++] = m_places[i];
        m_count = std::min(kept + 1, most);
        auto at = m_places.begin() + std::ptrdiff_t(m_count) - 1;
        for (; at != m_places.begin() && (at - 1)->margin() < place.margin(); --at)
            *at = *(at - 1);
        *at = place;
    }

    // Of the places that were seen to bear most after this time, s, and hold.
    void noteShortfall(double after, double shortfall)
    {
        for (LoadedPlace& place : std::span(m_places).first(m_count))
            if (place.time > after && !place.torn)
                place.shortfall = shortfall;
    }

    void forget() { m_count = 0; }

private:
    static bool areOne(const LoadedPlace& a, const LoadedPlace& b)
    {
        if (a.kind != b.kind)
            return false;
        return a.whole == b.whole || std::ranges::any_of(a.corners, [&](std::uint32_t corner) {
                   return corner != 0 && std::ranges::count(b.corners, corner) > 0;
               });
    }

    std::array<LoadedPlace, most> m_places;
    std::size_t m_count = 0;
};

// The places that broke first in a run, in that order: of a rip that goes through hundreds, where
// it began. A panel that breaks along its warp and then its weft is one. Takes nothing from the
// heap.
class FirstBreaks
{
public:
    static constexpr std::size_t most = 10;

    std::span<const LoadedPlace> all() const { return std::span(m_places).first(m_count); }

    void add(const LoadedPlace& place)
    {
        const bool isThere = std::ranges::any_of(all(), [&](const LoadedPlace& held) {
            return held.element == place.element && held.kind == place.kind;
        });
        if (m_count < most && !isThere)
            m_places[m_count++] = place;
    }

    void forget() { m_count = 0; }

private:
    std::array<LoadedPlace, most> m_places;
    std::size_t m_count = 0;
};

} // namespace ripstop
