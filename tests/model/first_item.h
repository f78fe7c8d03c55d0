// The first item of a kind in a scene, for tests that have one and change it. The scene must have
// one.
#pragma once

#include "scene/scene.h"

#include <QtGlobal>

namespace ripstop {

template <typename T>
T& firstOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (T* item = std::get_if<T>(&entry.item))
            return *item;
    qFatal("no such item");
}

} // namespace ripstop
