// The docks of the window, as the table has them (dock_table.h).
//
// The main window makes them before its actions, and tells them when its middle changes between
// the start page, which has the window to itself, and the view. Actions and the command line show
// docks by their ids and reach panels by their types.
#pragma once

#include "docks/dock_table.h"
#include "docks/panels.h"

#include <QList>
#include <QString>

#include <map>
#include <set>

class QAction;
class QMainWindow;

namespace ripstop {

class Docks final
{
public:
    struct Dock
    {
        DockRow row;
        QDockWidget* widget; // of the window
    };

    Docks(QMainWindow& window, const PanelParts& parts);

    const std::vector<Dock>& all() const { return m_all; } // in the order of the table

    template <typename Panel>
    Panel& panel() const
    {
        return m_panels.the<Panel>();
    }

    // brings it before the others of its area; false when there is none
    bool show(const QString& id) const;
    bool showToggled(const QAction& toggle) const; // the one that it shows and hides, likewise
    QList<QAction*> toggles() const;               // that show and hide them, by their ids

    // Puts all of them back to the places and sizes of their rows, and shows them.
    void arrange();

    // Their panels go on with what those of another window hold, which is about to go.
    void takeOver(const Docks& before);

    // Panels that show a run with some delay, to spare time, show its newest frame at once.
    void catchUp() const;

    void hideAll() const;
    void noteClosed();         // remembers those that are hidden now as closed by the user
    void showOpen() const;     // shows all but those that the user has closed
    void bringForward() const; // raises those that come forward when a scene is opened

private:
    void add(const DockRow& row, const PanelParts& parts);
    void place(const Dock& dock, const Dock* before) const;

    QMainWindow& m_window;
    std::vector<Dock> m_all;
    Panels m_panels;
    std::set<QDockWidget*> m_closed;
};

} // namespace ripstop
