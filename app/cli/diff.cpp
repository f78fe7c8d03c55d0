// ripstop-cli diff: what two designs differ in, in words.
//
// It ends as diff(1) does, 0 for the same, 1 for others, 2 for trouble, whatever other commands
// say by those numbers. Git calls a program for differences with seven or nine words about one
// file, and wants 0 from it in each case.
#include "author/scene_difference.h"
#include "cli/commands.h"
#include "cli/json_values.h"
#include "io/design_file.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

enum DiffExit { NoDifference = 0, SomeDifference = 1, CannotTell = 2 };

struct DiffOptions
{
    std::vector<std::string> words;
    bool json = false;
    bool brief = false;
};

// What git says of one file: its name, the old file, hash and mode, and the new ones; after a
// rename the new name and how alike the two are besides. One word alone is a file of a merge that
// is not settled.
struct Asked
{
    std::string first;
    std::string second;
    std::string nameFirst;
    std::string nameSecond;
    bool byGit = false;
};

std::optional<Asked> askedFor(const std::vector<std::string>& words)
{
    if (words.size() == 2)
        return Asked{words[0], words[1], words[0], words[1], false};
    if (words.size() == 7)
        return Asked{words[1], words[4], "a/" + words[0], "b/" + words[0], true};
    if (words.size() == 9)
        return Asked{words[1], words[4], "a/" + words[0], "b/" + words[7], true};
    return std::nullopt;
}

// Nothing is there before a file was added and after it was removed; git says /dev/null then.
Result<Scene> designIn(const std::string& file)
{
    return file == "/dev/null" ? Result<Scene>(Scene()) : readDesign(file);
}

Json jsonOf(const SceneDifference& difference)
{
    constexpr std::array<const char*, 7> names{"added", "removed",  "parameter", "by_hand",
                                               "count", "property", "unknown"};
    const auto ids = [](const std::vector<Id>& list) {
        Json numbers = Json::array();
        for (const Id id : list)
            numbers.push_back(std::uint32_t(id));
        return numbers;
    };
    return {{"what", names[std::size_t(difference.what)]},
            {"kind", kindName(difference.kind)},
            {"item", difference.item},
            {"key", difference.key},
            {"unit", difference.unit},
            {"from", jsonOf(difference.from)},
            {"to", jsonOf(difference.to)},
            {"first", ids(difference.inFirst)},
            {"second", ids(difference.inSecond)},
            {"text", difference.text.english()}};
}

int diff(const DiffOptions& options)
{
    const auto asked = askedFor(options.words);
    if (!asked) {
        (void)fail(WrongUsage, "Name two scenes or recordings to be compared.");
        return CannotTell;
    }
    const Result<Scene> first = designIn(asked->first);
    const Result<Scene> second = designIn(asked->second);
    if (!first || !second) {
        (void)fail(BadInput, first ? second.message() : first.message());
        return CannotTell;
    }
    const std::vector<SceneDifference> list = differencesOf(*first, *second);
    if (options.json) {
        Json rows = Json::array();
        for (const SceneDifference& difference : list)
            rows.push_back(jsonOf(difference));
        print({{"same", list.empty()},
               {"first", sizeOf(*first).english()},
               {"second", sizeOf(*second).english()},
               {"differences", std::move(rows)}});
    } else if (!list.empty() && options.brief) {
        std::cout << asked->nameFirst << " and " << asked->nameSecond << " differ in "
                  << list.size() << (list.size() == 1 ? " thing\n" : " things\n");
    } else if (!list.empty()) {
        std::cout << "--- " << asked->nameFirst << "\t" << sizeOf(*first).english() << "\n+++ "
                  << asked->nameSecond << "\t" << sizeOf(*second).english() << '\n';
        for (const SceneDifference& difference : list)
            std::cout << difference.text.english() << '\n';
    }
    return list.empty() || asked->byGit ? NoDifference : SomeDifference;
}

} // namespace

void addDiff(CLI::App& app, Command& chosen)
{
    CLI::App* command =
        app.add_subcommand("diff", "Tell in words what two designs differ in, like diff(1).");
    const auto options = std::make_shared<DiffOptions>();
    command->add_option("SCENES", options->words, "Two scenes or recordings")
        ->type_name("FILE")
        ->required();
    command->add_flag("--json", options->json, "Print one JSON object");
    command->add_flag("-q,--brief", options->brief, "Say only whether they differ");
    command->footer(
        "Examples:\n"
        "  ripstop-cli diff kite.ripstop.json kite_longer.ripstop.json\n"
        "  ripstop-cli diff kite.ripstop.json flight.ripstop-run --json\n"
        "\n"
        "The exit code is 0 when the designs are the same, 1 when they differ, 2 when one cannot "
        "be read.\nGit calls it for scenes after\n"
        "  echo '*.ripstop.json diff=ripstop' >> .gitattributes\n"
        "  git config diff.ripstop.command 'ripstop-cli diff'");
    command->callback([options, &chosen] { chosen = [options] { return diff(*options); }; });
}

} // namespace ripstop
