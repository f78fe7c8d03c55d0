// The size is in the first chunk of a PNG (ISO/IEC 15948, 11.2.2), and in the frame header of a
// JPEG (ISO/IEC 10918-1, B.2.2), which is found by going from segment to segment. Both are followed
// to their ends, as what draws them shows a damaged picture in part or not at all without a word.
//
// printedPoints() lays u and v over the panels of each part in turn, finds how many metres they
// are, and takes each particle through the place of the material.
#include "derived/fabric_picture.h"

#include <Eigen/Geometry>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr double mostPixels = 64e6;              // what Qt reads into 256 MiB, its limit
constexpr std::uintmax_t mostBytes = 256U << 20; // of so many pixels, without compression

std::uint32_t wholeNumber(const std::string& bytes, std::size_t at, std::size_t count)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i)
        number = number << 8 | std::uint8_t(bytes[at + i]);
    return number;
}

// Whether all chunks are there and are as they were written.
bool isWholePng(const std::string& bytes)
{
    constexpr std::size_t around = 12; // bytes of a chunk beside its data: length, name, checksum
    for (std::size_t at = 8; at + around <= bytes.size();) {
        const std::size_t length = wholeNumber(bytes, at, 4);
        if (length > bytes.size() - at - around)
            return false;
        const auto* name = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        if (crc32(0, name, uInt(4 + length)) != wholeNumber(bytes, at + 8 + length, 4))
            return false;
        if (bytes.compare(at + 4, 4, "IEND") == 0)
            return true;
        at += around + length;
    }
    return false;
}

struct Jpeg
{
    std::optional<PictureSize> size;
    bool isWhole = false;
};

// Goes from mark to mark: 0xff and a byte that says what begins. In the picture itself 0xff 0x00
// stands for 0xff, and the marks from 0xd0 to 0xd7 have no data.
Jpeg readJpeg(const std::string& bytes)
{
    Jpeg jpeg;
    bool isInPicture = false;
    for (std::size_t at = 2; at + 2 <= bytes.size();) {
        const auto mark = std::uint8_t(bytes[at + 1]);
        if (std::uint8_t(bytes[at]) != 0xff || (isInPicture && mark == 0x00)) {
            if (!isInPicture)
                return jpeg;
            ++at;
            continue;
        }
        if (mark == 0xff) { // fills
            ++at;
            continue;
        }
        if (mark >= 0xd0 && mark <= 0xd9) {
            jpeg.isWhole = mark == 0xd9;
            if (jpeg.isWhole)
                return jpeg;
            at += 2;
            continue;
        }
        if (at + 9 > bytes.size())
            return jpeg;
        const bool isFrame = mark >= 0xc0 && mark <= 0xcf && mark != 0xc4 && mark != 0xc8
                             && mark != 0xcc; // tables and extensions
        if (isFrame)
            jpeg.size =
                PictureSize{int(wholeNumber(bytes, at + 7, 2)), int(wholeNumber(bytes, at + 5, 2))};
        isInPicture = mark == 0xda;
        at += 2 + std::max<std::size_t>(wholeNumber(bytes, at + 2, 2), 2);
    }
    return jpeg;
}

// One of two numbers of a particle, by particle.
using Spots = std::map<Id, Eigen::Vector2d>;

struct Metres // for one of u and of v
{
    double u = 1.0;
    double v = 1.0;
};

class Fabric // of one material in one part
{
public:
    Fabric(const Part& part, Id material)
    {
        bool isPrinted = false;
        for (const Panel& panel : part.panels) {
            if (panel.material != material)
                continue;
            const Particle* const a = findRow(part.particles, panel.a);
            const Particle* const b = findRow(part.particles, panel.b);
            const Particle* const c = findRow(part.particles, panel.c);
            if (!a || !b || !c)
                continue;
            m_panels.push_back({a, b, c});
            for (const Particle* corner : m_panels.back()) {
                isPrinted |= corner->textureU != 0.0 || corner->textureV != 0.0;
                m_spots[corner->id] = {corner->textureU, corner->textureV};
            }
        }
        if (!isPrinted)
            layOverBox();
    }

    const Spots& spots() const { return m_spots; }

    // Means over the panels by area, of how far one goes on the cloth while u or v goes by 1.
    Metres metres() const
    {
        Metres sum{0.0, 0.0};
        double whole = 0.0;
        for (const auto& [a, b, c] : m_panels) {
            const Eigen::Vector2d ab = m_spots.at(b->id) - m_spots.at(a->id);
            const Eigen::Vector2d ac = m_spots.at(c->id) - m_spots.at(a->id);
            const double turn = ab.x() * ac.y() - ab.y() * ac.x();
            const Vec3 p = b->position - a->position, q = c->position - a->position;
            const double area = p.cross(q).norm();
            if (std::abs(turn) < 1e-12 || !(area > 0.0))
                continue;
            sum.u += area * ((ac.y() * p - ab.y() * q) / turn).norm();
            sum.v += area * ((ab.x() * q - ac.x() * p) / turn).norm();
            whole += area;
        }
        return whole > 0.0 ? Metres{sum.u / whole, sum.v / whole} : Metres{};
    }

private:
    void layOverBox()
    {
        Eigen::AlignedBox3d box;
        for (const auto& corners : m_panels)
            for (const Particle* corner : corners)
                box.extend(corner->position);
        if (box.isEmpty())
            return;
        Eigen::Index least = 0;
        box.sizes().minCoeff(&least);
        const Eigen::Index across = least == 0 ? 2 : 0, up = least == 1 ? 2 : 1;
        const auto share = [&box](const Vec3& place, Eigen::Index axis) {
            const double size = box.sizes()[axis];
            return size > 0.0 ? (place[axis] - box.min()[axis]) / size : 0.0;
        };
        for (const auto& corners : m_panels)
            for (const Particle* corner : corners)
                m_spots[corner->id] = {share(corner->position, across),
                                       share(corner->position, up)};
    }

    std::vector<std::array<const Particle*, 3>> m_panels;
    Spots m_spots;
};

} // namespace

Result<PictureSize> pictureSize(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::error_code error;
    const std::uintmax_t length = fs::file_size(file, error);
    if (!in || error)
        return Failure("%1 cannot be read: check the path.", file.string());
    if (length > mostBytes)
        return Failure("%1 has more than 256 MiB: make it smaller.", file.string());
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::optional<PictureSize> size;
    bool isWhole = true;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.size() >= 24) {
        size = PictureSize{int(wholeNumber(bytes, 16, 4)), int(wholeNumber(bytes, 20, 4))};
        isWhole = isWholePng(bytes);
    } else if (bytes.starts_with("\xff\xd8")) {
        const Jpeg jpeg = readJpeg(bytes);
        size = jpeg.size;
        isWhole = jpeg.isWhole;
    }
    if (!size || size->width <= 0 || size->height <= 0)
        return Failure("%1 is neither a PNG nor a JPEG: save the picture as one of these.",
                       file.string());
    if (double(size->width) * size->height > mostPixels)
        return Failure("%1 has %2 x %3 pixels: make it smaller, of 64 million at most.",
                       file.string(), size->width, size->height);
    if (!isWhole)
        return Failure("%1 is cut off or damaged: save or copy the picture again.", file.string());
    return *size;
}

std::optional<Message> pictureWarning(const Scene& scene, const Material& material)
{
    if (material.picture.empty())
        return std::nullopt;
    const auto size = pictureSize(placeOfFile(scene.folder.path, material.picture));
    if (size)
        return std::nullopt;
    return Message("Material %1 is drawn without its picture: %2", material.name, size.message());
}

std::vector<PrintedPoint> printedPoints(const Scene& scene, Id id)
{
    const Material* material = findItem<Material>(scene, id);
    if (!material || material->picture.empty())
        return {};
    const auto size = pictureSize(placeOfFile(scene.folder.path, material->picture));
    if (!size)
        return {};
    const double angle = material->pictureTurn * std::numbers::pi / 180.0;
    const Eigen::Rotation2Dd back(-angle);
    const Eigen::Vector2d middle(0.5, 0.5);
    const Eigen::Vector2d moved(material->pictureRight, material->pictureUp);
    const double tall = double(size->height) / size->width; // over its width

    std::vector<PrintedPoint> points;
    forEachPart(scene, [&](Id, const Part& part) {
        const Fabric fabric(part, id);
        const Metres metres = fabric.metres();
        // pictures are turned on the cloth, not where u is short and v long
        const double width = material->pictureWidth > 0.0 ? material->pictureWidth : metres.u;
        const double height = material->pictureWidth > 0.0 ? tall * width : metres.v;
        for (const auto& [particle, spot] : fabric.spots()) {
            const Eigen::Vector2d off(spot - middle); // from the middle of the fabric
            const Eigen::Vector2d away(off.x() * metres.u - moved.x() * width,
                                       off.y() * metres.v - moved.y() * height);
            const Eigen::Vector2d place = back * away; // m, from the middle of the picture
            points.push_back(
                {std::uint32_t(particle), {place.x() / width + 0.5, place.y() / height + 0.5}});
        }
    });
    std::ranges::sort(points, {}, &PrintedPoint::particle);
    return points;
}

} // namespace ripstop
