// The life of a stretch, in order: it is sealed when the next begins, packed by the recording's own
// thread, told to who follows, and moved to a temporary file when memory is over its bound. Packing
// and writing are done without the lock, so that a step does not wait for them.
//
// Then reading: the stretch of a frame or a step is found, unpacked and shown by a simulation.
#include "recording/recording_data.h"

#include "compile/compile.h"
#include "recording/packed.h"
#include "system/fields.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

using Lock = std::unique_lock<std::mutex>;

template <typename List, typename Step>
auto fromStep(const List& list, Step step)
{
    return std::partition_point(list.begin(), list.end(),
                                [&](const auto& one) { return one.step < step; });
}

} // namespace

bool fits(const System& system, const State& state)
{
    bool sized = true;
    forEachSized(system, state, [&](const auto& values, std::size_t count) {
        sized = sized && values.size() == count;
    });
    const auto isLink = [&](const TearHold& hold) {
        return hold.link >= 0 && std::size_t(hold.link) < system.links.size();
    };
    constexpr int mostSubsteps = 10000; // that a scene may ask for, and more than the solver takes
    return sized && state.substeps >= 0 && state.substeps <= mostSubsteps
           && state.carried.size() == state.hands.carries.size()
           && std::all_of(state.tearHolds.begin(), state.tearHolds.end(), isLink);
}

Recording::Private::Private(std::size_t bound, std::uint64_t number)
    : run(number)
    , memory(bound)
    , m_thread([this](const std::stop_token& stop) { tidy(stop); })
{}

// --- what is old -------------------------------------------------------------------------------

void Recording::Private::seal()
{
    if (entries.empty() || entries.back().sealed)
        return;
    entries.back().sealed = true;
    entries.back().raw = std::make_shared<const RunChunk>(std::exchange(open, {}));
    ++waiting;
    wake.notify_all();
}

std::optional<std::size_t> Recording::Private::oldestInMemory() const
{
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [](const Entry& entry) { return entry.packed != nullptr; });
    if (found == entries.end())
        return std::nullopt;
    return std::size_t(found - entries.begin());
}

void Recording::Private::tidy(const std::stop_token& stop)
{
    Lock lock(mutex);
    while (wake.wait(lock, stop, [this] { return hasWork(); })) {
        if (waiting > 0)
            packOne(lock);
        else if (hasNews())
            tellOne(lock);
        else
            spillOne(lock);
        wake.notify_all();
    }
}

void Recording::Private::packOne(Lock& lock)
{
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [](const Entry& entry) { return entry.raw != nullptr; });
    const auto number = found - entries.begin();
    const std::shared_ptr<const RunChunk> raw = found->raw;
    lock.unlock();
    if (!m_desk)
        m_desk.emplace();
    m_desk->stretch = bytesOf(*raw, std::move(m_desk->stretch));
    auto bytes = std::make_shared<const std::string>(m_desk->packer(m_desk->stretch));
    lock.lock();
    Entry& entry = entries[std::size_t(number)]; // more may have come meanwhile
    entry.raw.reset();
    entry.bytes = bytes->size();
    entry.packed = std::move(bytes);
    size.memory += entry.bytes;
    if (--waiting == 0 && over)
        m_desk.reset();
}

// The last stretch may still get hashes and inputs.
bool Recording::Private::hasNews() const
{
    return follower && told < entries.size() && entries[told].sealed
           && (told + 1 < entries.size() || over);
}

void Recording::Private::tellOne(Lock& lock)
{
    const auto tell = follower;
    const std::size_t number = told++;
    isTelling = true;
    lock.unlock();
    tell(number);
    lock.lock();
    isTelling = false;
}

void Recording::Private::spillOne(Lock& lock)
{
    const std::size_t number = *oldestInMemory();
    const std::shared_ptr<const std::string> bytes = entries[number].packed;
    lock.unlock();
    const Result<std::size_t> place = m_spill->append(*bytes);
    lock.lock();
    if (!place) {
        trouble = Message("The recording ends here, as %1.", place.message());
        return;
    }
    Entry& entry = entries[number];
    entry.fetch = [spill = m_spill, at = *place, count = bytes->size()] {
        return spill->read(at, count);
    };
    entry.packed.reset();
    size.memory -= entry.bytes;
    size.disk += entry.bytes;
}

// --- reading -----------------------------------------------------------------------------------

std::size_t Recording::Private::entryOfFrame(std::size_t frame) const
{
    const std::lock_guard lock(mutex);
    const auto after =
        std::partition_point(entries.begin(), entries.end(),
                             [&](const Entry& entry) { return entry.firstFrame <= frame; });
    return std::size_t(after - entries.begin()) - 1;
}

std::size_t Recording::Private::entryOfStep(std::int64_t step) const
{
    const std::lock_guard lock(mutex);
    const auto after =
        std::partition_point(entries.begin(), entries.end(),
                             [&](const Entry& entry) { return entry.firstStep <= step; });
    return after == entries.begin() ? 0 : std::size_t(after - entries.begin()) - 1;
}

Recording::Private::Entry Recording::Private::entryAt(std::size_t entry) const
{
    const std::lock_guard lock(mutex);
    return entries[entry];
}

Result<std::string> Recording::Private::packedBytes(std::size_t number) const
{
    Entry entry;
    RunChunk unfinished;
    {
        const std::lock_guard lock(mutex);
        entry = entries[number];
        if (!entry.sealed)
            unfinished = open;
    }
    if (entry.packed)
        return *entry.packed;
    if (entry.fetch)
        return entry.fetch();
    return packed(bytesOf(entry.raw ? *entry.raw : unfinished));
}

Result<std::shared_ptr<const RunChunk>> Recording::Private::chunkOf(std::size_t number)
{
    {
        const std::lock_guard lock(mutex);
        if (entries.empty())
            return Failure{"There is nothing in the recording."};
        const Entry& entry = entries[number];
        if (entry.raw)
            return entry.raw;
        if (!entry.sealed)
            return std::make_shared<const RunChunk>(open);
    }
    for (const Unpacked& kept : unpackedChunks)
        if (kept.chunk && kept.entry == number)
            return kept.chunk;
    const Result<std::string> bytes = packedBytes(number);
    if (!bytes)
        return bytes.failure();
    const Result<std::string> whole = unpacked(*bytes);
    std::optional<RunChunk> chunk = whole ? ripstop::chunkOf(*whole) : std::nullopt;
    if (!chunk || chunk->start->step != entryAt(number).firstStep)
        return Failure{"A stretch of the recording is damaged; choose another time."};
    std::swap(unpackedChunks[0], unpackedChunks[1]);
    unpackedChunks[0] = {number, std::make_shared<const RunChunk>(std::move(*chunk))};
    return unpackedChunks[0].chunk;
}

Result<std::shared_ptr<const System>> Recording::Private::compiledOf(int number)
{
    if (number == compiledDesign)
        return compiled;
    Design design;
    {
        const std::lock_guard lock(mutex);
        design = designs[std::size_t(number)];
    }
    auto made = compile(design.scene(), std::uint64_t(number) + 1, run);
    if (!made)
        return made.failure();
    compiledDesign = number;
    compiled = std::move(*made);
    return compiled;
}

Result<std::shared_ptr<const Frame>> Recording::Private::show(int design, State state,
                                                              std::uint64_t hash)
{
    if (!shown || shownDesign != design) {
        auto system = compiledOf(design);
        if (!system)
            return system.failure();
        shown.emplace(std::move(*system), std::move(state));
        shownDesign = design;
    } else {
        shown->place(std::move(state));
    }
    if (!fits(shown->system(), shown->state())) {
        shown.reset();
        return Failure{"The recording does not fit its design: it is damaged."};
    }
    const std::shared_ptr<Frame> frame = shown->frame();
    frame->hash = hash;
    return std::shared_ptr<const Frame>(frame);
}

StoredChunk Recording::Private::stored(std::size_t number) const
{
    const Entry& entry = entries[number];
    const bool last = number + 1 == entries.size();
    const std::size_t endFrame = last ? marks.size() : entries[number + 1].firstFrame;
    const std::int64_t endStep =
        last ? std::numeric_limits<std::int64_t>::max() : entries[number + 1].firstStep;

    StoredChunk chunk;
    chunk.firstStep = entry.firstStep;
    chunk.design = entry.design;
    for (std::size_t i = entry.firstFrame; i < endFrame; ++i) {
        chunk.frameSteps.push_back(marks[i].step);
        chunk.frameTimes.push_back(marks[i].time);
    }
    const auto firstHash = std::ptrdiff_t(entry.firstStep - firstStep);
    const auto endHash = std::min(endStep - firstStep, std::int64_t(hashes.size()));
    chunk.hashes.assign(hashes.begin() + firstHash, hashes.begin() + std::ptrdiff_t(endHash));
    chunk.inputs.insert(chunk.inputs.end(), fromStep(inputs, entry.firstStep),
                        fromStep(inputs, endStep));
    chunk.events.assign(fromStep(events, entry.firstStep), fromStep(events, endStep));
    return chunk;
}

} // namespace ripstop
