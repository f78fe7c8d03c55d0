#include "table/cell_editor.h"

#include "document/words.h"
#include "table/sheet_model.h"

#include <QComboBox>
#include <QLineEdit>

namespace ripstop {

CellEditor::CellEditor(SheetModel& model, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_model(model)
{}

QWidget* CellEditor::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                  const QModelIndex& index) const
{
    const Property* property = m_model.columns()[std::size_t(index.column())].property;
    if (!property || property->choices.empty()) {
        auto* line = new QLineEdit(parent); // also for numbers, which may have units
        line->setFrame(false);
        return line;
    }
    auto* list = new QComboBox(parent);
    for (const std::string_view choice : property->choices)
        list->addItem(choiceLabel(choice),
                      QString::fromUtf8(choice.data(), qsizetype(choice.size())));
    return list;
}

void CellEditor::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    const QString text = index.data(Qt::EditRole).toString();
    if (auto* list = qobject_cast<QComboBox*>(editor))
        list->setCurrentIndex(list->findData(text));
    else if (auto* line = qobject_cast<QLineEdit*>(editor))
        line->setText(text);
}

void CellEditor::setModelData(QWidget* editor, QAbstractItemModel* model,
                              const QModelIndex& index) const
{
    if (auto* list = qobject_cast<QComboBox*>(editor))
        model->setData(index, list->currentData().toString(), Qt::EditRole);
    else if (auto* line = qobject_cast<QLineEdit*>(editor))
        model->setData(index, line->text(), Qt::EditRole);
}

} // namespace ripstop
