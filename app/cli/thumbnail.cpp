// ripstop-cli thumbnail: a small picture of a design, as desktops ask for it.
#include "cli/commands.h"
#include "export/design_picture.h"
#include "io/design_file.h"
#include "io/whole_file.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

struct ThumbnailOptions
{
    std::string file;
    std::string output;
    int size = 256; // pixels
};

int thumbnail(const ThumbnailOptions& options)
{
    const Result<Scene> scene = readDesign(options.file);
    if (!scene)
        return fail(BadInput, scene.message());
    const Result<std::string> png = pngBytes(pictureOf(*scene, options.size));
    if (!png)
        return fail(BadInput, png.message());
    if (const auto failure = replaceFile(options.output, *png, Flush::Later))
        return fail(BadInput, failure->message);
    return Done;
}

} // namespace

void addThumbnail(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "thumbnail", "Draw a small picture of a design, without a window or a display.");
    const auto options = std::make_shared<ThumbnailOptions>();
    command->add_option("SCENE", options->file, "Scene, or recording with the design of its start")
        ->required();
    command->add_option("-o,--output", options->output, "PNG file to write")
        ->type_name("FILE")
        ->required();
    command->add_option("--size", options->size, "Pixels of each side")
        ->check(CLI::Range(16, 4096))
        ->type_name("N");
    command->footer("Example:\n"
                    "  ripstop-cli thumbnail kite.ripstop.json -o kite.png --size 256\n"
                    "\n"
                    "File managers call it by share/thumbnailers/org.ripstop.Ripstop.thumbnailer, "
                    "which the package installs.");
    command->callback([options, &chosen] { chosen = [options] { return thumbnail(*options); }; });
}

} // namespace ripstop
