// What a look at a scene finds: what keeps it from running, what will hardly run as meant, and how
// near it is to what its solver can follow. check.h finds the first two, author/stability.h the
// last.
#pragma once

#include "scene/edit.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ripstop {

enum class Severity {
    Error,   // the scene does not run
    Warning, // it runs, hardly as meant
    Fine     // as it should be, and worth telling
};

struct Finding
{
    Severity severity = Severity::Fine;
    Message message;            // what is so, and what to do about it
    std::vector<Id> culprits;   // items or elements, ascending; none when it is the whole scene
    std::string_view sort = {}; // "step", "loose": equal for all findings of one kind
    Message subject = {};       // "Time step", where the look has a heading for it
    std::optional<Edit> repair = {}; // its label says what it does; for the scene as it was

    // The first culprit; noId when the finding is about the scene as a whole.
    Id culprit() const { return culprits.empty() ? noId : culprits.front(); }
};

// A thing as the subject of a sentence: "Particle 17".
Message subjectOf(Kind kind, Id id);

} // namespace ripstop
