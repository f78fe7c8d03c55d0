// Shows where and when something broke: the moment in the recording of its run, with the place in
// the middle of the view.
//
// A camera that follows goes along with the fabric when that moment comes into the view, so the
// place is brought to the middle then. What is not recorded is said, and the view has the place as
// it is now. The main window has one; the panel of loads asks for it.
#pragma once

#include "base/vec3.h"

#include <QObject>
#include <QString>

#include <optional>

namespace ripstop {

class Player;
class Recordings;
class Viewport;

class ShownBreak final : public QObject
{
    Q_OBJECT

public:
    ShownBreak(Player& player, Recordings& recordings, Viewport& viewport, QObject& window);

    void show(quint64 run, double time, const Vec3& place); // s, m

signals:
    void said(const QString& message); // for the status bar

private:
    Recordings& m_recordings;
    Viewport& m_viewport;
    std::optional<Vec3> m_awaited; // m, until its moment is shown
};

} // namespace ripstop
