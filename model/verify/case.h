// Cases whose answer is known: what must come out, why, and how to find out what does.
//
// The expected values follow from theory or a publication, never from this program. The rows of one
// experiment share an id; its letter is that of the subject: P particles, I integrators, S springs,
// K constraint solvers, R ropes, M membranes, C conservation, B bodies in contact, T tearing, A
// air, F flight. Adding a case is a row in the file of its section.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class Rule {
    Absolute, // |got - expected| <= value, in the unit of the case
    Relative, // |got - expected| <= value x |expected|
    AtMost,   // got <= expected
    AtLeast   // got >= expected
};

struct Tolerance
{
    Rule rule = Rule::Absolute;
    double value = 0.0;
};

constexpr Tolerance within(double value) { return {Rule::Absolute, value}; }
constexpr Tolerance relative(double share) { return {Rule::Relative, share}; }
inline constexpr Tolerance exactly{Rule::Absolute, 0.0};
inline constexpr Tolerance atMost{Rule::AtMost, 0.0};
inline constexpr Tolerance atLeast{Rule::AtLeast, 0.0};

struct Case
{
    std::string id; // several cases may share one: they are rows of the same experiment
    std::string title;
    double expected = 0.0;
    Tolerance tolerance;
    std::string unit;   // empty when dimensionless
    std::string source; // the formula or the publication that `expected` is from
    std::function<double()> measure;
    std::string section = {}; // filled by allCases()
};

struct CaseResult
{
    std::string id;
    std::string title;
    double expected = 0.0;
    double got = 0.0;
    Tolerance tolerance;
    std::string unit;
    std::string source;
    std::string section;
    bool holds = false;
    double seconds = 0.0; // that it took
};

// All cases, in the order of the sections. Results of experiments that several rows share are
// kept as long as the list.
std::vector<Case> allCases();

// The cases that have the text in id, title, section or source; small and capital letters are
// alike.
std::vector<Case> casesWith(std::string_view text);

CaseResult run(const Case& one);

bool holds(double got, double expected, const Tolerance& tolerance); // never for not-a-number

// "0.001 m", "0.1 % of expected", "1e-12 of expected", "at most".
std::string textOf(const Tolerance& tolerance, const std::string& unit);

} // namespace ripstop
