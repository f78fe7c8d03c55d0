// A temporary file without a name, for what a recording cannot hold in memory: it is gone when this
// is, and when the program ends. Any thread may append and read; calls wait for each other.
#pragma once

#include "base/result.h"

#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace ripstop {

class SpillFile
{
public:
    // Where in the file it stands, or why it cannot be written.
    Result<std::size_t> append(std::string_view bytes);
    Result<std::string> read(std::size_t place, std::size_t size);

private:
    struct Close
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::optional<Failure> open();

    std::mutex m_mutex;
    std::unique_ptr<std::FILE, Close> m_file;
    std::size_t m_end = 0;
};

} // namespace ripstop
