// ripstop-cli fit: a stiffness from a test of a strip, a line or a rod.
//
// In order: sizes and units as they are typed; the report, as text and JSON; and the own material
// that is made of it when a name is given.
#include "cli/commands.h"
#include "cli/own_library.h"
#include "io/whole_file.h"
#include "materials/material_test.h"
#include "materials/presets.h"
#include "scene/typed_number.h"
#include "terminal/terminal.h"

#include <cmath>
#include <iostream>

namespace ripstop {
namespace {

struct FitOptions
{
    std::string file;
    std::string specimen = "strip";
    std::string length, width, from, to; // as typed
    bool weft = false;
    TestUnits units;
    std::string saved;
    std::string label;
    std::string like;
    bool replace = false;
    std::string own;
    bool json = false;
};

// A number with a unit, or the failure that names the option.
Result<double> quantity(const char* option, const std::string& text, std::string_view unit)
{
    const Typed typed = typedValue(text, unit, ThreeDigits::AreRefused);
    if (!typed.number)
        return Failure("%1 %2: It %3.", option, text, typed.complaint);
    return typed.number->number;
}

Result<SpecimenSize> sizeOf(const FitOptions& options)
{
    SpecimenSize size;
    for (int i = 0; i < specimenCount; ++i)
        if (specimenName(Specimen(i)) == options.specimen)
            size.specimen = Specimen(i);
    size.direction = options.weft ? PullDirection::Weft : PullDirection::Warp;
    const Result<double> length = quantity("--length", options.length, "m");
    if (!length)
        return length.failure();
    size.length = *length;
    if (size.specimen != Specimen::Strip)
        return size;
    if (options.width.empty())
        return Failure("A strip needs its --width.");
    const Result<double> width = quantity("--width", options.width, "m");
    if (!width)
        return width.failure();
    constexpr double widest = 1.0; // m
    const Result<double> inOther = quantity("--width", options.width, "cm");
    const bool hasUnit = !inOther || *inOther != *width; // a pure number is one in any unit
    if (*width > widest && !hasUnit)
        return Failure("--width %1 is taken for metres, and no strip is as wide as that: say the "
                       "unit, as in --width \"%1 cm\".",
                       options.width);
    size.width = *width;
    return size;
}

Result<std::optional<ElongationRange>> rangeOf(const FitOptions& options, Specimen specimen)
{
    if (options.from.empty() && options.to.empty())
        return std::optional<ElongationRange>();
    const std::string_view unit = specimen == Specimen::Rod ? "m" : "";
    ElongationRange range{-1e9, 1e9};
    if (!options.from.empty()) {
        const Result<double> from = quantity("--from", options.from, unit);
        if (!from)
            return from.failure();
        range.from = *from;
    }
    if (!options.to.empty()) {
        const Result<double> to = quantity("--to", options.to, unit);
        if (!to)
            return to.failure();
        range.to = *to;
    }
    return std::optional(range);
}

std::string strengthUnit(Specimen specimen)
{
    return specimen == Specimen::Strip ? "N/m" : specimen == Specimen::Line ? "N" : "N m";
}

void printFit(const MaterialFit& fit, const SpecimenSize& size)
{
    const std::string unit(elongationUnit(size.specimen));
    const auto shown = [&](double elongation) {
        constexpr double roundOff = 1e-9; // mm or %
        const double number = shownElongation(elongation, size.specimen);
        return shortNumber(std::abs(number) < roundOff ? 0.0 : number) + ' ' + unit;
    };
    std::cout << stiffnessOf(size).key << ' ' << shortNumber(fit.stiffness) << ' '
              << stiffnessUnit(size.specimen) << "\n  standard error "
              << shortNumber(fit.standardError) << ' ' << stiffnessUnit(size.specimen) << " ("
              << shortNumber(100.0 * fit.standardError / fit.stiffness) << " %)\n  residual "
              << shortNumber(fit.residual) << " N\n  " << fit.points << " points from "
              << shown(fit.range.from) << " to " << shown(fit.range.to)
              << "\n  the line meets 0 N at " << shown(-fit.offset / fit.slope) << '\n';
    if (fit.strength)
        std::cout << strengthOf(size).key << ' ' << shortNumber(*fit.strength) << ' '
                  << strengthUnit(size.specimen) << "\n  broke at " << shortNumber(fit.highest)
                  << " N and " << shown(fit.highestAt) << '\n';
    else
        std::cout << "It did not break: the largest force is " << shortNumber(fit.highest)
                  << " N, at " << shown(fit.highestAt) << ".\n";
}

void printFitJson(const MaterialFit& fit, const SpecimenSize& size)
{
    print({{"property", stiffnessOf(size).key},
           {"value", fit.stiffness},
           {"unit", stiffnessUnit(size.specimen)},
           {"standard_error", fit.standardError},
           {"residual", fit.residual},
           {"offset", fit.offset},
           {"slope", fit.slope},
           {"points", fit.points},
           {"from", fit.range.from},
           {"to", fit.range.to},
           {"largest_force", fit.highest},
           {"largest_force_at", fit.highestAt},
           {"broke", fit.broke},
           {"strength_property", strengthOf(size).key},
           {"strength", fit.strength ? Json(*fit.strength) : Json()}});
}

int saveFit(const FitOptions& options, const MaterialFit& fit, const std::vector<TestPoint>& points,
            const SpecimenSize& size)
{
    const std::vector<Preset> own = ownMaterials(options.own);
    const Preset* like = nullptr;
    if (!options.like.empty()) {
        const Result<const Preset*> found = findPreset(options.like, own);
        if (!found)
            return fail(WrongUsage, Message("--like: %1", found.message()));
        like = *found;
    }
    Preset preset = presetOf(fit, points, size, options.saved, "Test " + options.file, like);
    if (!options.label.empty())
        preset.label = options.label;
    const std::filesystem::path file = ownFileOf(options.own);
    if (const auto failure =
            saveOwnMaterial(file, preset, options.replace ? SameName::Replaced : SameName::Refused))
        return fail(BadInput, failure->message);
    std::cerr << "Saved " << preset.name << " in " << file.string() << '\n';
    return Done;
}

int fitTest(const FitOptions& options)
{
    const Result<SpecimenSize> size = sizeOf(options);
    if (!size)
        return fail(WrongUsage, size.message());
    const auto range = rangeOf(options, size->specimen);
    if (!range)
        return fail(WrongUsage, range.message());
    const Result<std::string> text =
        readWholeFile(options.file, [](std::string_view) { return std::nullopt; });
    if (!text)
        return fail(BadInput, text.message());
    const auto test = readMaterialTest(*text, options.file, *size, options.units);
    if (!test)
        return fail(BadInput, test.message());
    if (const auto skipped = skippedText(*test))
        warn(options.file + ": " + skipped->english());
    const Result<MaterialFit> fit = fitMaterialTest(test->points, *size, *range);
    if (!fit)
        return fail(BadInput, Message("%1: %2", options.file, fit.message()));
    if (options.json)
        printFitJson(*fit, *size);
    else
        printFit(*fit, *size);
    return options.saved.empty() ? int(Done) : saveFit(options, *fit, test->points, *size);
}

void addSavingOptions(CLI::App& command, FitOptions& options)
{
    command.add_option("--save", options.saved, "Keep it as an own material")->type_name("NAME");
    command.add_option("--label", options.label, "With --save: what the screen shows");
    command.add_option("--like", options.like, "With --save: a preset that has the other numbers")
        ->type_name("PRESET");
    command.add_flag("--replace", options.replace, "With --save: also one of the same name");
    addOwnMaterialsOption(command, "--materials,--own-materials", options.own);
}

} // namespace

void addFit(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "fit", "Fit E t, EA or EI to a test: a CSV file of force and elongation.");
    const auto options = std::make_shared<FitOptions>();
    command->add_option("TEST", options->file, "CSV file, \"force (N),elongation (mm)\"")
        ->required();
    command->add_option("--of", options->specimen, "What was pulled, or bent")
        ->check(CLI::IsMember({"strip", "line", "rod"}))
        ->capture_default_str()
        ->type_name("strip|line|rod");
    command
        ->add_option("--length", options->length,
                     "Between the clamps, or between the supports of a rod that is pressed in its "
                     "middle, m or with a unit")
        ->required()
        ->type_name("L");
    command->add_option("--width", options->width, "Of a strip, m or with a unit")->type_name("W");
    command->add_flag("--weft", options->weft, "The strip was pulled across its warp");
    command
        ->add_option("--from", options->from,
                     "Elongation from which points count, as a strain (0.2 %); of a rod in m")
        ->type_name("X");
    command->add_option("--to", options->to, "Elongation up to which points count")->type_name("X");
    command->add_option("--force-unit", options->units.force, "Where the header does not say it")
        ->type_name("UNIT");
    command
        ->add_option("--elongation-unit", options->units.elongation,
                     "Where the header does not say it: mm, %, strain")
        ->type_name("UNIT");
    addSavingOptions(*command, *options);
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer(
        "Without --from and --to, the points between 10 and 60 % of the largest force count.\n\n"
        "Examples:\n"
        "  ripstop-cli fit strip.csv --width \"5 cm\" --length \"20 cm\"\n"
        "  ripstop-cli fit cord.csv --of line --length 1 --from \"0.3 %\" --to \"1 %\" --save "
        "cord\n"
        "  ripstop-cli fit rod.csv --of rod --length \"660.4 mm\" --save my_rod --like "
        "carbon_rod_4");
    command->callback([options, &chosen] { chosen = [options] { return fitTest(*options); }; });
}

} // namespace ripstop
