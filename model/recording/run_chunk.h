// A stretch of a recording: one exact state, and frames after it as differences.
//
// A frame has time, inputs, hands and air exactly; places as differences to the exact state and
// velocities and tensions in single precision: places are right to 1e-7 of the way since the exact
// state, some tenths of a micrometre. An exact state of any step is computed again.
#pragma once

#include "system/state.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// Of files. A field of a state or a frame that is new since the last release is marked with the
// next number (Since), so that older stretches can be read.
inline constexpr int recordingVersion = 6;

struct KeptFrame
{
    std::int64_t step = 0;
    std::int64_t substep = 0;
    double time = 0.0; // s
    int substeps = 0;
    std::uint32_t tears = 0;  // so far, of RunChunk::tears
    std::uint32_t broken = 0; // of RunChunk::broken
    std::vector<double> inputCommand;
    std::vector<double> inputValue;
    Hands hands;
    std::vector<Vec3> carried;
    std::vector<GustState> gusts;
    std::vector<CanopyAir> canopies;
    Work work;
    std::vector<float> way;      // [3 particles] m, from the exact state
    std::vector<float> velocity; // [3 particles] m/s
    std::vector<float> tension;  // [rods] N
};

// What is torn and gone, noted when it changes.
struct Broken
{
    std::vector<std::uint8_t> springs;
    std::vector<std::uint8_t> rods;
    std::vector<std::uint8_t> panels;

    friend bool operator==(const Broken&, const Broken&) = default;
};

struct RunChunk
{
    std::shared_ptr<const State> start; // exact
    std::vector<std::shared_ptr<const KeptFrame>> frames;
    std::vector<Broken> broken;
    std::vector<State::Tear> tears; // since the start
};

// As a KeptFrame has it; `chunk` takes note of what broke.
KeptFrame kept(const State& state, RunChunk& chunk);

// The state that a frame of a chunk is kept of, as far as it is kept.
State stateOf(const RunChunk& chunk, const KeptFrame& frame);

std::size_t bytesIn(const KeptFrame& frame);
std::size_t bytesIn(const State& state);

// `room` gives its memory, as for one after the other.
std::string bytesOf(const RunChunk& chunk, std::string room = {});
std::optional<RunChunk> chunkOf(std::string_view bytes); // nothing when it is damaged

} // namespace ripstop
