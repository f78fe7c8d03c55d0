// A mesh of triangles, open or closed, with a tree of boxes over them to find what is near.
//
// An open mesh is a shell: a point stays on the side where it is. A closed one, whose edges all
// join two triangles, is solid as well: a point that is inside is brought out by the nearest way.
// Inside and outside are told by the normals of faces, edges and corners, those of corners weighted
// by angle (Baerentzen and Aanaes 2005).
#pragma once

#include "shapes/round_shapes.h"

#include <array>
#include <optional>
#include <vector>

namespace ripstop {

class TriangleTree
{
public:
    struct Face
    {
        std::array<int, 3> corner;
        Vec3 normal; // unit
    };
    struct Hit
    {
        int face;
        double share; // of the way
    };
    struct Near
    {
        int face;
        Vec3 place;      // on the mesh
        Vec3 normal;     // unit, of the face, edge or corner that the place is on
        double distance; // not negative
    };

    TriangleTree() = default;
    // Triangles without area are left out.
    TriangleTree(std::vector<Vec3> points, const std::vector<std::array<int, 3>>& triangles);

    const std::vector<Vec3>& points() const { return m_points; }
    const std::vector<Face>& faces() const { return m_faces; }
    bool isClosed() const { return m_closed; }
    Vec3 low() const { return m_nodes.empty() ? Vec3(Vec3::Zero()) : m_nodes[0].low; }
    Vec3 high() const { return m_nodes.empty() ? Vec3(Vec3::Zero()) : m_nodes[0].high; }

    // The first face on the way from one point to the other; through an edge counts as well.
    std::optional<Hit> firstHit(const Vec3& from, const Vec3& to) const;
    // The nearest place of the mesh that is nearer than `within`; nothing when there is none.
    std::optional<Near> nearest(const Vec3& point, double within) const;

    friend bool operator==(const TriangleTree& a, const TriangleTree& b);

private:
    struct Node // over faces first .. last - 1; the children of one with many are next and `second`
    {
        Vec3 low;
        Vec3 high;
        int first = 0;
        int last = 0;
        int second = 0; // 0 for a leaf
    };

    int grow(int first, int last);
    void findNormals();
    Near nearOn(int face, const Vec3& point) const;

    std::vector<Vec3> m_points;
    std::vector<Face> m_faces;                     // in the order of the leaves
    std::vector<std::array<Vec3, 3>> m_edgeNormal; // [faces] of the edge after each corner
    std::vector<Vec3> m_cornerNormal;              // [points]
    std::vector<Node> m_nodes;                     // the root first
    bool m_closed = false;
};

// See touch.h. A mesh always has some thickness, or rounding would decide on which side a point is
// that rests on it: the margin is at least `leastMargin` of its size.
// `inside` also looks for points that are deep in a closed mesh, which takes longer.
inline constexpr double leastMargin = 1e-5;
std::optional<Touch> touchMesh(const TriangleTree& mesh, double margin, const Vec3& from,
                               const Vec3& to, bool inside);

} // namespace ripstop
