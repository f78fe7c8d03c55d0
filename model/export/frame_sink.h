// The receiving end of an export: takes the frames of a series in order and makes files of them. A
// failure of add() or finish() ends the export. A sink is used by one thread at a time.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "recording/certificate.h"
#include "simulation/frame.h"

#include <optional>

namespace ripstop {

// Takes the frames of a series, one after the other, and makes files of them. One that is given up
// before finish() has succeeded leaves nothing behind.
class FrameSink
{
public:
    virtual ~FrameSink() = default;

    // Which digits of the probes hold, before the first frame, where that is known. Tables and
    // figures show it.
    virtual void certify(std::shared_ptr<const Certificate>) {}

    virtual std::optional<Failure> add(const Frame& frame) = 0;
    virtual std::optional<Failure> finish(const Progress& progress) = 0;
};

extern const Failure exportCancelled;

} // namespace ripstop
