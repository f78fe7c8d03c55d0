#include "io/load_table.h"

#include "io/csv.h"
#include "io/element_part.h"
#include "io/json_text.h"
#include "io/whole_file.h"

namespace ripstop {
namespace {

void appendRows(std::string& text, const Scene& scene, const char* of,
                std::span<const LoadedPlace> places)
{
    int rank = 0;
    for (const LoadedPlace& place : places) {
        text += of;
        text += ',' + std::to_string(++rank) + ',';
        appendNumber(text, place.time);
        text += ',';
        text += choiceNames<LoadKind>[std::size_t(place.kind)];
        text += ',' + std::to_string(place.element) + ','
                + csvCell(partOfElement(scene, Id{place.element}).name) + ',';
        appendNumber(text, place.load);
        text += ',';
        if (place.strength > 0.0)
            appendNumber(text, place.strength);
        text += ',';
        text += unitOf(place.kind);
        text += ',';
        if (place.strength > 0.0)
            appendNumber(text, place.margin());
        for (const double value : place.place) {
            text += ',';
            appendNumber(text, value);
        }
        text += place.torn ? ",1," : ",0,";
        appendNumber(text, place.shortfall);
        text += '\n';
    }
}

} // namespace

std::optional<Failure> writeLoads(const Scene& scene, const Frame& last,
                                  const std::filesystem::path& file)
{
    std::string text = "of,rank,time (s),kind,element,part,load,strength,unit,margin,"
                       "x (m),y (m),z (m),torn,shortfall\n";
    appendRows(text, scene, "moment", last.worstNow.all());
    appendRows(text, scene, "run", last.worstOfRun.all());
    appendRows(text, scene, "first to break", last.firstBreaks.all());
    return replaceFile(file, text);
}

} // namespace ripstop
