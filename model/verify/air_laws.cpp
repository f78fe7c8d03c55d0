// What every law of the air obeys, and the laws beyond paper and plate: the blend for all angles,
// lift and drag by table, porous cloth, lines.
//
// In order: symmetries that every law obeys (A2, A5 to A7), measured as the largest deviation over
// many winds; the blend and the table at all angles of a plate; porous cloth, at rest and
// descending; and lines across the wind.
#include "assembly/finish.h"
#include "base/angle.h"
#include "compile/resolve.h"
#include "forces/line_drag.h"
#include "forces/panel_load.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

Material materialOf(AirLaw law, double coefficient, double friction = 0.0)
{
    Material material;
    material.airLaw = law;
    material.normalCoefficient = coefficient;
    material.skinFriction = friction;
    return material;
}

MaterialAir airOf(const Material& material) { return ripstop::airOf(Id{1}, material); }

Material blended(double slope, double broadside)
{
    Material material = materialOf(AirLaw::LinearNormal, slope);
    material.broadsideCoefficient = broadside;
    return material;
}

Material porous(AirLaw law, double coefficient, double porosity)
{
    Material material = materialOf(law, coefficient);
    material.porosity = porosity;
    return material;
}

// Forces over the dynamic pressure and the area, 1.
struct Plate
{
    double normal;
    double lift;
    double drag;
};

Plate plate(const Material& material, double angle) // degrees
{
    const double alpha = angle * degrees;
    const Vec3 wind = 10.0 * Vec3(std::cos(alpha), std::sin(alpha), 0.0);
    const Vec3 c =
        panelLoad(airOf(material), Vec3::Zero(), {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, wind, airDensity)
        / (0.5 * airDensity * 100.0 * 0.5);
    return {c.y(), c.y() * std::cos(alpha) - c.x() * std::sin(alpha),
            c.y() * std::sin(alpha) + c.x() * std::cos(alpha)};
}

// --- A2, A5 to A7 --------------------------------------------------------------------------------

struct Worst
{
    double against = 0.0; // W, largest power that the wind gains
    double winding = 0.0; // 1, difference when the corners go the other way round
    double side = 0.0;    // 1, when the wind comes from the other side
    double parts = 0.0;   // 1, of four quarters
};

Worst worstOf(Material material)
{
    Worst worst;
    Dice dice(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = dice.vector(1.0);
        const Vec3 b = dice.vector(1.0);
        const Vec3 c = dice.vector(1.0);
        const Vec3 wind = dice.vector(10.0);
        material.skinFriction = i % 2 ? 0.02 : 0.0;
        const MaterialAir air = airOf(material);
        const auto load = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& w) {
            return panelLoad(air, p, q, r, w, airDensity);
        };
        const Vec3 whole = load(a, b, c, wind);
        const double size = 1.0 + whole.norm();
        const Vec3 ab = 0.5 * (a + b);
        const Vec3 bc = 0.5 * (b + c);
        const Vec3 ca = 0.5 * (c + a);
        const Vec3 parts = load(a, ab, ca, wind) + load(ab, b, bc, wind) + load(ca, bc, c, wind)
                           + load(ab, bc, ca, wind);
        worst.against = std::max(worst.against, -whole.dot(wind));
        worst.winding = std::max(worst.winding, (load(a, c, b, wind) - whole).norm() / size);
        worst.side = std::max(worst.side, (load(a, b, c, -wind) + whole).norm() / size);
        worst.parts = std::max(worst.parts, (parts - whole).norm() / size);
    }
    return worst;
}

double loadInTheWind(const Material& material) // N, the largest on fabric that moves with the wind
{
    System system = emptySystem(0.01);
    system.wind = {3.0, -1.0, 7.0};
    const MaterialAir air = airOf(material);
    Dice dice(8);
    for (int i = 0; i < 12; ++i)
        addParticle(system, dice.vector(1.0), 0.01, system.wind);
    for (int i = 0; i + 2 < 12; ++i)
        addPanel(system, i, i + 1, i + 2, air);
    finish(system);
    double most = 0.0;
    for (const Vec3& load : panelLoads(system, run(system, 100)))
        most = std::max(most, load.norm());
    return most;
}

double alongThePanel(Material material, double friction) // N, of 10 m/s on 0.5 m^2
{
    material.skinFriction = friction;
    return panelLoad(airOf(material), Vec3::Zero(), {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0},
                     {6.0, 0.0, 8.0}, airDensity)
        .dot(Vec3(0.6, 0.0, 0.8));
}

void addSymmetries(std::vector<Case>& cases)
{
    const std::pair<const char*, Material> laws[] = {
        {"paper", materialOf(AirLaw::Paper, 2.0)},
        {"linear_normal", materialOf(AirLaw::LinearNormal, 2.0)},
        {"linear_normal, blend", blended(2.44, 1.17)},
        {"linear_normal, porous", porous(AirLaw::LinearNormal, 2.0, 0.05)},
        {"lift_drag", materialOf(AirLaw::LiftDrag, 2.0)}};
    for (const auto& [name, law] : laws) {
        const auto worst = shared([law = law] { return worstOf(law); });
        const std::string by = std::string(", 1000 panels, ") + name;
        cases.push_back({"T-A2", "largest power that the wind gains" + by, 0.0, atMost, "W",
                         "F.w >= 0", [=] { return worst().against; }});
        cases.push_back({"T-A2", "corners the other way round, change" + by, 0.0, within(1e-12), "",
                         "n and -n are one panel", [=] { return worst().winding; }});
        cases.push_back({"T-A2", "wind from the other side, change" + by, 0.0, within(1e-12), "",
                         "F(-w) = -F(w)", [=] { return worst().side; }});
        cases.push_back({"T-A5", "four quarters of a panel, change" + by, 0.0, within(1e-12), "",
                         "uniform flow", [=] { return worst().parts; }});
        cases.push_back(
            {"T-A6", std::string("fabric that moves with the wind, largest load, ") + name, 0.0,
             within(1e-12), "N", "apparent wind 0", [law = law] { return loadInTheWind(law); }});
        cases.push_back({"T-A7", std::string("wind of 10 m/s along a panel, load, ") + name, 0.0,
                         within(1e-15), "N", "no normal force",
                         [law = law] { return alongThePanel(law, 0.0); }});
        cases.push_back({"T-A7", std::string("the same with skin friction 0.01, 0.5 m2, ") + name,
                         0.5 * airDensity * 0.01 * 0.5 * 100.0, relative(1e-12), "N",
                         "rho Cs A V^2 / 2", [law = law] { return alongThePanel(law, 0.01); }});
    }
}

// --- plates at all angles ------------------------------------------------------------------------

void addPlateLaws(std::vector<Case>& cases)
{
    const Material both = blended(2.44, 1.17);
    for (const auto& [angle, digits] :
         {std::pair(10.0, 0.356), {30.0, 0.79}, {60.0, 1.09}, {90.0, 1.17}}) {
        const double s = std::sin(angle * degrees);
        char source[80];
        std::snprintf(source, sizeof source, "Ca s / (1 + (Ca/C90 - 1) s): %g", digits);
        cases.push_back(
            {"4.1",
             "CN of the blend, Ca 2.44, C90 1.17, at " + std::to_string(int(angle)) + " degrees",
             2.44 * s / (1.0 + (2.44 / 1.17 - 1.0) * s), relative(1e-12), "", source,
             [=, angle = angle] { return plate(both, angle).normal; }});
    }
    // the default table keeps 257 points between the author's rows
    for (const double angle : {5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0}) {
        const double s = std::sin(angle * degrees);
        cases.push_back({"3.6",
                         "CN of the default table at " + std::to_string(int(angle)) + " degrees",
                         1.98 * s / (0.56 + 0.44 * s), within(1e-3), "",
                         "CD90 s / (0.56 + 0.44 s), Lindenburg; CD90 1.98",
                         [=] { return plate(materialOf(AirLaw::LiftDrag, 2.0), angle).normal; }});
    }
    Material stalling = materialOf(AirLaw::LiftDrag, 2.0);
    stalling.polar = {{0, 0.1, 0.02}, {12, 1.2, 0.05}, {16, 0.7, 0.25}, {90, 0, 1.3}};
    const double rows[][3] = {
        {6.0, 0.65, 0.035}, {14.0, 0.95, 0.15}, {53.0, 0.35, 0.775}, {90.0, 0.0, 1.3}};
    for (const auto& [angle, lift, drag] : rows) {
        const std::string at =
            " of a table with a stall at " + std::to_string(int(angle)) + " degrees";
        cases.push_back({"4.3", "CL" + at, lift, within(2e-3), "", "half-way between its rows",
                         [=, angle = angle] { return plate(stalling, angle).lift; }});
        cases.push_back({"4.3", "CD" + at, drag, within(2e-3), "", "half-way between its rows",
                         [=, angle = angle] { return plate(stalling, angle).drag; }});
    }
}

// --- porous cloth --------------------------------------------------------------------------------

// 0.3 kg on 0.5 m^2 that falls flat, C 1.4, m/s.
double porousDescent(double porosity)
{
    System system = heavySystem(0.001);
    const MaterialAir air = airOf(porous(AirLaw::LinearNormal, 1.4, porosity));
    for (const Vec3& x : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0)})
        addParticle(system, x, 0.1);
    addPanel(system, 0, 1, 2, air);
    finish(system);
    return -run(system, 5000).velocity[0].y();
}

// dp = dp0 (1 - leak / wind)^2 and leak = c sqrt(2 dp / rho) give C / (1 + c sqrt(C))^2 head on.
void addPorous(std::vector<Case>& cases)
{
    // air permeability at 124.5 Pa, m/s
    for (const auto& [cloth, leak] : {std::pair("MIL-C-7020 type I", 0.41), {"type II", 0.81}}) {
        const double c = leak / std::sqrt(2.0 * 124.5 / airDensity);
        for (const AirLaw law : {AirLaw::Paper, AirLaw::LinearNormal})
            cases.push_back(
                {"4.9",
                 std::string("C head on of porous cloth, ") + cloth + ", C 1.68, " + nameOf(law),
                 1.68 / std::pow(1.0 + c * std::sqrt(1.68), 2), relative(1e-12), "",
                 "C / (1 + c sqrt(C))^2",
                 [=] { return plate(porous(law, 1.68, c), 90.0).normal; }});
    }
    for (const double c : {0.0, 0.0285, 0.0570, 0.3}) {
        char title[60];
        std::snprintf(title, sizeof title, "porous plate falls flat, c %g, speed", c);
        cases.push_back({"4.9", title,
                         std::sqrt(2.0 * 0.3 * standardGravity / (airDensity * 1.4 * 0.5))
                             * (1.0 + c * std::sqrt(1.4)),
                         within(1e-6), "m/s", "sqrt(2 m g / (rho C A)) (1 + c sqrt(C))",
                         [=] { return porousDescent(c); }});
    }
}

// --- lines ---------------------------------------------------------------------------------------

Vec3 leaning(double angle) // N, 3 m at this angle to 7 m/s, Cd d 2 mm, degrees
{
    const Vec3 along(std::cos(angle * degrees), std::sin(angle * degrees), 0.0);
    return lineDrag(0.002, Vec3::Zero(), 3.0 * along, {7.0, 0.0, 0.0}, airDensity);
}

// 20 g of stick, 2 m long, Cd d 4.4 mm, that falls broadside, m/s.
double fallingStick()
{
    System system = heavySystem(1.0 / 1000.0);
    addParticle(system, {0.0, 0.0, 0.0}, 0.01);
    addParticle(system, {2.0, 0.0, 0.0}, 0.01);
    LinkPlace link{};
    link.kind = LinkKind::Rod;
    link.a = 0;
    link.b = 1;
    system.links.push_back(link);
    addRod(system, 0, 1, 2.0);
    DragLine line{};
    line.a = 0;
    line.b = 1;
    line.width = 1.1 * 0.004;
    system.of<LineLists>().list.push_back(line);
    finish(system);
    return -run(system, 10000).velocity[1].y();
}

void addLines(std::vector<Case>& cases)
{
    cases.push_back({"4.13", "50 m of 1 mm line across 8 m/s, Cd 1.1, drag", 2.156, within(1e-12),
                     "N", "rho Cd d l V^2 / 2", [] {
                         return lineDrag(1.1 * 0.001, Vec3::Zero(), {0.0, 50.0, 0.0},
                                         {8.0, 0.0, 0.0}, airDensity)
                             .x();
                     }});
    for (const double angle : {0.0, 20.0, 45.0, 70.0}) {
        const double s = std::sin(angle * degrees);
        cases.push_back({"4.13",
                         "line at " + std::to_string(int(angle)) + " degrees to 7 m/s, drag",
                         0.5 * airDensity * 0.002 * 3.0 * 49.0 * s * s, within(1e-12), "N",
                         "sin^2: the part across the line (Hoerner 1965)",
                         [=] { return leaning(angle).norm(); }});
    }
    cases.push_back({"4.13", "stick that falls broadside, speed",
                     std::sqrt(2.0 * 0.02 * standardGravity / (airDensity * 1.1 * 0.004 * 2.0)),
                     within(1e-6), "m/s", "sqrt(2 m g / (rho Cd d l))", fallingStick});
}

} // namespace

std::vector<Case> airLawCases()
{
    std::vector<Case> cases;
    addSymmetries(cases);
    addPlateLaws(cases);
    addPorous(cases);
    addLines(cases);
    return cases;
}

} // namespace ripstop
