// Files of recordings, *.ripstop-run: a line "RIPSTOP-RUN 3", then blocks, each with its kind, its
// length and a checksum (little-endian):
//
//     about        names and bookmarks
//     certificate  which digits of the probes hold, compressed, where that is known
//     design       a scene as text, compressed; the next ones as differences to the one before
//     stretch      what happened in it, and its frames, compressed
//     end          nothing; a file without it was cut off
//
// A file that is damaged or cut off opens up to there. Frames are read from the file when they are
// asked for.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "recording/recording.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace ripstop {

inline constexpr std::string_view recordingExtension = ".ripstop-run";

// Through a temporary file beside the target and a rename. A run may go on meanwhile: what is
// written is what there is at the beginning.
std::optional<Failure> saveRecording(const Recording& recording, const std::filesystem::path& file,
                                     const Progress& progress = {});

// A recording that is written while its run goes on, stretch by stretch, under the name of files
// under way (base/new_file.h) that ends with .ripstop-run: a run that is killed leaves that, and it
// opens up to its last whole stretch.
class GrowingRecording
{
public:
    static Result<GrowingRecording> open(const std::filesystem::path& file);

    GrowingRecording(GrowingRecording&&) noexcept;
    ~GrowingRecording();

    // From its first step on, once.
    void follow(std::shared_ptr<Recording> recording);

    // When the run is over: writes the rest, and the file comes into its place.
    std::optional<Failure> finish();

private:
    class Private;
    explicit GrowingRecording(std::unique_ptr<Private> made);

    std::unique_ptr<Private> d;
};

struct OpenedRecording
{
    std::shared_ptr<Recording> recording;
    Message damage; // one sentence, empty when the file is whole
};

Result<OpenedRecording> openRecording(const std::filesystem::path& file,
                                      const Progress& progress = {});

} // namespace ripstop
