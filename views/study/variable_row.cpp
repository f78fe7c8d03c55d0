// The constructor makes the line of a range or of a list; what is typed is judged as it is typed
// and becomes values when it is committed.
#include "study/variable_row.h"

#include "document/plain_text.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "icons/icon.h"
#include "inspector/value_edit.h"
#include "scene/typed_number.h"

#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>

namespace ripstop {
namespace {

constexpr int mostSteps = 1000;

QString judgeNumber(const QString& typed, const QString& unit)
{
    const Typed read = typedValue(typed.toStdString(), unit.toStdString());
    return read.number ? QString()
                       : VariableRow::tr("The number %1.").arg(translated(read.complaint));
}

double numberOf(const QString& typed, const QString& unit)
{
    const Typed read = typedValue(typed.toStdString(), unit.toStdString());
    return read.number ? read.number->number : 0.0;
}

QString listOf(const std::vector<std::string>& values)
{
    QStringList all;
    for (const std::string& value : values)
        all << QString::fromStdString(value);
    return all.join(QStringLiteral("; "));
}

} // namespace

VariableRow::VariableRow(StudyVariable variable, QString unit, QWidget* parent)
    : QWidget(parent)
    , m_variable(std::move(variable))
    , m_unit(std::move(unit))
    , m_complaint(new Complaint)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 6);
    grid->setVerticalSpacing(2);
    grid->setHorizontalSpacing(4);
    auto* name = new QLabel(QString::fromStdString(m_variable.name));
    name->setTextFormat(Qt::PlainText);
    QStringList paths;
    for (const std::string& path : m_variable.paths)
        paths << QString::fromStdString(path);
    name->setToolTip(shownAsIs(tr("Sets %1").arg(paths.join(QStringLiteral(", ")))));
    if (paths.size() > 1)
        name->setText(tr("%1 and %n more", nullptr, int(paths.size()) - 1).arg(name->text()));
    auto* remove = new QToolButton;
    remove->setIcon(icon(QStringLiteral("close")));
    remove->setIconSize(QSize(12, 12));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Vary it no more."));
    remove->setAccessibleName(tr("Remove %1").arg(name->text()));
    connect(remove, &QToolButton::clicked, this, &VariableRow::removed);
    grid->addWidget(name, 0, 0, 1, 6);
    grid->addWidget(remove, 0, 6);
    using Kind = Distribution::Kind;
    const bool isRange =
        m_variable.spread
        && (m_variable.spread->kind == Kind::Uniform || m_variable.spread->kind == Kind::Log);
    if (isRange)
        addRange(*grid);
    else if (!m_variable.spread)
        addList(*grid);
    else
        grid->addWidget(new QLabel(tr("Drawn from the distribution in the file.")), 1, 0, 1, 6);
    grid->addWidget(m_complaint, 2, 0, 1, 7);
}

ValueEdit* VariableRow::endEdit(const QString& name)
{
    auto* edit = new ValueEdit([this](const QString& typed) { return judgeNumber(typed, m_unit); });
    edit->setUnit(m_unit);
    edit->setAccessibleName(name);
    edit->setMinimumWidth(70);
    connect(edit, &ValueEdit::complained, m_complaint, &Complaint::tell);
    return edit;
}

void VariableRow::addRange(QGridLayout& grid)
{
    m_from = endEdit(tr("From"));
    m_to = endEdit(tr("To"));
    m_from->show(compactNumber(m_variable.spread->a));
    m_to->show(compactNumber(m_variable.spread->b));
    m_count = new QSpinBox;
    m_count->setRange(0, mostSteps);
    m_count->setValue(int(m_variable.values.size()));
    m_count->setAccessibleName(tr("Values"));
    m_count->setToolTip(tr("How many values, both ends included."));
    m_log = new QToolButton;
    m_log->setText(tr("log"));
    m_log->setCheckable(true);
    m_log->setChecked(m_variable.spread->kind == Distribution::Kind::Log);
    m_log->setToolTip(tr("Even factors from value to value instead of even differences."));
    grid.addWidget(m_from, 1, 0);
    grid.addWidget(new QLabel(QStringLiteral("–")), 1, 1);
    grid.addWidget(m_to, 1, 2);
    m_times = new QLabel(QStringLiteral("×"));
    grid.addWidget(m_times, 1, 3);
    grid.addWidget(m_count, 1, 4);
    grid.addWidget(m_log, 1, 5);
    grid.setColumnStretch(0, 1);
    grid.setColumnStretch(2, 1);
    connect(m_from, &ValueEdit::committed, this, &VariableRow::takeRange);
    connect(m_to, &ValueEdit::committed, this, &VariableRow::takeRange);
    connect(m_count, &QSpinBox::valueChanged, this, &VariableRow::takeRange);
    connect(m_log, &QToolButton::clicked, this, &VariableRow::takeRange);
}

void VariableRow::showCount(bool isShown)
{
    if (m_count)
        for (QWidget* one : std::initializer_list<QWidget*>{m_times, m_count})
            one->setVisible(isShown);
}

void VariableRow::takeRange()
{
    const auto& kept = m_variable.spread; // what is shown may have fewer digits
    const auto valueOf = [&](const ValueEdit& edit, double before) {
        return edit.text() == compactNumber(before) ? before : numberOf(edit.text(), m_unit);
    };
    const double from = valueOf(*m_from, kept->a), to = valueOf(*m_to, kept->b);
    if (!(from < to))
        return m_complaint->tell(tr("The second number has to be larger than the first."));
    if (m_log->isChecked() && !(from > 0.0))
        return m_complaint->tell(tr("Even factors have to begin above 0."));
    m_complaint->tell({});
    const int count = m_count->value() == 1 ? 2 : m_count->value(); // both ends
    StudyVariable range = rangeVariable(from, to, count, m_log->isChecked());
    m_variable.values = std::move(range.values);
    m_variable.spread = range.spread;
    m_from->show(compactNumber(from));
    m_to->show(compactNumber(to));
    emit edited();
}

void VariableRow::addList(QGridLayout& grid)
{
    m_list = new ValueEdit([](const QString& typed) {
        return typed.simplified().isEmpty() ? VariableRow::tr("At least one value is needed.")
                                            : QString();
    });
    m_list->setAccessibleName(tr("Values"));
    m_list->setToolTip(tr("Values, with a semicolon between two."));
    m_list->show(listOf(m_variable.values));
    m_list->setCursorPosition(0);
    grid.addWidget(m_list, 1, 0, 1, 7);
    connect(m_list, &ValueEdit::complained, m_complaint, &Complaint::tell);
    connect(m_list, &ValueEdit::committed, this, &VariableRow::takeList);
}

void VariableRow::takeList(const QString& typed)
{
    m_variable.values.clear();
    for (const QString& value : typed.split(QChar(';'), Qt::SkipEmptyParts))
        if (const QString one = value.trimmed(); !one.isEmpty())
            m_variable.values.push_back(one.toStdString());
    m_list->show(listOf(m_variable.values));
    emit edited();
}

} // namespace ripstop
