// The handles by which the hand moves, turns and scales what is selected: arrows and squares,
// rings, and boxes. Where they lie in the picture, which one the cursor is on, and what dragging it
// means.
//
// Handles keep their size in pixels, whatever the distance.
#pragma once

#include "camera/camera_projection.h"

#include <QPointF>
#include <QPolygonF>

#include <array>
#include <vector>

namespace ripstop {

enum class Shaping { None, Move, Turn, Scale };

struct Handle
{
    // Free moves in the plane of the picture, turns about the line of sight, or scales evenly in
    // all directions.
    enum class Sort { None, Axis, Plane, Free };
    Sort sort = Sort::None;
    int axis = 0; // the axis to move along or turn about, or that is across the plane

    explicit operator bool() const { return sort != Sort::None; }
    friend bool operator==(const Handle&, const Handle&) = default;

    // The axes that a drag of it changes.
    std::array<bool, 3> axes() const;
};

struct Gizmo
{
    Shaping shaping;
    Vec3 pivot; // m
    CameraProjection projection;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // columns, unit

    // The handle within a few pixels, drawn nearest to the cursor.
    Handle at(QPointF cursor) const;

    // What a drag of the handle with the cursor from `from` to `to`, pixels, comes to.
    Vec3 shift(Handle handle, QPointF from, QPointF to) const;   // m
    Vec3 factors(Handle handle, QPointF from, QPointF to) const; // of the axes, above 0
    // The angle of the cursor about turningAxis(), rad. Only differences count, and they jump by a
    // whole turn.
    double angle(Handle handle, QPointF at) const;
    Vec3 turningAxis(Handle handle) const; // unit

    // Lines for drawing, pixels; empty for what cannot be seen, such as an arrow end on.
    QPolygonF shape(Handle handle) const;  // line of an axis or ring, outline of a square
    QPolygonF behindShape(int ring) const; // the half of a ring that lies behind
    std::vector<Handle> handles() const;   // that can be seen
    std::optional<QPointF> centre() const { return projection.pixel(pivot); }

    static constexpr double reach = 84.0;      // pixels, of arrows and rings
    static constexpr double viewReach = 100.0; // pixels, of the ring about the line of sight
    static constexpr double grip = 8.0;        // pixels, radius of what is at the centre
};

} // namespace ripstop
