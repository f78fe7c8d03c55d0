// A change starts the timer (follow); when it fires, the follower is asked for a copy of its scene;
// the copy comes to post(), which takes the lock and hands it to the writer; and collect() hears
// what came of it. Every stage carries the number m_state, which grows when the work is saved or
// given up, so that a copy which is still under way then is thrown away rather than left behind.
#include "document/autosave.h"

#include "document/document.h"
#include "document/follower.h"
#include "document/words.h"
#include "io/scene_file.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSaveFile>
#include <QUuid>

namespace ripstop {
namespace {

bool writeAbout(const QString& path, const QString& file, const QString& title)
{
    QSaveFile about(path);
    return about.open(QIODevice::WriteOnly)
           && about.write(QJsonDocument(QJsonObject{{"file", file}, {"title", title}}).toJson()) > 0
           && about.commit();
}

} // namespace

Autosave::Autosave(Document& document, Follower& follower, const QString& folder, int delay,
                   QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_follower(follower)
    , m_place{folder, {}}
    , m_writer(std::make_unique<Worker<Job, Outcome>>(&Autosave::write, [this] {
        QMetaObject::invokeMethod(this, &Autosave::collect, Qt::QueuedConnection);
    }))
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(delay);
    connect(&m_soon, &QTimer::timeout, this, [this] { m_follower.copy(m_state); });
    connect(&m_follower, &Follower::copied, this, &Autosave::post);
    connect(&m_document, &Document::changed, this, &Autosave::follow);
    connect(&m_document, &Document::fileChanged, this, &Autosave::follow);
    connect(&m_document, &Document::replaced, this, &Autosave::forget);
    follow();
}

Autosave::~Autosave()
{
    m_writer.reset(); // waits for what it writes
    if (!m_isLeft)
        forget();
}

void Autosave::leave()
{
    m_soon.stop();
    m_writer.reset(); // waits for what it writes, which is older
    m_isLeft = m_document.isModified() && hold();
    if (!m_isLeft)
        return;
    const auto scene = std::make_shared<const Scene>(m_document.scene());
    const Outcome outcome =
        write({m_state, scene, m_place, m_document.file(), m_document.displayName()});
    if (outcome.failure)
        emit failed(tr("Unsaved work is not kept: %1").arg(translated(outcome.failure->message)));
}

std::optional<Failure> Autosave::recover(const Rescue& rescue)
{
    if (auto failure = m_document.recover(rescue.place.scene(), rescue.file, rescue.title))
        return failure;
    m_place = rescue.place;
    hold();
    return std::nullopt;
}

void Autosave::follow()
{
    if (!m_document.isModified())
        forget();
    else if (!m_soon.isActive())
        m_soon.start();
}

void Autosave::forget()
{
    ++m_state;
    m_soon.stop();
    if (m_lock)
        m_place.remove();
    m_lock.reset();
    m_place.name.clear();
}

// Takes the lock of the place. It returns false when another program holds that, or the folder
// cannot be written.
bool Autosave::hold()
{
    if (m_lock)
        return true;
    if (m_place.name.isEmpty())
        m_place.name = QUuid::createUuid().toString(QUuid::WithoutBraces);
    QDir().mkpath(m_place.folder);
    auto lock = std::make_unique<QLockFile>(m_place.lock());
    lock->setStaleLockTime(0);
    if (!lock->tryLock())
        return false;
    m_lock = std::move(lock);
    return true;
}

void Autosave::post(std::uint64_t state, const std::shared_ptr<const Scene>& scene)
{
    if (state != m_state)
        return; // the work has been saved or given up meanwhile
    if (m_writer && hold())
        return m_writer->post({state, scene, m_place, m_document.file(), m_document.displayName()});
    if (m_writer && !std::exchange(m_hasFailed, true))
        emit failed(tr("Unsaved work cannot be kept in %1: make the folder one that you may write "
                       "to, or save often.")
                        .arg(QDir::toNativeSeparators(m_place.folder)));
}

Autosave::Outcome Autosave::write(const Job& job)
{
    const std::filesystem::path file(job.place.scene().toStdU16String());
    if (auto failure = saveScene(*job.scene, file))
        return {job.state, job.place, std::move(failure)};
    if (!writeAbout(job.place.about(), job.file, job.title))
        return {job.state, job.place,
                Failure("%1 cannot be written: free some space.", job.place.about().toStdString())};
    return {job.state, job.place, std::nullopt};
}

void Autosave::collect()
{
    const auto outcome = m_writer ? m_writer->take() : nullptr;
    if (!outcome)
        return;
    if (outcome->state != m_state)
        return outcome->place.remove(); // the work was saved or given up while this was written
    if (!outcome->failure) {
        m_hasFailed = false;
        emit kept(outcome->place.scene());
    } else if (!std::exchange(m_hasFailed, true))
        emit failed(tr("Unsaved work is not kept: %1").arg(translated(outcome->failure->message)));
}

} // namespace ripstop
