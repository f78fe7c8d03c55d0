// The shape that an elastic panel has at rest: a triangle in the plane, of which the first axis is
// the warp of the cloth and the second the weft.
//
// It follows from the rest lengths of its sides and from its grain; sides without a rest length are
// as long as their corners are apart. Built or imported panels have all three, so that a scene that
// is saved in flight keeps its cut.
#pragma once

#include "scene/items.h"
#include "shapes/polygon_mesh.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace ripstop {

struct FlatPanel
{
    Eigen::Vector2d ab; // m, from a to b
    Eigen::Vector2d ac; // m, from a to c

    double area() const { return 0.5 * (ab.x() * ac.y() - ab.y() * ac.x()); } // m^2, positive
};

// Nothing where the lengths make no triangle, or one so thin that its strain would be rounding
// errors. Places of the corners in m.
std::optional<FlatPanel> flatPanel(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c);

// m^2, of that shape; where there is none, of the triangle as it lies.
double cutArea(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c);

// How far along ab and along ac the warp runs: with these shares its way is
//
//     shares[0] (b - a) + shares[1] (c - a)
//
// wherever the corners are, 1 long at rest. Nothing where there is no such triangle.
std::optional<std::array<double, 2>> warpShares(const Panel& panel, const Vec3& a, const Vec3& b,
                                                const Vec3& c);

// Degrees, 0 to 180: the grain that has the warp run along `warp`, projected onto the panel; 0
// where it runs across it.
double grainAlong(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& warp);

// Degrees, 0 to 180: this grain turned by an angle, from ab towards c; a warp runs both ways.
double turnedGrain(double grain, double turn);

// The same cloth seen from its other side: the panel with its corners b and c exchanged, and with
// them its rest lengths and its grain. The places, m, are those of the corners before.
Panel turnedOver(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c);

// Notes how long the sides are now, and the grain that has the warp run along `warp`, projected
// onto the panel; a warp across it leaves the grain at 0.
void layFlat(Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& warp);

// A way, of any length, along which the picture goes up that lies on the corners a, b, c with these
// texture points; where it has none, upright (y), and on what lies level along x.
Vec3 uprightWarp(const std::array<Vec3, 3>& corners,
                 const std::array<PolygonMesh::TexturePoint, 3>& texture);

// The same as above with the warp in the direction in which the picture that is printed on the
// fabric goes up.
double uprightGrain(const Particle& a, const Particle& b, const Particle& c); // degrees
void layFlat(Panel& panel, const Particle& a, const Particle& b, const Particle& c);

// Degrees, -90 to 90: by how much the warp is turned from there. Unlike the grain, which is counted
// from a side of its own panel, it tells a direction on the cloth, the same for all panels.
double grainTurn(const Panel& panel, const Particle& a, const Particle& b, const Particle& c);

} // namespace ripstop
