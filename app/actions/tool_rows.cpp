#include "actions/menu_rows.h"

#include "actions/dialogs.h"
#include "actions/workbench.h"
#include "docks/docks.h"
#include "inspector/inspector.h"

namespace ripstop {

MenuRows toolRows(const Workbench& bench)
{
    Docks& docks = bench.docks;
    Dialogs& dialogs = bench.dialogs;
    // clang-format off
    return {
        {"&Tools", "table",     tr("&Table of numbers"),   "table",   QKeySequence("Shift+T"), tr("Particles, links, lines, panels and materials as a spreadsheet."), [&docks] { docks.show("table"); }},
        {"&Edit", "findProperty", tr("Find a propert&y"),  "inspector", QKeySequence("Ctrl+Shift+P"), tr("Search the inspector for a property by its name or its help."), [&docks] { docks.show("inspector"); docks.panel<Inspector>().startSearch(); }},
        {"&Tools", "polar",     tr("&Polar of an air law"), "plot",   {},                   tr("What the air law of a material does to a flat plate, beside published curves."), [&dialogs] { dialogs.showPolar(); }},
        {"&Tools", "materialTest", tr("Material from a &test…"), "material", {},            tr("Stiffness and strength of an own material from a table of force and elongation (CSV)."), [&dialogs] { dialogs.showMaterialTest(); }},
    };
    // clang-format on
}

} // namespace ripstop
