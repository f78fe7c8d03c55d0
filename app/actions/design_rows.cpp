// Stages: Shaper holds what these actions do to the selection: transform tools, operations with a
// dialog, alignment, pins, copies. Each goes back to the design first where the change would
// otherwise meet a run, and says in the status bar what has to be selected when there is nothing
// to do. addAlignRows() makes the rows for three axes and three sides; designRows() has the table
// of all others and puts those rows before Flatten.
#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "dialogs/map_dialog.h"
#include "dialogs/operation_dialog.h"
#include "docks/docks.h"
#include "document/clipboard.h"
#include "document/document.h"
#include "document/selection.h"
#include "document/words.h"
#include "inspector/material_step.h"
#include "outline/outline.h"
#include "shaping/align.h"
#include "shaping/pin.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QMainWindow>
#include <QStatusBar>

namespace ripstop {
namespace {

constexpr std::array<std::array<const char*, 3>, 3> alignIds{
    {{"alignLeastX", "alignMiddleX", "alignMostX"},
     {"alignLeastY", "alignMiddleY", "alignMostY"},
     {"alignLeastZ", "alignMiddleZ", "alignMostZ"}}};
constexpr std::array<const char*, 3> distributeIds{"distributeX", "distributeY", "distributeZ"};

// What shapes the design. Operations leave a run that is shown and go back to the design first; the
// tools refuse it.
class Shaper
{
public:
    explicit Shaper(const Workbench& bench)
        : m_document(bench.document)
        , m_selection(bench.selection)
        , m_tool(bench.viewport.transformTool())
        , m_pointing(bench.viewport.pointing())
        , m_outline(bench.docks.panel<Outline>())
        , m_window(bench.window)
    {}

    // One tool at a time: another would have its options under those of this one.
    void choose(Shaping shaping) const
    {
        if (m_tool.shaping() != shaping && !m_tool.canBegin())
            return;
        while (m_pointing.hasTool() && m_pointing.escape()) {
        }
        m_tool.setShaping(m_tool.shaping() == shaping ? Shaping::None : shaping);
    }

    void operate(const char* name) const
    {
        m_tool.goToDesign();
        OperationDialog(*findOperation(name), m_document, m_selection, &m_window).exec();
    }

    void map() const
    {
        m_tool.goToDesign();
        MapDialog(m_document, m_selection, &m_window).exec();
    }

    void align(int axis, Side side) const
    {
        push(aligned(m_document.scene(), m_selection.ids(), axis, side, m_tool.restLengths()),
             tr("Select two or more things to align."));
    }

    void distribute(int axis) const
    {
        push(distributed(m_document.scene(), m_selection.ids(), axis, m_tool.restLengths()),
             tr("Select three or more things to distribute."));
    }

    void flatten() const
    {
        push(flattened(m_document.scene(), m_selection.ids(), m_tool.restLengths()),
             tr("Select three or more particles to flatten."));
    }

    void pin() const
    {
        const bool all = allPinned(m_document.scene(), m_selection.ids());
        Edit edit = pinning(m_document.scene(), m_selection.ids(), !all);
        if (edit.changes.empty())
            return say(tr("Select particles to pin."));
        m_document.push(std::move(edit));
        say(all ? tr("Unpinned.") : tr("Pinned."));
    }

    void stepMaterial(MaterialStep step) const
    {
        say(stepSelected(m_document, m_selection.ids(), step));
    }

    void duplicate() const
    {
        m_tool.goToDesign();
        take(duplicated(m_document.scene(), m_selection.ids(), {Motion{}}, Message("Duplicate")));
    }

    void copy() const
    {
        copyToClipboard(m_document.scene(), m_selection.ids());
        say(tr("Copied."));
    }

    void cut() const
    {
        copyToClipboard(m_document.scene(), m_selection.ids());
        m_outline.removeSelected();
    }

    void paste() const
    {
        Result<Copies> copies = pasteFromClipboard(m_document.scene());
        if (!copies)
            return say(translated(copies.message()));
        m_tool.goToDesign();
        take(std::move(*copies));
    }

private:
    void say(const QString& text) const { m_window.statusBar()->showMessage(text, messageTime); }

    void push(Edit edit, const QString& otherwise) const
    {
        if (edit.changes.empty())
            return say(otherwise);
        m_tool.goToDesign();
        m_document.push(std::move(edit));
    }

    // Copies lie on their originals: the next thing to do is to move them.
    void take(Copies copies) const
    {
        if (copies.edit.changes.empty())
            return say(tr("Select what is to be copied first."));
        m_document.push(std::move(copies.edit));
        m_selection.set(std::move(copies.ids));
        m_tool.setShaping(Shaping::Move);
    }

    Document& m_document;
    Selection& m_selection;
    TransformTool& m_tool;
    Pointing& m_pointing;
    Outline& m_outline;
    QMainWindow& m_window;
};

void addAlignRows(MenuRows& rows, const Shaper& shaper)
{
    const std::array<QString, 3> sides{tr("Least %1"), tr("Middle %1"), tr("Most %1")};
    const std::array<QString, 3> tips{tr("Bring all to the least %1 of what is selected."),
                                      tr("Bring all to the middle of what is selected along %1."),
                                      tr("Bring all to the greatest %1 of what is selected.")};
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 3; ++side) {
            const QChar name('x' + axis);
            rows.push_back({"&Design/&Align",
                            alignIds[std::size_t(axis)][std::size_t(side)],
                            sides[std::size_t(side)].arg(name),
                            nullptr,
                            {},
                            tips[std::size_t(side)].arg(name),
                            [=] { shaper.align(axis, Side(side)); },
                            Toggle::No,
                            nullptr,
                            Needs::Selection});
        }
    for (int axis = 0; axis < 3; ++axis) {
        const QChar name('x' + axis);
        rows.push_back({"&Design/D&istribute",
                        distributeIds[std::size_t(axis)],
                        tr("Along %1").arg(name),
                        nullptr,
                        {},
                        tr("Even steps along %1 between the outermost ones.").arg(name),
                        [=] { shaper.distribute(axis); },
                        Toggle::No,
                        nullptr,
                        Needs::Selection});
    }
}

} // namespace

MenuRows designRows(const Workbench& bench)
{
    const Shaper shaper(bench);
    const auto shaping = [&](Shaping wanted) { return [=] { shaper.choose(wanted); }; };
    const auto operation = [&](const char* name) { return [=] { shaper.operate(name); }; };
    const auto step = [&](MaterialStep way) { return [=] { shaper.stepMaterial(way); }; };
    const auto no = Toggle::No;
    const auto some = Needs::Selection;
    const MenuRow line = lineIn("&Design");
    // clang-format off
    MenuRows rows{
        lineIn("&Edit"),
        {"&Edit", "cut",       tr("Cu&t"),         nullptr,  QKeySequence::Cut,       tr("Copy what is selected, and remove it."), [=] { shaper.cut(); }, no, nullptr, some},
        {"&Edit", "copy",      tr("&Copy"),        nullptr,  QKeySequence::Copy,      tr("Copy what is selected, with the links and panels among it, for this or another scene."), [=] { shaper.copy(); }, no, nullptr, some},
        {"&Edit", "paste",     tr("&Paste"),       nullptr,  QKeySequence::Paste,     tr("Put what was copied into this scene, as a part of its own, and move it."), [=] { shaper.paste(); }},
        {"&Edit", "duplicate", tr("D&uplicate"),   nullptr,  QKeySequence("Shift+D"), tr("Copy what is selected within its part, and move the copy."), [=] { shaper.duplicate(); }, no, nullptr, some},

        {"&Design", "move",   tr("&Move"),         "move",   QKeySequence("G"),       tr("Move what is selected: pull an arrow, a square or the middle, or type how far."), shaping(Shaping::Move), Toggle::Off},
        {"&Design", "rotate", tr("&Rotate"),       "rotate", QKeySequence("R"),       tr("Turn what is selected: pull a ring, or type an angle."), shaping(Shaping::Turn), Toggle::Off},
        {"&Design", "scale",  tr("&Scale"),        "scale",  QKeySequence("S"),       tr("Make what is selected larger or smaller: pull a box or the middle, or type a factor."), shaping(Shaping::Scale), Toggle::Off},
        line,
        {"&Design", "mirror", tr("Mirr&or…"),      nullptr,  QKeySequence("Ctrl+M"),  tr("Add the other half of what is selected, in one piece with it."), operation("mirror"), no, nullptr, some},
        {"&Design", "row",    tr("Array in a ro&w…"), nullptr, {},                    tr("Copies in a row: ribs, rows of lines."), operation("row"), no, nullptr, some},
        {"&Design", "ring",   tr("Array in a rin&g…"), nullptr, {},                   tr("Copies around an axis: gores, spokes."), operation("ring"), no, nullptr, some},
        line,
        {"&Design", "flatten", tr("&Flatten"),     nullptr,  {},                      tr("Put what is selected into the plane that fits it best."), [=] { shaper.flatten(); }, no, nullptr, some},
        {"&Design", "smooth", tr("Smoo&th…"),      nullptr,  {},                      tr("Take bumps and creases out of the selected fabric and lines."), operation("smooth"), no, nullptr, some},
        {"&Design", "weld",   tr("W&eld…"),        nullptr,  QKeySequence("M"),       tr("Make one particle of those that lie together, or of all that are selected."), operation("weld"), no, nullptr, some},
        {"&Design", "split",  tr("S&plit links…"), nullptr,  {},                      tr("Make several links of each selected one, with particles between them."), operation("split"), no, nullptr, some},
        {"&Design", "panels", tr("T&hreads to panels…"), nullptr, {},                 tr("Have the panels of the selected parts carry the pull of their fabric, in place of threads."), operation("panels"), no, nullptr, some},
        line,
        {"&Design", "pin",    tr("Pi&n or unpin"), "pin",    QKeySequence("P"),       tr("Hold the selected particles where they are, or let them go when all are held."), [=] { shaper.pin(); }, no, nullptr, some},
        {"&Design", "guide",  tr("Free along a line or &in a plane…"), nullptr, QKeySequence("Ctrl+Alt+P"), tr("Let the selected particles slide along a line or in a plane only, as rings on a rail: along x, y or z, or as two or three selected particles lie."), operation("guide"), no, nullptr, some},
        {"&Design", "map",    tr("Map by a form&ula…"), nullptr, {},                  tr("Set a number of what is selected, such as the tear limit, by a formula of where it lies or by a picture: worn places, patches, a grain that fans out."), [=] { shaper.map(); }, no, nullptr, some},
        {"&Design/Mate&rial", "lighter", tr("&Lighter"), nullptr, {}, tr("The next lighter material of the library for what is selected; masses follow."), step(MaterialStep::Lighter), no, nullptr, some},
        {"&Design/Mate&rial", "heavier", tr("&Heavier"), nullptr, {}, tr("The next heavier material of the library for what is selected; masses follow."), step(MaterialStep::Heavier), no, nullptr, some},
        {"&Design/Mate&rial", "softer", tr("&Softer"), nullptr, {}, tr("The next softer material of the library for what is selected, by E t, EA or EI; masses follow."), step(MaterialStep::Softer), no, nullptr, some},
        {"&Design/Mate&rial", "stiffer", tr("S&tiffer"), nullptr, {}, tr("The next stiffer material of the library for what is selected, by E t, EA or EI; masses follow."), step(MaterialStep::Stiffer), no, nullptr, some},
        {"&Design/Mate&rial", "weaker", tr("&Weaker"), nullptr, {}, tr("The next weaker material of the library for what is selected; masses follow."), step(MaterialStep::Weaker), no, nullptr, some},
        {"&Design/Mate&rial", "stronger", tr("Str&onger"), nullptr, {}, tr("The next stronger material of the library for what is selected, by what it can bear; masses follow."), step(MaterialStep::Stronger), no, nullptr, some},
        {"&Design", "mass",   tr("M&ass…"),        nullptr,  QKeySequence("Ctrl+Shift+M"), tr("Give the selected particles mass: each, by length, by area, or a total to share."), operation("mass"), no, nullptr, some},
    };
    // clang-format on
    MenuRows lines;
    addAlignRows(lines, shaper);
    const auto flatten = std::ranges::find_if(
        rows, [](const MenuRow& row) { return row.id && QLatin1String(row.id) == "flatten"; });
    rows.insert(flatten, lines.begin(), lines.end());
    return rows;
}

} // namespace ripstop
