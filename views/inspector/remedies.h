// Buttons and links that make a value count which does nothing now (author/remedy.h).
#pragma once

#include "author/remedy.h"

#include <QString>

#include <vector>

namespace ripstop {

class Subject;

using Remedies = std::vector<const Remedy*>;

// Links for a label: "<a href="0">Give its links widths from the mesh</a> or <a ...". Empty for no
// remedy.
QString remedyLinks(const Remedies& remedies);

// The same in plain words, for a tool tip.
QString remedyWords(const Remedies& remedies);

// Makes the edit, as one step of undo, for all things of the subject. Says why it could not.
QString performRemedy(const Remedy& remedy, const Property& property, Subject& subject);

} // namespace ripstop
