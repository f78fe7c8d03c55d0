// The Select menu, as rows of the table of actions.
#pragma once

#include "actions/actions.h"
#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

std::vector<MenuRow> selectRows(const Workbench& bench, const Actions& actions);

// Actions that do nothing while nothing is selected.
extern const std::vector<const char*> actionsOnSelection;

} // namespace ripstop
