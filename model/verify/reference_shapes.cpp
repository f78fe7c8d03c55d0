// Plates, cups and flags in the wind.
//
// In order: plates head on, a hemispherical cup with air pressing from one side, and flags. Drag
// coefficients are those of a new material, as a user gets them, with nothing changed to fit.
#include "verify/reference_sections.h"

#include "compile/resolve.h"
#include "forces/panel_load.h"
#include "measure/diagnostics.h"
#include "verify/small_systems.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop {
namespace {

MaterialAir unchanged(AirLaw law)
{
    Material material;
    material.airLaw = law;
    return airOf(Id{1}, material);
}

// Drag coefficient of 0.5 m^2 head on to 10 m/s.
double broadside(AirLaw law)
{
    const Vec3 load = panelLoad(unchanged(law), Vec3::Zero(), Vec3(0.0, 0.0, 1.0),
                                Vec3(1.0, 0.0, 0.0), Vec3(0.0, 10.0, 0.0), airDensity);
    return load.y() / (0.5 * airDensity * 100.0 * 0.5);
}

// Drag coefficient on pi R^2 of a hemisphere along its axis, 96 rings of 192 panels, on which air
// presses from one side.
double cup(AirLaw law)
{
    const MaterialAir air = unchanged(law);
    constexpr int rings = 96;
    constexpr int sectors = 192;
    const auto node = [](int i, int j) {
        const double polar = 0.5 * std::numbers::pi * i / rings;
        const double angle = 2.0 * std::numbers::pi * j / sectors;
        return Vec3(std::sin(polar) * std::cos(angle), std::cos(polar),
                    std::sin(polar) * std::sin(angle));
    };
    const Vec3 wind(0.0, 10.0, 0.0);
    double force = 0.0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const Vec3 a = node(i, j);
            const Vec3 c = node(i + 1, j + 1);
            force += panelLoad(air, a, node(i + 1, j), c, wind, airDensity).y();
            force += panelLoad(air, a, c, node(i, j + 1), wind, airDensity).y();
        }
    return force / (0.5 * airDensity * 100.0 * std::numbers::pi);
}

// Mean drag coefficient of a flag on its area, 5 to 10 s. Cotton of 0.15 kg/m^2.
double flag(double area, double aspect, double wind)
{
    const double height = std::sqrt(area / aspect);
    const auto cloth = design("cloth", {{"hang", 1.0},
                                        {"flat", 0.0},
                                        {"sphere", 0.0},
                                        {"width", aspect * height},
                                        {"height", height},
                                        {"columns", 24.0},
                                        {"rows", 8.0},
                                        {"density", 0.15},
                                        {"wind", wind}});
    if (!cloth || !cloth->runUntil(5.0))
        return std::numeric_limits<double>::quiet_NaN();
    const System& system = cloth->system();
    const Vec3 along = system.wind.normalized();
    double force = 0.0;
    int samples = 0;
    for (; cloth->state().time < 10.0; ++samples) {
        if (!cloth->step())
            return std::numeric_limits<double>::quiet_NaN();
        for (const Vec3& load : panelLoads(system, cloth->state()))
            force += load.dot(along);
    }
    return force / samples / (0.5 * airDensity * wind * wind * area);
}

} // namespace

std::vector<Reference> shapeReferences()
{
    const std::string section = "Shapes in the wind";
    const char* plain = "new material, linear-normal";
    const char* table = "new material, lift and drag by table";
    std::vector<Reference> references;
    for (const AirLaw law : {AirLaw::LinearNormal, AirLaw::LiftDrag}) {
        const char* note = law == AirLaw::LinearNormal ? plain : table;
        references.push_back({section, "disc or square head on, CD", 1.17, 1.18, "", "Hoerner 1965",
                              note, [=] { return broadside(law); }});
        references.push_back({section, "long strip head on, CD", 1.98, 2.0, "", "Hoerner 1965",
                              note, [=] { return broadside(law); }});
        references.push_back({section, "hemispherical cup, open to the wind, CD", 1.40, 1.42, "",
                              "RocketPy; OpenRocket technical documentation", note,
                              [=] { return cup(law); }});
    }
    for (const double aspect : {4.0, 8.0}) {
        const double published = 0.405 * std::pow(aspect, -0.494);
        references.push_back(
            {section,
             "flag of 0.075 m2, aspect ratio " + std::to_string(int(aspect)) + ", 10 m/s, CD",
             published, published, "", "Carruthers and Filippone 2005",
             "cloth, 0.15 kg/m2, 24 x 8 cells", [=] { return flag(0.075, aspect, 10.0); }});
    }
    return references;
}

} // namespace ripstop
