// Everything that a user can do from a menu, a tool bar or a key, as one table.
#pragma once

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

class Document;
struct DrawSettings;
class Files;
class Inspector;
class Outline;
class Player;
class Selection;
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
    std::function<void()> showStartPage;
    std::function<void()> showKeys;
    std::function<void()> showVerification;
    std::function<void()> showPolar;
    std::function<void()> showCondition;
    std::function<void()> importMesh;
    std::function<void()> showPalette;
    std::function<void()> showTour;
    std::function<void(const QString&)> showDock; // by its id
    TuningPanel& tuning;
    Inspector& inspector;
    std::function<void()> showRigidity;
    DrawSettings& drawSettings;
};

class Actions final : public QObject
{
    Q_OBJECT

public:
    explicit Actions(const Workbench& bench);

    QAction* operator[](const QString& id) const { return m_byId.at(id); }
    const std::vector<QAction*>& all() const { return m_all; }

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
    QMenu* m_recent = nullptr;
    QMenu* m_templates = nullptr;
    QMenu* m_panels = nullptr;
};

} // namespace ripstop
