// A copy of the scene on a thread of its own, where what takes time is done: finding what an edit
// means to a running simulation, the check, and copies for saving unsaved work.
//
// It follows the document edit by edit, so that the window copies a whole scene only when another
// one is opened, however large it is. Made and asked by the window's thread, which also gets all
// signals; the thread of the follower sees nothing but inbox and outbox.
#pragma once

#include "author/stability.h"
#include "check/check.h"
#include "compile/update.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace ripstop {

class Document;
class LiveSystem;

// The outcome of a compile.
struct Compiled
{
    std::uint64_t generation;
    std::uint64_t run;
    Update update;   // empty when there is a problem
    Message problem; // why the scene cannot run, or empty
    Id culprit{};
};

class Follower final : public QObject
{
    Q_OBJECT

public:
    explicit Follower(Document& document, QObject* parent = nullptr);

    // All three are about the scene as it is now. Of two requests that wait, the newer one counts;
    // each outcome comes with a signal, in the order of the requests.
    void compile(std::uint64_t generation, std::uint64_t run);
    void check();
    void copy(std::uint64_t tag); // the tag comes back with the copy

signals:
    void compiled(const ripstop::Compiled& outcome); // every update has to be run, in order
    void checked(const std::vector<ripstop::Finding>& problems);
    void examined(const std::vector<ripstop::Finding>& findings); // with each check
    void copied(std::uint64_t tag, const std::shared_ptr<const ripstop::Scene>& scene);

private:
    struct Request
    {
        std::uint64_t generation;
        std::uint64_t run;
    };
    struct Inbox
    {
        std::optional<Scene> scene; // replaces the scene and all edits before it
        std::vector<Edit> edits;
        std::optional<Request> compile;
        bool check = false;
        std::optional<std::uint64_t> copy; // its tag
        bool empty() const { return !scene && edits.empty() && !compile && !check && !copy; }
    };
    struct Outbox
    {
        std::vector<Compiled> compiled;
        std::optional<std::vector<Finding>> problems;
        std::vector<Finding> findings; // with the problems
        std::shared_ptr<const Scene> copy;
        std::uint64_t copyTag = 0;
    };

    template <typename Note>
    void post(Note note);
    void deliver();
    void run(const std::stop_token& stop);
    void work(Inbox inbox, LiveSystem& live, DesignLog& log);
    template <typename Note>
    void answer(Note note);

    std::mutex m_mutex;
    Inbox m_inbox;   // guarded by m_mutex
    Outbox m_outbox; // guarded by m_mutex
    std::condition_variable_any m_wake;
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
