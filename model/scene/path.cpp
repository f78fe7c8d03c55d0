// Resolves a path from the right: the part behind the last dot is the key of a property, and what
// is before it names the settings, an id, an item, or a table of a part, tried in this order. A
// name that finds nothing is answered with the nearest one that exists, or with a list of all of
// them. assignment() adds the value and, where a density changes, the masses that follow from it
// (weigh.h).
#include "scene/path.h"

#include "scene/typed_number.h"
#include "scene/weigh.h"

#include <charconv>

namespace ripstop {
namespace {

// What is wrong with a word, and which one may be meant.
Failure unknown(const Message& what, std::string_view word,
                const std::vector<std::string_view>& candidates)
{
    const std::string_view near = nearest(word, candidates);
    if (!near.empty())
        return Failure("%1; did you mean \"%2\"?", what, near);
    std::string list;
    for (const std::string_view candidate : candidates)
        list += (list.empty() ? "" : ", ") + std::string(candidate);
    return list.empty() ? Failure(what) : Failure("%1; there is %2", what, list);
}

struct Target
{
    Kind kind;
    std::vector<Id> ids;
};

template <typename Row>
Target rowsOf(Kind kind, const std::vector<Row>& rows)
{
    Target target{kind, {}};
    for (const Row& row : rows)
        target.ids.push_back(row.id);
    return target;
}

Kind kindOf(const Item& item)
{
    return std::visit([](const auto& one) { return kindOf(ConstRef(&one)); }, item);
}

// "#17"
Result<Target> findNumbered(const Scene& scene, std::string_view name)
{
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    const bool whole = error == std::errc() && end == name.data() + name.size();
    if (const auto ref = whole ? find(scene, Id{number}) : std::nullopt)
        return Target{kindOf(*ref), {Id{number}}};
    return Failure("nothing in the scene has the id \"%1\"", name);
}

// `name` is all of the path before the property's key. Of items of one name it is the first that
// has the property.
Result<Target> findTarget(const Scene& scene, std::string_view name, std::string_view key)
{
    if (name == "settings")
        return Target{Kind::Settings, {settingsId}};
    if (name.starts_with('#'))
        return findNumbered(scene, name);

    std::vector<std::string_view> names{"settings"};
    std::optional<Target> called;
    for (const Entry& entry : scene.items) {
        names.push_back(nameOf(entry.item));
        if (names.back() != name)
            continue;
        const Target target{kindOf(entry.item), {entry.id}};
        if (findProperty(target.kind, key))
            return target;
        if (!called)
            called = target;
    }
    if (called)
        return *std::move(called);

    if (const auto dot = name.rfind('.'); dot != std::string_view::npos) {
        const std::string_view table = name.substr(dot + 1);
        for (const Entry& entry : scene.items) {
            const Part* part = std::get_if<Part>(&entry.item);
            if (!part || part->name != name.substr(0, dot))
                continue;
            if (table == kindPlural(Kind::Particle))
                return rowsOf(Kind::Particle, part->particles);
            if (table == kindPlural(Kind::Link))
                return rowsOf(Kind::Link, part->links);
            if (table == kindPlural(Kind::Panel))
                return rowsOf(Kind::Panel, part->panels);
            return Failure("part \"%1\" has particles, links and panels, not \"%2\"", part->name,
                           table);
        }
    }
    return unknown(Message("no item is called \"%1\"", name), name, names);
}

} // namespace

Result<Place> findPlace(const Scene& scene, std::string_view path)
{
    const auto dot = path.rfind('.');
    if (dot == std::string_view::npos)
        return Failure("\"%1\" is no path; write ITEM.PROPERTY, like settings.timeStep", path);

    const std::string_view key = path.substr(dot + 1);
    const Result<Target> target = findTarget(scene, path.substr(0, dot), key);
    if (!target)
        return target.failure();

    if (const Property* property = findProperty(target->kind, key))
        return Place{property, target->ids};
    std::vector<std::string_view> keys;
    for (const Property& property : propertiesOf(target->kind))
        keys.push_back(property.key);
    if (target->kind == Kind::Settings)
        return unknown(Message("settings have no property \"%1\"", key), key, keys);
    return unknown(
        Message("a %1 has no property \"%2\"", Message::word(kindName(target->kind)), key), key,
        keys);
}

std::string pathOf(const Scene& scene, Id id, const Property& property)
{
    const std::string end = '.' + std::string(property.key);
    if (property.kind == Kind::Settings)
        return "settings" + end;
    for (const Entry& entry : scene.items)
        if (entry.id == id) {
            std::string path = std::string(nameOf(entry.item)) + end;
            const auto place = findPlace(scene, path);
            if (place && place->property == &property && place->targets == std::vector{id})
                return path;
        }
    return '#' + std::to_string(std::uint32_t(id)) + end;
}

Result<Id> findNamed(const Scene& scene, Kind kind, std::string_view name)
{
    if (name.starts_with('#')) {
        const Result<Target> target = findNumbered(scene, name);
        if (!target)
            return target.failure();
        if (target->kind != kind)
            return Failure("\"%1\" is a %2, not a %3", name, Message::word(kindName(target->kind)),
                           Message::word(kindName(kind)));
        return target->ids.front();
    }
    std::vector<std::string_view> names;
    for (const Entry& entry : scene.items) {
        if (kindOf(entry.item) != kind)
            continue;
        if (nameOf(entry.item) == name)
            return entry.id;
        names.push_back(nameOf(entry.item));
    }
    if (names.empty())
        return Failure("the scene has no %1", Message::word(kindName(kind)));
    return unknown(Message("no %1 is called \"%2\"", Message::word(kindName(kind)), name), name,
                   names);
}

Result<Edit> assignment(const Scene& scene, std::string_view text)
{
    const auto equals = text.find('=');
    if (equals == std::string_view::npos)
        return Failure("\"%1\" sets nothing; write PATH=VALUE, like settings.timeStep=0.002", text);
    const Result<Place> place = findPlace(scene, text.substr(0, equals));
    if (!place)
        return place.failure();
    const Result<Value> value = valueFromText(*place->property, text.substr(equals + 1),
                                              place->property->unit, ThreeDigits::AreRefused);
    if (!value)
        return value.failure();
    return weighed(scene, {Message("Set %1", Message::word(place->property->label)),
                           {SetValues{place->property, place->targets, {*value}}}});
}

} // namespace ripstop
