// What was done by hand to a part since its builder made it.
#pragma once

#include "author/counterparts.h"

namespace ripstop {

// What tells the rows of a part from those that its builder made. A part that was moved or turned
// as a whole has none. A row may count as changed and as painted.
struct HandmadeParts
{
    std::size_t moved = 0;   // particles
    std::size_t changed = 0; // rows with another mass, pin, length, material or end
    std::size_t painted = 0; // rows with another strength, stiffness or grain (carry_paint.h)
    std::size_t added = 0;   // rows more than were built
    std::size_t removed = 0;

    std::size_t count() const { return moved + changed + painted + added + removed; }
    bool isNothing() const { return count() == 0; }
};

// `built` is what the builder makes of the parameters of the part, and `counterparts` pairs it with
// what stands in the scene.
HandmadeParts handWork(const Part& built, const Part& held, const Counterparts& counterparts);

// The same of a part in a scene, of which the builder is asked.
HandmadeParts handWork(const Scene& scene, Id part);

} // namespace ripstop
