// The rows of a sheet for a view.
//
// Cells are read from the scene when they are painted, so that a table of a million rows costs its
// ids. The order by a column is found by a thread of its own, from keys that are read before it
// starts; the rows change when its answer arrives in the thread of the window. All functions belong
// to that thread.
#pragma once

#include "select/sheet.h"

#include <QAbstractTableModel>

#include <optional>
#include <thread>

namespace ripstop {

class Document;

class SheetModel final : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit SheetModel(Document& document, QObject* parent = nullptr);

    void show(SheetOf sheet); // without rows until the next limit or reload
    // Shows only these rows, in ascending order; nothing takes the limit away.
    void limitTo(std::optional<std::vector<Id>> ids);
    void reload(); // rows may have come or gone

    SheetOf sheet() const { return m_sheet; }
    const std::vector<SheetColumn>& columns() const { return m_columns; }
    const std::vector<Id>& ids() const { return m_ids; } // in the order of the rows
    std::size_t total() const { return m_total; }        // without the limit
    bool isSorting() const { return m_isBusy; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    void sort(int column, Qt::SortOrder order) override;

signals:
    void refused(const QString& sentence); // what was typed; empty when it was taken
    void sorted();

private:
    void setRows(std::vector<Id> ids);
    void startSort();

    Document& m_document;
    SheetOf m_sheet = SheetOf::Particles;
    std::vector<SheetColumn> m_columns;
    std::vector<Id> m_rows; // the rows that are shown, ascending
    std::vector<Id> m_ids;
    std::size_t m_total = 0;
    std::optional<std::vector<Id>> m_limit;
    int m_sortColumn = 0;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
    bool m_isBusy = false;  // a thread is sorting
    bool m_isStale = false; // something changed since the sorting began
    std::jthread m_sorter;  // it is the last member, so that it ends before the rest is destroyed
};

} // namespace ripstop
