// Rows are made in the order of interest: what a design is first, then its materials, its mesh
// last, under a heading for each group; showWhatCounts() folds those that do nothing. Values come
// and go by the keys of parameters; a form that is filled by its owner says nothing of it.
#include "start/parameter_form.h"

#include "document/words.h"
#include "icons/fold_button.h"
#include "start/parameter_field.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <functional>

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

using Rows = std::vector<const Parameter*>;

// What a design is comes before what it is made of, and its mesh comes last. A group is named by
// its first parameter.
std::vector<Rows> inOrderOfInterest(std::span<const Parameter> parameters)
{
    std::vector<Rows> groups;
    for (const Parameter& parameter : parameters) {
        if (groups.empty() || !parameter.group.empty())
            groups.emplace_back();
        groups.back().push_back(&parameter);
    }
    const auto isCalled = [](std::string_view name) {
        return [name](const Rows& group) { return group.front()->group == name; };
    };
    const auto mesh =
        std::stable_partition(groups.begin(), groups.end(), std::not_fn(isCalled("Mesh")));
    if (groups.begin() != mesh)
        std::stable_partition(groups.begin() + 1, mesh, isCalled("Materials"));
    return groups;
}

} // namespace

ParameterForm::ParameterForm(std::span<const Parameter> parameters, QWidget* parent)
    : QWidget(parent)
    , m_parameters(parameters)
    , m_form(new QFormLayout(this))
    , m_idle(new FoldButton("idleParameters"))
{
    m_form->setContentsMargins(0, 4, 8, 4);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const Rows& rows : inOrderOfInterest(parameters))
        addGroup(rows);
    m_form->addRow(m_idle);
    connect(m_idle, &FoldButton::toggledOpen, this, &ParameterForm::showWhatCounts);
    showWhatCounts();
}

void ParameterForm::addGroup(const Rows& rows)
{
    Group& group = m_groups.emplace_back();
    group.heading = rows.front()->group.empty() ? nullptr : headingOf(rows.front()->group);
    if (group.heading)
        m_form->addRow(group.heading);
    for (const Parameter* parameter : rows) {
        auto* field = new ParameterField(*parameter, ParameterField::Slider::With);
        field->setObjectName(text(parameter->key));
        auto* label = new QLabel(ParameterField::label(*parameter));
        label->setBuddy(field);
        m_form->addRow(label, field);
        group.fields.push_back(field);
        m_fields.push_back(field);
        connect(field, &ParameterField::changed, this, [this, key = parameter->key] {
            m_said.insert(key);
            showWhatCounts();
            emit changed();
        });
    }
}

// "Does nothing now: it counts where Cloth is "Ideal"."
QString ParameterForm::whyIdle(const Parameter& parameter) const
{
    const auto& [key, is] = parameter.needs;
    const auto other = std::ranges::find(m_parameters, key, &Parameter::key);
    const QString zero =
        other->choices.empty() ? QStringLiteral("0") : choiceLabel(other->choices[0]);
    const QString why = is == ParameterNeed::Is::Zero
                            ? tr("Does nothing now: it counts where %1 is “%2”.")
                            : tr("Does nothing now: it counts where %1 is not “%2”.");
    return QStringLiteral("<p><b>%1</b></p>").arg(why.arg(ParameterField::label(*other), zero));
}

void ParameterForm::showWhatCounts()
{
    const Parameters all = values();
    int idle = 0;
    for (const Group& group : m_groups) {
        int shown = 0;
        for (ParameterField* field : group.fields) {
            const bool does = counts(field->parameter(), m_parameters, all);
            const bool isShown = does || m_idle->isOpen();
            m_form->setRowVisible(field, isShown);
            QWidget* label = m_form->labelForField(field);
            label->setForegroundRole(does ? QPalette::WindowText : QPalette::PlaceholderText);
            label->setToolTip((does ? QString() : whyIdle(field->parameter())) + field->toolTip());
            idle += !does;
            shown += isShown;
        }
        if (group.heading)
            m_form->setRowVisible(group.heading, shown > 0);
    }
    m_idle->sayIdle(idle);
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
            found != values.end()) {
            field->setValue(found->second);
            m_said.erase(field->parameter().key);
        }
    showWhatCounts();
}

Parameters ParameterForm::said() const
{
    Parameters said = values();
    std::erase_if(said, [this](const auto& value) { return !m_said.contains(value.first); });
    return said;
}

void ParameterForm::say(const Parameters& values)
{
    setValues(values);
    for (const ParameterField* field : m_fields)
        if (values.contains(std::string(field->parameter().key)))
            m_said.insert(field->parameter().key);
}

void ParameterForm::restoreDefaults()
{
    const QSignalBlocker quiet(this);
    for (ParameterField* field : m_fields)
        field->setValue(field->parameter().atFirst());
    m_said.clear();
    showWhatCounts();
}

} // namespace ripstop
