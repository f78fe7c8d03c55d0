// Stages: a Collector gathers texts; three functions give it those of properties, quantities and
// presets, those of builders and operations, and those of the verification, the export formats and
// the samples. A new table whose texts are shown in the window needs a line in one of them. At the
// end duplicates and empty texts go and the rest is sorted, so that the catalogue changes no more
// than the tables do.
#include "editor/table_texts.h"

#include "base/quantity.h"
#include "builders/builder.h"
#include "document/measurement.h"
#include "document/words.h"
#include "export/format.h"
#include "materials/presets.h"
#include "select/measure.h"
#include "shaping/operation.h"
#include "start/parameter_field.h"
#include "start/samples.h"
#include "verify/case.h"
#include "verify/reference.h"

namespace ripstop {
namespace {

class Collector
{
public:
    void add(std::string_view text)
    {
        if (!text.empty())
            m_texts << QString::fromUtf8(text.data(), qsizetype(text.size()));
    }

    void addChoices(std::span<const std::string_view> choices)
    {
        for (const std::string_view choice : choices)
            if (!findPreset(choice)) // it has a name of its own
                m_texts << englishLabel(choice);
    }

    void addParameters(std::span<const Parameter> parameters)
    {
        for (const Parameter& parameter : parameters) {
            m_texts << ParameterField::englishLabel(parameter);
            add(parameter.help);
            add(parameter.group);
            addChoices(parameter.choices);
        }
    }

    QStringList result()
    {
        m_texts.removeDuplicates();
        m_texts.removeAll(QString());
        m_texts.sort();
        return m_texts;
    }

private:
    QStringList m_texts;
};

void addDesigns(Collector& texts)
{
    for (int kind = 0; kind < kindCount; ++kind)
        texts.add(kindName(Kind(kind)));
    for (const Property& property : allProperties()) {
        texts.add(property.label);
        texts.add(property.help);
        texts.addChoices(property.choices);
        for (const Need& need : property.needs)
            texts.add(need.otherwise);
    }
    for (std::size_t i = 0; i < choiceNames<Quantity>.size(); ++i) {
        texts.add(rowOf(Quantity(i)).help);
        texts.add(asks(Quantity(i)));
    }
    for (const ConditionKey& key : conditionKeys(measurementOf(nullptr)))
        texts.add(key.help);
    for (const Preset& preset : allPresets()) { // sources are quoted as they are
        texts.add(preset.label);
        texts.add(preset.shortLabel);
    }
}

void addWork(Collector& texts)
{
    for (const Builder& builder : allBuilders()) {
        texts.add(builder.label);
        texts.add(englishLabel(builder.name).toStdString());
        texts.add(builder.help);
        texts.addParameters(builder.parameters);
        if (builder.table) {
            texts.add(englishLabel(builder.table->key).toStdString());
            texts.add(builder.table->help);
        }
    }
    for (const Operation& operation : allOperations()) {
        texts.add(operation.label);
        texts.add(operation.help);
        texts.addParameters(operation.parameters);
    }
}

// Only the headings of the verification are translated: its cases are records, and stay in English.
void addRest(Collector& texts)
{
    for (const Case& one : allCases())
        texts.add(one.section);
    for (const Reference& one : allReferences())
        texts.add(one.section);
    for (const ExportFormat& format : exportFormats()) {
        texts.add(format.label);
        texts.add(format.note);
    }
    for (const QString& file : sampleFiles()) {
        const Sample sample = readSample(file);
        texts.add(sample.title.toStdString());
        texts.add(sample.note.toStdString());
    }
}

} // namespace

QStringList tableTexts()
{
    Collector texts;
    addDesigns(texts);
    addWork(texts);
    addRest(texts);
    return texts.result();
}

} // namespace ripstop
