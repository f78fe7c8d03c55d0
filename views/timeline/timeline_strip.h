// The axis of time of a recording: what is kept, what happened, bookmarks, the range that is
// looped, and the instant that is looked at. A drag looks there, the wheel zooms, a double click
// shows all, and the arrow keys step by frames. It reads and moves Recordings and keeps only its
// own zoom. Times are in s, places in px from its left edge. Only the window's thread uses it.
#pragma once

#include "recording/run_event.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace ripstop {

class Recording;
class Recordings;

class TimelineStrip final : public QWidget
{
    Q_OBJECT

public:
    explicit TimelineStrip(Recordings& recordings, QWidget* parent = nullptr);

    double timeAt(int x) const;     // s
    int placeOf(double time) const; // px
    QString tipAt(int x) const;     // what happened there; empty when nothing did

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Span // of time, s
    {
        double from = 0.0;
        double to = 1.0;
        double length() const { return to - from; }
    };
    Span whole() const; // of the run, and of the one that it branched from
    void takeRun();     // when another run has become the current one
    Span shown() const;
    void refresh();
    void scrub(int x);
    void paintAxis(QPainter& painter) const;
    void paintKept(QPainter& painter) const;
    void paintEvents(QPainter& painter) const;
    void paintBookmarks(QPainter& painter) const;
    void paintHere(QPainter& painter) const;

    Recordings& m_recordings;
    std::vector<RunEvent> m_events;
    std::weak_ptr<const Recording> m_run; // that m_kept is for
    Span m_last{0.0, 0.0};                // what was whole() when the run last grew
    Span m_kept{0.0, 0.0};                // that stays where it is while a branch goes on from it
    Span m_zoom;
    bool m_zoomed = false;
};

} // namespace ripstop
