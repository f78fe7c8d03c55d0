// Frames are kept as differences to the exact state of their stretch, turned into states again, and
// a stretch is turned into bytes and back. Fields that came with later versions stand behind the
// rest, so that older stretches can be read.
#include "recording/run_chunk.h"

#include "base/bytes.h"
#include "recording/run_fields.h"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace ripstop {
namespace {

void append(std::vector<float>& list, const Vec3& value)
{
    for (int k = 0; k < 3; ++k)
        list.push_back(float(value[k]));
}

// A stretch may be older than the file that it is in, as it is copied into a new one unread. So
// what states and frames are made of since this version stands after the rest, version by version,
// and what is left of the bytes tells how far it goes.
constexpr int firstAfter = 3;

// The fields of a state or a frame that came with a version, into or out of bytes.
template <typename Bytes, typename Record>
void passSince(int version, Bytes& bytes, Record& record)
{
    forEachField<std::remove_const_t<Record>>([&](auto field) {
        if (field.mark(Since{1}).version == version)
            bytes(field.of(record));
    });
}

// What a frame says exactly, by the names that the state has for it.
template <typename Record>
auto exactPart(Record& record)
{
    return std::tie(record.step, record.substep, record.time, record.substeps, record.inputCommand,
                    record.inputValue, record.hands, record.carried, record.gusts, record.canopies,
                    record.work);
}

bool isSound(const RunChunk& chunk)
{
    const std::size_t particles = chunk.start->position.size();
    const auto isSoundFrame = [&](const auto& frame) {
        return frame->way.size() == 3 * particles && frame->velocity.size() == 3 * particles
               && frame->tension.size() == chunk.start->rodTension.size()
               && frame->tears <= chunk.tears.size() && frame->broken < chunk.broken.size();
    };
    return chunk.start->velocity.size() == particles
           && std::all_of(chunk.frames.begin(), chunk.frames.end(), isSoundFrame);
}

} // namespace

KeptFrame kept(const State& state, RunChunk& chunk)
{
    const State& start = *chunk.start;
    chunk.tears.insert(chunk.tears.end(),
                       state.tears.begin()
                           + std::ptrdiff_t(start.tears.size() + chunk.tears.size()),
                       state.tears.end());
    const auto isNoted = [&](const Broken& noted) {
        return noted.springs == state.springTorn && noted.rods == state.rodTorn
               && noted.panels == state.panelGone;
    };
    if (chunk.broken.empty() || !isNoted(chunk.broken.back()))
        chunk.broken.push_back({state.springTorn, state.rodTorn, state.panelGone});

    KeptFrame frame;
    exactPart(frame) = exactPart(state);
    frame.tears = std::uint32_t(chunk.tears.size());
    frame.broken = std::uint32_t(chunk.broken.size() - 1);
    frame.way.reserve(3 * state.position.size());
    frame.velocity.reserve(3 * state.position.size());
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        append(frame.way, state.position[i] - start.position[i]);
        append(frame.velocity, state.velocity[i]);
    }
    frame.tension.assign(state.rodTension.begin(), state.rodTension.end());
    return frame;
}

State stateOf(const RunChunk& chunk, const KeptFrame& frame)
{
    State state = *chunk.start;
    exactPart(state) = exactPart(frame);
    const Broken& broken = chunk.broken[frame.broken];
    state.springTorn = broken.springs;
    state.rodTorn = broken.rods;
    state.panelGone = broken.panels;
    state.tears.insert(state.tears.end(), chunk.tears.begin(), chunk.tears.begin() + frame.tears);
    for (std::size_t i = 0; i < state.position.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            state.position[i][Eigen::Index(k)] += double(frame.way[3 * i + k]);
            state.velocity[i][Eigen::Index(k)] = double(frame.velocity[3 * i + k]);
        }
    state.rodTension.assign(frame.tension.begin(), frame.tension.end());
    return state;
}

std::size_t bytesIn(const KeptFrame& frame)
{
    return sizeof(KeptFrame)
           + sizeof(float) * (frame.way.size() + frame.velocity.size() + frame.tension.size());
}

std::size_t bytesIn(const State& state)
{
    return sizeof(State) + 3 * sizeof(Vec3) * state.position.size()
           + (sizeof(double) + 1) * state.rodTension.size();
}

std::string bytesOf(const RunChunk& chunk, std::string room)
{
    ByteWriter writer(std::move(room), firstAfter - 1);
    writer(chunk);
    for (int version = firstAfter; version <= recordingVersion; ++version) {
        writer(std::uint64_t(1 + chunk.frames.size()));
        passSince(version, writer, *chunk.start);
        for (const auto& frame : chunk.frames)
            passSince(version, writer, *frame);
    }
    return writer.take();
}

std::optional<RunChunk> chunkOf(std::string_view bytes)
{
    ByteReader reader(bytes, firstAfter - 1);
    RunChunk chunk;
    reader(chunk);
    if (!reader.ok() || !chunk.start || !isSound(chunk))
        return std::nullopt;
    for (int version = firstAfter; version <= recordingVersion && !reader.atEnd(); ++version) {
        std::uint64_t count = 0;
        reader(count);
        if (count != 1 + chunk.frames.size())
            return std::nullopt;
        // nobody else has these parts yet, and they were not made const
        passSince(version, reader, const_cast<State&>(*chunk.start));
        for (const auto& frame : chunk.frames)
            passSince(version, reader, const_cast<KeptFrame&>(*frame));
    }
    if (!reader.ok() || !reader.atEnd())
        return std::nullopt;
    auto& velocityBefore = const_cast<State&>(*chunk.start).velocityBefore;
    if (velocityBefore.empty()) // an older stretch, which has no integrator that looks at it
        velocityBefore = chunk.start->velocity;
    auto& panelHold = const_cast<State&>(*chunk.start).panelHold;
    if (panelHold.empty()) // older still: no panel tore
        panelHold.assign(chunk.start->panelGone.size(), 0.0);
    return chunk;
}

} // namespace ripstop
