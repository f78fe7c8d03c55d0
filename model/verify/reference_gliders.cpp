// Hang gliders: glide ratio and sink of three generations.
//
// Each wing is flown at nine trims, which gives a polar of speed and sink; best glide, least sink
// and the sink at a speed are then read from the polar. A polar is flown once for all rows of its
// wing.
#include "verify/reference_sections.h"
#include "verify/sections.h"

#include "measure/diagnostics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

struct ReferenceWing
{
    const char* name;
    double area;   // m^2
    double aspect; // 1, span^2 / area
    double mass;   // kg, with pilot
    AirLaw law;
    double drag;                 // 1, CD0 of its class
    const char* cloth = "ideal"; // keeps its shape
    const char* spars = "ideal";
    const char* made = "ideal"; // in words
    double luffLines = 0.0;     // of each half; the first Rogallos had none
};

struct Point
{
    double speed; // m/s, along the path
    double sink;  // m/s
};

// The fittings of a wing of real cloth weigh what sail, tubes and pilot leave of its mass.
std::unique_ptr<Simulation> flown(const ReferenceWing& wing, Parameters given)
{
    for (const auto& [parameter, choice] :
         {std::pair("cloth", wing.cloth), std::pair("spars", wing.spars)})
        given[parameter] = choiceOf("hang_glider", parameter, choice);
    if (given["cloth"] > 0.0) {
        given["luff_lines"] = wing.luffLines;
        given["fittings"] = 1.0;
        const auto light = design("hang_glider", given);
        if (!light)
            return nullptr;
        given["fittings"] = wing.mass - (totalMass(light->system()) - 1.0);
    }
    return design("hang_glider", given);
}

// Flown at nine trims; by rising speed. Sail and twist are the builder's. With the plate law the
// slope is that which the builder's help gives for a delta of this aspect ratio,
// 2 pi A / (2 + sqrt(A^2 + 8)).
std::vector<Point> polarOf(const ReferenceWing& wing)
{
    const double span = std::sqrt(wing.aspect * wing.area);
    const double slope = 2.0 * 3.14159265358979323846 * wing.aspect
                         / (2.0 + std::sqrt(wing.aspect * wing.aspect + 8.0));
    std::vector<Point> polar;
    for (const double trim : {8.0, 9.0, 10.0, 11.0, 12.5, 15.0, 18.0, 22.0, 26.0}) {
        const auto glider = flown(wing, {{"span", span},
                                         {"chord", 2.0 * wing.area / span},
                                         {"wing_mass", 0.3 * wing.mass},
                                         {"pilot_mass", 0.7 * wing.mass},
                                         {"lift_slope", slope},
                                         {"vortex", wing.law == AirLaw::Vortex},
                                         {"drag", wing.drag},
                                         {"speed", trim},
                                         {"altitude", 2000.0}});
        if (!glider || !glider->runUntil(30.0))
            continue;
        const Vec3 from = centerOfMass(glider->system(), glider->state().position);
        if (!glider->runUntil(64.0)) // some four swings of speed against height
            continue;
        const Vec3 way = (centerOfMass(glider->system(), glider->state().position) - from) / 34.0;
        if (way.y() < 0.0 && std::hypot(way.x(), way.z()) > -way.y()) // glides
            polar.push_back({way.norm(), -way.y()});
    }
    std::sort(polar.begin(), polar.end(),
              [](const Point& a, const Point& b) { return a.speed < b.speed; });
    return polar;
}

double bestGlide(const std::vector<Point>& polar)
{
    double best = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : polar)
        best = std::fmax(best, std::sqrt(point.speed * point.speed - point.sink * point.sink)
                                   / point.sink);
    return best;
}

double leastSink(const std::vector<Point>& polar) // m/s
{
    double least = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : polar)
        least = std::fmin(least, point.sink);
    return least;
}

double sinkAt(const std::vector<Point>& polar, double speed) // m/s, between the points
{
    for (std::size_t i = 1; i < polar.size(); ++i)
        if (polar[i - 1].speed <= speed && speed <= polar[i].speed) {
            const double share =
                (speed - polar[i - 1].speed) / (polar[i].speed - polar[i - 1].speed);
            return polar[i - 1].sink + share * (polar[i].sink - polar[i - 1].sink);
        }
    return std::numeric_limits<double>::quiet_NaN();
}

// A wing of real materials, and the ideal one.
std::array<ReferenceWing, 2> both(ReferenceWing wing, const char* cloth, const char* spars,
                                  const char* made, double luffLines = 0.0)
{
    const ReferenceWing ideal = wing;
    wing.cloth = cloth;
    wing.spars = spars;
    wing.made = made;
    wing.luffLines = luffLines;
    return {wing, ideal};
}

template <typename Row> // row(wing, what, low, high, unit, source, measure)
void addSingleSurfaces(Row row)
{
    const ReferenceWing wing{"single surface, USHPA-2", 15.5, 5.5, 100.0, AirLaw::Vortex, 0.045};
    for (const ReferenceWing& single :
         both(wing, "dacron_sail", "aluminium_50", "Dacron on 50 mm tubes, luff lines", 2.0)) {
        const auto polar = shared([=] { return polarOf(single); });
        row(single, "best glide", 9.5, 9.5, "", "XCSoar PolarStore",
            [=] { return bestGlide(polar()); });
        row(single, "least sink", 1.04, 1.04, "m/s", "XCSoar PolarStore",
            [=] { return leastSink(polar()); });
        const char* sport = "Wills Wing Sport 2, f0n/polar";
        for (const auto& [speed, sink] : {std::pair(44.4, 0.987), {64.0, 2.28}, {88.5, 6.10}}) {
            char title[60];
            std::snprintf(title, sizeof title, "sink at %g km/h, beside a Sport 2", speed);
            row(single, title, sink, sink, "m/s", sport,
                [=, speed = speed] { return sinkAt(polar(), speed / 3.6); });
        }
    }
}

template <typename Row>
void addTopless(Row row)
{
    const ReferenceWing wing{"topless, USHPA-4", 14.0, 7.2, 100.0, AirLaw::Vortex, 0.03};
    for (const ReferenceWing& topless :
         both(wing, "laminate_scrim", "aluminium_62", "laminate on 62 mm tubes, luff lines", 2.0)) {
        const auto polar = shared([=] { return polarOf(topless); });
        row(topless, "best glide", 13.4, 13.4, "", "XCSoar PolarStore",
            [=] { return bestGlide(polar()); });
        row(topless, "least sink", 0.88, 0.88, "m/s", "XCSoar PolarStore",
            [=] { return leastSink(polar()); });
    }
}

} // namespace

std::vector<Reference> gliderReferences()
{
    const std::string section = "Hang gliders";
    std::vector<Reference> references;
    const auto row = [&](const ReferenceWing& wing, const char* what, double low, double high,
                         const char* unit, const char* source, auto measure) {
        char note[160];
        std::snprintf(note, sizeof note,
                      "hang_glider, %g m2, aspect ratio %g, %g kg, CD0 %g, law %s, %s", wing.area,
                      wing.aspect, wing.mass, wing.drag, nameOf(wing.law).c_str(), wing.made);
        const bool isIdeal = wing.made == std::string_view("ideal");
        references.push_back({section, wing.name + std::string(isIdeal ? ", ideal, " : ", ") + what,
                              low, high, unit, source, note, measure});
    };
    const ReferenceWing ofTheSeventies{
        "standard Rogallo of the 1970s", 18.0, 2.6, 90.0, AirLaw::LinearNormal, 0.06};
    for (const ReferenceWing& rogallo :
         both(ofTheSeventies, "dacron_sail", "aluminium_42", "Dacron on 42 mm tubes")) {
        const auto old = shared([=] { return polarOf(rogallo); });
        row(rogallo, "best glide", 3.5, 4.5, "", "british-hang-gliding-museum; plans of 1974",
            [=] { return bestGlide(old()); });
    }
    addSingleSurfaces(row);
    addTopless(row);
    return references;
}

} // namespace ripstop
