// Looks for fabric that lies in one plane with the wind and with gravity, to the last digit, as a
// flag does that was drawn in another program: whatever the solver, nothing ever moves it out of
// that plane, though a real flag would flutter. A part of check.h.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkFlutter(const Scene& scene, const AddFinding& add);

} // namespace ripstop
