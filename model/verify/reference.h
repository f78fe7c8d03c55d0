// Comparisons with measured data: what shipped designs do beside what was published of real ones.
//
// These are no cases: nothing must hold. A design is built from the dimensions and the masses that
// are published, everything else stays as its builder has it, and no row has numbers of its own
// that would make it fit. A ratio far from one says what the laws cannot do.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct Reference
{
    std::string section;
    std::string title;
    double low = 0.0; // as published; both alike when it is one number
    double high = 0.0;
    std::string unit;   // empty when dimensionless
    std::string source; // of the published number
    std::string note;   // how it was simulated
    std::function<double()> measure;
};

struct ReferenceResult
{
    std::string section;
    std::string title;
    double low = 0.0;
    double high = 0.0;
    double got = 0.0;   // not a number when the design does not get there
    double ratio = 0.0; // got over the middle of what was published
    bool inside = false;
    std::string unit;
    std::string source;
    std::string note;
    double seconds = 0.0; // that it took
};

std::vector<Reference> allReferences();

// The comparisons that have the text in section, title, source or note, whatever the case of its
// letters.
std::vector<Reference> referencesWith(std::string_view text);

ReferenceResult run(const Reference& reference);

} // namespace ripstop
