// Weight: the one force that is an acceleration to begin with, and so has no elements to gather.
#include "forces/force.h"

namespace ripstop {
namespace {

class WeightForce final : public Force
{
public:
    Message name() const override { return Message("weight"); }
    ForceKind kind() const override { return ForceKind::Weight; }
    bool acts(const System&, const State&) const override { return true; }
    bool isSteady() const override { return true; }
    Vec3 acceleration(const System& system) const override { return system.gravity; }
    double energy(const System& system, const State& state) const override
    {
        double energy = 0.0; // of free particles, zero at the origin
        for (std::size_t i = 0; i < state.position.size(); ++i)
            if (system.inverseMass[i] > 0.0)
                energy -= system.mass[i] * system.gravity.dot(state.position[i]);
        return energy;
    }
};

} // namespace

std::unique_ptr<Force> WeightLists::makeForce() { return std::make_unique<WeightForce>(); }

} // namespace ripstop
