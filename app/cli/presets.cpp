// ripstop-cli presets: materials that one can buy, and what they make of a scene's.
//
// In order: the notes on what a preset leaves for the user to look at; applyPreset(), which gives
// the materials of a scene a preset or the next one of the library; and what is printed of the
// presets themselves (preset_list.h).
#include "materials/neighbours.h"

#include "check/check.h"
#include "check/step_check.h"
#include "cli/commands.h"
#include "cli/own_library.h"
#include "cli/preset_list.h"
#include "cli/scene_input.h"
#include "io/scene_file.h"
#include "scene/element_index.h"
#include "scene/path.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <iostream>

namespace ripstop {
namespace {

struct PresetOptions
{
    std::string preset;
    std::string step; // "lighter", ... in place of a preset
    std::vector<std::string> materials;
    SceneInput scene;
    std::string output;
    std::string shown;  // the preset of which all is told
    std::string saved;  // name of an own material that is made of the scene's
    std::string label;  // of it
    std::string source; // who says its numbers
    std::string kind;   // of it; empty is found from its numbers
    bool replace = false;
    std::string own; // file of own materials
    bool json = false;
    bool manual = false;
};

// What the user should know about the changed scene.
void printNotes(const Scene& scene, const PresetEdit& made)
{
    for (const Id id : made.notWeighed)
        std::cout << findItem<Material>(scene, id)->name
                  << ": the particles keep their mass, because the old density of the material or "
                     "the new one is not known.\n";
    const std::optional<StepLimit> limit = stepLimit(scene);
    const Settings& settings = scene.settings;
    if (limit && exceeds(settings, *limit))
        std::cout << "Substeps have to be shorter now for " << limit->cause.said().english()
                  << ": settings.substeps=" << substepsWithin(*limit, settings) << '\n';
}

// Of a material that has a density, which says whether it is of a sheet or of a line.
void printUnlike(const Material& material, const Preset& preset)
{
    const bool isSheet = material.arealDensity.has_value();
    if (isSheet == material.linearDensity.has_value() || isSheet == ripstop::isSheet(preset.kind))
        return;
    std::cout << material.name << ": it is weighed by its " << (isSheet ? "area" : "length")
              << ", and " << preset.name << " is of the kind " << presetKindName(preset.kind)
              << ", which gives what it carries neither stiffness nor strength.\n";
}

Result<std::vector<Id>> materialsCalled(const Scene& scene, const std::vector<std::string>& names)
{
    std::vector<Id> materials;
    for (const std::string& name : names) {
        const Result<Id> id = findNamed(scene, Kind::Material, name);
        if (!id)
            return Failure("--material %1: %2.", name, id.message());
        if (std::find(materials.begin(), materials.end(), *id) == materials.end())
            materials.push_back(*id);
    }
    return materials;
}

// Says what a step makes of each material.
void printSteps(const Scene& before, const StepEdit& made)
{
    for (const auto& [id, preset] : made.given) {
        const Material& material = *findItem<Material>(before, id);
        std::cout << material.name << ": " << preset->label << " (" << preset->name << ")\n";
        for (const Message& change : changesBy(*preset, material))
            std::cout << "  " << change.english() << '\n';
    }
}

// The edit that --apply or --step asks for.
Result<PresetEdit> presetEditOf(const PresetOptions& options, const Scene& scene,
                                const std::vector<Id>& materials)
{
    const std::vector<Preset> own = ownMaterials(options.own);
    if (options.step.empty()) {
        const Result<const Preset*> preset = findPreset(options.preset, own);
        if (!preset)
            return preset.failure();
        for (const Id id : materials)
            printUnlike(*findItem<Material>(scene, id), **preset);
        return presetEdit(scene, **preset, materials);
    }
    const auto step = std::ranges::find(allMaterialSteps, options.step, materialStepName);
    Result<StepEdit> made = stepEdit(scene, materials, *step, own);
    if (!made)
        return made.failure();
    printSteps(scene, *made);
    return std::move(made->edit);
}

int applyPreset(const PresetOptions& options)
{
    if (options.preset.empty() == options.step.empty())
        return fail(WrongUsage, "A scene needs one of --apply PRESET, --step WAY and --save NAME: "
                                "without it, presets are listed and nothing is changed.");
    if (!options.preset.empty()) {
        const Result<const Preset*> preset = findPreset(options.preset, ownMaterials(options.own));
        if (!preset)
            return fail(WrongUsage, preset.message());
    }
    if (options.scene.file.empty() || options.output.empty() || options.materials.empty())
        return fail(WrongUsage, Message("%1 needs a scene, --material NAME and -o SCENE for the "
                                        "result.",
                                        options.step.empty() ? "--apply" : "--step"));
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    Scene& scene = *loaded.scene;
    if (const auto problem = firstError(scene, ElementIndex(scene)))
        return fail(BadInput, Message("%1: %2", options.scene.file, problem->message));
    const Result<std::vector<Id>> materials = materialsCalled(scene, options.materials);
    if (!materials)
        return fail(WrongUsage, materials.message());
    const Result<PresetEdit> made = presetEditOf(options, scene, *materials);
    if (!made)
        return fail(BadInput, Message("%1: %2", options.scene.file, made.message()));
    (void)apply(scene, made->edit);
    if (const auto failure = saveReadable(scene, options.output))
        return fail(BadInput, failure->message);
    printNotes(scene, *made);
    return Done;
}

std::optional<PresetKind> kindCalled(std::string_view name)
{
    for (int kind = 0; kind < presetKindCount; ++kind)
        if (presetKindName(PresetKind(kind)) == name)
            return PresetKind(kind);
    return std::nullopt;
}

// Writes a material of the scene into the file of own materials.
int saveMaterial(const PresetOptions& options)
{
    if (options.scene.file.empty() || options.materials.size() != 1 || !options.preset.empty())
        return fail(WrongUsage, "--save needs a scene and one --material NAME of it.");
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const std::string& called = options.materials.front();
    const Result<Id> id = findNamed(*loaded.scene, Kind::Material, called);
    if (!id)
        return fail(WrongUsage, Message("--material %1: %2.", called, id.message()));
    const Material& material = *findItem<Material>(*loaded.scene, *id);
    const std::vector<Preset> own = ownMaterials(options.own);
    const std::string source = options.source.empty()
                                   ? "Material " + called + " of " + options.scene.file
                                   : options.source;
    Preset preset = presetFrom(material, kindCalled(options.kind).value_or(likelyKind(material)),
                               options.saved, source, presetOf(material, own));
    if (!options.label.empty())
        preset.label = options.label;
    const std::filesystem::path file = ownFileOf(options.own);
    if (const auto failure =
            saveOwnMaterial(file, preset, options.replace ? SameName::Replaced : SameName::Refused))
        return fail(BadInput, failure->message);
    std::cout << "Saved " << preset.name << " in " << file.string() << '\n';
    return Done;
}

int printList(const PresetOptions& options)
{
    std::vector<Preset> presets(allPresets().begin(), allPresets().end());
    if (!options.manual)
        for (Preset& preset : ownMaterials(options.own))
            presets.push_back(std::move(preset));
    if (!options.shown.empty()) {
        const Result<const Preset*> preset =
            findPreset(options.shown, std::span(presets).subspan(allPresets().size()));
        if (!preset)
            return fail(WrongUsage, preset.message());
        presets = std::vector<Preset>{**preset};
    }
    if (options.json)
        printPresetsJson(presets);
    else if (options.manual)
        printPresetManual(presets);
    else if (options.shown.empty())
        printPresets(presets);
    else
        printPreset(presets.front());
    return Done;
}

} // namespace

void addPresets(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "presets", "List fabrics, lines and spars with their sources, or give one to a scene.");
    const auto options = std::make_shared<PresetOptions>();
    command->add_option("SCENE", options->scene.file, "Scene file that --apply changes");
    command->add_option("--apply", options->preset, "Preset to give to the materials")
        ->type_name("PRESET");
    command
        ->add_option("--step", options->step,
                     "Give the materials the next one of the library: by weight or by stiffness")
        ->check(CLI::IsMember({"lighter", "heavier", "softer", "stiffer", "weaker", "stronger"}))
        ->type_name("lighter|heavier|softer|stiffer|weaker|stronger");
    command->add_option("--material", options->materials, "Name of a material; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("-o,--output", options->output, "Scene file to write")->type_name("SCENE");
    addSetOption(*command, options->scene.assignments);
    command->add_option("--show", options->shown, "Say where each number of this preset is from")
        ->type_name("PRESET");
    command->add_option("--save", options->saved, "Keep a material of the scene as an own one")
        ->type_name("NAME");
    command->add_option("--label", options->label, "With --save: what the screen shows");
    command->add_option("--source", options->source, "With --save: who says its numbers");
    command->add_option("--kind", options->kind, "With --save: what it is")
        ->check(CLI::IsMember({"fabric", "film", "line", "spar"}))
        ->type_name("fabric|film|line|spar");
    command->add_flag("--replace", options->replace, "With --save: also one of the same name");
    addOwnMaterialsOption(*command, "--materials,--own-materials", options->own);
    command->add_flag("--json", options->json, "Print the list as one JSON object");
    command->add_flag("--manual", options->manual, "Print the list as a page of the manual");
    command->footer(
        "Examples:\n"
        "  ripstop-cli presets\n"
        "  ripstop-cli presets --show skytex_27\n"
        "  ripstop-cli presets rope.ripstop.json --apply liros_ltc80 --material cord \\\n"
        "      -o lines.ripstop.json\n"
        "  ripstop-cli presets cloth.ripstop.json --apply skytex_38 --material cloth \\\n"
        "      -o canopy.ripstop.json\n"
        "  ripstop-cli presets kite.ripstop.json --material sail --save my_sail\n"
        "  ripstop-cli presets kite.ripstop.json --step lighter --material sail -o light.json");
    command->callback([options, &chosen] {
        chosen = [options] {
            const bool lists = options->preset.empty() && options->step.empty()
                               && options->scene.file.empty() && options->scene.assignments.empty()
                               && options->materials.empty() && options->output.empty();
            if (!options->saved.empty())
                return saveMaterial(*options);
            if (!lists)
                return applyPreset(*options);
            return printList(*options);
        };
    });
}

} // namespace ripstop
