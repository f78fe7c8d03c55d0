// What the commands run, certify and info do with recordings and bundles: they save and describe
// them, compute them once more, and say whether that comes to the same bits. Each function prints
// for itself and returns the exit code of the command; a file that cannot be opened is reported on
// standard error.
#pragma once

#include "io/recording_file.h"
#include "recording/replay.h"

#include <string>

namespace ripstop {

// Computes a recording once more and says whether it comes to the same bits. The exit code is
// Done when it does and Differs when it does not.
int replayFile(const std::string& file, int threads, bool json);

// Computes the run of a bundle once more and says whether it comes to the same bits.
int flyBundle(const std::string& file, int threads, bool json);

// Prints what a replay has shown. Returns the exit code.
int tellReplay(const ReplayOutcome& outcome, bool json);

// Opens a recording. When that fails, the reason has been printed and there is no recording; when
// the file is damaged, that has been printed and the recording ends before the damage.
OpenedRecording openOrSay(const std::string& file);

// Saves the recording of a run that is over; it is null where no step was made.
std::optional<Failure> saveRun(const std::shared_ptr<Recording>& recording,
                               const std::string& file);

// Prints what is in a recording: its run, its frames, its events, its bookmarks.
int describeRecording(const std::string& file, bool json);

} // namespace ripstop
