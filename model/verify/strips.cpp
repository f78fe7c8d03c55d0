// Strips, squares and frames of cloth that are strained evenly or in zones, with closed answers,
// each on two meshes and by default.
//
// In order: a strip that hangs a weight by rollers, on meshes that lie at three angles to its yarns
// (RF-1); a square that weights pull along both yarns (RF-2); cloth whose yarns do not give, in the
// bias test between clamps (RF-5) and in a frame with four hinges (RF-6).
//
// Panels have Green's strain and pull in proportion to it. A load per flat width of N stretches
// cloth by s with E t s (s^2 - 1) / 2 = N; and yarns that do not stretch, turned by g towards each
// other, have the shear sin g and the energy G t sin^2(g) / 2.
//
// What theory says of a strip's width and of the zones of the bias test holds for cloth that
// resists pushing. Cloth that wrinkles may be narrower at no cost, and its yarns shorter.
#include "verify/at_rest.h"
#include "verify/by_default.h"
#include "verify/flat_cloth.h"
#include "verify/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double warpStiffness = 40e3, weftStiffness = 25e3, poisson = 0.2; // of cloth A

enum class Wrinkles { Yes, No };

// --- rollers and weights ----------------------------------------------------------------------

// The way of an edge across itself, m.
double wayOf(const FlatCloth& cloth, const std::vector<OfEdge>& edge, int across,
             const State& state)
{
    double sum = 0.0;
    for (const auto& [i, share] : edge)
        sum += share * (state.position[i][across] - cloth.place[i][across]);
    return sum;
}

struct Stretches
{
    double along = 0.0, across = 0.0; // 1, strains
};

constexpr double stripLength = 0.3, stripWidth = 0.05, stripLoad = 20.0; // m, m, N

// RF-1.
Stretches hung(double warp, double cell, double turn, Wrinkles wrinkles, SolvedBy by)
{
    const FlatCloth cloth = turnedRectangle(stripLength, stripWidth, cell, turn);
    Material material = clothA();
    material.resistsPushing = wrinkles == Wrinkles::No;
    Scene scene = hungByRollers(cloth, material, warp, stripLoad);
    if (by)
        scene.settings.solver = *by;
    const AtRest rest = restOf(scene, 1.0);
    const auto way = [&](int across, double at) {
        return wayOf(cloth, edgeOf(cloth, across, at), across, rest.state);
    };
    return {way(0, stripLength) / stripLength, (way(1, stripWidth) - way(1, 0.0)) / stripWidth};
}

// Of cloth pulled along one of its yarns, N/m.
Stretches ofPull(double pull, double stiffness, double ratio)
{
    double s = 1.0;
    for (int i = 0; i < 20; ++i)
        s -= (0.5 * s * (s * s - 1.0) - pull / stiffness) / (1.5 * s * s - 0.5);
    return {s - 1.0, std::sqrt(1.0 - ratio * (s * s - 1.0)) - 1.0};
}

void addHung(std::vector<Case>& cases)
{
    const auto add = [&](double warp, double cell, double turn, Wrinkles wrinkles, SolvedBy by) {
        const auto strip = shared([=] { return hung(warp, cell, turn, wrinkles, by); });
        const double stiffness = warp == 0.0 ? warpStiffness : weftStiffness;
        const Stretches known =
            ofPull(stripLoad / stripWidth, stiffness, poisson * stiffness / warpStiffness);
        const std::string title = std::string("strip hangs 20 N by its ")
                                  + (warp == 0.0 ? "warp" : "weft") + ", cells of "
                                  + digits(1e3 * cell, 3) + " mm turned by " + digits(turn, 3)
                                  + " degrees, " + nameOf(by) + ", ";
        if (wrinkles == Wrinkles::Yes)
            cases.push_back({"RF-1", title + "strain", known.along, relative(0.01), "",
                             "E t s (s^2 - 1) / 2 = N", [=] { return strip().along; }});
        else
            cases.push_back({"RF-1", title + "strain across where it cannot wrinkle", known.across,
                             relative(0.01), "", "Poisson's ratio, of Green's strain",
                             [=] { return strip().across; }});
    };
    for (const double cell : {0.025, 0.0125}) {
        for (const double turn : {0.0, 17.0, 45.0}) {
            add(0.0, cell, turn, Wrinkles::Yes, {});
            add(90.0, cell, turn, Wrinkles::Yes, {});
            add(0.0, cell, turn, Wrinkles::No, {});
        }
        add(90.0, cell, 17.0, Wrinkles::No, {});
        add(0.0, cell, 17.0, Wrinkles::Yes, Solver::Direct);
    }
}

// RF-2. A square on rollers along two sides. A weight that can only go straight away from the
// other two hangs at each of their particles, by a wire of a kilometre, so that they are free to
// go along; its weight, at 45 degrees to both, is that of the pull times the root of 2.
constexpr double side = 0.2;                         // m
constexpr std::array<double, 2> pulls{600.0, 300.0}; // N/m, along warp and weft

Stretches pulledBothWays(int cells, SolvedBy by)
{
    constexpr double wire = 1e3; // m
    const FlatCloth cloth = rectangle(side, side, cells, cells);
    Scene scene = sceneOf(cloth, clothA(), 0.0);
    if (by)
        scene.settings.solver = *by;
    scene.settings.gravity = standardGravity * Vec3(1.0, 1.0, 0.0).normalized();
    Part& part = std::get<Part>(scene.items.back().item);
    const Id material = part.panels.front().material;
    for (const int k : {0, 1}) {
        for (const OfEdge& one : edgeOf(cloth, k, 0.0)) {
            Particle& held = part.particles[one.particle];
            held.pinned = held.guide == Guide::Line; // the corner of both
            held.guide = Guide::Line;
            held.guideAxis = Vec3::Unit(1 - k);
        }
        for (const auto& [i, share] : edgeOf(cloth, k, side)) {
            Particle weight;
            weight.id = takeId(scene);
            weight.position = part.particles[i].position + wire * Vec3::Unit(k);
            weight.mass = share * pulls[std::size_t(k)] * side * std::sqrt(2.0) / standardGravity;
            weight.guide = Guide::Line;
            weight.guideAxis = Vec3::Unit(k);
            Link line;
            line.id = takeId(scene);
            line.from = part.particles[i].id;
            line.to = weight.id;
            line.material = material;
            line.restLength = wire;
            part.particles.push_back(weight);
            part.links.push_back(line);
        }
    }
    const AtRest rest = restOf(scene, 1.0);
    const auto strain = [&](int k) {
        return wayOf(cloth, edgeOf(cloth, k, side), k, rest.state) / side;
    };
    return {strain(0), strain(1)};
}

// With pulls per flat width, N/m; each goes with its stretch.
Stretches ofPulls(double alongWarp, double alongWeft)
{
    double a = 1.0, b = 1.0; // stretches
    for (int i = 0; i < 50; ++i) {
        const double warp = alongWarp / a, weft = alongWeft / b;
        a = std::sqrt(1.0 + 2.0 * (warp / warpStiffness - poisson * weft / warpStiffness));
        b = std::sqrt(1.0 + 2.0 * (weft / weftStiffness - poisson * warp / warpStiffness));
    }
    return {a - 1.0, b - 1.0};
}

void addPulledBothWays(std::vector<Case>& cases)
{
    const Stretches known = ofPulls(pulls[0], pulls[1]);
    for (const SolvedBy by : {SolvedBy(), SolvedBy(Solver::Direct)})
        for (const int cells : {4, 8}) {
            const auto square = shared([=] { return pulledBothWays(cells, by); });
            const std::string title = "cloth pulled by 600 and 300 N/m, " + std::to_string(cells)
                                      + " x " + std::to_string(cells) + ", " + nameOf(by)
                                      + ", strain along the ";
            cases.push_back({"RF-2", title + "warp", known.along, relative(0.01), "",
                             "orthotropic sheet, Jones 1975, 2.6", [=] { return square().along; }});
            cases.push_back({"RF-2", title + "weft", known.across, relative(0.01), "",
                             "orthotropic sheet, Jones 1975, 2.6",
                             [=] { return square().across; }});
        }
}

// --- yarns that do not give --------------------------------------------------------------------

constexpr double trellisShear = 1200.0; // N/m, G t

Material trellis(Wrinkles wrinkles)
{
    Material cloth = woven(4e6, 4e6, 0.0, trellisShear);
    cloth.resistsPushing = wrinkles == Wrinkles::No;
    return cloth;
}

// RF-5. Yarns at 45 degrees to a strip between clamps 20 mm farther apart than it is long: those of
// the middle zone turn by g towards each other, those of the zones beside the clamps by half of it,
// and the triangles at the clamps stay as they are (Cao et al. 2008).
struct Bias
{
    static constexpr double length = 0.3, width = 0.1, longer = 0.02; // m
    static constexpr double between = length - width;                 // m

    static double angle(double longer)
    {
        return 0.5 * std::numbers::pi
               - 2.0 * std::acos((between + longer) / (std::sqrt(2.0) * between));
    }
    static double energy(double longer) // J
    {
        const double middle = width * (between - 0.5 * width), beside = width * width;
        const double whole = std::sin(angle(longer)), half = std::sin(0.5 * angle(longer));
        return 0.5 * trellisShear * (middle * whole * whole + beside * half * half);
    }
    static double pull() // N
    {
        constexpr double h = 1e-5;
        return (energy(longer + h) - energy(longer - h)) / (2.0 * h);
    }
};

double biasPull(int across)
{
    const FlatCloth cloth =
        rectangle(Bias::length, Bias::width, 3 * across, across, Parted::Crosswise);
    Scene scene = sceneOf(cloth, trellis(Wrinkles::No), 45.0);
    std::vector<Vec3> way(cloth.place.size(), Vec3::Zero());
    std::vector<Particle>& particles = particlesOf(scene);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double x = cloth.place[i].x();
        particles[i].pinned = x < 1e-9 || x > Bias::length - 1e-9;
        particles[i].position.x() += Bias::longer * x / Bias::length;
        if (x > Bias::length - 1e-9)
            way[i] = Vec3::UnitX();
    }
    return restOf(scene, 1.0).against(way);
}

// RF-6. A square frame with four hinges, drawn along a diagonal; cloth fills it. Its yarns pull
// just enough that it does not wrinkle, which takes a share of 2 G / E of the shear.
struct PictureFrame
{
    static constexpr double side = 0.2, longer = 0.02; // m

    // half the angle between the sides at the corners that are drawn
    static double half() { return std::acos(std::sqrt(0.5) + longer / (2.0 * side)); }
    static double pull() // N
    {
        const double angle = 0.5 * std::numbers::pi - 2.0 * half();
        return trellisShear * std::sin(angle) * std::cos(angle) * side / std::sin(half());
    }
};

double framePull(int cells)
{
    const FlatCloth cloth = rectangle(PictureFrame::side, PictureFrame::side, cells, cells);
    Scene scene = sceneOf(cloth, trellis(Wrinkles::Yes), 0.0);
    // the diagonal from the corner at the origin lies along (1, 1)
    const Vec3 drawn = Vec3(1.0, 1.0, 0.0).normalized(), other(-drawn.y(), drawn.x(), 0.0);
    const double c = std::cos(PictureFrame::half()), s = std::sin(PictureFrame::half());
    std::vector<Vec3> way(cloth.place.size(), Vec3::Zero());
    std::vector<Particle>& particles = particlesOf(scene);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec3 at = cloth.place[i];
        const auto onEdge = [](double x) { return x < 1e-9 || x > PictureFrame::side - 1e-9; };
        particles[i].pinned = onEdge(at.x()) || onEdge(at.y());
        const double sum = at.x() + at.y(), difference = at.y() - at.x();
        particles[i].position = sum * c * drawn + difference * s * other;
        if (particles[i].pinned) // as the diagonal 2 L c grows, the other one shrinks
            way[i] = 0.5 / PictureFrame::side * (sum * drawn - difference * c / s * other);
        else // so that there is something to find
            particles[i].position.x() += 0.02 * PictureFrame::side / cells;
    }
    return restOf(scene, 0.5).against(way);
}

void addTrellises(std::vector<Case>& cases)
{
    for (const int across : {8, 12})
        cases.push_back({"RF-5",
                         "bias test of yarns that do not give, " + std::to_string(3 * across)
                             + " x " + std::to_string(across) + " cells, pull",
                         Bias::pull(), relative(0.03), "N",
                         "zones of Cao et al. 2008, G t sin^2(g) / 2",
                         [=] { return biasPull(across); }});
    for (const int cells : {4, 9})
        cases.push_back({"RF-6",
                         "frame with hinges, " + std::to_string(cells) + " x "
                             + std::to_string(cells) + " cells, pull along its diagonal",
                         PictureFrame::pull(), relative(0.01), "N",
                         "G t sin(g) cos(g) L / sin(half)", [=] { return framePull(cells); }});
}

} // namespace

std::vector<Case> stripCases()
{
    std::vector<Case> cases;
    addHung(cases);
    addPulledBothWays(cases);
    addTrellises(cases);
    return cases;
}

} // namespace ripstop
