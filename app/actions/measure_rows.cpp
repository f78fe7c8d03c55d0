// Stages: measureRows() makes a row for each quantity of the table of quantities, in a menu that
// follows from what the quantity is measured on, so that a new quantity needs nothing here. The
// action adds a probe to the scene, or says in the status bar what has to be selected first.
// showViewMenu() makes the menu under a right click from actions that exist already, with the
// quantities that the selection allows.
#include "actions/menu_rows.h"

#include "actions/actions.h"
#include "actions/workbench.h"
#include "base/quantity.h"
#include "document/document.h"
#include "document/selection.h"
#include "document/words.h"
#include "select/measure.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

namespace ripstop {
namespace {

using Of = QuantityRow::Of;

const char* menuOf(const QuantityRow& row)
{
    if (row.points > 1)
        return QT_TRANSLATE_NOOP("Actions", "&Tools/&Measure/&Between particles");
    switch (row.of) {
    case Of::Particles:
        return QT_TRANSLATE_NOOP("Actions", "&Tools/&Measure/&Place and motion");
    case Of::Links:
    case Of::LinksAndPanels:
    case Of::Fabric:
        return QT_TRANSLATE_NOOP("Actions", "&Tools/&Measure/&Links and fabric");
    case Of::Panels:
    case Of::Canopy:
        return QT_TRANSLATE_NOOP("Actions", "&Tools/&Measure/&Air");
    case Of::Whole:
    case Of::Probes:
        break;
    }
    return QT_TRANSLATE_NOOP("Actions", "&Tools/&Measure/&Whole scene");
}

QString labelOf(Quantity quantity)
{
    return choiceLabel(choiceNames<Quantity>[std::size_t(quantity)]);
}

std::string idOf(Quantity quantity)
{
    return "measure_" + std::string(choiceNames<Quantity>[std::size_t(quantity)]);
}

// The new probe is selected, so that the inspector shows it, and its value stands in the view.
void measure(const Workbench& bench, Quantity quantity)
{
    const auto added = withProbe(bench.document.scene(), quantity, bench.selection.ids());
    if (!added) {
        bench.window.statusBar()->showMessage(
            tr("%1 is measured on %2: select that first.")
                .arg(labelOf(quantity), translated(asks(quantity))),
            8000);
        return;
    }
    bench.document.push(added->edit);
    bench.selection.set({added->probe});
    QAction& showing = *bench.actions["probeValues"];
    if (!showing.isChecked())
        showing.trigger();
}

} // namespace

MenuRows measureRows(const Workbench& bench)
{
    static const std::vector<std::string> ids = [] { // rows keep pointers
        std::vector<std::string> all;
        for (std::size_t i = 0; i < choiceNames<Quantity>.size(); ++i)
            all.push_back(idOf(Quantity(i)));
        return all;
    }();
    MenuRows rows;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto quantity = Quantity(i);
        const QuantityRow& row = rowOf(quantity);
        rows.push_back({menuOf(row),
                        ids[i].c_str(),
                        labelOf(quantity),
                        nullptr,
                        {},
                        tr(row.help.data()),
                        [&bench, quantity] { measure(bench, quantity); }});
    }
    return rows;
}

void showViewMenu(const Workbench& bench, const QPoint& place)
{
    QMenu menu(&bench.window);
    menu.setToolTipsVisible(true);
    const auto add = [&](QMenu& to, const char* id) {
        if (QAction* action = bench.actions.find(id))
            to.addAction(action);
    };
    const bool isAny = !bench.selection.ids().empty();
    if (isAny) {
        QMenu* measuring = menu.addMenu(tr("&Measure"));
        measuring->setToolTipsVisible(true);
        for (std::size_t i = 0; i < choiceNames<Quantity>.size(); ++i)
            if (const auto quantity = Quantity(i);
                rowOf(quantity).of != Of::Whole && rowOf(quantity).of != Of::Probes
                && isMeasurable(bench.document.scene(), quantity, bench.selection.ids()))
                add(*measuring, idOf(quantity).c_str());
        for (const char* id : {"fitSelected", "pin", "group", "duplicate", "delete"})
            add(menu, id);
        menu.addSeparator();
    }
    for (const char* id : {"fit", "paste", "probeValues", "picture"})
        add(menu, id);
    menu.exec(place);
}

} // namespace ripstop
