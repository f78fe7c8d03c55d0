// Formulas of probes: a number made of others that have names and units, as "line_tension /
// weight" or "sqrt(a^2 + b^2)".
// A formula is read once, when a scene is checked or compiled, and evaluated for each reading of
// the probes (simulation/probe_reader.h). value() writes into variables of the parser, so that one
// formula belongs to one thread at a time. muParser stays in the source.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// One formula that has been read.
//
// Names are written with _ for what is neither a letter nor a digit. Functions: sqrt, abs, min,
// max, sin, cos, tan, asin, acos, atan, atan2, exp, ln. Angles are radians inside, so that sin()
// takes them as they come. The unit of the result follows from those that go into it, and like is
// added to like only: it is found as a physicist would, by making each basic unit smaller
// (expression.h).
class Formula
{
public:
    struct Name
    {
        std::string name;
        std::string unit; // as people write it: "m/s", "deg"
    };

    // The failure says what to change, without the name of what the formula belongs to.
    static Result<Formula> read(std::string_view text, std::span<const Name> names);

    // What `text` names that is none of `names`; empty where there is no such thing.
    static std::string unknownName(std::string_view text, std::span<const Name> names);

    Formula(Formula&&) noexcept;
    Formula& operator=(Formula&&) noexcept;
    ~Formula();

    const std::string& unit() const;              // "deg" of angles; empty of pure numbers
    const std::vector<std::size_t>& used() const; // indices of names, ascending

    // The result in unit(), from one value for each name, in the unit of that name.
    //   values  [names]
    double value(std::span<const double> values);

private:
    class Parts;
    explicit Formula(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

// How a formula writes a name.
std::string wordFor(std::string_view name);

// The formulas of a scene's probes. One may use all probes that are measured, and those formulas
// that stand before it.
struct ProbeFormula
{
    Id probe;
    Result<Formula> formula;
};
std::vector<ProbeFormula> formulasOf(const Scene& scene);

} // namespace ripstop
