// The canvas keeps a depth for each pixel, so that faces and lines may come in any order. Each
// surface is projected once, its triangles are filled with a shade from a fixed light, and its
// edges are drawn a little nearer than the faces that they bound, so that they are not lost in
// them. Of meshes with many edges only rims and edges of more than two faces are drawn, because all
// edges would cover the faces. Lines beside the faces are drawn in any case.
#include "import/mesh_raster.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t mostEdges = 12000; // shown; finer meshes would be all edges
constexpr float edgeLift = 1.5f;         // px by which lines are nearer than what they bound

class Canvas
{
public:
    Canvas(const QSize& size, const QColor& ground)
        : m_image(size, QImage::Format_RGB32)
        , m_depth(std::size_t(size.width()) * std::size_t(size.height()), -1e30f)
    {
        m_image.fill(ground);
    }

    const QImage& image() const { return m_image; }

    // Fills a triangle; x and y are in px, z grows towards the camera.
    void triangle(const Vec3& a, const Vec3& b, const Vec3& c, QRgb color)
    {
        const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        if (area == 0.0)
            return;
        const int left = std::max(int(std::floor(std::min({a.x(), b.x(), c.x()}))), 0);
        const int right =
            std::min(int(std::ceil(std::max({a.x(), b.x(), c.x()}))), m_image.width() - 1);
        const int top = std::max(int(std::floor(std::min({a.y(), b.y(), c.y()}))), 0);
        const int bottom =
            std::min(int(std::ceil(std::max({a.y(), b.y(), c.y()}))), m_image.height() - 1);
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const double px = x + 0.5;
                const double py = y + 0.5;
                const double u = ((b.x() - px) * (c.y() - py) - (b.y() - py) * (c.x() - px)) / area;
                const double v = ((c.x() - px) * (a.y() - py) - (c.y() - py) * (a.x() - px)) / area;
                const double w = 1.0 - u - v;
                if (u >= 0.0 && v >= 0.0 && w >= 0.0)
                    put(x, y, float(u * a.z() + v * b.z() + w * c.z()), color);
            }
    }

    void line(const Vec3& a, const Vec3& b, QRgb color)
    {
        const double length = std::max(std::abs(b.x() - a.x()), std::abs(b.y() - a.y()));
        const int steps = int(std::min(std::ceil(length), 20000.0));
        for (int i = 0; i <= steps; ++i) {
            const Vec3 p = a + (steps == 0 ? 0.0 : double(i) / steps) * (b - a);
            const int x = int(std::floor(p.x()));
            const int y = int(std::floor(p.y()));
            if (x >= 0 && y >= 0 && x < m_image.width() && y < m_image.height())
                put(x, y, float(p.z()) + edgeLift, color);
        }
    }

private:
    void put(int x, int y, float z, QRgb color)
    {
        float& depth = m_depth[std::size_t(y) * std::size_t(m_image.width()) + std::size_t(x)];
        if (z < depth)
            return;
        depth = z;
        reinterpret_cast<QRgb*>(m_image.scanLine(y))[x] = color;
    }

    QImage m_image;
    std::vector<float> m_depth; // px
};

QRgb shaded(const QColor& color, double light)
{
    const double share = 0.4 + 0.6 * light;
    return qRgb(int(share * color.red()), int(share * color.green()), int(share * color.blue()));
}

void drawSurface(Canvas& canvas, const RepairedMesh& surface, const MeshCamera& camera,
                 const QSize& size, const MeshLook& look)
{
    std::vector<Vec3> at; // px; x to the right, y down, z towards the camera
    at.reserve(surface.mesh.points.size());
    for (const Vec3& point : surface.mesh.points)
        at.push_back(camera.project(point, size));
    const Vec3 light = Vec3(-0.35, -0.5, 0.8).normalized();
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec3& p = at[std::size_t(a)];
        // y points down, so that a front is clockwise here
        const Vec3 normal = -(at[std::size_t(b)] - p).cross(at[std::size_t(c)] - p).normalized();
        const bool isFront = normal.z() > 0.0;
        canvas.triangle(p, at[std::size_t(b)], at[std::size_t(c)],
                        shaded(isFront ? look.front : look.back, std::abs(normal.dot(light))));
    }
    const bool showsAll = surface.edges.size() <= mostEdges;
    for (const MeshEdge& edge : surface.edges) {
        if (edge.faceCount == 2 && !showsAll)
            continue;
        const QColor& color = edge.faceCount == 2   ? look.edge
                              : edge.faceCount == 1 ? look.rim
                                                    : look.trouble;
        canvas.line(at[std::size_t(edge.a)], at[std::size_t(edge.b)], color.rgb());
    }
    for (const auto& [a, b] : surface.mesh.lines)
        canvas.line(at[std::size_t(a)], at[std::size_t(b)], look.rim.rgb());
}

} // namespace

Vec3 MeshCamera::project(const Vec3& point, const QSize& size) const
{
    const Vec3 seen = scale * (turn * (point - middle));
    return {0.5 * size.width() + seen.x(), 0.5 * size.height() - seen.y(), seen.z()};
}

QImage drawMesh(const PreparedMesh& mesh, const MeshCamera& camera, const QSize& size,
                const MeshLook& look)
{
    Canvas canvas(size, look.ground);
    for (const RepairedMesh& surface : mesh.surfaces)
        drawSurface(canvas, surface, camera, size, look);
    return canvas.image();
}

} // namespace ripstop
