// The rows of the menus, a function for each source NAME_rows.cpp. The menus put them together in
// an order of their own (menus.cpp); rows know nothing of that.
#pragma once

#include "actions/menu_row.h"

#include <vector>

class QPoint;

namespace ripstop {

struct Workbench;

using MenuRows = std::vector<MenuRow>;

MenuRows fileRows(const Workbench& bench);
MenuRows editRows(const Workbench& bench);
MenuRows selectRows(const Workbench& bench);
MenuRows insertRows(const Workbench& bench); // a row for each builder
MenuRows designRows(const Workbench& bench); // what shapes the design
MenuRows drawRows(const Workbench& bench);
MenuRows viewRows(const Workbench& bench);
MenuRows themeRows(const Workbench& bench);    // the choice is seen at once, and kept
MenuRows languageRows(const Workbench& bench); // the choice is kept for the next start
MenuRows runRows(const Workbench& bench); // play and reset, tools of the hand, settling and poses
MenuRows tuningRows(const Workbench& bench);   // sliders and sets of their values
MenuRows timelineRows(const Workbench& bench); // recordings and looking back at runs
MenuRows toolRows(const Workbench& bench);
MenuRows measureRows(const Workbench& bench); // a probe of what is selected, for each quantity
MenuRows helpRows(const Workbench& bench);

// The menu under a right click in the view: what can be done with the selection, and what of it can
// be measured. It picks actions from those of the rows.
void showViewMenu(const Workbench& bench, const QPoint& place);

} // namespace ripstop
