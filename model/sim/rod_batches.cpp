#include "sim/rod_batches.h"

#include <limits>

#define RIPSTOP_KERNEL "sim/rod_kernel.inl"
#include "sim/for_each_machine.inl"

namespace ripstop {

void sweepRuns(RodBatches& batches, std::span<const int> order, bool backwards,
               PaddedVec3* position, bool asWide)
{
    (asWide ? wide::sweepRuns : anywhere::sweepRuns)(batches, order, backwards, position);
}

} // namespace ripstop
