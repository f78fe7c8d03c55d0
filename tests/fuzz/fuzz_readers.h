// All readers of files of strangers, each as a function that takes any bytes: whatever they are, it
// neither crashes nor hangs nor takes much memory, and what it reads is sound.
//
// The programs of tests/fuzz/CMakeLists.txt feed them what libFuzzer makes up; the test test_fuzz
// feeds them the files in tests/fuzz/seeds/NAME and simple changes of those. A reader that is new
// gets a function, a row and a folder of seeds.
#pragma once

#include <span>
#include <string_view>

namespace ripstop {

struct FuzzReader
{
    std::string_view name;                // of its folder of seeds
    void (*read)(std::string_view bytes); // ends the program when what was read is not sound
};

std::span<const FuzzReader> fuzzReaders();

} // namespace ripstop
