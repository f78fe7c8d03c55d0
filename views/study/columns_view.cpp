// Columns of variables are made once for a study, as they take longest; those of readings whenever
// there are more flights.
#include "study/columns_view.h"

#include "document/plain_text.h"
#include "study/point_table.h"
#include "study/scatter_matrix.h"
#include "study/study_map.h"

#include <QMenu>
#include <QStackedLayout>
#include <QToolButton>

#include <algorithm>

namespace ripstop {
namespace {

constexpr std::size_t firstReadings = 3; // that are shown at first

} // namespace

ColumnsView::ColumnsView(QWidget* parent)
    : QWidget(parent)
    , m_choice(new QToolButton)
    , m_menu(new QMenu(m_choice))
    , m_pages(new QStackedLayout(this))
    , m_parallel(new ParallelChart)
    , m_scatter(new ScatterMatrix)
    , m_table(new PointTable)
{
    m_choice->setText(tr("Columns"));
    m_choice->setToolTip(tr("Which variables and measures are shown"));
    m_choice->setPopupMode(QToolButton::InstantPopup);
    m_choice->setMenu(m_menu);
    for (QWidget* page : std::initializer_list<QWidget*>{m_parallel, m_scatter, m_table})
        m_pages->addWidget(page);
    connect(m_parallel, &ParallelChart::picked, this, &ColumnsView::picked);
    connect(m_scatter, &ScatterMatrix::picked, this, &ColumnsView::picked);
    connect(m_table, &PointTable::picked, this, &ColumnsView::picked);
}

void ColumnsView::setStudy(const OpenedStudy& study)
{
    m_drawn.clear();
    const std::size_t variables = study.study.variables.size();
    std::vector<QString> titles;
    for (const StudyVariable& variable : study.study.variables)
        titles.push_back(QString::fromStdString(titleOf(study, variable)));
    for (const std::string& reading : readingsOf(study))
        titles.push_back(QString::fromStdString(reading));
    m_isShown.assign(titles.size(), 0);
    for (std::size_t i = 0; i < titles.size(); ++i)
        m_isShown[i] = i < variables + firstReadings;
    for (const std::size_t wanted : study.wanted)
        m_isShown[variables + wanted] = 1;
    m_menu->clear();
    for (std::size_t i = 0; i < titles.size(); ++i) {
        QAction* action = m_menu->addAction(inMenu(titles[i]));
        action->setCheckable(true);
        action->setChecked(m_isShown[i]);
        connect(action, &QAction::toggled, this, [this, i](bool on) {
            m_isShown[i] = on;
            emit columnsChosen();
        });
    }
}

void ColumnsView::show(const OpenedStudy& study, const StudyFlights& flights, Picture picture)
{
    const std::size_t variables = study.study.variables.size();
    if (m_drawn.empty() || m_drawn.front().value.size() != flights.size()) {
        m_drawn.clear();
        for (std::size_t v = 0; v < variables; ++v)
            m_drawn.push_back(variableColumn(study, v));
    }
    std::vector<StudyColumn> columns;
    for (std::size_t i = 0; i < m_isShown.size(); ++i)
        if (m_isShown[i])
            columns.push_back(i < variables ? m_drawn[i]
                                            : readingColumn(study, flights, i - variables));
    const auto shared = std::make_shared<const std::vector<StudyColumn>>(std::move(columns));
    m_pages->setCurrentIndex(int(picture));
    if (picture == Picture::Parallel)
        m_parallel->show(shared, m_selected);
    else if (picture == Picture::Scatter)
        m_scatter->show(shared, m_selected);
    else {
        std::vector<FlightOutcome> outcomes;
        for (const FlightResult* flight : flights)
            outcomes.push_back(outcomeOf(flight));
        m_table->points().show(shared, std::move(outcomes));
        m_table->points().mark(m_selected);
    }
}

void ColumnsView::mark(const std::vector<std::size_t>& selected)
{
    m_selected = selected;
    if (isVisible())
        markShown();
}

void ColumnsView::markShown()
{
    switch (Picture(m_pages->currentIndex())) {
    case Picture::Parallel:
        return m_parallel->mark(m_selected);
    case Picture::Scatter:
        return m_scatter->mark(m_selected);
    case Picture::Table:
        return m_table->points().mark(m_selected);
    }
}

QCustomPlot* ColumnsView::plot()
{
    switch (Picture(m_pages->currentIndex())) {
    case Picture::Parallel:
        return &m_parallel->plot();
    case Picture::Scatter:
        return &m_scatter->plot();
    case Picture::Table:
        return nullptr;
    }
    return nullptr;
}

} // namespace ripstop
