// Rows are made anew whenever there is another one; each changes its own objective in place.
#include "study/goal_form.h"

#include "icons/icon.h"
#include "study/shown_value.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

QComboBox* narrowChoice(const QString& name, const QStringList& texts)
{
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(5);
    box->addItems(texts);
    return box;
}

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

QString limitText(const Constraint& constraint) // "line tension max ≤ 60"
{
    const QString sign =
        constraint.kind == Constraint::Kind::AtMost ? QStringLiteral("≤") : QStringLiteral("≥");
    return QStringLiteral("%1 %2 %3")
        .arg(QString::fromStdString(headingOf(constraint.measure, {})), sign,
             fourDigits(constraint.limit));
}

} // namespace

GoalForm::GoalForm(QWidget* parent)
    : QWidget(parent)
    , m_rows(new QVBoxLayout)
    , m_noTear(new QCheckBox(tr("Nothing may tear")))
    , m_accurate(new QCheckBox(tr("The accuracy is held")))
    , m_limits(new QLabel)
{
    m_rows->setSpacing(2);
    auto* add = new QPushButton(tr("&Want something…"));
    add->setToolTip(tr("Another measure that is wanted small, large or at a value; with two the "
                       "best are a front."));
    connect(add, &QPushButton::clicked, this, [this] {
        Objective objective;
        objective.goal = Goal::Maximise;
        objective.measure.probe =
            m_probes.isEmpty() ? std::string() : m_probes.front().toStdString();
        objective.measure.reduction = Reduction::Mean;
        this->add(objective);
    });
    auto* last = new QHBoxLayout;
    last->addWidget(add);
    last->addStretch();
    auto* outcomes = new QVBoxLayout;
    outcomes->addWidget(m_noTear);
    outcomes->addWidget(m_accurate);
    outcomes->addWidget(m_limits);
    m_limits->setTextFormat(Qt::PlainText);
    m_limits->setWordWrap(true);
    m_limits->setToolTip(tr("Limits of measures, as the file of the study has them."));
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

void GoalForm::show(const Study& study, const QStringList& probes)
{
    m_probes = probes;
    m_objectives = study.objectives;
    m_measured.clear();
    const auto isWanted = [&](WantedOutcome outcome) {
        return std::ranges::any_of(study.constraints, [&](const Constraint& one) {
            return one.kind == Constraint::Kind::Outcome && one.outcome == outcome;
        });
    };
    std::ranges::copy_if(study.constraints, std::back_inserter(m_measured),
                         [](const auto& one) { return one.kind != Constraint::Kind::Outcome; });
    QStringList limits;
    for (const Constraint& one : m_measured)
        limits << limitText(one);
    m_limits->setText(limits.join(QChar('\n')));
    m_limits->setVisible(!limits.isEmpty());
    m_isShowing = true;
    m_noTear->setChecked(isWanted(WantedOutcome::NoTear));
    m_accurate->setChecked(isWanted(WantedOutcome::Accurate));
    m_isShowing = false;
    rebuild();
}

void GoalForm::giveTo(Study& study) const
{
    study.objectives = m_objectives;
    study.constraints = m_measured;
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

void GoalForm::rebuild()
{
    for (QWidget* row : m_made) {
        row->hide();
        row->deleteLater(); // it may be the one that asked for this
    }
    m_made.clear();
    for (std::size_t place = 0; place < m_objectives.size(); ++place)
        addRow(place);
}

void GoalForm::addRow(std::size_t place)
{
    const Objective& shown = m_objectives[place];
    auto* goal = narrowChoice(tr("What is wanted"), goalTexts());
    goal->setCurrentIndex(int(shown.goal));
    auto* number = new QDoubleSpinBox;
    number->setRange(-1e9, 1e9);
    number->setDecimals(4);
    number->setValue(shown.target);
    number->setAccessibleName(tr("The value that is wanted"));
    number->setVisible(shown.goal == Goal::Target);
    QStringList probes = m_probes;
    const QString own = QString::fromStdString(shown.measure.probe);
    if (!probes.contains(own))
        probes.prepend(own);
    auto* probe = narrowChoice(tr("Probe"), probes);
    probe->setCurrentIndex(int(probes.indexOf(own)));
    auto* reduction = narrowChoice(tr("What of its values"), reductionTexts());
    reduction->setCurrentIndex(int(shown.measure.reduction));
    auto* remove = new QToolButton;
    remove->setIcon(icon(QStringLiteral("close")));
    remove->setToolTip(tr("Want this no more"));
    remove->setAccessibleName(remove->toolTip());
    remove->setAutoRaise(true);
    auto* row = new QWidget;
    auto* layout = new QGridLayout(row); // two lines, as the form is narrow
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(4);
    layout->addWidget(goal, 0, 0);
    layout->addWidget(number, 0, 1);
    layout->addWidget(remove, 0, 2);
    layout->addWidget(probe, 1, 0);
    layout->addWidget(reduction, 1, 1, 1, 2);
    for (const int column : {0, 1})
        layout->setColumnStretch(column, 1);
    m_rows->addWidget(row);
    m_made.push_back(row);
    const auto take = [this, place, goal, number, probe, reduction] {
        Objective& objective = m_objectives[place];
        objective.goal = Goal(goal->currentIndex());
        objective.target = number->value();
        objective.measure.probe = probe->currentText().toStdString();
        objective.measure.reduction = Reduction(reduction->currentIndex());
        number->setVisible(objective.goal == Goal::Target);
        emit edited();
    };
    for (QComboBox* box : {goal, probe, reduction})
        connect(box, &QComboBox::activated, this, take);
    connect(number, &QDoubleSpinBox::valueChanged, this, take);
    connect(remove, &QToolButton::clicked, this, [this, place] {
        m_objectives.erase(m_objectives.begin() + std::ptrdiff_t(place));
        rebuild();
        emit edited();
    });
}

} // namespace ripstop
