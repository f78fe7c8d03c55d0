// Keeps a copy of what is not saved, some seconds after it changed, without holding up the window:
// the follower's scene is copied on its thread and written on another. The copy goes when the work
// is saved or given up. Made and asked by the window's thread.
#pragma once

#include "base/result.h"
#include "document/rescue.h"
#include "document/worker.h"
#include "scene/scene.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

class QLockFile;

namespace ripstop {

class Document;
class Follower;

class Autosave final : public QObject
{
    Q_OBJECT

public:
    static constexpr int usualDelay = 20000; // ms after the first change

    Autosave(Document& document, Follower& follower, const QString& folder, int delay = usualDelay,
             QObject* parent = nullptr);
    ~Autosave() override;

    // Opens what was left behind and goes on keeping it where it lies.
    [[nodiscard]] std::optional<Failure> recover(const Rescue& rescue);

    // Keeps what is not saved at once and lets go of it, so that the next program finds it: this
    // one was told to end.
    void leave();

signals:
    void kept(const QString& file);
    void failed(const QString& why); // once, until a copy succeeds

private:
    struct Job
    {
        std::uint64_t state;
        std::shared_ptr<const Scene> scene;
        RescuePlace place;
        QString file;
        QString title;
    };
    struct Outcome
    {
        std::uint64_t state;
        RescuePlace place;
        std::optional<Failure> failure;
    };

    static Outcome write(const Job& job);
    void follow();
    void forget();
    void post(std::uint64_t state, const std::shared_ptr<const Scene>& scene);
    void collect();
    bool hold();

    Document& m_document;
    Follower& m_follower;
    RescuePlace m_place;
    std::unique_ptr<QLockFile> m_lock; // while there is something to keep
    std::uint64_t m_state = 0;         // grows when what is being kept is no longer wanted
    bool m_hasFailed = false;
    bool m_isLeft = false; // to the next program
    QTimer m_soon;
    std::unique_ptr<Worker<Job, Outcome>> m_writer;
};

} // namespace ripstop
