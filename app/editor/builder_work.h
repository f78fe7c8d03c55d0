// The thread that builds what a BuilderDialog asks for.
#pragma once

#include "author/figures.h"
#include "author/insert.h"
#include "document/worker.h"

#include <memory>

namespace ripstop {

// One wish of the form. Without a ground the outcome is the whole scene, as for a new design.
struct BuildJob
{
    const Builder* builder = nullptr;
    Parameters parameters;
    std::shared_ptr<const InsertGround> ground; // of the open scene, for an insertion
    InsertWish wish;
    Id nextId{1}; // of the open scene now; a preview that was taken back has used some
    int number = 0;
};

struct BuildOutcome
{
    int number = 0;
    std::string refusal; // why there is nothing, or empty
    Figures figures;
    Scene scene;         // without a ground
    Insertion insertion; // with one
};

BuildOutcome outcomeOf(const BuildJob& job);

using BuildWork = Worker<BuildJob, BuildOutcome>;

} // namespace ripstop
