// What the races share in print: tables, the machine, and the figures of a list of times. Tables go
// to standard output row by row, as soon as each is known. Where a file of the system cannot be
// read, as on systems without /proc, the machine says "unknown".
#pragma once

#include "bench/timing.h"
#include "terminal/terminal.h"

#include <string>
#include <vector>

namespace ripstop {

struct Column
{
    std::string title;
    int width; // negative is flush left
};

// Prints rows under titles, each as soon as it is known.
class Table
{
public:
    // A table that is not shown prints nothing.
    Table(std::string heading, std::vector<Column> columns, bool shown);
    void row(const std::vector<std::string>& cells);

private:
    std::string m_heading;
    std::vector<Column> m_columns;
    bool m_shown;
    bool m_started = false;
};

std::string fixed(double number, int digits); // "12.30"; "-" when not finite
std::string rate(double perSecond);           // "13 290"
std::string percent(double share);            // "0.46 %"

Json jsonOf(const TimingSummary& figures); // quiet, median, slow, blocks

// Processor, cores, compiler, flags, build, version; no names.
Json machine();
std::string machineText(const Json& machine);

long residentBytes(); // of this process now

} // namespace ripstop
