// Tables of numbers as loggers and spreadsheets write them.
//
// Cells are separated by tabs, semicolons or commas, whichever the first line has, in this order.
// Lines that begin with # are remarks, and empty ones are passed over. Who writes decimals with a
// comma parts cells by semicolons or tabs, and writes all of them so. A header names the columns,
// with their units in brackets.
#pragma once

#include "base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ripstop {

// What a cell holds, without blanks and quotation marks around it.
std::string_view cellContent(std::string_view cell);

// The finite number that is all of a cell's content.
std::optional<double> cellNumber(std::string_view cell);

struct TableLine
{
    int number; // from 1, as an editor counts
    std::vector<std::string> cells;
};

std::vector<TableLine> tableLines(std::string_view text);

bool isHeader(const TableLine& line); // no cell of it is a number

std::pair<std::string, std::string> nameAndUnit(std::string cell); // "Force (N)": "force", "N"

// Fails with the name of the file and the line.
Result<double> numberAt(const TableLine& line, std::size_t column, std::string_view name);

} // namespace ripstop
