// The points of a study over many variables: parallel coordinates, a scatter matrix, or a table,
// and which columns they show. What is brushed in one is selected in all. Only the window's thread
// uses it.
#pragma once

#include "study/parallel_chart.h"

class QMenu;
class QStackedLayout;
class QToolButton;

namespace ripstop {

class PointTable;
class ScatterMatrix;

class ColumnsView final : public QWidget
{
    Q_OBJECT

public:
    enum class Picture { Parallel, Scatter, Table };

    explicit ColumnsView(QWidget* parent = nullptr);

    // The study, or another one; its variables, and of the readings what is wanted in it and the
    // first ones, are shown at first.
    void setStudy(const OpenedStudy& study);
    void show(const OpenedStudy& study, const StudyFlights& flights, Picture picture);
    using QWidget::show;
    void mark(const std::vector<std::size_t>& selected); // by their numbers in the study

    QCustomPlot* plot(); // null: it shows the table
    ParallelChart& parallel() { return *m_parallel; }
    ScatterMatrix& scatter() { return *m_scatter; }
    PointTable& table() { return *m_table; }
    QToolButton& choice() { return *m_choice; } // of columns, for the line above

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how);
    void columnsChosen(); // others than before

private:
    void markShown();

    std::vector<char> m_isShown;      // [variables and readings]
    std::vector<StudyColumn> m_drawn; // [variables], which stay
    std::vector<std::size_t> m_selected;
    QToolButton* m_choice;
    QMenu* m_menu;
    QStackedLayout* m_pages;
    ParallelChart* m_parallel;
    ScatterMatrix* m_scatter;
    PointTable* m_table;
};

} // namespace ripstop
