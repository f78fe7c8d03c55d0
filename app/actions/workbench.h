// What actions act on: the design, the run, the view, the panels and the flows of the window.
//
// The main window makes one and the rows of the menus keep references into it, so it lives as long
// as they do. A panel needs no member here: an action reaches it by its type, through the docks.
#pragma once

#include <functional>

class QMainWindow;

namespace ripstop {

class Actions;
class Arrivals;
class Dialogs;
class Docks;
class Document;
struct DrawSettings;
class Files;
class Player;
class Recordings;
class RunFiles;
class Selection;
class Viewport;
enum class Language;

inline constexpr int messageTime = 8000; // ms, that the status bar shows what an action says

struct Workbench
{
    QMainWindow& window;
    Document& document;
    Selection& selection;
    Player& player;
    Recordings& recordings;
    Viewport& viewport;
    DrawSettings& drawSettings;
    Docks& docks;
    Files& files;
    RunFiles& runFiles;
    Arrivals& arrivals;
    Dialogs& dialogs;
    Actions& actions; // by their ids; there once all rows have been made
    std::function<void()> showStartPage;
    std::function<void()> showTour;
    std::function<void()> resetLayout;
    // called when a tool has changed how hard hands pull or blow, or how wide the brush is
    std::function<void()> toolChanged;
    std::function<void(Language)> speak; // from now on
};

} // namespace ripstop
