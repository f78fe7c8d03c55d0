#include "verify/case.h"

#include "verify/text.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace ripstop {
std::vector<Case> casesWith(std::string_view text)
{
    std::vector<Case> cases = allCases();
    std::erase_if(cases, [&](const Case& one) {
        return !containsText(one.id, text) && !containsText(one.title, text)
               && !containsText(one.section, text) && !containsText(one.source, text);
    });
    return cases;
}

CaseResult run(const Case& one)
{
    const auto start = std::chrono::steady_clock::now();
    const double got = one.measure();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    return {one.id,       one.title,     one.expected,
            got,          one.tolerance, one.unit,
            one.source,   one.section,   holds(got, one.expected, one.tolerance),
            taken.count()};
}

bool holds(double got, double expected, const Tolerance& tolerance)
{
    switch (tolerance.rule) {
    case Rule::Absolute:
        return std::abs(got - expected) <= tolerance.value;
    case Rule::Relative:
        return std::abs(got - expected) <= tolerance.value * std::abs(expected);
    case Rule::AtMost:
        return got <= expected;
    case Rule::AtLeast:
        return got >= expected;
    }
    return false;
}

std::string textOf(const Tolerance& tolerance, const std::string& unit)
{
    char text[40];
    switch (tolerance.rule) {
    case Rule::Absolute:
        if (tolerance.value == 0.0)
            return "exact";
        std::snprintf(text, sizeof text, "%.3g", tolerance.value);
        return text + (unit.empty() ? std::string() : ' ' + unit);
    case Rule::Relative:
        if (tolerance.value < 1e-4)
            std::snprintf(text, sizeof text, "%.3g of expected", tolerance.value);
        else
            std::snprintf(text, sizeof text, "%.3g %% of expected", 100.0 * tolerance.value);
        return text;
    case Rule::AtMost:
        return "at most";
    case Rule::AtLeast:
        return "at least";
    }
    return {};
}

} // namespace ripstop
