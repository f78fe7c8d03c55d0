// Where the frames of an export come from: a flight, or a recording of one.
//
// A source is used by one thread at a time; the editor exports on a thread of its own, and a
// recording may go on being written meanwhile.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "io/control_track.h"
#include "recording/recording.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace ripstop {

struct Certificate; // recording/certificate.h
class Recorder;
class Simulation;

class FrameSource
{
public:
    virtual ~FrameSource() = default;

    virtual double begin() const = 0;    // s, of the first frame that can be taken
    virtual double end() const = 0;      // s, of the last; infinite when more can be flown
    virtual double timeStep() const = 0; // s, at the beginning

    // Which digits of the probes hold; null where that is not known.
    virtual std::shared_ptr<const Certificate> certificate() const { return nullptr; }

    struct Taken
    {
        std::shared_ptr<const Frame> frame; // null when cancelled, or when there is none
        Message end;                        // why none comes after it, a sentence; or empty
    };

    // The frame of the time step nearest to `time`, s, or the last one that there is. Times ascend
    // from call to call. `reached` is told how far it has come, s; false cancels.
    using Reached = std::function<bool(double)>;
    virtual Taken take(double time, const Reached& reached) = 0;
};

// Runs a simulation from where it is; a recorder that has it loaded is told of each step.
class FlownFrames final : public FrameSource
{
public:
    explicit FlownFrames(Simulation& simulation, ControlTrack controls = {},
                         Recorder* recorder = nullptr);

    double begin() const override;
    double end() const override { return std::numeric_limits<double>::infinity(); }
    double timeStep() const override;
    Taken take(double time, const Reached& reached) override;

private:
    Simulation& m_simulation;
    ControlPlayer m_controls;
    Recorder* m_recorder;
};

// The flight of a scene as it is, by a simulation of its own. Fails with the first problem that
// keeps the scene from running.
Result<std::unique_ptr<FrameSource>> flightOf(const Scene& scene, ControlTrack controls);

// Takes steps that a recording has a frame of from there, places to some tenths of a micrometre
// (recording/run_chunk.h), and computes the others again from the exact states, to the bit.
class RecordedFrames final : public FrameSource
{
public:
    // One frame at least. Exact ones are all computed.
    enum class Places { AsKept, Exact };
    explicit RecordedFrames(std::shared_ptr<const Recording> recording,
                            Places places = Places::AsKept, int threads = 1);
    ~RecordedFrames() override;

    double begin() const override;
    double end() const override;
    double timeStep() const override { return m_timeStep; }
    std::shared_ptr<const Certificate> certificate() const override
    {
        return m_recording->certificate();
    }
    Taken take(double time, const Reached& reached) override;

private:
    double timeStepFrom(std::size_t frame) const; // s, of the steps after it
    std::int64_t stepAt(double time) const;
    Taken computed(std::int64_t step, const Reached& reached);

    struct Walk; // through what is recorded

    const std::shared_ptr<const Recording> m_recording;
    const Places m_places;
    const int m_threads;
    const double m_timeStep;      // s
    std::unique_ptr<Walk> m_walk; // null before the first step that has to be computed
};

Message inSeconds(double time); // "4.25 s"

} // namespace ripstop
