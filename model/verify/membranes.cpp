// Elastic panels against closed and published answers, each on two meshes and with everything else
// as a new scene has it.
//
// Cloth is laid out flat in the plane of x and y, then its held particles are put where the case
// wants them, and viscosity, which changes nothing of where it ends, brings it to rest. What panels
// carry is read from their law: N_x over a cloth of length L is the mean of N_x over its area times
// its width, whatever the mesh.
//
// Numbers of cloth A (E1 t 40, E2 t 25, G t 1.2 kN/m, nu12 0.2) are exact for small strains. Panels
// have Green's strain: a pull per flat width of N stretches them by N / E t less 3/2 of the square.
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

// --- a strip that hangs ----------------------------------------------------------------------

struct HungStrip
{
    double length, width, density, load; // m, m, kg/m^2, N
    double warp;                         // degrees from the vertical
    int along, across;
    Parted parted = Parted::Rising;
};

// Its upper edge is held in height and free to get narrower and to skew. Returns how far the lower
// edge has come down, m.
double drop(const HungStrip& strip)
{
    Scene scene =
        sceneOf(rectangle(strip.length, strip.width, strip.along, strip.across, strip.parted),
                clothA(), strip.warp, strip.density);
    scene.settings.gravity = Vec3(standardGravity, 0.0, 0.0); // x is down
    std::vector<Particle>& particles = particlesOf(scene);
    const auto at = [&](int row, int column) -> Particle& {
        return particles[std::size_t(row * (strip.along + 1) + column)];
    };
    for (int row = 0; row <= strip.across; ++row) {
        at(row, 0).guide = Guide::Line;
        at(row, 0).guideAxis = Vec3::UnitY();
        const double share = row == 0 || row == strip.across ? 0.5 : 1.0;
        at(row, strip.along).mass += share / strip.across * strip.load / standardGravity;
    }
    at(strip.across / 2, 0).pinned = true;
    const AtRest rest = restOf(scene, 1.0);
    double sum = 0.0;
    for (int row = 0; row <= strip.across; ++row) {
        const double share = row == 0 || row == strip.across ? 0.5 : 1.0;
        const auto i = std::size_t(row * (strip.along + 1) + strip.along);
        sum += share / strip.across * (rest.state.position[i].x() - strip.length);
    }
    return sum;
}

double modulus(double degrees) // N/m, of cloth A (Jones)
{
    const double c = std::cos(degrees * std::numbers::pi / 180.0);
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    return 1.0
           / (c * c * c * c / 40e3 + (1.0 / 1.2e3 - 0.4 / 40e3) * s * s * c * c
              + s * s * s * s / 25e3);
}

// How far a sheet of 2 x 1 m cut at 45 degrees comes down, m, whose weight is that of drop(): with
// Green's strain a stretch s carries N = E s (s^2 - 1) / 2 of the flat width. Simpson's
// rule over the height.
double biasDrop(double load, double density)
{
    const auto stretch = [](double pull) { // N/m
        double s = 1.0;
        for (int i = 0; i < 20; ++i)
            s -= (0.5 * s * (s * s - 1.0) - pull / modulus(45.0)) / (1.5 * s * s - 0.5);
        return s - 1.0;
    };
    const double weight = 2.0 * density * standardGravity; // N/m, of all of it
    return 2.0 * (stretch(load) + 4.0 * stretch(load + 0.5 * weight) + stretch(load + weight))
           / 6.0;
}

void addStrips(std::vector<Case>& cases)
{
    for (const double degrees : {0.0, 22.5, 45.0, 90.0})
        for (const bool fine : {false, true}) {
            const HungStrip strip{
                0.3,     0.05,           1e-5,         0.25,
                degrees, fine ? 24 : 12, fine ? 4 : 2, fine ? Parted::Falling : Parted::Rising};
            const double pull = strip.load / strip.width;
            cases.push_back({"RF-3",
                             "strip cut at " + digits(degrees, 3) + " degrees to the warp, "
                                 + std::to_string(strip.along) + " x "
                                 + std::to_string(strip.across),
                             strip.length * pull / modulus(degrees), relative(0.01), "m",
                             "N L / E(th), Jones 1975, 2.6", [=] { return drop(strip); }});
        }
    struct Hung
    {
        double warp, expected; // degrees, m
    };
    for (const auto& [warp, expected] :
         {Hung{0.0, 2.5206e-3}, Hung{90.0, 4.0330e-3}, Hung{45.0, biasDrop(50.0, 0.042)}})
        for (const int cells : {10, 20}) {
            const HungStrip sheet{2.0, 1.0, 0.042, 50.0, warp, 2 * cells, cells};
            cases.push_back({"RF-7",
                             "sheet of 2 m hangs 50 N, warp at " + digits(warp, 3) + " degrees, "
                                 + std::to_string(sheet.along) + " x "
                                 + std::to_string(sheet.across),
                             expected, relative(0.005), "m", "(F + m g / 2) L / (E t W)",
                             [=] { return drop(sheet); }});
        }
}

// --- panels that are held all around, or at two ends ------------------------------------------

// Pure shear g of a square of 1 m, prescribed on its edges; the mean of one component, N/m.
double wagner(const Material& material, int cells, int component)
{
    constexpr double shear = 0.01;
    Scene scene = sceneOf(rectangle(1.0, 1.0, cells, cells), material, 0.0);
    for (Particle& particle : particlesOf(scene)) {
        const Vec3 at = particle.position;
        particle.pinned = at.x() == 0.0 || at.x() == 1.0 || at.y() == 0.0 || at.y() == 1.0;
        particle.position += 0.5 * shear * Vec3(at.y(), at.x(), 0.0);
    }
    return restOf(scene, 0.5).mean([&](const Vec3& tension, const Vec3&) {
        return tension[component];
    });
}

void addWagner(std::vector<Case>& cases)
{
    for (const int cells : {4, 9}) {
        const std::string mesh = ", " + std::to_string(cells) + " x " + std::to_string(cells);
        cases.push_back({"RF-13", "panel in pure shear of 1 %, shear" + mesh, 100.0, relative(0.02),
                         "N/m", "E t g / 4, Wagner 1929",
                         [=] { return wagner(isotropic(40e3, 0.3), cells, 2); }});
        cases.push_back({"RF-13", "panel in pure shear of 1 %, along the edges" + mesh, 100.0,
                         relative(0.02), "N/m", "E t g / 4, Wagner 1929",
                         [=] { return wagner(isotropic(40e3, 0.3), cells, 0); }});
        cases.push_back({"RF-13", "cloth A in pure shear of 1 %, shear" + mesh, 11.279,
                         relative(0.02), "N/m", "tension field at 41.64 degrees",
                         [=] { return wagner(clothA(), cells, 2); }});
    }
}

// Two opposite ends at distances L (1 + strain) apart, turned so that the sheet bends by a
// curvature (1/m) in its plane.
Scene heldByEnds(const FlatCloth& cloth, const Material& material, double warp, double strain,
                 double curvature)
{
    Scene scene = sceneOf(cloth, material, warp);
    const auto width = std::ranges::max(cloth.place, {}, [](const Vec3& p) { return p.y(); }).y();
    const auto length = std::ranges::max(cloth.place, {}, [](const Vec3& p) { return p.x(); }).x();
    for (Particle& particle : particlesOf(scene)) {
        const double along = particle.position.x() - 0.5 * length;
        particle.pinned = std::abs(std::abs(along) - 0.5 * length) < 1e-9;
        particle.position.x() +=
            along * (strain + curvature * (particle.position.y() - 0.5 * width));
    }
    return scene;
}

// RF-12: a stretched sheet bent in its plane wrinkles where it would push (Stein and Hedgepeth
// 1961). With m = M / (P h) the wrinkled share is b/h = 3 m - 1/2, and the tension rises from there
// to the far edge.
struct Bent
{
    double moment, pull; // M / (P h), N
};

Bent bent(double moment, int rows)
{
    constexpr double pull = 20.0, height = 0.5, length = 0.25, stiffness = 40e3;
    const double wrinkled = 3.0 * moment - 0.5;
    const double curvature =
        2.0 * pull / (stiffness * height * height) / std::pow(3.0 * (0.5 - moment), 2.0);
    const double strain =
        2.0 * pull / height * (0.5 - wrinkled) / std::pow(1.0 - wrinkled, 2.0) / stiffness;
    const AtRest rest = restOf(heldByEnds(rectangle(length, height, rows / 2, rows),
                                          isotropic(stiffness, 0.0), 0.0, strain, curvature),
                               0.6);
    const double whole = height * rest.mean([](const Vec3& t, const Vec3&) { return t[0]; });
    const double turned = height * rest.mean([&](const Vec3& t, const Vec3& middle) {
        return t[0] * (middle.y() - 0.5 * height);
    });
    return {turned / (whole * height), whole};
}

void addBent(std::vector<Case>& cases)
{
    for (const double moment : {0.25, 0.35})
        for (const int rows : {20, 40}) {
            const auto run = shared([=] { return bent(moment, rows); });
            const std::string title = "sheet bent in its plane by " + digits(moment, 3) + " P h, "
                                      + std::to_string(rows) + " rows, ";
            cases.push_back({"RF-12", title + "M / (P h)", moment, relative(0.02), "",
                             "Stein and Hedgepeth 1961", [=] { return run().moment; }});
            cases.push_back({"RF-12", title + "pull", 20.0, relative(0.02), "N",
                             "Stein and Hedgepeth 1961", [=] { return run().pull; }});
        }
}

// RF-4: the bias strip between clamps.
double clampedBias(int across)
{
    constexpr double length = 0.2, width = 0.05, strain = 1e-3;
    const AtRest rest = restOf(
        heldByEnds(rectangle(length, width, 4 * across, across), clothA(), 45.0, strain, 0.0), 0.5);
    // Along x: warp and weft lie at 45 degrees to it.
    const double pull =
        rest.mean([](const Vec3& t, const Vec3&) { return 0.5 * (t[0] + t[1]) - t[2]; });
    return pull / strain;
}

// --- a membrane under a load across it -------------------------------------------------------

// Hencky's: a disc of radius 0.5 m, clamped at its rim, under 200 Pa, which its own weight makes.
double hencky(double poisson, int rings)
{
    constexpr double load = 200.0; // Pa
    Scene scene =
        sceneOf(disc(0.5, rings), isotropic(32.7e3, poisson), 0.0, load / standardGravity);
    scene.settings.gravity = Vec3(0.0, 0.0, -standardGravity);
    scene.settings.viscosity = 10.0;
    for (Particle& particle : particlesOf(scene))
        particle.pinned = particle.position.norm() > 0.5 - 1e-9;
    return -restOf(scene, 2.0).state.position[0].z();
}

} // namespace

std::vector<Case> membraneCases()
{
    std::vector<Case> cases;
    addStrips(cases);
    addWagner(cases);
    addBent(cases);
    for (const int across : {12, 16})
        cases.push_back({"RF-4",
                         "bias strip between clamps, " + std::to_string(4 * across) + " x "
                             + std::to_string(across),
                         4904.0, relative(0.03), "N/m", "tension field by finite elements",
                         [=] { return clampedBias(across); }});
    struct Disc
    {
        double poisson, rise; // 1, m
    };
    for (const auto& [poisson, rise] : {Disc{0.3, 47.424e-3}, Disc{0.0, 52.135e-3}})
        for (const int rings : {8, 16})
            cases.push_back({"RF-8",
                             "disc under 200 Pa, Poisson's ratio " + digits(poisson, 2) + ", "
                                 + std::to_string(rings) + " rings",
                             rise, relative(0.01), "m", "Hencky 1915; Fichter 1997",
                             [=, nu = poisson] { return hencky(nu, rings); }});
    return cases;
}

} // namespace ripstop
