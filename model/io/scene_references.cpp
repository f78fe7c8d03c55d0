// References between the things of a draft.
#include "io/scene_reader.h"

#include "io/json_place.h"

#include <algorithm>

namespace ripstop {
namespace {

std::string number(Id id) { return std::to_string(std::uint32_t(id)); }

class References
{
public:
    References(SceneDraft& draft, std::string_view text)
        : m_scene(draft.scene)
        , m_written(draft.written)
        , m_text(text)
    {}

    std::optional<Flaw> check()
    {
        const auto byId = [](const Written& a, const Written& b) {
            return a.id != b.id ? a.id < b.id : a.begin < b.begin;
        };
        if (!std::is_sorted(m_written.begin(), m_written.end(), byId))
            std::sort(m_written.begin(), m_written.end(), byId);
        const auto twice =
            std::adjacent_find(m_written.begin(), m_written.end(),
                               [](const Written& a, const Written& b) { return a.id == b.id; });
        if (twice != m_written.end())
            return Flaw{endOfMember(m_text, (twice + 1)->begin, "id", 0),
                        "is used twice: " + number(twice->id) + " is also the id of the "
                            + std::string(twice->name()) + " in line "
                            + std::to_string(placeOf(m_text, twice->begin + 1).line)
                            + "; give one of the two another id"};
        for (const Entry& entry : m_scene.items) {
            checkThing(entry.id,
                       std::visit([](const auto& item) -> ConstRef { return &item; }, entry.item));
            if (const Part* part = std::get_if<Part>(&entry.item))
                checkElements(*part);
            if (m_flaw)
                break;
        }
        return m_flaw;
    }

private:
    void checkElements(const Part& part)
    {
        for (const Link& link : part.links) {
            checkThing(link.id, &link);
            if (link.from == noId || link.to == noId || link.from == link.to)
                note(link.id, {}, 0, R"(needs two different particles as its "from" and "to")");
        }
        for (const Panel& panel : part.panels) {
            checkThing(panel.id, &panel);
            if (panel.a == noId || panel.b == noId || panel.c == noId || panel.a == panel.b
                || panel.b == panel.c || panel.a == panel.c)
                note(panel.id, {}, 0, R"(needs three different particles as its "a", "b", "c")");
        }
    }

    void checkThing(Id holder, const ConstRef& ref)
    {
        for (const Property& property : m_pointing[std::size_t(kindOf(ref))]) {
            const Value value = property.get(ref);
            if (const Id* id = std::get_if<Id>(&value))
                checkOne(holder, property, *id, 0);
            else if (const auto* ids = std::get_if<std::vector<Id>>(&value))
                for (std::size_t i = 0; i < ids->size(); ++i)
                    checkOne(holder, property, (*ids)[i], i);
        }
    }

    void checkOne(Id holder, const Property& property, Id id, std::size_t index)
    {
        if (id == noId)
            return;
        const Written* found = findWritten(id);
        if (!found)
            note(holder, property.key, index,
                 "points at " + number(id)
                     + ", which does not exist; write the id of an existing thing or remove it");
        else if (found->kind && !property.pointsAt.contains(*found->kind)) // check.h knows the rest
            note(holder, property.key, index,
                 "points at " + number(id) + ", which is a " + std::string(found->name())
                     + "; write the id of " + wanted(property));
    }

    const Written* findWritten(Id id) const
    {
        // Ids are mostly given in one go, so most of them lie where counting expects them.
        const std::size_t guess = std::size_t(id) - std::size_t(m_written.front().id);
        if (guess < m_written.size() && m_written[guess].id == id)
            return &m_written[guess];
        const auto found =
            std::lower_bound(m_written.begin(), m_written.end(), id,
                             [](const Written& w, Id searched) { return w.id < searched; });
        return found != m_written.end() && found->id == id ? &*found : nullptr;
    }

    static std::string wanted(const Property& property)
    {
        std::string list;
        for (int i = 0; i < kindCount; ++i)
            if (property.pointsAt.contains(Kind(i)))
                list += (list.empty() ? "a " : " or a ") + std::string(kindName(Kind(i)));
        return list;
    }

    // The first flaw counts.
    void note(Id holder, std::string_view key, std::size_t index, std::string message)
    {
        if (m_flaw)
            return;
        const std::size_t begin = findWritten(holder)->begin;
        m_flaw = Flaw{key.empty() ? begin + 1 : endOfMember(m_text, begin, key, index),
                      std::move(message)};
    }

    static std::vector<std::vector<Property>> pointing()
    {
        std::vector<std::vector<Property>> table(kindCount);
        for (const Property& property : allProperties())
            if (!property.pointsAt.empty())
                table[std::size_t(property.kind)].push_back(property);
        return table;
    }

    const Scene& m_scene;
    std::vector<Written>& m_written;
    std::string_view m_text;
    std::vector<std::vector<Property>> m_pointing = pointing();
    std::optional<Flaw> m_flaw;
};

} // namespace

std::optional<Flaw> referenceFlaw(SceneDraft& draft, std::string_view text)
{
    return References(draft, text).check();
}

} // namespace ripstop
