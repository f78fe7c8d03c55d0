// Stages: the functions at the top give the mouse a tool of the hand, make the pose of the run the
// design, and pull out pins; each says in the status bar why it does nothing. runRows() binds them
// to the rows. A tool of the hand puts the transform tool away, since its handles would be in the
// way, and takes the focus so that keys reach it.
#include "actions/menu_rows.h"

#include "actions/actions.h"
#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "dialogs/pose_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "tools/cut_tool.h"
#include "tools/fan_tool.h"
#include "tools/grab_tool.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>

namespace ripstop {
namespace {

void say(const Workbench& bench, const QString& text)
{
    bench.window.statusBar()->showMessage(text, messageTime);
}

// Handles of the transform tool would be in the way of a hand, so that tool is put away.
void take(const Workbench& bench, std::unique_ptr<Tool> tool)
{
    bench.viewport.transformTool().setShaping(Shaping::None);
    bench.viewport.pointing().setTool(std::move(tool));
    bench.viewport.setFocus(); // so that keys reach it
}

void adoptPose(const Workbench& bench)
{
    const auto& frame = bench.player.frame();
    if (!frame || !frame->underWay)
        return say(bench, tr("The design stands at its start; run it first (Space)."));
    if (!bench.player.isCurrent())
        return say(bench, tr("What is shown is no run of the design as it is now: mend "
                             "its problems, or wait for the next step."));
    bench.player.pause();
    PoseDialog(bench.document, bench.player, &bench.window).exec();
}

void pullOutPins(const Workbench& bench)
{
    const std::vector<std::uint32_t> pins = bench.player.hands().hands.pins;
    if (pins.empty())
        return say(bench, tr("Nothing is pinned by hand: grab it and press P."));
    for (const std::uint32_t particle : pins)
        bench.player.handle(HandNote::Pin{particle, false});
}

} // namespace

MenuRows runRows(const Workbench& bench)
{
    Player& player = bench.player;
    const Actions& actions = bench.actions;
    const auto grab = [&bench] {
        Viewport& viewport = bench.viewport;
        take(bench,
             std::make_unique<GrabTool>(bench.document, bench.player, viewport.hands(),
                                        [&viewport] { return viewport.pointing().pickable; }));
    };
    const auto cut = [&bench, &actions] {
        take(bench, std::make_unique<CutTool>(bench.player, [&actions] {
                 return actions["through"]->isChecked() ? Depth::Through : Depth::Visible;
             }));
    };
    const auto fan = [&bench] {
        take(bench,
             std::make_unique<FanTool>(bench.player, bench.viewport.hands(), bench.toolChanged));
    };
    const auto settle = [&bench] {
        bench.dialogs.showSettle(bench.player, [&bench] { adoptPose(bench); });
    };
    const auto adopt = [&bench] { adoptPose(bench); };
    const auto unpin = [&bench] { pullOutPins(bench); };
    const MenuRow line = lineIn("&Run");
    // clang-format off
    return {
        {"&Run", "play",        tr("&Play"),               "play",    QKeySequence("Space"), tr("Run the simulation, or hold it."), [&player] { player.toggle(); }},
        {"&Run", "step",        tr("&Step"),               "step",    QKeySequence("."),    tr("One time step."), [&player] { player.step(); }},
        {"&Run", "reset",       tr("&Reset"),              "reset",   QKeySequence("Ctrl+R"), tr("Back to the design; controls return to zero."), [&player] { player.reset(); }},
        line,
        {"&Run", "toolGrab",   tr("&Grab"),          "grab",     QKeySequence("H"), tr("Pull at fabric and lines, carry colliders, move controls: drag them. The wheel moves the hand nearer or farther, P pins what it holds. Ctrl and a drag does this with any tool."), grab, Toggle::Off, "tool"},
        {"&Run", "toolCut",    tr("&Cut"),           "tool-cut", QKeySequence("K"), tr("Draw a stroke across links and fabric: they part where it runs."), cut, Toggle::Off, "tool"},
        {"&Run", "toolFan",    tr("&Fan"),           "tool-fan", QKeySequence("W"), tr("Blow with the mouse: hold the left button. The wheel makes it blow harder, with Ctrl wider."), fan, Toggle::Off, "tool"},
        {"&Run", "unpinHands", tr("Pull &out pins"), nullptr,    {},                tr("Let go of all that was pinned by hand in this run."), unpin},
        line,
        {"&Run", "settle",     tr("S&ettle…"),       nullptr,    QKeySequence("Ctrl+Shift+Space"), tr("Run until all hangs still, then pause."), settle},
        {"&Run", "certify",    tr("Certif&y…"),      nullptr,    {},                               tr("Fly the design three times, to tell which digits of its probes hold."), [&bench] { bench.dialogs.showCertify(bench.recordings); }},
        {"&Run", "adoptPose",  tr("&Adopt pose…"),   nullptr,    QKeySequence("Ctrl+Shift+A"), tr("Make the shape of the run the design. Undo brings the old design back."), adopt},
    };
    // clang-format on
}

} // namespace ripstop
