// Descent rates and the shape of round canopies.
//
// In order: descent rates of canopies with a hoop, the width of the skirt over the nominal
// diameter, and the opening of a C-9 (verify/opening.h). Canopy and lines weigh as the builder has
// them, and the payload is what is left of the published mass.
#include "verify/reference_sections.h"

#include "measure/diagnostics.h"
#include "verify/opening.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop {
namespace {

// Canopy, lines and hoop of this design weigh as the builder has them; the payload is what is left
// of the mass in all.
double descentRate(Parameters given, double mass) // m/s
{
    given.emplace("cloth", 0.0); // ideal, as heavy as is said
    given["payload"] = 1.0;
    given["altitude"] = 1000.0;
    const auto light = design("parachute", given);
    if (!light)
        return std::numeric_limits<double>::quiet_NaN();
    given["payload"] = mass - (totalMass(light->system()) - 1.0);
    const auto flown = design("parachute", given);
    return flown ? meanProbe(*flown, "sink rate", 20.0, 30.0)
                 : std::numeric_limits<double>::quiet_NaN();
}

// Width of the skirt over the nominal diameter after 20 s, from its area seen from above.
double projectedRatio(double hoop)
{
    const auto flown = design("parachute", {{"cloth", 0.0}, {"hoop", hoop}, {"altitude", 1000.0}});
    if (!flown || !flown->runUntil(20.0))
        return std::numeric_limits<double>::quiet_NaN();
    const System& system = flown->system();
    const State& state = flown->state();
    Vec3 middle = Vec3::Zero();
    int count = 0;
    for (const FabricPanel& panel : system.panels)
        for (const int corner : panel.corner) {
            middle += state.position[std::size_t(corner)];
            ++count;
        }
    middle /= count;
    // the outermost particle in each of 24 sectors
    constexpr int sectors = 24;
    double radius[sectors] = {};
    for (const FabricPanel& panel : system.panels)
        for (const int corner : panel.corner) {
            const Vec3 off = state.position[std::size_t(corner)] - middle;
            const double angle = std::atan2(off.z(), off.x()) / (2.0 * std::numbers::pi) + 1.0;
            double& held = radius[int(angle * sectors) % sectors];
            held = std::max(held, std::hypot(off.x(), off.z()));
        }
    double mean = 0.0;
    for (const double one : radius)
        mean += one / sectors;
    return 2.0 * mean / 5.0; // the builder's D0 is 5 m
}

// The C-9, thrown down at 60 m/s or as it sinks, without a hoop.
Flight flightOfC9(bool opens, const Parameters& materials)
{
    Chute chute;
    chute.parameters = joined(sizeOfC9(), materials);
    chute.gravity = 9.80665;
    chute.speed = opens ? 60.0 : 6.0;
    chute.until = opens ? 1.5 : 25.0;
    return fly(chute);
}

void addOpenings(std::vector<Reference>& references, const Parameters& materials,
                 const std::string& c9, const std::string& note)
{
    const std::string section = "Parachutes";
    const auto sinking = shared([=] { return flightOfC9(false, materials); });
    const auto held = shared([=] { return fly(heldC9(20.0, materials)); });
    references.push_back({section, c9 + "CD0 as it sinks with 100 kg", 0.75, 0.80, "",
                          "Knacke 1991, table 5-1, flat circular", note,
                          [=] { return sinking().drag; }});
    references.push_back({section, c9 + "projected over nominal diameter", 0.67, 0.70, "",
                          "Knacke 1991, table 5-1", note, [=] { return sinking().width; }});
    references.push_back({section, c9 + "fill constant at 20 m/s", 8.0, 8.0, "",
                          "Knacke 1991, table 5-6, flat circular", note + ", payload held",
                          [=] { return held().filled; }});
    references.push_back({section, c9 + "exponent of the drag area's growth", 2.0, 2.0, "",
                          "Knacke 1991, figure 5-51, solid cloth", note + ", payload held",
                          [=] { return held().growth; }});
    references.push_back({section, c9 + "opening load, 100 kg down at 60 m/s", 9278.7, 9278.7, "N",
                          "drag area as (t / tf)^2 with CD0 0.775 and n = 8, integrated", note,
                          [=] { return flightOfC9(true, materials).highest; }});
}

} // namespace

std::vector<Reference> parachuteReferences()
{
    const std::string section = "Parachutes";
    const std::string builder = "parachute with hoop, drag as the builder has it";
    std::vector<Reference> references;
    references.push_back({section, "T-10D, 35 ft, 360 lb, descent, canopy pressure", 6.7, 7.3,
                          "m/s", "FM 57-220; en.wikipedia.org T-10_parachute",
                          "no hoop, air in the canopy; nylon of 1.1 oz, cords of 550 lb", [] {
                              return descentRate(joined({{"diameter", 10.67},
                                                         {"line_length", 7.77},
                                                         {"sectors", 30},
                                                         {"pressure", 1.68}},
                                                        nylonOfC9()),
                                                 163.3);
                          }});
    references.push_back({section, "T-10D, 35 ft, 360 lb, descent", 6.7, 7.3, "m/s",
                          "FM 57-220; en.wikipedia.org T-10_parachute", builder, [] {
                              return descentRate(
                                  {{"diameter", 10.67}, {"line_length", 7.77}, {"sectors", 30}},
                                  163.3);
                          }});
    references.push_back(
        {section, "flat circular, D0 1 m, 1.1 kg, CD0 0.8, descent", 5.2944, 5.2944, "m/s",
         "Knacke 1991, page 5-128", "parachute with hoop, drag 0.8", [] {
             return descentRate(
                 {{"diameter", 1.0}, {"drag", 0.8}, {"line_length", 1.0}, {"hoop_mass", 0.02}},
                 1.1);
         }});
    const double area = std::numbers::pi * 8.53 * 8.53 / 4.0; // of the C-9, m^2
    references.push_back(
        {section, "C-9, 28 ft, 28 gores, 100 kg, descent",
         std::sqrt(2.0 * 100.0 * 9.80665 / (airDensity * 0.80 * area)),
         std::sqrt(2.0 * 100.0 * 9.80665 / (airDensity * 0.75 * area)), "m/s",
         "Knacke 1991, CD0 0.75 to 0.80 of flat circular canopies", builder, [] {
             return descentRate({{"diameter", 8.53}, {"line_length", 7.3}, {"sectors", 28}}, 100.0);
         }});
    for (const int hoop : {1, 0})
        references.push_back(
            {section,
             std::string("flat circular, projected over nominal diameter, ")
                 + (hoop ? "hoop" : "no hoop"),
             0.67, 0.70, "", "Knacke 1991, table 5-1",
             hoop ? "the hoop is given that width" : "starts open; lines and air alone keep it so",
             [=] { return projectedRatio(hoop); }});
    addOpenings(references, nylonOfC9(), "C-9, canopy pressure, ",
                "no hoop, air in the canopy; nylon of 1.1 oz, cords of 550 lb");
    addOpenings(references, {}, "C-9, ideal, canopy pressure, ",
                "no hoop, air in the canopy; ideal cloth, airtight");
    return references;
}

} // namespace ripstop
