// The open scene, its history and its file. Views read scene() and react to changed() and
// replaced(); they write only through push() and drag(). Belongs to the window's thread, as all of
// its signals do.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include <filesystem>
#include <optional>

namespace ripstop {

std::filesystem::path pathOf(const QString& file); // as the model takes it

class Document final : public QObject
{
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Scene& scene() const { return m_scene; }
    QUndoStack& history() { return m_history; }

    void push(Edit edit);              // one step in the history
    void drag(Edit edit, int gesture); // steps of one gesture merge into one
    int beginGesture();                // a fresh number for drag()
    void cancel(int gesture);          // as if it had never begun, if it is the last step
    void tryOut(Edit edit);            // shows what comes of it, which is no step of the history
    bool takeBack();                   // what is tried out; returns whether there was anything
    void retranslate();                // names the steps in the language that is spoken now

    // A new design without a file. The history starts over.
    void replace(Scene scene, const QString& suggestedName = {});

    // On failure the open scene stays as it was.
    [[nodiscard]] std::optional<Failure> open(const QString& file);
    [[nodiscard]] std::optional<Failure> save(const QString& file);

    // Opens a copy that was kept of unsaved work, as a later state of `file`, which is empty when
    // the work was never saved. The scene counts as modified.
    [[nodiscard]] std::optional<Failure> recover(const QString& copy, const QString& file,
                                                 const QString& name);

    const QString& file() const { return m_file; } // empty until saved
    QString displayName() const;                   // file name, or the suggested one
    bool isModified() const { return !m_history.isClean(); }
    bool isOlderThanFile() const; // another program has written the file since

signals:
    void changed(const ripstop::Edit& applied);
    void replaced();
    void fileChanged(); // name or modified mark

private:
    friend class EditCommand;
    Edit applyNow(const Edit& edit);
    void show(Scene scene, const QString& file, const QString& suggestedName);

    Scene m_scene;
    QUndoStack m_history;
    QString m_file;
    QString m_suggestedName;
    QDateTime m_written;        // when the file was, as last read or saved
    std::optional<Edit> m_back; // from what is tried out
    int m_gesture = 0;
    bool m_isReplacing = false;
};

} // namespace ripstop
