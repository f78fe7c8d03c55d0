// How the hash of a state is written for people, in files and on the command line.
#pragma once

#include <cstdint>
#include <string>

namespace ripstop {

std::string hashText(std::uint64_t hash); // 16 hexadecimal digits

} // namespace ripstop
