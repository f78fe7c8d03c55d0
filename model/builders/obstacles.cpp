// Obstacles: a box, a sphere, a cylinder or hills that stand on the ground, for designs to land on,
// to drape over and to fly along.
#include "builders/designs.h"
#include "builders/network.h"

#include <array>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// clang-format off
constexpr Parameter boxParameters[]{
    {"width",     "m",   1,    0.01, 1000, false, "Along x, as seen from the front from left to right.", "Size"},
    {"height",    "m",   1,    0.01, 1000, false, "Along y."},
    {"depth",     "m",   1,    0.01, 1000, false, "Along z."},
    {"turn",      "deg", 0,    -180, 180,  false, "About the vertical."},
    {"clearance", "m",   0,    0,    1000, false, "Between the ground and the underside."},
    {"friction",  "",    0.3,  0,    2,    false, "Coefficient of friction of what slides on it.", "Contact"},
    {"restitution", "",  0,    0,    1,    false, "Share of the speed that what hits it keeps; 0 does not bounce."},
};
constexpr Parameter sphereParameters[]{
    {"radius",    "m",   0.5,  0.01, 500,  false, "Of the sphere.", "Size"},
    {"clearance", "m",   0,    0,    1000, false, "Between the ground and the underside."},
    {"friction",  "",    0.3,  0,    2,    false, "Coefficient of friction of what slides on it.", "Contact"},
    {"restitution", "",  0,    0,    1,    false, "Share of the speed that what hits it keeps; 0 does not bounce."},
};
constexpr Parameter cylinderParameters[]{
    {"radius",    "m",   0.25, 0.01, 500,  false, "Of the cylinder.", "Size"},
    {"length",    "m",   1,    0.01, 1000, false, "From cap to cap."},
    {"tilt",      "deg", 0,    0,    90,   false, "Of the axis from the vertical; 90 lays it along z."},
    {"clearance", "m",   0,    0,    1000, false, "Between the ground and the underside."},
    {"friction",  "",    0.3,  0,    2,    false, "Coefficient of friction of what slides on it.", "Contact"},
    {"restitution", "",  0,    0,    1,    false, "Share of the speed that what hits it keeps; 0 does not bounce."},
};
constexpr Parameter hillsParameters[]{
    {"width",     "m",   100,  1,    10000, false, "Of the field along x.", "Size"},
    {"depth",     "m",   100,  1,    10000, false, "Of the field along z."},
    {"height",    "m",   8,    0.01, 2000, false, "From the lowest valley to the highest top."},
    {"length",    "",    0.25, 0.02, 1,    false, "From hill to hill, over the width of the field."},
    {"grid",      "",    128,  8,    1024, true,  "Points along each side."},
    {"seed",      "",    1,    1,    1e6,  true,  "Another number, other hills."},
    {"friction",  "",    0.5,  0,    2,    false, "Coefficient of friction of what slides on it.", "Contact"},
};
// clang-format on

Scene obstacleScene(const Collider& collider, const char* title)
{
    Scene scene;
    scene.settings.title = title;
    addGround(scene);
    addItem(scene, collider);
    return scene;
}

Result<Scene> buildBox(const Parameters& p)
{
    Collider box;
    box.name = "box";
    box.shape = ColliderShape::Box;
    box.size = Vec3(p.at("width"), p.at("height"), p.at("depth"));
    box.position.y() = p.at("clearance") + 0.5 * p.at("height");
    box.turn.y() = p.at("turn");
    box.friction = p.at("friction");
    box.restitution = p.at("restitution");
    return obstacleScene(box, "Box");
}

Result<Scene> buildSphere(const Parameters& p)
{
    Collider sphere;
    sphere.name = "sphere";
    sphere.shape = ColliderShape::Sphere;
    sphere.radius = p.at("radius");
    sphere.position.y() = p.at("clearance") + p.at("radius");
    sphere.friction = p.at("friction");
    sphere.restitution = p.at("restitution");
    return obstacleScene(sphere, "Sphere");
}

Result<Scene> buildCylinder(const Parameters& p)
{
    Collider cylinder;
    cylinder.name = "cylinder";
    cylinder.shape = ColliderShape::Cylinder;
    cylinder.radius = p.at("radius");
    cylinder.size = Vec3(2.0 * p.at("radius"), p.at("length"), 2.0 * p.at("radius"));
    cylinder.turn.x() = p.at("tilt");
    const double tilt = p.at("tilt") * (std::numbers::pi / 180.0);
    cylinder.position.y() =
        p.at("clearance") + p.at("radius") * std::sin(tilt) + 0.5 * p.at("length") * std::cos(tilt);
    cylinder.friction = p.at("friction");
    cylinder.restitution = p.at("restitution");
    return obstacleScene(cylinder, "Cylinder");
}

Result<Scene> buildHills(const Parameters& p)
{
    Collider hills;
    hills.name = "hills";
    hills.shape = ColliderShape::HeightField;
    hills.size = Vec3(p.at("width"), p.at("height"), p.at("depth"));
    hills.hillLength = p.at("length");
    hills.grid = int(p.at("grid"));
    hills.seed = int(p.at("seed"));
    hills.friction = p.at("friction");
    return obstacleScene(hills, "Hills");
}

} // namespace

std::span<const Builder> obstacleBuilders()
{
    static constexpr std::array rows{
        Builder{"box", "Box", "A box on the ground that cloth lies on and lines bend round.",
                boxParameters, buildBox, Family::Obstacles},
        Builder{"sphere", "Sphere", "A sphere on the ground that cloth drapes over.",
                sphereParameters, buildSphere, Family::Obstacles},
        Builder{"cylinder", "Cylinder",
                "A cylinder on the ground, upright or lying, that cloth drapes over.",
                cylinderParameters, buildCylinder, Family::Obstacles},
        Builder{"hills", "Hills", "Rolling ground to soar along and to land on.", hillsParameters,
                buildHills, Family::Obstacles}};
    return rows;
}

} // namespace ripstop
