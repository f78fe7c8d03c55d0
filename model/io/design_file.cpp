#include "io/design_file.h"

#include "io/recording_file.h"
#include "io/scene_file.h"

namespace ripstop {

Result<Scene> readDesign(const std::filesystem::path& file)
{
    if (file.extension() != recordingExtension)
        return readScene(file);
    Result<OpenedRecording> opened = openRecording(file);
    if (!opened)
        return opened.failure();
    return opened->recording->scene();
}

} // namespace ripstop
