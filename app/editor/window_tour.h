// The tour of the window: where it stops, and over which design.
//
// It goes to the view, what stands beside it, the bar that flies it, what stands below, and the
// menus. The stops at docks are those of their table (docks/dock_table.h).
#pragma once

#include <functional>

class QMainWindow;
class QWidget;

namespace ripstop {

class Docks;
class Document;
class Files;
class Viewport;

struct TouredWindow
{
    QMainWindow& window;
    Document& document;
    Files& files;
    Viewport& viewport;
    QWidget& transport;
    Docks& docks;
    std::function<void()> showScene;
};

// Shows the tour over the design that is open, or over a sample when there is none.
void showTour(const TouredWindow& toured);

} // namespace ripstop
