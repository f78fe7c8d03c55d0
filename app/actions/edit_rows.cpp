#include "actions/menu_rows.h"

#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "docks/docks.h"
#include "document/document.h"
#include "outline/outline.h"

namespace ripstop {

MenuRows editRows(const Workbench& bench)
{
    Document& document = bench.document;
    auto& outline = bench.docks.panel<Outline>();
    // clang-format off
    return {
        {"&Edit", "undo",       tr("&Undo"),               "undo",    QKeySequence::Undo,   tr("Take back the last edit."), [&document] { document.history().undo(); }},
        {"&Edit", "redo",       tr("&Redo"),               "redo",    QKeySequence("Ctrl+Shift+Z"), tr("Make the last edit again that was taken back."), [&document] { document.history().redo(); }},
        lineIn("&Edit"),
        {"&Edit", "delete",     tr("&Delete"),             "delete",  QKeySequence::Delete, tr("Remove what is selected, and all that hangs on it."), [&outline] { outline.removeSelected(); }, Toggle::No, nullptr, Needs::Selection},
        {"&Edit", "find",       tr("&Find in outline"),    "search",  QKeySequence::Find,   tr("Search the outline by name."), [&outline] { outline.focusSearch(); }},
        {"&Edit", "preferences", tr("Pre&ferences…"),      nullptr,   QKeySequence("Ctrl+,"), tr("Theme, language and memory, on one page."), [&bench] { bench.dialogs.showPreferences(bench.actions, bench.runFiles); }},
    };
    // clang-format on
}

} // namespace ripstop
