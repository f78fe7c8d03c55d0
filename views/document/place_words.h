// Where in a design an element is, in words: by its material, which tells more than its number.
#pragma once

#include "scene/scene.h"

#include <QString>

namespace ripstop {

// "bridle, link 17"; "link 17 of kite" for an element without a material.
QString placeWords(const Scene& scene, Id element);

} // namespace ripstop
