// The entry of libFuzzer for one reader, READER.
#include "fuzz/fuzz_readers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const ripstop::FuzzReader& reader =
        *std::ranges::find(ripstop::fuzzReaders(), READER, &ripstop::FuzzReader::name);
    reader.read({reinterpret_cast<const char*>(data), size});
    return 0;
}
