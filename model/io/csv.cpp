// Cells come first, then the rows of a table, then the file that they go into.
//
// Numbers are written by appendNumber() and read by std::from_chars, as neither asks the locale for
// a decimal point. CsvWriter looks at its stream when it opens and when it closes: a stream that
// has failed stays failed, so close() still tells of a write that went wrong in between.
#include "io/csv.h"
#include "base/program_version.h"

#include "base/hash_text.h"
#include "io/json_text.h"

#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

std::string stateOf(const Frame& frame)
{
    std::string text = "; state at ";
    appendNumber(text, frame.time);
    return text + " s: " + hashText(frame.hash) + '\n';
}

} // namespace

std::string csvCell(const std::string& text, char separator)
{
    const char special[]{separator, '"', '\r', '\n', '\0'};
    if (text.find_first_of(special) == std::string::npos)
        return text;
    std::string quoted(1, '"');
    for (const char c : text)
        quoted.append(c == '"' ? 2 : 1, c);
    quoted += '"';
    return quoted;
}

void appendCell(std::string& row, double value)
{
    row += ',';
    if (std::isfinite(value))
        appendNumber(row, value);
}

std::string withUnit(const std::string& name, const std::string& unit)
{
    return unit.empty() ? name : name + " (" + unit + ")";
}

std::string csvHeader(const Frame& first, const Certificate* certificate)
{
    std::string header = "# Ripstop " + programVersion() + stateOf(first) + "time (s)";
    const auto add = [&](const std::string& name, const std::string& unit) {
        header += ',' + csvCell(withUnit(name, unit));
    };
    for (const Layout::Probe& probe : first.layout->probes)
        add(probe.name, probe.unit);
    if (certificate)
        for (const Layout::Probe& probe : first.layout->probes)
            add(probe.name + " error", probe.unit);
    return header + '\n';
}

std::string csvRow(const Frame& frame, const Certificate* certificate)
{
    std::string row;
    appendNumber(row, frame.time);
    for (const double value : frame.probe)
        appendCell(row, value);
    if (certificate)
        for (const Layout::Probe& probe : frame.layout->probes)
            appendCell(row, certificate->errorAt(probe.name, frame.time));
    return row + '\n';
}

std::string csvEnd(const Frame& last) { return "# end" + stateOf(last); }

Result<CsvWriter> CsvWriter::open(const std::filesystem::path& file, const Frame& first)
{
    Result<NewFile> made = NewFile::open(file);
    if (!made)
        return made.failure();
    CsvWriter writer(std::move(*made));
    writer.m_file.out() << csvHeader(first) << std::flush;
    return writer;
}

void CsvWriter::add(const Frame& frame)
{
    constexpr std::chrono::milliseconds patience(250); // of who follows it
    m_file.out() << csvRow(frame);
    if (const auto now = Clock::now(); now - m_flushed > patience) {
        m_flushed = now;
        m_file.out().flush();
    }
}

std::optional<Failure> CsvWriter::close(const Frame& last)
{
    m_file.out() << csvEnd(last);
    return m_file.commit();
}

} // namespace ripstop
