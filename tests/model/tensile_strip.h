// Strips of fabric that panels carry, as a tensile test has them, for tests of how panels tear.
//
// A strip hangs by its upper edge and is drawn by a load on the lower one. With a Poisson's ratio
// of 0 each of its threads along the load has the same pull W / b under the weight W, b being its
// width.
#pragma once

#include "scene/scene.h"
#include "system/system.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <Eigen/Geometry>

namespace ripstop {

inline constexpr double width = 0.2;     // m
inline constexpr double length = 0.4;    // m
inline constexpr double stiffness = 1e4; // N/m, of both threads

struct StripMesh
{
    int across = 4;
    int along = 8;
    bool leansRight = false; // every diagonal; else they alternate
    double skew = 0.0; // 1, of a cell: rows inside are moved, so that no panel is like another
};

struct Strip
{
    Scene scene;
    Id material{};

    Material& cloth()
    {
        for (Entry& entry : scene.items)
            if (entry.id == material)
                return std::get<Material>(entry.item);
        std::abort();
    }
};

// A strip in the plane z = 0 without weight of its own that counts; its lower edge weighs
// `load` / g in all, shared as the widths beside the particles are.
//   grain  degrees, of the warp from the length of the strip
inline Strip strip(const StripMesh& mesh, double grain, double load)
{
    Strip made;
    Scene& scene = made.scene;
    made.material = takeId(scene);
    Material cloth;
    cloth.name = "cloth";
    cloth.membraneStiffness = stiffness;
    cloth.shearStiffness = 0.3 * stiffness;
    cloth.poissonRatio = 0.0;
    cloth.dampingTime = 0.02;
    cloth.airLaw = AirLaw::None;
    scene.items.push_back({made.material, cloth});
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 20.0;
    const Id id = takeId(scene);
    Part part;
    part.name = "strip";
    part.carrier = FabricKind::Panels;
    for (int row = 0; row <= mesh.along; ++row)
        for (int column = 0; column <= mesh.across; ++column) {
            const bool isInside = row > 0 && row < mesh.along && column > 0 && column < mesh.across;
            const double shift =
                isInside ? mesh.skew * std::sin(3.0 * row + 5.0 * column) / mesh.across : 0.0;
            Particle particle;
            particle.id = takeId(scene);
            particle.position = {width * (double(column) / mesh.across + shift),
                                 -length * row / mesh.along, 0.0};
            particle.pinned = row == 0;
            const double share =
                (column == 0 || column == mesh.across ? 0.5 : 1.0) / double(mesh.across);
            particle.mass =
                row == mesh.along ? std::max(share * load / standardGravity, 1e-6) : 1e-6;
            part.particles.push_back(particle);
        }
    const auto cover = [&](int a, int b, int c) {
        Panel panel;
        panel.id = takeId(scene);
        panel.a = part.particles[std::size_t(a)].id;
        panel.b = part.particles[std::size_t(b)].id;
        panel.c = part.particles[std::size_t(c)].id;
        panel.material = made.material;
        // the warp is turned from down, the length, towards x
        const Vec3 ab =
            part.particles[std::size_t(b)].position - part.particles[std::size_t(a)].position;
        const Vec3 ac =
            part.particles[std::size_t(c)].position - part.particles[std::size_t(a)].position;
        const double turned = std::atan2(ab.y(), ab.x());
        const double sense = ab.cross(ac).z() < 0.0 ? -1.0 : 1.0;
        const double wanted = (grain - 90.0) * std::numbers::pi / 180.0;
        double degrees = sense * (wanted - turned) * 180.0 / std::numbers::pi;
        while (degrees < 0.0)
            degrees += 180.0;
        while (degrees >= 180.0)
            degrees -= 180.0;
        panel.grain = degrees;
        part.panels.push_back(panel);
    };
    const auto at = [&](int row, int column) { return row * (mesh.across + 1) + column; };
    for (int row = 0; row < mesh.along; ++row)
        for (int column = 0; column < mesh.across; ++column) {
            const int a = at(row, column), b = at(row, column + 1);
            const int c = at(row + 1, column), d = at(row + 1, column + 1);
            if (mesh.leansRight || (row + column) % 2 == 0) {
                cover(a, c, d);
                cover(a, d, b);
            } else {
                cover(a, c, b);
                cover(b, c, d);
            }
        }
    scene.items.push_back({id, part});
    return made;
}

inline constexpr StripMesh coarse{2, 3, false, 0.0};
inline constexpr StripMesh fine{6, 10, false, 0.0};
inline constexpr StripMesh leaning{5, 7, true, 0.0};
inline constexpr StripMesh skewed{5, 9, true, 0.12};

inline int goneIn(const State& state)
{
    return int(std::count(state.panelGone.begin(), state.panelGone.end(), 1));
}

// A sheet with a notch amid it, between two edges of which the lower one is drawn down.
inline Strip notched(TearMesh tearMesh)
{
    const StripMesh mesh{12, 12, false, 0.0};
    Strip made = strip(mesh, 0.0, 0.0);
    Scene& scene = made.scene;
    scene.settings.gravity = Vec3::Zero();
    scene.settings.tearMesh = tearMesh;
    made.cloth().dampingTime = 7.7e-4; // s, of kite cloth
    Material held = made.cloth();      // what the jaws press on tears nowhere: their corners cut
    held.name = "in the jaws";
    const Id jaws = takeId(scene);
    scene.items.push_back({jaws, held});
    made.cloth().tearRule = TearRule::Tension;
    made.cloth().tearLimit = 300.0;
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item)) {
            std::vector<Id> lower;
            for (int column = 0; column <= mesh.across; ++column) {
                Particle& particle =
                    part->particles[std::size_t(mesh.along * (mesh.across + 1) + column)];
                particle.pinned = true;
                lower.push_back(particle.id);
            }
            for (Particle& particle : part->particles)
                particle.mass = 1e-4;
            const auto middleOf = [&](const Panel& panel) -> Vec3 {
                const auto place = [&](Id id) -> Vec3 {
                    return std::ranges::find(part->particles, id, &Particle::id)->position;
                };
                return (place(panel.a) + place(panel.b) + place(panel.c)) / 3.0;
            };
            for (Panel& panel : part->panels)
                if (std::abs(middleOf(panel).y() + 0.5 * length) > 0.33 * length)
                    panel.material = jaws;
            std::erase_if(part->panels, [&](const Panel& panel) { // the notch, a cell high
                const Vec3 middle = middleOf(panel);
                return std::abs(middle.x() - 0.5 * width) < 0.15 * width
                       && middle.y() < -0.5 * length
                       && middle.y() > -0.5 * length * (1.0 + 2.0 / mesh.along);
            });
            Control control;
            control.name = "jaw";
            control.kind = ControlKind::Move;
            control.targets = lower;
            control.axis = {0.0, -1.0, 0.0};
            control.limit = 0.1;
            control.automaticRate = 0.02;
            scene.items.push_back({takeId(scene), control});
            break;
        }
    return made;
}

} // namespace ripstop
