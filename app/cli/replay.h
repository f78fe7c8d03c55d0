// What run and info do with recordings.
#pragma once

#include "run/recording.h"

#include <string>

namespace ripstop {

// Computes the recording once more and says whether it comes to the same bits. Returns the exit
// code.
int replayFile(const std::string& file, int threads, bool json);

// The recording, or null after a message. Damage is told, and what comes before it is used.
std::shared_ptr<Recording> openOrSay(const std::string& file);

int describeRecording(const std::string& file, bool json);

} // namespace ripstop
