// The inside of a Recording: where its stretches are, and how they are read. Seen by recording.cpp
// and recording_data.cpp only.
//
// Three sides use it: the thread that adds, the threads that read, and a thread of its own that
// packs what is old and moves it to disk. Two locks keep them apart, and what each guards is said
// below.
#pragma once

#include "recording/certificate.h"
#include "recording/input_player.h"
#include "recording/packed.h"
#include "recording/recording.h"
#include "recording/run_chunk.h"
#include "recording/spill_file.h"
#include "simulation/simulation.h"

#include <array>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

namespace ripstop {

// Whether a state from a file has the arrays of a system.
bool fits(const System& system, const State& state);

class Recording::Private
{
public:
    Private(std::size_t memory, std::uint64_t run);

    struct Mark // of a frame
    {
        std::int64_t step;
        double time; // s
    };
    struct Entry // a stretch
    {
        std::int64_t firstStep = 0;
        int design = 0;
        std::size_t firstFrame = 0;
        bool sealed = false;                         // no more frames come
        std::shared_ptr<const RunChunk> raw{};       // sealed and not yet packed
        std::shared_ptr<const std::string> packed{}; // in memory
        Fetch fetch{};                               // from disk
        std::size_t bytes = 0;                       // packed
    };

    // Under `mutex`:
    void seal();
    bool hasWork() const { return waiting > 0 || hasNews() || (isOverBound() && oldestInMemory()); }
    bool hasNews() const; // for who follows the stretches
    bool isOverBound() const { return trouble.empty() && size.memory > memory; }
    std::optional<std::size_t> oldestInMemory() const;
    StoredChunk stored(std::size_t entry) const;

    // Under `readMutex`:
    std::size_t entryOfFrame(std::size_t frame) const;
    std::size_t entryOfStep(std::int64_t step) const;
    Entry entryAt(std::size_t entry) const;
    Result<std::shared_ptr<const RunChunk>> chunkOf(std::size_t entry);
    Result<std::shared_ptr<const System>> compiledOf(int design);
    Result<std::shared_ptr<const Frame>> show(int design, State state, std::uint64_t hash);

    Result<std::string> packedBytes(std::size_t entry) const;

    const std::uint64_t run;

    mutable std::mutex mutex; // guards all up to the next comment
    std::condition_variable_any wake;
    std::size_t memory; // bytes, the bound
    std::vector<Entry> entries;
    RunChunk open;           // the last entry, unless sealed
    std::size_t waiting = 0; // entries that are sealed and not packed
    std::vector<Mark> marks;
    std::int64_t firstStep = 0;
    std::vector<std::uint64_t> hashes;
    std::vector<RunInput> inputs;
    std::vector<RunEvent> events;
    std::vector<Design> designs;
    std::vector<Bookmark> bookmarks;
    std::string name;
    std::string origin;
    std::shared_ptr<const Certificate> certificate;
    Message trouble;
    bool over = false;
    Size size;
    std::function<void(std::size_t)> follower;
    std::size_t told = 0; // entries that the follower knows
    bool isTelling = false;

    std::mutex readMutex; // guards what reading keeps; taken before `mutex`
    struct Unpacked
    {
        std::size_t entry = 0;
        std::shared_ptr<const RunChunk> chunk;
    };
    std::array<Unpacked, 2> unpackedChunks; // the newest first
    int compiledDesign = -1;
    std::shared_ptr<const System> compiled;
    int shownDesign = -1;
    std::optional<Simulation> shown; // makes frames

private:
    void tidy(const std::stop_token& stop);
    void packOne(std::unique_lock<std::mutex>& lock);
    void spillOne(std::unique_lock<std::mutex>& lock);
    void tellOne(std::unique_lock<std::mutex>& lock);

    std::shared_ptr<SpillFile> m_spill = std::make_shared<SpillFile>();
    struct Desk
    {
        std::string stretch; // before it is packed
        Packer packer;
    };
    std::optional<Desk> m_desk; // of the thread, while there is something to pack
    std::jthread m_thread;      // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
