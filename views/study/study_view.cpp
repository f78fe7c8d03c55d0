// Stages: the lines above and below the chart; the choices that a study has; then refresh(), which
// draws what is chosen, and describe(), which puts a flight into words.
#include "study/study_view.h"

#include "document/spoken.h"
#include "document/words.h"
#include "icons/icon.h"
#include "study/columns_view.h"
#include "study/design_gallery.h"
#include "study/flight_curves.h"
#include "study/goal_chart.h"
#include "study/narrow_box.h"
#include "study/percentile_chart.h"
#include "study/shown_value.h"
#include "study/study_chart.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int whichRole = Qt::UserRole + 1; // of a page that has several pictures

QString outcomeText(const FlightResult& flight)
{
    if (flight.endedEarly())
        return StudyView::tr("Ended early at %1: %2")
            .arg(spokenText(flight.time, "s"), translated(flight.whyEarly()));
    if (flight.torn > 0)
        return StudyView::tr("Tore at %1, at a load of %2.")
            .arg(spokenText(flight.firstTear, "s"),
                 spokenText(flight.firstTearLoad, flight.firstTearUnit));
    return StudyView::tr("Held.");
}

} // namespace

StudyView::StudyView(QWidget* parent)
    : QWidget(parent)
    , m_picture(new NarrowBox(tr("Picture"), {}, 3))
    , m_reading(new NarrowBox(tr("What is shown")))
    , m_x(new NarrowBox(tr("Variable to the right"), {}, 2))
    , m_over(new QLabel(tr("over")))
    , m_y(new NarrowBox(tr("Variable upwards"), {}, 2))
    , m_slices(new QHBoxLayout)
    , m_charts(new QStackedWidget)
    , m_chart(new StudyChart)
    , m_goals(new GoalChart)
    , m_designs(new DesignGallery)
    , m_bands(new PercentileChart)
    , m_columns(new ColumnsView)
    , m_sides(new QSplitter)
    , m_curves(new FlightCurves)
    , m_told(new QLabel)
    , m_watch(new QPushButton(tr("&Watch")))
    , m_compare(new QPushButton)
    , m_apply(new QPushButton(tr("&Apply")))
    , m_save(new QToolButton)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    m_axes = axesLine();
    layout->addWidget(m_axes);
    layout->addLayout(m_slices);
    for (QWidget* page :
         std::initializer_list<QWidget*>{m_chart, m_bands, m_columns, m_goals, m_designs})
        m_charts->addWidget(page); // in the order of Page
    m_charts->addWidget(emptyPage());
    m_sides->setChildrenCollapsible(false);
    m_sides->addWidget(m_charts);
    m_sides->addWidget(m_curves);
    m_sides->setStretchFactor(0, 1);
    m_sides->setStretchFactor(1, 1);
    m_curves->hide();
    layout->addWidget(m_sides, 1);
    layout->addWidget(flightLine());
    connect(m_chart, &StudyChart::picked, this, &StudyView::pick);
    connect(m_bands, &PercentileChart::picked, this, &StudyView::pick);
    connect(m_columns, &ColumnsView::picked, this, &StudyView::pick);
    connect(m_columns, &ColumnsView::columnsChosen, this, &StudyView::refresh);
    connect(m_goals, &GoalChart::chosen, this, &StudyView::choose);
    connect(m_designs, &DesignGallery::chosen, this, &StudyView::choose);
    connect(m_curves, &FlightCurves::chosen, this, &StudyView::chooseOfSelected);
    connect(m_curves, &FlightCurves::ghostsWanted, this, &StudyView::ghostsWanted);
    connect(m_curves, &FlightCurves::closed, this, [this] {
        showCurves({});
        emit ghostsWanted();
    });
    connect(m_picture, &QComboBox::activated, this, [this] {
        showBoxes();
        refresh();
    });
    connect(m_chart, &StudyChart::pointedAt, this, &StudyView::describe);
    connect(m_watch, &QPushButton::clicked, this, [this] { emit watchWanted(*m_chosen); });
    connect(m_compare, &QPushButton::clicked, this, [this] { emit compareWanted(m_selected); });
    connect(m_apply, &QPushButton::clicked, this, [this] { emit applyWanted(*m_chosen); });
    for (QComboBox* box : {m_reading, m_x, m_y})
        connect(box, &QComboBox::activated, this, [this, box] {
            if (box != m_reading)
                fillSlices();
            refresh();
        });
    showBoxes();
    choose(std::nullopt);
}

// Before anything is flown.
QWidget* StudyView::emptyPage()
{
    auto* text = new QLabel(tr("Fly shows here what comes of it, a cell for each flight.\n\nThen a "
                               "click on one opens that flight or takes its values."));
    text->setAlignment(Qt::AlignCenter);
    text->setWordWrap(true);
    text->setForegroundRole(QPalette::PlaceholderText);
    text->setMargin(16);
    return text;
}

QWidget* StudyView::axesLine()
{
    m_save->setIcon(icon(QStringLiteral("save")));
    m_save->setToolTip(tr("Save the table or the picture"));
    m_save->setAccessibleName(m_save->toolTip());
    m_save->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_save);
    menu->addAction(tr("&Table (CSV)…"), this, &StudyView::tableWanted);
    auto* picture =
        menu->addAction(tr("&Picture (SVG, PDF, PNG)…"), this, &StudyView::savePictureAs);
    auto* curves =
        menu->addAction(tr("&Curves (SVG, PDF, PNG, CSV)…"), this, &StudyView::saveCurvesAs);
    connect(menu, &QMenu::aboutToShow, this, [this, picture, curves] {
        picture->setEnabled(shownPlot() != nullptr);
        curves->setEnabled(m_curves->isVisible());
    });
    m_save->setMenu(menu);
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_picture, 1);
    layout->addWidget(m_reading, 2);
    layout->addWidget(m_over);
    layout->addWidget(m_x, 1);
    layout->addWidget(m_y, 1);
    layout->addWidget(&m_columns->choice());
    layout->addWidget(m_save);
    return line;
}

QWidget* StudyView::flightLine()
{
    m_told->setTextFormat(Qt::PlainText);
    m_told->setWordWrap(true);
    m_told->setMinimumHeight(2 * m_told->fontMetrics().lineSpacing());
    m_told->setObjectName(QStringLiteral("told"));
    m_watch->setToolTip(tr("Fly it again with all of its frames, to the moment when it tears or to "
                           "its end, and compare its hash with that of the study."));
    m_apply->setToolTip(tr("Give the open design the values of this flight, as one step."));
    m_compare->setToolTip(
        tr("Fly the selected flights again in the background, and show the curves of a probe over "
           "each other and the flights as ghosts in the view. Ctrl or Shift and click, or a rubber "
           "band, selects several."));
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton* button : {m_watch, m_compare, m_apply})
        buttons->addWidget(button);
    auto* line = new QWidget; // beside each other, the words would be as narrow as a column
    auto* layout = new QVBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_told);
    layout->addLayout(buttons);
    return line;
}

QString StudyView::valuesOf(const OpenedStudy& study, std::size_t point)
{
    const std::vector<std::string> values = study.points.values(point);
    QStringList all;
    for (std::size_t v = 0; v < values.size(); ++v)
        all << valueOfVariable(study, v, values[v]);
    return all.join(QStringLiteral(", "));
}

void StudyView::setStudy(const OpenedStudy* study, const StudyFlights* flights)
{
    m_study = study;
    m_flights = flights;
    m_selected.clear();
    m_chosen = std::nullopt;
    m_designs->clear();
    showCurves({});
    if (study) {
        m_columns->setStudy(*study);
        fillChoices();
        fillSlices();
    }
    showBoxes();
    refresh();
    choose(std::nullopt);
}

// What was chosen before stays where a study of the same name still has it.
void StudyView::fillChoices()
{
    const auto fill = [](QComboBox& box, const QStringList& texts, int usual) {
        const QString before = box.currentText();
        box.clear();
        box.addItems(texts);
        const int again = box.findText(before);
        box.setCurrentIndex(again >= 0 ? again : std::min(usual, box.count() - 1));
    };
    QStringList readings;
    for (const std::string& one : readingsOf(*m_study))
        readings << QString::fromStdString(one);
    const int torn = int(readings.size()) - 1; // how many tore says most where nothing is measured
    fill(*m_reading, readings, m_study->headings.empty() ? torn : 0);
    QStringList variables;
    for (const StudyVariable& variable : m_study->study.variables)
        variables << QString::fromStdString(variable.name);
    QStringList before;
    for (int i = 0; i + 1 < m_y->count(); ++i) // all but the last, which is none
        before << m_y->itemText(i);
    if (variables != before) {
        m_x->clear();
        m_y->clear();
    }
    fill(*m_x, variables, 0);
    variables << tr("(none)");
    fill(*m_y, variables, variables.size() > 2 ? 1 : int(variables.size()) - 1);
    fillPictures();
}

// The map first, and what is looked for.
void StudyView::fillPictures()
{
    const QString before = m_picture->currentText();
    const int count = m_picture->count();
    m_picture->clear();
    const auto add = [this](const QString& words, Page page, int which = 0) {
        m_picture->addItem(words, int(page));
        m_picture->setItemData(m_picture->count() - 1, which, whichRole);
    };
    add(tr("Map"), Page::Map);
    for (const GoalChart::Picture picture : GoalChart::picturesOf(*m_study)) {
        const QString texts[]{tr("Best so far"), tr("Front"), tr("What matters")};
        add(texts[std::size_t(picture)], Page::Goals, int(picture));
    }
    if (!m_study->wanted.empty())
        add(tr("Best designs"), Page::Designs);
    add(tr("Percentiles"), Page::Percentiles);
    add(tr("Parallel axes"), Page::Columns, int(ColumnsView::Picture::Parallel));
    add(tr("Scatter matrix"), Page::Columns, int(ColumnsView::Picture::Scatter));
    add(tr("Table"), Page::Columns, int(ColumnsView::Picture::Table));
    // a study with other pictures begins with what it looks for
    const bool hasSame = m_picture->count() == count && m_picture->findText(before) >= 0;
    const StudyPlan::Kind kind = m_study->study.plan.kind;
    const bool looks =
        !GoalChart::picturesOf(*m_study).empty()
        && (kind == StudyPlan::Kind::Optimise || kind == StudyPlan::Kind::Sensitivity);
    m_picture->setCurrentIndex(hasSame ? m_picture->findText(before) : looks ? 1 : 0);
    showBoxes();
}

StudyView::Page StudyView::page() const
{
    return Page(std::max(0, m_picture->currentData().toInt()));
}

bool StudyView::isEmpty() const
{
    return !m_study || std::ranges::all_of(*m_flights, [](const auto* flight) { return !flight; });
}

// Only the choices that the picture asks for.
void StudyView::showBoxes()
{
    m_axes->setVisible(!isEmpty());
    if (isEmpty())
        return m_charts->setCurrentIndex(m_charts->count() - 1);
    const Page shown = page();
    const bool hasReading = shown == Page::Map || shown == Page::Percentiles
                            || (shown == Page::Goals
                                && GoalChart::Picture(m_picture->currentData(whichRole).toInt())
                                       == GoalChart::Picture::Sensitivity);
    const bool hasMany = m_study->study.variables.size() > 1;
    m_reading->setVisible(hasReading);
    for (QWidget* one : std::initializer_list<QWidget*>{m_x, m_over})
        one->setVisible(hasMany && (shown == Page::Map || shown == Page::Percentiles));
    m_y->setVisible(hasMany && shown == Page::Map);
    m_columns->choice().setVisible(shown == Page::Columns);
    for (QComboBox* box : m_sliceBoxes)
        if (box)
            box->parentWidget()->setVisible(shown == Page::Map);
    m_charts->setCurrentIndex(int(shown));
}

// A box for each further variable of a grid.
void StudyView::fillSlices()
{
    for (QComboBox* box : m_sliceBoxes)
        if (box)
            box->parentWidget()->deleteLater();
    m_sliceBoxes.assign(m_study->study.variables.size(), nullptr);
    if (!m_study->study.plan.isGrid())
        return;
    for (std::size_t v = 0; v < m_sliceBoxes.size(); ++v) {
        if (int(v) == m_x->currentIndex() || int(v) == m_y->currentIndex())
            continue;
        const StudyVariable& variable = m_study->study.variables[v];
        auto* box = new NarrowBox(tr("The value at which the map is cut"));
        for (const std::string& value : variable.values)
            box->addItem(QString::fromStdString(value));
        auto* pair = new QWidget;
        auto* layout = new QHBoxLayout(pair);
        layout->setContentsMargins(0, 0, 0, 0);
        auto* at = new QLabel(tr("at %1").arg(QString::fromStdString(variable.name)));
        at->setTextFormat(Qt::PlainText);
        layout->addWidget(at);
        layout->addWidget(box);
        layout->addStretch();
        m_slices->addWidget(pair);
        m_sliceBoxes[v] = box;
        connect(box, &QComboBox::activated, this, &StudyView::refresh);
    }
}

void StudyView::refresh()
{
    if (!m_study) {
        m_chart->show({}, {});
        return;
    }
    if (isEmpty() == m_axes->isVisibleTo(this)) // the first flight has come
        showBoxes();
    const auto reading = std::size_t(std::max(0, m_reading->currentIndex()));
    const auto x = std::size_t(std::max(0, m_x->currentIndex()));
    const int which = m_picture->currentData(whichRole).toInt();
    switch (page()) {
    case Page::Map:
        refreshMap(reading);
        break;
    case Page::Percentiles:
        m_bands->show(variableColumn(*m_study, x), readingColumn(*m_study, *m_flights, reading),
                      *m_flights);
        break;
    case Page::Columns:
        m_columns->show(*m_study, *m_flights, ColumnsView::Picture(which));
        break;
    case Page::Goals:
        m_goals->show(*m_study, *m_flights, GoalChart::Picture(which), reading);
        break;
    case Page::Designs:
        m_designs->show(*m_study, *m_flights);
        m_designs->mark(m_chosen);
        break;
    }
    describe(-1);
}

void StudyView::refreshMap(std::size_t reading)
{
    MapChoice choice;
    choice.x = std::size_t(std::max(0, m_x->currentIndex()));
    const auto y = std::size_t(std::max(0, m_y->currentIndex()));
    if (y < m_study->study.variables.size() && y != choice.x)
        choice.y = y;
    choice.reading = reading;
    for (const QComboBox* box : m_sliceBoxes)
        choice.slice.push_back(box ? std::size_t(box->currentIndex()) : 0);
    m_chart->show(mapOf(*m_study, *m_flights, choice), m_reading->currentText());
}

void StudyView::choose(std::optional<std::size_t> point)
{
    select(point ? std::vector{*point} : std::vector<std::size_t>());
}

void StudyView::pick(const std::vector<std::size_t>& points, Picking how)
{
    select(pickedOf(m_selected, points, how));
    if (how == Picking::Replace && points.size() > 1) // none of them more than another
        chooseOfSelected(std::nullopt);
}

// The last of them is the chosen one.
void StudyView::select(std::vector<std::size_t> points)
{
    m_selected = std::move(points);
    m_columns->mark(m_selected);
    chooseOfSelected(m_selected.empty() ? std::nullopt : std::optional(m_selected.back()));
}

void StudyView::chooseOfSelected(std::optional<std::size_t> point)
{
    m_chosen = point;
    m_chart->mark(m_selected, m_chosen);
    m_curves->mark(m_chosen);
    m_designs->mark(m_chosen);
    for (QPushButton* button : {m_watch, m_apply})
        button->setEnabled(point.has_value());
    const std::size_t several = std::min(m_selected.size(), mostCompared);
    m_compare->setEnabled(several > 1);
    m_compare->setText(several > 1 ? tr("&Compare %1").arg(several) : tr("&Compare"));
    describe(-1);
}

void StudyView::showCurves(std::vector<FlightCurve> curves)
{
    m_curves->setVisible(!curves.empty());
    m_curves->show(std::move(curves));
    m_curves->mark(m_chosen);
}

// Of the flight below the pointer, or of the chosen one.
void StudyView::describe(qlonglong point)
{
    if (!m_study)
        return m_told->clear();
    if (point < 0 && m_chosen)
        point = qlonglong(*m_chosen);
    if (point < 0 && !m_selected.empty())
        return m_told->setText(tr("%1 flights are selected.").arg(m_selected.size()));
    if (point < 0)
        return m_told->setText(tr("Click a flight to watch it or to take its values."));
    QString text;
    if (const FlightResult* flight = (*m_flights)[std::size_t(point)]) {
        const auto reading = std::size_t(std::max(0, m_reading->currentIndex()));
        const double value = readingOf(*flight, reading);
        const std::size_t measures = m_study->headings.size(); // first tear and load come after
        const bool isOfTear =
            reading >= measures && reading < measures + std::size_t(TearReading::Torn);
        if (std::isfinite(value) && !isOfTear) // which the outcome says
            text += tr("%1 is %2. ")
                        .arg(wordsOfHeading(m_reading->currentText()).name,
                             measuredText(m_reading->currentText(), value));
        text += outcomeText(*flight);
        if (!flight->inaccurate.empty())
            text += ' ' + translated(flight->inaccurate);
    } else {
        text += tr("not flown yet.");
    }
    m_told->setText(labelled(valuesOf(*m_study, std::size_t(point)), text));
}

} // namespace ripstop
