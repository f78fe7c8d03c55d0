// Stages: the lines above and below the chart; the choices that a study has; then refresh(), which
// draws what is chosen, and describe(), which puts a flight into words.
#include "study/study_view.h"

#include "document/words.h"
#include "icons/icon.h"
#include "plots/chart_picture.h"
#include "study/goal_chart.h"
#include "study/shown_value.h"
#include "study/study_chart.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace ripstop {
namespace {

QComboBox* narrowBox(const QString& name)
{
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(4);
    return box;
}

QString outcomeText(const FlightResult& flight)
{
    if (flight.endedEarly())
        return StudyView::tr("Ended early at %1 s: %2")
            .arg(fourDigits(flight.time), translated(flight.whyEarly()));
    if (flight.torn > 0)
        return StudyView::tr("Tore at %1 s, at a load of %2.")
            .arg(fourDigits(flight.firstTear), fourDigits(flight.firstTearLoad));
    return StudyView::tr("Held.");
}

} // namespace

StudyView::StudyView(QWidget* parent)
    : QWidget(parent)
    , m_picture(narrowBox(tr("Picture")))
    , m_reading(narrowBox(tr("What is shown")))
    , m_x(narrowBox(tr("Variable to the right")))
    , m_over(new QLabel(tr("over")))
    , m_y(narrowBox(tr("Variable upwards")))
    , m_slices(new QHBoxLayout)
    , m_charts(new QStackedWidget)
    , m_chart(new StudyChart)
    , m_goals(new GoalChart)
    , m_told(new QLabel)
    , m_watch(new QPushButton(tr("&Watch")))
    , m_apply(new QPushButton(tr("&Apply")))
    , m_save(new QToolButton)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(axesLine());
    layout->addLayout(m_slices);
    m_charts->addWidget(m_chart);
    m_charts->addWidget(m_goals);
    layout->addWidget(m_charts, 1);
    layout->addWidget(flightLine());
    connect(m_chart, &StudyChart::chosen, this, &StudyView::choose);
    connect(m_goals, &GoalChart::chosen, this, &StudyView::choose);
    connect(m_picture, &QComboBox::activated, this, [this] {
        showBoxes();
        refresh();
    });
    connect(m_chart, &StudyChart::pointedAt, this, &StudyView::describe);
    connect(m_watch, &QPushButton::clicked, this, [this] { emit watchWanted(*m_chosen); });
    connect(m_apply, &QPushButton::clicked, this, [this] { emit applyWanted(*m_chosen); });
    for (QComboBox* box : {m_reading, m_x, m_y})
        connect(box, &QComboBox::activated, this, [this, box] {
            if (box != m_reading)
                fillSlices();
            refresh();
        });
    choose(std::nullopt);
}

QWidget* StudyView::axesLine()
{
    m_save->setIcon(icon(QStringLiteral("save")));
    m_save->setToolTip(tr("Save the table or the picture"));
    m_save->setAccessibleName(m_save->toolTip());
    m_save->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_save);
    menu->addAction(tr("&Table (CSV)…"), this, &StudyView::tableWanted);
    menu->addAction(tr("&Picture (SVG, PDF, PNG)…"), this, &StudyView::savePictureAs);
    m_save->setMenu(menu);
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_picture, 1);
    layout->addWidget(m_reading, 2);
    layout->addWidget(m_over);
    layout->addWidget(m_x, 1);
    layout->addWidget(m_y, 1);
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
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_told, 1);
    layout->addWidget(m_watch);
    layout->addWidget(m_apply);
    return line;
}

QString StudyView::valuesOf(const OpenedStudy& study, std::size_t point)
{
    const std::vector<std::string> values = study.points.values(point);
    QStringList all;
    for (std::size_t v = 0; v < values.size(); ++v) {
        all << QStringLiteral("%1 %2").arg(QString::fromStdString(study.study.variables[v].name),
                                           shownValue(values[v]));
    }
    return all.join(QStringLiteral(", "));
}

void StudyView::setStudy(const OpenedStudy* study, const StudyFlights* flights)
{
    m_study = study;
    m_flights = flights;
    m_chosen = std::nullopt;
    if (study) {
        fillChoices();
        fillSlices();
    }
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
    m_picture->addItem(tr("Map"), -1);
    for (const GoalChart::Picture picture : GoalChart::picturesOf(*m_study)) {
        const QString texts[]{tr("Best so far"), tr("Front"), tr("What matters")};
        m_picture->addItem(texts[std::size_t(picture)], int(picture));
    }
    // a study with other pictures begins with what it looks for
    const bool hasSame = m_picture->count() == count && m_picture->findText(before) >= 0;
    const StudyPlan::Kind kind = m_study->study.plan.kind;
    const bool looks = kind == StudyPlan::Kind::Optimise || kind == StudyPlan::Kind::Sensitivity;
    m_picture->setCurrentIndex(hasSame ? m_picture->findText(before)
                                       : std::min(looks ? 1 : 0, m_picture->count() - 1));
    showBoxes();
}

// Only the choices that the picture asks for.
void StudyView::showBoxes()
{
    const bool isMap = m_picture->currentData().toInt() < 0;
    const bool hasAxes = isMap && m_study && m_study->study.variables.size() > 1;
    m_picture->setVisible(m_picture->count() > 1);
    m_reading->setVisible(
        isMap || m_picture->currentData().toInt() == int(GoalChart::Picture::Sensitivity));
    for (QWidget* one : std::initializer_list<QWidget*>{m_x, m_y, m_over})
        one->setVisible(hasAxes);
    for (QComboBox* box : m_sliceBoxes)
        if (box)
            box->parentWidget()->setVisible(isMap);
    m_charts->setCurrentIndex(isMap ? 0 : 1);
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
        auto* box = narrowBox(tr("The value at which the map is cut"));
        for (const std::string& value : variable.values)
            box->addItem(QString::fromStdString(value));
        auto* pair = new QWidget;
        auto* layout = new QHBoxLayout(pair);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(new QLabel(tr("at %1").arg(QString::fromStdString(variable.name))));
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
    const auto reading = std::size_t(std::max(0, m_reading->currentIndex()));
    if (m_charts->currentWidget() == m_goals) {
        m_goals->show(*m_study, *m_flights, GoalChart::Picture(m_picture->currentData().toInt()),
                      reading);
        return describe(-1);
    }
    MapChoice choice;
    choice.x = std::size_t(std::max(0, m_x->currentIndex()));
    const auto y = std::size_t(std::max(0, m_y->currentIndex()));
    if (y < m_study->study.variables.size() && y != choice.x)
        choice.y = y;
    choice.reading = reading;
    for (const QComboBox* box : m_sliceBoxes)
        choice.slice.push_back(box ? std::size_t(box->currentIndex()) : 0);
    m_chart->show(mapOf(*m_study, *m_flights, choice), m_reading->currentText());
    describe(-1);
}

void StudyView::choose(std::optional<std::size_t> point)
{
    m_chosen = point;
    m_chart->mark(point);
    for (QPushButton* button : {m_watch, m_apply})
        button->setEnabled(point.has_value());
    describe(-1);
}

// Of the flight below the pointer, or of the chosen one.
void StudyView::describe(qlonglong point)
{
    if (!m_study)
        return m_told->clear();
    if (point < 0 && m_chosen)
        point = qlonglong(*m_chosen);
    if (point < 0)
        return m_told->setText(tr("Click a flight to watch it or to take its values."));
    QString text = valuesOf(*m_study, std::size_t(point)) + QStringLiteral(": ");
    if (const FlightResult* flight = (*m_flights)[std::size_t(point)]) {
        const double value =
            readingOf(*flight, std::size_t(std::max(0, m_reading->currentIndex())));
        if (std::isfinite(value))
            text += tr("%1 is %2. ")
                        .arg(wordsOfHeading(m_reading->currentText()).name,
                             measuredText(m_reading->currentText(), value));
        text += outcomeText(*flight);
        if (!flight->inaccurate.empty())
            text += ' ' + translated(flight->inaccurate);
    } else {
        text += tr("not flown yet.");
    }
    m_told->setText(text);
}

void StudyView::savePictureAs()
{
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save the picture"), QStringLiteral("study.svg"),
                                     tr("Pictures (*.svg *.pdf *.png)"));
    if (file.isEmpty())
        return;
    const bool isMap = m_charts->currentWidget() == m_chart;
    if (savePicture(isMap ? m_chart->plot() : m_goals->plot(), file))
        emit said(tr("Saved %1").arg(QFileInfo(file).fileName()));
    else
        QMessageBox::warning(this, tr("Cannot save the picture"),
                             tr("%1 cannot be written.").arg(file));
}

} // namespace ripstop
