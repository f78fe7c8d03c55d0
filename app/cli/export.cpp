// ripstop-cli export: meshes, series and tables for other programs.
//
// The source of the frames is either a recording or a scene that is flown for it; the format
// follows from the ending of the target. A target of one moment needs no range of time; a film or a
// table gets one.
#include "export/export_run.h"

#include "cli/commands.h"
#include "cli/replay.h"
#include "cli/scene_input.h"
#include "cli/targets.h"
#include "compile/compile.h"
#include "export/format.h"
#include "simulation/simulation.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>

namespace ripstop {
namespace {

constexpr double seriesSeconds = 10.0; // s, of a series or table that is flown without --to

struct ExportOptions
{
    SceneInput scene;
    std::string output;
    double fps = 25.0;
    std::optional<double> from;
    std::optional<double> to;
    std::string controls;
    bool exact = false;    // of a recording
    bool replaces = false; // also meshes that were not named
    int threads = 1;
};

bool isOneMoment(const std::filesystem::path& target)
{
    const ExportFormat* format = formatOf(target);
    return format && format->of == ExportFormat::Of::Moment;
}

// The range that was asked for, in the time of the source.
ExportRange rangeOf(const ExportOptions& options, const FrameSource& source)
{
    const double from = options.from.value_or(source.begin());
    const double all =
        std::isfinite(source.end()) ? std::max(from, source.end()) : from + seriesSeconds;
    return {from, options.to.value_or(isOneMoment(options.output) ? from : all), options.fps};
}

bool isThere(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::exists(file, error);
}

// What is written, the target first; nothing where exportRun() says that there is no such format.
std::vector<std::filesystem::path> outputsOf(const ExportOptions& options, const Scene& scene)
{
    const ExportFormat* format = formatOf(options.output);
    return format ? filesOf(*format, options.output, 1, MeshAppearance(scene))
                  : std::vector<std::filesystem::path>();
}

// What has not been named, and of which there is one already.
std::vector<std::filesystem::path> thereBeside(std::vector<std::filesystem::path> outputs)
{
    if (!outputs.empty())
        outputs.erase(outputs.begin()); // the target has a name
    std::erase_if(outputs, [](const std::filesystem::path& file) { return !isThere(file); });
    return outputs;
}

std::optional<Failure> write(FrameSource& source, const Scene& scene, const ExportOptions& options)
{
    const auto anew = thereBeside(outputsOf(options, scene));
    ProgressLine progress(options.output);
    auto failure = exportRun(source, MeshAppearance(scene), rangeOf(options, source),
                             options.output, [&](double share) {
                                 progress.show(share);
                                 return !interrupted();
                             });
    if (!failure)
        for (const std::filesystem::path& file : anew)
            std::cerr << "ripstop-cli: note: " << file.string() << " was there, and is written "
                      << "anew beside " << options.output << ".\n";
    return failure;
}

// Whether an OBJ file was exported by Ripstop, or is empty.
bool isOurs(const std::filesystem::path& mesh)
{
    std::ifstream file(mesh);
    std::string begin(1024, '\0');
    file.read(begin.data(), std::streamsize(begin.size()));
    begin.resize(std::size_t(file.gcount()));
    if (begin.starts_with("mtllib")) // stands in front of the first comment
        begin.erase(0, begin.find('\n') + 1);
    return begin.empty() || begin.starts_with("# Ripstop");
}

// Whether a file that was not named may be replaced: the mesh and the materials of an export that
// is made again. Without the export they are somebody's, also where Ripstop wrote them.
bool isMadeAgain(const std::filesystem::path& file, const std::filesystem::path& target)
{
    const std::filesystem::path kind = file.extension();
    return (kind != ".obj" && kind != ".mtl")
           || (isThere(target) && (kind != ".obj" || isOurs(file)));
}

// Looks at what is written beside the target and has not been named: nothing that is read, and no
// mesh that is not of an export to the same target.
int refuseFilesBeside(const ExportOptions& options, const Scene& scene, const FileNames& inputs)
{
    const auto outputs = outputsOf(options, scene);
    for (const std::filesystem::path& file : thereBeside(outputs)) {
        if (isInput(file.string(), inputs))
            return WrongUsage;
        if (!options.replaces && !isMadeAgain(file, outputs.front()))
            return fail(WrongUsage,
                        Message("%1 is written beside %2, and is there already; it would be lost: "
                                "give the target another name, or say --replace.",
                                file.string(), options.output));
    }
    return Done;
}

int exportRecording(const ExportOptions& options)
{
    if (!options.scene.assignments.empty() || !options.controls.empty())
        return fail(WrongUsage, "A recording is exported as it was flown: --set and --controls go "
                                "with a scene.");
    const OpenedRecording opened = openOrSay(options.scene.file);
    if (!opened.recording)
        return BadInput;
    using Places = RecordedFrames::Places;
    RecordedFrames source(opened.recording, options.exact ? Places::Exact : Places::AsKept,
                          options.threads);
    const int lastDesign = int(opened.recording->designCount()) - 1;
    const Scene scene = opened.recording->design(lastDesign).scene();
    if (const int code = refuseFilesBeside(options, scene, inputsOf(scene, options.scene.file));
        code != Done)
        return code;
    if (auto failure = write(source, scene, options))
        return fail(interrupted() ? Interrupted : BadInput, failure->message);
    return opened.damage.empty() ? Done : BadInput; // openOrSay() has printed the damage
}

bool isFilm(const std::filesystem::path& target)
{
    constexpr std::array<std::string_view, 4> films{".mp4", ".webm", ".gif", ".png"};
    return std::ranges::find(films, target.extension().string()) != films.end();
}

int exportScene(const ExportOptions& options)
{
    if (isFilm(options.output))
        return fail(BadInput, options.output
                                  + " is a picture or a film: those are drawn by the window "
                                    "(ripstop, File > Export), which needs a display.");
    const FileNames files{options.scene.file, options.controls};
    if (const int code = refuseTargets({options.output}, files); code != Done)
        return code;
    if (options.scene.file.ends_with(recordingExtension))
        return exportRecording(options);
    const SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const FileNames inputs = inputsOf(*loaded.scene, options.scene.file);
    if (const int code = refuseTargets({options.output}, inputs); code != Done)
        return code;
    if (const int code = refuseFilesBeside(options, *loaded.scene, inputs); code != Done)
        return code;
    const auto system = compile(*loaded.scene);
    if (!system)
        return fail(BadInput, Message("%1: %2", options.scene.file, system.message()));

    Simulation simulation(*system, options.threads);
    ControlTrack controls;
    if (!options.controls.empty()) {
        Result<ControlTrack> track = readControlTrack(options.controls, *loaded.scene);
        if (!track)
            return fail(BadInput, track.message());
        controls = std::move(*track);
    }
    FlownFrames source(simulation, std::move(controls));
    const auto failure = write(source, *loaded.scene, options);
    if (!failure)
        return Done;
    return fail(simulation.trouble() ? Diverged
                : interrupted()      ? Interrupted
                                     : BadInput,
                failure->message);
}

std::string formatList()
{
    std::string list = "Formats:\n";
    for (const ExportFormat& format : exportFormats()) {
        std::string line = "  " + std::string(format.ending);
        line.resize(std::max<std::size_t>(line.size() + 1, 18), ' ');
        list += line + std::string(format.label) + '\n';
    }
    return list;
}

} // namespace

void addExport(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "export", "Write meshes, an animation or a table of a flight for other programs.");
    const auto options = std::make_shared<ExportOptions>();
    command
        ->add_option(
            "SCENE", options->scene.file,
            "Scene file, which is flown, or a recording (*.ripstop-run), which is taken as "
            "it is")
        ->required();
    command
        ->add_option("-o,--output", options->output,
                     "What to write; the ending says the format, see below")
        ->required()
        ->type_name("TARGET");
    command->add_option("--fps", options->fps, "Frames per simulated second")
        ->check(numberBetween(1e-6, 1e6))
        ->capture_default_str()
        ->type_name("F");
    command->add_option("--from", options->from, "Simulated time of the first frame, s")
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T0");
    command
        ->add_option("--to", options->to,
                     "Simulated time of the last frame, s; by default 10 s after the first, or the "
                     "end of the recording; for one moment the first itself")
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T1");
    command
        ->add_option("--controls", options->controls,
                     "What pilot and hands do: a control track, as of run --controls")
        ->type_name("FILE");
    command->add_flag("--exact", options->exact,
                      "Of a recording: compute each frame again, to the bit, instead of taking the "
                      "places that were kept, to 1e-6 m");
    command->add_flag("--replace", options->replaces,
                      "Also where a mesh that is written beside TARGET is there already");
    addSetOption(*command, options->scene.assignments);
    addThreadsOption(*command, options->threads);
    command->footer(
        formatList()
        + "\n"
          "Examples:\n"
          "  ripstop-cli export kite.ripstop.json -o design.obj            (as drawn)\n"
          "  ripstop-cli export kite.ripstop.json -o flying.ply --to 20    (after 20 s)\n"
          "  ripstop-cli export kite.ripstop.json -o kite.glb --to 10 --fps 25\n"
          "  ripstop-cli export kite.ripstop.json -o kite_{frame}.obj --to 2\n"
          "  ripstop-cli export kite.ripstop-run -o kite.pvd --from 3 --to 5 --fps 60\n"
          "\n"
          "Torn links and the panels beside them are left out of meshes. Formats of one\n"
          "mesh for all frames have the mesh as it is split in the end, from the start on;\n"
          "panels that go shrink to a point. Ctrl-C removes what was written.");
    command->callback([options, &chosen] { chosen = [options] { return exportScene(*options); }; });
}

} // namespace ripstop
