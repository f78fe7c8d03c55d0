// cast(): the frame of the picture around all that falls on the ground, with room for penumbras;
// the triangles, each in the layer of its penumbra; the foot, straight below; blurs; and the sum.
//
// A blur is three means over a window in each direction, which cost the same whatever the width. A
// window of n pixels has the variance (n^2 - 1) / 12, a disc of the width w has w^2 / 16 along each
// axis: three windows of n = w / 2 are as wide as the disc.
#include "look/shadow_map.h"

#include "look/triangle_pixels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int side = ShadowMap::side;
constexpr double darkest = 0.80;     // of the light of the sun that things keep away
constexpr double footDarkest = 0.55; // of the light of the sky
constexpr double footShare = 0.06;   // of the size of the picture, m, that the foot reaches up
constexpr double highestFoot = 0.3;  // m
constexpr double smallest = 1e-3;    // m
constexpr float leastBlur = 1.6F;    // pixels, against steps of pixels

// Each pixel of the triangle is at least `value`.
void draw(std::vector<float>& sheet, const std::array<std::array<float, 2>, 3>& corners,
          float value)
{
    forEachPixel(side, corners, [&](std::size_t pixel, float, float) {
        sheet[pixel] = std::max(sheet[pixel], value);
    });
}

// The mean over 2 r + 1 pixels along one direction; there is nothing beyond the edges.
void meanAlong(std::vector<float>& sheet, std::vector<float>& line, int stride, int across, int r)
{
    const float share = 1.0F / float(2 * r + 1);
    for (int i = 0; i < side; ++i) {
        float* const pixels = sheet.data() + std::ptrdiff_t(i) * across;
        const auto at = [&](int k) { return pixels[std::ptrdiff_t(k) * stride]; };
        float sum = 0.0F;
        for (int k = 0; k < std::min(r, side); ++k)
            sum += at(k);
        for (int k = 0; k < side; ++k) {
            sum += k + r < side ? at(k + r) : 0.0F;
            line[std::size_t(k)] = share * sum;
            sum -= k - r >= 0 ? at(k - r) : 0.0F;
        }
        for (int k = 0; k < side; ++k)
            pixels[std::ptrdiff_t(k) * stride] = line[std::size_t(k)];
    }
}

} // namespace

void ShadowMap::frame(std::span<const Vec3> places, std::span<const std::array<int, 3>> triangles,
                      double ground)
{
    const double slope =
        sunDirection.norm() / sunDirection.y(); // m along the ray for one of height
    double lowX = 1e300, highX = -1e300, lowZ = 1e300, highZ = -1e300, highest = 0.0;
    m_spots.assign(places.size(), {0.0F, 0.0F, -1.0F});
    const auto shadowOf = [ground](const Vec3& place) {
        return Vec3(place - (place.y() - ground) / sunDirection.y() * sunDirection);
    };
    const auto extend = [&](const Vec3& place) {
        lowX = std::min(lowX, place.x());
        highX = std::max(highX, place.x());
        lowZ = std::min(lowZ, place.z());
        highZ = std::max(highZ, place.z());
    };
    for (const auto& triangle : triangles)
        for (const int corner : triangle) {
            const Vec3& place = places[std::size_t(corner)];
            Spot& spot = m_spots[std::size_t(corner)];
            if (spot.height >= 0.0F || !place.allFinite() || place.y() < ground)
                continue;
            spot.height = float(place.y() - ground);
            extend(shadowOf(place));
            if (spot.height <= highestFoot) // the foot lies straight below
                extend(place);
            highest = std::max(highest, double(spot.height));
        }
    m_size = 0.0;
    if (lowX > highX)
        return;
    const double room = 1.5 * sunWidth * slope * highest;
    const double span = std::max({highX - lowX, highZ - lowZ, smallest}) + 2.0 * room;
    m_size = 1.12 * span;
    m_x = 0.5 * (lowX + highX - m_size);
    m_z = 0.5 * (lowZ + highZ - m_size);
    const double perMetre = side / m_size;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (m_spots[i].height >= 0.0F) {
            const Vec3 fallen = shadowOf(places[i]);
            m_spots[i].x = float(perMetre * (fallen.x() - m_x));
            m_spots[i].z = float(perMetre * (fallen.z() - m_z));
        }
}

void ShadowMap::drawInLayers(std::span<const std::array<int, 3>> triangles)
{
    const double slope = sunDirection.norm() / sunDirection.y();
    const double pixelsPerHeight = sunWidth * slope * side / m_size;
    for (const auto& [a, b, c] : triangles) {
        const Spot &p = m_spots[std::size_t(a)], &q = m_spots[std::size_t(b)],
                   &r = m_spots[std::size_t(c)];
        if (p.height < 0.0F || q.height < 0.0F || r.height < 0.0F)
            continue;
        const double width = pixelsPerHeight * double(p.height + q.height + r.height) / 3.0;
        const int octave = width <= 1.0 ? 0 : 1 + int(std::floor(std::log2(width)));
        Layer& layer = m_layers[std::min(std::size_t(octave), m_layers.size() - 1)];
        if (layer.count++ == 0)
            layer.sheet.assign(std::size_t(side * side), 0.0F);
        layer.width += width;
        draw(layer.sheet, {{{p.x, p.z}, {q.x, q.z}, {r.x, r.z}}}, 1.0F);
    }
}

void ShadowMap::drawFoot(std::span<const Vec3> places,
                         std::span<const std::array<int, 3>> triangles, double ground)
{
    const double reach = std::min(footShare * m_size, highestFoot);
    const double perMetre = side / m_size;
    for (const auto& triangle : triangles) {
        std::array<std::array<float, 2>, 3> corners{};
        double height = 0.0;
        bool isOver = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = std::size_t(triangle[i]);
            isOver = isOver && m_spots[corner].height >= 0.0F;
            height += (places[corner].y() - ground) / 3.0;
            corners[i] = {float(perMetre * (places[corner].x() - m_x)),
                          float(perMetre * (places[corner].z() - m_z))};
        }
        if (!isOver || height >= reach)
            continue;
        if (m_foot.count++ == 0)
            m_foot.sheet.assign(std::size_t(side * side), 0.0F);
        draw(m_foot.sheet, corners, float(1.0 - height / reach));
    }
    m_foot.width = 1.2 * reach * perMetre;
}

void ShadowMap::blur(Sheet& sheet, double width)
{
    m_scratch.resize(side);
    const int r = std::clamp(int(std::lround(0.25 * std::max(width, double(leastBlur)))), 1, 60);
    for (int pass = 0; pass < 3; ++pass) {
        meanAlong(sheet, m_scratch, 1, side, r);
        meanAlong(sheet, m_scratch, side, 1, r);
    }
}

void ShadowMap::put()
{
    m_dark.assign(std::size_t(side * side), 0);
    for (std::size_t i = 0; i < m_dark.size(); ++i) {
        double sum = 0.0;
        for (const Layer& layer : m_layers)
            if (layer.count > 0)
                sum += double(layer.sheet[i]);
        const double foot = m_foot.count > 0 ? double(m_foot.sheet[i]) : 0.0;
        const double light = (1.0 - darkest * std::min(sum, 1.0)) * (1.0 - footDarkest * foot);
        m_dark[i] = std::uint8_t(std::lround(255.0 * (1.0 - light)));
    }
}

void ShadowMap::cast(std::span<const Vec3> places, std::span<const std::array<int, 3>> triangles,
                     double ground)
{
    for (Layer& layer : m_layers)
        layer.count = 0, layer.width = 0.0;
    m_foot.count = 0;
    frame(places, triangles, ground);
    if (isEmpty())
        return;
    drawInLayers(triangles);
    drawFoot(places, triangles, ground);
    for (Layer& layer : m_layers)
        if (layer.count > 0)
            blur(layer.sheet, layer.width / layer.count);
    if (m_foot.count > 0)
        blur(m_foot.sheet, m_foot.width);
    put();
}

double ShadowMap::darkAt(double x, double z) const
{
    if (isEmpty())
        return 0.0;
    const double column = side * (x - m_x) / m_size - 0.5;
    const double row = side * (z - m_z) / m_size - 0.5;
    if (!(column > -1.0 && column < side && row > -1.0 && row < side))
        return 0.0;
    const int left = int(std::floor(column)), above = int(std::floor(row));
    const auto pixel = [this](int c, int r) {
        const bool isInside = c >= 0 && c < side && r >= 0 && r < side;
        return isInside ? m_dark[std::size_t(r * side + c)] / 255.0 : 0.0;
    };
    const double right = column - left, below = row - above; // shares
    return (1.0 - below) * ((1.0 - right) * pixel(left, above) + right * pixel(left + 1, above))
           + below * ((1.0 - right) * pixel(left, above + 1) + right * pixel(left + 1, above + 1));
}

std::vector<std::uint8_t> ShadowMap::darkBeside(const ShadowMap& other) const
{
    std::vector<std::uint8_t> dark = m_dark;
    const double pixel = m_size / side;
    for (std::size_t i = 0; i < dark.size() && !other.isEmpty(); ++i) {
        if (dark[i] == 0)
            continue;
        const double left = 1.0
                            - other.darkAt(m_x + pixel * (double(i % side) + 0.5),
                                           m_z + pixel * (double(i / side) + 0.5));
        const double light = 1.0 - dark[i] / 255.0;
        dark[i] = light < left ? std::uint8_t(std::lround(255.0 * (1.0 - light / left))) : 0;
    }
    return dark;
}

} // namespace ripstop
