// A table prints its titles with the first row, so that a race without rows prints nothing. Then
// come the formats of numbers, which print something readable for figures that are not finite; the
// machine, read from /proc, with what the build says about the compiler; and the memory of this
// process.
#include "bench/report.h"
#include "base/program_version.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>

#include <unistd.h>

namespace ripstop {
namespace {

std::string valueInFile(const char* file, std::string_view key)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key))
            return line.substr(line.find(':') + 2);
    return "unknown";
}

void printCell(const std::string& text, int width)
{
    const auto room = std::size_t(std::abs(width));
    const std::string space(room > text.size() ? room - text.size() : 0, ' ');
    std::cout << (width < 0 ? text + space : space + text) << (width < 0 ? " " : "  ");
}

} // namespace

Table::Table(std::string heading, std::vector<Column> columns, bool shown)
    : m_heading(std::move(heading))
    , m_columns(std::move(columns))
    , m_shown(shown)
{}

void Table::row(const std::vector<std::string>& cells)
{
    if (!m_shown)
        return;
    if (!m_started) {
        std::cout << '\n' << m_heading << "\n\n";
        for (const Column& column : m_columns)
            printCell(column.title, column.width);
        std::cout << '\n';
        m_started = true;
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
        printCell(cells[i], m_columns[i].width);
    std::cout << std::endl;
}

std::string fixed(double number, int digits)
{
    if (!std::isfinite(number))
        return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, number);
    return text;
}

std::string rate(double perSecond)
{
    if (!std::isfinite(perSecond))
        return "-";
    const std::string digits = fixed(perSecond, perSecond < 100.0 ? 1 : 0);
    if (perSecond < 10000.0)
        return digits;
    std::string text; // in groups of three
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += ' ';
        text += digits[i];
    }
    return text;
}

std::string percent(double share)
{
    if (!std::isfinite(share))
        return "broken";
    return fixed(100.0 * share, share < 0.001 ? 4 : share < 0.1 ? 2 : 0) + " %";
}

Json jsonOf(const TimingSummary& figures)
{
    return {{"quiet", figures.quiet},
            {"median", figures.median},
            {"slow", figures.slow},
            {"blocks", figures.blocks}};
}

Json machine()
{
    return {{"processor", valueInFile("/proc/cpuinfo", "model name")},
            {"family", valueInFile("/proc/cpuinfo", "cpu family")},
            {"model", valueInFile("/proc/cpuinfo", "model\t")},
            {"cores", std::thread::hardware_concurrency()},
            {"memory", valueInFile("/proc/meminfo", "MemTotal")},
            {"compiler", COMPILER_TEXT},
            {"flags", COMPILER_FLAGS},
#ifdef NDEBUG
            {"build", "optimised"},
#else
            {"build", "with checks: figures mean little"},
#endif
            {"version", programVersion()}};
}

std::string machineText(const Json& machine)
{
    return machine["processor"].get<std::string>() + " (family "
           + machine["family"].get<std::string>() + ", model " + machine["model"].get<std::string>()
           + "), " + std::to_string(machine["cores"].get<int>()) + " cores, "
           + machine["compiler"].get<std::string>() + ", " + machine["build"].get<std::string>();
}

long residentBytes()
{
    std::ifstream in("/proc/self/statm");
    long total = 0;
    long resident = 0;
    in >> total >> resident;
    return resident * ::sysconf(_SC_PAGESIZE);
}

} // namespace ripstop
