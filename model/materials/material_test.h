// A stiffness from a test: forces and elongations that somebody has measured become E t of a strip
// of cloth, EA of a line or EI of a bent rod.
//
// A straight line F = a + k x is fitted to the points of a range of elongation by least squares:
// the errors are taken to be those of the force, alike and independent. Then
//
//     strip of width w     E t = k / w       x is strain
//     line                 EA  = k           x is strain
//     rod on two supports  EI  = k L^3 / 48  x is the deflection in the middle, L the span
//
// and the standard error of each follows from that of k, s / sqrt(sum (x - mean)^2) with the
// residual s^2 = sum (F - a - k x)^2 / (n - 2). The offset a takes up the toe that crimp, slack or
// play make at the beginning.
#pragma once

#include "base/result.h"
#include "materials/preset.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class Specimen { Strip, Line, Rod };
inline constexpr int specimenCount = 3;
std::string_view specimenName(Specimen specimen); // "strip", "line", "rod"

enum class PullDirection { Warp, Weft };

struct SpecimenSize
{
    Specimen specimen = Specimen::Strip;
    double length = 0.0; // m, between the marks or clamps; of a rod between its supports
    double width = 0.0;  // m, of a strip
    PullDirection direction = PullDirection::Warp; // of a strip
};

// Units of the columns where the header does not say them, "N" and "mm" for example; empty leaves
// it to the header.
struct TestUnits
{
    std::string force;
    std::string elongation; // "mm", or "%" and "strain" for one that is over the length
};

struct TestPoint
{
    double elongation; // 1, strain; of a rod m
    double force;      // N
};

struct MaterialTest
{
    std::vector<TestPoint> points;
    std::vector<int> skipped; // lines, from 1
};

// Reads a table with a column for the force and one for the elongation, separated by commas,
// semicolons or tabs. A header names them, with units: "force (N),elongation (mm)"; without one
// they stand in this order and have the units that are given. Lines that begin with # are remarks.
// A row in which one of the two cells is empty is skipped, as loggers leave them.
Result<MaterialTest> readMaterialTest(std::string_view text, std::string_view name,
                                      const SpecimenSize& size, const TestUnits& units);

// Names the lines that were skipped; nothing where there are none.
std::optional<Message> skippedText(const MaterialTest& test);

struct ElongationRange
{
    double from; // as TestPoint
    double to;
};

struct MaterialFit
{
    double stiffness = 0.0;     // N/m of a strip (E t), N of a line (EA), N m^2 of a rod (EI)
    double standardError = 0.0; // in the same unit
    double slope = 0.0;         // k, N or N/m
    double offset = 0.0;        // a, N
    double residual = 0.0;      // s, N
    ElongationRange range{};
    int points = 0;         // that were used
    double highest = 0.0;   // N, the largest force
    bool broke = false;     // the force fell to less than half of it afterwards
    double highestAt = 0.0; // its elongation
    std::optional<double>
        strength; // strength if it broke: N/m of a strip, N of a line, N m of a rod
};

// Fits the points in the range, or without one those between 10 and 60 % of the largest force:
// above the toe and below what breaking does. What came after the largest force is left out.
Result<MaterialFit> fitMaterialTest(const std::vector<TestPoint>& points, const SpecimenSize& size,
                                    std::optional<ElongationRange> range);

// What the fit says, as a preset: `source` names the file. Numbers that no test gives come from
// `like`, when there is one.
Preset presetOf(const MaterialFit& fit, const std::vector<TestPoint>& points,
                const SpecimenSize& size, std::string name, std::string_view source,
                const Preset* like = nullptr);

std::string_view stiffnessUnit(Specimen specimen);                   // "N/m", "N", "N m²"
const Property& stiffnessOf(const SpecimenSize& size);               // what is fitted
const Property& strengthOf(const SpecimenSize& size);                // what breaking tells
Message summaryOf(const MaterialFit& fit, const SpecimenSize& size); // one sentence
std::string_view elongationUnit(Specimen specimen);                  // "%" or "mm"
double shownElongation(double elongation, Specimen specimen);        // in that unit

} // namespace ripstop
