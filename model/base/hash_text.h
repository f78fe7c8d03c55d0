// How the hash of a state is written for people, in files and on the command line: always as 16
// hexadecimal digits in lower case, so that two hashes are equal when their texts are.
#pragma once

#include <cstdint>
#include <string>

namespace ripstop {

std::string hashText(std::uint64_t hash); // 16 hexadecimal digits

} // namespace ripstop
