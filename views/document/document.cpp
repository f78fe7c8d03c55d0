// Edits come through push() and drag() into the undo stack, whose commands call applyNow(), as does
// tryOut(): the only place where an edit reaches the scene, and so the only one that emits
// changed(). Whole scenes come through show(), which clears the history, because its commands
// belong to the scene that is gone; replace() and recover() then mark the new scene as unsaved.
#include "document/document.h"

#include "document/edit_command.h"
#include "io/scene_file.h"

#include <QFileInfo>

#include <utility>

namespace ripstop {

std::filesystem::path pathOf(const QString& file)
{
    return std::filesystem::path(file.toStdU16String());
}

Document::Document(QObject* parent)
    : QObject(parent)
{
    connect(&m_history, &QUndoStack::cleanChanged, this, [this] {
        if (!m_isReplacing)
            emit fileChanged();
    });
}

void Document::push(Edit edit)
{
    takeBack();
    if (!edit.changes.empty())
        m_history.push(new EditCommand(*this, std::move(edit))); // the stack owns the command
}

void Document::drag(Edit edit, int gesture)
{
    takeBack();
    if (!edit.changes.empty())
        m_history.push(new EditCommand(*this, std::move(edit), gesture));
}

int Document::beginGesture() { return ++m_gesture; }

void Document::cancel(int gesture)
{
    const int last = m_history.index() - 1;
    if (last < 0 || m_history.command(last)->id() != gesture)
        return;
    auto* command = const_cast<QUndoCommand*>(m_history.command(last));
    command->undo();
    command->setObsolete(true); // the history then drops it, without undoing it once more
    m_history.undo();
}

// Redoing is kept: the history drops it with the next step, which this is not.
void Document::tryOut(Edit edit)
{
    takeBack();
    if (!edit.changes.empty())
        m_back = applyNow(edit);
}

bool Document::takeBack()
{
    const std::optional<Edit> back = std::exchange(m_back, std::nullopt);
    if (back)
        applyNow(*back);
    return back.has_value();
}

void Document::retranslate()
{
    for (int i = 0; i < m_history.count(); ++i)
        // the history hands out its commands as constant, but they are our own
        static_cast<EditCommand*>(const_cast<QUndoCommand*>(m_history.command(i)))->retranslate();
}

void Document::replace(Scene scene, const QString& suggestedName)
{
    const bool isWork = !scene.items.empty();
    show(std::move(scene), {}, suggestedName);
    if (isWork) { // it stands in no file yet
        m_history.resetClean();
        emit fileChanged();
    }
}

std::optional<Failure> Document::open(const QString& file)
{
    Result<Scene> scene = readScene(pathOf(file));
    if (!scene)
        return scene.failure();
    show(std::move(*scene), QFileInfo(file).absoluteFilePath(), {});
    return std::nullopt;
}

std::optional<Failure> Document::save(const QString& file)
{
    if (auto failure = saveScene(m_scene, pathOf(file)))
        return failure;
    m_file = QFileInfo(file).absoluteFilePath();
    m_written = QFileInfo(m_file).lastModified();
    m_suggestedName.clear();
    m_history.setClean();
    emit fileChanged();
    return std::nullopt;
}

std::optional<Failure> Document::recover(const QString& copy, const QString& file,
                                         const QString& name)
{
    Result<Scene> scene = readScene(pathOf(copy));
    if (!scene)
        return scene.failure();
    show(std::move(*scene), file, name);
    m_history.resetClean();
    emit fileChanged();
    return std::nullopt;
}

bool Document::isOlderThanFile() const
{
    return !m_file.isEmpty() && QFileInfo(m_file).lastModified() > m_written;
}

QString Document::displayName() const
{
    if (!m_file.isEmpty())
        return QFileInfo(m_file).fileName();
    return m_suggestedName.isEmpty() ? tr("untitled") : m_suggestedName;
}

void Document::show(Scene scene, const QString& file, const QString& suggestedName)
{
    m_scene = std::move(scene);
    m_back.reset();
    m_file = file;
    m_written = QFileInfo(file).lastModified();
    m_suggestedName = suggestedName;
    m_isReplacing = true; // nobody hears of the file before they hear of the scene
    m_history.clear();    // its commands belong to the scene that is gone
    m_history.setClean(); // clear() leaves this out when there are no commands
    m_isReplacing = false;
    emit replaced();
    emit fileChanged();
}

Edit Document::applyNow(const Edit& edit)
{
    Edit inverse = apply(m_scene, edit);
    emit changed(edit);
    return inverse;
}

} // namespace ripstop
