// In order: signals, of which the handler notes the first; what is printed; and the line of
// progress.
#include "terminal/terminal.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <iostream>

#include <unistd.h>

namespace ripstop {
namespace {

volatile std::sig_atomic_t signalSeen = 0; // its number
timespec seenAt{};

double since(const timespec& then)
{
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return double(now.tv_sec - then.tv_sec) + 1e-9 * double(now.tv_nsec - then.tv_nsec);
}

// Programs like timeout send a signal to the process and to its group, so that it comes twice at
// once: only a person presses Ctrl-C again.
void onSignal(int signal)
{
    constexpr double atOnce = 0.3; // s
    if (signalSeen == 0) {
        ::clock_gettime(CLOCK_MONOTONIC, &seenAt);
        signalSeen = signal;
    } else if (signal == SIGINT && since(seenAt) > atOnce) {
        std::signal(SIGINT, SIG_DFL);
        std::raise(SIGINT);
    }
}

int withSignal(ExitCode code)
{
    if (code != Interrupted)
        return code;
    return Interrupted + (signalSeen != 0 ? int(signalSeen) : SIGINT);
}

} // namespace

int fail(ExitCode code, std::string_view message)
{
    std::cerr << "ripstop-cli: " << message << '\n';
    return withSignal(code);
}

int fail(ExitCode code, const Message& message) { return fail(code, message.english()); }

void warn(std::string_view message) { std::cerr << "ripstop-cli: warning: " << message << '\n'; }

Json numbersOf(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

// dump() writes control characters below a blank as \u001b; those that terminals know beyond it,
// too, are two bytes.
void print(const Json& object)
{
    std::string text = object.dump(2, ' ', false, Json::error_handler_t::replace);
    for (std::size_t i = text.find('\xc2'); i != std::string::npos; i = text.find('\xc2', i + 1)) {
        const auto second = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        if (second < 0x80 || second > 0x9f)
            continue;
        char escaped[8];
        std::snprintf(escaped, sizeof escaped, "\\u%04x", second);
        text.replace(i, 2, escaped);
    }
    std::cout << text << '\n';
}

std::string shortNumber(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

void catchInterrupt()
{
    struct sigaction action
    {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART; // files are written to their end
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before
        {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) // as nohup and shells ask for
            ::sigaction(signal, &action, nullptr);
    }
}

bool interrupted() { return signalSeen != 0; }

ProgressLine::ProgressLine(std::string label)
    : m_label(std::move(label))
    , m_visible(::isatty(STDERR_FILENO) == 1)
    , m_began(std::chrono::steady_clock::now())
    , m_next(m_began)
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
    share = std::clamp(share, 0.0, 1.0);
    std::fprintf(stderr, "\r\033[K%s %3.0f %%", m_label.c_str(), 100.0 * share);
    // What is left, at the pace so far; at first nobody knows.
    const double taken = std::chrono::duration<double>(now - m_began).count(); // s
    const double left = share > 0.0 ? taken * (1.0 - share) / share : 0.0;     // s
    if (taken > 5.0 && left >= 120.0)
        std::fprintf(stderr, ", %.0f min left", left / 60.0);
    else if (taken > 5.0)
        std::fprintf(stderr, ", %.0f s left", left);
    std::fflush(stderr);
}

} // namespace ripstop
