// What a study has found: its map, which measure it shows over which variables, and the flights
// that are selected in it, one of which is the chosen one; percentiles over one variable; all
// points over many variables; and of what is looked for, the pictures of goal_chart.h. Beside them
// stand the curves of flights that are compared. All share one selection.
//
// It draws what it is given and announces what a person wants of a flight; the panel does it.
#pragma once

#include "study/flight_curves.h"
#include "study/study_map.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QCustomPlot;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace ripstop {

class ColumnsView;
class GoalChart;
class PercentileChart;
class StudyChart;
class DesignGallery;
enum class Picking;

class StudyView final : public QWidget
{
    Q_OBJECT

public:
    explicit StudyView(QWidget* parent = nullptr);

    // Both stay with who shows them, until another is shown or null.
    void setStudy(const OpenedStudy* study, const StudyFlights* flights);
    void refresh(); // there are more flights

    StudyChart& chart() { return *m_chart; }
    GoalChart& goals() { return *m_goals; }
    DesignGallery& designs() { return *m_designs; }
    PercentileChart& bands() { return *m_bands; }
    ColumnsView& columns() { return *m_columns; }
    std::optional<std::size_t> chosen() const { return m_chosen; } // point of the study
    void choose(std::optional<std::size_t> point);                 // that one alone
    const std::vector<std::size_t>& selected() const { return m_selected; }
    void select(std::vector<std::size_t> points);

    static constexpr std::size_t mostCompared = 16;   // curves that can be told apart
    void showCurves(std::vector<FlightCurve> curves); // none: hides them
    FlightCurves& curves() { return *m_curves; }

    // Says whether it could, to people too.
    bool writePicture(QCustomPlot& plot, const QString& file);

    // "EA 3000 N, strength 80 N"
    static QString valuesOf(const OpenedStudy& study, std::size_t point);

signals:
    void watchWanted(std::size_t point);
    void compareWanted(const std::vector<std::size_t>& points);
    void ghostsWanted(); // in another way than before, or no more
    void applyWanted(std::size_t point);
    void tableWanted();
    void said(const QString& words); // for the status bar

private:
    enum class Page { Map, Percentiles, Columns, Goals, Designs }; // of m_charts

    QWidget* axesLine();
    QWidget* emptyPage();
    QWidget* flightLine();
    void fillChoices();
    void fillPictures();
    Page page() const;
    QCustomPlot* shownPlot(); // null: a table or designs are shown
    void pick(const std::vector<std::size_t>& points, Picking how);
    void refreshMap(std::size_t reading);
    bool isEmpty() const; // nothing is flown
    void showBoxes();
    void fillSlices();
    void describe(qlonglong point);
    void chooseOfSelected(std::optional<std::size_t> point);
    void savePictureAs();
    void saveCurvesAs();

    const OpenedStudy* m_study = nullptr;
    const StudyFlights* m_flights = nullptr;
    std::vector<std::size_t> m_selected; // in the order in which they were picked
    std::optional<std::size_t> m_chosen;
    QWidget* m_axes; // what stands above the charts
    QComboBox* m_picture;
    QComboBox* m_reading;
    QComboBox* m_x;
    QLabel* m_over;
    QComboBox* m_y;
    QHBoxLayout* m_slices;
    std::vector<QComboBox*> m_sliceBoxes; // [variables] null of those that are axes
    QStackedWidget* m_charts;
    StudyChart* m_chart;
    GoalChart* m_goals;
    DesignGallery* m_designs;
    PercentileChart* m_bands;
    ColumnsView* m_columns;
    QSplitter* m_sides;
    FlightCurves* m_curves;
    QLabel* m_told;
    QPushButton* m_watch;
    QPushButton* m_compare;
    QPushButton* m_apply;
    QToolButton* m_save;
};

} // namespace ripstop
