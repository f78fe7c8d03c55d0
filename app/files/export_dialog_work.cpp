// Writing what the form of the export dialog says. start() asks before it replaces files, then
// writes at once (writeNow()) or on a thread: write() chooses recording or simulation as the source
// and opens the sink of the format; writeBundle() does the same for a bundle. watch() polls
// progress and ends it.
#include "files/export_dialog.h"

#include "bundle/bundle.h"
#include "document/plain_text.h"
#include "document/words.h"
#include "export/output_files.h"
#include "io/tear_table.h"

#include <QCoreApplication>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>

namespace ripstop {
namespace {

// Calls `draw` on the thread of the window and waits for it.
DrawFrame drawnBy(QObject* window, const ExportDialog::Draw& draw, const FilmLook& look)
{
    return [window, &draw, look](const std::shared_ptr<const Frame>& frame) {
        QImage picture;
        QMetaObject::invokeMethod(
            window,
            [&] {
                picture = draw(frame, look);
                paintCaption(picture, *frame, look);
            },
            Qt::BlockingQueuedConnection);
        return picture;
    };
}

} // namespace

// A thread that draws waits for this one, so events are processed while it ends.
ExportDialog::~ExportDialog()
{
    m_cancelled = true;
    while (m_work.valid()
           && m_work.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready)
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
}

void ExportDialog::start()
{
    showPreview(); // a folder may have come or gone since
    if (m_work.valid() || !m_go->isEnabled() || !mayWrite())
        return;
    if (!choice().isFlown()) {
        const QString failure = writeNow();
        return failure.isEmpty() ? accept() : end(failure);
    }
    m_cancelled = false;
    m_done = 0.0;
    m_progress->show();
    m_progress->setValue(0);
    setBusy(true);
    m_work = std::async(std::launch::async, [this, job = job()] { return write(job); });
    m_watch.start(50);
}

QString ExportDialog::writeNow() const
{
    if (!m_now)
        return tr("There is nothing on the screen to export; see the list of problems.");
    const std::filesystem::path file = target().toStdString();
    const auto* table = std::get_if<RunTable>(&choice().what);
    const auto failure = !table ? writeMoment(*m_now, m_appearance, file)
                         : *table == RunTable::Tears
                             ? writeTears(m_scene, *m_now, file)
                             : writeControlTrack(m_scene, trackOf(*m_now), file);
    return failure ? translated(failure->message) : QString();
}

Result<std::unique_ptr<FrameSink>> ExportDialog::sinkFor(const Job& job)
{
    if (const FilmFormat* film = job.choice.film())
        return openFilm(*film, job.target, job.picturesPerSecond, drawnBy(this, m_draw, job.look));
    return openSink(*job.choice.mesh(), job.target.toStdString(), m_appearance);
}

QString ExportDialog::writeBundle(const Job& job)
{
    BundleOrder order;
    order.seconds = job.range.to;
    order.controls = job.controls;
    if (m_draw && m_now)
        order.decorate = [picture = drawnBy(this, m_draw, job.look)(m_now)](
                             const std::filesystem::path& folder) -> std::optional<Failure> {
            const std::filesystem::path file = folder / "view.png";
            if (picture.save(QString::fromStdString(file.string())))
                return std::nullopt;
            return notWritten(file, Message("the picture could not be saved"));
        };
    const std::filesystem::path target = job.target.toStdString();
    const Progress progress = [this](double done) {
        m_done = done;
        return !m_cancelled;
    };
    const BundleWritten written = job.recorded
                                      ? ripstop::writeBundle(m_recording, order, target, progress)
                                      : ripstop::writeBundle(m_scene, order, target, progress);
    return written.failure ? translated(written.failure->message) : QString();
}

QString ExportDialog::write(const Job& job)
{
    if (job.choice.isBundle())
        return writeBundle(job);
    std::unique_ptr<FrameSource> source;
    if (job.recorded) {
        source = std::make_unique<RecordedFrames>(m_recording);
    } else {
        auto flight = flightOf(m_scene, job.controls);
        if (!flight)
            return translated(flight.message());
        source = std::move(*flight);
    }
    const auto sink = sinkFor(job);
    if (!sink)
        return translated(sink.message());
    const auto failure = exportSeries(*source, job.range, **sink, [this](double done) {
        m_done = done;
        return !m_cancelled;
    });
    return failure ? translated(failure->message) : QString();
}

bool ExportDialog::mayWrite()
{
    const QString file = target();
    const QStringList there = replacedBy(choice(), file, frames(), m_appearance);
    if (there.isEmpty() || (there == QStringList{file} && file == m_mayReplace))
        return true;
    const QString question =
        there.size() == 1
            ? tr("%1 exists already. Replace it?").arg(QDir::toNativeSeparators(there[0]))
            : tr("%1 and %2 more exist already. Replace them?")
                  .arg(QDir::toNativeSeparators(there[0]), QString::number(there.size() - 1));
    return QMessageBox::question(this, tr("Replace what is there?"), shownAsIs(question))
           == QMessageBox::Yes;
}

void ExportDialog::watch()
{
    m_progress->setValue(int(1000 * m_done));
    if (m_work.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    m_watch.stop();
    const QString failure = m_work.get();
    emit ended();
    if (failure.isEmpty())
        accept(); // also when it was done before it noticed that it was cancelled
    else
        end(m_cancelled ? tr("Cancelled; nothing was kept.") : failure);
}

void ExportDialog::setBusy(bool busy)
{
    m_fields->setEnabled(!busy);
    m_go->setEnabled(!busy);
}

void ExportDialog::end(const QString& failure)
{
    setBusy(false);
    m_progress->hide();
    m_message->setText(failure);
}

void ExportDialog::reject()
{
    if (m_work.valid())
        m_cancelled = true; // watch() sees the end of it
    else
        QDialog::reject();
}

} // namespace ripstop
