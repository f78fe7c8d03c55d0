// Rows are made anew whenever there is another one; each changes its own objective in place.
#include "study/goal_form.h"

#include "icons/icon.h"
#include "study/narrow_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int letters = 5; // of choices

QStringList goalTexts()
{
    return {GoalForm::tr("Smallest"), GoalForm::tr("Largest"), GoalForm::tr("Nearest to")};
}

QStringList reductionTexts() // in the order of the enumeration
{
    return {GoalForm::tr("at the end"),
            GoalForm::tr("mean"),
            GoalForm::tr("least"),
            GoalForm::tr("largest"),
            GoalForm::tr("root mean square"),
            GoalForm::tr("percentile"),
            GoalForm::tr("slope"),
            GoalForm::tr("time of the least"),
            GoalForm::tr("time of the largest")};
}

QStringList limitTexts() { return {GoalForm::tr("At most"), GoalForm::tr("At least")}; }

} // namespace

GoalForm::GoalForm(QWidget* parent)
    : QWidget(parent)
    , m_rows(new QVBoxLayout)
    , m_noTear(new QCheckBox(tr("Nothing may tear")))
    , m_accurate(new QCheckBox(tr("The accuracy is held")))
{
    m_rows->setSpacing(2);
    auto* add = new QPushButton(tr("&Want something…"));
    add->setToolTip(tr("Another measure that is wanted small, large or at a value; with two the "
                       "best are a front."));
    connect(add, &QPushButton::clicked, this, [this] {
        Objective objective;
        objective.goal = Goal::Maximise;
        objective.measure = firstMeasure();
        objective.measure.reduction = Reduction::Mean;
        this->add(objective);
    });
    auto* limit = new QPushButton(tr("&Limit something…"));
    limit->setToolTip(
        tr("A measure that may be at most or has to be at least some value in a good design."));
    connect(limit, &QPushButton::clicked, this, [this] {
        Constraint constraint{Constraint::Kind::AtMost, firstMeasure(), 0.0, {}};
        constraint.measure.reduction = Reduction::Largest;
        this->add(constraint);
    });
    auto* last = new QHBoxLayout;
    last->addWidget(add);
    last->addWidget(limit);
    last->addStretch();
    auto* outcomes = new QVBoxLayout;
    outcomes->addWidget(m_noTear);
    outcomes->addWidget(m_accurate);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(m_rows);
    layout->addLayout(last);
    layout->addLayout(outcomes);
    for (QCheckBox* box : {m_noTear, m_accurate})
        connect(box, &QCheckBox::toggled, this, [this] {
            if (!m_isShowing)
                emit edited();
        });
}

Measure GoalForm::firstMeasure() const
{
    Measure measure;
    measure.probe = m_probes.isEmpty() ? std::string() : m_probes.front().toStdString();
    return measure;
}

void GoalForm::show(const Study& study, const QStringList& probes)
{
    m_probes = probes;
    m_objectives = study.objectives;
    m_limits.clear();
    const auto isWanted = [&](WantedOutcome outcome) {
        return std::ranges::any_of(study.constraints, [&](const Constraint& one) {
            return one.kind == Constraint::Kind::Outcome && one.outcome == outcome;
        });
    };
    std::ranges::copy_if(study.constraints, std::back_inserter(m_limits),
                         [](const auto& one) { return one.kind != Constraint::Kind::Outcome; });
    m_isShowing = true;
    m_noTear->setChecked(isWanted(WantedOutcome::NoTear));
    m_accurate->setChecked(isWanted(WantedOutcome::Accurate));
    m_isShowing = false;
    rebuild();
}

void GoalForm::giveTo(Study& study) const
{
    study.objectives = m_objectives;
    study.constraints = m_limits;
    const auto demand = [&](const QCheckBox& box, WantedOutcome outcome) {
        if (box.isChecked())
            study.constraints.push_back({Constraint::Kind::Outcome, {}, 0.0, outcome});
    };
    demand(*m_noTear, WantedOutcome::NoTear);
    demand(*m_accurate, WantedOutcome::Accurate);
}

void GoalForm::add(Objective objective)
{
    m_objectives.push_back(std::move(objective));
    rebuild();
    emit edited();
}

void GoalForm::add(Constraint limit)
{
    m_limits.push_back(std::move(limit));
    rebuild();
    emit edited();
}

void GoalForm::rebuild()
{
    for (QWidget* row : m_made) {
        row->hide();
        row->deleteLater(); // it may be the one that asked for this
    }
    m_made.clear();
    for (std::size_t place = 0; place < m_objectives.size(); ++place)
        addObjective(place);
    for (std::size_t place = 0; place < m_limits.size(); ++place)
        addLimit(place);
}

GoalForm::Row GoalForm::makeRow(QComboBox* kind, const QString& numberName, double number,
                                const Measure& measure, const QString& removal)
{
    auto* value = new QDoubleSpinBox;
    value->setRange(-1e9, 1e9);
    value->setDecimals(4);
    value->setValue(number);
    value->setAccessibleName(numberName);
    QStringList probes = m_probes;
    const QString own = QString::fromStdString(measure.probe);
    if (!probes.contains(own))
        probes.prepend(own);
    auto* probe = new NarrowBox(tr("Probe"), probes, letters);
    probe->setCurrentIndex(int(probes.indexOf(own)));
    auto* reduction = new NarrowBox(tr("What of its values"), reductionTexts(), letters);
    reduction->setCurrentIndex(int(measure.reduction));
    auto* remove = new QToolButton;
    remove->setIcon(icon(QStringLiteral("close")));
    remove->setToolTip(removal);
    remove->setAccessibleName(removal);
    remove->setAutoRaise(true);
    auto* row = new QWidget;
    auto* layout = new QGridLayout(row); // two lines, as the form is narrow
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(4);
    layout->addWidget(kind, 0, 0);
    layout->addWidget(value, 0, 1);
    layout->addWidget(remove, 0, 2);
    layout->addWidget(probe, 1, 0);
    layout->addWidget(reduction, 1, 1, 1, 2);
    for (const int column : {0, 1})
        layout->setColumnStretch(column, 1);
    m_rows->addWidget(row);
    m_made.push_back(row);
    return {kind, value, probe, reduction, remove};
}

void GoalForm::connectRow(const Row& row, const std::function<void()>& take,
                          const std::function<void()>& remove)
{
    const auto taken = [this, take] {
        take();
        emit edited();
    };
    for (QComboBox* box : {row.kind, row.probe, row.reduction})
        connect(box, &QComboBox::activated, this, taken);
    connect(row.number, &QDoubleSpinBox::valueChanged, this, taken);
    connect(row.remove, &QToolButton::clicked, this, [this, remove] {
        remove();
        rebuild();
        emit edited();
    });
}

void GoalForm::addObjective(std::size_t place)
{
    const Objective& shown = m_objectives[place];
    auto* goal = new NarrowBox(tr("What is wanted"), goalTexts(), letters);
    goal->setCurrentIndex(int(shown.goal));
    const Row row = makeRow(goal, tr("The value that is wanted"), shown.target, shown.measure,
                            tr("Want this no more"));
    row.number->setVisible(shown.goal == Goal::Target);
    connectRow(
        row,
        [this, place, row] {
            Objective& objective = m_objectives[place];
            objective.goal = Goal(row.kind->currentIndex());
            objective.target = row.number->value();
            objective.measure.probe = row.probe->currentText().toStdString();
            objective.measure.reduction = Reduction(row.reduction->currentIndex());
            row.number->setVisible(objective.goal == Goal::Target);
        },
        [this, place] { m_objectives.erase(m_objectives.begin() + std::ptrdiff_t(place)); });
}

void GoalForm::addLimit(std::size_t place)
{
    const Constraint& shown = m_limits[place];
    auto* kind = new NarrowBox(tr("Which side is limited"), limitTexts(), letters);
    kind->setCurrentIndex(shown.kind == Constraint::Kind::AtMost ? 0 : 1);
    const Row row =
        makeRow(kind, tr("The limit"), shown.limit, shown.measure, tr("Limit this no more"));
    connectRow(
        row,
        [this, place, row] {
            Constraint& limit = m_limits[place];
            limit.kind = row.kind->currentIndex() == 0 ? Constraint::Kind::AtMost
                                                       : Constraint::Kind::AtLeast;
            limit.limit = row.number->value();
            limit.measure.probe = row.probe->currentText().toStdString();
            limit.measure.reduction = Reduction(row.reduction->currentIndex());
        },
        [this, place] { m_limits.erase(m_limits.begin() + std::ptrdiff_t(place)); });
}

} // namespace ripstop
