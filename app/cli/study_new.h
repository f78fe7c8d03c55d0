// The command study new, which writes the file of a study.
#pragma once

#include "cli/commands.h"

namespace ripstop {

void addStudyNew(CLI::App& study, Command& chosen);

} // namespace ripstop
