// The public side of a Recording: each call takes the lock and reads or adds to what
// recording_data.h holds. Frames come from the stretch that keeps them; exact moments are computed
// again from the state at the start of their stretch.
//
// startChunk() waits while too many stretches are unpacked, so that a fast run cannot fill the
// memory.
#include "recording/recording.h"

#include "recording/recording_data.h"
#include "scene/scene.h"
#include "system/moment.h"

#include <algorithm>
#include <utility>

namespace ripstop {

double timeOf(const Moment& moment) { return moment.state.time; }

const Hands& handsOf(const Moment& moment) { return moment.state.hands; }

Recording::Recording(std::size_t memory, std::uint64_t run)
    : d(std::make_unique<Private>(memory, run))
{}

Recording::~Recording() = default;

// --- frames ------------------------------------------------------------------------------------

std::size_t Recording::frameCount() const
{
    const std::lock_guard lock(d->mutex);
    return d->marks.size();
}

std::int64_t Recording::stepOf(std::size_t frame) const
{
    const std::lock_guard lock(d->mutex);
    return d->marks[frame].step;
}

double Recording::timeOf(std::size_t frame) const
{
    const std::lock_guard lock(d->mutex);
    return d->marks[frame].time;
}

std::size_t Recording::frameAt(double time) const
{
    const std::lock_guard lock(d->mutex);
    const auto& marks = d->marks;
    const auto after = std::partition_point(marks.begin(), marks.end(),
                                            [&](const auto& mark) { return mark.time < time; });
    if (after == marks.begin())
        return 0;
    const auto index = std::size_t(after - marks.begin());
    if (after == marks.end() || time - marks[index - 1].time < after->time - time)
        return index - 1;
    return index;
}

std::size_t Recording::frameOfStep(std::int64_t step) const
{
    const std::lock_guard lock(d->mutex);
    const auto& marks = d->marks;
    const auto after = std::partition_point(marks.begin(), marks.end(),
                                            [&](const auto& mark) { return mark.step <= step; });
    return after == marks.begin() ? 0 : std::size_t(after - marks.begin()) - 1;
}

Result<State> Recording::keptState(std::size_t number) const
{
    const std::lock_guard reading(d->readMutex);
    const std::size_t entry = d->entryOfFrame(number);
    const auto chunk = d->chunkOf(entry);
    if (!chunk)
        return chunk.failure();
    const std::size_t place = number - d->entryAt(entry).firstFrame;
    if (place >= (*chunk)->frames.size())
        return Failure{"The recording is damaged at this frame; choose another one."};
    return stateOf(**chunk, *(*chunk)->frames[place]);
}

int Recording::designOf(std::size_t number) const
{
    const std::lock_guard reading(d->readMutex);
    return d->entryAt(d->entryOfFrame(number)).design;
}

Result<std::shared_ptr<const Frame>> Recording::frame(std::size_t number) const
{
    Result<State> state = keptState(number);
    if (!state)
        return state.failure();
    const std::lock_guard reading(d->readMutex);
    const int design = d->entryAt(d->entryOfFrame(number)).design;
    return d->show(design, std::move(*state), hashOf(stepOf(number)));
}

Result<std::shared_ptr<const Frame>> Recording::exactFrame(std::int64_t step,
                                                           const Progress& progress) const
{
    auto there = moment(step, progress);
    if (!there)
        return there.failure();
    Moment& from = **there;
    const Simulation simulation(from.system, std::move(from.state));
    return std::shared_ptr<const Frame>(simulation.frame());
}

Result<std::shared_ptr<Moment>> Recording::moment(std::int64_t step, const Progress& progress) const
{
    std::shared_ptr<const RunChunk> chunk;
    std::shared_ptr<const System> system;
    {
        const std::lock_guard reading(d->readMutex);
        const std::size_t entry = d->entryOfStep(step);
        auto found = d->chunkOf(entry);
        if (!found)
            return found.failure();
        auto compiled = d->compiledOf(d->entryAt(entry).design);
        if (!compiled)
            return compiled.failure();
        chunk = std::move(*found);
        system = std::move(*compiled);
    }
    Simulation simulation(std::move(system), *chunk->start);
    if (!fits(simulation.system(), simulation.state()))
        return Failure{"The recording does not fit its design: it is damaged."};
    InputPlayer inputs(*this, *chunk->start);
    const std::int64_t first = chunk->start->step;
    while (simulation.state().step < step) {
        if (auto failure = inputs.giveTo(simulation))
            return *failure;
        if (!simulation.step())
            return Failure("The run stopped before that: %1", simulation.trouble()->message);
        if (!goesOn(progress, double(simulation.state().step - first) / double(step - first)))
            return Failure{"Cancelled."};
    }
    return std::make_shared<Moment>(Moment{simulation.compiled(), simulation.state()});
}

// --- what happened -----------------------------------------------------------------------------

std::int64_t Recording::firstStep() const
{
    const std::lock_guard lock(d->mutex);
    return d->firstStep;
}

std::int64_t Recording::lastStep() const
{
    const std::lock_guard lock(d->mutex);
    return d->firstStep + std::int64_t(d->hashes.size()) - 1;
}

std::uint64_t Recording::hashOf(std::int64_t step) const
{
    const std::lock_guard lock(d->mutex);
    const std::int64_t place = step - d->firstStep;
    return place < 0 || place >= std::int64_t(d->hashes.size()) ? 0 : d->hashes[std::size_t(place)];
}

std::vector<RunInput> Recording::inputs() const
{
    const std::lock_guard lock(d->mutex);
    return d->inputs;
}

std::vector<RunEvent> Recording::events(std::size_t first) const
{
    const std::lock_guard lock(d->mutex);
    const std::size_t from = std::min(first, d->events.size());
    return {d->events.begin() + std::ptrdiff_t(from), d->events.end()};
}

bool Recording::isOver() const
{
    const std::lock_guard lock(d->mutex);
    return d->over;
}

std::uint64_t Recording::run() const { return d->run; }

std::size_t Recording::designCount() const
{
    const std::lock_guard lock(d->mutex);
    return d->designs.size();
}

Design Recording::design(int number) const
{
    const std::lock_guard lock(d->mutex);
    return d->designs[std::size_t(number)];
}

Scene Recording::scene() const
{
    return chunkCount() == 0 ? Scene() : design(chunk(0).design).scene();
}

// --- what people say about it --------------------------------------------------------------------

std::string Recording::name() const
{
    const std::lock_guard lock(d->mutex);
    return d->name;
}

void Recording::setName(std::string name)
{
    const std::lock_guard lock(d->mutex);
    d->name = std::move(name);
}

std::string Recording::origin() const
{
    const std::lock_guard lock(d->mutex);
    return d->origin;
}

void Recording::setOrigin(std::string origin)
{
    const std::lock_guard lock(d->mutex);
    d->origin = std::move(origin);
}

std::shared_ptr<const Certificate> Recording::certificate() const
{
    const std::lock_guard lock(d->mutex);
    return d->certificate;
}

void Recording::setCertificate(std::shared_ptr<const Certificate> certificate)
{
    const std::lock_guard lock(d->mutex);
    d->certificate = std::move(certificate);
}

std::vector<Bookmark> Recording::bookmarks() const
{
    const std::lock_guard lock(d->mutex);
    return d->bookmarks;
}

void Recording::setBookmarks(std::vector<Bookmark> bookmarks)
{
    std::stable_sort(bookmarks.begin(), bookmarks.end(),
                     [](const Bookmark& a, const Bookmark& b) { return a.step < b.step; });
    const std::lock_guard lock(d->mutex);
    d->bookmarks = std::move(bookmarks);
}

// --- where it is --------------------------------------------------------------------------------

Recording::Size Recording::size() const
{
    const std::lock_guard lock(d->mutex);
    return d->size;
}

void Recording::setMemory(std::size_t bytes)
{
    {
        const std::lock_guard lock(d->mutex);
        d->memory = bytes;
    }
    d->wake.notify_all();
}

Message Recording::trouble() const
{
    const std::lock_guard lock(d->mutex);
    return d->trouble;
}

void Recording::settle() const
{
    std::unique_lock lock(d->mutex);
    d->wake.wait(lock, [this] { return !d->hasWork(); });
}

// --- adding -------------------------------------------------------------------------------------

int Recording::addDesign(Design design)
{
    const std::lock_guard lock(d->mutex);
    d->designs.push_back(std::move(design));
    return int(d->designs.size()) - 1;
}

void Recording::startChunk(State start, int design)
{
    std::unique_lock lock(d->mutex);
    if (!d->trouble.empty())
        return;
    d->seal();
    // packing that cannot keep up slows the run down rather than taking all memory
    constexpr std::size_t mostWaiting = 6;
    d->wake.wait(lock, [this] { return d->waiting < mostWaiting; });
    if (d->entries.empty())
        d->firstStep = start.step;
    d->entries.push_back(
        {.firstStep = start.step, .design = design, .firstFrame = d->marks.size()});
    d->open = {std::make_shared<const State>(std::move(start)), {}, {}, {}};
    d->wake.notify_all(); // the one before is complete
}

void Recording::addStep(std::int64_t step, std::uint64_t hash)
{
    const std::lock_guard lock(d->mutex);
    if (d->trouble.empty() && step == d->firstStep + std::int64_t(d->hashes.size()))
        d->hashes.push_back(hash);
}

std::size_t Recording::addFrame(const State& state)
{
    const std::lock_guard lock(d->mutex);
    if (!d->trouble.empty())
        return 0;
    auto frame = std::make_shared<const KeptFrame>(kept(state, d->open));
    d->open.frames.push_back(frame);
    d->marks.push_back({state.step, state.time});
    return bytesIn(*frame);
}

void Recording::addInputs(std::vector<RunInput> inputs)
{
    const std::lock_guard lock(d->mutex);
    if (d->trouble.empty())
        d->inputs.insert(d->inputs.end(), inputs.begin(), inputs.end());
}

void Recording::addEvent(const RunEvent& event)
{
    const std::lock_guard lock(d->mutex);
    if (d->trouble.empty())
        d->events.push_back(event);
}

void Recording::finish()
{
    const std::lock_guard lock(d->mutex);
    if (std::exchange(d->over, true))
        return;
    d->seal();
    d->open = {};
    d->wake.notify_all();
}

// --- for files ----------------------------------------------------------------------------------

std::size_t Recording::chunkCount() const
{
    const std::lock_guard lock(d->mutex);
    return d->entries.size();
}

StoredChunk Recording::chunk(std::size_t number) const
{
    const std::lock_guard lock(d->mutex);
    return d->stored(number);
}

Result<std::string> Recording::chunkBytes(std::size_t number) const
{
    return d->packedBytes(number);
}

void Recording::tellOfStretches(std::function<void(std::size_t)> told)
{
    std::unique_lock lock(d->mutex);
    d->follower = std::move(told);
    d->wake.notify_all();
    d->wake.wait(lock, [this] { return d->follower || !d->isTelling; });
}

void Recording::addChunk(StoredChunk chunk, Fetch fetch, std::size_t bytes)
{
    const std::lock_guard lock(d->mutex);
    if (d->entries.empty())
        d->firstStep = chunk.firstStep;
    Private::Entry entry{
        .firstStep = chunk.firstStep, .design = chunk.design, .firstFrame = d->marks.size()};
    entry.fetch = std::move(fetch);
    entry.bytes = bytes;
    entry.sealed = true;
    d->entries.push_back(std::move(entry));
    d->size.disk += bytes;
    for (std::size_t i = 0; i < chunk.frameSteps.size(); ++i)
        d->marks.push_back({chunk.frameSteps[i], chunk.frameTimes[i]});
    d->hashes.insert(d->hashes.end(), chunk.hashes.begin(), chunk.hashes.end());
    d->inputs.insert(d->inputs.end(), chunk.inputs.begin(), chunk.inputs.end());
    d->events.insert(d->events.end(), chunk.events.begin(), chunk.events.end());
}

} // namespace ripstop
