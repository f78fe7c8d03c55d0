#include "verify/reference.h"

#include "verify/reference_sections.h"
#include "verify/text.h"

#include <chrono>
#include <iterator>

namespace ripstop {

std::vector<Reference> allReferences()
{
    std::vector<Reference> all;
    for (const auto section :
         {parachuteReferences, kiteReferences, gliderReferences, shapeReferences}) {
        std::vector<Reference> references = section();
        std::move(references.begin(), references.end(), std::back_inserter(all));
    }
    return all;
}

std::vector<Reference> referencesWith(std::string_view text)
{
    std::vector<Reference> references = allReferences();
    std::erase_if(references, [&](const Reference& one) {
        return !containsText(one.section, text) && !containsText(one.title, text)
               && !containsText(one.source, text) && !containsText(one.note, text);
    });
    return references;
}

ReferenceResult run(const Reference& reference)
{
    const auto start = std::chrono::steady_clock::now();
    const double got = reference.measure();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    ReferenceResult result;
    result.section = reference.section;
    result.title = reference.title;
    result.low = reference.low;
    result.high = reference.high;
    result.got = got;
    result.ratio = got / (0.5 * (reference.low + reference.high));
    result.inside = got >= reference.low && got <= reference.high;
    result.unit = reference.unit;
    result.source = reference.source;
    result.note = reference.note;
    result.seconds = taken.count();
    return result;
}

} // namespace ripstop
