// In order: names of tables and types; a part by its builder's parameters, its tables and their
// rows; and the whole, which is put in order at the end.
#include "author/scene_difference.h"

#include "author/property_difference.h"
#include "author/rebuild.h"
#include "scene/said_number.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

Message tableName(Kind kind)
{
    return kind == Kind::Particle ? Message("particles")
           : kind == Kind::Link   ? Message("links")
                                  : Message("panels");
}

Message itemTypeName(Kind kind)
{
    std::string name(kindName(kind));
    name[0] = char(name[0] - 'a' + 'A');
    return Message::word(name);
}

// --- parts --------------------------------------------------------------------------------------

// Nothing where it is a number.
std::optional<Message> choiceInWords(const Builder* builder, const std::string& key, double value)
{
    if (builder)
        for (const Parameter& parameter : builder->parameters)
            if (parameter.key == key && value >= 0.0 && value < double(parameter.choices.size()))
                return Message::verbatim(std::string(parameter.choices[std::size_t(value)]));
    return std::nullopt;
}

Message changeOfParameter(const Builder* builder, const Message& subject, const std::string& key,
                          double from, double to, const std::string& unit)
{
    const Message what = Message::verbatim(key);
    const auto first = choiceInWords(builder, key, from), second = choiceInWords(builder, key, to);
    return first && second ? changeInWords(subject, what, *first, *second, unit)
                           : changeOfNumber(subject, what, from, to, unit);
}

std::string unitOf(const Builder* builder, const std::string& key)
{
    if (!builder)
        return {};
    for (const Parameter& parameter : builder->parameters)
        if (parameter.key == key)
            return std::string(parameter.unit);
    const TableParameter* table = builder->table;
    return table && key.starts_with(std::string(table->key) + ".") ? std::string(table->unit) : "";
}

// What is not said is as the builder has it at first.
Parameters allParameters(const Part& part)
{
    Parameters all = part.parameters;
    if (const Builder* builder = builderOf(part))
        for (const auto& [key, value] : unsaid(*builder))
            all.emplace(key, value);
    return all;
}

// True when the two were built differently, so that their rows tell nothing more.
bool compareBuilders(Differences& list, const Entry& a, const Entry& b)
{
    const Part& first = std::get<Part>(a.item);
    const Part& second = std::get<Part>(b.item);
    const Message subject = Message::verbatim(first.name);
    if (first.builder != second.builder) {
        const auto name = [](const std::string& builder) {
            return builder.empty() ? Message("by hand") : Message::verbatim(builder);
        };
        list.push_back({DifferenceKind::Parameter,
                        Kind::Part,
                        first.name,
                        std::string(propertyOf<&Part::builder>().key),
                        {},
                        first.builder,
                        second.builder,
                        {a.id},
                        {b.id},
                        changeInWords(subject, Message("built"), name(first.builder),
                                      name(second.builder), {})});
        return true;
    }
    const Builder* builder = builderOf(first);
    Parameters from = allParameters(first), to = allParameters(second);
    const std::size_t before = list.size();
    for (const auto& [key, value] : to)
        from.try_emplace(key, NAN);
    for (const auto& [key, value] : from) {
        const auto found = to.find(key);
        const double other = found == to.end() ? NAN : found->second;
        if (value == other)
            continue;
        const std::string unit = unitOf(builder, key);
        list.push_back({DifferenceKind::Parameter,
                        Kind::Part,
                        first.name,
                        key,
                        unit,
                        value,
                        other,
                        {a.id},
                        {b.id},
                        changeOfParameter(builder, subject, key, value, other, unit)});
    }
    return list.size() > before;
}

// What hands have done to a part that was built differently besides; its rows cannot be compared.
void tellHandWork(Differences& list, const TwoScenes& scenes, const Entry& a, const Entry& b)
{
    const auto count = [](const Scene& scene, const Entry& entry) {
        if (!builderOf(std::get<Part>(entry.item)))
            return 0;
        return int(handWork(scene, entry.id).count());
    };
    const int before = count(scenes.first, a), after = count(scenes.second, b);
    if (before == 0 && after == 0)
        return;
    const std::string& name = nameOf(a.item);
    list.push_back(
        {DifferenceKind::ByHand,
         Kind::Part,
         name,
         "by_hand",
         {},
         before,
         after,
         {a.id},
         {b.id},
         Message("%1: changed by hand besides, %2 -> %3 elements", name, before, after)});
}

template <typename Row>
void compareTables(Differences& list, const TwoScenes& scenes, const Entry& a, const Entry& b,
                   std::vector<Row> Part::*table, bool asBuilt)
{
    const std::vector<Row>& first = std::get<Part>(a.item).*table;
    const std::vector<Row>& second = std::get<Part>(b.item).*table;
    const std::string& name = nameOf(a.item);
    const Kind kind = kindOfType<Row>;
    std::vector<Id> gone, come;
    RowPairs<Row> pairs;
    for (const Row& row : first) {
        const auto found = scenes.pairs.secondOf.find(row.id);
        if (found == scenes.pairs.secondOf.end())
            gone.push_back(row.id);
        else
            pairs.emplace_back(&row, findRow(second, found->second));
    }
    std::vector<Id> kept;
    for (const auto& pair : pairs)
        kept.push_back(pair.second->id);
    for (const Row& row : second)
        if (!std::ranges::binary_search(kept, row.id))
            come.push_back(row.id);

    const std::string key(kindPlural(kind));
    const Value from = int(first.size()), to = int(second.size());
    const auto add = [&](const Message& text) {
        list.push_back({DifferenceKind::Count, kind, name, key, {}, from, to, gone, come, text});
    };
    if (asBuilt || pairs.empty()) { // nothing tells which of the rows went and came
        if (first.size() != second.size())
            add(changeInWords(Message::verbatim(name), tableName(kind), Message("%1", first.size()),
                              Message("%1", second.size()), {}));
        return;
    }
    if (!gone.empty() || !come.empty())
        add(Message("%1: %2 added %3, removed %4", name, tableName(kind), come.size(),
                    gone.size()));
    compareRows(list, scenes, name, pairs);
}

void comparePart(Differences& list, const TwoScenes& scenes, const Entry& a, const Entry& b)
{
    const bool asBuilt = compareBuilders(list, a, b);
    if (asBuilt)
        tellHandWork(list, scenes, a, b);
    compareTables(list, scenes, a, b, &Part::particles, asBuilt);
    compareTables(list, scenes, a, b, &Part::links, asBuilt);
    compareTables(list, scenes, a, b, &Part::panels, asBuilt);
}

// --- the whole ----------------------------------------------------------------------------------

void tellItem(Differences& list, DifferenceKind what, const Entry& entry)
{
    const bool added = what == DifferenceKind::Added;
    const Kind kind =
        kindOf(std::visit([](const auto& item) { return ConstRef(&item); }, entry.item));
    const std::string& name = nameOf(entry.item);
    Message text = added ? Message("%1 added: %2", itemTypeName(kind), name)
                         : Message("%1 removed: %2", itemTypeName(kind), name);
    if (const Part* part = std::get_if<Part>(&entry.item))
        text = Message("%1 (%2 particles, %3 links, %4 panels)", text, part->particles.size(),
                       part->links.size(), part->panels.size());
    const std::vector<Id> here{entry.id}, nowhere;
    list.push_back(
        {what, kind, name, {}, {}, {}, {}, added ? nowhere : here, added ? here : nowhere, text});
}

// Parts and what they are, what they are made of, what blows and how it is solved, what is around,
// what is measured, and last what only the view shows.
int importanceOf(const SceneDifference& difference)
{
    if (difference.what == DifferenceKind::Unknown)
        return 100;
    const Property* property = findProperty(difference.kind, difference.key);
    if (difference.what == DifferenceKind::Property && property
        && property->effect == Effect::DisplayOnly)
        return 90;
    switch (difference.kind) {
    case Kind::Part:
    case Kind::Particle:
    case Kind::Link:
    case Kind::Panel:
        return 0 + int(difference.what);
    case Kind::Material:
        return 10;
    case Kind::Wind:
        return 20;
    case Kind::Settings:
        return 30;
    case Kind::Collider:
        return 40;
    case Kind::Control:
        return 50;
    case Kind::Group:
        return 60;
    case Kind::Probe:
        return 70;
    case Kind::Plot:
        return 80;
    }
    return 100;
}

} // namespace

Differences differencesOf(const Scene& first, const Scene& second)
{
    const ScenePairs pairs = pairsOf(first, second);
    const TwoScenes scenes{first, second, pairs};
    Differences list;
    for (const Entry* entry : pairs.onlyFirst)
        tellItem(list, DifferenceKind::Removed, *entry);
    for (const Entry* entry : pairs.onlySecond)
        tellItem(list, DifferenceKind::Added, *entry);
    for (const auto& [a, b] : pairs.items) {
        if (std::holds_alternative<Part>(a->item))
            comparePart(list, scenes, *a, *b);
        std::visit(
            [&, &one = a, &other = b](const auto& item) {
                using Type = std::decay_t<decltype(item)>;
                compareThing(list, scenes, item.name, one->id, other->id, &item,
                             &std::get<Type>(other->item));
            },
            a->item);
    }
    compareThing(list, scenes, "settings", settingsId, settingsId, &first.settings,
                 &second.settings);
    if (first.unknown != second.unknown || first.unknownItems != second.unknownItems)
        list.push_back({DifferenceKind::Unknown,
                        Kind::Settings,
                        {},
                        {},
                        {},
                        {},
                        {},
                        {},
                        {},
                        Message("What this version does not know of the two files differs")});
    std::ranges::stable_sort(list, {}, importanceOf);
    return list;
}

Message sizeOf(const Scene& scene)
{
    std::size_t particles = 0, links = 0, panels = 0;
    double mass = 0.0;
    forEachPart(scene, [&](Id, const Part& part) {
        particles += part.particles.size();
        links += part.links.size();
        panels += part.panels.size();
        for (const Particle& particle : part.particles)
            mass += particle.mass;
    });
    return Message("%1 particles, %2 links, %3 panels, %4", particles, links, panels,
                   saidNumber(mass, "kg"));
}

} // namespace ripstop
