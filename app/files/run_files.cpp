// Stages: open() reads the file with a progress bar; show() warns of damage, and asks by mayShow()
// whether the design of the recording is to be opened when it is another one, before the recording
// is added to the timeline. save() writes the current run under a suggested name. The memory that
// a run may take is asked for, kept in the settings, and given to the recordings; it holds from
// the next run on.
#include "files/run_files.h"

#include "dialogs/work_dialog.h"
#include "document/ask_file.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/recordings.h"
#include "document/words.h"
#include "files/files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <optional>

namespace ripstop {
namespace {

constexpr auto memoryKey = "recording/memory"; // MB
constexpr int usualMemory = 512;               // MB

QString titleOf(const Scene& scene, const QString& file)
{
    const QString title = QString::fromStdString(scene.settings.title);
    return title.isEmpty() ? QFileInfo(file).completeBaseName() : title;
}

QString filter() { return RunFiles::tr("Recordings (*.ripstop-run);;All files (*)"); }

} // namespace

RunFiles::RunFiles(Document& document, Recordings& recordings, Files& files, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_recordings(recordings)
    , m_files(files)
    , m_window(window)
{}

bool RunFiles::isRecording(const QString& file)
{
    return file.endsWith(QLatin1String(recordingExtension.data()), Qt::CaseInsensitive);
}

Result<OpenedRecording> RunFiles::openDesign(Document& document, const QString& file)
{
    auto opened = openRecording(pathOf(file));
    if (opened) {
        Scene scene = opened->recording->scene();
        const QString title = titleOf(scene, file);
        document.replace(std::move(scene), title);
    }
    return opened;
}

void RunFiles::browse()
{
    const QString folder =
        m_document.file().isEmpty() ? QString() : QFileInfo(m_document.file()).path();
    const QString file =
        QFileDialog::getOpenFileName(&m_window, tr("Open a recording"), folder, filter());
    if (!file.isEmpty())
        open(file);
}

void RunFiles::open(const QString& file)
{
    std::optional<Result<OpenedRecording>> opened;
    workWithProgress(
        &m_window, tr("Opening %1\u2026").arg(QFileInfo(file).fileName()),
        [&](const Progress& progress) { opened.emplace(openRecording(pathOf(file), progress)); });
    if (!*opened) {
        if (opened->message() != Message("Cancelled."))
            QMessageBox::warning(&m_window, tr("Cannot open the recording"),
                                 shownAsIs(translated(opened->message())));
        return;
    }
    show(**opened, file);
}

void RunFiles::show(const OpenedRecording& opened, const QString& file)
{
    const std::shared_ptr<Recording> recording = opened.recording;
    const QString damage = translated(opened.damage);
    if (!damage.isEmpty())
        QMessageBox::warning(&m_window, tr("The recording is damaged"), shownAsIs(damage));
    if (!mayShow(*recording, file))
        return;
    if (recording->name().empty())
        recording->setName(QFileInfo(file).completeBaseName().toStdString());
    m_recordings.add(recording);
    emit said(tr("Opened %1").arg(QDir::toNativeSeparators(file)));
}

// Opens the design of the recording in the window, unless the user only wants to compare. Returns
// false when the recording is not to be shown.
bool RunFiles::mayShow(const Recording& recording, const QString& file)
{
    Scene scene = recording.scene();
    if (scene == m_document.scene())
        return true;
    if (!m_document.scene().items.empty()) {
        QMessageBox box(QMessageBox::Question, tr("A recording of another design"),
                        shownAsIs(tr("%1 is of another design than the one that is open. Open that "
                                     "design, too? The runs that are not saved are then lost.")
                                      .arg(QFileInfo(file).fileName())),
                        QMessageBox::Cancel, &m_window);
        QPushButton* open = box.addButton(tr("&Open its design"), QMessageBox::AcceptRole);
        QPushButton* compare = box.addButton(tr("Only &compare"), QMessageBox::ActionRole);
        box.setDefaultButton(open);
        box.exec();
        if (box.clickedButton() == compare)
            return true;
        if (box.clickedButton() != open || !m_files.mayDiscard())
            return false;
    }
    const QString title = titleOf(scene, file);
    m_document.replace(std::move(scene), title);
    emit m_files.opened();
    return true;
}

void RunFiles::save()
{
    const std::shared_ptr<Recording> recording = m_recordings.current();
    if (!recording || recording->frameCount() == 0) {
        emit said(tr("Nothing is recorded yet: run the simulation first (Space)."));
        return;
    }
    const QString folder =
        m_document.file().isEmpty() ? QDir::currentPath() : QFileInfo(m_document.file()).path();
    QString name = m_document.displayName().remove(QStringLiteral(".ripstop.json")) + ' '
                   + QString::fromStdString(recording->name());
    name.replace('/', '-');
    const QString file = askWhereToSave(&m_window, tr("Save the recording"),
                                        QDir(folder).filePath(name + ".ripstop-run"), filter(),
                                        QStringLiteral("ripstop-run"));
    if (file.isEmpty())
        return;
    std::optional<Failure> failure;
    workWithProgress(&m_window, tr("Saving %1\u2026").arg(QFileInfo(file).fileName()),
                     [&](const Progress& progress) {
                         failure = saveRecording(*recording, pathOf(file), progress);
                     });
    if (!failure)
        emit said(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    else if (failure->message != Message("Cancelled."))
        QMessageBox::warning(&m_window, tr("Cannot save the recording"),
                             shownAsIs(translated(failure->message)));
}

void RunFiles::askForMemory()
{
    bool given = false;
    const int asked = QInputDialog::getInt(
        &m_window, tr("Memory for recordings"),
        tr("Each run keeps up to this much of itself in memory (MB); older moments go to a "
           "temporary file. 0 records nothing. It holds from the next run on."),
        memory(), 0, mostMemory, 64, &given);
    if (given)
        setMemory(asked);
}

int RunFiles::memory() { return QSettings().value(memoryKey, usualMemory).toInt(); }

void RunFiles::setMemory(int memory)
{
    QSettings().setValue(memoryKey, memory);
    restoreMemory();
}

void RunFiles::restoreMemory() { m_recordings.setMemory(std::size_t(memory()) * 1'000'000); }

} // namespace ripstop
