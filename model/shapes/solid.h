// The table of shapes: everything that the program knows of one, in one row.
//
// A collider of a scene and an obstacle of a system have the numbers of all shapes, and say which
// shape they are. What these numbers mean is told by the row of that shape: contact asks it what a
// particle touches, the check what is wrong with it, the author's tools how it grows, the view what
// it looks like and where it is met. A row is in the shape's own frame, around the origin and
// before the collider's turn and place. Any thread may ask.
//
// A new shape is a name in laws/contact_laws.h, its functions in a file of its own, and a row in
// solid.cpp; the table does not compile without it.
#pragma once

#include "base/message.h"
#include "laws/contact_laws.h"
#include "shapes/shape_surface.h"
#include "shapes/touch.h"

#include <Eigen/Geometry>

#include <optional>
#include <string_view>
#include <vector>

namespace ripstop {

// The numbers of a shape, whichever it is; a row says which of them it uses. What is pointed at is
// not owned, and null where a file could not be read yet: then nothing touches.
struct Solid
{
    Vec3 normal = Vec3::UnitY();        // unit
    double radius = 1.0;                // m
    Vec3 size = Vec3::Ones();           // m
    double scale = 1.0;                 // m per unit of the mesh
    double margin = 0.0;                // m, added to the surface
    const HeightGrid* grid = nullptr;   // of a height field
    const TriangleTree* mesh = nullptr; // of a mesh
};

// Which properties of a collider count for a shape.
struct ShapeUses
{
    bool normal = false;
    bool radius = false;
    bool size = false;
    bool turn = false;
    bool file = false;
    bool scale = false;
    bool hills = false; // the numbers of generated hills
};

// What a shape needs beside its numbers: nothing, a HeightGrid or a TriangleTree.
enum class MadeOf { Numbers, Heights, Triangles };

// Across which axes a radius lies, and so with which of them it grows.
enum class Round { Everywhere, AboutY };

struct ShapeRow
{
    ColliderShape shape;
    ShapeUses uses;
    MadeOf madeOf = MadeOf::Numbers;
    Round round = Round::Everywhere;
    bool isGround = false; // a landscape: the camera does not step back to have all of it in sight

    // What a particle touches that was at `from` and is at `to`. `inside` also looks for one that
    // was deep inside a closed mesh before. Null for planes, which are the scene's and compared by
    // height, four particles at a time (contact/contact_kernel.inl).
    std::optional<Touch> (*touch)(const Solid&, const Vec3& from, const Vec3& to, bool inside);

    // The box around it, without its margin; empty for what has no end or is not there yet.
    Eigen::AlignedBox3d (*bounds)(const Solid&);

    // Its width where fabric must not slip by, m, with its margin, since particles touch and panels
    // do not. Infinite for a shape that nothing can slip by.
    double (*width)(const Solid&);

    // What is wrong with its numbers, as a sentence in which %1 is the name of the collider; empty
    // when nothing is.
    Message (*flaw)(const Solid&);

    // What the view draws; without faces when there is nothing.
    ShapeSurface (*surface)(const Solid&);

    // How far along a line of sight it is met; noHit when it is not.
    double (*ray)(const Solid&, const ShapeRay&);

    // Points that are in sight when all of it is.
    std::vector<Vec3> (*extremes)(const Solid&);
};

const ShapeRow& rowOf(ColliderShape shape);

} // namespace ripstop
