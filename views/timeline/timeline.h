#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace ripstop {

class Recordings;
class TimelineStrip;

// Looks back at runs: which run, play it back, step, events, bookmarks, a loop, go on from here.
class Timeline final : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(Recordings& recordings, QWidget* parent = nullptr);

    TimelineStrip& strip() { return *m_strip; }

    void askForBookmark(); // its name, and sets it here
    void rename();         // the current run
    void askWhatToCompare();

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
    void loopFromHere();
    void loopToHere();
    void refresh();

    Recordings& m_recordings;
    QComboBox* m_runs;
    QToolButton* m_more; // what can be done with a run
    QToolButton* m_eventBack;
    QToolButton* m_back;
    QToolButton* m_play;
    QToolButton* m_forward;
    QToolButton* m_eventForward;
    QComboBox* m_speed;
    QToolButton* m_loop;
    QToolButton* m_bookmark;
    QToolButton* m_compare;
    QToolButton* m_continue;
    QToolButton* m_live;
    QLabel* m_where;
    TimelineStrip* m_strip;
};

} // namespace ripstop
