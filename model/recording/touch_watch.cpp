#include "recording/touch_watch.h"

#include "assembly/split_system.h"
#include "contact/contact.h"
#include "simulation/simulation.h"

#include <algorithm>

namespace ripstop {
namespace {

std::size_t colliderCount(const System& system)
{
    constexpr std::size_t most = 32; // that touchOf() tells apart
    return std::min(system.obstacles.size(), most);
}

} // namespace

void TouchWatch::begin(Begin how)
{
    m_pairs.clear();
    m_serial = 0;
    m_quietly = how == Begin::AsItIs;
}

// What touched goes on touching in an edited system.
void TouchWatch::prepare(const System& system)
{
    if (m_serial == system.serial)
        return;
    m_serial = system.serial;
    std::vector<Pair> pairs;
    pairs.reserve(system.parts.size() * colliderCount(system));
    for (const PartPlace& part : system.parts)
        for (std::size_t o = 0; o < colliderCount(system); ++o) {
            Pair pair{part.key, system.obstacles[o].key};
            const auto before = std::ranges::find_if(m_pairs, [&](const Pair& other) {
                return other.part == pair.part && other.collider == pair.collider;
            });
            pairs.push_back(before == m_pairs.end() ? pair : *before);
        }
    m_pairs = std::move(pairs);
    const auto isTwin = [](Key key) { return key >= firstTwinParticle; };
    m_particles = std::size_t(std::ranges::find_if(system.key, isTwin) - system.key.begin());
}

void TouchWatch::look(const Simulation& simulation, std::vector<RunEvent>& events)
{
    const System& system = simulation.system();
    const State& state = simulation.state();
    prepare(system);
    const std::span<const std::uint32_t> touches = simulation.touches();
    const std::size_t colliders = colliderCount(system);
    for (std::size_t p = 0; p < system.parts.size() && !touches.empty(); ++p) {
        const auto first = std::size_t(system.parts[p].first);
        const auto end =
            p + 1 < system.parts.size() ? std::size_t(system.parts[p + 1].first) : m_particles;
        std::uint32_t met = 0;
        for (std::size_t i = first; i < std::min(end, touches.size()); ++i)
            met |= touches[i];
        for (std::size_t o = 0; o < colliders; ++o) {
            Pair& pair = m_pairs[p * colliders + o];
            if (met & touchOf(o))
                pair.last = state.time;
            const bool now =
                (met & touchOf(o)) || (pair.touches && state.time - pair.last < outlast);
            if (now == pair.touches)
                continue;
            pair.touches = now;
            if (!m_quietly)
                events.push_back({now ? RunEvent::Kind::Contact : RunEvent::Kind::LiftOff,
                                  state.step, state.time, pair.part, 1, pair.collider});
        }
    }
    m_quietly = false;
}

} // namespace ripstop
