// Which part of a scene a link or a panel is in, for tables. Any thread may ask.
#pragma once

#include "scene/scene.h"

#include <string>

namespace ripstop {

struct ElementPart
{
    std::string name; // empty when the scene has no such link or panel
    bool isPanel = false;
};

ElementPart partOfElement(const Scene& scene, Id element);

} // namespace ripstop
