// Saves and opens recordings (*.ripstop-run), with progress, and sees to it that a recording is
// looked at with its own design.
//
// Reading and writing happen on another thread (work_dialog.h) while the window waits for them;
// all else is on the thread of the window. A damaged recording is shown as far as it can be read,
// with a warning; one that cannot be read is refused in a message box. The memory for recordings
// is a setting in MB.
#pragma once

#include "io/recording_file.h"

#include <QObject>
#include <QString>

#include <memory>

class QWidget;

namespace ripstop {

class Document;
class Files;
class Recording;
class Recordings;

class RunFiles final : public QObject
{
    Q_OBJECT

public:
    RunFiles(Document& document, Recordings& recordings, Files& files, QWidget& window);

    static bool isRecording(const QString& file);
    // Reads a recording and opens its design, where there is no window yet to show it in.
    static Result<OpenedRecording> openDesign(Document& document, const QString& file);

    void browse();
    void open(const QString& file);
    // What has been read from that file; asks where its design is not the one that is open.
    void show(const OpenedRecording& opened, const QString& file);
    void save(); // saves the current run
    void askForMemory();
    void restoreMemory(); // as it was set in an earlier session

    static constexpr int mostMemory = 64 * 1024; // MB
    static int memory();                         // MB, that each run keeps of itself
    void setMemory(int memory);                  // MB, from the next run on; it is kept

signals:
    void said(const QString& message); // for the status bar

private:
    bool mayShow(const Recording& recording, const QString& file);

    Document& m_document;
    Recordings& m_recordings;
    Files& m_files;
    QWidget& m_window;
};

} // namespace ripstop
