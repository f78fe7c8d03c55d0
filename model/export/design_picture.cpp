// The places are turned to the eye and scaled to a canvas of twice the size, where each point keeps
// the nearest that was drawn; four points of the canvas are one of the picture, so that edges are
// smooth.
#include "export/design_picture.h"

#include "export/appearance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <png.h>

namespace ripstop {
namespace {

constexpr int finer = 2;            // points of the canvas for a pixel, each way
constexpr double fromSide = 0.65;   // rad, that the eye is turned about y
constexpr double fromAbove = 0.42;  // rad
constexpr double margin = 0.06;     // of the size, on each side
constexpr double inShadow = 0.4;    // of the colour, where fabric stands along the light
constexpr double overFabric = 0.01; // of the depth of the whole, that lines are drawn before it
constexpr std::array<double, 3> lineColor{0.25, 0.27, 0.30};

// Looks at the middle of what is to be seen, x to the right, y up, z to the eye.
Eigen::Matrix3d turnToEye()
{
    return (Eigen::AngleAxisd(fromAbove, Vec3::UnitX())
            * Eigen::AngleAxisd(-fromSide, Vec3::UnitY()))
        .toRotationMatrix();
}

struct Seen
{
    std::vector<Vec3> points; // towards the eye
    std::vector<std::array<int, 3>> panels;
    std::vector<std::array<double, 3>> colors; // [panels]
    std::vector<std::array<int, 2>> lines;
};

bool isShown(const Scene& scene, Id material)
{
    const Material* found = findItem<Material>(scene, material);
    return !found || found->shown;
}

Seen seenOf(const Scene& scene)
{
    const MeshAppearance appearance(scene);
    const Eigen::Matrix3d turn = turnToEye();
    Seen seen;
    std::unordered_map<Id, int> placeOf;
    forEachPart(scene, [&](Id, const Part& part) {
        if (!part.shown)
            return;
        for (const Particle& row : part.particles)
            if (row.position.allFinite()) {
                placeOf.emplace(row.id, int(seen.points.size()));
                seen.points.push_back(turn * row.position);
            }
        const auto place = [&](Id id) {
            const auto found = placeOf.find(id);
            return found == placeOf.end() ? -1 : found->second;
        };
        for (const Panel& row : part.panels) {
            const std::array corners{place(row.a), place(row.b), place(row.c)};
            if (std::ranges::min(corners) < 0 || !isShown(scene, row.material))
                continue;
            seen.panels.push_back(corners);
            seen.colors.push_back(
                appearance.fabrics()[appearance.fabricOf(std::uint32_t(row.id))].color);
        }
        const bool isNet = part.panels.empty(); // without fabric, its threads are what there is
        for (const Link& row : part.links) {
            const std::array ends{place(row.from), place(row.to)};
            if (std::ranges::min(ends) >= 0 && isShown(scene, row.material)
                && (isNet || row.role == LinkRole::Line))
                seen.lines.push_back(ends);
        }
    });
    return seen;
}

// The fabric, or all where there is none.
Eigen::AlignedBox3d frameOf(const Seen& seen)
{
    Eigen::AlignedBox3d box;
    for (const auto& corners : seen.panels)
        for (const int corner : corners)
            box.extend(seen.points[std::size_t(corner)]);
    if (box.isEmpty())
        for (const Vec3& point : seen.points)
            box.extend(point);
    return box;
}

class Canvas
{
public:
    explicit Canvas(int size)
        : m_size(size)
        , m_depth(std::size_t(size) * std::size_t(size), -std::numeric_limits<double>::infinity())
        , m_color(m_depth.size())
    {}

    int size() const { return m_size; }

    // Corners in points of the canvas, y down; z is larger the nearer.
    void triangle(const std::array<Vec3, 3>& corner, const std::array<double, 3>& color)
    {
        const auto edge = [](const Vec3& a, const Vec3& b, double x, double y) {
            return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
        };
        const double area = edge(corner[0], corner[1], corner[2].x(), corner[2].y());
        if (area == 0.0)
            return;
        const auto bound = [&](double value) {
            return int(std::clamp(std::floor(value), 0.0, double(m_size - 1)));
        };
        const auto [left, right] = std::minmax({corner[0].x(), corner[1].x(), corner[2].x()});
        const auto [top, bottom] = std::minmax({corner[0].y(), corner[1].y(), corner[2].y()});
        if (right < 0.0 || left >= m_size || bottom < 0.0 || top >= m_size)
            return;
        for (int y = bound(top); y <= bound(bottom); ++y)
            for (int x = bound(left); x <= bound(right); ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double a = edge(corner[1], corner[2], px, py) / area;
                const double b = edge(corner[2], corner[0], px, py) / area;
                const double c = 1.0 - a - b;
                if (a >= 0.0 && b >= 0.0 && c >= 0.0)
                    put(x, y, a * corner[0].z() + b * corner[1].z() + c * corner[2].z(), color);
            }
    }

    void line(const Vec3& from, const Vec3& to)
    {
        // the part within the canvas (Liang and Barsky 1984)
        double first = 0.0, last = 1.0;
        for (const int axis : {0, 1}) {
            const double step = to[axis] - from[axis];
            const double low = (0.0 - from[axis]) / step, high = (m_size - from[axis]) / step;
            if (step == 0.0 && (from[axis] < 0.0 || from[axis] >= m_size))
                return;
            if (step != 0.0) {
                first = std::max(first, std::min(low, high));
                last = std::min(last, std::max(low, high));
            }
        }
        const int steps = int((last - first) * (to - from).head<2>().lpNorm<Eigen::Infinity>()) + 1;
        for (int i = 0; first <= last && i <= steps; ++i) {
            const Vec3 at = from + (first + (last - first) * i / steps) * (to - from);
            for (const int aside : {0, 1})
                for (const int below : {0, 1})
                    put(int(at.x()) + aside, int(at.y()) + below, at.z(), lineColor);
        }
    }

    RasterPicture smooth() const
    {
        RasterPicture picture{m_size / finer, {}};
        for (int y = 0; y < picture.size; ++y)
            for (int x = 0; x < picture.size; ++x)
                append(picture.pixels, x, y);
        return picture;
    }

private:
    std::size_t at(int x, int y) const
    {
        return std::size_t(y) * std::size_t(m_size) + std::size_t(x);
    }

    void put(int x, int y, double depth, const std::array<double, 3>& color)
    {
        if (x < 0 || y < 0 || x >= m_size || y >= m_size || m_depth[at(x, y)] >= depth)
            return;
        m_depth[at(x, y)] = depth;
        m_color[at(x, y)] = color;
    }

    void append(std::vector<std::uint8_t>& pixels, int x, int y) const
    {
        std::array<double, 3> sum{};
        int drawn = 0;
        for (int i = 0; i < finer * finer; ++i) {
            const std::size_t point = at(finer * x + i % finer, finer * y + i / finer);
            if (!std::isfinite(m_depth[point]))
                continue;
            ++drawn;
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += m_color[point][k];
        }
        for (const double part : sum)
            pixels.push_back(std::uint8_t(std::lround(255.0 * part / std::max(drawn, 1))));
        pixels.push_back(std::uint8_t(255 * drawn / (finer * finer)));
    }

    int m_size;
    std::vector<double> m_depth; // [points]
    std::vector<std::array<double, 3>> m_color;
};

// Fabric is lit from both sides alike.
std::array<double, 3> lit(std::array<double, 3> color, const std::array<Vec3, 3>& corner)
{
    const Vec3 light = Vec3(-0.35, 0.6, 0.75).normalized();
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double length = normal.norm();
    const double facing = length > 0.0 ? std::abs(normal.dot(light)) / length : 0.0;
    for (double& part : color)
        part *= inShadow + (1.0 - inShadow) * facing;
    return color;
}

} // namespace

RasterPicture pictureOf(const Scene& scene, int size)
{
    Canvas canvas(finer * size);
    Seen seen = seenOf(scene);
    const Eigen::AlignedBox3d frame = frameOf(seen);
    if (frame.isEmpty())
        return canvas.smooth();
    const double extent = std::max({frame.sizes().x(), frame.sizes().y(), 1e-9}); // m
    const double scale = canvas.size() * (1.0 - 2.0 * margin) / extent;
    const double lift = overFabric * std::max(extent, frame.sizes().z()) * scale;
    const auto onCanvas = [&](int point) {
        const Vec3 from = scale * (seen.points[std::size_t(point)] - frame.center());
        return Vec3(0.5 * canvas.size() + from.x(), 0.5 * canvas.size() - from.y(), from.z());
    };
    for (std::size_t i = 0; i < seen.panels.size(); ++i) {
        std::array<Vec3, 3> corner, place;
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = seen.points[std::size_t(seen.panels[i][k])];
            place[k] = onCanvas(seen.panels[i][k]);
        }
        canvas.triangle(place, lit(seen.colors[i], corner));
    }
    for (const auto& [a, b] : seen.lines)
        canvas.line(onCanvas(a) + Vec3(0.0, 0.0, lift), onCanvas(b) + Vec3(0.0, 0.0, lift));
    return canvas.smooth();
}

Result<std::string> pngBytes(const RasterPicture& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = png_uint_32(picture.size);
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    std::string bytes;
    if (png_image_write_to_memory(&image, nullptr, &size, 0, picture.pixels.data(), 0, nullptr)) {
        bytes.resize(size);
        if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0,
                                      nullptr)) {
            bytes.resize(size);
            return bytes;
        }
    }
    return Failure("The picture could not be made (%1).", image.message);
}

} // namespace ripstop
