// Cells and tables in CSV (RFC 4180), with units in the headings. A CsvWriter is used by one
// thread; its failures say why the file could not be written.
#pragma once

#include "base/result.h"
#include "run/certificate.h"
#include "run/frame.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

// Quoted where RFC 4180 asks for it; tables for the clipboard have tabs between their cells.
std::string csvCell(const std::string& text, char separator = ',');

std::string withUnit(const std::string& name, const std::string& unit); // "height (m)"

// What a cell holds, without blanks and quotation marks around it.
std::string_view cellContent(std::string_view cell);

// The finite number that is all of a cell's content.
std::optional<double> cellNumber(std::string_view cell);

// A table of probe values, one row for each frame. Comments, lines that begin with #, say which
// program and which state it began with; the header gives each column its unit: "time (s),height
// (m)". A value that is not a number is an empty cell.
// With a certificate a column for the error of each probe follows, "height error (m)": what the
// value may be off by.
std::string csvHeader(const Frame& first, const Certificate* certificate = nullptr);
std::string csvRow(const Frame& frame, const Certificate* certificate = nullptr);
std::string csvEnd(const Frame& last); // a comment with the state it ended with

// The same as a file that grows, so that a run that is broken off leaves what it has.
class CsvWriter
{
public:
    static Result<CsvWriter> open(const std::filesystem::path& file, const Frame& first);

    void add(const Frame& frame);

    // The failure of any write, or nothing.
    std::optional<Failure> close(const Frame& last);

private:
    std::filesystem::path m_file;
    std::ofstream m_out;
};

} // namespace ripstop
