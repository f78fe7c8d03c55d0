// What run and info do with recordings and bundles.
#pragma once

#include "io/recording_file.h"
#include "run/replay.h"

#include <string>

namespace ripstop {

// Computes the recording once more and says whether it comes to the same bits. Returns the exit
// code.
int replayFile(const std::string& file, int threads, bool json);

// The same of a bundle.
int flyBundle(const std::string& file, int threads, bool json);

// Prints what a replay has shown. Returns the exit code.
int tellReplay(const ReplayOutcome& outcome, bool json);

// Without a recording after a message. Damage is told here, and what comes before it is used.
OpenedRecording openOrSay(const std::string& file);

int describeRecording(const std::string& file, bool json);

} // namespace ripstop
