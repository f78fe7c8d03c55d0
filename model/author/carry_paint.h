// What was painted on a part goes over to the part that its builder makes again.
//
// Painted are the numbers of the brush (shaping/brush.h), by the brush or in the inspector: how
// strong and how stiff an element is of its material, and where the warp of a panel runs. They
// belong to a place of the design, so that they outlive its mesh. Where the mesh is joined as
// before, each row keeps its own. Otherwise a row takes what was painted on the nearest row of its
// material and role: by its place in the box around all of these, so that a longer line has its
// weak place at the same share of its length, and by its texture coordinates, which tell places of
// cloth in whatever shape it flies. A grain keeps its angle to the picture that is printed on the
// fabric, as the brush has it.
#pragma once

#include "author/counterparts.h"

namespace ripstop {

struct CarriedPaint
{
    std::size_t kept = 0; // rows that have some now
    std::size_t lost = 0; // painted rows at whose place nothing is painted any more
};

// `before` is as the builder made the part, `after` as it makes it now, which gets the paint.
CarriedPaint carryPaint(const Part& held, const Counterparts& counterparts, const Scene& before,
                        Scene& after);

} // namespace ripstop
