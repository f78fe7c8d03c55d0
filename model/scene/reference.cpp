// Kinds, and finding the thing that an id names.
#include "scene/property.h"

#include <algorithm>

namespace ripstop {
namespace {

struct KindNames
{
    std::string_view one;
    std::string_view many;
};

constexpr std::array<KindNames, kindCount> names{{{"settings", "settings"},
                                                  {"particle", "particles"},
                                                  {"link", "links"},
                                                  {"panel", "panels"},
                                                  {"part", "parts"},
                                                  {"material", "materials"},
                                                  {"group", "groups"},
                                                  {"collider", "colliders"},
                                                  {"wind", "winds"},
                                                  {"control", "controls"},
                                                  {"probe", "probes"},
                                                  {"plot", "plots"}}};

} // namespace

std::string_view kindName(Kind kind) { return names[std::size_t(kind)].one; }
std::string_view kindPlural(Kind kind) { return names[std::size_t(kind)].many; }

std::optional<Kind> kindFromName(std::string_view name)
{
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i].one == name)
            return Kind(i);
    return std::nullopt;
}

bool isElement(Kind kind)
{
    return kind == Kind::Particle || kind == Kind::Link || kind == Kind::Panel;
}

ConstRef asConst(const Ref& ref)
{
    return std::visit([](const auto* object) -> ConstRef { return object; }, ref);
}

std::optional<Ref> find(Scene& scene, Id id)
{
    if (id == settingsId)
        return &scene.settings;
    for (Entry& entry : scene.items) {
        if (entry.id == id)
            return std::visit([](auto& item) -> Ref { return &item; }, entry.item);
        if (Part* part = std::get_if<Part>(&entry.item)) {
            if (Particle* row = findRow(part->particles, id))
                return row;
            if (Link* row = findRow(part->links, id))
                return row;
            if (Panel* row = findRow(part->panels, id))
                return row;
        }
    }
    return std::nullopt;
}

std::optional<ConstRef> find(const Scene& scene, Id id)
{
    const std::optional<Ref> ref = find(const_cast<Scene&>(scene), id);
    return ref ? std::optional<ConstRef>(asConst(*ref)) : std::nullopt;
}

} // namespace ripstop
