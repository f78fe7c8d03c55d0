// A material that one can buy or has measured: numbers of its properties, and where each of them is
// from.
//
// Presets come from files of materials (material_file.h): the library that the program carries in
// itself (presets.h) and the user's own (own_materials.h).
#pragma once

#include "scene/property.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class PresetKind { Fabric, Film, Line, Spar };
inline constexpr int presetKindCount = 4;
std::string_view presetKindName(PresetKind kind); // "fabric", "film", "line", "spar"
bool isSheet(PresetKind kind);                    // fabric or film: it has an area

// How well a number is known.
enum class NumberStanding {
    Measured, // by the source that is named
    Listed,   // by its maker, its seller or its specification
    Derived,  // worked out from numbers of the source, as the source text says
    Typical,  // what such a material has as a rule; nobody is quoted for this one
    Assumed   // for want of anything better
};
inline constexpr int numberStandingCount = 5;
std::string_view standingName(NumberStanding standing); // "measured", ...

// What a fabric is woven of. It bounds what the weave can hold (strongestMembrane()).
enum class Yarn { Unknown, Nylon, Polyester, Polyethylene };

struct PresetNumber
{
    std::string_view key; // of a property of materials, or breakElongationKey
    Value value;          // SI
    NumberStanding standing = NumberStanding::Assumed;
    std::string source; // who says so, and how it was derived
};

// The strain at which it breaks: noted in files of materials, and no property of a scene's.
inline constexpr std::string_view breakElongationKey = "breakElongation";

// A point of a measured curve of stretch. Nothing flies by it yet: links have one stiffness.
struct StretchPoint
{
    double load;   // N of a line, N/m of a fabric
    double strain; // 1
};

struct StretchCurve
{
    std::vector<StretchPoint> points; // in order of load; empty where none is known
    NumberStanding standing = NumberStanding::Listed;
    std::string source;
};

struct Preset
{
    PresetKind kind = PresetKind::Fabric;
    std::string name;       // "skytex_27", what the command line takes
    std::string label;      // on screen
    std::string shortLabel; // where there is little room; empty, the label is short enough
    std::string note;       // what one should know of it, in sentences
    Yarn yarn = Yarn::Unknown;
    std::vector<PresetNumber> values; // of properties of materials
    std::optional<PresetNumber> breakElongation;
    StretchCurve curve;
    bool own = false; // from the user's file
};

const PresetNumber* findNumber(const Preset& preset, const Property& property); // or null

// What a number of the preset is measured in; that of a tear limit hangs on the tear rule.
std::string_view unitOf(const Preset& preset, const PresetNumber& number);

// Properties of materials that presets may set: the physical ones. Name, colour, how it meets the
// wind and bare springs are the scene's own business.
bool isPhysical(const Property& property);

// The membrane stiffness, N/m, above which no weave of this yarn and weight (kg/m^2) can be: half
// of the yarn lies each way, and crimp only softens it. Nothing for a yarn that is not told.
//     E t <= areal density / 2 x modulus of the yarn per density,
// which is about 4.0 MN m/kg for nylon 6.6, 9.7 for polyester and 113 for polyethylene (HMPE).
std::optional<double> strongestMembrane(Yarn yarn, double arealDensity);

// Why no cloth can have these numbers, or nothing: stiffer than its yarn, or a stiffness by which
// stretching it would give energy (positive definite: nu^2 < E1 / E2).
std::optional<Message> implausible(const Preset& preset);

// The note and each source once, with the names of the numbers that it tells of: a text for a
// tooltip or a terminal.
std::string sourcesOf(const Preset& preset);

} // namespace ripstop
