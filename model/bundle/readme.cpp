#include "bundle/readme.h"

#include "io/json_text.h"

#include <array>
#include <utility>

namespace ripstop {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 8> contents{{
    {bundled::scene, "the design as it was flown"},
    {bundled::files, "files that the design names"},
    {bundled::controls, "what pilot and hands did"},
    {bundled::recording, "the recording: look at it in the editor with File > Open recording"},
    {bundled::probes, "what the probes read after each time step, with units"},
    {bundled::curves, "the same as a figure"},
    {"view.png", "the view of the editor when the bundle was made"},
    {bundled::manifest, "version, hashes and sums, for programs"},
}};

std::string exact(double number)
{
    std::string text;
    appendNumber(text, number);
    return text;
}

} // namespace

std::vector<std::string> commandsOf(const Manifest& manifest, bool hasProbes, bool isSteered)
{
    const std::string end = exact(double(manifest.steps) * manifest.timeStep);
    const std::string rate = " --fps " + exact(1.0 / manifest.timeStep);
    std::vector<std::string> commands;
    commands.emplace_back("ripstop-cli run .");
    if (manifest.from == Manifest::From::Scene) {
        const char* steered = isSteered ? " --controls controls.csv" : "";
        std::string run = "ripstop-cli run scene.ripstop.json --seconds ";
        run.append(end).append(steered).append(hasProbes ? " --csv probes.csv" : "");
        commands.push_back(run.append(" --record run.ripstop-run"));
        std::string draw = "ripstop-cli export scene.ripstop.json -o curves.svg --to ";
        if (hasProbes)
            commands.push_back(draw.append(end).append(rate).append(steered));
        return commands;
    }
    commands.emplace_back("ripstop-cli run --replay run.ripstop-run");
    for (const char* file : {bundled::probes, bundled::curves}) {
        std::string write = "ripstop-cli export run.ripstop-run --exact -o ";
        if (hasProbes)
            commands.push_back(write.append(file).append(rate));
    }
    return commands;
}

std::string readmeText(const Manifest& manifest, const std::filesystem::path& folder)
{
    std::string text = "# " + (manifest.title.empty() ? "A run of Ripstop" : manifest.title)
                       + "\n\nFlown by " + manifest.program + " from " + exact(manifest.begin)
                       + " s to " + exact(manifest.end) + " s in " + std::to_string(manifest.steps)
                       + " steps.\n";
    if (!manifest.stopped.empty())
        text += "\n" + manifest.stopped + "\n";
    text += "\n| state | hash |\n|---|---|\n| at the start | " + manifest.hashAtStart
            + " |\n| at the end | " + manifest.hashAtEnd
            + " |\n\n| file | what it is |\n|---|---|\n";
    std::error_code error;
    for (const auto& [name, what] : contents)
        if (name == std::string_view(bundled::manifest)
            || std::filesystem::exists(folder / name, error))
            text += "| " + std::string(name) + " | " + what + " |\n";
    text +=
        "\nIn this folder, the first of these lines flies it again and compares every step; the "
        "others\nmake its files again:\n\n";
    for (const std::string& command : manifest.commands)
        text += "    " + command + "\n";
    text += "\nThe hash of a state is equal for equal bits only.\n";
    return text;
}

} // namespace ripstop
