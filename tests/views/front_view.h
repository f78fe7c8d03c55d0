// A view from the front, and a red panel that fills the middle of it, for tests that look at
// pixels.
//
// Ids of the panel stand above its function. Whoever makes a view has to run by runWithView().
#pragma once

#include "views/bare_view.h"

#include <QColor>
#include <QImage>

#include <utility>

namespace ripstop {

// One red panel that fills the middle of a picture taken from the front. Ids: part 1, particles
// 2, 3, 4, panel 5, material 6.
inline Scene redPanel()
{
    Scene scene;
    Part part;
    part.particles.push_back({.id = Id{2}, .position = Vec3(-1, -1, 0), .pinned = true});
    part.particles.push_back({.id = Id{3}, .position = Vec3(1, -1, 0), .pinned = true});
    part.particles.push_back({.id = Id{4}, .position = Vec3(0, 1, 0), .pinned = true});
    part.panels.push_back({Id{5}, Id{2}, Id{3}, Id{4}, Id{6}});
    Material material;
    material.color = "#ff0000";
    scene.items = {{Id{1}, part}, {Id{6}, material}};
    scene.nextId = Id{7};
    return scene;
}

inline bool isReddish(const QColor& color)
{
    return color.red() > 2 * color.green() && color.red() > 2 * color.blue();
}

struct FrontView : BareView
{
    explicit FrontView(Scene scene)
        : BareView(std::move(scene), {400, 300})
    {
        viewport.view(PresetView::Front);
    }

    QColor middle()
    {
        const QImage image = viewport.image(); // more pixels than points on a fine screen
        return image.pixelColor(image.width() / 2, image.height() * 8 / 15);
    }
};

} // namespace ripstop
