// When a run that is to stop at a time has come there. Runner, exporters and the window ask the
// same question, so that they stop at the same step. May be called from any thread.
#pragma once

namespace ripstop {

// Whether the time step that is nearest to `until` has been reached; all in s. Midway between two
// steps it is the earlier one, and round-off does not decide.
inline bool hasReached(double time, double until, double timeStep)
{
    return time >= until - (0.5 + 1e-6) * timeStep;
}

} // namespace ripstop
