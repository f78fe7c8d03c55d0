// The commands of ripstop-cli. Each adds itself to the program with its options and help, and puts
// what it does into `chosen` when the user calls it.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace ripstop {

// Returns the exit code.
using Command = std::function<int()>;

void addInfo(CLI::App& app, Command& chosen);
void addBuild(CLI::App& app, Command& chosen);
void addBuilders(CLI::App& app, Command& chosen);
void addImport(CLI::App& app, Command& chosen);
void addRun(CLI::App& app, Command& chosen);
void addSweep(CLI::App& app, Command& chosen);
void addStudy(CLI::App& app, Command& chosen);
void addCertify(CLI::App& app, Command& chosen);
void addCompare(CLI::App& app, Command& chosen);
void addDiff(CLI::App& app, Command& chosen);
void addExport(CLI::App& app, Command& chosen);
void addBundle(CLI::App& app, Command& chosen);
void addPolar(CLI::App& app, Command& chosen);
void addBench(CLI::App& app, Command& chosen);
void addProperties(CLI::App& app, Command& chosen);
void addSchema(CLI::App& app, Command& chosen);
void addVerify(CLI::App& app, Command& chosen);
void addPresets(CLI::App& app, Command& chosen);
void addWeigh(CLI::App& app, Command& chosen);
void addConvert(CLI::App& app, Command& chosen);
void addMap(CLI::App& app, Command& chosen);
void addThumbnail(CLI::App& app, Command& chosen);
void addFit(CLI::App& app, Command& chosen);
void addCompletions(CLI::App& app, Command& chosen); // of all that were added before

} // namespace ripstop
