#include "io/tear_table.h"

#include "io/csv.h"
#include "io/element_part.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "run/tear_report.h"

namespace ripstop {
std::optional<Failure> writeTears(const Scene& scene, std::span<const Tear> tears,
                                  const std::filesystem::path& file)
{
    std::string text = "time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m),"
                       "tension (N/m),moment (N m)\n";
    for (const Tear& tear : tears) {
        const ElementPart torn = partOfElement(scene, Id{tear.element});
        appendNumber(text, tear.time);
        text += ',' + std::to_string(tear.element) + ',' + csvCell(torn.name) + ',';
        appendNumber(text, tear.strain);
        text += ',';
        const bool isMoment = isSnap(tear);
        if (!torn.isPanel && !isMoment)
            appendNumber(text, tear.force);
        for (const double value : {tear.energy, tear.place.x(), tear.place.y(), tear.place.z()}) {
            text += ',';
            appendNumber(text, value);
        }
        text += ',';
        if (torn.isPanel)
            appendNumber(text, tear.force);
        text += ',';
        if (isMoment)
            appendNumber(text, tear.force);
        text += '\n';
    }
    return replaceFile(file, text);
}

} // namespace ripstop
