#include "actions/menu_rows.h"

#include "actions/actions.h"
#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "manual/manual.h"

#include <QApplication>
#include <QDesktopServices>
#include <QMainWindow>
#include <QMessageBox>
#include <QStatusBar>

namespace ripstop {
namespace {

void about(QWidget* window)
{
    QMessageBox::about(
        window, tr("About Ripstop"),
        tr("<h3>Ripstop %1</h3><p>An editor and simulator for fabric that flies: kites, "
           "hang gliders, parachutes, cloth.</p><p>Every number on the screen can be made "
           "again by <tt>ripstop-cli</tt>, bit for bit.</p><p>Free software under the GNU "
           "General Public License, version 3 or later. Built with Qt, VTK, Eigen, oneTBB, "
           "RapidJSON, nlohmann/json, CLI11, muParser, assimp, tinygltf, zstd and "
           "QCustomPlot.</p>")
            .arg(QApplication::applicationVersion()));
}

Manual* manualFor(QMainWindow& window)
{
    auto* manual =
        new Manual(QApplication::applicationDirPath(), &QDesktopServices::openUrl, &window);
    QObject::connect(manual, &Manual::said, &window, [&window](const QString& sentence) {
        window.statusBar()->showMessage(sentence, messageTime);
    });
    return manual;
}

} // namespace

MenuRows helpRows(const Workbench& bench)
{
    Dialogs& dialogs = bench.dialogs;
    const Docks& docks = bench.docks;
    const Actions& actions = bench.actions;
    QMainWindow& window = bench.window;
    Manual* manual = manualFor(window);
    // clang-format off
    return {
        {"&Help", "manual",     tr("&Manual"),             nullptr,   {},                   tr("The book: tutorials, editor, materials, tuning, studies, physics."), [manual] { manual->showStart(); }},
        {"&Help", "manualHere", tr("Manual about &this"),  nullptr,   QKeySequence("F1"),   tr("The page of the manual about the property, panel or dialog under the mouse."), [manual] { manual->showHere(); }},
        {"&Help", "palette",    tr("&Find an action…"),    "search",  QKeySequence("F3"),   tr("Type to find anything that the menus can do."), [&dialogs, &docks] { dialogs.showPalette(docks); }},
        {"&Help", "keys",       tr("&Keys…"),              "keys",    QKeySequence("Shift+F1"), tr("All keys, to see and to change, and those of the controls of this scene."), [&dialogs, &actions] { dialogs.showKeys(actions.keys()); }},
        {"&Help", "tour",       tr("&Tour"),               nullptr,   {},                   tr("What the parts of the window are for, in a minute."), bench.showTour},
        {"&Help", "verification", tr("&Verification…"),    nullptr,   {},                   tr("Run the cases whose answer is known, and see what comes out."), [&dialogs] { dialogs.showVerification(); }},
        {"&Help", "about",      tr("&About Ripstop"),      "about",   {},                   tr("Version and licence."), [&window] { about(&window); }},
    };
    // clang-format on
}

} // namespace ripstop
