#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "docks/docks.h"
#include "inspector/tuning_panel.h"
#include "study/study_panel.h"

namespace ripstop {

MenuRows tuningRows(const Workbench& bench)
{
    Docks& docks = bench.docks;
    auto& tuning = docks.panel<TuningPanel>();
    // clang-format off
    return {
        lineIn("&Run"),
        {"&Run", "tuning",      tr("Sl&iders"),            "slider",  QKeySequence("T"),    tr("Show the sliders that tune the design while it flies."), [&docks] { docks.show("tuning"); }},
        {"&Run", "study",       tr("Stu&dy"),              nullptr,   {},                   tr("Fly the design many times with other values, and see for which of them it holds."), [&docks] { docks.show("study"); }},
        {"&Run", "openStudy",   tr("Open a study…"),       nullptr,   {},                   tr("See the map of a study that was saved, or fly what is missing of it."), [&docks] { docks.show("study"); docks.panel<StudyPanel>().browse(); }},
        {"&Run", "usualSliders", tr("Add the &usual sliders"), nullptr, {},                   tr("Wind, E t, G t, EA, EI and strength of what materials are, stiffness, damping and tear limit of what they are not, and the settings of the solver, as far as they have an effect here. Of what is selected only, if it is made of something."), [&docks, &tuning] { docks.show("tuning"); tuning.addUsual(); }},
        {"&Run", "switchSets",  tr("Switch &A and B"),     nullptr,   QKeySequence("Ctrl+Shift+T"), tr("Go to the other set of slider values, to compare the two."), [&tuning] { tuning.switchSets(); }},
        {"&Run", "keepSliders", tr("&Keep slider values"), nullptr,   {},                   tr("Make the present values those that resetting the sliders goes back to."), [&tuning] { tuning.keep(); }},
        {"&Run", "resetSliders", tr("Re&set sliders"),     nullptr,   {},                   tr("All sliders back to the values they had when they were added or last kept."), [&tuning] { tuning.reset(); }},
    };
    // clang-format on
}

} // namespace ripstop
