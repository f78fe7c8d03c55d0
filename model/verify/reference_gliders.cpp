// Hang gliders: glide ratio and sink of three generations.
//
// Each wing is flown at nine trims, which gives a polar of speed and sink; best glide, least sink
// and the sink at a speed are then read from the polar. A polar is flown once for all rows of its
// wing.
#include "verify/reference_sections.h"
#include "verify/sections.h"

#include "measure/diagnostics.h"

#include <algorithm>
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
    double drag; // 1, CD0 of its class
};

struct Point
{
    double speed; // m/s, along the path
    double sink;  // m/s
};

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
        const auto glider =
            design("hang_glider", {{"cloth", 0.0}, // ideal: the wing keeps its shape
                                   {"span", span},
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

} // namespace

std::vector<Reference> gliderReferences()
{
    const std::string section = "Hang gliders";
    std::vector<Reference> references;
    const auto row = [&](const ReferenceWing& wing, const char* what, double low, double high,
                         const char* unit, const char* source, auto measure) {
        char note[160];
        std::snprintf(note, sizeof note,
                      "hang_glider, %g m2, aspect ratio %g, %g kg, CD0 %g, law %s", wing.area,
                      wing.aspect, wing.mass, wing.drag, nameOf(wing.law).c_str());
        references.push_back({section, wing.name + std::string(", ") + what, low, high, unit,
                              source, note, measure});
    };
    const ReferenceWing rogallo{
        "standard Rogallo of the 1970s", 18.0, 2.6, 90.0, AirLaw::LinearNormal, 0.06};
    const auto old = shared([=] { return polarOf(rogallo); });
    row(rogallo, "best glide", 3.5, 4.5, "", "british-hang-gliding-museum; plans of 1974",
        [=] { return bestGlide(old()); });

    const ReferenceWing single{"single surface, USHPA-2", 15.5, 5.5, 100.0, AirLaw::Vortex, 0.045};
    const auto middle = shared([=] { return polarOf(single); });
    row(single, "best glide", 9.5, 9.5, "", "XCSoar PolarStore",
        [=] { return bestGlide(middle()); });
    row(single, "least sink", 1.04, 1.04, "m/s", "XCSoar PolarStore",
        [=] { return leastSink(middle()); });
    const char* sport = "Wills ReferenceWing Sport 2, f0n/polar";
    for (const auto& [speed, sink] : {std::pair(44.4, 0.987), {64.0, 2.28}, {88.5, 6.10}}) {
        char title[60];
        std::snprintf(title, sizeof title, "sink at %g km/h, beside a Sport 2", speed);
        row(single, title, sink, sink, "m/s", sport,
            [=, speed = speed] { return sinkAt(middle(), speed / 3.6); });
    }

    const ReferenceWing topless{"topless, USHPA-4", 14.0, 7.2, 100.0, AirLaw::Vortex, 0.03};
    const auto late = shared([=] { return polarOf(topless); });
    row(topless, "best glide", 13.4, 13.4, "", "XCSoar PolarStore",
        [=] { return bestGlide(late()); });
    row(topless, "least sink", 0.88, 0.88, "m/s", "XCSoar PolarStore",
        [=] { return leastSink(late()); });
    return references;
}

} // namespace ripstop
