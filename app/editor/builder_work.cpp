#include "editor/builder_work.h"

namespace ripstop {

BuildOutcome outcomeOf(const BuildJob& job)
{
    BuildOutcome outcome;
    outcome.number = job.number;
    Result<Scene> built = build(*job.builder, job.parameters);
    if (!built) {
        outcome.refusal = built.message();
        return outcome;
    }
    outcome.figures = figuresOf(*built, job.builder->family);
    if (job.ground) {
        InsertGround ground = *job.ground;
        ground.scene.nextId = job.nextId;
        outcome.insertion = inserted(ground, std::move(*built), job.wish);
    } else {
        outcome.scene = std::move(*built);
    }
    return outcome;
}

} // namespace ripstop
