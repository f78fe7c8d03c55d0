// The first two columns are the number of the point and its outcome; those of the study follow.
// Selected rows are coloured by the model, as a selection of the view would keep a range for each
// of a hundred thousand rows.
#include "study/point_table.h"

#include "study/picking.h"
#include "study/shown_value.h"

#include <QGuiApplication>
#include <QHeaderView>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

constexpr int ownColumns = 2;

QString outcomeName(FlightOutcome outcome)
{
    switch (outcome) {
    case FlightOutcome::Missing:
        return PointTable::tr("not flown");
    case FlightOutcome::Held:
        return PointTable::tr("held");
    case FlightOutcome::Torn:
        return PointTable::tr("tore");
    case FlightOutcome::Stopped:
        return PointTable::tr("ended early");
    }
    return {};
}

} // namespace

void PointModel::show(SharedColumns columns, std::vector<FlightOutcome> outcomes)
{
    beginResetModel();
    m_columns = std::move(columns);
    m_outcomes = std::move(outcomes);
    sortRows();
    endResetModel();
}

void PointModel::mark(const std::vector<std::size_t>& selected)
{
    m_isSelected = marksOf(selected, m_outcomes.size());
    if (!m_order.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1),
                         {Qt::BackgroundRole, Qt::ForegroundRole});
}

int PointModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_order.size());
}

int PointModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ownColumns + int(m_columns->size());
}

QString PointModel::text(int column, std::size_t point) const
{
    if (column == 0)
        return QString::number(point + 1);
    if (column == 1)
        return outcomeName(m_outcomes[point]);
    const StudyColumn& shown = (*m_columns)[std::size_t(column - ownColumns)];
    const double value = shown.value[point];
    if (!std::isfinite(value))
        return {};
    return shown.labels.empty() ? fourDigits(value)
                                : QString::fromStdString(shown.labels[std::size_t(value)]);
}

QVariant PointModel::data(const QModelIndex& index, int role) const
{
    const std::size_t point = pointAt(index.row());
    const bool isSelected = !m_isSelected.empty() && m_isSelected[point];
    if (role == Qt::DisplayRole)
        return text(index.column(), point);
    if (role == Qt::TextAlignmentRole && index.column() != 1)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::BackgroundRole && isSelected)
        return QGuiApplication::palette().brush(QPalette::Highlight);
    if (role == Qt::ForegroundRole && isSelected)
        return QGuiApplication::palette().brush(QPalette::HighlightedText);
    return {};
}

QVariant PointModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    if (section == 0)
        return PointTable::tr("point");
    if (section == 1)
        return PointTable::tr("outcome");
    return QString::fromStdString((*m_columns)[std::size_t(section - ownColumns)].title);
}

void PointModel::sort(int column, Qt::SortOrder order)
{
    beginResetModel();
    m_sorted = column;
    m_direction = order;
    sortRows();
    endResetModel();
}

// What has no number comes last either way.
void PointModel::sortRows()
{
    m_order.resize(m_outcomes.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    const auto column = std::size_t(m_sorted);
    const auto key = [&](std::size_t point) {
        if (m_sorted == 0)
            return double(point);
        if (m_sorted == 1)
            return double(m_outcomes[point]);
        return (*m_columns)[column - ownColumns].value[point];
    };
    if (m_sorted >= columnCount())
        return;
    const bool falls = m_direction == Qt::DescendingOrder;
    std::ranges::stable_sort(m_order, [&](std::size_t a, std::size_t b) {
        const double one = key(a);
        const double other = key(b);
        if (!std::isfinite(one) || !std::isfinite(other))
            return std::isfinite(one) && !std::isfinite(other);
        return falls ? one > other : one < other;
    });
}

PointTable::PointTable(QWidget* parent)
    : QTableView(parent)
    , m_model(new PointModel(this))
{
    setModel(m_model);
    setSelectionMode(QAbstractItemView::NoSelection);
    setSortingEnabled(true);
    sortByColumn(0, Qt::AscendingOrder);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setAccessibleName(tr("Points of the study"));
    connect(this, &QTableView::pressed, this, &PointTable::pick);
}

void PointTable::pick(const QModelIndex& index)
{
    const Picking how = pickingOf(QGuiApplication::keyboardModifiers());
    if (how != Picking::Add) {
        m_anchor = index.row();
        emit picked({m_model->pointAt(index.row())}, how);
        return;
    }
    const auto [first, last] =
        std::minmax({std::min(m_anchor, m_model->rowCount() - 1), index.row()});
    std::vector<std::size_t> points;
    for (int row = first; row <= last; ++row)
        points.push_back(m_model->pointAt(row));
    emit picked(points, how);
}

} // namespace ripstop
