#include "terminal/terminal.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>

#include <unistd.h>

namespace ripstop {
namespace {

volatile std::sig_atomic_t interruptions = 0;

void onInterrupt(int)
{
    interruptions = 1;
    std::signal(SIGINT, SIG_DFL);
}

} // namespace

int fail(ExitCode code, std::string_view message)
{
    std::cerr << "ripstop-cli: " << message << '\n';
    return code;
}

int fail(ExitCode code, const Message& message) { return fail(code, message.english()); }

void print(const Json& object)
{
    std::cout << object.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

std::string shortNumber(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

void catchInterrupt() { std::signal(SIGINT, onInterrupt); }

bool interrupted() { return interruptions != 0; }

ProgressLine::ProgressLine(std::string label)
    : m_label(std::move(label))
    , m_visible(::isatty(STDERR_FILENO) == 1)
    , m_next(std::chrono::steady_clock::now())
{}

ProgressLine::~ProgressLine()
{
    if (m_visible)
        std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double share)
{
    if (!m_visible)
        return;
    const auto now = std::chrono::steady_clock::now();
    if (now < m_next)
        return;
    m_next = now + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\r\033[K%s %3.0f %%", m_label.c_str(),
                 100.0 * std::clamp(share, 0.0, 1.0));
    std::fflush(stderr);
}

} // namespace ripstop
