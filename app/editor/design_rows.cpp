#include "editor/design_rows.h"

#include "editor/actions.h"
#include "viewport/transform_tool.h"
#include "viewport/viewport.h"

namespace ripstop {

std::vector<MenuRow> designRows(const Workbench& bench)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    TransformTool& tool = bench.viewport.transformTool();
    const auto shaping = [&tool](Shaping wanted) {
        return
            [&tool, wanted] { tool.setShaping(tool.shaping() == wanted ? Shaping::None : wanted); };
    };
    const MenuRow line{"&Design", nullptr, {}, nullptr, {}, {}, {}};
    // clang-format off
    return {
        {"&Design", "move",   tr("&Move"),   "move",   QKeySequence("G"), tr("Move what is selected: pull an arrow, a square or the middle, or type how far."), shaping(Shaping::Move), Toggle::Off},
        {"&Design", "rotate", tr("&Rotate"), "rotate", QKeySequence("R"), tr("Turn what is selected: pull a ring, or type an angle."), shaping(Shaping::Turn), Toggle::Off},
        {"&Design", "scale",  tr("&Scale"),  "scale",  QKeySequence("S"), tr("Make what is selected larger or smaller: pull a box or the middle, or type a factor."), shaping(Shaping::Scale), Toggle::Off},
    };
    // clang-format on
}

} // namespace ripstop
