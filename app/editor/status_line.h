// The status bar: at the left what has just been done, or what is under the mouse; at the right
// what is selected and how much the scene has. That something has torn in the flight is said as it
// happens, because it may be too small to be seen, or behind what is in front.
//
// Objects with a signal said() are connected by hear(); all others call say(). It lives on the
// thread of the window.
#pragma once

#include "scene/id.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <vector>

class QLabel;
class QStatusBar;

namespace ripstop {

class Document;
class Player;
class Recordings;
class Selection;
class Viewport;

class StatusLine final : public QObject
{
    Q_OBJECT

public:
    static constexpr int glance = 8000; // ms, how long a note of what was done stays
    static constexpr int read = 15000;  // ms, how long a note of what went wrong stays

    StatusLine(QStatusBar& bar, Document& document, Selection& selection, Player& player);

    void say(const QString& message, int time = glance);

    template <typename Speaker>
    void hear(const Speaker& speaker)
    {
        connect(&speaker, &Speaker::said, this, [this](const QString& message) { say(message); });
    }
    void follow(const Recordings& recordings);
    void follow(Viewport& viewport); // shows what the mouse is on

private:
    void tellTears(const Recordings& recordings);
    void showCounts();
    void showSelected();
    void showHovered(Id id);
    QString summary(const std::vector<Id>& ids) const;

    QStatusBar& m_bar;
    Document& m_document;
    Selection& m_selection;
    Player& m_player;
    QLabel* m_selected;
    QLabel* m_counts;
    std::uint64_t m_watched = 0; // the run whose tears have been told
    std::size_t m_heard = 0;     // how many of its events
    QTimer m_selectedSoon;       // counts what is selected
};

} // namespace ripstop
