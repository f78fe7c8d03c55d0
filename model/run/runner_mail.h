// What lies between a runner and the thread of its simulation: what was asked for on the way in,
// frames, samples and recordings on the way out. Both threads use all of it at any time; each value
// is a mailbox, an atomic number, or guarded by the mutex for as long as it takes to move a list.
#pragma once

#include "compile/update.h"
#include "run/latest_value.h"
#include "run/settle.h"
#include "simulation/commands.h"
#include "simulation/frame.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace ripstop {

class Recording;

// To play to: at no time.
inline constexpr double noTime = -std::numeric_limits<double>::infinity(); // s

struct RunnerMail
{
    // --- to the simulation ---
    LatestValue<Commands> commands;
    LatestValue<HandCommands> hands;
    LatestValue<std::optional<SettleGoal>> settle;
    std::atomic<bool> playing = false;
    std::atomic<double> speed = 1.0;    // simulated seconds per second of the clock; 0 is unpaced
    std::atomic<int> stepsLeft = 0;     // that were asked for and have not been made
    std::atomic<double> until = noTime; // s, to play to unpaced
    std::atomic<std::size_t> recordingMemory = std::size_t(512) << 20; // bytes

    // A new system replaces all updates that wait, but for the moment that its run begins with.
    void putUpdate(Update update);
    std::vector<Update> takeUpdates() { return take(m_updates); }

    // Ends a sleep, or the next one before it begins.
    void wake()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_woken = true;
        }
        m_wake.notify_one();
    }
    void sleep(const std::stop_token& stop, std::chrono::steady_clock::duration longest)
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait_for(lock, stop, longest, [this] { return m_woken; });
        m_woken = false;
    }

    // --- from the simulation ---
    LatestValue<Frame> frames;
    void putSample(ProbeSample sample) { put(m_samples, std::move(sample)); }
    std::vector<ProbeSample> takeSamples() { return take(m_samples); }
    void putRecording(std::shared_ptr<Recording> begun) { put(m_recordings, std::move(begun)); }
    std::vector<std::shared_ptr<Recording>> takeRecordings() { return take(m_recordings); }

private:
    template <typename T>
    void put(std::vector<T>& list, T value)
    {
        const std::lock_guard lock(m_mutex);
        list.push_back(std::move(value));
    }
    template <typename T>
    std::vector<T> take(std::vector<T>& list)
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(list, {});
    }

    std::mutex m_mutex; // guards all below
    std::vector<Update> m_updates;
    std::vector<ProbeSample> m_samples;
    std::vector<std::shared_ptr<Recording>> m_recordings;
    bool m_woken = false;
    std::condition_variable_any m_wake;
};

} // namespace ripstop
