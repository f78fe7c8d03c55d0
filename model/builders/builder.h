// Builders: parametric designs.
//
// A builder is one row of a table: its parameters with unit, default and range, and a function
// that turns values into a whole scene. The command line, the forms of the editor and the manual
// are made from the rows.
//
// A parameter that is not said is `initial`: files leave out what was not there when they were
// saved, and are built again as they were. A new design may be offered something else: the craft
// are made of real materials, and `initial` are the ideal ones of the papers.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ripstop {

// What another parameter has to be for this one to count. One that does not count itself is as if
// it were zero.
struct ParameterNeed
{
    enum class Is { Zero, NotZero }; // the first choice is zero: ideal, or none
    std::string_view key;            // empty: it always counts
    Is is = Is::Zero;
};

constexpr ParameterNeed isZero(std::string_view key) { return {key, ParameterNeed::Is::Zero}; }
constexpr ParameterNeed isNotZero(std::string_view key)
{
    return {key, ParameterNeed::Is::NotZero};
}

struct Parameter
{
    std::string_view key;
    std::string_view unit; // SI; empty for counts and switches
    double initial;        // where nothing is said of it
    double low;
    double high;
    bool whole; // counts, switches (0 or 1) and choices
    std::string_view help;
    std::string_view group = {};                    // heading over this one and those after it
    std::span<const std::string_view> choices = {}; // what whole numbers from 0 on stand for
    std::optional<double> offered = {};             // of a new design, where that is not `initial`
    ParameterNeed needs = {};

    double atFirst() const { return offered.value_or(initial); } // of a new design
};

// Joins tables of parameters into one.
template <std::size_t... counts>
constexpr auto joined(const std::array<Parameter, counts>&... tables)
{
    std::array<Parameter, (counts + ...)> all{};
    std::size_t count = 0;
    const auto append = [&](const auto& table) {
        for (const Parameter& parameter : table)
            all[count++] = parameter;
    };
    (append(tables), ...);
    return all;
}

using Parameters = std::map<std::string, double>;

// Whether it changes anything beside these values, which say all of them.
bool counts(const Parameter& parameter, std::span<const Parameter> all, const Parameters& values);

// Rows of numbers, as one copies them from a spreadsheet. Among the parameters its cells are called
// KEY.ROW.COLUMN, from 1 on: "lengths.2.1".
struct TableParameter
{
    std::string_view key;
    std::string_view unit; // SI, of every number
    double low;
    double high;
    std::string_view help;
};

enum class Family { Wings, Canopies, Cloth, Lines, Obstacles };

struct Builder
{
    std::string_view name;
    std::string_view label; // on screen
    std::string_view help;
    std::span<const Parameter> parameters;
    // Every number is there and in range. May fail where they do not go together.
    Result<Scene> (*build)(const Parameters&);
    Family family;
    const TableParameter* table = nullptr; // null for most
};

std::span<const Builder> allBuilders();            // by family
const Builder* findBuilder(std::string_view name); // null when there is none

// Fills in what is not said with `initial` and checks names and ranges, then builds.
Result<Scene> build(const Builder& builder, const Parameters& given);

Parameters unsaid(const Builder& builder); // every parameter at `initial`

// What is said of a new design, with what is offered for the rest. Who says that its cloth is ideal
// wants the papers' design, and is offered nothing else; who gives another number than the usual
// that counts beside an ideal material only, as the stiffness of a rope, is not offered a real one
// there, and for one that counts without pressure in a canopy only has the papers' canopy.
Parameters newDesign(const Builder& builder, const Parameters& given);

void setTable(Parameters& parameters, const TableParameter& table, const NumberRows& rows);
NumberRows tableOf(const Parameters& parameters,
                   const TableParameter& table); // empty without cells

// Cells between tabs, commas or blanks, rows between line breaks or semicolons; between tabs, a
// comma may stand for the point. A refusal names row and column.
Result<NumberRows> tableFromText(const TableParameter& table, std::string_view text);

} // namespace ripstop
