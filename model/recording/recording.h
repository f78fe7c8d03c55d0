// All of a run: the hash of each step, each input with its step, frames every few steps, and now
// and then an exact state, from which any step can be computed again, to the bit.
//
// One thread adds (recorder.h), any thread reads and says names and bookmarks; calls wait for each
// other and none of them for a step. What is old is compressed by a thread of its own
// and leaves memory for a temporary file when there is more than the bound. A recording that was
// opened from a file (io/recording_file.h) reads from that.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "compile/design.h"
#include "recording/run_event.h"
#include "simulation/frame.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ripstop {

struct Certificate; // recording/certificate.h
struct Moment;      // system/moment.h
struct State;       // system/state.h

// What a moment says to those who only pass it on.
double timeOf(const Moment& moment);        // s
const Hands& handsOf(const Moment& moment); // as they were told

struct Bookmark
{
    std::int64_t step = 0;
    double time = 0.0; // s
    std::string name;

    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

// A stretch as files have it.
struct StoredChunk
{
    std::int64_t firstStep = 0;
    int design = 0; // number of the one that ran when it began
    std::vector<std::int64_t> frameSteps;
    std::vector<double> frameTimes;    // s
    std::vector<std::uint64_t> hashes; // of each state from the first step on
    std::vector<RunInput> inputs;
    std::vector<RunEvent> events;
};

class Recording
{
public:
    // Bytes that it may hold in memory; what is more goes to a temporary file.
    explicit Recording(std::size_t memory = std::size_t(512) << 20, std::uint64_t run = 0);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    // --- frames ---
    std::size_t frameCount() const;
    std::int64_t stepOf(std::size_t frame) const;
    double timeOf(std::size_t frame) const;      // s
    std::size_t frameAt(double time) const;      // the nearest; there has to be one
    std::size_t frameOfStep(std::int64_t) const; // the last that is not after it

    // The arrays as far as run_chunk.h keeps them, with the hash of the exact state. Frames of one
    // system share a layout. Takes some milliseconds more when another stretch is unpacked for it.
    Result<std::shared_ptr<const Frame>> frame(std::size_t frame) const;

    // What is kept of the state at a frame, and the number of the design that it is one of.
    Result<State> keptState(std::size_t frame) const;
    int designOf(std::size_t frame) const;

    // To the bit, by computing the steps since the exact state before again.
    Result<std::shared_ptr<const Frame>> exactFrame(std::int64_t step,
                                                    const Progress& progress = {}) const;
    Result<std::shared_ptr<Moment>> moment(std::int64_t step, const Progress& progress = {}) const;

    // --- what happened ---
    std::int64_t firstStep() const;
    std::int64_t lastStep() const;
    std::uint64_t hashOf(std::int64_t step) const; // 0 when it is not in the recording
    std::vector<RunInput> inputs() const;
    std::vector<RunEvent> events(std::size_t first = 0) const; // from this one on
    bool isOver() const;
    std::uint64_t run() const; // as its frames have it

    std::size_t designCount() const;
    Design design(int number) const;
    Scene scene() const; // as the run began; an empty one when nothing was recorded

    // --- what people say about it ---
    std::string name() const;
    void setName(std::string name);
    std::string origin() const; // "4.2 s of flight 1"; empty for a run that began with the design
    void setOrigin(std::string origin);
    // Which digits of its probes hold; null where nobody has certified it.
    std::shared_ptr<const Certificate> certificate() const;
    void setCertificate(std::shared_ptr<const Certificate> certificate);
    std::vector<Bookmark> bookmarks() const;
    void setBookmarks(std::vector<Bookmark> bookmarks); // sorted by step here

    // --- where it is ---
    struct Size
    {
        std::size_t memory = 0; // bytes
        std::size_t disk = 0;   // bytes, of the temporary or the opened file
    };
    Size size() const;
    void setMemory(std::size_t bytes); // the bound
    Message trouble() const;           // why it ends before the run does; empty when it does not
    void settle() const;               // waits until all that is old is packed

    // --- adding, from one thread ---
    int addDesign(Design design); // its number
    void startChunk(State start, int design);
    void addStep(std::int64_t step, std::uint64_t hash);
    std::size_t addFrame(const State& state); // what it takes, bytes
    void addInputs(std::vector<RunInput> inputs);
    void addEvent(const RunEvent& event);
    void finish(); // no more comes

    // --- for files ---
    std::size_t chunkCount() const;
    StoredChunk chunk(std::size_t number) const;              // what is known without unpacking
    Result<std::string> chunkBytes(std::size_t number) const; // packed
    // Calls `told` with the number of each stretch as soon as no more comes to it, in their order,
    // on the recording's own thread. Nothing in its place ends that, when the last call is over.
    void tellOfStretches(std::function<void(std::size_t)> told);
    // A stretch whose packed bytes can be read at any time.
    using Fetch = std::function<Result<std::string>()>;
    void addChunk(StoredChunk chunk, Fetch fetch, std::size_t bytes);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace ripstop
