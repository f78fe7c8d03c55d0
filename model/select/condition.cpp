// Finds what meets a condition, clause by clause:
// 1. condition_text.h makes clauses of the text; each finds a sorted list of ids, and "and"
//    intersects these lists.
// 2. subjectOf() resolves the key of a clause: a measurement, a property of elements, or else one
//    of items; a vector needs an axis.
// 3. Numbers are compared in the unit of the property, within rounding; words, switches, choices
//    and references are compared for equality. A link without a number of its own is asked by that
//    of its material.
// 4. Every failure names the character of the text and what could stand there.
#include "select/condition.h"

#include "scene/path.h"
#include "scene/typed_number.h"
#include "scene/units.h"
#include "select/condition_text.h"
#include "select/elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace ripstop {
namespace {

constexpr std::array elementKinds{Kind::Particle, Kind::Link, Kind::Panel};

// What a clause compares, once its key is known.
struct Subject
{
    std::vector<const Property*> properties; // one for each kind that has the key
    int axis = -1;                           // of a vector
    const Measurement::Key* measured = nullptr;
    Kinds kinds; // of `measured`
};

std::string quoted(std::string_view text)
{
    std::string result(1, '"');
    result.append(text);
    result.push_back('"');
    return result;
}

class Matcher
{
public:
    Matcher(const Scene& scene, const Measurement& measurement)
        : m_scene(scene)
        , m_measurement(measurement)
    {}

    Result<std::vector<Id>> matches(const Clause& clause);

private:
    Result<Subject> subjectOf(const Clause& clause) const;
    Message unknownKey(const Clause& clause) const;
    Result<std::vector<Id>> members(const Clause& clause) const;
    Result<std::vector<Id>> byNumber(const Clause& clause, const Subject& subject) const;
    Result<std::vector<Id>> byWord(const Clause& clause, const Subject& subject) const;
    Result<double> number(const Clause& clause, std::string_view unit) const;

    template <typename Test>
    std::vector<Id> where(const Property& property, Test test) const;

    const Scene& m_scene;
    const Measurement& m_measurement;
};

bool holds(Comparison comparison, double left, double right)
{
    switch (comparison) {
    case Comparison::Equal:
        // what was typed has fewer digits than what it is compared with
        return std::abs(left - right) <= 1e-9 * std::max(std::abs(left), std::abs(right));
    case Comparison::NotEqual:
        return !holds(Comparison::Equal, left, right);
    case Comparison::Less:
        return left < right;
    case Comparison::NotMore:
        return left <= right || holds(Comparison::Equal, left, right);
    case Comparison::More:
        return left > right;
    case Comparison::NotLess:
        return left >= right || holds(Comparison::Equal, left, right);
    case Comparison::None:
        break;
    }
    return false;
}

bool isNumber(const Property& property)
{
    return std::holds_alternative<double>(property.initial)
           || std::holds_alternative<int>(property.initial) || property.optional;
}

std::vector<std::string_view> knownKeys(const Measurement& measurement)
{
    std::vector<std::string_view> keys{"part", "group"};
    for (const Measurement::Key& key : measurement.keys)
        keys.push_back(key.key);
    for (const Property& property : allProperties())
        if (property.kind != Kind::Settings)
            keys.push_back(property.key);
    return keys;
}

// Calls visit(id, thing) for all things of a kind.
template <typename Visit>
void forEachOf(const Scene& scene, Kind kind, Visit visit)
{
    const auto rows = [&](const auto& table) {
        for (const auto& row : table)
            visit(row.id, ConstRef(&row));
    };
    for (const Entry& entry : scene.items) {
        const Part* part = std::get_if<Part>(&entry.item);
        if (kind == Kind::Particle && part)
            rows(part->particles);
        else if (kind == Kind::Link && part)
            rows(part->links);
        else if (kind == Kind::Panel && part)
            rows(part->panels);
        else if (!isElement(kind))
            std::visit(
                [&](const auto& item) {
                    if (const ConstRef ref = &item; kindOf(ref) == kind)
                        visit(entry.id, ref);
                },
                entry.item);
    }
}

Message Matcher::unknownKey(const Clause& clause) const
{
    const std::vector<std::string_view> keys = knownKeys(m_measurement);
    const std::string_view near = nearest(clause.key, keys);
    return near.empty()
               ? Message("nothing has a %1; say for example mass, restLength, material or "
                         "strain",
                         quoted(clause.key))
               : Message("nothing has a %1; did you mean %2?", quoted(clause.key), quoted(near));
}

Result<Subject> Matcher::subjectOf(const Clause& clause) const
{
    Subject subject;
    std::string_view key = clause.key;
    std::optional<Kind> only;
    if (const auto dot = key.find('.'); dot != key.npos)
        if (only = kindFromName(key.substr(0, dot)); only)
            key.remove_prefix(dot + 1);
    std::string_view name = key;
    if (key.size() > 2 && key[key.size() - 2] == '.') {
        subject.axis = int(std::string_view("xyz").find(key.back()));
        name.remove_suffix(2);
    }

    for (const Measurement::Key& measured : m_measurement.keys)
        if (measured.key == key && (!only || measured.kinds.contains(*only))) {
            subject.measured = &measured;
            subject.kinds = only ? Kinds{*only} : measured.kinds;
            return subject;
        }
    const auto add = [&](Kind kind) {
        const Property* property = findProperty(kind, name);
        if (property && kind != Kind::Settings && (!only || kind == *only))
            subject.properties.push_back(property);
    };
    for (const Kind kind : elementKinds)
        add(kind);
    for (int kind = 0; subject.properties.empty() && kind < kindCount; ++kind)
        if (!isElement(Kind(kind)))
            add(Kind(kind));
    if (subject.properties.empty())
        return failureAt(clause.keyAt, unknownKey(clause));

    const Property& property = *subject.properties.front();
    const bool isVector = std::holds_alternative<Vec3>(property.initial);
    const std::string label(name);
    if (isVector && (subject.axis < 0 || subject.axis > 2))
        return failureAt(clause.keyAt, Message("%1 has three numbers; say %2.x, %3.y or %4.z",
                                               quoted(label), label, label, label));
    if (!isVector && name != key)
        return failureAt(clause.keyAt,
                         Message("%1 has no x, y or z; say %2", quoted(label), label));
    if (std::holds_alternative<NumberRows>(property.initial)
        || std::holds_alternative<std::vector<Id>>(property.initial))
        return failureAt(
            clause.keyAt,
            Message("%1 is a list and cannot be compared; choose another property", quoted(label)));
    return subject;
}

// The ids of the things whose value passes the test. Where a link leaves a value to its material,
// that of the material is tested.
template <typename Test>
std::vector<Id> Matcher::where(const Property& property, Test test) const
{
    std::vector<Id> ids;
    const Property* general = ofMaterial(property);
    std::map<Id, Value> inherited;
    if (general)
        for (const Entry& entry : m_scene.items)
            if (const auto* material = std::get_if<Material>(&entry.item))
                inherited.emplace(entry.id, general->get(material));
    forEachOf(m_scene, property.kind, [&](Id id, const ConstRef& ref) {
        const Value value = property.get(ref);
        if (!std::holds_alternative<std::monostate>(value)) {
            if (test(value))
                ids.push_back(id);
        } else if (!inherited.empty()) {
            const auto found = inherited.find(std::get<const Link*>(ref)->material);
            if (found != inherited.end() && test(found->second))
                ids.push_back(id);
        }
    });
    return ids;
}

Result<double> Matcher::number(const Clause& clause, std::string_view unit) const
{
    if (clause.comparison == Comparison::None)
        return failureAt(
            clause.keyAt + clause.key.size(),
            Message("%1 is a number; go on with <, > or = and a value", quoted(clause.key)));
    const Typed typed = typedValue(clause.value, unit);
    if (typed.number)
        return typed.number->number;
    if (typed.unit.empty() || typed.at == 0) // no number in front of it
        return failureAt(clause.valueAt,
                         clause.value.empty()
                             ? Message("a number is missing; write one, as in %1 > 1", clause.key)
                             : Message("%1 is not a number; write one, as in %2 > 1",
                                       quoted(clause.value), clause.key));
    std::string units;
    for (const std::string& other : unitsLike(unit))
        units += (units.empty() ? "" : ", ") + other;
    return failureAt(
        clause.valueAt + typed.at,
        Message("%1 is not a unit of %2; %3", quoted(typed.unit), clause.key,
                units.empty() ? Message("leave it out") : Message("use one of %1", units)));
}

Result<std::vector<Id>> Matcher::byNumber(const Clause& clause, const Subject& subject) const
{
    std::vector<Id> ids;
    if (const Measurement::Key* key = subject.measured) {
        const auto typed = number(clause, key->unit);
        if (!typed)
            return typed.failure();
        for (const Kind kind : elementKinds) {
            if (!subject.kinds.contains(kind) || !m_measurement.read)
                continue;
            const Measurement::Reading reading = m_measurement.read(*key, kind);
            for (std::size_t i = 0; i < reading.ids.size(); ++i)
                if (holds(clause.comparison, reading.values[i], *typed))
                    ids.push_back(reading.ids[i]);
        }
        return ids;
    }
    for (const Property* property : subject.properties) {
        const auto typed = number(clause, property->unit);
        if (!typed)
            return typed.failure();
        const auto found = where(*property, [&](const Value& value) {
            if (const double* real = std::get_if<double>(&value))
                return holds(clause.comparison, *real, *typed);
            if (const int* whole = std::get_if<int>(&value))
                return holds(clause.comparison, *whole, *typed);
            if (const Vec3* vector = std::get_if<Vec3>(&value))
                return holds(clause.comparison, (*vector)[subject.axis], *typed);
            return false;
        });
        ids.insert(ids.end(), found.begin(), found.end());
    }
    return ids;
}

// Matches switches, choices, texts, and references by name or number.
Result<std::vector<Id>> Matcher::byWord(const Clause& clause, const Subject& subject) const
{
    const Property& first = *subject.properties.front();
    const bool isSwitch = std::holds_alternative<bool>(first.initial);
    if (clause.comparison == Comparison::None && !isSwitch)
        return failureAt(clause.keyAt + clause.key.size(),
                         Message("go on with = and a value, as in %1 = %2", clause.key,
                                 first.choices.empty()
                                     ? Message("name")
                                     : Message::verbatim(std::string(first.choices.front()))));
    if (clause.comparison != Comparison::None && clause.comparison != Comparison::Equal
        && clause.comparison != Comparison::NotEqual)
        return failureAt(clause.comparisonAt, Message("%1 is not a number; compare it with = or !=",
                                                      quoted(clause.key)));

    Value wanted;
    if (std::holds_alternative<Id>(first.initial) && !clause.value.starts_with('#')
        && first.pointsAt.contains(Kind::Material)) {
        const auto id = findNamed(m_scene, Kind::Material, clause.value);
        if (!id)
            return failureAt(clause.valueAt, id.message());
        wanted = *id;
    } else {
        std::string text = clause.comparison != Comparison::None ? clause.value
                           : clause.negated                      ? "false"
                                                                 : "true";
        if (std::holds_alternative<Id>(first.initial) && text.starts_with('#'))
            text = text.substr(1);
        if (!first.choices.empty())
            std::ranges::replace(text, ' ', '_');
        const auto value = valueFromText(first, text);
        if (!value)
            return failureAt(clause.valueAt, value.message());
        wanted = *value;
    }
    const bool equal = clause.comparison != Comparison::NotEqual;
    std::vector<Id> ids;
    for (const Property* property : subject.properties) {
        const auto found =
            where(*property, [&](const Value& value) { return (value == wanted) == equal; });
        ids.insert(ids.end(), found.begin(), found.end());
    }
    return ids;
}

// Matches membership, as in "part = kite" or "group = edge".
Result<std::vector<Id>> Matcher::members(const Clause& clause) const
{
    const Kind kind = clause.key == "part" ? Kind::Part : Kind::Group;
    if (clause.comparison != Comparison::Equal && clause.comparison != Comparison::NotEqual)
        return failureAt(clause.keyAt + clause.key.size(),
                         Message("go on with = and the name of a %1", Message::word(clause.key)));
    const auto holder = findNamed(m_scene, kind, clause.value);
    if (!holder)
        return failureAt(clause.valueAt, holder.message());
    std::vector<Id> ids = elementsOf(m_scene, {*holder});
    if (clause.comparison == Comparison::Equal)
        return ids;
    std::vector<Id> others;
    std::ranges::set_difference(everyElement(m_scene).ids(), ids, std::back_inserter(others));
    return others;
}

Result<std::vector<Id>> Matcher::matches(const Clause& clause)
{
    if (clause.key == "part" || clause.key == "group")
        return members(clause);
    const auto subject = subjectOf(clause);
    if (!subject)
        return subject.failure();
    const bool counts =
        subject->measured || isNumber(*subject->properties.front()) || subject->axis >= 0;
    if (clause.negated
        && (counts || !std::holds_alternative<bool>(subject->properties.front()->initial)
            || clause.comparison != Comparison::None))
        return failureAt(clause.keyAt,
                         Message("\"not\" goes with a switch, as in not pinned; elsewhere "
                                 "compare with !="));
    return counts ? byNumber(clause, *subject) : byWord(clause, *subject);
}

} // namespace

Result<std::vector<Id>> matching(const Scene& scene, const Measurement& measurement,
                                 std::string_view text)
{
    const auto clauses = clausesOf(text);
    if (!clauses)
        return clauses.failure();
    std::vector<Id> ids;
    bool first = true;
    for (const Clause& clause : *clauses) {
        auto found = Matcher(scene, measurement).matches(clause);
        if (!found)
            return found;
        if (!std::ranges::is_sorted(*found))
            std::ranges::sort(*found);
        found->erase(std::unique(found->begin(), found->end()), found->end());
        std::vector<Id> both;
        if (!first)
            std::ranges::set_intersection(ids, *found, std::back_inserter(both));
        ids = first ? std::move(*found) : std::move(both);
        first = false;
    }
    return ids;
}

std::vector<ConditionKey> conditionKeys(const Measurement& measurement)
{
    std::vector<ConditionKey> keys;
    for (const Measurement::Key& key : measurement.keys)
        keys.push_back(
            {std::string(key.key), std::string(key.unit), std::string(key.help), key.kinds});
    for (const Kind kind : elementKinds)
        for (const Property& property : propertiesOf(kind)) {
            const bool isVector = std::holds_alternative<Vec3>(property.initial);
            for (const char* axis : {".x", ".y", ".z"})
                if (isVector || std::string_view(axis) == ".x")
                    keys.push_back({std::string(property.key) + (isVector ? axis : ""),
                                    std::string(property.unit), std::string(property.help),
                                    Kinds{kind}});
        }
    return keys;
}

} // namespace ripstop
