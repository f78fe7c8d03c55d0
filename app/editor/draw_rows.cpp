#include "editor/draw_rows.h"

#include "document/document.h"
#include "editor/actions.h"
#include "editor/dialogs.h"
#include "viewport/draw_tool.h"
#include "viewport/pointing.h"
#include "viewport/transform_tool.h"
#include "viewport/viewport.h"

#include <QMainWindow>
#include <QStatusBar>

namespace ripstop {
namespace {

constexpr int messageTime = 8000; // ms

std::function<void()> drawing(const Workbench& bench, DrawTool::Shape shape)
{
    return [&bench, shape] {
        TransformTool& shaping = bench.viewport.transformTool();
        shaping.setShaping(Shaping::None); // its handles would be in the way
        auto* status = bench.window.statusBar();
        bench.viewport.pointing().setTool(std::make_unique<DrawTool>(
            shape, bench.document, bench.drawSettings, [&shaping] { shaping.goToDesign(); },
            [status](const QString& text) { status->showMessage(text, messageTime); }));
        bench.viewport.setFocus(); // so that Escape reaches it
    };
}

} // namespace

std::vector<MenuRow> drawRows(const Workbench& bench)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    const auto draw = [&](DrawTool::Shape shape) { return drawing(bench, shape); };
    using Shape = DrawTool::Shape;
    const MenuRow line{"D&raw", nullptr, {}, nullptr, {}, {}, {}};
    // clang-format off
    return {
        {"D&raw", "drawParticles", tr("&Particles"), "draw-particle", QKeySequence("Shift+A"), tr("Click where particles are to be: in a plane, on fabric."), draw(Shape::Particles), Toggle::Off, "tool"},
        {"D&raw", "drawLinks",     tr("&Links"),     "draw-link",     QKeySequence("D"),       tr("Click from particle to particle, or where one is to be: rods, lines, springs, ropes of many segments."), draw(Shape::Links), Toggle::Off, "tool"},
        {"D&raw", "drawPanels",    tr("P&anels"),    "draw-panel",    QKeySequence("Ctrl+D"),   tr("Click the three corners of a panel."), draw(Shape::Panels), Toggle::Off, "tool"},
        line,
        {"D&raw", "floppy",   tr("What gives &way…"),  nullptr, QKeySequence("Ctrl+Shift+R"), tr("In which ways the selection, or the design, gives way without a link growing longer, and the rods that would stop it."), [&dialogs = bench.dialogs] { dialogs.showRigidity(); }},
    };
    // clang-format on
}

} // namespace ripstop
