// What a study has found: its map, which measure it shows over which variables, and the flight that
// is chosen in it.
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
class QToolButton;

namespace ripstop {

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
    void fillSlices();
    void describe(qlonglong point);
    void savePictureAs();

    const OpenedStudy* m_study = nullptr;
    const StudyFlights* m_flights = nullptr;
    std::optional<std::size_t> m_chosen;
    QComboBox* m_reading;
    QComboBox* m_x;
    QLabel* m_over;
    QComboBox* m_y;
    QHBoxLayout* m_slices;
    std::vector<QComboBox*> m_sliceBoxes; // [variables] null of those that are axes
    StudyChart* m_chart;
    QLabel* m_told;
    QPushButton* m_watch;
    QPushButton* m_apply;
    QToolButton* m_save;
};

} // namespace ripstop
