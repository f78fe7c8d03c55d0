// Stages: the functions at the top give the mouse a tool that draws or paints, widen the brush, and
// open the dialog of an operation; drawRows() binds them to the rows. A tool puts the transform
// tool away, since its handles would be in the way, and takes the focus so that Escape reaches it.
#include "actions/menu_rows.h"

#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "dialogs/operation_dialog.h"
#include "document/document.h"
#include "document/selection.h"
#include "tools/brush_tool.h"
#include "tools/draw_tool.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QMainWindow>
#include <QStatusBar>

namespace ripstop {
namespace {

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

std::function<void()> painting(const Workbench& bench)
{
    return [&bench] {
        TransformTool& shaping = bench.viewport.transformTool();
        shaping.setShaping(Shaping::None); // its handles would be in the way
        shaping.goToDesign();
        const auto begin = [&shaping] {
            const bool isThere = shaping.isAtDesign();
            shaping.goToDesign();
            return isThere;
        };
        const auto say = [status = bench.window.statusBar()](const QString& text) {
            status->showMessage(text, messageTime);
        };
        bench.viewport.pointing().setTool(
            std::make_unique<BrushTool>(bench.document, bench.viewport.brush(),
                                        BrushTool::Calls{begin, bench.toolChanged, say}));
        bench.viewport.setFocus(); // so that Escape reaches it
    };
}

// Makes the brush so many times as wide.
std::function<void()> widening(const Workbench& bench, double factor)
{
    return [&bench, factor] {
        bench.viewport.brush().widen(factor);
        bench.toolChanged();
        bench.viewport.pointing().update();
    };
}

std::function<void()> operating(const Workbench& bench, const char* name)
{
    return [&bench, name] {
        bench.viewport.transformTool().goToDesign();
        OperationDialog(*findOperation(name), bench.document, bench.selection, &bench.window)
            .exec();
    };
}

} // namespace

MenuRows drawRows(const Workbench& bench)
{
    const auto draw = [&](DrawTool::Shape shape) { return drawing(bench, shape); };
    const auto operation = [&](const char* name) { return operating(bench, name); };
    const auto no = Toggle::No;
    const auto some = Needs::Selection;
    using Shape = DrawTool::Shape;
    const MenuRow line = lineIn("D&raw");
    // clang-format off
    return {
        {"D&raw", "drawParticles", tr("&Particles"), "draw-particle", QKeySequence("Shift+A"), tr("Click where particles are to be: in a plane, on fabric."), draw(Shape::Particles), Toggle::Off, "tool"},
        {"D&raw", "drawLinks",     tr("&Links"),     "draw-link",     QKeySequence("D"),       tr("Click from particle to particle, or where one is to be: rods, lines, springs, ropes of many segments."), draw(Shape::Links), Toggle::Off, "tool"},
        {"D&raw", "drawPanels",    tr("P&anels"),    "draw-panel",    QKeySequence("Ctrl+D"),   tr("Click the three corners of a panel."), draw(Shape::Panels), Toggle::Off, "tool"},
        {"D&raw", "toolBrush",     tr("Paint with a &brush"), "tool-brush", QKeySequence("U"), tr("Drag over fabric to make it stronger or weaker, stiffer or softer, or to turn its grain: patches, reinforcements, worn places."), painting(bench), Toggle::Off, "tool"},
        {"D&raw", "brushNarrower", tr("Narrower brush"),   nullptr,         QKeySequence("["),     tr("Make the radius of the brush smaller."), widening(bench, 1.0 / 1.25)},
        {"D&raw", "brushWider",    tr("Wider brush"),      nullptr,         QKeySequence("]"),     tr("Make the radius of the brush larger."), widening(bench, 1.25)},
        line,
        {"D&raw", "link",     tr("L&ink selected…"),   "link",  QKeySequence("J"),       tr("Tie the selected particles to each other, in a line, a ring, or each with each."), operation("link"), no, nullptr, some},
        {"D&raw", "rope",     tr("&Rope…"),            nullptr, {},                      tr("A rope or line of many links between two selected particles."), operation("rope"), no, nullptr, some},
        {"D&raw", "spar",     tr("&Spar…"),            nullptr, {},                      tr("A stiff spar along the selected particles."), operation("spar"), no, nullptr, some},
        {"D&raw", "fill",     tr("&Fill with panels…"), "panel", QKeySequence("Shift+J"), tr("Close the hole that the selected particles surround."), operation("fill"), no, nullptr, some},
        {"D&raw", "rigidity", tr("Ri&gidity particles…"), nullptr, {},                   tr("Particles on both sides of the selected ones, tied to each, so that they keep their shape."), operation("rigidity"), no, nullptr, some},
        line,
        {"D&raw", "floppy",   tr("What gives &way…"),  nullptr, QKeySequence("Ctrl+Shift+R"), tr("In which ways the selection, or the design, gives way without a link growing longer, and the rods that would stop it."), [&dialogs = bench.dialogs] { dialogs.showRigidity(); }},
    };
    // clang-format on
}

} // namespace ripstop
