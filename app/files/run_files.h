#pragma once

#include <QObject>
#include <QString>

#include <memory>

class QWidget;

namespace ripstop {

class Document;
class Files;
class Recording;
class Recordings;

// Saves and opens recordings, with progress, and sees to it that a recording is looked at with its
// own design.
class RunFiles final : public QObject
{
    Q_OBJECT

public:
    RunFiles(Document& document, Recordings& recordings, Files& files, QWidget& window);

    static bool isRecording(const QString& file);

    void browse();
    void open(const QString& file);
    void save(); // the current run
    void askForMemory();
    void restoreMemory(); // as it was set in an earlier session

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
