// setStudy() shows a study; what a person changes goes through change(), which stays silent while
// values are shown. Rows of variables are made anew whenever there is another one.
#include "study/study_form.h"

#include "document/words.h"
#include "icons/complaint.h"
#include "inspector/value_edit.h"
#include "scene/typed_number.h"
#include "study/goal_form.h"
#include "study/narrow_box.h"
#include "study/polish.h"
#include "study/variable_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

using PlanKind = StudyPlan::Kind;

constexpr int usualCount = 64; // points of a plan that draws them

QString judgeSeconds(const QString& typed)
{
    const Typed read = typedValue(typed.toStdString(), "s");
    if (!read.number)
        return StudyForm::tr("The time %1.").arg(translated(read.complaint));
    return read.number->number > 0.0 ? QString() : StudyForm::tr("A flight lasts longer than 0 s.");
}

} // namespace

StudyForm::StudyForm(QWidget* parent)
    : QWidget(parent)
    , m_variables(new QVBoxLayout)
    , m_hint(new QLabel)
    , m_plan(new QComboBox)
    , m_draw(new QHBoxLayout)
    , m_count(new QSpinBox)
    , m_seed(new QSpinBox)
    , m_seedLabel(new QLabel(tr("with seed")))
    , m_search(new QHBoxLayout)
    , m_last(new QHBoxLayout)
    , m_population(new QSpinBox)
    , m_generations(new QSpinBox)
    , m_polish(new QSpinBox)
    , m_goals(new GoalForm)
    , m_seconds(new ValueEdit(judgeSeconds))
    , m_untilTear(new QCheckBox(tr("or until something tears")))
    , m_keep(new NarrowBox(tr("Which flights are kept with all of their frames"),
                           {tr("None is kept"), tr("Of those that tore or ended early"),
                            tr("Of the best"), tr("All are kept")},
                           12))
    , m_keepCount(new QSpinBox)
{
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_variables->setSpacing(0);
    m_plan->addItem(tr("Every combination"), int(PlanKind::Grid));
    m_plan->addItem(tr("Along the tear line"), int(PlanKind::Frontier));
    m_plan->addItem(tr("One at a time"), int(PlanKind::OneAtATime));
    m_plan->addItem(tr("Sobol' sequence"), int(PlanKind::Sobol));
    m_plan->addItem(tr("Latin hypercube"), int(PlanKind::LatinHypercube));
    m_plan->addItem(tr("At random"), int(PlanKind::MonteCarlo));
    m_plan->addItem(tr("Towards the best"), int(PlanKind::Optimise));
    m_plan->addItem(tr("Which variable matters"), int(PlanKind::Sensitivity));
    m_plan->setAccessibleName(tr("Points"));
    m_plan->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_plan->setMinimumContentsLength(12);
    m_count->setRange(1, 1'000'000);
    m_count->setAccessibleName(tr("Number of points"));
    m_seed->setRange(0, std::numeric_limits<int>::max());
    m_seed->setAccessibleName(tr("Seed"));
    for (QSpinBox* box : {m_count, m_seed}) { // the form is narrow
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(50); // the largest number of all need not fit
    }
    m_seed->setToolTip(tr("Another seed draws other points."));
    m_seconds->setUnit(QStringLiteral("s"));
    m_seconds->setAccessibleName(tr("Each flight"));
    m_seconds->setMaximumWidth(90);

    m_draw->setSpacing(4);
    m_draw->addWidget(m_count, 1);
    m_draw->addWidget(m_seedLabel);
    m_draw->addWidget(m_seed, 1);
    for (QHBoxLayout* line : {m_search, m_last})
        line->setSpacing(4);
    addSearch(*m_search, *m_population, tr("Generations of"), 2,
              tr("Flights of a generation, at once"));
    addSearch(*m_search, *m_generations, QStringLiteral("×"), 1, tr("Generations"));
    addSearch(*m_last, *m_polish, tr("then from the best"), 0,
              tr("Flights of the last stage, one after the other, from the best so far"));
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("Points"), m_plan);
    form->addRow(QString(), m_draw);
    form->addRow(QString(), m_search);
    form->addRow(QString(), m_last);
    form->addRow(tr("Each flight"), m_seconds);
    auto* complaint = new Complaint; // of the time
    form->addRow(complaint);
    form->addRow(QString(), m_untilTear);
    m_keepCount->hide();
    m_keepCount->setRange(1, mostKept);
    m_keepCount->setAccessibleName(tr("How many of the best are kept"));
    m_keepCount->setToolTip(tr("Those that fulfil all limits and come nearest to what is wanted; "
                               "a flight that is overtaken loses its recording."));
    auto* kept = new QHBoxLayout;
    kept->setSpacing(4);
    kept->addWidget(m_keep, 1);
    kept->addWidget(m_keepCount);
    form->addRow(tr("Recordings"), kept);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 4);
    layout->setSpacing(4);
    layout->addLayout(m_variables);
    layout->addWidget(m_hint);
    layout->addLayout(form);
    layout->addWidget(m_goals);

    connect(m_goals, &GoalForm::edited, this, &StudyForm::takePlan);
    connect(m_plan, &QComboBox::activated, this, &StudyForm::takePlan);
    connect(m_count, &QSpinBox::valueChanged, this, &StudyForm::takePlan);
    connect(m_seed, &QSpinBox::valueChanged, this, &StudyForm::takePlan);
    connect(m_seconds, &ValueEdit::committed, this, [this](const QString& typed) {
        change([&] { m_study.seconds = typedValue(typed.toStdString(), "s").number->number; });
        m_seconds->show(compactNumber(m_study.seconds));
    });
    connect(m_seconds, &ValueEdit::complained, complaint, &Complaint::tell);
    connect(m_keep, &QComboBox::activated, this,
            [this](int keep) { change([&] { m_study.keep = KeptRuns(keep); }); });
    connect(m_keep, &QComboBox::currentIndexChanged, m_keepCount,
            [this](int keep) { m_keepCount->setVisible(KeptRuns(keep) == KeptRuns::Best); });
    connect(m_keepCount, &QSpinBox::valueChanged, this,
            [this](int count) { change([&] { m_study.keepCount = count; }); });
    connect(m_untilTear, &QCheckBox::toggled, this,
            [this](bool on) { change([&] { m_study.untilTear = on; }); });
}

void StudyForm::addSearch(QHBoxLayout& line, QSpinBox& box, const QString& words, int least,
                          const QString& tip)
{
    box.setRange(least, 10'000);
    box.setButtonSymbols(QAbstractSpinBox::NoButtons);
    box.setAccessibleName(tip);
    box.setToolTip(tip);
    auto* label = new QLabel(words);
    m_searchLabels.push_back(label);
    line.addWidget(label);
    line.addWidget(&box, 1);
    connect(&box, &QSpinBox::valueChanged, this, &StudyForm::takePlan);
}

void StudyForm::change(const std::function<void()>& what)
{
    if (m_isShowing)
        return;
    what();
    emit edited();
}

void StudyForm::setStudy(Study study, UnitOf unitOf, const QStringList& probes)
{
    m_study = std::move(study);
    m_unitOf = std::move(unitOf);
    m_isShowing = true;
    m_seconds->show(compactNumber(m_study.seconds));
    m_untilTear->setChecked(m_study.untilTear);
    m_keep->setCurrentIndex(int(m_study.keep));
    m_keepCount->setValue(m_study.keepCount);
    m_goals->show(m_study, probes);
    showPlan();
    m_isShowing = false;
    rebuild();
}

void StudyForm::showPlan()
{
    const StudyPlan& plan = m_study.plan;
    const int file = m_plan->findData(int(PlanKind::Points)); // there for studies that have it
    if (plan.kind == PlanKind::Points && file < 0)
        m_plan->addItem(tr("Rows of a file"), int(PlanKind::Points));
    else if (plan.kind != PlanKind::Points && file >= 0)
        m_plan->removeItem(file);
    m_plan->setCurrentIndex(m_plan->findData(int(plan.kind)));
    m_count->setValue(plan.count > 0 ? int(std::min<std::int64_t>(plan.count, m_count->maximum()))
                                     : usualCount);
    m_seed->setValue(int(std::min<std::uint64_t>(plan.seed, std::uint64_t(m_seed->maximum()))));
    const bool isOptimised = plan.kind == PlanKind::Optimise;
    m_population->setValue(int(plan.population));
    m_generations->setValue(int(plan.generations));
    m_polish->setValue(int(plan.polish));
    m_count->setVisible(plan.draws());
    for (VariableRow* row : m_rows)
        row->showCount(plan.goesThroughValues());
    for (QWidget* one : std::initializer_list<QWidget*>{m_seed, m_seedLabel})
        one->setVisible(plan.draws() || isOptimised);
    for (QWidget* one : m_searchLabels)
        one->setVisible(isOptimised);
    for (QWidget* one : {m_population, m_generations, m_polish})
        one->setVisible(isOptimised);
    // a swarm polishes, a front has no single best place to begin from
    m_polish->setEnabled(Polish::isThere() && m_study.objectives.size() < 2);
}

void StudyForm::takePlan()
{
    change([this] {
        StudyPlan& plan = m_study.plan;
        plan.kind = PlanKind(m_plan->currentData().toInt());
        plan.count = plan.draws() ? m_count->value() : 0;
        plan.seed = std::uint64_t(m_seed->value());
        m_goals->giveTo(m_study);
        const bool hasFront = m_study.objectives.size() > 1;
        plan.population = m_population->value();
        plan.generations = m_generations->value();
        plan.polish = hasFront ? 0 : m_polish->value();
        plan.method = hasFront ? StudyPlan::Method::Nsga2 : StudyPlan::Method::ParticleSwarm;
        m_isShowing = true;
        showPlan();
        m_isShowing = false;
    });
}

void StudyForm::add(StudyVariable variable)
{
    const auto same = std::ranges::find(m_study.variables, variable.paths, &StudyVariable::paths);
    if (same != m_study.variables.end())
        *same = std::move(variable);
    else
        m_study.variables.push_back(std::move(variable));
    rebuild();
    emit edited();
}

// Rows are made anew: there are few.
void StudyForm::rebuild()
{
    for (VariableRow* row : m_rows) {
        row->hide();
        row->deleteLater(); // it may be the one that asked for this
    }
    m_rows.clear();
    for (const StudyVariable& variable : m_study.variables) {
        auto* row = new VariableRow(variable, m_unitOf(variable));
        const std::size_t place = m_rows.size();
        connect(row, &VariableRow::edited, this, [this, row, place] {
            change([&] { m_study.variables[place] = row->variable(); });
        });
        connect(row, &VariableRow::removed, this, [this, place] {
            m_study.variables.erase(m_study.variables.begin() + std::ptrdiff_t(place));
            rebuild();
            emit edited();
        });
        m_variables->addWidget(row);
        row->showCount(m_study.plan.goesThroughValues());
        m_rows.push_back(row);
    }
    m_hint->setText(m_rows.empty()
                        ? tr("Right-click the name of a property, in the inspector or beside a "
                             "slider, and choose Study this.")
                        : tr("Study this on another property adds it."));
    m_hint->setVisible(m_rows.size() < 2);
}

} // namespace ripstop
