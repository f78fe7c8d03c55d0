#include "camera/overlay_margins.h"

#include <QWidget>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double tall = 1.0 / 3.0;   // of the height of the view
constexpr double narrow = 1.0 / 3.0; // of its width; what is wider cannot be spared
constexpr double most = 0.3;         // of the width or height that one side may take

bool isAtSide(const QRect& child, const QWidget& view)
{
    return (child.height() >= tall * view.height() || child.height() > child.width())
           && child.width() <= narrow * view.width() && child.y() <= tall * view.height();
}

bool isBar(const QRect& child, const QWidget& view)
{
    return child.y() >= (1.0 - tall) * view.height() && child.width() > narrow * view.width()
           && child.width() > 2 * child.height();
}

} // namespace

std::vector<QRect> overlaysOf(const QWidget& view)
{
    std::vector<QRect> places;
    for (const QObject* object : view.children()) {
        const auto* child = qobject_cast<const QWidget*>(object);
        if (child && !child->isHidden() && !child->isWindow()
            && !child->geometry().contains(view.rect()))
            places.push_back(child->geometry());
    }
    return places;
}

OverlayMargins overlayMarginsOf(const QWidget& view)
{
    OverlayMargins margins;
    for (const QRect& place : overlaysOf(view)) {
        if (isBar(place, view))
            margins.bottom = std::max(margins.bottom, 1.0 - double(place.top()) / view.height());
        if (!isAtSide(place, view))
            continue;
        if (place.center().x() < view.width() / 2)
            margins.left = std::max(margins.left, double(place.right()) / view.width());
        else
            margins.right = std::max(margins.right, 1.0 - double(place.left()) / view.width());
    }
    margins.left = std::min(margins.left, most);
    margins.right = std::min(margins.right, most);
    margins.bottom = std::min(margins.bottom, most);
    return margins;
}

} // namespace ripstop
