#pragma once

#include "base/result.h"
#include "run/frame.h"

#include <filesystem>
#include <fstream>

namespace ripstop {

// Quoted where RFC 4180 asks for it; tables for the clipboard have tabs between their cells.
std::string csvCell(const std::string& text, char separator = ',');

// A table of probe values, one row per frame. The header gives each column its unit:
// "time (s),height (m)". A value that is not a number is an empty cell.
class CsvWriter
{
public:
    static Result<CsvWriter> open(const std::filesystem::path& file, const Layout& layout);

    void add(const Frame& frame);

    // The failure of any write, or nothing.
    std::optional<Failure> close();

private:
    std::filesystem::path m_file;
    std::ofstream m_out;
};

} // namespace ripstop
