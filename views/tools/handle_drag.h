// One pull at a handle of a gizmo: what the hand, the snapping and typed digits come to.
//
// Numbers go along or about the axes of the gizmo: m, degrees, or factors. It is a plain value
// without document or widget: the transform tool keeps one for as long as a drag lasts, tells it
// where the cursor is, and makes edits of its motion.
#pragma once

#include "shaping/transform.h"
#include "tools/gizmo.h"

#include <QString>

#include <optional>

namespace ripstop {

constexpr double degreesPerRadian = 57.29577951308232;

// The motion that numbers mean for the handles as they stand.
Motion motionOf(const Gizmo& handles, const Vec3& numbers);
Vec3 idleNumbers(Shaping shaping); // numbers that change nothing

struct HandleDrag
{
    Gizmo start; // where it began
    Handle handle;
    QPointF from;
    QPointF to;
    bool snaps = false;
    bool placesAreRound = true; // places snap to the grid; otherwise the way from the start does
    QString typed = {};
    double angle = 0.0;     // rad, turned so far
    double lastAngle = 0.0; // rad, as the gizmo saw it last

    static HandleDrag at(const Gizmo& gizmo, Handle handle, QPointF from);
    void follow(QPointF cursor);
    void keepTo(int axis); // the second call for the same axis lets it go

    // `goal` is the place that it snaps to instead of the grid, m.
    Vec3 numbers(const std::optional<Vec3>& goal) const;
    Motion motion(const Vec3& numbers) const;
    QString told(const Vec3& numbers) const; // in words

    bool isAboutSight() const; // it turns in the picture, about none of the axes

private:
    Vec3 way(const std::optional<Vec3>& goal) const; // m along the axes
    std::optional<double> typedNumber() const;
};

} // namespace ripstop
