// Rows are made in the order of interest: what a design is first, its mesh last, under a heading
// for each group. Values come and go by the keys of parameters; a form that is filled by its owner
// says nothing of it.
#include "start/parameter_form.h"

#include "document/words.h"
#include "start/parameter_field.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>

#include <vector>

namespace ripstop {
namespace {

QLabel* headingOf(std::string_view words)
{
    auto* heading = new QLabel(translated(words));
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    heading->setContentsMargins(0, 6, 0, 0);
    return heading;
}

// What a design is comes before how finely it is cut up. A group is named by its first parameter.
std::vector<const Parameter*> inOrderOfInterest(std::span<const Parameter> parameters)
{
    std::vector<const Parameter*> ordered, ofMesh;
    bool isMesh = false;
    for (const Parameter& parameter : parameters) {
        if (!parameter.group.empty())
            isMesh = parameter.group == "Mesh";
        (isMesh ? ofMesh : ordered).push_back(&parameter);
    }
    ordered.insert(ordered.end(), ofMesh.begin(), ofMesh.end());
    return ordered;
}

} // namespace

ParameterForm::ParameterForm(std::span<const Parameter> parameters, QWidget* parent)
    : QWidget(parent)
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 4, 8, 4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const Parameter* one : inOrderOfInterest(parameters)) {
        const Parameter& parameter = *one;
        if (!parameter.group.empty())
            form->addRow(headingOf(parameter.group));
        auto* field = new ParameterField(parameter, ParameterField::Slider::With);
        field->setObjectName(text(parameter.key));
        auto* label = new QLabel(ParameterField::label(parameter));
        label->setToolTip(field->toolTip());
        label->setBuddy(field);
        form->addRow(label, field);
        m_fields.push_back(field);
        connect(field, &ParameterField::changed, this, &ParameterForm::changed);
    }
}

void ParameterForm::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter)
        QWidget::keyPressEvent(event);
}

Parameters ParameterForm::values() const
{
    Parameters values;
    for (const ParameterField* field : m_fields)
        values[std::string(field->parameter().key)] = field->value();
    return values;
}

QString ParameterForm::refusal() const
{
    for (const ParameterField* field : m_fields)
        if (const QString refusal = field->refusal(); !refusal.isEmpty())
            return refusal;
    return {};
}

void ParameterForm::setValues(const Parameters& values)
{
    const QSignalBlocker quiet(this); // the caller knows that the values have changed
    for (ParameterField* field : m_fields)
        if (const auto found = values.find(std::string(field->parameter().key));
            found != values.end())
            field->setValue(found->second);
}

void ParameterForm::restoreDefaults()
{
    const QSignalBlocker quiet(this);
    for (ParameterField* field : m_fields)
        field->setValue(field->parameter().atFirst());
}

} // namespace ripstop
