#include "cli/commands.h"
#include "cli/terminal.h"

#include <exception>

int main(int argc, char** argv)
{
    using namespace ripstop;

    CLI::App app("Ripstop without a window: build, inspect, fly and export fabric that flies.",
                 "ripstop-cli");
    app.set_version_flag("--version", "ripstop-cli " RIPSTOP_VERSION);
    app.require_subcommand(1);
    app.footer("Examples:\n"
               "  ripstop-cli build delta_kite span=1.8 wind=8 -o small.ripstop.json\n"
               "  ripstop-cli info small.ripstop.json\n"
               "  ripstop-cli run small.ripstop.json --seconds 20 --csv small.csv\n"
               "  ripstop-cli export small.ripstop.json -o small.pvd --to 10 --fps 25\n"
               "\n"
               "Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 the simulation diverged.\n"
               "ripstop-cli COMMAND --help explains each command.");

    Command chosen;
    addInfo(app, chosen);
    addBuild(app, chosen);
    addBuilders(app, chosen);
    addRun(app, chosen);
    addExport(app, chosen);
    addBench(app, chosen);
    addProperties(app, chosen);

    try {
        app.parse(argc, argv);
        return chosen();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : wrongUsage;
    } catch (const std::bad_alloc&) {
        return fail(badInput, "There is not enough memory for this.");
    } catch (const std::exception& error) {
        return fail(badInput, error.what());
    }
}
