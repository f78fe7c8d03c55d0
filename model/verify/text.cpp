#include "verify/text.h"

#include "verify/reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ripstop {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

std::string printed(const char* format, int count, double number)
{
    char text[40];
    std::snprintf(text, sizeof text, format, count, number);
    return text;
}

} // namespace

std::string digits(double number, int count) { return printed("%.*g", count, number); }

std::string publishedText(double low, double high)
{
    return low == high ? digits(low, 4) : digits(low, 4) + " to " + digits(high, 4);
}

std::string gotText(const ReferenceResult& result)
{
    return std::isfinite(result.got) ? digits(result.got, 4) : "not reached";
}

std::string ratioText(const ReferenceResult& result)
{
    return std::isfinite(result.got) ? printed("%.*f", 2, result.ratio) : "";
}

bool containsText(std::string_view text, std::string_view part)
{
    return std::search(text.begin(), text.end(), part.begin(), part.end(),
                       [](char a, char b) { return lower(a) == lower(b); })
           != text.end();
}

} // namespace ripstop
