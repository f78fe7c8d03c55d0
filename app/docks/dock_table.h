// The table of docks. A dock is a row here and nothing elsewhere.
//
// What follows from a row: where the dock stands and how large it is at first, behind which others
// it lies, its toggle in the View menu, its name for --dock and for actions that show it, the place
// in remembered layouts, the stop of the tour, and that actions reach its panel by its type
// (Docks::panel). Only the docks read the table.
#pragma once

#include <QString>
#include <Qt>

#include <functional>
#include <vector>

class QDockWidget;
class QWidget;

namespace ripstop {

class Document;
class Panels;
class Player;
class Recordings;
class Selection;

// What panels are made of.
struct PanelParts
{
    Document& document;
    Selection& selection;
    Player& player;
    Recordings& recordings;
    std::function<void(const QString& message)> say; // in the status bar
    std::function<bool()> saveDesign; // to a file of its own, as it is; false when it is not
};

// What a dock does when a scene is opened.
enum class OnOpening { Stays, ComesForward };

struct DockRow
{
    const char* id; // never renamed: remembered layouts know docks by it
    QString title;
    Qt::DockWidgetArea area; // rows of one area are tabs, in their order, with the first in front
    int size;                // px, of the area at first: width at a side, height below; 0: no wish
    OnOpening onOpening;
    // Makes the panel from the parts and from panels of the rows above. The dock becomes its
    // parent; what the dock itself does, such as to come forward, is connected here as well.
    QWidget* (*make)(const PanelParts& parts, const Panels& above, QDockWidget& dock);
    QString tourTitle; // empty: the tour does not stop here
    QString tourText;
};

std::vector<DockRow> dockTable();

} // namespace ripstop
