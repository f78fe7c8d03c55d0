// Stages: first what opens and begins (new, browse, open), then what saves (a sample is never
// written over, it gets a file of its own), then templates, then what happens when another program
// has written the open file, which is asked about once for each time that it was written. Then
// come export and pictures of the view, the question before changes are lost, and the list of
// recent files.
#include "files/files.h"

#include "document/ask_file.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/words.h"
#include "files/export_dialog.h"
#include "files/film.h"
#include "files/picture_dialog.h"
#include "files/templates.h"
#include "io/scene_file.h"
#include "start/samples.h"
#include "viewport/viewport.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <utility>

namespace ripstop {
namespace {

constexpr auto recentKey = "recentFiles";
constexpr int mostRecent = 12;

} // namespace

Files::Files(Document& document, Player& player, Viewport& viewport, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_player(player)
    , m_viewport(viewport)
    , m_window(window)
{}

QString Files::sceneFilter() { return tr("Ripstop scenes (*.ripstop.json);;All files (*)"); }

void Files::takeOver(const Files& before)
{
    m_seenOnDisk = before.m_seenOnDisk;
    m_exported = before.m_exported;
}

void Files::startNew()
{
    if (!mayDiscard())
        return;
    m_document.replace(Scene{});
    emit opened();
}

void Files::browse()
{
    const QString folder =
        m_document.file().isEmpty() ? QString() : QFileInfo(m_document.file()).path();
    const QString file = QFileDialog::getOpenFileName(
        &m_window, tr("Open"), folder,
        tr("Scenes, studies and recordings (*.ripstop.json *.ripstop-study.json *.ripstop-run)")
            + QStringLiteral(";;") + tr("All files (*)"));
    if (!file.isEmpty())
        emit chosen(file);
}

bool Files::open(const QString& file)
{
    if (!mayDiscard())
        return false;
    if (const auto failure = m_document.open(file)) {
        QMessageBox::warning(&m_window, tr("Cannot open the scene"),
                             shownAsIs(translated(failure->message)));
        return false;
    }
    remember(file);
    emit opened();
    return true;
}

// A sample belongs to the program, so what was made of it gets a file of its own.
bool Files::save()
{
    const QString file = m_document.file();
    return file.isEmpty() || isSample(file) ? saveAs() : write(file);
}

bool Files::saveForStudy()
{
    const QString file = m_document.file();
    if (!file.isEmpty() && !isSample(file) && !m_document.isModified())
        return true;
    const auto answer =
        QMessageBox::question(&m_window, tr("Save the design?"),
                              shownAsIs(tr("A study flies the design as it is saved. Save %1 now?")
                                            .arg(m_document.displayName())),
                              QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Save && save();
}

bool Files::saveAs()
{
    const QString file =
        askWhereToSave(&m_window, tr("Save the scene as"), suggestedFile(".ripstop.json"),
                       sceneFilter(), "ripstop.json");
    return !file.isEmpty() && write(file);
}

void Files::saveAsTemplate()
{
    bool ok = false;
    const QString name =
        QInputDialog::getText(&m_window, tr("Save as template"), tr("Name of the template:"),
                              QLineEdit::Normal, m_document.displayName().remove(".ripstop.json"),
                              &ok)
            .trimmed();
    if (!ok || name.isEmpty())
        return;
    const QString file = templateFile(name);
    if (QFileInfo::exists(file)
        && QMessageBox::question(&m_window, tr("Save as template"),
                                 shownAsIs(tr("There is a template %1. Replace it?").arg(name)))
               != QMessageBox::Yes)
        return;
    QDir().mkpath(QFileInfo(file).path());
    const std::filesystem::path path(file.toStdU16String());
    if (const auto failure = saveScene(m_document.scene(), path))
        QMessageBox::warning(&m_window, tr("Cannot save the template"),
                             shownAsIs(translated(failure->message)));
    else
        emit said(tr("Saved the template %1").arg(name));
}

void Files::startFromTemplate(const QString& file)
{
    if (!mayDiscard())
        return;
    Result<Scene> scene = readScene(std::filesystem::path(file.toStdU16String()));
    if (!scene) {
        QMessageBox::warning(&m_window, tr("Cannot open the template"),
                             shownAsIs(translated(scene.message())));
        return;
    }
    m_document.replace(std::move(*scene), templateName(file));
    emit opened();
}

QStringList Files::templates() const { return templateFiles(); }

void Files::lookAtDisk()
{
    if (!m_document.isOlderThanFile())
        return;
    const QDateTime written = QFileInfo(m_document.file()).lastModified();
    if (std::exchange(m_seenOnDisk, written) == written)
        return; // asked before; saving asks once more
    const QString lost = m_document.isModified() ? tr(" Your changes are then lost.") : QString();
    QMessageBox box(QMessageBox::Question, tr("Changed on the disk"),
                    shownAsIs(tr("Another program has written %1. Open it again?%2")
                                  .arg(m_document.displayName(), lost)),
                    QMessageBox::NoButton, &m_window);
    QPushButton* open = box.addButton(tr("&Open again"), QMessageBox::AcceptRole);
    box.setDefaultButton(box.addButton(tr("&Keep mine"), QMessageBox::RejectRole));
    box.exec();
    if (box.clickedButton() != open)
        return;
    if (const auto failure = m_document.open(m_document.file()))
        QMessageBox::warning(&m_window, tr("Cannot open the scene"),
                             shownAsIs(translated(failure->message)));
}

bool Files::mayOverwrite()
{
    return QMessageBox::warning(&m_window, tr("Changed on the disk"),
                                shownAsIs(tr("Another program has written %1 since you opened "
                                             "it. Replace what it wrote?")
                                              .arg(m_document.displayName())),
                                QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Save;
}

bool Files::write(const QString& file)
{
    if (file == m_document.file() && m_document.isOlderThanFile() && !mayOverwrite())
        return false;
    if (const auto failure = m_document.save(file)) {
        QMessageBox::warning(&m_window, tr("Cannot save the scene"),
                             shownAsIs(translated(failure->message)));
        return false;
    }
    remember(file);
    emit said(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    return true;
}

void Files::exportRun(const Recordings& recordings) { exportAs(m_exported, recordings); }

void Files::saveFilm(const Recordings& recordings)
{
    exportAs(QString::fromUtf8(filmFormats().front().ending), recordings);
}

void Files::exportAs(const QString& ending, const Recordings& recordings)
{
    const auto draw = [this](const std::shared_ptr<const Frame>& frame, const FilmLook& look) {
        m_viewport.show(frame);
        return m_viewport.image(Viewport::Shot{
            look.size, look.overlays ? Viewport::Overlays::With : Viewport::Overlays::Without,
            look.transparent ? Backdrop::Transparent : Backdrop::Scenery,
            look.pins ? Viewport::Pins::With : Viewport::Pins::Without});
    };
    ExportDialog::Matter matter{m_document.scene(), m_player.frame()};
    if (const auto& recording = recordings.current(); recording && recording->frameCount() > 0) {
        matter.recording = recording;
        if (const auto& loop = recordings.loop())
            matter.range.emplace(loop->from, loop->to);
    }
    ExportDialog dialog(matter, suggestedFile(""), draw,
                        m_viewport.size() * m_viewport.devicePixelRatioF(), &m_window);
    connect(&dialog, &ExportDialog::ended, this, [this] {
        if (m_player.frame())
            m_viewport.show(m_player.frame()); // a film has left its last picture
    });
    dialog.choose(ending);
    const int answer = dialog.exec();
    m_exported = dialog.ending();
    if (answer == QDialog::Accepted)
        emit said(tr("Exported %1").arg(QDir::toNativeSeparators(dialog.target())));
}

void Files::savePicture()
{
    PictureDialog dialog(m_viewport, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QString ending = dialog.ending();
    const QString file =
        askWhereToSave(&m_window, tr("Save the view as a picture"), suggestedFile("." + ending),
                       tr("Pictures (*.png *.jpg *.svg *.pdf)"), ending);
    if (file.isEmpty())
        return;
    if (writePicture(m_viewport, dialog.look(), file))
        emit said(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    else
        QMessageBox::warning(
            &m_window, tr("Cannot save the picture"),
            shownAsIs(tr("%1 cannot be written: choose a folder that you may write to, and the "
                         "ending .png, .jpg, .svg or .pdf.")
                          .arg(QDir::toNativeSeparators(file))));
}

bool Files::mayDiscard()
{
    if (!m_document.isModified())
        return true;
    const auto answer = QMessageBox::question(
        &m_window, tr("Unsaved changes"),
        shownAsIs(tr("%1 has changes that are not saved. Save them first?")
                      .arg(m_document.displayName())),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save();
    return answer == QMessageBox::Discard;
}

QStringList Files::recent() const
{
    QStringList files = QSettings().value(recentKey).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void Files::remember(const QString& file)
{
    const QString whole = QFileInfo(file).absoluteFilePath();
    QStringList files = recent();
    files.removeAll(whole);
    files.prepend(whole);
    QSettings().setValue(recentKey, files.mid(0, mostRecent));
    emit recentChanged();
}

// Suggests a file beside the scene and with its name, but never one among the samples.
QString Files::suggestedFile(const QString& extension) const
{
    const QString file = m_document.file();
    QString name = file.isEmpty() ? m_document.displayName() : QFileInfo(file).fileName();
    name.remove(".ripstop.json");
    const bool isOwn = !file.isEmpty() && !isSample(file);
    return QDir(isOwn ? QFileInfo(file).path() : QDir::currentPath()).filePath(name + extension);
}

} // namespace ripstop
