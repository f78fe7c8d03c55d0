// A machine of states that takes the events of the JSON text: file, items, tables, records, then
// single values and lists. Each value is checked and set through the property table as it comes, so
// that no tree of the text is built.
#include "io/scene_reader.h"

#include "io/item_types.h"
#include "io/json_capture.h"
#include "io/json_place.h"
#include "io/json_value.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

using Token = JsonEvent::Type;

constexpr std::size_t deepest = 64; // levels of nesting; a scene needs six
constexpr std::string_view noIdRule =
    "has no \"id\"; give it a whole number that nothing else in the file has";
constexpr std::string_view idRule = "must be an id: a whole number from 1 to 4000000000";

template <typename Row>
void sortById(std::vector<Row>& rows)
{
    const auto byId = [](const Row& a, const Row& b) { return a.id < b.id; };
    if (!std::is_sorted(rows.begin(), rows.end(), byId))
        std::stable_sort(rows.begin(), rows.end(), byId);
}

// The keys of a file and of an item that are not rows of the property table.
enum class Slot { Property, Id, Type, Parameters, Table, Format, Version, NextId, Settings, Items };

class SceneReader
{
public:
    explicit SceneReader(std::string_view text)
        : m_text(text)
    {
        for (int i = 0; i < kindCount; ++i)
            m_properties[std::size_t(i)] = propertiesOf(Kind(i));
    }

    SceneDraft read()
    {
        walkJson(m_text, 0, true, [this](const JsonEvent& event) { return on(event); });
        if (m_draft.flaw)
            return std::move(m_draft);
        Scene& scene = m_draft.scene;
        if (!m_fileUnknown.empty())
            scene.unknown[noId] = "{" + m_fileUnknown + "}";
        for (const Written& written : m_draft.written)
            takeAbove(written.id);
        return std::move(m_draft);
    }

private:
    enum class In { Nothing, File, Items, Record, Parameters, Table, List };

    // An object whose keys are properties, while it is read.
    struct Record
    {
        Kind kind{};
        Ref ref;
        std::size_t begin = 0;
        Id id{};
        std::uint64_t seen = 0; // a bit per property and slot
        std::string unknown{};
    };

    bool on(const JsonEvent& event)
    {
        m_end = event.end;
        if (event.type == Token::Error)
            return flaw(std::string(event.text));
        m_depth += event.begins() ? 1 : 0;
        m_depth -= event.ends() ? 1 : 0;
        if (m_depth > deepest)
            return flaw("is nested deeper than any scene; remove the brackets");
        if (m_unknown.active())
            return keep(event);

        switch (m_in.back()) {
        case In::Nothing:
            return enter(In::File);
        case In::File:
            return inFile(event);
        case In::Items:
            return inItems(event);
        case In::Record:
            return inRecord(event);
        case In::Parameters:
            return inParameters(event);
        case In::Table:
            return inTable(event);
        case In::List:
            return inList(event);
        }
        return false;
    }

    bool enter(In in)
    {
        m_in.push_back(in);
        return true;
    }
    bool leave()
    {
        m_in.pop_back();
        return true;
    }
    bool flaw(std::string message) { return flawAt(m_end, std::move(message)); }
    bool flawAt(std::size_t end, std::string message)
    {
        m_draft.flaw = Flaw{end, std::move(message)};
        return false;
    }

    // --- the file ---------------------------------------------------------------------------

    bool inFile(const JsonEvent& event)
    {
        static constexpr std::array<std::pair<std::string_view, Slot>, 5> slots{
            {{"format", Slot::Format},
             {"version", Slot::Version},
             {"nextId", Slot::NextId},
             {"settings", Slot::Settings},
             {"items", Slot::Items}}};
        if (event.type == Token::EndObject)
            return leave();
        if (event.type == Token::Key) {
            for (const auto& [name, slot] : slots)
                if (event.text == name) {
                    m_slot = slot;
                    return once(m_fileSeen, std::size_t(slot));
                }
            return m_unknown.start(m_fileUnknown, event.text);
        }
        if (m_slot == Slot::Format || m_slot == Slot::Version)
            return event.begins() ? flaw("must be a text or a number") : true; // looked at before
        if (m_slot == Slot::NextId)
            return readId(event, m_draft.scene.nextId, largestId + 1.0);
        if (m_slot == Slot::Settings) {
            if (event.type != Token::BeginObject)
                return flaw("must be an object: {...}");
            m_records.push_back(
                {Kind::Settings, &m_draft.scene.settings, event.end - 1, settingsId});
            return enter(In::Record);
        }
        return event.type == Token::BeginArray ? enter(In::Items) : flaw("must be a list: [...]");
    }

    // New ids are above this one.
    void takeAbove(Id id)
    {
        Scene& scene = m_draft.scene;
        scene.nextId = std::max(scene.nextId, Id{std::uint32_t(id) + 1});
    }

    static bool isIdNumber(double number, double largest)
    {
        return number == std::floor(number) && number >= 1.0 && number <= largest;
    }

    bool once(std::uint64_t& seen, std::size_t bit)
    {
        if (seen >> bit & 1)
            return flaw("is there twice; remove one of the two");
        seen |= std::uint64_t(1) << bit;
        return true;
    }

    bool readId(const JsonEvent& event, Id& id, double largest = largestId)
    {
        if (event.type != Token::Number || !isIdNumber(event.number, largest))
            return flaw(std::string(idRule) + ", not " + shown(event, m_text));
        id = Id{std::uint32_t(event.number)};
        return true;
    }

    // --- items and elements -----------------------------------------------------------------

    bool inItems(const JsonEvent& event)
    {
        if (event.type == Token::EndArray)
            return leave();
        if (event.type != Token::BeginObject)
            return flaw(R"(must be an object: {"type": ..., "id": ...})");

        // The type decides what the other keys mean, wherever it stands among them.
        const std::size_t begin = event.end - 1;
        const std::optional<JsonMember> type = findMember(m_text, begin, "type");
        if (!type)
            return flaw("has no \"type\"; give it one of " + itemTypeList());
        const bool isText = type->type == Token::Text && !type->text.empty();
        const auto kind = isText ? itemKind(type->text) : std::nullopt;
        if (isText && !kind && !kindFromName(type->text))
            return beginUnknownItem(event, type->text);
        if (type->type != Token::Error && !kind)
            return flawAt(type->end, "must be one of " + itemTypeList());
        // A broken text is told of when the walk gets there.
        Scene& scene = m_draft.scene;
        scene.items.push_back({noId, itemOf(kind.value_or(Kind::Part))});
        const Ref ref =
            std::visit([](auto& item) -> Ref { return &item; }, scene.items.back().item);
        m_records.push_back({kindOf(asConst(ref)), ref, begin});
        return enter(In::Record);
    }

    // What a later version may have written is kept as it is.
    bool beginUnknownItem(const JsonEvent& event, const std::string& type)
    {
        const std::size_t begin = event.end - 1;
        const std::optional<JsonMember> id = findMember(m_text, begin, "id");
        if (!id)
            return flawAt(begin + 1, std::string(noIdRule));
        const bool isId = id->type == Token::Number && isIdNumber(id->number, largestId);
        if (id->type != Token::Error && !isId)
            return flawAt(id->end, std::string(idRule));
        Scene& scene = m_draft.scene;
        const Id after = scene.items.empty() ? noId : scene.items.back().id;
        const Id own{isId ? std::uint32_t(id->number) : 0};
        scene.unknownItems.push_back({own, after, type, {}});
        m_draft.written.push_back({own, std::nullopt, begin});
        m_unknown.start(scene.unknownItems.back().text);
        m_isInUnknownItem = true;
        return keep(event);
    }

    // What is not understood. Ids within an item are not given to others.
    bool keep(const JsonEvent& event)
    {
        if (m_isInUnknownItem && m_isAtId && event.type == Token::Number
            && isIdNumber(event.number, largestId))
            takeAbove(Id{std::uint32_t(event.number)});
        m_isAtId = event.type == Token::Key && event.text == "id";
        m_unknown.add(event, m_text);
        m_isInUnknownItem &= m_unknown.active();
        return true;
    }

    bool inTable(const JsonEvent& event)
    {
        if (event.type == Token::EndArray)
            return leave();
        if (event.type != Token::BeginObject)
            return flaw("must be an object: {\"id\": ...}");
        Part& part = *std::get<Part*>(m_records.back().ref);
        const Ref ref = m_table == Kind::Particle ? Ref(&part.particles.emplace_back())
                        : m_table == Kind::Link   ? Ref(&part.links.emplace_back())
                                                  : Ref(&part.panels.emplace_back());
        m_records.push_back({m_table, ref, event.end - 1});
        return enter(In::Record);
    }

    bool inRecord(const JsonEvent& event)
    {
        Record& record = m_records.back();
        if (event.type == Token::EndObject)
            return finish(record);
        if (event.type == Token::Key)
            return onKey(record, event.text);

        switch (m_slot) {
        case Slot::Id:
            return readId(event, record.id);
        case Slot::Type:
            return true;
        case Slot::Parameters:
            return event.type == Token::BeginObject ? enter(In::Parameters)
                                                    : flaw("must be an object: {...}");
        case Slot::Table:
            return event.type == Token::BeginArray ? enter(In::Table)
                                                   : flaw("must be a list: [...]");
        default:
            return onValue(record, event);
        }
    }

    bool onKey(Record& record, std::string_view key)
    {
        const auto slot = [&](Slot which, std::size_t extra = 0) {
            m_slot = which;
            return once(record.seen, 48 + std::size_t(which) + extra);
        };
        const auto properties = m_properties[std::size_t(record.kind)];
        for (std::size_t i = 0; i < properties.size(); ++i)
            if (properties[i].key == key) {
                m_slot = Slot::Property;
                m_property = &properties[i];
                return once(record.seen, i);
            }
        if (key == "id" && record.kind != Kind::Settings)
            return slot(Slot::Id);
        if (key == "type" && record.kind >= Kind::Part)
            return slot(Slot::Type);
        if (record.kind == Kind::Part) {
            if (key == "parameters")
                return slot(Slot::Parameters);
            for (const Kind table : {Kind::Particle, Kind::Link, Kind::Panel})
                if (key == kindPlural(table)) {
                    m_table = table;
                    return slot(Slot::Table, std::size_t(table));
                }
        }
        return m_unknown.start(record.unknown, key);
    }

    bool finish(Record& record)
    {
        Scene& scene = m_draft.scene;
        if (record.id == noId)
            return flawAt(record.begin + 1, std::string(noIdRule));
        if (!record.unknown.empty())
            scene.unknown[record.id] = "{" + record.unknown + "}";
        switch (record.kind) {
        case Kind::Settings:
            break;
        case Kind::Particle:
            std::get<Particle*>(record.ref)->id = record.id;
            break;
        case Kind::Link:
            std::get<Link*>(record.ref)->id = record.id;
            break;
        case Kind::Panel:
            std::get<Panel*>(record.ref)->id = record.id;
            break;
        default:
            scene.items.back().id = record.id;
        }
        if (record.kind != Kind::Settings)
            m_draft.written.push_back({record.id, record.kind, record.begin});
        if (record.kind == Kind::Part) {
            Part& part = *std::get<Part*>(record.ref);
            sortById(part.particles);
            sortById(part.links);
            sortById(part.panels);
        }
        m_records.pop_back();
        return leave();
    }

    // --- values -----------------------------------------------------------------------------

    bool onValue(const Record& record, const JsonEvent& event)
    {
        const Value& initial = m_property->initial;
        const bool list = std::holds_alternative<Vec3>(initial)
                          || std::holds_alternative<std::vector<Id>>(initial)
                          || std::holds_alternative<NumberRows>(initial);
        if (list && event.type == Token::BeginArray) {
            m_vectorSize = 0;
            m_ids.clear();
            m_rows.clear();
            m_inRow = false;
            return enter(In::List);
        }
        const Value value = valueFromEvent(*m_property, event);
        if (const auto reason = refusal(*m_property, value)) {
            const std::string_view near =
                event.type == Token::Text ? nearest(event.text, m_property->choices) : "";
            return flaw(reason->english() + ", not " + shown(event, m_text)
                        + (near.empty() ? "" : "; did you mean " + quoted(near) + "?"));
        }
        m_property->set(record.ref, value);
        return true;
    }

    bool inList(const JsonEvent& event)
    {
        if (std::holds_alternative<NumberRows>(m_property->initial))
            return inRows(event);
        const Ref& ref = m_records.back().ref;
        const bool vector = std::holds_alternative<Vec3>(m_property->initial);
        if (event.type == Token::EndArray) {
            if (vector && m_vectorSize != 3)
                return flaw("must be three numbers, not " + std::to_string(m_vectorSize));
            m_property->set(ref, vector ? Value(m_vector) : Value(m_ids));
            return leave();
        }
        if (!vector)
            return readId(event, m_ids.emplace_back());
        if (event.type != Token::Number)
            return flaw("must be a number, not " + shown(event, m_text));
        if (m_vectorSize == 3)
            return flaw("is a fourth number where three belong; remove it");
        m_vector[Eigen::Index(m_vectorSize++)] = event.number;
        return true;
    }

    bool inRows(const JsonEvent& event)
    {
        if (event.type == Token::BeginArray && !m_inRow) {
            m_rows.emplace_back();
            return m_inRow = true;
        }
        if (event.type == Token::EndArray && m_inRow) {
            m_inRow = false;
            return true;
        }
        if (event.type != Token::EndArray) {
            if (!m_inRow)
                return flaw("must be a list of rows, like [[0, 1], [2, 3]]");
            if (event.type != Token::Number)
                return flaw("must be a number, not " + shown(event, m_text));
            m_rows.back().push_back(event.number);
            return true;
        }
        const Value value(m_rows);
        if (const auto reason = refusal(*m_property, value))
            return flaw(reason->english());
        m_property->set(m_records.back().ref, value);
        return leave();
    }

    bool inParameters(const JsonEvent& event)
    {
        if (event.type == Token::EndObject)
            return leave();
        if (event.type == Token::Key)
            m_parameter = event.text;
        else if (event.type != Token::Number)
            return flaw("must be a number, not " + shown(event, m_text));
        else
            std::get<Part*>(m_records.back().ref)->parameters[m_parameter] = event.number;
        return true;
    }

    std::string_view m_text;
    SceneDraft m_draft;
    std::array<std::span<const Property>, kindCount> m_properties;

    std::size_t m_end = 0; // of the event at hand
    std::size_t m_depth = 0;
    std::vector<In> m_in{In::Nothing};
    std::vector<Record> m_records;
    std::uint64_t m_fileSeen = 0;

    // what the next value is for
    Slot m_slot = Slot::Format;
    const Property* m_property = nullptr;
    Kind m_table = Kind::Particle;
    std::string m_parameter;

    // a list under way
    Vec3 m_vector = Vec3::Zero();
    std::size_t m_vectorSize = 0;
    std::vector<Id> m_ids;
    NumberRows m_rows;
    bool m_inRow = false;

    // keys that this version does not know
    JsonCapture m_unknown;
    bool m_isInUnknownItem = false; // what is kept is an item, or in one
    bool m_isAtId = false;          // and the key before was "id"
    std::string m_fileUnknown;
};

} // namespace

SceneDraft readDraft(std::string_view text) { return SceneReader(text).read(); }

} // namespace ripstop
