#include "viewport/covered.h"

#include <QWidget>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double tall = 1.0 / 3.0;   // of the height of the view
constexpr double narrow = 1.0 / 3.0; // of its width; what is wider cannot be spared
constexpr double most = 0.3;         // of the width that one side may take

} // namespace

Covered coveredOf(const QWidget& view)
{
    Covered covered;
    for (const QObject* object : view.children()) {
        const auto* child = qobject_cast<const QWidget*>(object);
        if (!child || child->isHidden() || child->height() < tall * view.height()
            || child->width() > narrow * view.width() || child->y() > tall * view.height())
            continue;
        const QRect place = child->geometry();
        if (place.center().x() < view.width() / 2)
            covered.left = std::max(covered.left, double(place.right()) / view.width());
        else
            covered.right = std::max(covered.right, 1.0 - double(place.left()) / view.width());
    }
    covered.left = std::min(covered.left, most);
    covered.right = std::min(covered.right, most);
    return covered;
}

} // namespace ripstop
