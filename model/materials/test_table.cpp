// Reading of the table of a test: the header says which columns are meant, then each row gives two
// numbers, and every complaint names the line.
#include "base/number_table.h"
#include "materials/material_test.h"
#include "scene/units.h"

#include <algorithm>

namespace ripstop {
namespace {

// Where the two columns are, and SI units in one of theirs.
struct Columns
{
    std::size_t force = 0;
    std::size_t elongation = 1;
    std::size_t count = 2;
    double forceFactor = 1.0;
    double elongationFactor = 1.0; // to TestPoint
};

bool isOneOfWords(const std::string& word, std::initializer_list<std::string_view> words)
{
    return std::ranges::any_of(words, [&](std::string_view one) {
        return word == one || word.starts_with(std::string(one) + ' ');
    });
}

bool isForce(const std::string& word)
{
    return isOneOfWords(word, {"force", "load", "pull", "tension", "f"});
}

bool isElongation(const std::string& word)
{
    return isOneOfWords(word, {"elongation", "extension", "stretch", "displacement", "deflection",
                               "strain", "travel", "x"});
}

std::optional<Failure> findColumns(const TableLine& header, std::string_view name, TestUnits& units,
                                   Columns& columns)
{
    std::optional<std::size_t> force, elongation;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        const auto [word, unit] = nameAndUnit(header.cells[i]);
        if (!force && isForce(word)) {
            force = i;
            if (units.force.empty())
                units.force = unit;
        } else if (!elongation && isElongation(word)) {
            elongation = i;
            if (units.elongation.empty())
                units.elongation = unit.empty() && word.starts_with("strain") ? "strain" : unit;
        }
    }
    if (!force || !elongation)
        return Failure("%1, line %2: The header names no column for the %3; write \"force "
                       "(N),elongation (mm)\" for example.",
                       name, header.number, force ? Message("elongation") : Message("force"));
    columns.force = *force;
    columns.elongation = *elongation;
    columns.count = header.cells.size();
    return std::nullopt;
}

// A length is over that of the specimen; a strain of a rod makes no sense.
std::optional<Failure> findUnits(std::string_view name, const TestUnits& units,
                                 const SpecimenSize& size, Columns& columns)
{
    const auto force = units.force.empty() ? std::nullopt : unitFactor(units.force, "N");
    if (!force)
        return Failure("%1: The unit of the force is not told: write \"force (N)\" in the header, "
                       "or give it.",
                       name);
    columns.forceFactor = *force;
    const auto length = units.elongation.empty() ? std::nullopt : unitFactor(units.elongation, "m");
    const auto strain = units.elongation == "strain" || units.elongation == "1" ? std::optional(1.0)
                        : units.elongation.empty()                              ? std::nullopt
                                                   : unitFactor(units.elongation, "");
    if (length && size.specimen == Specimen::Rod)
        columns.elongationFactor = *length;
    else if (length)
        columns.elongationFactor = *length / size.length;
    else if (strain && size.specimen != Specimen::Rod)
        columns.elongationFactor = *strain;
    else if (size.specimen == Specimen::Rod)
        return Failure("%1: The unit of the deflection is not told: write \"deflection (mm)\" in "
                       "the header, or give it.",
                       name);
    else
        return Failure("%1: The unit of the elongation is not told: write \"elongation (mm)\" or "
                       "\"strain (%)\" in the header, or give it.",
                       name);
    return std::nullopt;
}

} // namespace

Result<MaterialTest> readMaterialTest(std::string_view text, std::string_view name,
                                      const SpecimenSize& size, const TestUnits& given)
{
    if (!(size.length > 0.0) || (size.specimen == Specimen::Strip && !(size.width > 0.0)))
        return Failure("The size of the specimen must be told: its length, and of a strip its "
                       "width, above 0.");
    std::vector<TableLine> lines = tableLines(text);
    if (lines.empty())
        return Failure("%1 has no rows.", name);
    Columns columns;
    TestUnits units = given;
    if (isHeader(lines.front())) {
        if (const auto failure = findColumns(lines.front(), name, units, columns))
            return *failure;
        lines.erase(lines.begin());
    } else if (units.force.empty() || units.elongation.empty()) {
        return Failure("%1 has no header: begin it with a line like \"force (N),elongation (mm)\", "
                       "or give both units of columns in this order.",
                       name);
    }
    if (const auto failure = findUnits(name, units, size, columns))
        return *failure;
    MaterialTest test;
    std::vector<TestPoint>& points = test.points;
    for (const TableLine& line : lines) {
        if (line.cells.size() != columns.count)
            return Failure("%1, line %2: It has %3 cells instead of %4; decimals are written with "
                           "a point.",
                           name, line.number, line.cells.size(), columns.count);
        if (line.cells[columns.force].empty() || line.cells[columns.elongation].empty()) {
            test.skipped.push_back(line.number);
            continue;
        }
        const Result<double> force = numberAt(line, columns.force, name);
        if (!force)
            return force.failure();
        const Result<double> elongation = numberAt(line, columns.elongation, name);
        if (!elongation)
            return elongation.failure();
        const TestPoint point{*elongation * columns.elongationFactor, *force * columns.forceFactor};
        if (!points.empty() && point.elongation < points.back().elongation)
            return Failure("%1, line %2: The elongation goes back. A test is one pull, from slack "
                           "until it ends or breaks; leave out the way back.",
                           name, line.number);
        points.push_back(point);
    }
    if (points.size() < 3)
        return Failure("%1 has %2 rows of numbers; a fit needs three or more.", name,
                       points.size());
    return test;
}

std::optional<Message> skippedText(const MaterialTest& test)
{
    if (test.skipped.empty())
        return std::nullopt;
    if (test.skipped.size() == 1)
        return Message("Line %1 has an empty cell and is left out.", test.skipped.front());
    return Message("%1 lines have an empty cell and are left out, the first of them line %2.",
                   test.skipped.size(), test.skipped.front());
}

} // namespace ripstop
