// openBundle() uses a folder where it lies and unpacks a zip into a temporary folder, which lives
// as long as the bundle. It finds the manifest, reads it, and compares size and sum of each file
// that it names: a missing file is a failure, a changed one is only listed, since the bundle can
// still be looked at. Files that the manifest does not name are not looked at.
//
// flyAgain() opens the recording, which must be undamaged. What was flown from a recording is
// replayed from its first state and inputs. What was flown from a scene is compiled from the scene
// of the bundle, steered by its controls, and compared with the recording step by step.
#include "bundle/bundle.h"

#include "bundle/zip_file.h"
#include "compile/compile.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <fstream>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

bool startsAsZip(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    char start[4] = {};
    in.read(start, sizeof start);
    return std::string_view(start, sizeof start) == std::string_view("PK\3\4", 4);
}

// The folder with the manifest: of a zip it is one below.
fs::path withManifest(const fs::path& folder)
{
    std::error_code error;
    if (fs::exists(folder / bundled::manifest, error))
        return folder;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (fs::exists(entry.path() / bundled::manifest, error))
            return entry.path();
    return {};
}

Result<std::vector<std::string>> changedFiles(const Manifest& manifest, const fs::path& folder,
                                              const std::string& bundle)
{
    const auto now = filesIn(folder);
    if (!now)
        return now.failure();
    std::vector<std::string> changed;
    for (const auto& [name, file] : manifest.files) {
        const auto there = now->find(name);
        if (there == now->end())
            return Failure("%1 has no %2 in it, which its manifest names; get it again.", bundle,
                           name);
        if (there->second.bytes != file.bytes || there->second.sum != file.sum)
            changed.push_back(name);
    }
    return changed;
}

} // namespace

bool looksLikeBundle(const fs::path& file)
{
    std::error_code error;
    if (fs::is_directory(file, error))
        return true;
    return file.extension() == ".zip" || startsAsZip(file);
}

Result<Bundle> openBundle(const fs::path& file, const Progress& progress)
{
    Bundle bundle;
    std::error_code error;
    if (!fs::exists(file, error))
        return Failure("%1 does not exist; check the path.", file.string());
    if (fs::is_directory(file, error)) {
        bundle.folder = file;
    } else {
        auto made = TemporaryFolder::make(fs::temp_directory_path(error) / "ripstop-bundle");
        if (!made)
            return made.failure();
        if (auto failure = unzip(file, made->path(), progress))
            return *failure;
        bundle.folder = withManifest(made->path());
        bundle.unpacked = std::make_shared<TemporaryFolder>(std::move(*made));
    }
    if (bundle.folder.empty() || !fs::exists(bundle.folder / bundled::manifest, error))
        return Failure("%1 is no bundle of Ripstop: it has no %2.", file.string(),
                       bundled::manifest);
    auto manifest = readManifest(bundle.folder);
    if (!manifest)
        return manifest.failure();
    auto changed = changedFiles(*manifest, bundle.folder, file.string());
    if (!changed)
        return changed.failure();
    bundle.manifest = std::move(*manifest);
    bundle.changed = std::move(*changed);
    return bundle;
}

Result<ReplayOutcome> flyAgain(const Bundle& bundle, int threads, const Progress& progress)
{
    const auto opened = openRecording(bundle.folder / bundled::recording);
    if (!opened)
        return opened.failure();
    if (!opened->damage.empty())
        return Failure(opened->damage);
    const Recording& recording = *opened->recording;
    if (bundle.manifest.from == Manifest::From::Recording)
        return replay(recording, threads, progress);

    const auto scene = readScene(bundle.folder / bundled::scene);
    if (!scene)
        return scene.failure();
    ControlTrack track;
    std::error_code error;
    if (fs::exists(bundle.folder / bundled::controls, error)) {
        auto read = readControlTrack(bundle.folder / bundled::controls, *scene);
        if (!read)
            return read.failure();
        track = std::move(*read);
    }
    const auto system = compile(*scene);
    if (!system)
        return system.failure();
    Simulation simulation(*system, threads);
    ControlPlayer controls(std::move(track));
    return compareFlight(
        recording, simulation,
        [&](Simulation& flown) -> std::optional<Failure> {
            controls.giveTo(flown);
            return std::nullopt;
        },
        progress);
}

} // namespace ripstop
