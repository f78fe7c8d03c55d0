#include "actions/menu_rows.h"

#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "files/arrivals.h"
#include "files/files.h"
#include "files/run_files.h"

#include <QMainWindow>

namespace ripstop {

MenuRows fileRows(const Workbench& bench)
{
    Files& files = bench.files;
    RunFiles& runFiles = bench.runFiles;
    Arrivals& arrivals = bench.arrivals;
    QMainWindow& window = bench.window;
    const MenuRow line = lineIn("&File");
    // clang-format off
    return {
        {"&File", "new",        tr("&New scene"),          "new",     QKeySequence::New,    tr("An empty scene, to draw or import into."), [&files] { files.startNew(); }},
        {"&File", "build",      tr("New from &builder…"),  "builder", QKeySequence("Ctrl+B"), tr("A kite, glider, parachute, cloth or rope from its dimensions."), [&arrivals] { arrivals.startFrom({}); }},
        {"&File", "open",       tr("&Open…"),              "open",    QKeySequence::Open,   tr("Open a scene file."), [&files] { files.browse(); }},
        {"&File", "import",     tr("&Import…"),            "import",  QKeySequence("Ctrl+Shift+I"), tr("Make fabric of a mesh: OBJ, STL, PLY, OFF, glTF, Collada, VTP or VTU."), [&arrivals] { arrivals.importMesh(); }},
        {"&File", "start",      tr("S&tart page"),         "start",   {},                   tr("Samples, recent files and builders."), bench.showStartPage},
        line,
        {"&File", "save",       tr("&Save"),               "save",    QKeySequence::Save,   tr("Save the scene in its file."), [&files] { files.save(); }},
        {"&File", "saveAs",     tr("Save &as…"),           "save-as", QKeySequence("Ctrl+Shift+S"), tr("Save the scene in another file."), [&files] { files.saveAs(); }},
        {"&File", "saveTemplate", tr("Save as &template…"), nullptr, {},                   tr("Keep the design as one to begin new ones from."), [&files] { files.saveAsTemplate(); }},
        {"&File", "compareDesign", tr("Compare &with…"),   "compare", {},                   tr("What the open design and another one, or the saved one, differ in."), [&dialogs = bench.dialogs] { dialogs.showDifferences(); }},
        line,
        {"&File", "openRun", tr("Open reco&rding…"), nullptr, QKeySequence("Ctrl+Alt+O"), tr("Look at a run that was saved, compare with it, or go on from it."), [&runFiles] { runFiles.browse(); }},
        {"&File", "saveRun", tr("Sa&ve recording…"), nullptr, QKeySequence("Ctrl+Alt+S"), tr("Save the run that the timeline shows, every step of it."), [&runFiles] { runFiles.save(); }},
        {"&File", "export",     tr("&Export…"),            "export",  QKeySequence("Ctrl+E"), tr("Meshes for Blender, series for ParaView, tables of the probes and of what has torn."), [&files, &recordings = bench.recordings] { files.exportRun(recordings); }},
        {"&File", "film",       tr("Save &film…"),         nullptr,   {},                     tr("The flight of the timeline as a film, MP4, WebM or GIF, seen as in the 3D view."), [&files, &recordings = bench.recordings] { files.saveFilm(recordings); }},
        {"&File", "picture",    tr("Save &picture…"),      "picture", QKeySequence("Ctrl+P"), tr("The 3D view as PNG, JPEG, SVG or PDF, large enough for a paper, on sky, white or nothing."), [&files] { files.savePicture(); }},
        line,
        {"&File", "quit",       tr("&Quit"),               "quit",    QKeySequence::Quit,   tr("Leave Ripstop."), [&window] { window.close(); }},
    };
    // clang-format on
}

} // namespace ripstop
