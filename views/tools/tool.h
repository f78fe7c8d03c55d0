// What the mouse does in the view while a tool is chosen: draw a box, pull an arrow, set a point.
//
// The view asks its tool first. What the tool does not take turns and moves the view, or selects
// what is clicked, as without a tool.
#pragma once

#include "camera/camera_view.h"
#include "look/theme.h"

#include <Qt>

class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace ripstop {

class Tool
{
public:
    virtual ~Tool() = default;

    // True when the tool takes the event. Moves come with and without a button.
    virtual bool press(const QMouseEvent&, const CameraView&) { return false; }
    virtual bool move(const QMouseEvent&, const CameraView&) { return false; }
    virtual bool release(const QMouseEvent&, const CameraView&) { return false; }

    virtual bool wheel(const QWheelEvent&, const CameraView&) { return false; }

    // A key while a gesture is under way; a key that the tool takes is nobody's shortcut then.
    virtual bool takesKey(const QKeyEvent&) const { return false; }
    virtual void key(const QKeyEvent&, const CameraView&) {}

    // What is seen has moved, by itself or as the camera has.
    virtual void moved(const CameraView&) {}

    // True while a gesture is under way that a camera on the move would upset.
    virtual bool holds() const { return false; }

    // Escape: gives up the gesture under way. False when there is none; the view then goes back to
    // the pointer.
    virtual bool cancel() { return false; }

    // Paints over the picture, after each event and each instant.
    virtual void paint(QPainter&, const Theme&, const CameraView&) {}

    // True where a click takes what is under the cursor, so that the view shows it beforehand.
    virtual bool picks() const { return true; }

    virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
};

} // namespace ripstop
