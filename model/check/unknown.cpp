#include "check/unknown.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace ripstop {
namespace {

struct Places
{
    Id first{};
    std::size_t count = 0;
};

// The file itself has no kind.
using KeyOfKind = std::pair<std::optional<Kind>, std::string>;

std::map<KeyOfKind, Places> unknownKeys(const Scene& scene, const ElementIndex& index)
{
    std::map<KeyOfKind, Places> keys;
    for (const auto& [id, text] : scene.unknown) {
        const auto object = nlohmann::json::parse(text, nullptr, false);
        const std::optional<Kind> kind = id == settingsId ? Kind::Settings : index.kindOf(id);
        if (!object.is_object() || (id != noId && !kind))
            continue; // of what has been removed since it was read
        for (const auto& [key, value] : object.items()) {
            Places& places = keys[{kind, key}];
            if (places.count++ == 0)
                places.first = id;
        }
    }
    return keys;
}

Message whereKeyIs(const std::optional<Kind>& kind, const Places& places)
{
    if (!kind)
        return Message("File");
    if (*kind == Kind::Settings)
        return Message("Settings");
    return places.count == 1
               ? subjectOf(*kind, places.first)
               : Message("%1 and others, %2 in all", subjectOf(*kind, places.first), places.count);
}

std::string_view nearestKey(const std::optional<Kind>& kind, std::string_view key)
{
    if (!kind)
        return {};
    std::vector<std::string_view> known;
    for (const Property& property : propertiesOf(*kind))
        known.push_back(property.key);
    return nearest(key, known);
}

} // namespace

const UnknownItem* findUnknownItem(const Scene& scene, Id id)
{
    const auto found = std::ranges::find(scene.unknownItems, id, &UnknownItem::id);
    return found != scene.unknownItems.end() ? &*found : nullptr;
}

Message unknownText(const UnknownItem& item)
{
    return Message("Item %1 is of the type %2, which this version does not know; it is kept as it "
                   "is and does nothing.",
                   std::uint32_t(item.id), item.type);
}

void checkUnknown(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    for (const UnknownItem& item : scene.unknownItems)
        add("unknown", Severity::Warning, unknownText(item), noId);
    if (scene.unknown.empty())
        return;
    for (const auto& [keyOfKind, places] : unknownKeys(scene, index)) {
        const auto& [kind, key] = keyOfKind;
        const Message where = whereKeyIs(kind, places);
        const std::string_view near = nearestKey(kind, key);
        const Id culprit = kind && *kind != Kind::Settings ? places.first : noId;
        add("unknown", Severity::Warning,
            near.empty()
                ? Message("%1: this version does not know the key \"%2\"; it is kept as it is and "
                          "does nothing.",
                          where, key)
                : Message("%1: this version does not know the key \"%2\"; it is kept as it is and "
                          "does nothing. Did you mean \"%3\"?",
                          where, key, near),
            culprit);
    }
}

} // namespace ripstop
