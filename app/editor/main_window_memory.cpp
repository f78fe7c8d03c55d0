// What the main window keeps: from run to run, in the settings, and when another window takes its
// place, because the language has changed.
#include "actions/menus.h"
#include "document/player.h"
#include "document/recordings.h"
#include "editor/brush_bar.h"
#include "editor/hand_bar.h"
#include "editor/main_window.h"
#include "editor/window_layout.h"
#include "files/kept_work.h"
#include "files/run_files.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QCloseEvent>
#include <QToolBar>

namespace ripstop {

MainWindow::MainWindow(MainWindow& before)
    : MainWindow(before.m_document, before.m_selection, before.m_player, before.m_memory,
                 before.m_drawSettings, before.m_recordings)
{
    takeOver(before);
}

void MainWindow::restoreMemory()
{
    if (m_memory == Memory::Ignore)
        return;
    restoreLayout(*this);
    m_docks->noteClosed();
    m_menus->restoreView();
    m_runFiles->restoreMemory();
}

// The view comes after the actions, whose switches it has then, and is shown before it is told
// where things are, as sizes are known only then.
void MainWindow::takeOver(MainWindow& before)
{
    m_files->takeOver(*before.m_files);
    m_keptWork->takeOver(*before.m_keptWork);
    m_docks->takeOver(*before.m_docks);
    if (before.isSceneShown())
        showScene();
    restoreGeometry(before.saveGeometry()); // whether it fills the screen
    if (!isMaximized() && !isFullScreen())
        setGeometry(before.geometry());
    restoreState(before.saveState());
    m_menus->takeOver(before.m_actions);
    m_viewport->takeOver(*before.m_viewport);
    m_handBar->refresh();
    m_brushBar->refresh();
    if (before.isVisible()) {
        show();
        before.hide();
        activateWindow();
    }
    m_recordings->setGhost(m_recordings->ghost());
    m_dialogs.takeChecks(before.m_dialogs);
    for (const QString& id : before.m_dialogs.open())
        m_actions[id]->trigger();
}

void MainWindow::resetLayout()
{
    showScene();
    m_toolBar->show();
    m_docks->arrange();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayDiscard())
        return event->ignore();
    if (m_memory == Memory::Keep) {
        if (!isSceneShown())
            showScene(); // because the layout to be kept is the one with docks
        keepLayout(*this);
        m_menus->keepView();
    }
    event->accept();
}

} // namespace ripstop
