// What the thread of a BuilderDialog does: it turns what the form says into a scene or an edit.
//
// The dialog posts a BuildJob and takes the BuildOutcome with the same number. outcomeOf() is
// called on the thread of the worker, and may be: a job holds all that it reads, and shared scenes
// are constant. A builder that refuses is a message in the outcome, not a failure of the thread.
#pragma once

#include "author/design_figures.h"
#include "author/rebuild.h"
#include "document/worker.h"
#include "shaping/insert.h"

#include <memory>

namespace ripstop {

// What the form asks for. With a ground the outcome is an insertion into the open scene; with a
// scene it is one part of that scene built again; with neither it is a whole new scene.
struct BuildJob
{
    const Builder* builder = nullptr;
    Parameters parameters;
    std::shared_ptr<const InsertGround> ground;
    InsertWish wish;
    std::shared_ptr<const Scene> scene;
    Id part{};
    Id nextId{1}; // of the open scene when the job is posted, since previews use up ids
    int number = 0;
};

struct BuildOutcome
{
    int number = 0;
    Message refusal; // why there is nothing, or empty
    DesignFigures figures;
    Scene scene;             // a new one, when the job has neither ground nor scene
    Edit edit;               // of the open scene, otherwise
    std::vector<Id> bodies;  // to be selected: parts and obstacles that come, or the part
    int substeps = 0;        // to which the scene is raised, or 0 where it has enough
    HandmadeParts lost;      // of a part that is built again
    std::size_t painted = 0; // rows of it that keep what was painted
    std::vector<OtherMaterial> staying; // of the part
    std::size_t letGo = 0;              // references of other items to what goes
};

BuildOutcome outcomeOf(const BuildJob& job);

using BuildWork = Worker<BuildJob, BuildOutcome>;

} // namespace ripstop
