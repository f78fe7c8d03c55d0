// Stages: one function for each dock makes its panel and connects what the dock itself does, such
// as to come forward; then stands the table. A new dock is a function here and a row there. A
// panel that needs another one gets it from the rows above, so the order of rows matters for that
// as well as for the order of tabs.
#include "docks/dock_table.h"

#include "docks/panels.h"
#include "document/document.h"
#include "document/measurement.h"
#include "document/player.h"
#include "document/recordings.h"
#include "inspector/inspector.h"
#include "inspector/tuning_panel.h"
#include "loads/load_panel.h"
#include "outline/outline.h"
#include "plots/plot_panel.h"
#include "problems/problem_list.h"
#include "study/study_panel.h"
#include "table/sheet_panel.h"
#include "timeline/timeline.h"
#include "transport/control_strip.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QUndoView>

namespace ripstop {
namespace {

constexpr int roomOfStudy = 340; // px of height

QString tr(const char* text) { return QCoreApplication::translate("Docks", text); }

QWidget* makeOutline(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    return new Outline(parts.document, parts.selection, &dock);
}

QWidget* makeHistory(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    auto* history = new QUndoView(&parts.document.history(), &dock);
    history->setEmptyLabel(tr("The design as it was opened"));
    history->setToolTip(tr("Click a step to go back to it, or forward again."));
    return history;
}

QWidget* makeInspector(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    return new Inspector(parts.document, parts.selection, &dock);
}

QWidget* makeTuning(const PanelParts& parts, const Panels& above, QDockWidget& dock)
{
    return new TuningPanel(parts.document, parts.selection, above.the<Inspector>().sliders(),
                           &dock);
}

QWidget* makePlots(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    auto* plots = new PlotPanel(parts.document, parts.player, &dock);
    plots->follow(parts.recordings);
    QObject::connect(plots, &PlotPanel::said, &dock, parts.say);
    return plots;
}

QWidget* makeControls(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    return new ControlStrip(parts.document, parts.player, &dock);
}

// The title of this dock counts problems, and it comes forward when the design cannot run or the
// run has stopped.
QWidget* makeProblems(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    auto* problems = new ProblemList(parts.document, parts.selection, parts.player, &dock);
    QObject::connect(
        problems, &ProblemList::countChanged, &dock, [&dock](int errors, int warnings) {
            const int count = errors + warnings;
            dock.setWindowTitle(count ? tr("Problems (%1)").arg(count) : tr("Problems"));
            if (errors)
                dock.raise();
        });
    QObject::connect(&parts.player, &Player::stopped, &dock, [&dock] {
        dock.show();
        dock.raise();
    });
    return problems;
}

QWidget* makeLoads(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    return new LoadPanel(parts.document, parts.selection, parts.player, &dock);
}

QWidget* makeTable(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    auto* table = new SheetPanel(
        parts.document, parts.selection,
        [&player = parts.player] { return measurementOf(player.frame()); }, &dock);
    table->follow(parts.player);
    return table;
}

// What is to be studied brings it forward, with room for the map.
QWidget* makeStudy(const PanelParts& parts, const Panels& above, QDockWidget& dock)
{
    auto* panel = new StudyPanel(parts.document, parts.recordings, parts.saveDesign, &dock);
    QObject::connect(panel, &StudyPanel::said, &dock, parts.say);
    const auto comeForward = [&dock] {
        dock.show();
        dock.raise();
        auto* window = qobject_cast<QMainWindow*>(dock.parentWidget());
        if (window && !dock.isFloating() && dock.height() < roomOfStudy)
            window->resizeDocks({&dock}, {roomOfStudy}, Qt::Vertical);
    };
    SliderShelf& sliders = above.the<Inspector>().sliders();
    QObject::connect(&sliders, &SliderShelf::studyWanted, panel, &StudyPanel::study);
    QObject::connect(&sliders, &SliderShelf::studyWanted, &dock, comeForward);
    QObject::connect(panel, &StudyPanel::opened, &dock, comeForward);
    return panel;
}

QWidget* makeTimeline(const PanelParts& parts, const Panels&, QDockWidget& dock)
{
    return new Timeline(parts.recordings, &dock);
}

} // namespace

std::vector<DockRow> dockTable()
{
    const auto left = Qt::LeftDockWidgetArea;
    const auto right = Qt::RightDockWidgetArea;
    const auto below = Qt::BottomDockWidgetArea;
    const auto stays = OnOpening::Stays;
    const auto comes = OnOpening::ComesForward;
    // clang-format off
    return {
        {"outline",   tr("Outline"),   left,  250, comes, makeOutline,
            tr("Outline"), tr("Everything that the scene is made of: parts, materials, groups, controls, colliders. The tab History goes back to any step.")},
        {"history",   tr("History"),   left,  0,   stays, makeHistory, {}, {}},
        {"inspector", tr("Inspector"), right, 320, stays, makeInspector,
            tr("Inspector"), tr("The values of what is selected, one thing or thousands. Type with units (12 cm, 25 g), drag a label sideways, or change a value while the simulation runs.")},
        {"tuning",    tr("Tuning"),    right, 0,   stays, makeTuning, {}, {}},
        {"plots",     tr("Plots"),     below, 210, comes, makePlots,
            tr("Measure it"), tr("Strain, energy, forces and probes as they happen. Problems of the design stand beside, each with a click to what it is about.")},
        {"controls",  tr("Controls"),  below, 0,   stays, makeControls, {}, {}},
        {"problems",  tr("Problems"),  below, 0,   stays, makeProblems, {}, {}},
        {"loads",     tr("Loads"),     below, 0,   stays, makeLoads, {}, {}},
        {"table",     tr("Table"),     below, 0,   stays, makeTable, {}, {}},
        {"study",     tr("Study"),     below, 0,   stays, makeStudy, {}, {}},
        {"timeline",  tr("Timeline"),  below, 0,   stays, makeTimeline, {}, {}},
    };
    // clang-format on
}

} // namespace ripstop
