// The window's thread writes requests and edits into the inbox (post) and reads the outbox when it
// is woken (deliver); the thread of the follower takes the whole inbox at once (run) and works
// through it in a fixed order: the scene or the edits first, then compile, check and copy, all of
// which are about the scene as it is after those edits. Only exchanges of the boxes are done under
// the lock, so that neither thread waits while the other works.
#include "document/follower.h"

#include "compile/live_system.h"
#include "document/document.h"

#include <utility>

namespace ripstop {
namespace {

Compiled outcomeOf(LiveSystem& live, std::uint64_t generation, std::uint64_t run)
{
    auto update = live.update(generation, run);
    if (auto* problem = std::get_if<Finding>(&update))
        return {generation, run, {}, std::move(problem->message), problem->culprit()};
    return {generation, run, std::get<Update>(std::move(update)), {}, {}};
}

} // namespace

Follower::Follower(Document& document, QObject* parent)
    : QObject(parent)
    , m_thread([this](const std::stop_token& stop) { run(stop); })
{
    const auto copy = [this, &document] {
        post([&](Inbox& inbox) {
            inbox.scene = document.scene();
            inbox.edits.clear();
        });
    };
    copy();
    connect(&document, &Document::replaced, this, copy);
    connect(&document, &Document::changed, this, [this](const Edit& applied) {
        post([&](Inbox& inbox) { inbox.edits.push_back(applied); });
    });
}

void Follower::compile(std::uint64_t generation, std::uint64_t run)
{
    post([&](Inbox& inbox) { inbox.compile = {generation, run}; });
}

void Follower::check()
{
    post([](Inbox& inbox) { inbox.check = true; });
}

void Follower::copy(std::uint64_t tag)
{
    post([tag](Inbox& inbox) { inbox.copy = tag; });
}

template <typename Note>
void Follower::post(Note note)
{
    {
        const std::lock_guard lock(m_mutex);
        note(m_inbox);
    }
    m_wake.notify_one();
}

template <typename Note>
void Follower::answer(Note note)
{
    {
        const std::lock_guard lock(m_mutex);
        note(m_outbox);
    }
    QMetaObject::invokeMethod(this, &Follower::deliver, Qt::QueuedConnection);
}

void Follower::deliver()
{
    Outbox outbox;
    {
        const std::lock_guard lock(m_mutex);
        outbox = std::exchange(m_outbox, {});
    }
    for (const Compiled& outcome : outbox.compiled)
        emit compiled(outcome);
    if (outbox.problems) {
        emit checked(*outbox.problems);
        emit examined(outbox.findings);
    }
    if (outbox.copy)
        emit copied(outbox.copyTag, outbox.copy);
}

void Follower::run(const std::stop_token& stop)
{
    LiveSystem live;
    DesignLog log;
    for (;;) {
        Inbox inbox;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, stop, [this] { return !m_inbox.empty(); }))
                return;
            inbox = std::exchange(m_inbox, {});
        }
        work(std::move(inbox), live, log);
    }
}

void Follower::work(Inbox inbox, LiveSystem& live, DesignLog& log)
{
    if (inbox.scene) {
        live.replace(std::move(*inbox.scene));
        log.replace();
    }
    for (const Edit& edit : inbox.edits) {
        live.apply(edit);
        log.apply(edit);
    }
    if (inbox.compile) {
        Compiled outcome = outcomeOf(live, inbox.compile->generation, inbox.compile->run);
        outcome.update.design = log.design(live.scene());
        answer([&](Outbox& outbox) { outbox.compiled.push_back(std::move(outcome)); });
    }
    if (inbox.check) {
        std::vector<Finding> problems = problemsOf(live.scene());
        std::vector<Finding> findings = stabilityOf(live.scene());
        answer([&](Outbox& outbox) {
            outbox.problems = std::move(problems);
            outbox.findings = std::move(findings);
        });
    }
    if (inbox.copy) {
        auto scene = std::make_shared<const Scene>(live.scene());
        answer([&](Outbox& outbox) {
            outbox.copy = std::move(scene);
            outbox.copyTag = *inbox.copy;
        });
    }
}

} // namespace ripstop
