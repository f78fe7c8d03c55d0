#include "constraints/rod_batches.h"

#include <limits>

#define RIPSTOP_KERNEL "constraints/rod_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

void sweepRuns(RodBatches& batches, std::span<const int> order, const SweepHow& how,
               PaddedVec3* position)
{
    (how.wide ? wide::sweepRuns : anywhere::sweepRuns)(batches, order, how, position);
}

} // namespace ripstop
