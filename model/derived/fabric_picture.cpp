// printedPoints() lays u and v over the panels of each part in turn, finds how many metres they
// are, and takes each particle through the place of the material.
#include "derived/fabric_picture.h"

#include "shapes/shape_files.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ripstop {
namespace {

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

std::filesystem::path placeOfPicture(const Scene& scene, const Material& material)
{
    return placeOfFile(scene.folder.path, material.picture);
}

std::optional<Message> pictureWarning(const Scene& scene, const Material& material)
{
    if (material.picture.empty())
        return std::nullopt;
    const auto size = pictureSize(placeOfPicture(scene, material));
    if (size)
        return std::nullopt;
    return Message("Material %1 is drawn without its picture: %2", material.name, size.message());
}

std::vector<PrintedPoint> printedPoints(const Scene& scene, Id id)
{
    const Material* material = findItem<Material>(scene, id);
    if (!material || material->picture.empty())
        return {};
    const auto size = pictureSize(placeOfPicture(scene, *material));
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
