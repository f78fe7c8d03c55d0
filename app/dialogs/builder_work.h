// The thread that builds what a BuilderDialog asks for.
#pragma once

#include "author/design_figures.h"
#include "author/insert.h"
#include "author/rebuild.h"
#include "document/worker.h"

#include <memory>

namespace ripstop {

// One wish of the form. With a ground the outcome is an insertion into the open scene; with a
// scene, its part built again; with neither, a whole new scene.
struct BuildJob
{
    const Builder* builder = nullptr;
    Parameters parameters;
    std::shared_ptr<const InsertGround> ground;
    InsertWish wish;
    std::shared_ptr<const Scene> scene;
    Id part{};
    Id nextId{1}; // of the open scene now; a preview that was taken back has used some
    int number = 0;
};

struct BuildOutcome
{
    int number = 0;
    Message refusal; // why there is nothing, or empty
    DesignFigures figures;
    Scene scene;            // a new one
    Edit edit;              // of the open one
    std::vector<Id> bodies; // to be selected: parts and obstacles that come, or the part
    int substeps = 0;       // that the scene is raised to, 0 where it has enough
    HandWork lost;          // of a part that is built again
    std::size_t letGo = 0;  // that pointed at what goes
};

BuildOutcome outcomeOf(const BuildJob& job);

using BuildWork = Worker<BuildJob, BuildOutcome>;

} // namespace ripstop
