// First the ground that a reader stands on: a file for those that read files, an end for what is
// not sound. Then a function for each reader, in the order of the table at the end.
//
// The bytes of "recording" are a file whose checksums are made right before it is read, so that
// changes reach what is behind them. Those of "stretches" are what stands in a recording before it
// is packed: pieces of a letter (D design, H head, F frames), a length of four bytes and a content.
#include "fuzz/fuzz_readers.h"

#include "builders/builder.h"
#include "bundle/bundle.h"
#include "bundle/temporary_folder.h"
#include "check/check.h"
#include "io/control_track.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "materials/material_file.h"
#include "materials/material_test.h"
#include "model/recording_blocks.h"
#include "shapes/height_picture.h"
#include "shapes/mesh_answer.h"
#include "shapes/obj_file.h"
#include "shapes/ply_file.h"
#include "system/moment.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

// What a fuzzer or a test takes for a crash.
void demand(bool isSound, const char* what)
{
    if (isSound)
        return;
    std::fprintf(stderr, "Not sound: %s.\n", what);
    std::abort();
}

// Every failure is a sentence.
void demandSentence(const Failure& failure)
{
    demand(!failure.message.english().empty(), "a failure says nothing");
}

// A file with these bytes, of the one folder that this process has: in memory, where there is one.
fs::path fileWith(std::string_view bytes, const char* name)
{
    static const Result<TemporaryFolder> folder = TemporaryFolder::make(
        (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path())
        / "ripstop-fuzz");
    demand(bool(folder), "there is no temporary folder");
    const fs::path file = folder->path() / name;
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    return file;
}

const Scene& kite()
{
    static const Scene scene = *build(*findBuilder("delta_kite"), {});
    return scene;
}

// --- meshes and pictures -------------------------------------------------------------------------

void demandSound(const PolygonMesh& mesh)
{
    demand(!mesh.first.empty() && std::size_t(mesh.first.back()) == mesh.corners.size()
               && std::ranges::is_sorted(mesh.first),
           "faces do not lie one after the other");
    demand(std::ranges::all_of(
               mesh.corners,
               [&](int corner) { return corner >= 0 && std::size_t(corner) < mesh.points.size(); }),
           "a corner is of no point");
    demand(std::ranges::all_of(mesh.lines,
                               [&](const auto& ends) {
                                   return std::ranges::all_of(ends, [&](int end) {
                                       return end >= 0 && std::size_t(end) < mesh.points.size();
                                   });
                               }),
           "a line ends at no point");
    demand(mesh.mass.empty() || mesh.mass.size() == mesh.points.size(), "masses of other points");
    demand(mesh.texture.empty() || mesh.texture.size() == mesh.corners.size(),
           "corners have no texture");
    demand(mesh.object.size() == mesh.faceCount() && mesh.material.size() == mesh.faceCount(),
           "faces have no object or material");
}

template <typename Read>
void readMesh(Read read, std::string_view bytes)
{
    const Result<PolygonMesh> mesh = read(bytes, "fuzzed", Progress());
    if (mesh)
        demandSound(*mesh);
    else
        demandSentence(mesh.failure());
}

void fuzzObj(std::string_view bytes) { readMesh(readObj, bytes); }
void fuzzPly(std::string_view bytes) { readMesh(readPly, bytes); }
void fuzzOff(std::string_view bytes) { readMesh(readOff, bytes); }

void fuzzMtl(std::string_view bytes)
{
    PolygonMesh mesh;
    mesh.materials = {{"cloth", ""}, {"spar", ""}};
    readMtl(bytes, mesh);
    demand(mesh.materials.size() == 2, "materials were lost");
}

void fuzzMeshAnswer(std::string_view bytes)
{
    MeshAnswer answer;
    const std::size_t half = bytes.size() / 2;
    if (answer.take(bytes.substr(0, half)) && answer.take(bytes.substr(half)) && answer.mesh())
        demandSound(*answer.mesh());
}

void fuzzHeightPicture(std::string_view bytes)
{
    const Result<HeightGrid> grid = readHeightPicture(fileWith(bytes, "picture"));
    if (!grid)
        return demandSentence(grid.failure());
    demand(grid->height.size() == std::size_t(grid->columns) * std::size_t(grid->rows),
           "heights are missing");
}

// --- tables and materials ------------------------------------------------------------------------

void fuzzControlTrack(std::string_view bytes)
{
    const auto track = readControlTrack(fileWith(bytes, "controls.csv"), kite());
    if (!track)
        return demandSentence(track.failure());
    demand(std::ranges::is_sorted(track->commands, {}, &ControlCommand::time),
           "commands are not in the order of time");
}

void fuzzMaterialTest(std::string_view bytes)
{
    SpecimenSize size;
    size.length = 0.2;
    size.width = 0.05;
    const auto test = readMaterialTest(bytes, "fuzzed", size, {});
    if (!test)
        return demandSentence(test.failure());
    if (const auto fit = fitMaterialTest(test->points, size, {}); !fit)
        demandSentence(fit.failure());
}

void fuzzMaterials(std::string_view bytes)
{
    const auto presets = readMaterials(bytes, "fuzzed");
    if (!presets)
        return demandSentence(presets.failure());
    demand(bool(readMaterials(materialsText(*presets), "written")),
           "materials that were written cannot be read");
}

// --- scenes, recordings, bundles -----------------------------------------------------------------

void fuzzScene(std::string_view bytes)
{
    const Result<Scene> scene = parseScene(bytes, "fuzzed");
    if (!scene)
        return demandSentence(scene.failure());
    (void)problemsOf(*scene);
    const std::string text = sceneText(*scene);
    const Result<Scene> again = parseScene(text, "written");
    demand(again && sceneText(*again) == text, "a scene that was written is read otherwise");
}

// Looks at the first and the last frame and computes some steps.
void lookInto(const std::string& file)
{
    const auto opened = openRecording(fileWith(file, "run.ripstop-run"));
    if (!opened)
        return demandSentence(opened.failure());
    const Recording& recording = *opened->recording;
    for (const std::size_t frame : {std::size_t(0), recording.frameCount() - 1})
        if (const auto shown = recording.frame(frame); !shown)
            demandSentence(shown.failure());
    const std::int64_t step = std::min(recording.lastStep(), recording.firstStep() + 2);
    if (const auto moment = recording.moment(step); !moment)
        demandSentence(moment.failure());
}

void fuzzRecording(std::string_view bytes)
{
    if (!bytes.empty())
        lookInto(fileOf(blocksOf(bytes)));
}

void fuzzStretches(std::string_view bytes)
{
    RecordingBlocks blocks{"RIPSTOP-RUN 6\n", {}};
    std::string text;
    StretchParts stretch;
    constexpr std::size_t headSize = 1 + sizeof(std::uint32_t);
    while (bytes.size() >= headSize) {
        const char letter = bytes.front();
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 1, sizeof length);
        const std::string content(bytes.substr(headSize, length));
        bytes.remove_prefix(headSize + content.size());
        if (letter == 'D') {
            blocks.blocks.push_back({RecordingBlock::Design, text.empty()
                                                                 ? packed(content, Packing::Small)
                                                                 : packedAfter(text, content)});
            text = content;
        } else if (letter == 'H') {
            stretch.head = packed(content, Packing::Small);
        } else {
            stretch.frames = packed(content);
            blocks.blocks.push_back({RecordingBlock::Stretch, contentOf(stretch)});
        }
    }
    blocks.blocks.push_back({RecordingBlock::End, {}});
    lookInto(fileOf(blocks));
}

void fuzzBundle(std::string_view bytes)
{
    if (const auto bundle = openBundle(fileWith(bytes, "bundle.zip")); !bundle)
        demandSentence(bundle.failure());
}

void fuzzManifest(std::string_view bytes)
{
    const auto manifest = readManifest(fileWith(bytes, bundled::manifest).parent_path());
    if (!manifest)
        return demandSentence(manifest.failure());
    fileWith(manifestText(*manifest), bundled::manifest);
}

constexpr std::array<FuzzReader, 14> readers{{{"scene", fuzzScene},
                                              {"recording", fuzzRecording},
                                              {"stretches", fuzzStretches},
                                              {"bundle", fuzzBundle},
                                              {"manifest", fuzzManifest},
                                              {"obj", fuzzObj},
                                              {"mtl", fuzzMtl},
                                              {"ply", fuzzPly},
                                              {"off", fuzzOff},
                                              {"mesh_answer", fuzzMeshAnswer},
                                              {"control_track", fuzzControlTrack},
                                              {"material_test", fuzzMaterialTest},
                                              {"materials", fuzzMaterials},
                                              {"height_picture", fuzzHeightPicture}}};

} // namespace

std::span<const FuzzReader> fuzzReaders() { return readers; }

} // namespace ripstop
