#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "docks/docks.h"
#include "document/recordings.h"
#include "files/run_files.h"
#include "timeline/timeline.h"

namespace ripstop {

MenuRows timelineRows(const Workbench& bench)
{
    using Way = Recordings::Way;
    Docks& docks = bench.docks;
    Recordings& runs = bench.recordings;
    auto& timeline = docks.panel<Timeline>();
    RunFiles& files = bench.runFiles;
    const auto playBack = [&docks, &runs] {
        docks.show("timeline");
        runs.isPlaying() ? runs.pause() : runs.play();
    };
    const MenuRow line = lineIn("Ti&meline");
    // clang-format off
    return {
        {"Ti&meline", "timeline",   tr("&Show the timeline"),   "timeline",   QKeySequence("Shift+L"),     tr("Look back at runs: every moment is kept."), [&docks] { docks.show("timeline"); }},
        {"Ti&meline", "playBack",   tr("&Play back"),           "play",       QKeySequence("Shift+Space"), tr("Play the recording back from where you look, or hold it."), playBack},
        {"Ti&meline", "frameBack",  tr("A frame &back"),        "step-back",  QKeySequence("Alt+Left"),    tr("Look at the frame before."), [&runs] { runs.move(-1); }},
        {"Ti&meline", "frameOn",    tr("A frame &on"),          "step",       QKeySequence("Alt+Right"),   tr("Look at the next frame."), [&runs] { runs.move(1); }},
        {"Ti&meline", "eventBack",  tr("Pre&vious event"),      "event-back", QKeySequence("Alt+Up"),      tr("Back to the tear, edit, hand or control before."), [&runs] { runs.toEvent(Way::Back); }},
        {"Ti&meline", "eventOn",    tr("&Next event"),          "event-next", QKeySequence("Alt+Down"),    tr("On to the next tear, edit, hand or control."), [&runs] { runs.toEvent(Way::Forward); }},
        {"Ti&meline", "markBack",   tr("Previous bookm&ark"),   nullptr,      QKeySequence("Ctrl+Alt+Up"), tr("Back to the bookmark before."), [&runs] { runs.toBookmark(Way::Back); }},
        {"Ti&meline", "markOn",     tr("Next boo&kmark"),       nullptr,      QKeySequence("Ctrl+Alt+Down"), tr("On to the next bookmark."), [&runs] { runs.toBookmark(Way::Forward); }},
        {"Ti&meline", "mark",       tr("Book&mark this moment…"), "bookmark", QKeySequence("Ctrl+Alt+M"),  tr("Give this moment a name, to find it again."), [&timeline] { timeline.askForBookmark(); }},
        line,
        {"Ti&meline", "continueHere", tr("&Continue from here"), "branch",    QKeySequence("Ctrl+Alt+Space"), tr("Begin a new run at this moment, with the design as it is now. The run that is shown is kept."), [&runs] { runs.continueHere(); }},
        {"Ti&meline", "backToLive", tr("Back to the &run"),     "live",       QKeySequence("Alt+End"),     tr("Show the run as it stands now."), [&runs] { runs.backToLive(); }},
        {"Ti&meline", "compare",     tr("C&ompare with…"),      "compare",    {},                          tr("Show another run at the same time as a ghost, and plot how far the two are apart."), [&docks, &timeline] { docks.show("timeline"); timeline.askWhatToCompare(); }},
        {"Ti&meline", "loopFrom",   tr("Loop &from here on"),   "loop",       {},                          tr("Playback repeats what follows this moment."), [&timeline] { timeline.loopFromHere(); }},
        {"Ti&meline", "loopTo",     tr("Loop up &to here"),     nullptr,      {},                          tr("Playback repeats what was before this moment."), [&timeline] { timeline.loopToHere(); }},
        {"Ti&meline", "noLoop",     tr("No &loop"),             nullptr,      {},                          tr("Playback ends where the run does."), [&runs] { runs.setLoop({}); }},
        {"Ti&meline", "renameRun",  tr("Rename the r&un…"),     nullptr,      {},                          tr("Give the run that is shown another name."), [&timeline] { timeline.rename(); }},
        {"Ti&meline", "removeRun",  tr("Remove this run"),      "delete",     {},                          tr("Forget the run that is shown; the design stays as it is."), [&runs] { runs.remove(runs.current()); }},
        line,
        {"Ti&meline", "recordingMemory", tr("M&emory for recordings…"), nullptr, {},                       tr("How much of a run stays in memory before it goes to the disk."), [&files] { files.askForMemory(); }},
    };
    // clang-format on
}

} // namespace ripstop
