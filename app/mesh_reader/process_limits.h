// What the system holds this process to, so that a broken file cannot take more of the machine.
#pragma once

#include <cstdint>

namespace ripstop {

// It writes no file and no core, gains no rights, and ends when the process that started it does.
void limitProcess();

// Memory and time for files of so many bytes (ReadLimits in shapes/mesh_process.h). Larger numbers
// give more than smaller ones have given.
void limitProcess(std::uint64_t bytes);

} // namespace ripstop
