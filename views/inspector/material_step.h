// Steps from a material to the next one of the library, for the buttons of the inspector and for
// actions: made, and told in words.
#pragma once

#include "materials/neighbours.h"

#include <QString>

#include <span>
#include <vector>

namespace ripstop {

class Document;

QString stepLabel(MaterialStep step); // "Lighter"

// Makes the step as one edit of the document. Says what the materials are now and what that
// changes, or why nothing was done. `materials` are in the scene.
QString stepMaterials(Document& document, const std::vector<Id>& materials, MaterialStep step,
                      std::span<const Preset> own);

// The same for the materials that the selection is made of, with the user's own materials.
QString stepSelected(Document& document, const std::vector<Id>& selected, MaterialStep step);

// What the step would do, or why it does not go; `goes` tells which.
QString stepPreview(const Document& document, const std::vector<Id>& materials, MaterialStep step,
                    std::span<const Preset> own, bool& goes);

} // namespace ripstop
