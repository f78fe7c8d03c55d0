#include "outline/outline_filter.h"

#include "outline/outline_model.h"

#include <algorithm>

namespace ripstop {

OutlineFilter::OutlineFilter(OutlineModel& model, QObject* parent)
    : QSortFilterProxyModel(parent)
    , m_model(model)
{
    setRecursiveFilteringEnabled(true);
    setSourceModel(&model);
}

void OutlineFilter::search(const QString& text)
{
    m_text = text.trimmed();
    if (m_text == QChar('#')) // a number is about to come
        m_text.clear();
    m_id = idIn(m_text);
    invalidateFilter();
}

std::optional<Id> OutlineFilter::idIn(const QString& text)
{
    const QString trimmed = text.trimmed();
    bool isNumber = false;
    const auto number = trimmed.mid(1).toUInt(&isNumber);
    return trimmed.startsWith(QChar('#')) && isNumber ? std::optional(Id{number}) : std::nullopt;
}

bool OutlineFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    using Sort = OutlineModel::Node::Sort;
    const QModelIndex name = m_model.index(row, OutlineModel::Name, parent);
    const OutlineModel::Node node = m_model.node(name);
    const QString detail =
        m_model.index(row, OutlineModel::Detail, parent).data(Qt::DisplayRole).toString();

    if (m_id && node.sort == Sort::Table)
        return std::ranges::binary_search(m_model.ids(name), *m_id);
    if (m_id && node.sort == Sort::Thing && node.id == *m_id)
        return true;

    // A list is there for what it holds, so that it comes back with its first matching item.
    if (node.sort == Sort::Section)
        return m_text.isEmpty() && m_model.rowCount(name) > 0;
    if (node.sort == Sort::Table)
        return m_text.isEmpty() && detail != QStringLiteral("0");
    return m_text.isEmpty() || name.data().toString().contains(m_text, Qt::CaseInsensitive)
           || detail.contains(m_text, Qt::CaseInsensitive);
}

} // namespace ripstop
