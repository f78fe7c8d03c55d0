#include "document/selection.h"

#include "document/document.h"

#include <algorithm>

namespace ripstop {
namespace {

bool removesSomething(const Edit& edit)
{
    return std::any_of(edit.changes.begin(), edit.changes.end(), [](const Change& change) {
        return std::holds_alternative<RemoveItem>(change)
               || std::holds_alternative<RemoveRows>(change);
    });
}

} // namespace

Selection::Selection(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::replaced, this, &Selection::clear);
    connect(&document, &Document::changed, this, [this](const Edit& applied) {
        if (removesSomething(applied))
            set(m_ids);
    });
}

bool Selection::contains(Id id) const { return std::binary_search(m_ids.begin(), m_ids.end(), id); }

void Selection::set(std::vector<Id> ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::erase_if(ids, [this](Id id) { return !find(m_document.scene(), id); });
    if (ids == m_ids)
        return;
    m_ids = std::move(ids);
    emit changed();
}

void Selection::toggle(Id id)
{
    std::vector<Id> ids = m_ids;
    if (contains(id))
        std::erase(ids, id);
    else
        ids.push_back(id);
    set(std::move(ids));
}

} // namespace ripstop
