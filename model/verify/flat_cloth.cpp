// Networks of cells and of rings, the cloths of the cases, and the scene that one of them makes.
// The warp is laid by texture: v runs along it.
#include "verify/flat_cloth.h"

#include "verify/small_systems.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using Polygon = std::vector<Vec3>; // convex

// What a half of the plane leaves of it: that in which `inside`, linear, is positive.
template <typename Inside>
Polygon clipped(const Polygon& polygon, const Inside& inside)
{
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const double here = inside(from), there = inside(to);
        if (here >= 0.0)
            left.push_back(from);
        if (here * there < 0.0)
            left.push_back(from + here / (here - there) * (to - from));
    }
    return left;
}

// The place of a point among those of a cloth, new or there already.
int placeOf(FlatCloth& cloth, const Vec3& point)
{
    const auto found = std::ranges::find_if(
        cloth.place, [&](const Vec3& other) { return (other - point).norm() < 1e-6; });
    const int place = int(found - cloth.place.begin());
    if (found == cloth.place.end())
        cloth.place.push_back(point);
    return place;
}

} // namespace

FlatCloth rectangle(double length, double width, int along, int across, Parted parted)
{
    FlatCloth cloth;
    for (int row = 0; row <= across; ++row)
        for (int column = 0; column <= along; ++column)
            cloth.place.emplace_back(length * column / along, width * row / across, 0.0);
    const auto at = [&](int row, int column) { return row * (along + 1) + column; };
    for (int row = 0; row < across; ++row)
        for (int column = 0; column < along; ++column) {
            const int a = at(row, column), b = at(row, column + 1);
            const int c = at(row + 1, column + 1), d = at(row + 1, column);
            auto& triangles = cloth.triangles;
            if (parted == Parted::Crosswise) {
                const int middle = int(cloth.place.size());
                cloth.place.push_back(
                    0.5 * (cloth.place[std::size_t(a)] + cloth.place[std::size_t(c)]));
                triangles.insert(triangles.end(),
                                 {{middle, a, b}, {middle, b, c}, {middle, c, d}, {middle, d, a}});
            } else if (parted == Parted::Falling
                       || (parted == Parted::ByTurns && (row + column) % 2 != 0)) {
                triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
            } else {
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            }
        }
    return cloth;
}

FlatCloth turnedRectangle(double length, double width, double cell, double degrees)
{
    FlatCloth cloth;
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 along = cell * Vec3(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across(-along.y(), along.x(), 0.0);
    const Vec3 middle(0.5 * length, 0.5 * width, 0.0);
    const int far = int(std::ceil(middle.norm() / cell)) + 1;
    for (int i = -far; i < far; ++i)
        for (int j = -far; j < far; ++j) {
            const Vec3 corner = middle + double(i) * along + double(j) * across;
            Polygon left{corner, corner + along, corner + along + across, corner + across};
            left = clipped(left, [](const Vec3& at) { return at.x(); });
            left = clipped(left, [=](const Vec3& at) { return length - at.x(); });
            left = clipped(left, [](const Vec3& at) { return at.y(); });
            left = clipped(left, [=](const Vec3& at) { return width - at.y(); });
            Vec3 sum = Vec3::Zero();
            std::vector<int> rim;
            for (const Vec3& point : left) {
                sum += point;
                if (const int place = placeOf(cloth, point);
                    std::ranges::find(rim, place) == rim.end())
                    rim.push_back(place);
            }
            if (rim.size() < 3)
                continue;
            const int centre = int(cloth.place.size());
            cloth.place.push_back(sum / double(left.size()));
            for (std::size_t k = 0; k < rim.size(); ++k)
                cloth.triangles.push_back({centre, rim[k], rim[(k + 1) % rim.size()]});
        }
    return cloth;
}

FlatCloth disc(double radius, int rings)
{
    FlatCloth cloth{{Vec3::Zero()}, {}};
    const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < 6 * ring; ++i) {
            const double angle = std::numbers::pi * i / (3.0 * ring);
            cloth.place.push_back(radius * ring / rings
                                  * Vec3(std::cos(angle), std::sin(angle), 0.0));
        }
    for (int ring = 1; ring <= rings; ++ring)
        for (int side = 0; side < 6; ++side) {
            const auto outer = [&](int i) { return first(ring) + (side * ring + i) % (6 * ring); };
            const auto inner = [&](int i) {
                return ring == 1 ? 0 : first(ring - 1) + (side * (ring - 1) + i) % (6 * (ring - 1));
            };
            for (int i = 0; i < ring; ++i)
                cloth.triangles.push_back({inner(i), outer(i), outer(i + 1)});
            for (int i = 0; i + 1 < ring; ++i)
                cloth.triangles.push_back({inner(i), outer(i + 1), inner(i + 1)});
        }
    return cloth;
}

Material woven(double warp, double weft, double poisson, double shear)
{
    Material material;
    material.membraneStiffness = warp;
    material.weftStiffness = weft;
    material.poissonRatio = poisson;
    material.shearStiffness = shear;
    return material;
}

Material clothA() { return woven(40e3, 25e3, 0.2, 1.2e3); }
Material isotropic(double stiffness, double poisson)
{
    return woven(stiffness, stiffness, poisson, stiffness / (2.0 * (1.0 + poisson)));
}

Scene sceneOf(const FlatCloth& cloth, const Material& material, double warp, double density)
{
    Scene scene;
    scene.settings.airDensity = 0.0;
    scene.settings.gravity = Vec3::Zero();
    scene.settings.viscosity = 20.0;
    const double angle = warp * std::numbers::pi / 180.0;
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across(along.y(), -along.x(), 0.0);
    const Id made = addItem(scene, material);
    Network network(scene, "cloth");
    std::vector<Id> ids;
    for (const Vec3& place : cloth.place) {
        ids.push_back(network.particle(place));
        network.texture(ids.back(), place.dot(across), place.dot(along));
    }
    for (const auto& [a, b, c] : cloth.triangles)
        network.panel(ids[std::size_t(a)], ids[std::size_t(b)], ids[std::size_t(c)], made);
    network.addFabricMass(density);
    network.carryByPanels();
    network.finish({}, {});
    return scene;
}

std::vector<Particle>& particlesOf(Scene& scene)
{
    return std::get<Part>(scene.items.back().item).particles;
}

std::vector<OfEdge> edgeOf(const FlatCloth& cloth, int across, double at)
{
    std::vector<OfEdge> found;
    for (std::size_t i = 0; i < cloth.place.size(); ++i)
        if (std::abs(cloth.place[i][across] - at) < 1e-9)
            found.push_back({i, 0.0});
    const auto along = [&](const OfEdge& one) { return cloth.place[one.particle][1 - across]; };
    std::ranges::sort(found, {}, along);
    const double length = along(found.back()) - along(found.front());
    for (std::size_t k = 0; k + 1 < found.size(); ++k) {
        const double half = 0.5 * (along(found[k + 1]) - along(found[k])) / length;
        found[k].share += half;
        found[k + 1].share += half;
    }
    return found;
}

Scene hungByRollers(const FlatCloth& cloth, const Material& material, double warp, double load)
{
    Scene scene = sceneOf(cloth, material, warp);
    scene.settings.gravity = Vec3(standardGravity, 0.0, 0.0);
    std::vector<Particle>& particles = particlesOf(scene);
    double lowest = 0.0;
    for (const Vec3& place : cloth.place)
        lowest = std::max(lowest, place.x());
    const auto upper = edgeOf(cloth, 0, 0.0);
    for (const OfEdge& one : upper) {
        particles[one.particle].guide = Guide::Line;
        particles[one.particle].guideAxis = Vec3::UnitY();
    }
    particles[upper[upper.size() / 2].particle].pinned = true;
    for (const auto& [i, share] : edgeOf(cloth, 0, lowest))
        particles[i].mass += share * load / standardGravity;
    return scene;
}

} // namespace ripstop
