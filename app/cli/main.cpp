// The program: its commands in the order of its help, and what is said where one is misspelt.
#include "base/program_version.h"
#include "cli/commands.h"
#include "scene/property.h"
#include "terminal/output.h"
#include "terminal/terminal.h"

#include <exception>

namespace ripstop {
namespace {

// Names a command that is misspelt, because CLI11 says only "A subcommand is required".
std::optional<std::string> unknownCommand(const CLI::App& app, const std::string& word)
{
    std::vector<std::string_view> names;
    std::string list;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == word)
            return std::nullopt;
        names.push_back(command->get_name());
        list += (list.empty() ? "" : ", ") + command->get_name();
    }
    const std::string_view near = nearest(word, names);
    return "There is no command \"" + word + "\"; "
           + (near.empty() ? "there are " + list + "."
                           : "did you mean \"" + std::string(near) + "\"?");
}

int call(int argc, char** argv)
{
    CLI::App app("Ripstop without a window: build, inspect, fly and export fabric that flies.",
                 "ripstop-cli");
    app.set_version_flag("--version", "ripstop-cli " + programVersion());
    app.set_help_all_flag("--help-all", "Print the help of all commands and exit");
    app.require_subcommand(1);
    app.footer("Examples:\n"
               "  ripstop-cli build delta_kite span=1.8 wind=8 -o small.ripstop.json\n"
               "  ripstop-cli import sail.stl --unit mm --up z -o sail.ripstop.json\n"
               "  ripstop-cli info small.ripstop.json\n"
               "  ripstop-cli run small.ripstop.json --seconds 20 --csv small.csv\n"
               "  ripstop-cli export small.ripstop.json -o small.pvd --to 10 --fps 25\n"
               "  ripstop-cli bundle small.ripstop.json -o small.zip --seconds 20\n"
               "\n"
               "Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 the simulation diverged,\n"
               "4 a replay or a comparison differs, 5 a strict run missed its accuracy or a\n"
               "certificate its digits, 6 standard output is full or closed, 7 a run ended in a\n"
               "state that no fabric can be in, 128 and its number after a signal.\n"
               "ripstop-cli COMMAND --help explains each command.");

    Command chosen;
    addInfo(app, chosen);
    addBuild(app, chosen);
    addBuilders(app, chosen);
    addImport(app, chosen);
    addRun(app, chosen);
    addSweep(app, chosen);
    addStudy(app, chosen);
    addCertify(app, chosen);
    addCompare(app, chosen);
    addDiff(app, chosen);
    addExport(app, chosen);
    addBundle(app, chosen);
    addPolar(app, chosen);
    addBench(app, chosen);
    addProperties(app, chosen);
    addSchema(app, chosen);
    addPresets(app, chosen);
    addWeigh(app, chosen);
    addConvert(app, chosen);
    addMap(app, chosen);
    addThumbnail(app, chosen);
    addFit(app, chosen);
    addVerify(app, chosen);
    addCompletions(app, chosen);

    if (argc > 1 && argv[1][0] != '-')
        if (const auto message = unknownCommand(app, argv[1]))
            return fail(WrongUsage, *message);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Done : WrongUsage;
    }
    return chosen();
}

} // namespace
} // namespace ripstop

int main(int argc, char** argv)
{
    using namespace ripstop;
    StandardOutput output;
    catchInterrupt();
    try {
        return output.finish(call(argc, argv));
    } catch (const std::bad_alloc&) {
        return fail(BadInput, "There is not enough memory for this.");
    } catch (const std::exception& error) {
        return fail(BadInput, error.what());
    }
}
