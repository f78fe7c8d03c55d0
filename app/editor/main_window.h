// The main window: it makes the view, the start page, the docks, the menus and the bars, and
// connects them.
//
// There is no logic here, and no list: docks are rows of docks/dock_table.h, menus rows of
// actions/menu_rows.h, bars tables of editor/tool_bars.h. What is a flow of its own (files,
// arrivals, kept work, the tour, the status line) has a class of its own; those outside reach it
// from here. main() makes the window last, so that it goes before the document, the selection and
// the player.
#pragma once

#include "actions/actions.h"
#include "actions/dialogs.h"
#include "docks/docks.h"
#include "files/files.h"
#include "tools/draw_tool.h"

#include <QMainWindow>

#include <memory>

class QStackedWidget;

namespace ripstop {

class Arrivals;
class Document;
class BrushBar;
class HandBar;
class KeptWork;
class Menus;
class Player;
class Recordings;
class RunFiles;
class Selection;
class StartPage;
class StatusLine;
class Transport;
class Viewport;
enum class Language;

class MainWindow final : public QMainWindow
{
    Q_OBJECT

public:
    enum class Memory { Keep, Ignore }; // whether places and sizes are kept from run to run

    MainWindow(Document& document, Selection& selection, Player& player, Memory memory);
    // In the place of another one, which is about to go: with all that it shows, in the language
    // that is spoken now.
    explicit MainWindow(MainWindow& before);
    ~MainWindow() override;

    Viewport& viewport() { return *m_viewport; }
    Recordings& recordings() { return *m_recordings; }
    Docks& docks() { return *m_docks; }
    Actions& actions() { return m_actions; }
    Files& files() { return *m_files; }
    RunFiles& runFiles() { return *m_runFiles; }
    Arrivals& arrivals() { return *m_arrivals; }
    KeptWork& keptWork() { return *m_keptWork; }

    void showScene();
    void showStartPage();
    void showViewOnly();               // hides all bars and docks, for pictures
    void openRun(const QString& file); // opens a recording
    void openStudy(const QString& file);

signals:
    void languageChosen(ripstop::Language language);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    MainWindow(Document& document, Selection& selection, Player& player, Memory memory,
               const DrawSettings& drawSettings, Recordings* recordings); // null: its own
    void openAny(const QString& file);
    void takeOver(MainWindow& before);
    void buildDocks();
    void buildActions();
    void buildToolBar();
    void buildBarsOfView();
    void buildInputs();
    void connectStart();
    void connectParts();
    void restoreMemory();
    void resetLayout(); // as it was at the very first start
    void showTitle();
    bool isSceneShown() const; // false while the start page is shown

    Document& m_document;
    Selection& m_selection;
    Player& m_player;
    Memory m_memory;
    DrawSettings m_drawSettings;
    Actions m_actions;

    Recordings* m_recordings;
    Viewport* m_viewport;
    StartPage* m_start;
    QStackedWidget* m_middle;
    Transport* m_transport;
    StatusLine* m_status;
    Files* m_files;
    RunFiles* m_runFiles;
    Arrivals* m_arrivals;
    KeptWork* m_keptWork;
    Dialogs m_dialogs;
    std::unique_ptr<Docks> m_docks;
    std::unique_ptr<Menus> m_menus; // goes before the view, whose tools speak until the end
    HandBar* m_handBar = nullptr;
    BrushBar* m_brushBar = nullptr;
    QToolBar* m_toolBar = nullptr;
};

} // namespace ripstop
