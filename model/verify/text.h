// Numbers and results as text, for the reports of cases and comparisons, and the search for text
// that their filters use. Pure functions; any thread may call them.
#pragma once

#include <string>
#include <string_view>

namespace ripstop {

struct ReferenceResult;

// "0.0123", "4.2e-05": nine significant digits, or as many as asked for.
std::string digits(double number, int count = 9);

// "3.5", "0.65 to 0.85": what was published, four significant digits.
std::string publishedText(double low, double high);

// What came out, four significant digits, and its ratio to what was published, two decimals; "not
// reached" and nothing when the design does not get there.
std::string gotText(const ReferenceResult& result);
std::string ratioText(const ReferenceResult& result);

// Whether `part` occurs in `text`; small and capital letters of ASCII are alike.
bool containsText(std::string_view text, std::string_view part);

} // namespace ripstop
