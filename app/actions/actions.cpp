#include "actions/actions.h"

#include "actions/design_rows.h"
#include "actions/dialogs.h"
#include "actions/draw_rows.h"
#include "actions/group_menus.h"
#include "actions/insert_rows.h"
#include "actions/language_rows.h"
#include "actions/measure_rows.h"
#include "actions/mnemonics.h"
#include "actions/run_rows.h"
#include "actions/select_rows.h"
#include "actions/timeline_rows.h"
#include "actions/tuning_rows.h"
#include "builders/builder.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "files/files.h"
#include "files/templates.h"
#include "icons/icon.h"
#include "outline/outline.h"
#include "scene/scene.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QToolBar>

#include <algorithm>

namespace ripstop {
namespace {

void about(QWidget* window)
{
    QMessageBox::about(
        window, Actions::tr("About Ripstop"),
        Actions::tr(
            "<h3>Ripstop %1</h3><p>An editor and simulator for fabric that flies: kites, "
            "hang gliders, parachutes, cloth.</p><p>Every number on the screen can be made "
            "again by <tt>ripstop-cli</tt>, bit for bit.</p><p>Free software under the GNU "
            "General Public License, version 3 or later. Built with Qt, VTK, Eigen, oneTBB, "
            "RapidJSON, nlohmann/json, CLI11, muParser, assimp, tinygltf, zstd and "
            "QCustomPlot.</p>")
            .arg(QApplication::applicationVersion()));
}

// The table. Menus appear in the order in which they are first named.
std::vector<MenuRow> rowsOf(const Workbench& bench, const Actions& actions)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    Document& document = bench.document;
    Selection& selection = bench.selection;
    Player& player = bench.player;
    Viewport& viewport = bench.viewport;
    Files& files = bench.files;
    QMainWindow& window = bench.window;
    const auto showing = [&viewport, &actions](const char* id, void (Viewport::*show)(bool)) {
        return [&viewport, &actions, id, show] { (viewport.*show)(actions[id]->isChecked()); };
    };
    const auto looking = [&viewport](PresetView view) {
        return [&viewport, view] { viewport.view(view); };
    };
    const auto coloring = [&viewport](ColorBy colorBy) {
        return [&viewport, colorBy] { viewport.setColorBy(colorBy); };
    };
    const auto arrows = [&viewport](Vectors vectors) {
        return [&viewport, vectors] { viewport.setVectors(vectors); };
    };
    const MenuRow line{"", nullptr, {}, nullptr, {}, {}, {}};
    // clang-format off
    std::vector<MenuRow> rows{
        {"&File", "new",        tr("&New scene"),          "new",     QKeySequence::New,    tr("An empty scene, to draw or import into."), [&files] { files.startNew(); }},
        {"&File", "build",      tr("New from &builder…"),  "builder", QKeySequence("Ctrl+B"), tr("A kite, glider, parachute, cloth or rope from its dimensions."), [&files] { files.startFrom({}); }},
        {"&File", "open",       tr("&Open…"),              "open",    QKeySequence::Open,   tr("Open a scene file."), [&files] { files.browse(); }},
        {"&File", "import",     tr("&Import…"),            "import",  QKeySequence("Ctrl+Shift+I"), tr("Make fabric of a mesh: OBJ, STL, PLY, OFF, glTF or Collada."), bench.importMesh},
        {"&File", "start",      tr("S&tart page"),         "start",   {},                   tr("Samples, recent files and builders."), bench.showStartPage},
        line,
        {"&File", "save",       tr("&Save"),               "save",    QKeySequence::Save,   tr("Save the scene in its file."), [&files] { files.save(); }},
        {"&File", "saveAs",     tr("Save &as…"),           "save-as", QKeySequence("Ctrl+Shift+S"), tr("Save the scene in another file."), [&files] { files.saveAs(); }},
        {"&File", "saveTemplate", tr("Save as &template…"), nullptr, {},                   tr("Keep the design as one to begin new ones from."), [&files] { files.saveAsTemplate(); }},
        {"&File", "export",     tr("&Export…"),            "export",  QKeySequence("Ctrl+E"), tr("Meshes for Blender, series for ParaView, tables of the probes and of what has torn."), [&files, &recordings = bench.recordings] { files.exportRun(recordings); }},
        {"&File", "picture",    tr("Save &picture…"),      "picture", QKeySequence("Ctrl+P"), tr("The 3D view as a PNG or JPEG file."), [&files] { files.savePicture(); }},
        line,
        {"&File", "quit",       tr("&Quit"),               "quit",    QKeySequence::Quit,   tr("Leave Ripstop."), [&window] { window.close(); }},

        {"&Edit", "undo",       tr("&Undo"),               "undo",    QKeySequence::Undo,   tr("Take back the last edit."), [&document] { document.history().undo(); }},
        {"&Edit", "redo",       tr("&Redo"),               "redo",    QKeySequence("Ctrl+Shift+Z"), tr("Make the last edit again that was taken back."), [&document] { document.history().redo(); }},
        line,
        {"&Edit", "delete",     tr("&Delete"),             "delete",  QKeySequence::Delete, tr("Remove what is selected, and all that hangs on it."), [&outline = bench.outline] { outline.removeSelected(); }},
        {"&Edit", "find",       tr("&Find in outline"),    "search",  QKeySequence::Find,   tr("Search the outline by name."), [&bench = bench.outline] { bench.focusSearch(); }},

        {"&View", "fit",        tr("&Fit"),                "fit",     QKeySequence("Home"), tr("Show the whole scene."), [&viewport] { viewport.fit(); }},
        {"&View", "fitSelected", tr("Fit sele&ction"),     nullptr,   QKeySequence("F"),    tr("Show what is selected, or the whole scene when nothing is."), [&viewport, &selection] { viewport.fit(selection.ids()); }},
        {"&View", "follow",     tr("F&ollow"),             "follow",  QKeySequence("Shift+F"), tr("The camera goes with the fabric."), showing("follow", &Viewport::setFollow), Toggle::On},
        {"&View", "ortho",      tr("O&rthographic"),       "orthographic", QKeySequence("5"), tr("Without perspective: parallels stay parallel."), showing("ortho", &Viewport::setOrthographic), Toggle::Off},
        line,
        {"&View", "front",      tr("Fro&nt"),              "view-front", QKeySequence("1"), tr("Look from the front."), looking(PresetView::Front)},
        {"&View", "back",       tr("&Back"),               nullptr,   QKeySequence("Ctrl+1"), tr("Look from behind."), looking(PresetView::Back)},
        {"&View", "right",      tr("R&ight"),              "view-side", QKeySequence("3"),  tr("Look from the right."), looking(PresetView::Right)},
        {"&View", "left",       tr("&Left"),               nullptr,   QKeySequence("Ctrl+3"), tr("Look from the left."), looking(PresetView::Left)},
        {"&View", "top",        tr("&Top"),                "view-top", QKeySequence("7"),   tr("Look from above."), looking(PresetView::Top)},
        {"&View", "bottom",     tr("Botto&m"),             nullptr,   QKeySequence("Ctrl+7"), tr("Look from below."), looking(PresetView::Bottom)},
        {"&View", "home",       tr("&Corner"),             "view-home", QKeySequence("0"),  tr("Look from a corner above."), looking(PresetView::Iso)},
        line,
        {"&View", "byMaterial", tr("Colour by &material"), nullptr,   QKeySequence("Alt+1"), tr("The colours of the materials."), coloring(ColorBy::Material), Toggle::On, "color"},
        {"&View", "byStrain",   tr("Colour by &strain"),   "color-by", QKeySequence("Alt+2"), tr("How far links are stretched."), coloring(ColorBy::Strain), Toggle::Off, "color"},
        {"&View", "byTension",  tr("Colour by t&ension"),  nullptr,   QKeySequence("Alt+3"), tr("How hard links pull."), coloring(ColorBy::Tension), Toggle::Off, "color"},
        {"&View", "bySpeed",    tr("Colour by s&peed"),    nullptr,   QKeySequence("Alt+4"), tr("How fast particles move."), coloring(ColorBy::Speed), Toggle::Off, "color"},
        {"&View", "byLoad",     tr("Colour by panel loa&d"), nullptr, QKeySequence("Alt+5"), tr("How hard the air pushes panels, per area."), coloring(ColorBy::PanelLoad), Toggle::Off, "color"},
        {"&View", "byTear",     tr("Colour by tea&r limit"), nullptr, QKeySequence("Alt+6"), tr("How much of what it tears at each link bears."), coloring(ColorBy::TearLoad), Toggle::Off, "color"},
        {"&View", "byStress",   tr("Colour by fabric stress"), nullptr, QKeySequence("Alt+7"), tr("Tension of threads over the width of fabric that they stand for."), coloring(ColorBy::Stress), Toggle::Off, "color"},
        {"&View", "colourRange", tr("Range of colours…"), nullptr,   QKeySequence("Alt+8"), tr("Type the values at the ends of the colours, or let them follow. A click on the colours does the same."), [&viewport] { viewport.editRange(); }},
        line,
        {"&View", "panels",     tr("Show p&anels"),        "panel",   {},                   tr("Draw the fabric."), showing("panels", &Viewport::setPanelsShown), Toggle::On},
        {"&View", "links",      tr("Show lin&ks"),         "link",    {},                   tr("Draw springs, rods and lines."), showing("links", &Viewport::setLinksShown), Toggle::On},
        {"&View", "particles",  tr("Show partic&les"),     "particle", QKeySequence("Shift+P"), tr("Draw a dot at each particle."), showing("particles", &Viewport::setParticlesShown), Toggle::Off},
        {"&View", "wind",       tr("Show &wind"),          "wind",    {},                   tr("Draw an arrow for the wind."), showing("wind", &Viewport::setWindShown), Toggle::On},
        {"&View", "windField",  tr("Show wind fiel&d"),    nullptr,   QKeySequence("Shift+W"), tr("Draw arrows for the wind all around the design."), showing("windField", &Viewport::setWindFieldShown), Toggle::Off},
        {"&View", "centre",     tr("Show centre of &gravity"), nullptr, QKeySequence("Shift+G"), tr("Mark the centre of gravity of what is selected, or of the whole design, with its mass."), showing("centre", &Viewport::setCentreShown), Toggle::Off},
        {"&View", "probeValues", tr("Show what &probes read"), nullptr, QKeySequence("Shift+V"), tr("Write the values of probes beside what they look at."), showing("probeValues", &Viewport::setProbesShown), Toggle::Off},
        {"&View", "trails",     tr("Show trails"),         nullptr,   {}, tr("Draw the ways that the selected particles have come in the last five seconds; of those that probes look at when none is selected."), showing("trails", &Viewport::setTrailsShown), Toggle::Off},
        {"&View", "designGhost", tr("Show the design as a ghost"), nullptr, {}, tr("The shape as it was designed, beside what has become of it; where nothing is pinned it goes along."), showing("designGhost", &Viewport::setDesignShown), Toggle::Off},
        {"&View/&Arrows", "noArrows", tr("&None"),         nullptr,   {}, tr("No arrows on particles, panels and links."), arrows(Vectors::None), Toggle::On, "arrows"},
        {"&View/&Arrows", "velocityArrows", tr("&Velocity"), nullptr, {}, tr("How fast each particle moves, and where to."), arrows(Vectors::Velocity), Toggle::Off, "arrows"},
        {"&View/&Arrows", "loadArrows", tr("Panel &load"), nullptr,   {}, tr("How hard the air pushes each panel."), arrows(Vectors::PanelLoad), Toggle::Off, "arrows"},
        {"&View/&Arrows", "tensionArrows", tr("&Tension"), nullptr,   {}, tr("How hard each link pulls at its ends."), arrows(Vectors::Tension), Toggle::Off, "arrows"},

        {"&Run", "play",        tr("&Play"),               "play",    QKeySequence("Space"), tr("Run the simulation, or hold it."), [&player] { player.toggle(); }},
        {"&Run", "step",        tr("&Step"),               "step",    QKeySequence("."),    tr("One time step."), [&player] { player.step(); }},
        {"&Run", "reset",       tr("&Reset"),              "reset",   QKeySequence("Ctrl+R"), tr("Back to the design; controls return to zero."), [&player] { player.reset(); }},

        {"&Tools", "polar",     tr("&Polar of an air law"), "plot",   {},                   tr("What the air law of a material does to a flat plate, beside published curves."), [&dialogs = bench.dialogs] { dialogs.showPolar(); }},

        {"&Help", "palette",    tr("&Find an action…"),    "search",  QKeySequence("F3"),   tr("Type to find anything that the menus can do."), [&dialogs = bench.dialogs] { dialogs.showPalette(); }},
        {"&Help", "keys",       tr("&Keys…"),              "keys",    QKeySequence("F1"),   tr("All keys, to see and to change, and those of the controls of this scene."), [&dialogs = bench.dialogs, &actions] { dialogs.showKeys(actions.keys()); }},
        {"&Help", "tour",       tr("&Tour"),               nullptr,   {},                   tr("What the parts of the window are for, in a minute."), bench.showTour},
        {"&Help", "verification", tr("&Verification…"),    nullptr,   {},                   tr("Run the cases whose answer is known, and see what comes out."), [&dialogs = bench.dialogs] { dialogs.showVerification(); }},
        {"&Help", "about",      tr("&About Ripstop"),      "about",   {},                   tr("Version and licence."), [&window] { about(&window); }},
    };
    // clang-format on
    const auto insertBefore = [&rows](std::string_view menu, const std::vector<MenuRow>& more) {
        const auto place = std::ranges::find_if(
            rows, [menu](const MenuRow& row) { return std::string_view(row.menu) == menu; });
        rows.insert(place, more.begin(), more.end());
    };
    insertBefore("&View", selectRows(bench, actions));
    insertBefore("&Run", languageRows(bench));
    insertBefore("&Tools", handRows(bench, actions));
    insertBefore("&Tools", tuningActionRows(bench));
    insertBefore("&Help", measureRows(bench, actions));
    insertBefore("&Tools", timelineRows(bench));
    const auto place = std::ranges::find_if(
        rows, [](const MenuRow& row) { return row.id && std::string_view(row.id) == "export"; });
    const std::vector<MenuRow> recordings = recordingFileRows(bench);
    rows.insert(place, recordings.begin(), recordings.end());
    return rows;
}

} // namespace

Actions::Actions(const Workbench& bench, KeyMap::Memory keys)
    : QObject(&bench.window)
    , m_bench(bench)
{
    build();
    m_keys = new KeyMap(m_all, keys, this);
    connect(&m_bench.document.history(), &QUndoStack::indexChanged, this, &Actions::keepCurrent);
    connect(&m_bench.selection, &Selection::changed, this, &Actions::keepCurrent);
    connect(&m_bench.player, &Player::stateChanged, this, &Actions::keepCurrent);
    connect(&m_bench.viewport.transformTool(), &TransformTool::changed, this,
            &Actions::keepCurrent);
    connect(&m_bench.viewport, &Viewport::menuWanted, this,
            [this](const QPoint& place) { showViewMenu(m_bench, *this, place); });
    connect(&m_bench.files, &Files::recentChanged, this, &Actions::fillRecent);
    connect(&m_bench.viewport.pointing(), &Pointing::toolLeft, this,
            [this] { m_byId["toolPointer"]->setChecked(true); });
    fillRecent();
    keepCurrent();
    m_bench.viewport.setParticlesShown(m_byId["particles"]->isChecked());
}

void Actions::build()
{
    std::map<QString, QMenu*> menus;
    std::map<QString, QActionGroup*> groups;
    QMenu* menu = nullptr;
    const std::function<QMenu*(const QString&)> open = [&](const QString& path) {
        QMenu*& place = menus[path];
        const QString name = path.section('/', -1);
        if (!place && path.contains('/'))
            place = open(path.section('/', 0, -2))->addMenu(tr(qPrintable(name)));
        else if (!place)
            place = m_bench.window.menuBar()->addMenu(tr(qPrintable(name)));
        return place;
    };
    std::vector<MenuRow> rows = rowsOf(m_bench, *this);
    const auto isView = [](const MenuRow& row) { return QLatin1String(row.menu) == "&View"; };
    for (const std::vector<MenuRow>& more :
         {insertRows(m_bench), designRows(m_bench), drawRows(m_bench)})
        rows.insert(std::ranges::find_if(rows, isView), more.begin(), more.end());
    for (const MenuRow& row : rows) {
        if (!row.id) {
            (*row.menu ? open(row.menu) : menu)->addSeparator();
            continue;
        }
        menu = open(row.menu);
        QAction* action =
            menu->addAction(row.icon ? icon(row.icon) : QIcon(), row.text, this, row.run);
        action->setObjectName(row.id);
        action->setShortcut(row.keys);
        action->setStatusTip(row.tip);
        action->setCheckable(row.toggle != Toggle::No);
        action->setChecked(row.toggle == Toggle::On);
        if (row.group) {
            QActionGroup*& group = groups[row.group];
            if (!group)
                group = new QActionGroup(this);
            group->addAction(action);
        }
        m_byId[row.id] = action;
        if (row.needs == Needs::Selection)
            m_needSelection.push_back(action);
        if (row.toggle != Toggle::No && isView(row))
            m_viewToggles.push_back(action);
        m_all.push_back(action);
    }
    m_recent = new QMenu(tr("Open &recent"), &m_bench.window);
    m_recent->setIcon(icon("recent"));
    menus["&File"]->insertMenu(m_byId["start"], m_recent);
    m_templates = new QMenu(tr("New from te&mplate"), &m_bench.window);
    menus["&File"]->insertMenu(m_byId["open"], m_templates);
    connect(m_templates, &QMenu::aboutToShow, this, &Actions::fillTemplates);
    addGroupMenus(*menus["&Select"], m_bench);
    m_panels = menus["&View"]->addMenu(tr("Panels and &docks"));
    giveMnemonics(m_bench.window.menuBar()->actions());
    keepMnemonics(m_bench.window.menuBar()->actions());
}

void Actions::addDockToggle(QAction* toggle) { m_panels->addAction(toggle); }

void Actions::keepCurrent()
{
    const QUndoStack& history = m_bench.document.history();
    m_byId["undo"]->setEnabled(history.canUndo());
    m_byId["undo"]->setText(history.canUndo() ? tr("&Undo: %1").arg(history.undoText())
                                              : tr("&Undo"));
    m_byId["redo"]->setEnabled(history.canRedo());
    m_byId["redo"]->setText(history.canRedo() ? tr("&Redo: %1").arg(history.redoText())
                                              : tr("&Redo"));
    m_byId["delete"]->setEnabled(!m_bench.selection.ids().empty());
    for (const char* id : actionsOnSelection)
        m_byId[id]->setEnabled(!m_bench.selection.ids().empty());
    for (QAction* action : m_needSelection)
        action->setEnabled(!m_bench.selection.ids().empty());
    const Shaping shaping = m_bench.viewport.transformTool().shaping();
    m_byId["move"]->setChecked(shaping == Shaping::Move);
    m_byId["rotate"]->setChecked(shaping == Shaping::Turn);
    m_byId["scale"]->setChecked(shaping == Shaping::Scale);
    const bool playing = m_bench.player.isPlaying();
    m_byId["play"]->setText(playing ? tr("&Pause") : tr("&Play"));
    m_byId["play"]->setIcon(icon(playing ? "pause" : "play"));
}

void Actions::keepView() const
{
    QSettings settings;
    for (const QAction* action : m_viewToggles)
        settings.setValue("view/" + action->objectName(), action->isChecked());
}

void Actions::restoreView()
{
    const QSettings settings;
    for (QAction* action : m_viewToggles) {
        const bool isOne = action->actionGroup() != nullptr; // of several: only switched on
        const bool kept =
            settings.value("view/" + action->objectName(), action->isChecked()).toBool();
        if (kept != action->isChecked() && (kept || !isOne))
            action->trigger();
    }
}

void Actions::fillTemplates()
{
    m_templates->clear();
    for (const QString& file : m_bench.files.templates())
        m_templates->addAction(templateName(file).replace('&', "&&"), this,
                               [this, file] { m_bench.files.startFromTemplate(file); });
    if (m_templates->isEmpty())
        m_templates->addAction(tr("None yet: File, Save as template"))->setEnabled(false);
    m_templates->addSeparator();
    m_templates->addAction(tr("Show the &folder"), this, [] { showTemplateFolder(); });
}

void Actions::fillRecent()
{
    m_recent->clear();
    for (const QString& file : m_bench.files.recent())
        m_recent
            ->addAction(QFileInfo(file).fileName().replace('&', "&&"), this,
                        [this, file] { m_bench.files.open(file); })
            ->setToolTip(file);
    m_recent->setEnabled(!m_recent->isEmpty());
}

} // namespace ripstop
