// Copy and paste through the clipboard of the desktop, as the text of a scene file: what is copied
// can be pasted into another scene, another window, or a text editor.
#pragma once

#include "shaping/copy.h"

namespace ripstop {

void copyToClipboard(const Scene& scene, const std::vector<Id>& ids);

// Fails with a sentence when the clipboard holds no design.
Result<Copies> pasteFromClipboard(const Scene& scene);

} // namespace ripstop
