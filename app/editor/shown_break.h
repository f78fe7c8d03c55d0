// Shows where and when something broke: the last moment before that in the recording of its run,
// with the place in the middle of the view. There it is still whole, and a ring marks where
// it breaks, until another moment is shown or something else is selected.
//
// A camera that follows goes along with the fabric when that moment comes into the view, so the
// place is brought to the middle then. What is not recorded is said, and the view has the place as
// it is now. The main window has one; the panel of loads asks for it.
#pragma once

#include "base/vec3.h"

#include <QObject>
#include <QString>
#include <QWidget>

#include <optional>

namespace ripstop {

class Player;
class Recordings;
class Selection;
class Viewport;

// The ring, a transparent widget over the view that takes no mouse.
class BreakMark final : public QWidget
{
    Q_OBJECT

public:
    explicit BreakMark(Viewport& viewport); // its parent

    void mark(const Vec3& place); // m

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Viewport& m_viewport;
    Vec3 m_place = Vec3::Zero(); // m
};

class ShownBreak final : public QObject
{
    Q_OBJECT

public:
    ShownBreak(Player& player, Recordings& recordings, Selection& selection, Viewport& viewport,
               QObject& window);

    void show(quint64 run, double time, const Vec3& place); // s, m

signals:
    void said(const QString& message); // for the status bar

private:
    Recordings& m_recordings;
    Viewport& m_viewport;
    BreakMark* m_mark;
    std::optional<Vec3> m_awaited; // m, until its moment is shown
};

} // namespace ripstop
