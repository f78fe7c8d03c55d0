// The same bits: again, on several threads, and from a checkpoint.
#include "builders/builder.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

namespace ripstop {
namespace {

std::shared_ptr<const System> designed(const char* builder)
{
    const Result<Scene> scene = build(*findBuilder(builder), {});
    if (!scene)
        return nullptr;
    const auto system = compile(*scene);
    return system ? *system : nullptr;
}

// Particles whose bits differ, or -1 without a system.
double differing(const System& system, const State& a, const State& b)
{
    if (system.key.empty())
        return -1.0;
    double count = stateHash(a) == stateHash(b) ? 0.0 : 1.0;
    for (std::size_t i = 0; i < a.position.size(); ++i)
        if (a.position[i] != b.position[i] || a.velocity[i] != b.velocity[i])
            ++count;
    return count;
}

constexpr int steps = 240; // one second

} // namespace

std::vector<Case> repeatCases()
{
    std::vector<Case> cases;
    const char* source = "same scene, same bits";
    for (const char* builder : {"delta_kite", "hang_glider", "parachute", "cloth", "rope"}) {
        const auto first = shared([=] {
            const auto system = designed(builder);
            return std::pair(system, system ? run(*system, steps) : State{});
        });
        const auto row = [&](const char* id, const char* what, auto again) {
            cases.push_back({id, builder + std::string(", 1 s, particles that differ ") + what, 0.0,
                             exactly, "", source, [=] {
                                 const auto& [system, state] = first();
                                 return system ? differing(*system, state, again(*system)) : -1.0;
                             }});
        };
        row("T-C9", "in another run", [](const System& system) { return run(system, steps); });
        row("T-C9", "on two threads", [](const System& system) { return run(system, steps, 2); });
        row("T-C9", "on three threads", [](const System& system) { return run(system, steps, 3); });
        row("T-C10", "when it goes on from a checkpoint at 0.4 s", [](const System& system) {
            const State checkpoint = run(system, 2 * steps / 5);
            return run(system, checkpoint, steps - 2 * steps / 5);
        });
    }
    return cases;
}

} // namespace ripstop
