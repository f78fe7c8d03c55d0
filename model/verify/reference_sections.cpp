#include "verify/reference_sections.h"

#include "compile/compile.h"

#include <algorithm>
#include <limits>

namespace ripstop {

std::unique_ptr<Simulation> design(std::string_view builder, const Parameters& given)
{
    const Result<Scene> scene = build(*findBuilder(builder), given);
    if (!scene)
        return nullptr;
    const auto system = compile(*scene);
    return system ? std::make_unique<Simulation>(*system) : nullptr;
}

double choiceOf(std::string_view builder, std::string_view parameter, std::string_view choice)
{
    for (const Parameter& one : findBuilder(builder)->parameters)
        if (one.key == parameter)
            return double(std::ranges::find(one.choices, choice) - one.choices.begin());
    return 0.0;
}

double meanProbe(Simulation& simulation, std::string_view probe, double from, double to)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    int samples = 0;
    for (double time = from; time <= to + 1e-9; time += 0.1) {
        if (!simulation.runUntil(time))
            return none;
        const auto frame = simulation.frame();
        for (std::size_t i = 0; i < frame->probe.size(); ++i)
            if (frame->layout->probes[i].name == probe) {
                sum += frame->probe[i];
                ++samples;
            }
    }
    return samples > 0 ? sum / samples : none;
}

} // namespace ripstop
