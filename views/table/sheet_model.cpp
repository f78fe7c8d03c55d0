// reload() takes the ids of the sheet, cuts them to the limit and starts to sort. startSort() reads
// the keys of the column and gives them to a thread; a change meanwhile only marks the answer as
// stale, so that one thread runs at a time.
//
// data() reads a cell from the scene by the property of its column: switches as check marks,
// choices by their labels, numbers in few digits. setData() makes an edit of what was typed by the
// same function that pasting uses, or emits why it was refused.
#include "table/sheet_model.h"

#include "document/document.h"
#include "document/edit_words.h"
#include "document/words.h"

#include <QColor>
#include <QPalette>

#include <algorithm>

namespace ripstop {
namespace {

bool isSwitch(const SheetColumn& column)
{
    return column.property && std::holds_alternative<bool>(column.property->initial);
}

bool isNumber(const Property& property)
{
    return property.optional || std::holds_alternative<double>(property.initial)
           || std::holds_alternative<int>(property.initial)
           || std::holds_alternative<Vec3>(property.initial);
}

} // namespace

SheetModel::SheetModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent)
    , m_document(document)
    , m_columns(sheetColumns(m_sheet))
{}

void SheetModel::show(SheetOf sheet)
{
    beginResetModel();
    m_sheet = sheet;
    m_columns = sheetColumns(sheet);
    m_rows.clear();
    m_ids.clear();
    m_sortColumn = 0;
    m_sortOrder = Qt::AscendingOrder;
    endResetModel();
}

void SheetModel::limitTo(std::optional<std::vector<Id>> ids)
{
    m_limit = std::move(ids);
    reload();
}

void SheetModel::reload()
{
    std::vector<Id> ids = sheetRows(m_document.scene(), m_sheet);
    m_total = ids.size();
    if (m_limit) {
        std::vector<Id> both;
        std::ranges::set_intersection(ids, *m_limit, std::back_inserter(both));
        ids = std::move(both);
    }
    if (ids != m_rows) {
        m_rows = std::move(ids);
        setRows(m_rows); // in the order of ids until they are sorted
    }
    startSort();
}

void SheetModel::setRows(std::vector<Id> ids)
{
    beginResetModel();
    m_ids = std::move(ids);
    endResetModel();
}

void SheetModel::sort(int column, Qt::SortOrder order)
{
    if (column < 0 || column >= columnCount())
        return;
    m_sortColumn = column;
    m_sortOrder = order;
    startSort();
}

void SheetModel::startSort()
{
    m_isStale = m_isBusy;
    if (m_isBusy)
        return;
    const bool isById = m_sortColumn == 0 && m_sortOrder == Qt::AscendingOrder;
    if (isById) {
        if (m_rows != m_ids)
            setRows(m_rows);
        emit sorted();
        return;
    }
    m_isBusy = true;
    const auto order = m_sortOrder == Qt::AscendingOrder ? SheetOrder::Rising : SheetOrder::Falling;
    m_sorter = std::jthread([this, order,
                             keys = sheetKeys(m_document.scene(), m_rows,
                                              m_columns[std::size_t(m_sortColumn)])]() mutable {
        auto inOrder = ripstop::sorted(std::move(keys), order);
        QMetaObject::invokeMethod(
            this,
            [this, inOrder = std::move(inOrder)]() mutable {
                m_isBusy = false;
                if (m_isStale)
                    return startSort(); // for what is wanted by now
                if (inOrder != m_ids)
                    setRows(std::move(inOrder));
                emit sorted();
            },
            Qt::QueuedConnection);
    });
}

int SheetModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_ids.size());
}

int SheetModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_columns.size());
}

QVariant SheetModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Id id = m_ids[std::size_t(index.row())];
    const SheetColumn& column = m_columns[std::size_t(index.column())];
    if (!column.property) {
        if (role == Qt::DisplayRole)
            return std::uint32_t(id);
        if (role == Qt::TextAlignmentRole)
            return int(Qt::AlignRight | Qt::AlignVCenter);
        return role == Qt::ForegroundRole ? QVariant(QPalette().placeholderText()) : QVariant();
    }
    const auto thing = find(m_document.scene(), id);
    if (!thing || kindOf(*thing) != column.property->kind)
        return {}; // an edit removed it, and the rows are about to change
    const Property& property = *column.property;
    switch (role) {
    case Qt::DisplayRole:
        if (isSwitch(column))
            return {};
        if (!property.choices.empty())
            return choiceLabel(std::get<std::string>(property.get(*thing)));
        if (property.optional && std::holds_alternative<std::monostate>(property.get(*thing)))
            return QString(QChar(0x2013)); // the number is the material's
        [[fallthrough]];
    case Qt::EditRole: {
        const QString cell = QString::fromStdString(cellText(m_document.scene(), *thing, column));
        bool isPlain = false;
        const double number = cell.toDouble(&isPlain);
        return role == Qt::DisplayRole && isPlain && isNumber(property) ? compactNumber(number)
                                                                        : cell;
    }
    case Qt::CheckStateRole:
        return isSwitch(column)
                   ? QVariant(std::get<bool>(property.get(*thing)) ? Qt::Checked : Qt::Unchecked)
                   : QVariant();
    case Qt::TextAlignmentRole:
        return int((isNumber(property) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::DecorationRole:
        return property.meaning == Meaning::Color ? QVariant(
                   QColor(QString::fromStdString(cellText(m_document.scene(), *thing, column))))
                                                  : QVariant();
    default:
        return {};
    }
}

QVariant SheetModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    const SheetColumn& column = m_columns[std::size_t(section)];
    if (!column.property)
        return role == Qt::DisplayRole   ? QVariant(tr("Id"))
               : role == Qt::ToolTipRole ? QVariant(tr("The number by which files and paths name "
                                                       "the thing."))
                                         : QVariant();
    const Property& property = *column.property;
    if (role == Qt::ToolTipRole)
        return QStringLiteral("<qt>%1</qt>").arg(helpOf(property).toHtmlEscaped());
    if (role != Qt::DisplayRole)
        return {};
    QString title = labelOf(property);
    if (std::holds_alternative<Vec3>(property.initial))
        title += QStringLiteral(" %1").arg(QChar("xyz"[column.axis]));
    return property.unit.empty() ? title : title + QStringLiteral(" (%1)").arg(text(property.unit));
}

Qt::ItemFlags SheetModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || index.column() == 0)
        return flags;
    if (isSwitch(m_columns[std::size_t(index.column())]))
        return flags | Qt::ItemIsUserCheckable;
    return flags | Qt::ItemIsEditable;
}

bool SheetModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || (role != Qt::EditRole && role != Qt::CheckStateRole))
        return false;
    const QString typed =
        role == Qt::CheckStateRole
            ? (value.toInt() == Qt::Checked ? QStringLiteral("yes") : QStringLiteral("no"))
            : value.toString();
    if (role == Qt::EditRole && typed == data(index, Qt::EditRole).toString())
        return true; // the text is as it was
    const SheetColumn& column = m_columns[std::size_t(index.column())];
    auto edit = pasted(m_document.scene(), {m_ids[std::size_t(index.row())]}, {column},
                       typed.toStdString());
    if (!edit) {
        const QString sentence = translated(edit.message());
        // the place before the colon is not needed, as there is one cell only
        emit refused(sentence.mid(sentence.indexOf(QStringLiteral(": ")) + 2));
        return false;
    }
    emit refused({});
    if (const auto* set = std::get_if<SetValues>(&edit->changes.front()))
        edit->label = settingLabel(m_document.scene(), *column.property, set->targets, set->values);
    m_document.push(std::move(*edit));
    return true;
}

} // namespace ripstop
