// One thread that turns jobs into outcomes while the window goes on. A job that is posted while
// another waits replaces it: only the newest matters. Any thread may post and take.
//
// `work` and `done` are called on the worker's thread; `done` after each outcome, to wake whoever
// collects it.
#pragma once

#include "run/latest_value.h"

#include <condition_variable>
#include <functional>
#include <thread>

namespace ripstop {

template <typename Job, typename Outcome>
class Worker
{
public:
    Worker(std::function<Outcome(const Job&)> work, std::function<void()> done)
        : m_work(std::move(work))
        , m_done(std::move(done))
        , m_thread([this](const std::stop_token& stop) { run(stop); })
    {}

    void post(Job job)
    {
        {
            const std::lock_guard lock(m_mutex);
            m_jobs.put(std::make_shared<const Job>(std::move(job)));
            m_waiting = true;
        }
        m_wake.notify_one();
    }

    // The newest outcome, or null when there is none since the last call.
    [[nodiscard]] std::shared_ptr<const Outcome> take() { return m_outcomes.take(); }

private:
    void run(const std::stop_token& stop)
    {
        for (;;) {
            {
                std::unique_lock lock(m_mutex);
                if (!m_wake.wait(lock, stop, [this] { return m_waiting; }))
                    return;
                m_waiting = false;
            }
            if (const auto job = m_jobs.take()) {
                m_outcomes.put(std::make_shared<const Outcome>(m_work(*job)));
                m_done();
            }
        }
    }

    std::function<Outcome(const Job&)> m_work;
    std::function<void()> m_done;
    LatestValue<Job> m_jobs;
    LatestValue<Outcome> m_outcomes;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    bool m_waiting = false;
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
