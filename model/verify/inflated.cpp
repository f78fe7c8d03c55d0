// Cloth that air under pressure fills, against closed and published answers, each on two meshes and
// with everything else as a new scene has it.
//
// In order: a sphere (RF-9); a closed tube (RF-10) and how it bends until it collapses (RF-11); a
// square in its frame (RF-14) and the airbag of two squares (RF-15).
//
// Wind blows into an opening that is the mouth of a canopy and lets nothing through. The air inside
// comes to rest and has the wind's dynamic pressure, across each panel as it lies at that moment. A
// plane of symmetry closes the rest: the particles of the mouth slide in it. Viscosity, which
// changes nothing of where it ends, brings all to rest.
//
// Panels have Green's strain and pull in proportion to it; a sphere and a tube that grow by s have
// that much more to hold.
#include "verify/at_rest.h"
#include "verify/flat_cloth.h"
#include "verify/sections.h"
#include "verify/small_systems.h"
#include "verify/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;

// Air under this pressure, Pa, comes in along z. This is the last that is done to a scene.
void fill(Scene& scene, double pressure)
{
    for (Entry& entry : scene.items)
        if (auto* material = std::get_if<Material>(&entry.item))
            material->normalCoefficient = material->skinFriction = 0.0; // of wind that flows past
    Part& part = std::get<Part>(scene.items.back().item);
    part.canopyPressure = 1.0;
    part.addedMass = 0.0;
    scene.settings.airDensity = airDensity;
    addWind(scene, std::sqrt(2.0 * pressure / scene.settings.airDensity) * Vec3::UnitZ());
}

void guide(Particle& particle, Guide by, const Vec3& axis)
{
    particle.guide = by;
    particle.guideAxis = axis;
}

// --- the sphere -------------------------------------------------------------------------------

// Over the plane z = 0, its rim in it.
FlatCloth hemisphere(double radius, int rings)
{
    FlatCloth cloth = disc(1.0, rings);
    for (Vec3& place : cloth.place) {
        const double angle = 0.5 * pi * place.norm();
        place =
            radius * (std::sin(angle) * place.stableNormalized() + std::cos(angle) * Vec3::UnitZ());
    }
    return cloth;
}

struct Sphere
{
    double stretch = 0.0; // 1
    double pull = 0.0;    // N/m, per width as it is now
};

constexpr double sphereRadius = 0.5, spherePressure = 2000.0; // m, Pa

Sphere blownSphere(int rings)
{
    const FlatCloth cloth = hemisphere(sphereRadius, rings);
    Scene scene = sceneOf(cloth, isotropic(40e3, 0.3), 0.0);
    for (Particle& particle : particlesOf(scene))
        if (particle.position.z() < 1e-9)
            guide(particle, Guide::Line, particle.position.normalized());
    fill(scene, spherePressure);
    const AtRest rest = restOf(scene, 0.5);
    Sphere sphere;
    for (const Vec3& position : rest.state.position)
        sphere.stretch += position.norm() / sphereRadius / double(cloth.place.size());
    // stretched alike in all directions, it pulls per new width as it does by Piola and Kirchhoff
    sphere.pull = rest.mean([](const Vec3& t, const Vec3&) { return 0.5 * (t[0] + t[1]); });
    return sphere;
}

void addSpheres(std::vector<Case>& cases)
{
    // p R s / 2 = E t (s^2 - 1) / (2 (1 - nu))
    const double share = 0.5 * spherePressure * sphereRadius * (1.0 - 0.3) / 40e3;
    const double stretch = share + std::sqrt(1.0 + share * share);
    for (const int rings : {10, 16}) {
        const auto sphere = shared([=] { return blownSphere(rings); });
        const std::string title =
            "sphere of 0.5 m under 2 kPa, " + std::to_string(rings) + " rings, ";
        cases.push_back({"RF-9", title + "strain", stretch - 1.0, relative(0.01), "",
                         "p R s / 2 = E t (s^2 - 1) / (2 (1 - nu))",
                         [=] { return sphere().stretch - 1.0; }});
        cases.push_back({"RF-9", title + "pull", 0.5 * spherePressure * sphereRadius * stretch,
                         relative(0.01), "N/m", "p R s / 2", [=] { return sphere().pull; }});
    }
}

// --- the tube ---------------------------------------------------------------------------------

constexpr double tubeRadius = 0.09, tubePressure = 30e3;   // m, Pa
constexpr double tubeStiffness = 170e3, tubePoisson = 0.3; // N/m, 1

// Goes on below the rim of a cloth, the last of its particles, by rows of triangles with sides
// alike, down to z = 0.
void addTube(FlatCloth& cloth, double length, int around)
{
    const int rows = int(std::lround(length * around / (2.0 * pi * tubeRadius * std::sqrt(0.75))));
    for (int row = 1; row <= rows; ++row) {
        const int lower = int(cloth.place.size()), upper = lower - around;
        for (int i = 0; i < around; ++i) {
            const double angle = 2.0 * pi * (i + 0.5 * (row % 2)) / around;
            cloth.place.emplace_back(tubeRadius * std::cos(angle), tubeRadius * std::sin(angle),
                                     length * (rows - row) / rows);
            const int next = (i + 1) % around;
            if (row % 2 != 0)
                cloth.triangles.insert(cloth.triangles.end(),
                                       {{upper + i, upper + next, lower + i},
                                        {lower + i, upper + next, lower + next}});
            else
                cloth.triangles.insert(cloth.triangles.end(),
                                       {{upper + i, lower + i, lower + next},
                                        {upper + i, lower + next, upper + next}});
        }
    }
}

struct Tube
{
    double around = 0.0, along = 0.0; // 1, strains
};

// Half of a closed tube 0.54 m long, whose ends are half spheres.
Tube blownTube(int rings)
{
    constexpr double length = 0.27; // m
    FlatCloth cloth = hemisphere(tubeRadius, rings);
    for (Vec3& place : cloth.place)
        place.z() += length;
    addTube(cloth, length, 6 * rings);
    Scene scene = sceneOf(cloth, isotropic(tubeStiffness, tubePoisson), 0.0);
    for (Particle& particle : particlesOf(scene))
        if (particle.position.z() < 1e-9)
            guide(particle, Guide::Line, particle.position.normalized());
    fill(scene, tubePressure);
    const AtRest rest = restOf(scene, 0.5);
    // of what is farther than a radius and a half from the ends
    Tube tube;
    double count = 0.0, below = 0.0, above = 0.0;
    for (std::size_t i = 0; i < cloth.place.size(); ++i) {
        const Vec3 from = cloth.place[i], to = rest.state.position[i];
        if (from.z() > 0.5 * length)
            continue;
        count += 1.0;
        tube.around += std::hypot(to.x(), to.y()) / tubeRadius - 1.0;
        below += from.z();
        above += to.z();
    }
    tube.around /= count;
    tube.along = above / below - 1.0;
    return tube;
}

// Per flat width it has S1 = p R s2 around and S2 = p R s1^2 / (2 s2) along.
Tube knownTube(double stiffness)
{
    double around = 1.0, along = 1.0; // stretches
    for (int i = 0; i < 100; ++i) {
        const double hoop = tubePressure * tubeRadius * along;
        const double axial = 0.5 * tubePressure * tubeRadius * around * around / along;
        around = std::sqrt(1.0 + 2.0 * (hoop - tubePoisson * axial) / stiffness);
        along = std::sqrt(1.0 + 2.0 * (axial - tubePoisson * hoop) / stiffness);
    }
    return {around - 1.0, along - 1.0};
}

void addTubes(std::vector<Case>& cases)
{
    const Tube known = knownTube(tubeStiffness);
    for (const int rings : {4, 8}) {
        const auto tube = shared([=] { return blownTube(rings); });
        const std::string title =
            "closed tube under 30 kPa, " + std::to_string(6 * rings) + " panels around, strain ";
        cases.push_back({"RF-10", title + "around", known.around, relative(0.015), "",
                         "p R around, p R / 2 along", [=] { return tube().around; }});
        cases.push_back({"RF-10", title + "along", known.along, relative(0.015), "",
                         "p R around, p R / 2 along", [=] { return tube().along; }});
    }
}

// --- the tube bends ---------------------------------------------------------------------------

struct BentTube
{
    double moment = 0.0;   // N m
    double wrinkled = 0.0; // 1, of the panels
};

// A stretch of tube between two planes that are turned against each other by a curvature, 1/m,
// times its length. Its ends slide in them. A lid that air presses on and that pulls at nothing
// closes the far one.
BentTube bentTube(double curvature, int around, double stiffness)
{
    constexpr double length = 2.0 * tubeRadius;
    FlatCloth cloth;
    for (int i = 0; i < around; ++i) {
        const double angle = 2.0 * pi * i / around;
        cloth.place.emplace_back(tubeRadius * std::cos(angle), tubeRadius * std::sin(angle),
                                 length);
    }
    addTube(cloth, length, around);
    const std::size_t walls = cloth.triangles.size(), hub = cloth.place.size();
    cloth.place.push_back(length * Vec3::UnitZ());
    for (int i = 0; i < around; ++i)
        cloth.triangles.push_back({int(hub), i, (i + 1) % around});

    Scene scene = sceneOf(cloth, isotropic(stiffness, tubePoisson), 0.0);
    scene.settings.viscosity = 60.0;
    Part part = std::get<Part>(scene.items.back().item);
    scene.items.pop_back();
    const Id lid = addItem(scene, Material());
    for (std::size_t i = walls; i < part.panels.size(); ++i)
        part.panels[i].material = lid;
    for (Particle& particle : part.particles) {
        const double z = particle.position.z(), turn = curvature * z;
        const double radius = 1.0 / curvature - particle.position.x();
        particle.position.x() = 1.0 / curvature - radius * std::cos(turn);
        particle.position.z() = radius * std::sin(turn);
        if (z < 1e-9 || z > length - 1e-9)
            guide(particle, Guide::Plane, {std::sin(turn), 0.0, std::cos(turn)});
    }
    part.particles[hub].pinned = true;
    addItem(scene, part);
    fill(scene, tubePressure);
    const AtRest rest = restOf(scene, 0.6);

    Vec3 middle = Vec3::Zero(); // of the far end
    for (std::size_t i = 0; i < std::size_t(around); ++i)
        middle += rest.state.position[i] / around;
    std::vector<Vec3> way(cloth.place.size(), Vec3::Zero());
    for (std::size_t i = 0; i < std::size_t(around); ++i)
        way[i] = Vec3::UnitY().cross(rest.state.position[i] - middle);
    BentTube tube{rest.against(way), 0.0};
    for (const Membrane& membrane : rest.system->membranes) {
        const Corners corners = cornersOf(*rest.system, membrane, rest.state.position);
        if (lawOf(*rest.system, membrane).isElastic()
            && tensionIn(*rest.system, membrane, corners).state != ClothState::Taut)
            tube.wrinkled += 1.0 / double(walls);
    }
    return tube;
}

// Moment and curvature where it has wrinkled from the inside of the bend to an angle to either side
// (Comer and Levy 1963), at the radius that it has under pressure.
struct Wrinkled
{
    double moment, curvature; // N m, 1/m
};

Wrinkled wrinkledTo(double angle, double stiffness)
{
    const double radius = tubeRadius * (1.0 + knownTube(stiffness).around);
    const double rest = pi - angle;
    const double carries = 2.0 * (rest * std::cos(angle) + std::sin(angle));
    const double steepest =
        tubePressure * radius * pi / carries; // N/m, for each radius across the bend
    return {radius * radius * steepest * (rest + 0.5 * std::sin(2.0 * angle)),
            steepest / (stiffness * tubeRadius)};
}

void addBentTubes(std::vector<Case>& cases)
{
    const Wrinkled first = wrinkledTo(0.0, tubeStiffness);
    for (const int around : {24, 36}) {
        const std::string title =
            "tube under 30 kPa bends, " + std::to_string(around) + " panels around, ";
        const auto row = [&](const std::string& what, double expected, Tolerance tolerance,
                             const char* unit, auto measure) {
            cases.push_back(
                {"RF-11", title + what, expected, tolerance, unit, "Comer and Levy 1963", measure});
        };
        for (const double share : {0.5, 0.95, 1.05}) {
            const auto tube =
                shared([=] { return bentTube(share * first.curvature, around, tubeStiffness); });
            const std::string at =
                " at " + digits(share, 3) + " of the curvature of first wrinkles";
            if (share < 1.0) {
                row("moment" + at, share * first.moment, relative(0.05), "N m",
                    [=] { return tube().moment; });
                row("share of its panels in wrinkles" + at, 0.0, exactly, "",
                    [=] { return tube().wrinkled; });
            } else {
                row("share of its panels in wrinkles" + at, 1e-3, atLeast, "",
                    [=] { return tube().wrinkled; });
            }
        }
        const Wrinkled half = wrinkledTo(0.5 * pi, tubeStiffness);
        row("moment where wrinkles reach half around", half.moment, relative(0.05), "N m",
            [=] { return bentTube(half.curvature, around, tubeStiffness).moment; });
        // Far beyond, its walls pull so hard around the bend that its section goes flat and it
        // bears less again. Theory leaves that out; stiff cloth, which bends less, puts it off.
        const Wrinkled last = wrinkledTo(0.75 * pi, 10.0 * tubeStiffness);
        row("ten times as stiff, moment at 0.94 of that of collapse", last.moment, relative(0.05),
            "N m", [=] { return bentTube(last.curvature, around, 10.0 * tubeStiffness).moment; });
        const Wrinkled beyond = wrinkledTo(0.75 * pi, tubeStiffness);
        row("moment at 20.7 times the curvature of first wrinkles, where it has collapsed",
            half.moment, atMost, "N m",
            [=] { return bentTube(beyond.curvature, around, tubeStiffness).moment; });
    }
}

// --- squares ----------------------------------------------------------------------------------

// So that there is an inside.
void hollow(Scene& scene, double side, double depth)
{
    for (Particle& particle : particlesOf(scene)) {
        const Vec3 at = pi / side * particle.position;
        particle.position.z() = depth * std::sin(at.x()) * std::sin(at.y());
    }
}

bool isOnEdge(const Vec3& place, double side)
{
    const auto ends = [&](double x) { return x < 1e-9 || x > side - 1e-9; };
    return ends(place.x()) || ends(place.y());
}

// RF-14. Stretched to 1 m so far that it pulls with 100 N/m, of cloth so soft that the pressure
// adds next to nothing to that.
constexpr double squarePull = 100.0, squarePressure = 5.0, squareStiffness = 1000.0; // N/m, Pa

double blownSquare(int cells)
{
    const double stretch = std::sqrt(1.0 + 2.0 * squarePull / squareStiffness);
    const FlatCloth cloth =
        rectangle(1.0 / stretch, 1.0 / stretch, cells, cells, Parted::Crosswise);
    Scene scene = sceneOf(cloth, isotropic(squareStiffness, 0.0), 0.0);
    scene.settings.viscosity = 60.0;
    std::size_t middle = 0;
    std::vector<Particle>& particles = particlesOf(scene);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles[i].position *= stretch;
        particles[i].pinned = isOnEdge(particles[i].position, 1.0);
        if ((particles[i].position - Vec3(0.5, 0.5, 0.0)).norm() < 1e-9)
            middle = i;
    }
    hollow(scene, 1.0, 0.01);
    fill(scene, squarePressure);
    return restOf(scene, 0.8).state.position[middle].z();
}

double navier() // m, of a square of 1 m
{
    double sum = 0.0;
    for (int m = 1; m < 400; m += 2)
        for (int n = 1; n < 400; n += 2)
            sum += ((m + n) / 2 % 2 != 0 ? 1.0 : -1.0) / (double(m) * n * (m * m + n * n));
    return 16.0 / std::pow(pi, 4) * squarePressure / squarePull * sum;
}

// RF-15. Two squares of 1.2 m from corner to corner, joined at their edges; the upper one.
struct Airbag
{
    double rise = 0.0;    // m, of its middle
    double inwards = 0.0; // m, the middle of an edge
    double volume = 0.0;  // m^3, of both squares
    double pull = 0.0;    // N/m, at its middle
};

Airbag blownAirbag(int cells)
{
    const double side = 1.2 / std::sqrt(2.0);
    const FlatCloth cloth = rectangle(side, side, cells, cells, Parted::Crosswise);
    Scene scene = sceneOf(cloth, isotropic(352800.0, 0.4), 0.0);
    const Vec3 centre(0.5 * side, 0.5 * side, 0.0), edge(0.5 * side, 0.0, 0.0);
    std::size_t middle = 0, below = 0;
    std::vector<Particle>& particles = particlesOf(scene);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec3 at = particles[i].position;
        if (isOnEdge(at, side))
            guide(particles[i], Guide::Plane, Vec3::UnitZ());
        if ((at - centre).norm() < 1e-9) {
            middle = i;
            guide(particles[i], Guide::Line, Vec3::UnitZ());
        }
        if ((at - edge).norm() < 1e-9)
            below = i;
    }
    hollow(scene, side, 0.02);
    fill(scene, 5000.0);
    const AtRest rest = restOf(scene, 1.0);
    const auto& position = rest.state.position;
    Airbag bag{position[middle].z(), position[below].y(), 0.0, 0.0};
    double panels = 0.0;
    for (const Membrane& membrane : rest.system->membranes) {
        const auto& corner = rest.system->panels[std::size_t(membrane.panel)].corner;
        const Corners at = cornersOf(*rest.system, membrane, position);
        const double flat = 0.5 * (at[1] - at[0]).cross(at[2] - at[0]).z();
        bag.volume += 2.0 * flat * (at[0] + at[1] + at[2]).z() / 3.0;
        if (std::ranges::find(corner, int(middle)) != corner.end()) {
            bag.pull += largestTension(tensionIn(*rest.system, membrane, at).tension);
            panels += 1.0;
        }
    }
    bag.pull /= panels;
    return bag;
}

void addSquares(std::vector<Case>& cases)
{
    for (const int cells : {16, 24})
        cases.push_back({"RF-14",
                         "stretched square under 5 Pa, " + std::to_string(cells) + " x "
                             + std::to_string(cells) + " cells, rise of its middle",
                         navier(), relative(0.005), "m", "Navier 1820",
                         [=] { return blownSquare(cells); }});
    for (const int cells : {12, 20}) {
        const auto bag = shared([=] { return blownAirbag(cells); });
        const std::string title = "airbag of two squares under 5 kPa, " + std::to_string(cells)
                                  + " x " + std::to_string(cells) + " cells, ";
        const auto row = [&](const char* what, double expected, double share, const char* unit,
                             auto measure) {
            cases.push_back({"RF-15", title + what, expected, relative(share), unit,
                             "Contri and Schrefler 1988; Jarasjarungkiat et al. 2009", measure});
        };
        row("rise of its middle", 0.2165, 0.01, "m", [=] { return bag().rise; });
        row("volume", 0.1250, 0.01, "m^3", [=] { return bag().volume; });
        row("middle of an edge moves in", 0.122, 0.05, "m", [=] { return bag().inwards; });
        row("pull at its middle", 3.875e6 * 0.6e-3, 0.05, "N/m", [=] { return bag().pull; });
    }
}

} // namespace

std::vector<Case> inflatedCases()
{
    std::vector<Case> cases;
    addSpheres(cases);
    addTubes(cases);
    addBentTubes(cases);
    addSquares(cases);
    return cases;
}

} // namespace ripstop
