#include "io/csv.h"

#include "io/json_text.h"

#include <cerrno>
#include <cmath>
#include <cstring>

namespace ripstop {
namespace {

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown error"; }

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

Result<CsvWriter> CsvWriter::open(const std::filesystem::path& file, const Layout& layout)
{
    CsvWriter writer;
    writer.m_file = file;
    errno = 0;
    writer.m_out.open(file, std::ios::binary | std::ios::trunc);
    if (!writer.m_out)
        return Failure{file.string() + " cannot be written: " + reason()
                       + "; choose another folder."};

    std::string header = "time (s)";
    for (const Layout::Probe& probe : layout.probes) {
        header += ',';
        header += csvCell(probe.unit.empty() ? probe.name : probe.name + " (" + probe.unit + ")");
    }
    writer.m_out << header << '\n';
    return writer;
}

void CsvWriter::add(const Frame& frame)
{
    std::string row;
    appendNumber(row, frame.time);
    for (const double value : frame.probe) {
        row += ',';
        if (std::isfinite(value))
            appendNumber(row, value);
    }
    row += '\n';
    m_out << row;
}

std::optional<Failure> CsvWriter::close()
{
    errno = 0;
    m_out.close();
    if (!m_out)
        return Failure{m_file.string() + " is not complete: " + reason()
                       + "; make room or choose another folder."};
    return std::nullopt;
}

} // namespace ripstop
