#include "forces/lane.h"

#include "parallel/simd_pack.h"

#include <algorithm>

#define RIPSTOP_KERNEL "forces/lane_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

void gatherAccelerations(std::span<const Lane> lanes, const Vec3& common, const double* inverseMass,
                         PaddedVec3* acceleration, std::size_t first, std::size_t last)
{
    (wideMachine ? wide::gather : anywhere::gather)(lanes, common, inverseMass, acceleration, first,
                                                    last);
}

void addForces(const Lane& lane, std::span<Vec3> force)
{
    for (std::size_t i = 0; i < force.size(); ++i)
        for (int k = lane.at->start[i]; k < lane.at->start[i + 1]; ++k) {
            const PaddedVec3& load = lane.load[lane.at->items[std::size_t(k)]];
            if (lane.minus)
                force[i] += lane.minus[k] ? -load : Vec3(load);
            else if (lane.weight)
                force[i] += lane.weight[k] * load;
            else
                force[i] += load / lane.parts;
        }
}

} // namespace ripstop
