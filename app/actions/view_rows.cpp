#include "actions/menu_rows.h"

#include "actions/actions.h"
#include "actions/workbench.h"
#include "document/selection.h"
#include "viewport/viewport.h"

#include <QAction>

namespace ripstop {

MenuRows viewRows(const Workbench& bench)
{
    Selection& selection = bench.selection;
    Viewport& viewport = bench.viewport;
    const Actions& actions = bench.actions;
    const auto showing = [&viewport, &actions](const char* id, void (Viewport::*show)(bool)) {
        return [&viewport, &actions, id, show] { (viewport.*show)(actions[id]->isChecked()); };
    };
    const auto looking = [&viewport](PresetView view) {
        return [&viewport, view] { viewport.view(view); };
    };
    const auto coloring = [&viewport](ColorBy colorBy) {
        return [&viewport, colorBy] { viewport.setColorBy(colorBy); };
    };
    const auto arrows = [&viewport](Vectors vectors) {
        return [&viewport, vectors] { viewport.setVectors(vectors); };
    };
    const MenuRow line = lineIn("&View");
    // clang-format off
    return {
        {"&View", "fit",        tr("&Fit"),                "fit",     QKeySequence("Home"), tr("Show the whole scene."), [&viewport] { viewport.fit(); }},
        {"&View", "fitSelected", tr("Fit sele&ction"),     nullptr,   QKeySequence("F"),    tr("Show what is selected, or the whole scene when nothing is."), [&viewport, &selection] { viewport.fit(selection.ids()); }},
        {"&View", "follow",     tr("F&ollow"),             "follow",  QKeySequence("Shift+F"), tr("The camera goes with the fabric."), showing("follow", &Viewport::setFollow), Toggle::On},
        {"&View", "ortho",      tr("O&rthographic"),       "orthographic", QKeySequence("5"), tr("Without perspective: parallels stay parallel."), showing("ortho", &Viewport::setOrthographic), Toggle::Off},
        line,
        {"&View/&Look from", "front",      tr("Fro&nt"),              "view-front", QKeySequence("1"), tr("Look from the front."), looking(PresetView::Front)},
        {"&View/&Look from", "back",       tr("&Back"),               nullptr,   QKeySequence("Ctrl+1"), tr("Look from behind."), looking(PresetView::Back)},
        {"&View/&Look from", "right",      tr("R&ight"),              "view-side", QKeySequence("3"),  tr("Look from the right."), looking(PresetView::Right)},
        {"&View/&Look from", "left",       tr("&Left"),               nullptr,   QKeySequence("Ctrl+3"), tr("Look from the left."), looking(PresetView::Left)},
        {"&View/&Look from", "top",        tr("&Top"),                "view-top", QKeySequence("7"),   tr("Look from above."), looking(PresetView::Top)},
        {"&View/&Look from", "bottom",     tr("Botto&m"),             nullptr,   QKeySequence("Ctrl+7"), tr("Look from below."), looking(PresetView::Bottom)},
        {"&View/&Look from", "home",       tr("&Corner"),             "view-home", QKeySequence("0"),  tr("Look from a corner above."), looking(PresetView::Iso)},
        {"&View/&Colours", "byMaterial", tr("Colour by &material"), nullptr,   QKeySequence("Alt+1"), tr("The colours of the materials."), coloring(ColorBy::Material), Toggle::On, "color"},
        {"&View/&Colours", "byStrain",   tr("Colour by &strain"),   "color-by", QKeySequence("Alt+2"), tr("How far links and elastic panels are stretched."), coloring(ColorBy::Strain), Toggle::Off, "color"},
        {"&View/&Colours", "byTension",  tr("Colour by t&ension"),  nullptr,   QKeySequence("Alt+3"), tr("How hard links pull."), coloring(ColorBy::Tension), Toggle::Off, "color"},
        {"&View/&Colours", "bySpeed",    tr("Colour by s&peed"),    nullptr,   QKeySequence("Alt+4"), tr("How fast particles move."), coloring(ColorBy::Speed), Toggle::Off, "color"},
        {"&View/&Colours", "byLoad",     tr("Colour by panel loa&d"), nullptr, QKeySequence("Alt+5"), tr("How hard the air pushes panels, per area."), coloring(ColorBy::PanelLoad), Toggle::Off, "color"},
        {"&View/&Colours", "byTear",     tr("Colour by tea&r limit"), nullptr, QKeySequence("Alt+6"), tr("How much of what it tears at each link bears."), coloring(ColorBy::TearLoad), Toggle::Off, "color"},
        {"&View/&Colours", "byStress",   tr("Colour by fabric stress"), nullptr, QKeySequence("Alt+7"), tr("How hard the fabric pulls per width: the largest tension of elastic panels, that of threads over the width that they stand for."), coloring(ColorBy::Stress), Toggle::Off, "color"},
        {"&View/&Colours", "byWrinkles", tr("Colour by wrinkles"), nullptr,   {},                    tr("Which elastic panels are slack, wrinkled or taut."), coloring(ColorBy::Wrinkles), Toggle::Off, "color"},
        {"&View/&Colours", "byMargin",   tr("Colour by margin"),   nullptr,   {},                    tr("Load over strength of lines, cloth and spars: 1 breaks."), coloring(ColorBy::Margin), Toggle::Off, "color"},
        {"&View/&Colours", "byStiffness", tr("Colour by stiffness factor"), nullptr, {},              tr("How many times as stiff elements are as their materials: reinforced and worn places."), coloring(ColorBy::Stiffness), Toggle::Off, "color"},
        {"&View/&Colours", "byStrength", tr("Colour by strength factor"), nullptr, {},                tr("How many times as strong elements are as their materials: reinforced and worn places."), coloring(ColorBy::Strength), Toggle::Off, "color"},
        {"&View/&Colours", "byGrain",    tr("Colour by grain"),    nullptr,   {},                    tr("How far the warp of elastic panels is turned from the way that the picture on the fabric goes up."), coloring(ColorBy::Grain), Toggle::Off, "color"},
        {"&View/&Colours", "colourRange", tr("Range of colours…"), nullptr,   QKeySequence("Alt+8"), tr("Type the values at the ends of the colours, or let them follow. A click on the colours does the same."), [&viewport] { viewport.editRange(); }},
        {"&View/&Colours", "rangeToPeak", tr("Range up to the peak"), nullptr, {},                tr("The colours reach as far as the largest value. Without it 2 % of the values may lie beyond, so that a few of them do not make the rest look alike; the legend has an arrow then."), showing("rangeToPeak", &Viewport::setRangeToPeak), Toggle::Off},
        {"&View/Sho&w", "panels",     tr("Show p&anels"),        "panel",   {},                   tr("Draw the fabric."), showing("panels", &Viewport::setPanelsShown), Toggle::On},
        {"&View/Sho&w", "links",      tr("Show lin&ks"),         "link",    {},                   tr("Draw springs, rods and lines."), showing("links", &Viewport::setLinksShown), Toggle::On},
        {"&View/Sho&w", "particles",  tr("Show partic&les"),     "particle", QKeySequence("Shift+P"), tr("Draw a dot at each particle."), showing("particles", &Viewport::setParticlesShown), Toggle::Off},
        {"&View/Sho&w", "people",     tr("Show people"),         nullptr,   {},                   tr("Draw who holds the line of a kite and who hangs below a glider or a parachute, 1.75 m tall."), showing("people", &Viewport::setPeopleShown), Toggle::On},
        {"&View/Sho&w", "wind",       tr("Show &wind"),          "wind",    {},                   tr("Draw an arrow for the wind."), showing("wind", &Viewport::setWindShown), Toggle::On},
        {"&View/Sho&w", "windStreaks", tr("Show wind streaks"),  nullptr,   {},                   tr("Let short streaks drift with the wind, gusts included; they stand while the run is held."), showing("windStreaks", &Viewport::setStreaksShown), Toggle::On},
        {"&View/Sho&w", "windField",  tr("Show wind fiel&d"),    nullptr,   QKeySequence("Shift+W"), tr("Draw arrows for the wind all around the design."), showing("windField", &Viewport::setWindFieldShown), Toggle::Off},
        {"&View/Sho&w", "centre",     tr("Show centre of &gravity"), nullptr, QKeySequence("Shift+G"), tr("Mark the centre of gravity of what is selected, or of the whole design, with its mass."), showing("centre", &Viewport::setCentreShown), Toggle::Off},
        {"&View/Sho&w", "probeValues", tr("Show what &probes read"), nullptr, QKeySequence("Shift+V"), tr("Write the values of probes beside what they look at."), showing("probeValues", &Viewport::setProbesShown), Toggle::Off},
        {"&View/Sho&w", "trails",     tr("Show trails"),         nullptr,   {}, tr("Draw the ways that the selected particles have come in the last five seconds; of those that probes look at when none is selected."), showing("trails", &Viewport::setTrailsShown), Toggle::Off},
        {"&View/Sho&w", "grain",      tr("Show grain"),          nullptr,   {},                   tr("Draw the warp of elastic panels as short strokes."), showing("grain", &Viewport::setGrainShown), Toggle::Off},
        {"&View/Sho&w", "mesh",       tr("Show mesh"),           nullptr,   {},                   tr("Draw the links that stand for fabric on it, as wires; those that show a quantity always are."), showing("mesh", &Viewport::setMeshShown), Toggle::Off},
        {"&View/Sho&w", "designGhost", tr("Show the design as a ghost"), nullptr, {}, tr("The shape as it was designed, beside what has become of it; where nothing is pinned it goes along."), showing("designGhost", &Viewport::setDesignShown), Toggle::Off},
        {"&View/&Arrows", "noArrows", tr("&None"),         nullptr,   {}, tr("No arrows on particles, panels and links."), arrows(Vectors::None), Toggle::On, "arrows"},
        {"&View/&Arrows", "velocityArrows", tr("&Velocity"), nullptr, {}, tr("How fast each particle moves, and where to."), arrows(Vectors::Velocity), Toggle::Off, "arrows"},
        {"&View/&Arrows", "loadArrows", tr("Panel &load"), nullptr,   {}, tr("How hard the air pushes each panel."), arrows(Vectors::PanelLoad), Toggle::Off, "arrows"},
        {"&View/&Arrows", "tensionArrows", tr("&Tension"), nullptr,   {}, tr("How hard each link pulls at its ends."), arrows(Vectors::Tension), Toggle::Off, "arrows"},
        {"&View", "reduceMotion", tr("Reduce motion"),     nullptr,   {},                   tr("Nothing moves in the view but what is simulated: no streaks drift with the wind."), showing("reduceMotion", &Viewport::setMotionReduced), Toggle::Off},
    };
    // clang-format on
}

} // namespace ripstop
