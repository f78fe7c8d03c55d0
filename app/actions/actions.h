// Everything that a user can do from a menu, a tool bar or a key, as one table.
#pragma once

#include "actions/key_map.h"

#include <QIcon>
#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <vector>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace ripstop {

class Dialogs;
class Document;
struct DrawSettings;
class Files;
class Inspector;
class Outline;
class Player;
class Recordings;
class RunFiles;
class Selection;
class Timeline;
class TuningPanel;
class Viewport;

// What actions act on.
struct Workbench
{
    QMainWindow& window;
    Document& document;
    Selection& selection;
    Player& player;
    Viewport& viewport;
    Outline& outline;
    Files& files;
    Dialogs& dialogs;
    TuningPanel& tuning;
    Inspector& inspector;
    DrawSettings& drawSettings;
    Recordings& recordings;
    Timeline& timeline;
    RunFiles& runFiles;
    std::function<void()> showStartPage;
    std::function<void()> importMesh;
    std::function<void()> showTour;
    std::function<void(const QString&)> showDock; // by its id
    std::function<void(const QString& builder)> insert;
    std::function<void()> handsChanged; // how hard they pull and blow
};

class Actions final : public QObject
{
    Q_OBJECT

public:
    Actions(const Workbench& bench, KeyMap::Memory keys);

    QAction* operator[](const QString& id) const { return m_byId.at(id); }
    QAction* find(const QString& id) const // null when there is none
    {
        const auto found = m_byId.find(id);
        return found == m_byId.end() ? nullptr : found->second;
    }
    const std::vector<QAction*>& all() const { return m_all; }
    KeyMap& keys() const { return *m_keys; }

    void addDockToggle(QAction* toggle); // to View > Panels

    // What the View menu shows and hides, from run to run.
    void keepView() const;
    void restoreView();

private:
    void build();
    void keepCurrent(); // enabled, checked and worded as things are
    void fillRecent();
    void fillTemplates();

    Workbench m_bench;
    std::map<QString, QAction*> m_byId;
    std::vector<QAction*> m_all;
    std::vector<QAction*> m_needSelection;
    std::vector<QAction*> m_viewToggles;
    KeyMap* m_keys = nullptr;
    QMenu* m_recent = nullptr;
    QMenu* m_templates = nullptr;
    QMenu* m_panels = nullptr;
};

} // namespace ripstop
