// Deltas on a line: at what angle they stand and how hard they pull.
#include "verify/reference_sections.h"
#include "verify/sections.h"

#include <array>
#include <limits>

namespace ripstop {
namespace {

enum class Made { Ideal, OfRipstop };

// 1.2 m^2 and 0.25 kg, tow point and all else as the builder has it. Of ripstop of 0.75 oz on
// fibreglass tubes of 8 mm it weighs 0.235 kg.
std::array<double, 2> flown(double wind, Made made) // degrees, N
{
    Parameters given{{"span", 2.2}, {"chord", 1.09}, {"wind", wind}};
    if (made == Made::Ideal) {
        given.insert({{"cloth", 0.0}, {"frame_mass", 0.19}});
    } else {
        for (const auto& [parameter, choice] : {std::pair("cloth", "ripstop_075"),
                                                {"spars", "fibreglass_tube_8"},
                                                {"cord", "liros_ltc45"}})
            given[parameter] = choiceOf("delta_kite", parameter, choice);
        given["keel_length"] = 0.7;
    }
    const auto kite = design("delta_kite", given);
    if (!kite)
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    const double angle = meanProbe(*kite, "line angle", 25.0, 30.0);
    return {angle, meanProbe(*kite, "line tension", 30.0, 35.0)};
}

} // namespace

std::vector<Reference> kiteReferences()
{
    const std::string section = "Kites";
    const std::string size = "delta_kite, span 2.2 m, chord 1.09 m, 25 m of line";
    const std::string theory = "flat delta of 1.2 m2, 0.25 kg, CLa 2.57, CD0 0.03 at 10 to 20 "
                               "degrees of attack, computed";
    struct Day
    {
        double wind;                // m/s
        double pullLow, pullHigh;   // N
        double angleLow, angleHigh; // degrees
    };
    std::vector<Reference> references;
    for (const Day& day : {Day{4.0, 3.0, 8.2, 62.0, 65.0},
                           {6.0, 9.6, 21.3, 66.0, 73.0},
                           {8.0, 18.9, 39.5, 67.0, 74.0}}) {
        const std::string at = " at " + std::to_string(int(day.wind)) + " m/s";
        for (const Made made : {Made::OfRipstop, Made::Ideal}) {
            const auto kite = shared([wind = day.wind, made] { return flown(wind, made); });
            const std::string note =
                size
                + (made == Made::Ideal ? ", ideal"
                                       : ", of 0.75 oz ripstop and 8 mm fibreglass, 0.235 kg");
            const std::string delta =
                made == Made::Ideal ? "single-line delta, ideal, " : "single-line delta, ";
            references.push_back({section, delta + "angle of the line" + at, 50.0, 70.0, "deg",
                                  "typical value in the field, unsourced", note,
                                  [=] { return kite()[0]; }});
            references.push_back({section, delta + "angle beside theory" + at, day.angleLow,
                                  day.angleHigh, "deg", theory, note, [=] { return kite()[0]; }});
            references.push_back({section, delta + "pull beside theory" + at, day.pullLow,
                                  day.pullHigh, "N", theory, note, [=] { return kite()[1]; }});
        }
    }
    return references;
}

} // namespace ripstop
