#include "actions/tuning_rows.h"

#include "inspector/inspector.h"
#include "inspector/tuning_panel.h"

namespace ripstop {

std::vector<MenuRow> tuningActionRows(const Workbench& bench)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    TuningPanel& tuning = bench.tuning;
    Inspector& inspector = bench.inspector;
    const auto show = bench.showDock;
    // clang-format off
    return {
        {"&Run", nullptr, {}, nullptr, {}, {}, {}},
        {"&Run", "tuning",      tr("Sl&iders"),            "slider",  QKeySequence("T"),    tr("Show the sliders that tune the design while it flies."), [show] { show("tuning"); }},
        {"&Run", "usualSliders", tr("Add the &usual sliders"), nullptr, {},                   tr("Wind, stiffness, damping, tear limit and the settings of the solver, as far as they have an effect here."), [&tuning, show] { show("tuning"); tuning.addUsual(); }},
        {"&Run", "switchSets",  tr("Switch &A and B"),     nullptr,   QKeySequence("Ctrl+Shift+T"), tr("Go to the other set of slider values, to compare the two."), [&tuning] { tuning.switchSets(); }},
        {"&Run", "keepSliders", tr("&Keep slider values"), nullptr,   {},                   tr("Make the present values those that resetting the sliders goes back to."), [&tuning] { tuning.keep(); }},
        {"&Run", "resetSliders", tr("Re&set sliders"),     nullptr,   {},                   tr("All sliders back to the values they had when they were added or last kept."), [&tuning] { tuning.reset(); }},
        {"&Tools", "table",     tr("&Table of numbers"),   "table",   QKeySequence("Shift+T"), tr("Particles, links, lines, panels and materials as a spreadsheet."), [show] { show("table"); }},
        {"&Edit", "findProperty", tr("Find a propert&y"),  "inspector", QKeySequence("Ctrl+Shift+P"), tr("Search the inspector for a property by its name or its help."), [show, &inspector] { show("inspector"); inspector.startSearch(); }},
    };
    // clang-format on
}

} // namespace ripstop
