#include "io/tear_table.h"

#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"

namespace ripstop {
namespace {

std::string partOf(const Scene& scene, Id link)
{
    std::string name;
    forEachPart(scene, [&](Id, const Part& part) {
        if (findRow(part.links, link))
            name = part.name;
    });
    return name;
}

} // namespace

std::optional<Failure> writeTears(const Scene& scene, std::span<const Tear> tears,
                                  const std::filesystem::path& file)
{
    std::string text = "time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m)\n";
    for (const Tear& tear : tears) {
        appendNumber(text, tear.time);
        text += ',' + std::to_string(tear.link) + ',' + csvCell(partOf(scene, Id{tear.link}));
        for (const double value : {tear.strain, tear.force, tear.energy, tear.place.x(),
                                   tear.place.y(), tear.place.z()}) {
            text += ',';
            appendNumber(text, value);
        }
        text += '\n';
    }
    return replaceFile(file, text);
}

} // namespace ripstop
