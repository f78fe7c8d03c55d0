#include "run/run_chunk.h"

#include "run/run_visit.h"

#include <algorithm>

namespace ripstop {

template <typename A>
void visit(A& archive, Of<A, KeptFrame>& frame)
{
    auto& [step, substep, time, substeps, tears, broken, inputCommand, inputValue, hands, carried,
           gusts, canopies, work, way, velocity, tension] = frame;
    (void)work; // after all else: version 2 of the file had none
    archive(step, substep, time, substeps, tears, broken, inputCommand, inputValue, hands, carried,
            gusts, canopies, way, velocity, tension);
}

template <typename A>
void visit(A& archive, Of<A, Broken>& broken)
{
    auto& [springs, rods, panels] = broken;
    archive(springs, rods, panels);
}

template <typename A>
void visit(A& archive, Of<A, RunChunk>& chunk)
{
    auto& [start, frames, broken, tears] = chunk;
    archive(start, frames, broken, tears);
}

namespace {

void append(std::vector<float>& list, const Vec3& value)
{
    for (int k = 0; k < 3; ++k)
        list.push_back(float(value[k]));
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

// Into a chunk that has just been read: nobody else has its parts yet, and they were not made
// const.
//   works  [1 + frames]  of the start and of each frame
void addWork(const RunChunk& chunk, const std::vector<Work>& works)
{
    const_cast<State&>(*chunk.start).work = works.front();
    for (std::size_t i = 0; i < chunk.frames.size(); ++i)
        const_cast<KeptFrame&>(*chunk.frames[i]).work = works[i + 1];
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

    KeptFrame frame{.step = state.step,
                    .substep = state.substep,
                    .time = state.time,
                    .substeps = state.substeps,
                    .tears = std::uint32_t(chunk.tears.size()),
                    .broken = std::uint32_t(chunk.broken.size() - 1),
                    .inputCommand = state.inputCommand,
                    .inputValue = state.inputValue,
                    .hands = state.hands,
                    .carried = state.carried,
                    .gusts = state.gusts,
                    .canopies = state.canopies,
                    .work = state.work,
                    .way = {},
                    .velocity = {},
                    .tension = {}};
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
    state.step = frame.step;
    state.substep = frame.substep;
    state.time = frame.time;
    state.substeps = frame.substeps;
    state.inputCommand = frame.inputCommand;
    state.inputValue = frame.inputValue;
    state.hands = frame.hands;
    state.carried = frame.carried;
    state.gusts = frame.gusts;
    state.canopies = frame.canopies;
    state.work = frame.work;
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
    std::vector<Work> works{chunk.start->work};
    for (const auto& frame : chunk.frames)
        works.push_back(frame->work);
    ByteWriter writer(std::move(room));
    writer(chunk, works);
    return writer.take();
}

std::optional<RunChunk> chunkOf(std::string_view bytes)
{
    ByteReader reader(bytes);
    RunChunk chunk;
    std::vector<Work> works;
    reader(chunk);
    const bool knowsWork = !reader.atEnd();
    if (knowsWork)
        reader(works);
    if (!reader.ok() || !reader.atEnd() || !chunk.start || !isSound(chunk)
        || (knowsWork && works.size() != chunk.frames.size() + 1))
        return std::nullopt;
    if (knowsWork)
        addWork(chunk, works);
    return chunk;
}

} // namespace ripstop
