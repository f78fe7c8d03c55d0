// A program that is started without standard output gets a file that cannot be written in its
// place: otherwise the first file that it opens would be standard output.
#include "terminal/output.h"

#include "terminal/terminal.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace ripstop {
namespace {

void occupyStandardHandles()
{
    for (int handle = ::open("/dev/null", O_RDONLY); handle >= 0; handle = ::dup(handle))
        if (handle > STDERR_FILENO) {
            ::close(handle);
            return;
        }
}

bool isControl(unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; }

// C1 controls, of which 0x9b begins a sequence as ESC [ does, are two bytes in UTF-8.
constexpr unsigned char beforeC1 = 0xc2;
bool isC1(unsigned char c) { return c >= 0x80 && c < 0xa0; }

} // namespace

class StandardOutput::Buffer final : public std::streambuf
{
public:
    explicit Buffer(int handle)
        : m_handle(handle)
        , m_byLine(::isatty(handle) == 1)
    {}

    int error() const { return m_error; }

protected:
    int overflow(int c) override
    {
        if (c != traits_type::eof())
            put(static_cast<unsigned char>(c));
        return m_error == 0 ? traits_type::not_eof(c) : traits_type::eof();
    }

    std::streamsize xsputn(const char* text, std::streamsize size) override
    {
        for (std::streamsize i = 0; i < size; ++i)
            put(static_cast<unsigned char>(text[i]));
        return m_error == 0 ? size : 0;
    }

    int sync() override
    {
        for (std::size_t done = 0; done < m_bytes.size() && m_error == 0;) {
            const ssize_t count = ::write(m_handle, m_bytes.data() + done, m_bytes.size() - done);
            if (count >= 0)
                done += std::size_t(count);
            else if (errno != EINTR)
                m_error = errno;
        }
        m_bytes.clear();
        return m_error == 0 ? 0 : -1;
    }

private:
    void put(unsigned char c)
    {
        if (m_isAfterC2) {
            m_isAfterC2 = false;
            if (isC1(c))
                return escape(c);
            m_bytes += char(beforeC1);
        }
        if (isControl(c))
            return escape(c);
        m_isAfterC2 = c == beforeC1;
        if (!m_isAfterC2)
            m_bytes += char(c);
        constexpr std::size_t most = std::size_t(1) << 14;
        if (m_bytes.size() >= most || (m_byLine && c == '\n'))
            sync();
    }

    void escape(unsigned char c)
    {
        constexpr const char* digits = "0123456789abcdef";
        m_bytes.append("\\x").append(1, digits[c >> 4]).append(1, digits[c & 15]);
    }

    int m_handle;
    bool m_byLine;
    bool m_isAfterC2 = false;
    int m_error = 0;
    std::string m_bytes;
};

StandardOutput::StandardOutput()
{
    occupyStandardHandles();
    for (const int fatal : {SIGPIPE, SIGXFSZ}) // a limit of the size of files is a full disk, too
        std::signal(fatal, SIG_IGN);
    m_out = std::make_unique<Buffer>(STDOUT_FILENO);
    m_error = std::make_unique<Buffer>(STDERR_FILENO);
    m_outBefore = std::cout.rdbuf(m_out.get());
    m_errorBefore = std::cerr.rdbuf(m_error.get()); // which flushes after each call
}

StandardOutput::~StandardOutput()
{
    std::cout.flush();
    std::cerr.flush();
    std::cout.rdbuf(m_outBefore);
    std::cerr.rdbuf(m_errorBefore);
}

int StandardOutput::finish(int exitCode)
{
    std::cout.flush();
    if (m_out->error() == 0)
        return exitCode;
    const int code = exitCode == Done ? int(OutputLost) : exitCode;
    std::cerr << "ripstop-cli: Standard output did not take all of the results: "
              << std::strerror(m_out->error()) << ".\n";
    return code;
}

OutputOnError::OutputOnError(bool isActive)
    : m_before(isActive ? std::cout.rdbuf(std::cerr.rdbuf()) : nullptr)
{}

OutputOnError::~OutputOnError()
{
    std::cout.flush();
    if (m_before)
        std::cout.rdbuf(m_before);
}

} // namespace ripstop
