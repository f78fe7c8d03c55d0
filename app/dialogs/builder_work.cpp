#include "dialogs/builder_work.h"

namespace ripstop {
namespace {

void buildAgain(BuildOutcome& outcome, const BuildJob& job)
{
    Result<Rebuilt> again = rebuilt(*job.scene, job.part, job.parameters, job.nextId);
    if (!again) {
        outcome.refusal = again.message();
        return;
    }
    outcome.figures = designFiguresOf(again->built, job.builder->family);
    outcome.edit = std::move(again->edit);
    outcome.bodies = {job.part};
    outcome.lost = again->lost;
    outcome.painted = again->painted;
    outcome.staying = std::move(again->staying);
    outcome.letGo = again->letGo;
}

} // namespace

BuildOutcome outcomeOf(const BuildJob& job)
{
    BuildOutcome outcome;
    outcome.number = job.number;
    if (job.scene) {
        buildAgain(outcome, job);
        return outcome;
    }
    Result<Scene> built = build(*job.builder, job.parameters);
    if (!built) {
        outcome.refusal = built.message();
        return outcome;
    }
    outcome.figures = designFiguresOf(*built, job.builder->family);
    if (!job.ground) {
        outcome.scene = std::move(*built);
        return outcome;
    }
    InsertGround ground = *job.ground;
    ground.scene.nextId = job.nextId;
    Insertion insertion = inserted(ground, std::move(*built), job.wish);
    outcome.edit = std::move(insertion.edit);
    outcome.bodies = std::move(insertion.bodies);
    outcome.substeps = insertion.substeps;
    return outcome;
}

} // namespace ripstop
