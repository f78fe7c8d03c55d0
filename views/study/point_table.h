// The points of a study as a table: a row for each, with its variables, what came of it, and what
// was read. A click on a heading sorts; a click on a row picks it, with Ctrl or Shift several. What
// is selected elsewhere is coloured here, however much it is. Only the window's thread uses it.
#pragma once

#include "study/parallel_chart.h"

#include <QAbstractTableModel>
#include <QTableView>

namespace ripstop {

class PointModel final : public QAbstractTableModel
{
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(SharedColumns columns, std::vector<FlightOutcome> outcomes);
    void mark(const std::vector<std::size_t>& selected);
    std::size_t pointAt(int row) const { return m_order[std::size_t(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void sort(int column, Qt::SortOrder order) override;

private:
    QString text(int column, std::size_t point) const;
    void sortRows();

    SharedColumns m_columns = std::make_shared<const std::vector<StudyColumn>>();
    std::vector<FlightOutcome> m_outcomes; // [points]
    std::vector<std::size_t> m_order;      // [rows] point
    std::vector<char> m_isSelected;        // [points] empty: none is
    int m_sorted = 0;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
};

class PointTable final : public QTableView
{
    Q_OBJECT

public:
    explicit PointTable(QWidget* parent = nullptr);

    PointModel& points() { return *m_model; }

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how);

private:
    void pick(const QModelIndex& index);

    PointModel* m_model;
    int m_anchor = 0; // row
};

} // namespace ripstop
