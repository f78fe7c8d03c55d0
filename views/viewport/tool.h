// What the mouse does in the view while a tool is chosen: draw a box, pull an arrow, set a point.
//
// The view asks its tool first. What the tool does not take turns and moves the view, or selects
// what is clicked, as without a tool.
#pragma once

#include "run/frame.h"
#include "viewport/collider_geometry.h"
#include "viewport/look.h"
#include "viewport/theme.h"
#include "viewport/turntable.h"

class QMouseEvent;
class QPainter;

namespace ripstop {

// What the view shows at this moment. Pixels count from the top left.
struct Sight
{
    const Frame& frame;
    const Look& look;
    const std::vector<ColliderBody>& colliders;
    const Turntable& camera;
    double width;  // of the picture, pixels
    double height; // pixels
};

class Tool
{
public:
    virtual ~Tool() = default;

    // True when the tool takes the event. Moves come with and without a button.
    virtual bool press(const QMouseEvent&, const Sight&) { return false; }
    virtual bool move(const QMouseEvent&, const Sight&) { return false; }
    virtual bool release(const QMouseEvent&, const Sight&) { return false; }

    // Escape: gives up the gesture under way. False when there is none; the view then goes back to
    // the pointer.
    virtual bool cancel() { return false; }

    // Over the picture, after each event and each instant.
    virtual void paint(QPainter&, const Theme&, const Sight&) {}

    // True where a click takes what is under the cursor, so that the view shows it beforehand.
    virtual bool picks() const { return true; }
};

} // namespace ripstop
