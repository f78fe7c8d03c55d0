#include "dialogs/beside.h"

#include <QWidget>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int fromEdge = 24;     // pixels
constexpr int belowToolBar = 96; // pixels, from the upper edge

} // namespace

void moveBesideDesign(QWidget& dialog, const QWidget* window)
{
    if (!window)
        return;
    // one that is not shown yet grows to what its words need, in French more than in English
    const int width = std::max(dialog.width(), dialog.minimumSizeHint().width());
    dialog.move(window->geometry().right() - width - fromEdge,
                window->geometry().top() + belowToolBar);
}

} // namespace ripstop
