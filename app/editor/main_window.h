#pragma once

#include "actions/actions.h"
#include "actions/dialogs.h"
#include "files/files.h"
#include "tools/draw_tool.h"

#include <QMainWindow>
#include <QTimer>

#include <map>
#include <set>

class QLabel;
class QStackedWidget;

namespace ripstop {

class Autosave;
class ControlKeys;
class Document;
class HandBar;
class Inspector;
class Outline;
class PlotPanel;
class Player;
class ProblemList;
class Selection;
class SheetPanel;
class Recordings;
class RunFiles;
class StartPage;
class Timeline;
class Transport;
class TuningPanel;
class Viewport;

// Places the docks and menus; no logic. The view or the start page in the middle, the outline on
// the left, the inspector on the right, plots, problems and controls below.
class MainWindow final : public QMainWindow
{
    Q_OBJECT

public:
    enum class Memory { Keep, Ignore }; // of places and sizes, from run to run

    MainWindow(Document& document, Selection& selection, Player& player, Memory memory);

    Viewport& viewport() { return *m_viewport; }
    Files& files() { return *m_files; }
    RunFiles& runFiles() { return *m_runFiles; }
    Recordings& recordings() { return *m_recordings; }
    Timeline& timeline() { return *m_timeline; }
    Actions& actions() { return *m_actions; }
    TuningPanel& tuning() { return *m_tuning; }
    Inspector& inspector() { return *m_inspector; }
    bool showDock(const QString& id); // in front of those that share its place; if there is one

    void showScene();
    void showStartPage();
    void showViewOnly();                  // for pictures
    void importMesh(const QString& file); // empty: asks for one
    void insert(const QString& builder);  // into the open scene
    void openRun(const QString& file);    // a recording

    // Keeps copies of unsaved work in that folder, and asks about those that were left behind
    // there.
    void keepWork(const QString& folder);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildDocks();
    void buildActions();
    void buildToolBar();
    void buildStatusBar();
    void connectParts();
    void addDock(const QString& id, const QString& title, QWidget* widget, Qt::DockWidgetArea area);
    void restoreLayout();
    void showTitle();
    void showCounts();
    void showTour();
    void showSelected();
    QString summary(const std::vector<Id>& ids) const;

    Document& m_document;
    Selection& m_selection;
    Player& m_player;
    Memory m_memory;
    DrawSettings m_drawSettings;

    Recordings* m_recordings;
    Viewport* m_viewport;
    StartPage* m_start;
    QStackedWidget* m_middle;
    Outline* m_outline;
    Inspector* m_inspector;
    PlotPanel* m_plots;
    ProblemList* m_problems;
    Transport* m_transport;
    TuningPanel* m_tuning;
    SheetPanel* m_table;
    Timeline* m_timeline;
    Files* m_files;
    RunFiles* m_runFiles;
    Dialogs m_dialogs;
    QToolBar* m_toolBar = nullptr;
    Actions* m_actions = nullptr;
    Autosave* m_autosave = nullptr;
    HandBar* m_handBar = nullptr;
    std::map<QString, QDockWidget*> m_docks;
    std::set<QString> m_hidden; // docks that the user has closed
    QLabel* m_counts;
    QLabel* m_selected;
    QTimer m_selectedSoon; // counts what is selected
};

} // namespace ripstop
