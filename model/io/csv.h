// Cells and tables in CSV (RFC 4180), with units in the headings. A CsvWriter is used by one
// thread; its failures say why the file could not be written.
#pragma once

#include "base/new_file.h"
#include "base/number_table.h"
#include "base/result.h"
#include "recording/certificate.h"
#include "simulation/frame.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace ripstop {

// Quoted where RFC 4180 asks for it; tables for the clipboard have tabs between their cells.
std::string csvCell(const std::string& text, char separator = ',');

std::string withUnit(const std::string& name, const std::string& unit); // "height (m)"

// A comma and the number after it; one that is not finite leaves the cell empty.
void appendCell(std::string& row, double value);

// A table of probe values, one row for each frame. Comments, lines that begin with #, say which
// program and which state it began with; the header gives each column its unit: "time (s),height
// (m)". A value that is not a number is an empty cell.
// With a certificate a column for the error of each probe follows, "height error (m)": what the
// value may be off by.
std::string csvHeader(const Frame& first, const Certificate* certificate = nullptr);
std::string csvRow(const Frame& frame, const Certificate* certificate = nullptr);
std::string csvEnd(const Frame& last); // a comment with the state it ended with

// The same as a file. It grows under the name that files under way have (base/new_file.h), where it
// can be followed, and comes into its place with its last row.
class CsvWriter
{
public:
    static Result<CsvWriter> open(const std::filesystem::path& file, const Frame& first);

    void add(const Frame& frame);

    // The failure of any write, or nothing.
    std::optional<Failure> close(const Frame& last);

private:
    using Clock = std::chrono::steady_clock;

    explicit CsvWriter(NewFile file)
        : m_file(std::move(file))
    {}

    NewFile m_file;
    Clock::time_point m_flushed = Clock::now();
};

} // namespace ripstop
