// A certificate (recording/certificate.h) as the command line tells it.
#pragma once

#include "recording/certificate.h"
#include "terminal/terminal.h"

namespace ripstop {

void printTable(const Certificate& certificate);
Json jsonOf(const Certificate& certificate);

} // namespace ripstop
