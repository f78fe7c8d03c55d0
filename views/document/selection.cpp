#include "document/selection.h"

#include "document/document.h"
#include "select/rows_among.h"

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

// The ids that stand for something in the scene. `ids` are in ascending order.
std::vector<Id> existing(const Scene& scene, const std::vector<Id>& ids)
{
    std::vector<char> found(ids.size(), 0);
    const auto note = [&](Id id) {
        const auto place = std::lower_bound(ids.begin(), ids.end(), id);
        if (place != ids.end() && *place == id)
            found[std::size_t(place - ids.begin())] = 1;
    };
    note(settingsId);
    for (const Entry& entry : scene.items)
        note(entry.id);
    forEachPart(scene, [&](Id, const Part& part) {
        const auto mark = [&](const auto&, std::size_t place) { found[place] = 1; };
        forEachRowAmong(part.particles, ids, mark);
        forEachRowAmong(part.links, ids, mark);
        forEachRowAmong(part.panels, ids, mark);
    });
    std::vector<Id> result;
    for (std::size_t i = 0; i < ids.size(); ++i)
        if (found[i])
            result.push_back(ids[i]);
    return result;
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
    if (!std::is_sorted(ids.begin(), ids.end()))
        std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    ids = existing(m_document.scene(), ids);
    if (ids == m_ids)
        return;
    m_ids = std::move(ids);
    emit changed();
}

void Selection::add(const std::vector<Id>& ids)
{
    std::vector<Id> all = m_ids;
    all.insert(all.end(), ids.begin(), ids.end());
    set(std::move(all));
}

void Selection::remove(const std::vector<Id>& ids)
{
    std::vector<Id> out = ids;
    std::sort(out.begin(), out.end());
    std::vector<Id> left;
    std::set_difference(m_ids.begin(), m_ids.end(), out.begin(), out.end(),
                        std::back_inserter(left));
    set(std::move(left));
}

} // namespace ripstop
