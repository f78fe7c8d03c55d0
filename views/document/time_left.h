// How long work goes on that has come so far, as all panels say it: "About 40 s left."
#pragma once

#include <QString>

namespace ripstop {

// s, if the rest goes as what is done; not a number before that tells something.
//   elapsed  s, since the work began
//   share    of it that is done, 0 .. 1
double secondsLeft(double elapsed, double share);

QString timeLeftText(double seconds); // empty for what is no number

} // namespace ripstop
