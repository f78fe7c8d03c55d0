#include "dialogs/beside.h"

#include <QWidget>

namespace ripstop {
namespace {

constexpr int fromEdge = 24;     // pixels
constexpr int belowToolBar = 96; // pixels, from the upper edge

} // namespace

void moveBesideDesign(QWidget& dialog, const QWidget* window)
{
    if (window)
        dialog.move(window->geometry().right() - dialog.width() - fromEdge,
                    window->geometry().top() + belowToolBar);
}

} // namespace ripstop
