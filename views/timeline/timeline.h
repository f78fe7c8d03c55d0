// The dock in which the user looks back at runs: it chooses the run, steps, jumps to events
// and bookmarks, loops a range, compares with another run, and continues from an instant. What it
// shows is played back by the transport of the tool bar. It keeps no state of its own: each button
// calls Recordings, and refresh() shows what that then says. Only the window's thread uses it.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace ripstop {

class Recordings;
class TimelineStrip;

class Timeline final : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(Recordings& recordings, QWidget* parent = nullptr);

    TimelineStrip& strip() { return *m_strip; }

    void askForBookmark(); // asks for a name and puts a bookmark at the instant that is shown
    void rename();         // asks for a new name of the current run
    void askWhatToCompare();
    void loopFromHere(); // plays the rest of the run again and again, or what of it the loop has
    void loopToHere();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* button(const char* name, const char* iconName, const QString& text,
                        const QString& toolTip);
    void layOut();
    bool isWide() const; // enough for words beside the icons
    void connectButtons();
    void fillRuns();
    void fillBookmarks();
    void fillCompare();
    void plotDifference();
    void refresh();

    Recordings& m_recordings;
    QComboBox* m_runs;
    QToolButton* m_more; // what can be done with a run
    QToolButton* m_eventBack;
    QToolButton* m_back;
    QToolButton* m_forward;
    QToolButton* m_eventForward;
    QToolButton* m_loop;
    QToolButton* m_bookmark;
    QToolButton* m_compare;
    QToolButton* m_continue;
    QToolButton* m_live;
    QLabel* m_where;
    TimelineStrip* m_strip;
};

} // namespace ripstop
