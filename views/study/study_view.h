// What a study has found: its map, which measure it shows over which variables, and the flight that
// is chosen in it; of what is looked for, the pictures of goal_chart.h.
//
// It draws what it is given and announces what a person wants of a flight; the panel does it.
#pragma once

#include "study/study_map.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace ripstop {

class GoalChart;
class StudyChart;

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
    std::optional<std::size_t> chosen() const { return m_chosen; } // point of the study
    void choose(std::optional<std::size_t> point);

    // "EA 3000, strength 80"
    static QString valuesOf(const OpenedStudy& study, std::size_t point);

signals:
    void watchWanted(std::size_t point);
    void applyWanted(std::size_t point);
    void tableWanted();
    void said(const QString& words); // for the status bar

private:
    QWidget* axesLine();
    QWidget* flightLine();
    void fillChoices();
    void fillPictures();
    void showBoxes();
    void fillSlices();
    void describe(qlonglong point);
    void savePictureAs();

    const OpenedStudy* m_study = nullptr;
    const StudyFlights* m_flights = nullptr;
    std::optional<std::size_t> m_chosen;
    QComboBox* m_picture; // the map, or one of GoalChart
    QComboBox* m_reading;
    QComboBox* m_x;
    QLabel* m_over;
    QComboBox* m_y;
    QHBoxLayout* m_slices;
    std::vector<QComboBox*> m_sliceBoxes; // [variables] null of those that are axes
    QStackedWidget* m_charts;
    StudyChart* m_chart;
    GoalChart* m_goals;
    QLabel* m_told;
    QPushButton* m_watch;
    QPushButton* m_apply;
    QToolButton* m_save;
};

} // namespace ripstop
