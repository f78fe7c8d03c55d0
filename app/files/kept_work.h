// Copies of work that is not saved, and what becomes of those that a crash left behind.
//
// The window begins to keep work once it is on the screen; pictures and tests keep none, or in a
// folder of their own.
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace ripstop {

class Autosave;
class Document;
class Files;
class Player;

class KeptWork final : public QObject
{
    Q_OBJECT

public:
    KeptWork(Document& document, Player& player, Files& files, QWidget& window);

    // Keeps copies in that folder, and asks about those that were left behind there.
    void keepIn(const QString& folder);

    // Goes on keeping what that one keeps, without asking again.
    void takeOver(KeptWork& before);

    // Keeps it at once for the next program, because this one was told to end.
    void leave();

signals:
    void opened();                   // what was left behind is there to be looked at
    void failed(const QString& why); // a copy could not be written

private:
    Autosave* m_autosave = nullptr; // of ours, once work is kept
    Document& m_document;
    Player& m_player;
    Files& m_files;
    QWidget& m_window;
};

} // namespace ripstop
