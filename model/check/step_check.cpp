// The limits of all particles are found once; the least of them is what the scene has to keep to.
#include "check/step_check.h"

#include "laws/solver_laws.h"
#include "laws/step_limit.h"
#include "scene/property.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Substeps are many from here on, and so they are over those that most particles ask for.
constexpr int manySubsteps = 10;
constexpr int manyTimes = 5;

std::optional<StepLimit> leastOf(const Scene& scene, const StepLimits& limits)
{
    std::optional<StepLimit> least;
    std::size_t i = 0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const double h = limits.timeStep[i++];
            if (std::isfinite(h) && (!least || h < least->timeStep))
                least = StepLimit{h, particle.id, limits.cause};
        }
    });
    return least;
}

// s, of the particle in the middle of those that ask for one.
double usualLimit(std::vector<double> limits)
{
    std::erase_if(limits, [](double h) { return !std::isfinite(h); });
    const auto middle = limits.begin() + std::ptrdiff_t(limits.size() / 2);
    std::nth_element(limits.begin(), middle, limits.end());
    return *middle;
}

int substepsOf(double limit, const Settings& settings)
{
    return std::max(1, int(std::ceil(spareOfSubsteps * settings.timeStep / limit)));
}

// Solver::Auto takes as many substeps as bending asks for, of all that the scene has.
void checkBending(const Settings& settings, const StepLimit& least, const StepLimits& limits,
                  const AddFinding& add)
{
    const int taken = std::max(mostSubsteps, settings.substeps);
    if (settings.timeStep > taken * least.timeStep)
        return add("step", Severity::Warning,
                   Message("The bending at particle %1 needs substeps of %2 s, and the "
                           "automatic solver takes no more than %3 of them in a time step: it "
                           "will run away. Lower the flexural rigidity, join small cells, or "
                           "shorten the time step.",
                           std::uint32_t(least.particle), Message::number("%.3g", least.timeStep),
                           taken),
                   least.particle);
    if (limits.cause.springs) // which may be what asks for so many
        return;
    const int asked = substepsOf(least.timeStep, settings);
    const int usual = substepsOf(usualLimit(limits.timeStep), settings);
    if (asked >= std::max(manySubsteps, settings.substeps) && asked >= manyTimes * usual)
        add("step", Severity::Warning,
            Message("The bending at particle %1 asks for %2 substeps, where %3 would do for most "
                    "of what bends: cells there are narrow, or links short, and each step takes as "
                    "many times as long. Make them like the others, join them, or leave out the "
                    "bending stiffness.",
                    std::uint32_t(least.particle), asked, usual),
            least.particle);
}

} // namespace

bool exceeds(const Settings& settings, const StepLimit& limit)
{
    return settings.timeStep / settings.substeps > limit.timeStep
           && !(limit.cause.bending && settings.solver == Solver::Auto);
}

int substepsWithin(const StepLimit& limit, const Settings& settings)
{
    constexpr double spare = 1.2;
    const Range range = propertyOf<&Settings::substeps>().range;
    return int(
        std::clamp(std::ceil(spare * settings.timeStep / limit.timeStep), range.low, range.high));
}

std::optional<StepLimit> stepLimit(const Scene& scene)
{
    return leastOf(scene, stepLimitsOf(scene, ElementIndex(scene)));
}

void checkStep(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    const Settings& settings = scene.settings;
    if (settings.integrator == Integrator::Bdf2 && settings.solver == Solver::SmallSteps)
        add("single sweeps", Severity::Warning,
            Message("The integrator bdf2 makes what single sweeps leave over grow, so that "
                    "rods swing up: "
                    "choose the automatic solver, or another integrator."),
            noId);
    const StepLimits limits = stepLimitsOf(scene, index);
    const std::optional<StepLimit> least = leastOf(scene, limits);
    if (!least)
        return;
    if (least->cause.bending && settings.solver == Solver::Auto)
        return checkBending(settings, *least, limits, add);
    if (!exceeds(settings, *least))
        return;
    const double h = settings.timeStep / settings.substeps;
    add("step", Severity::Warning,
        Message("The substep of %1 s is above the %2 s that particle %3 may need for %4: shorten "
                "the time step, add substeps, or lower stiffness and damping.",
                Message::number("%.3g", h), Message::number("%.3g", least->timeStep),
                std::uint32_t(least->particle), least->cause.said()),
        least->particle);
}

} // namespace ripstop
