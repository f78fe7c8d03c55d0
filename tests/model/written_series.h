// Writes frames as a run exports them, for tests that read the files back.
#pragma once

#include "export/export_run.h"
#include "export/format.h"

#include <span>
#include <string>

namespace ripstop {

inline std::optional<Failure> writeSeries(std::span<const Frame> frames,
                                          const MeshAppearance& appearance,
                                          const std::string& target)
{
    auto sink = openSink(*formatOf(target), target, appearance);
    if (!sink)
        return sink.failure();
    for (const Frame& frame : frames)
        if (auto failure = (*sink)->add(frame))
            return failure;
    return (*sink)->finish({});
}

} // namespace ripstop
