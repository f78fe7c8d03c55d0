// What the File menu does with scenes: it asks by dialogs, acts on the document, and keeps the
// list of recent files (at most 12, in the settings).
//
// Nothing is thrown away without asking: mayDiscard() comes before everything that replaces the
// scene, and a file that another program has written meanwhile is not overwritten silently.
// Failures are shown in a message box and leave the open scene as it was. It lives on the thread
// of the window. Recordings are handled by run_files.h, builders and meshes by arrivals.h.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QStringList>

class QWidget;

namespace ripstop {

class Document;
class Player;
class Recordings;
class Viewport;

class Files final : public QObject
{
    Q_OBJECT

public:
    Files(Document& document, Player& player, Viewport& viewport, QWidget& window);

    void takeOver(const Files& before); // what has been asked and chosen so far

    void startNew();
    void browse();
    bool open(const QString& file); // false when refused; the open scene then stays
    bool save();
    bool saveAs();
    bool saveForStudy(); // asks, when the design is not in a file of its own as it is
    void saveAsTemplate();
    void startFromTemplate(const QString& file);
    void exportRun(const Recordings& recordings);
    void saveFilm(const Recordings& recordings); // the same, with a film chosen
    void savePicture();
    bool mayDiscard(); // asks to save when there are changes

    QStringList recent() const; // newest first, files that still exist
    QStringList templates() const;

    void lookAtDisk(); // asks what to do when another program has written the open file

    static QString sceneFilter();

signals:
    void chosen(const QString& file); // a file of any sort that may be opened
    void opened();                    // a scene is there to be looked at
    void recentChanged();
    void said(const QString& message); // for the status bar

private:
    bool write(const QString& file);
    bool mayOverwrite();
    void remember(const QString& file);
    void exportAs(const QString& ending, const Recordings& recordings);
    QString suggestedFile(const QString& extension) const;

    Document& m_document;
    Player& m_player;
    Viewport& m_viewport;
    QWidget& m_window;
    QDateTime m_seenOnDisk; // when the file was written that was last asked about
    QString m_exported;     // ending of what was exported last
};

} // namespace ripstop
