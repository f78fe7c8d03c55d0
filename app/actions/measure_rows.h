#pragma once

#include "actions/actions.h"
#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

// Probes for what is selected: a row for each quantity there is.
std::vector<MenuRow> measureRows(const Workbench& bench, const Actions& actions);

// The menu under a right click in the view: what can be done with the selection, and what of it can
// be measured.
void showViewMenu(const Workbench& bench, const Actions& actions, const QPoint& place);

} // namespace ripstop
