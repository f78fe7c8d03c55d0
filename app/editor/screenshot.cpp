// Stages: goOn(), called by a timer, waits until the player has a frame and does not run, lets the
// event loop turn a few times, then flies one slice further or saves. A flight goes in slices
// because plots take one sample at the end of each. save() names the file, fits the view, and
// grabs; saveImport() and saveWithDialog() do so where a dialog is what is wanted. finish() ends
// the program with an exit code. Waiting counts turns of the event loop, because Qt tells nobody
// when a layout has come to rest.
#include "editor/screenshot.h"

#include "base/hash_text.h"
#include "document/player.h"
#include "document/recordings.h"
#include "editor/main_window.h"
#include "files/run_files.h"
#include "files/view_picture.h"
#include "import/import_dialog.h"
#include "viewport/viewport.h"

#include <QApplication>
#include <QFileInfo>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace ripstop {
namespace {

constexpr int slicesPerPicture = 120; // one sample of the plots each
constexpr int settlingTurns = 6;      // of the event loop, until docks and view have their sizes
constexpr int openingTurns = 50;      // of the event loop, until the dialog of an action is open
constexpr int dialogTurns = 200;      // of the event loop, until a dialog shows its preview

} // namespace

Screenshot::Screenshot(const Options& options, std::vector<Id> fitted, MainWindow& window,
                       Player& player)
    : QObject(&window)
    , m_options(options)
    , m_fitted(std::move(fitted))
    , m_window(window)
    , m_player(player)
    , m_isRecording(RunFiles::isRecording(options.scene))
{
    connect(&m_timer, &QTimer::timeout, this, &Screenshot::goOn);
    connect(&m_player, &Player::stopped, this, [this](const QString& why) {
        std::fprintf(stderr, "%s\n", qPrintable(why));
        finish(3);
    });
    m_timer.start(10);
}

void Screenshot::goOn()
{
    const bool isReady = m_player.frame() || !m_player.problem().isEmpty();
    if (m_player.isPlaying() || !isReady)
        return;
    if (!m_options.mesh.isEmpty())
        return saveImport();
    if (!m_options.action.isEmpty() && QApplication::activeModalWidget())
        return saveWithDialog();
    if (!m_options.action.isEmpty() && m_slice == 0 && ++m_waited < openingTurns)
        return;
    if ((m_isRecording && !lookBack()) || ++m_settling < settlingTurns)
        return;
    if (m_isRecording)
        return save();
    const int perPicture = std::max(1, slicesPerPicture / m_options.frames);
    const int slices = m_options.after > 0.0 ? perPicture * (m_picture + 1) : 0;
    if (m_slice < slices) {
        ++m_slice;
        m_player.playUntil(m_options.after * m_slice / (perPicture * m_options.frames));
        return;
    }
    save();
}

// The recording is shown by the event loop, and its frames are unpacked by another thread.
bool Screenshot::lookBack()
{
    Recordings& recordings = m_window.recordings();
    if (!recordings.current())
        return false;
    if (!std::exchange(m_sought, true)) {
        recordings.seekTime(m_options.after * (m_picture + 1) / m_options.frames);
        m_settling = 0;
    }
    return recordings.isLookingBack()
           && m_player.frame()->step == recordings.current()->stepOf(recordings.frame());
}

void Screenshot::save()
{
    m_sought = false;
    QString file = m_options.screenshot;
    if (m_options.frames > 1 || file.contains("%1"))
        file = (file.contains("%1") ? file : file.insert(file.lastIndexOf('.'), "%1"))
                   .arg(m_picture, 4, 10, QChar('0'));
    m_window.viewport().fit(m_fitted); // each time, because what flies leaves the first picture
    if (m_options.frames == 1)         // one that is looked at alone has the colours of its moment
        m_window.viewport().setFixedRange({});
    if (!(m_options.viewOnly ? writeView(file) : grabWindow().save(file))) {
        std::fprintf(stderr,
                     "%s: cannot be written; choose a folder that you may write to and the ending "
                     ".png, or of the view .jpg, .svg or .pdf\n",
                     qPrintable(file));
        return finish(1);
    }
    if (++m_picture < m_options.frames)
        return;
    if (const auto& frame = m_player.frame())
        std::printf("%s time %.6g s step %lld hash %s\n", qPrintable(file), frame->time,
                    static_cast<long long>(frame->step), hashText(frame->hash).c_str());
    finish(0);
}

QPixmap Screenshot::grabWindow()
{
    m_window.docks().catchUp(); // or their numbers would be older than the moment that is printed
    m_window.repaint();
    m_window.viewport().image(); // finely; what moves is drawn quickly
    return m_window.grab();
}

bool Screenshot::writeView(const QString& file)
{
    Viewport& viewport = m_window.viewport();
    viewport.image(); // the first picture takes in what has changed since
    const QSize shown = viewport.size() * viewport.devicePixelRatioF();
    const int width = m_options.pictureWidth;
    return writePicture(viewport,
                        {width > 0 ? sizeOfWidth(width, shown) : shown, m_options.backdrop,
                         m_options.legend, m_options.pins},
                        file);
}

// Saves the import dialog, once it shows what will be made of the mesh.
void Screenshot::saveImport()
{
    auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
    if (!dialog || !dialog->isSettled() || ++m_settling < settlingTurns)
        return;
    if (m_options.size)
        dialog->resize(*m_options.size);
    finish(dialog->grab().save(m_options.screenshot) ? 0 : 1);
}

// Saves the window with the dialog of the action over it, once that has had time to show its
// preview.
void Screenshot::saveWithDialog()
{
    QWidget* dialog = QApplication::activeModalWidget();
    if (++m_settling < dialogTurns)
        return;
    QPixmap picture = grabWindow();
    QPainter painter(&picture);
    painter.drawPixmap(dialog->mapToGlobal(QPoint()) - m_window.mapToGlobal(QPoint()),
                       dialog->grab());
    painter.end();
    finish(picture.save(m_options.screenshot) ? 0 : 1);
}

void Screenshot::finish(int exitCode)
{
    m_timer.stop();
    QApplication::exit(exitCode);
}

} // namespace ripstop
