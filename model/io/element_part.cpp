#include "io/element_part.h"

namespace ripstop {

ElementPart partOfElement(const Scene& scene, Id element)
{
    ElementPart found;
    forEachPart(scene, [&](Id, const Part& part) {
        if (findRow(part.links, element))
            found = {part.name, false};
        else if (findRow(part.panels, element))
            found = {part.name, true};
    });
    return found;
}

} // namespace ripstop
