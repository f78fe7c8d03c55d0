// The field that opens in a cell of the sheet: a list for a choice, a line for all else.
//
// The line takes text as it is typed, with units where there are any; the model judges it.
#pragma once

#include <QStyledItemDelegate>

namespace ripstop {

class SheetModel;

class CellEditor final : public QStyledItemDelegate
{
    Q_OBJECT

public:
    CellEditor(SheetModel& model, QObject* parent);

private:
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;

    SheetModel& m_model;
};

} // namespace ripstop
