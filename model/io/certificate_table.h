// A certificate as CSV (csv.h): a row for each time step, and of each probe its value and its
// error, the half of the band that it may be off by.
#pragma once

#include "recording/certificate.h"

#include <string>

namespace ripstop {

std::string certificateTable(const Certificate& certificate);

} // namespace ripstop
