// ripstop-cli completions: the script by which a shell completes commands, options and their words.
//
// The program is read as CLI11 has it: CommandFacts of each command, its own commands last. A
// shell's script is made of these alone, so that it knows what the program knows.
#include "builders/builder.h"
#include "materials/presets.h"

#include "cli/commands.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <iostream>

namespace ripstop {
namespace {

using Words = std::vector<std::string>;

struct OptionFacts
{
    Words names; // with their dashes
    std::string help;
    std::string value; // what it is called, empty for a flag
    Words words;       // that it may be

    bool takesFile() const
    {
        return words.empty()
               && std::ranges::any_of(
                   std::array{"FILE", "SCENE", "FOLDER", "STUDY", "TEXT"},
                   [&](std::string_view file) { return value.find(file) != value.npos; });
    }
};

struct CommandFacts
{
    Words path; // "study", "run"; empty for the program
    std::string help;
    std::vector<OptionFacts> options;
    Words words;    // of what is given without an option
    bool takesFile; // without an option
    std::vector<CommandFacts> commands;

    std::string name() const { return path.empty() ? "" : path.back(); }
};

std::string joined(const Words& words, std::string_view between = " ")
{
    std::string text;
    for (const std::string& word : words)
        text.append(text.empty() ? "" : between).append(word);
    return text;
}

// "{a,b,c}" behind the name of a value, as CLI11 shows what a value has to be one of.
Words wordsIn(const std::string& type)
{
    const std::size_t open = type.find('{'), close = type.rfind('}');
    return open == std::string::npos || close < open
               ? Words()
               : CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

template <typename Things>
Words namesOf(const Things& things)
{
    Words names;
    for (const auto& thing : things)
        names.emplace_back(thing.name);
    return names;
}

Words wordsOf(const CLI::Option& option)
{
    const std::string name = option.get_single_name();
    if (name == "BUILDER")
        return namesOf(allBuilders());
    if (name == "PRESET" || name == "apply")
        return namesOf(allPresets());
    return wordsIn(option.get_type_name());
}

// Words of a line, in the quotes of a shell.
std::string oneLine(std::string text)
{
    std::ranges::replace(text, '\n', ' ');
    std::erase(text, '\'');
    return text;
}

CommandFacts factsOf(const CLI::App& command, Words path)
{
    CommandFacts facts{std::move(path), oneLine(command.get_description()), {}, {}, false, {}};
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional() && !option->nonpositional()) {
            const Words words = wordsOf(*option);
            facts.words.insert(facts.words.end(), words.begin(), words.end());
            facts.takesFile |= words.empty();
            continue;
        }
        OptionFacts one{{}, oneLine(option->get_description()), {}, wordsOf(*option)};
        for (const std::string& name : option->get_snames())
            one.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames())
            one.names.push_back("--" + name);
        if (option->get_items_expected_max() > 0) {
            const std::string type = option->get_type_name();
            one.value = type.substr(0, type.find_first_of(":{ "));
            if (one.value.empty())
                one.value = "VALUE";
        }
        facts.options.push_back(std::move(one));
    }
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; })) {
        Words inside = facts.path;
        inside.push_back(inner->get_name());
        facts.commands.push_back(factsOf(*inner, std::move(inside)));
    }
    return facts;
}

template <typename Visit>
void forEachCommand(const CommandFacts& facts, const Visit& visit)
{
    visit(facts);
    for (const CommandFacts& inner : facts.commands)
        forEachCommand(inner, visit);
}

Words namesOfOptions(const CommandFacts& facts)
{
    Words names;
    for (const OptionFacts& option : facts.options)
        names.insert(names.end(), option.names.begin(), option.names.end());
    return names;
}

// --- bash ------------------------------------------------------------------------------------

void printBash(const CommandFacts& program)
{
    Words commands;
    std::string values, options, words;
    forEachCommand(program, [&](const CommandFacts& facts) {
        const std::string path = joined(facts.path);
        if (!facts.path.empty())
            commands.push_back("'" + path + "'");
        for (const OptionFacts& option : facts.options)
            for (const std::string& name : option.names)
                if (!option.value.empty())
                    values += "        '" + path + " " + name + "') words='" + joined(option.words)
                              + (option.takesFile() ? "' files=1 ;;\n" : "' ;;\n");
        options += "        '" + path + "') words='" + joined(namesOfOptions(facts)) + "' ;;\n";
        Words inner = facts.words;
        for (const CommandFacts& one : facts.commands)
            inner.push_back(one.name());
        words += "        '" + path + "') words='" + joined(inner)
                 + "' files=" + (facts.takesFile ? "1" : "") + " ;;\n";
    });
    std::cout
        << "# bash completion of ripstop-cli\n"
           "_ripstop_cli()\n"
           "{\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    local command= words= files= i\n"
           "    for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "        case \"${command:+$command }${COMP_WORDS[i]}\" in\n"
           "        "
        << joined(commands, " | ")
        << ") command=${command:+$command }${COMP_WORDS[i]} ;;\n"
           "        esac\n"
           "    done\n"
           "    case \"$command $before\" in\n"
        << values
        << "        *)\n"
           "    if [[ $current == -* ]]; then\n"
           "        case \"$command\" in\n"
        << options
        << "        esac\n"
           "    else\n"
           "        case \"$command\" in\n"
        << words
        << "        esac\n"
           "    fi ;;\n"
           "    esac\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"\n"
           "        [[ -n $files ]] && compgen -f -- \"$current\")\n"
           "}\n"
           "complete -o filenames -o bashdefault -F _ripstop_cli ripstop-cli\n";
}

// --- zsh -------------------------------------------------------------------------------------

std::string functionOf(const CommandFacts& facts)
{
    return facts.path.empty() ? "_ripstop_cli" : "_ripstop_cli_" + joined(facts.path, "_");
}

// What ends a part of a specification of zsh's is escaped.
std::string forZsh(const std::string& text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\')
            escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string actionOf(const Words& words, bool takesFile)
{
    return takesFile ? "_files" : "(" + joined(words) + ")";
}

void printZshFunction(const CommandFacts& facts)
{
    std::cout << functionOf(facts) << "()\n{\n    local line state\n    _arguments -C";
    for (const OptionFacts& option : facts.options)
        for (const std::string& name : option.names)
            std::cout << " \\\n        '" << name << '[' << forZsh(option.help) << ']'
                      << (option.value.empty() ? ""
                                               : ":" + forZsh(option.value) + ":"
                                                     + actionOf(option.words, option.takesFile()))
                      << '\'';
    if (facts.commands.empty()) {
        if (facts.takesFile || !facts.words.empty())
            std::cout << " \\\n        '*:argument:" << actionOf(facts.words, facts.takesFile)
                      << '\'';
        std::cout << "\n}\n";
        return;
    }
    std::cout << " \\\n        '1: :->command' '*:: :->rest'\n"
                 "    case $state in\n"
                 "    command)\n"
                 "        local -a commands=(\n";
    for (const CommandFacts& inner : facts.commands)
        std::cout << "            '" << inner.name() << ':' << forZsh(inner.help) << "'\n";
    std::cout << "        )\n"
                 "        _describe command commands ;;\n"
                 "    rest)\n"
                 "        case $line[1] in\n";
    for (const CommandFacts& inner : facts.commands)
        std::cout << "        " << inner.name() << ") " << functionOf(inner) << " ;;\n";
    std::cout << "        esac ;;\n"
                 "    esac\n"
                 "}\n";
}

void printZsh(const CommandFacts& program)
{
    std::cout << "#compdef ripstop-cli\n";
    forEachCommand(program, printZshFunction);
    std::cout << "_ripstop_cli \"$@\"\n";
}

// --- fish ------------------------------------------------------------------------------------

// Where the words before are those of the path.
std::string conditionOf(const CommandFacts& facts)
{
    if (facts.path.empty())
        return "__fish_use_subcommand";
    std::string condition;
    for (const std::string& word : facts.path)
        condition += (condition.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + word);
    if (!facts.commands.empty())
        for (const CommandFacts& inner : facts.commands)
            condition += "; and not __fish_seen_subcommand_from " + inner.name();
    return condition;
}

void printFish(const CommandFacts& program)
{
    std::cout << "# fish completion of ripstop-cli\n"
                 "complete -c ripstop-cli -n __fish_use_subcommand -f\n";
    forEachCommand(program, [](const CommandFacts& facts) {
        const std::string begin = "complete -c ripstop-cli -n '" + conditionOf(facts) + "' ";
        for (const CommandFacts& inner : facts.commands)
            std::cout << begin << "-f -a " << inner.name() << " -d '" << inner.help << "'\n";
        if (!facts.words.empty())
            std::cout << begin << "-a '" << joined(facts.words) << "'\n";
        for (const OptionFacts& option : facts.options) {
            std::cout << begin;
            for (const std::string& name : option.names)
                std::cout << (name.starts_with("--") ? "-l " + name.substr(2)
                                                     : "-s " + name.substr(1))
                          << ' ';
            if (!option.words.empty())
                std::cout << "-x -a '" << joined(option.words) << "' ";
            else if (!option.value.empty())
                std::cout << (option.takesFile() ? "-r " : "-x ");
            std::cout << "-d '" << option.help << "'\n";
        }
    });
}

} // namespace

void addCompletions(CLI::App& app, Command& chosen)
{
    CLI::App* command =
        app.add_subcommand("completions", "Print the script by which a shell completes commands.");
    const auto shell = std::make_shared<std::string>();
    command->add_option("SHELL", *shell, "The shell")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->footer(
        "Examples:\n"
        "  source <(ripstop-cli completions bash)\n"
        "  ripstop-cli completions zsh > ~/.zfunc/_ripstop-cli\n"
        "  ripstop-cli completions fish > ~/.config/fish/completions/ripstop-cli.fish\n");
    command->callback([shell, &app, &chosen] {
        chosen = [shell, &app] {
            const CommandFacts program = factsOf(app, {});
            if (*shell == "bash")
                printBash(program);
            else if (*shell == "zsh")
                printZsh(program);
            else
                printFish(program);
            return Done;
        };
    });
}

} // namespace ripstop
