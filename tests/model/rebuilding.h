// Parts of builders in scenes, built again; the functions end the test that calls them where that
// fails.
#pragma once

#include "author/rebuild.h"
#include "shaping/insert.h"

#include <QtTest>

namespace ripstop::rebuilding {

inline Scene built(const char* name, const Parameters& given = {})
{
    const Result<Scene> scene = build(*findBuilder(name), given);
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

inline Id partId(const Scene& scene, std::size_t index = 0)
{
    std::vector<Id> ids;
    forEachPart(scene, [&](Id id, const Part&) { ids.push_back(id); });
    return ids[index];
}

inline const Part& part(const Scene& scene, std::size_t index = 0)
{
    return *findItem<Part>(scene, partId(scene, index));
}

template <typename T>
T* itemNamed(Scene& scene, std::string_view name)
{
    for (Entry& entry : scene.items)
        if (T* item = std::get_if<T>(&entry.item); item && item->name == name)
            return item;
    return nullptr;
}

// The scene after the edit; the inverse must lead back, but for the counter of ids.
inline Scene after(Scene scene, const Edit& edit)
{
    Scene back = scene;
    const Edit inverse = apply(back, edit);
    const Scene changed = back;
    (void)apply(back, inverse);
    back.nextId = scene.nextId;
    if (!(back == scene))
        qFatal("undo does not restore the scene");
    return changed;
}

inline Scene inserting(const Scene& scene, const char* name, InsertWish wish = {},
                       const Parameters& given = {})
{
    wish.label = name;
    return after(scene, inserted(groundOf(scene), built(name, given), wish).edit);
}

inline Scene changing(const Scene& scene, const Parameters& given, std::size_t index = 0)
{
    Parameters parameters = chosenNow(scene, partId(scene, index)).parameters;
    for (const auto& [key, value] : given)
        parameters[key] = value;
    const Result<Rebuilt> again = rebuilt(scene, partId(scene, index), parameters);
    if (!again)
        qFatal("%s", again.message().english().c_str());
    return after(scene, again->edit);
}

} // namespace ripstop::rebuilding
