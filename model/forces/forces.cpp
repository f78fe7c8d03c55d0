// The list of forces, made from ForceLists, and what they ask together: what they derive anew after
// an edit, how long a substep may be for what is stiff, and what they take from motion.
#include "forces/forces.h"

#include "forces/gusts.h"
#include "forces/spring_force.h"
#include "laws/step_limit.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <type_traits>

namespace ripstop {
namespace {

template <typename... Lists>
std::vector<std::unique_ptr<Force>> makeAll(std::type_identity<std::tuple<Lists...>>)
{
    std::vector<std::unique_ptr<Force>> all;
    (all.push_back(Lists::makeForce()), ...);
    return all;
}

} // namespace

Forces::Forces()
    : m_all(makeAll(std::type_identity<ForceLists>()))
    , m_springs(nullptr)
{
    for (const auto& force : m_all)
        if (const auto* springs = dynamic_cast<const SpringForce*>(force.get()))
            m_springs = springs;
}

Forces::~Forces() = default;
Forces::Forces(Forces&&) noexcept = default;
Forces& Forces::operator=(Forces&&) noexcept = default;

std::span<const PaddedVec3> Forces::ofSprings() const { return m_springs->loads(); }

const Forces& knownForces()
{
    static const Forces forces;
    return forces;
}

bool listForces(System& system, const Edited& edited)
{
    if (edited.winds)
        startGusts(system);
    bool bounds = false;
    for (const auto& force : knownForces()) {
        if (!force->hangsOn(edited))
            continue;
        const auto meetsSolver = [&] {
            return force->boundsSubstep(system) || force->joinsRods(system);
        };
        bounds |= meetsSolver();
        force->list(system);
        bounds |= meetsSolver();
    }
    return bounds;
}

double stiffStepLimit(const System& system)
{
    std::vector<double> stiffness(system.inverseMass.size(), 0.0);
    std::vector<double> damping(system.inverseMass.size(), 0.0);
    // what bounds the substep comes first; other forces count only beside some that do
    bool some = false;
    for (const bool bounds : {true, false})
        for (const auto& force : knownForces())
            if (force->boundsSubstep(system) == bounds && (bounds || some)) {
                force->addStiffness(system, stiffness, damping);
                some |= bounds;
            }
    double limit = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; some && i < stiffness.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            limit = std::min(limit, springStepLimit(1.0 / system.inverseMass[i], stiffness[i],
                                                    damping[i], system.integrator));
    return limit;
}

Message boundingForces(const System& system)
{
    Message names;
    for (const auto& force : knownForces())
        if (force->boundsSubstep(system))
            names = names.empty() ? force->name() : Message("%1 and %2", names, force->name());
    return names;
}

void fillDamping(const System& system, const State& state, Damping& damping)
{
    damping.at.assign(state.position.size(), Mat3::Zero());
    for (const auto& force : knownForces())
        if (force->acts(system, state))
            force->addDamping(system, state, damping);
}

// The trace is at least the largest rate.
double dampingStepLimit(const System& system, const State& state, Damping& damping)
{
    fillDamping(system, state, damping);
    double largest = 0.0; // 1/s
    for (std::size_t i = 0; i < damping.at.size(); ++i)
        largest = std::max(largest, damping.at[i].trace() * system.inverseMass[i]);
    return largest > 0.0 ? 2.0 / largest : std::numeric_limits<double>::infinity();
}

} // namespace ripstop
