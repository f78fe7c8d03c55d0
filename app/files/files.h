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

// What the File menu does: dialogs around the document, and the list of recent files. Nothing is
// thrown away without asking.
class Files final : public QObject
{
    Q_OBJECT

public:
    Files(Document& document, Player& player, Viewport& viewport, QWidget& window);

    void startNew();
    void browse();
    bool open(const QString& file); // false when refused; the open scene then stays
    bool save();
    bool saveAs();
    void saveAsTemplate();
    void startFromTemplate(const QString& file);
    void exportRun(const Recordings& recordings);
    void savePicture();
    bool mayDiscard(); // asks to save when there are changes

    QStringList recent() const; // newest first, files that still exist
    QStringList templates() const;

    void lookAtDisk(); // asks what to do when another program has written the open file

    static QString sceneFilter();

signals:
    void opened(); // a scene is there to be looked at
    void recentChanged();
    void said(const QString& message); // for the status bar

private:
    bool write(const QString& file);
    bool mayOverwrite();
    void remember(const QString& file);
    QString suggestedFile(const QString& extension) const;

    Document& m_document;
    Player& m_player;
    Viewport& m_viewport;
    QWidget& m_window;
    QDateTime m_seenOnDisk; // of the file, when it was last asked about
    QString m_exported;     // ending of what was exported last
};

} // namespace ripstop
