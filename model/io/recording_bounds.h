// What a recording may ask for, by what is there: a forged one must not take all memory, nor have
// steps computed that nobody has recorded.
#pragma once

#include "recording/recording.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ripstop {

// Memory, by the bytes of the file that have been read so far. A stretch at rest packs to little,
// but its file has the design as well, which grows like the states do.
class RecordingBudget
{
public:
    static constexpr std::uint64_t perByte = 256;
    static constexpr std::uint64_t atOnce = std::uint64_t(1) << 20;       // bytes, of one piece
    static constexpr std::uint64_t ofDesigns = std::uint64_t(1) << 30;    // bytes, of all of them
    static constexpr std::uint64_t largestBlock = std::uint64_t(4) << 30; // bytes, packed

    void hasRead(std::uint64_t bytes) { m_read += bytes; }

    // Whether these may be unpacked: pieces that are read and left again, what is kept of each
    // stretch, and designs.
    bool takes(std::string_view packed) const;
    bool takesToKeep(std::string_view packed) { return takesOf(packed, m_kept, atOnce); }
    bool takesDesign(std::string_view packed) { return takesOf(packed, m_designs, ofDesigns); }

private:
    bool takesOf(std::string_view packed, std::uint64_t& sum, std::uint64_t base);

    std::uint64_t m_read = 0;    // bytes
    std::uint64_t m_kept = 0;    // bytes, unpacked
    std::uint64_t m_designs = 0; // bytes, unpacked
};

// Whether the steps and times of stretches go on from each other, as long as the time steps of
// their designs are.
class RecordedTime
{
public:
    void addDesign(double timeStep) { m_timeSteps.push_back(timeStep); }

    bool takes(const StoredChunk& chunk); // the next one; its design is known

private:
    bool goesOn(std::int64_t step, double time, double shortest, double longest);

    struct Instant
    {
        std::int64_t step = 0;
        double time = 0.0; // s
    };

    std::vector<double> m_timeSteps; // s, of designs
    double m_timeStep = 0.0;         // s, in the last stretch
    std::int64_t m_nextStep = 0;
    std::optional<Instant> m_last; // frame
};

} // namespace ripstop
