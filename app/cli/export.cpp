// ripstop-cli export: meshes, series and tables for other programs.
#include "export/export_run.h"

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "compile/compile.h"
#include "export/format.h"

#include <optional>

namespace ripstop {
namespace {

constexpr double seriesSeconds = 10.0; // s, of a series or table without --to

struct Options
{
    SceneInput scene;
    std::string output;
    double fps = 25.0;
    double from = 0.0;
    std::optional<double> to;
    std::string controls;
    int threads = 1;
};

bool isOneMoment(const std::filesystem::path& target)
{
    const ExportFormat* format = formatOf(target);
    return format && format->of == ExportFormat::Of::Moment;
}

int exportScene(const Options& options)
{
    const SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const auto system = compile(*loaded.scene);
    if (!system)
        return fail(BadInput, options.scene.file + ": " + system.message());

    Simulation simulation(*system, options.threads);
    ExportRange range{options.from, 0.0, options.fps};
    range.to = options.to.value_or(isOneMoment(options.output) ? options.from
                                                               : options.from + seriesSeconds);
    if (!options.controls.empty()) {
        Result<ControlTrack> track = readControlTrack(options.controls, *loaded.scene);
        if (!track)
            return fail(BadInput, track.message());
        range.controls = std::move(*track);
    }
    catchInterrupt();
    ProgressLine progress(options.output);
    const auto failure =
        exportRun(simulation, Dress(*loaded.scene), range, options.output, [&](double share) {
            progress.show(share);
            return !interrupted();
        });
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
        "export", "Fly a scene and write meshes, an animation or a table for other programs.");
    const auto options = std::make_shared<Options>();
    addSceneOption(*command, options->scene);
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
        ->check(numberBetween(0.0, 1e9))
        ->type_name("T0");
    command
        ->add_option("--to", options->to,
                     "Simulated time of the last frame, s; by default 10 s after the first, and "
                     "for one moment the first itself")
        ->check(numberBetween(0.0, 1e9))
        ->type_name("T1");
    command
        ->add_option("--controls", options->controls,
                     "What pilot and hands do: a control track, as of run --controls")
        ->type_name("FILE");
    addSetOption(*command, options->scene.assignments);
    command->add_option("--threads", options->threads, "Threads; the result is the same for all")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->footer(
        formatList()
        + "\n"
          "Examples:\n"
          "  ripstop-cli export kite.ripstop.json -o design.obj            (as drawn)\n"
          "  ripstop-cli export kite.ripstop.json -o flying.ply --to 20    (after 20 s)\n"
          "  ripstop-cli export kite.ripstop.json -o kite.glb --to 10 --fps 25\n"
          "  ripstop-cli export kite.ripstop.json -o kite_{frame}.obj --to 2\n"
          "\n"
          "Torn links and the panels beside them are left out of meshes. Formats of one\n"
          "mesh for all frames have the mesh as it is split in the end, from the start on;\n"
          "panels that go shrink to a point. Ctrl-C removes what was written.");
    command->callback([options, &chosen] { chosen = [options] { return exportScene(*options); }; });
}

} // namespace ripstop
