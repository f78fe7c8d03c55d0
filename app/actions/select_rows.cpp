// Stages: the functions at the top each make what a row runs: a selection from the selection, from
// a condition, from a kind or from a region drawn with the mouse. Those that find nothing leave
// the selection as it was and say so, except where nothing is a sensible answer (reducing()). Then
// come the rows of pointing, of types and the rest, and selectRows() puts them in the order of the
// menu.
#include "actions/menu_rows.h"

#include "actions/actions.h"
#include "actions/dialogs.h"
#include "actions/group_menus.h"
#include "actions/workbench.h"
#include "document/document.h"
#include "document/selection.h"
#include "select/condition.h"
#include "select/select.h"
#include "tools/pointing.h"
#include "tools/region_tool.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QStatusBar>

namespace ripstop {
namespace {

// A selection of nothing is most likely not what was wanted: it says so and leaves the old one.
void choose(const Workbench& bench, std::vector<Id> ids)
{
    if (!ids.empty())
        return bench.selection.set(std::move(ids));
    bench.window.statusBar()->showMessage(tr("There is none of that here; the selection stays."),
                                          5000);
}

// An open list takes the Escape key first.
void deselect(Selection& selection)
{
    if (QWidget* list = QApplication::activePopupWidget())
        list->close();
    else
        selection.clear();
}

// Makes a selection from the selection.
std::function<void()> selecting(const Workbench& bench,
                                std::vector<Id> (*from)(const Scene&, const std::vector<Id>&))
{
    return [&bench, from] { choose(bench, from(bench.document.scene(), bench.selection.ids())); };
}

// Makes a selection that may well be empty: the inverse of everything, or one ring less than a
// ring.
std::function<void()> reducing(const Workbench& bench,
                               std::vector<Id> (*from)(const Scene&, const std::vector<Id>&))
{
    return [&bench, from] {
        bench.selection.set(from(bench.document.scene(), bench.selection.ids()));
    };
}

std::function<void()> turning(const Workbench& bench, Kind kind)
{
    return [&bench, kind] {
        choose(bench, turnedInto(kind, bench.document.scene(), bench.selection.ids()));
    };
}

std::function<void()> likening(const Workbench& bench, Alike alike)
{
    return [&document = bench.document, &selection = bench.selection, alike] {
        selection.set(similar(alike, document.scene(), selection.ids()));
    };
}

// Lines that go on: says so where none does, which would look like an action that does nothing.
std::function<void()> following(const Workbench& bench)
{
    return [&bench] {
        const Scene& scene = bench.document.scene();
        const std::vector<Id> before = elementsOf(scene, bench.selection.ids());
        std::vector<Id> ids = loop(scene, bench.selection.ids());
        if (ids == before)
            bench.window.statusBar()->showMessage(
                tr("Nothing goes on from here: take a link or a particle of an edge."),
                messageTime);
        else
            bench.selection.set(std::move(ids));
    };
}

std::function<void()> drawing(const Workbench& bench, RegionTool::Shape shape)
{
    return [&selection = bench.selection, &viewport = bench.viewport, &actions = bench.actions,
            shape] {
        const auto options = [&pointing = viewport.pointing(), &actions] {
            return RegionTool::Options{pointing.pickable, actions["through"]->isChecked()
                                                              ? Depth::Through
                                                              : Depth::Visible};
        };
        viewport.pointing().setTool(std::make_unique<RegionTool>(shape, selection, options));
        viewport.setFocus(); // so that Escape reaches it
    };
}

std::function<void()> taking(const Workbench& bench, const char* id, bool ElementKinds::*kind)
{
    return [&viewport = bench.viewport, &actions = bench.actions, id, kind] {
        viewport.pointing().pickable.wanted.*kind = actions[id]->isChecked();
    };
}

// Selects all elements that meet a condition, or all of a kind.
std::function<void()> finding(const Workbench& bench, const char* condition)
{
    return [&bench, condition] {
        if (const auto ids = matching(bench.document.scene(), {}, condition))
            choose(bench, *ids);
    };
}

template <typename Row>
std::function<void()> finding(const Workbench& bench, std::vector<const Row*> Elements::*kind)
{
    return [&bench, kind] {
        std::vector<Id> ids;
        const Elements all = everyElement(bench.document.scene());
        for (const Row* row : all.*kind)
            ids.push_back(row->id);
        choose(bench, std::move(ids));
    };
}

MenuRows pointingRows(const Workbench& bench)
{
    const auto draw = [&](RegionTool::Shape shape) { return drawing(bench, shape); };
    const auto take = [&](const char* id, bool ElementKinds::*kind) {
        return taking(bench, id, kind);
    };
    const MenuRow line = lineIn("&Select");
    using Shape = RegionTool::Shape;
    // clang-format off
    return {
        {"&Select", "toolPointer", tr("&Pointer"),     "tool-pointer", {}, tr("A click takes what is under it, Shift adds, Ctrl takes away; a drag turns the view. Escape comes back to this."), [&viewport = bench.viewport] { viewport.pointing().setTool(nullptr); }, Toggle::On, "tool"},
        {"&Select", "toolBox",     tr("&Box"),         "tool-box",     QKeySequence("B"), tr("Drag a box around what to select; Shift adds, Ctrl takes away; a right drag turns the view."), draw(Shape::Box), Toggle::Off, "tool"},
        {"&Select", "toolLasso",   tr("&Lasso"),       "tool-lasso",   QKeySequence("L"), tr("Draw a line around what to select; Shift adds, Ctrl takes away; a right drag turns the view."), draw(Shape::Lasso), Toggle::Off, "tool"},
        {"&Select", "through",     tr("Select t&hrough"), "through",   QKeySequence("Alt+Z"), tr("Box and lasso also take what is hidden behind fabric and colliders, and the knife cuts it."), [] {}, Toggle::Off},
        {"&Select/Mouse ta&kes", "takeParticles", tr("&Particles"), "particle", {}, tr("Clicks, box and lasso take particles; with links and panels off also those without a dot."), take("takeParticles", &ElementKinds::particles), Toggle::On},
        {"&Select/Mouse ta&kes", "takeLinks",     tr("&Links"),     "link",     {}, tr("Clicks, box and lasso take links."), take("takeLinks", &ElementKinds::links), Toggle::On},
        {"&Select/Mouse ta&kes", "takePanels",    tr("P&anels"),    "panel",    {}, tr("Clicks, box and lasso take panels."), take("takePanels", &ElementKinds::panels), Toggle::On},
        line,
    };
    // clang-format on
}

MenuRows typeRows(const Workbench& bench)
{
    const auto find = [&](auto what) { return finding(bench, what); };
    // clang-format off
    return {
        {"&Select/By &type", "allParticles", tr("&Particles"),        "particle", {}, tr("All particles."), find(&Elements::particles)},
        {"&Select/By &type", "allPinned",    tr("P&inned particles"), "pin",      {}, tr("All particles that are held in place."), find("pinned")},
        {"&Select/By &type", "allGuided",    tr("Particles on &guides"), nullptr,  {}, tr("All particles that are free along a line or in a plane only."), find("guide != none")},
        {"&Select/By &type", "allFree",      tr("&Free particles"),   nullptr,    {}, tr("All particles that can move."), find("not pinned")},
        {"&Select/By &type", "allLinks",     tr("&Links"),            "link",     {}, tr("All springs and rods."), find(&Elements::links)},
        {"&Select/By &type", "allSprings",   tr("&Springs"),          "spring",   {}, tr("All links that pull with a force."), find("kind = spring")},
        {"&Select/By &type", "allRods",      tr("&Rods"),             "rod",      {}, tr("All links that keep their length."), find("kind = rod")},
        {"&Select/By &type", "allLines",     tr("Li&nes and spars"),  nullptr,    {}, tr("All links that stand for a line or a spar by itself."), find("role = line")},
        {"&Select/By &type", "allThreads",   tr("&Threads"),          nullptr,    {}, tr("All links that run along the threads of a fabric."), find("role = thread")},
        {"&Select/By &type", "allBiases",    tr("&Bias"),             nullptr,    {}, tr("All links that stand for the shear of a fabric."), find("role = bias")},
        {"&Select/By &type", "allPanels",    tr("P&anels"),           "panel",    {}, tr("All panels."), find(&Elements::panels)},
    };
    // clang-format on
}

} // namespace

MenuRows selectRows(const Workbench& bench)
{
    const auto from = [&](auto function) { return selecting(bench, function); };
    const auto into = [&](Kind kind) { return turning(bench, kind); };
    const auto like = [&](Alike alike) { return likening(bench, alike); };
    const auto all = [&document = bench.document, &selection = bench.selection] {
        selection.set(everyElement(document.scene()).ids());
    };
    const MenuRow line = lineIn("&Select");
    const auto no = Toggle::No;
    const auto some = Needs::Selection;
    MenuRows rows = pointingRows(bench);
    // clang-format off
    const MenuRows more{
        {"&Select", "selectAll", tr("&All"),        "select-all", QKeySequence::SelectAll, tr("Select all particles, links and panels."), all},
        {"&Select", "deselect",  tr("Non&e"),       "deselect",   QKeySequence("Esc"),     tr("Select nothing; the inspector then shows the settings."), [&selection = bench.selection] { deselect(selection); }, no, nullptr, some},
        {"&Select", "invert",    tr("&Invert"),     nullptr,      QKeySequence("Ctrl+I"),  tr("Select all others of the same kinds: the other particles, where particles are selected."), reducing(bench, inverted)},
        line,
        {"&Select", "grow",      tr("&Grow"),       nullptr,      QKeySequence("Ctrl++"),  tr("Add one ring: the neighbours of particles, the links and panels that touch the selected ones."), from(grown), no, nullptr, some},
        {"&Select", "shrink",    tr("&Shrink"),     nullptr,      QKeySequence("Ctrl+-"),  tr("Take one ring away: whatever has a neighbour that is not selected."), reducing(bench, shrunk), no, nullptr, some},
        {"&Select", "connected", tr("Co&nnected"),  nullptr,      QKeySequence("Ctrl+L"),  tr("Add all that hangs together with the selection by links and panels."), from(connected), no, nullptr, some},
        {"&Select", "loop",      tr("L&oop or line"), nullptr,    QKeySequence("Ctrl+Shift+L"), tr("Follow the selected links or particles both ways: along a line, along a thread, around an edge. Of two particles on an edge, the stretch between them."), following(bench), no, nullptr, some},
        {"&Select", "boundary",  tr("Edge o&f fabric"), nullptr,  QKeySequence("Ctrl+Shift+B"), tr("The edge of the selected panels, or of all fabric."), from(boundary)},
        {"&Select/&Turn into", "toParticles", tr("&Particles"), "particle", {}, tr("The particles at the ends of the selected links and the corners of the selected panels."), into(Kind::Particle), no, nullptr, some},
        {"&Select/&Turn into", "toLinks",     tr("&Links"),     "link",     {}, tr("The links between the selected."), into(Kind::Link), no, nullptr, some},
        {"&Select/&Turn into", "toPanels",    tr("P&anels"),    "panel",    {}, tr("The panels between the selected."), into(Kind::Panel), no, nullptr, some},
        line,
        {"&Select", "byProperty", tr("By &property…"), "search", QKeySequence("Ctrl+Shift+F"), tr("Select by what things are: strain > 5 %, mass < 1 g, material = ripstop."), [&dialogs = bench.dialogs] { dialogs.showCondition(); }},
        {"&Select/Si&milar", "likeType",     tr("Same &type"),     nullptr, {}, tr("All springs where a spring is selected, all rods, pinned particles, free particles, panels."), like(Alike::Type), no, nullptr, some},
        {"&Select/Si&milar", "likeMaterial", tr("Same &material"), nullptr, {}, tr("All links and panels of the materials of the selected ones."), like(Alike::Material), no, nullptr, some},
        {"&Select/Si&milar", "likeRole",     tr("Same &role"),     nullptr, {}, tr("All links of the role of the selected ones: line, thread or bias."), like(Alike::Role), no, nullptr, some},
        {"&Select/Si&milar", "likeMeasure",  tr("Same &size"),     nullptr, {}, tr("All with the mass, the rest length or the area of the selected ones, within 1 %."), like(Alike::Measure), no, nullptr, some},
        {"&Select/Si&milar", "likeGroup",    tr("Same &group"),    nullptr, {}, tr("All members of the groups that the selected ones belong to."), like(Alike::Group), no, nullptr, some},
        {"&Select/Si&milar", "likePart",     tr("Same &part"),     nullptr, {}, tr("All elements of these kinds in the same parts."), like(Alike::Part), no, nullptr, some},
    };
    // clang-format on
    rows.insert(rows.end(), more.begin(), more.end());
    const MenuRows types = typeRows(bench);
    rows.insert(rows.end(), types.begin(), types.end());
    rows.push_back(line);
    rows.push_back({"&Select", "group", tr("Group sele&ction…"), "group", QKeySequence("Ctrl+G"),
                    tr("Give the selected elements a name, as a group."),
                    [&bench] { groupSelection(bench); }, no, nullptr, some});
    return rows;
}

} // namespace ripstop
