#include "io/tear_table.h"

#include "io/csv.h"
#include "io/element_part.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "run/tear_events.h"
#include "run/tear_report.h"

namespace ripstop {
std::optional<Failure> writeTears(const Scene& scene, const Frame& frame,
                                  const std::filesystem::path& file)
{
    std::string text = "time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m),"
                       "tension (N/m),moment (N m),event\n";
    const TearEvents events = frame.layout ? tearEvents(frame.tears, *frame.layout) : TearEvents();
    for (std::size_t i = 0; i < frame.tears.size(); ++i) {
        const Tear& tear = frame.tears[i];
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
        text += ',' + std::to_string(events.of[i] + 1) + '\n';
    }
    return replaceFile(file, text);
}

} // namespace ripstop
