#include "actions/timeline_rows.h"

#include "document/recordings.h"
#include "files/run_files.h"
#include "timeline/timeline.h"

namespace ripstop {

std::vector<MenuRow> recordingFileRows(const Workbench& bench)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    RunFiles& files = bench.runFiles;
    // clang-format off
    return {
        {"&File", nullptr, {}, nullptr, {}, {}, {}},
        {"&File", "openRun", tr("Open reco&rding…"), nullptr, QKeySequence("Ctrl+Alt+O"), tr("Look at a run that was saved, compare with it, or go on from it."), [&files] { files.browse(); }},
        {"&File", "saveRun", tr("Sa&ve recording…"), nullptr, QKeySequence("Ctrl+Alt+S"), tr("Save the run that the timeline shows, every step of it."), [&files] { files.save(); }},
    };
    // clang-format on
}

std::vector<MenuRow> timelineRows(const Workbench& bench)
{
    const auto tr = [](const char* text) { return Actions::tr(text); };
    using Way = Recordings::Way;
    Recordings& runs = bench.recordings;
    Timeline& timeline = bench.timeline;
    RunFiles& files = bench.runFiles;
    const auto show = bench.showDock;
    const auto playBack = [&runs, show] {
        show("timeline");
        runs.isPlaying() ? runs.pause() : runs.play();
    };
    const MenuRow line{"Ti&meline", nullptr, {}, nullptr, {}, {}, {}};
    // clang-format off
    return {
        {"Ti&meline", "timeline",   tr("&Show the timeline"),   "timeline",   QKeySequence("Shift+L"),     tr("Look back at runs: every moment is kept."), [show] { show("timeline"); }},
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
        {"Ti&meline", "compare",     tr("C&ompare with…"),      "compare",    {},                          tr("Show another run at the same time as a ghost, and plot how far the two are apart."), [&timeline, show] { show("timeline"); timeline.askWhatToCompare(); }},
        {"Ti&meline", "renameRun",  tr("Rename the r&un…"),     nullptr,      {},                          tr("Give the run that is shown another name."), [&timeline] { timeline.rename(); }},
        line,
        {"Ti&meline", "recordingMemory", tr("M&emory for recordings…"), nullptr, {},                       tr("How much of a run stays in memory before it goes to the disk."), [&files] { files.askForMemory(); }},
    };
    // clang-format on
}

} // namespace ripstop
