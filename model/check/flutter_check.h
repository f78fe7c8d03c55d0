// Looks for fabric that lies in one plane with the wind and with gravity, to the last digit, as a
// flag does that was drawn in another program: whatever the solver, nothing ever moves it out of
// that plane, though a real flag would flutter. A part of check.h. Without any wind a sheet that
// hangs in a plane stays in it as well, which the author may mean (author/fabric_findings.h).
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkFlutter(const Scene& scene, const AddFinding& add);

// Parts with panels in a scene of which all lies and moves in one plane that holds gravity, where
// no wind blows and no collider and no control leads out of the plane; else none.
std::vector<Id> partsThatStayFlat(const Scene& scene);

} // namespace ripstop
