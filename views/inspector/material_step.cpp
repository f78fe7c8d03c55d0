// Labels of the steps first; then a step is made, of materials or of what is selected, and said; at
// the end it is said before it is made.
#include "inspector/material_step.h"

#include "check/check.h"
#include "document/document.h"
#include "document/words.h"
#include "materials/own_materials.h"
#include "scene/element_index.h"
#include "select/made_of.h"

#include <QCoreApplication>

namespace ripstop {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("MaterialStep", text); }

QString presetLabel(const Preset& preset)
{
    return preset.own ? tr("%1 (own)").arg(QString::fromStdString(preset.label))
                      : translated(preset.label);
}

// "Areal density 47 → 38 g/m², Warp strength 8 → 6.6 kN/m"
QString changesInWords(const Preset& preset, const Material& before)
{
    QStringList words;
    for (const Message& change : changesBy(preset, before))
        words << translated(change).trimmed(); // a number without a unit ends in a blank
    return words.join(QStringLiteral(", "));
}

} // namespace

QString stepLabel(MaterialStep step)
{
    switch (step) {
    case MaterialStep::Lighter:
        return tr("Lighter");
    case MaterialStep::Heavier:
        return tr("Heavier");
    case MaterialStep::Softer:
        return tr("Softer");
    case MaterialStep::Stiffer:
        return tr("Stiffer");
    case MaterialStep::Weaker:
        return tr("Weaker");
    case MaterialStep::Stronger:
        break;
    }
    return tr("Stronger");
}

QString stepMaterials(Document& document, const std::vector<Id>& materials, MaterialStep step,
                      std::span<const Preset> own)
{
    const Scene& scene = document.scene();
    if (const auto problem = firstError(scene, ElementIndex(scene)))
        return translated(problem->message);
    Result<StepEdit> made = stepEdit(scene, materials, step, own);
    if (!made)
        return translated(made.message());
    QStringList words;
    for (const auto& [id, preset] : made->given) {
        const Material& material = *findItem<Material>(scene, id);
        words << tr("%1 is of %2 now: %3.")
                     .arg(QString::fromStdString(material.name), presetLabel(*preset),
                          changesInWords(*preset, material));
    }
    if (!made->edit.notWeighed.empty())
        words << tr("Particles keep their mass, because the density of before or of the preset "
                    "is not known.");
    document.push(std::move(made->edit.edit));
    return words.join(QChar(' '));
}

QString stepSelected(Document& document, const std::vector<Id>& selected, MaterialStep step)
{
    const std::vector<Id> materials = materialsOf(document.scene(), selected);
    if (materials.empty())
        return tr("Select a material, or cloth, lines or spars that are made of one.");
    return stepMaterials(document, materials, step, readOwnMaterials(ownMaterialsFile()).presets);
}

QString stepPreview(const Document& document, const std::vector<Id>& materials, MaterialStep step,
                    std::span<const Preset> own, bool& goes)
{
    QStringList words;
    goes = true;
    for (const Id id : materials) {
        const Material& material = *findItem<Material>(document.scene(), id);
        const Result<const Preset*> next = neighbour(material, step, own);
        if (!next) {
            goes = false;
            return translated(next.message());
        }
        words << tr("%1: %2, %3")
                     .arg(stepLabel(step), presetLabel(**next), changesInWords(**next, material));
    }
    return words.join(QChar('\n'));
}

} // namespace ripstop
