#pragma once

#include "actions/actions.h"
#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

// What looks back at runs: the menu Timeline, and recordings in the File menu.
std::vector<MenuRow> recordingFileRows(const Workbench& bench);
std::vector<MenuRow> timelineRows(const Workbench& bench);

} // namespace ripstop
