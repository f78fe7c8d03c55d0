// A handler may do next to nothing: it writes the number of the signal into a pipe that the event
// loop looks at.
#include "editor/end_signals.h"

#include <array>
#include <csignal>

#include <unistd.h>

namespace ripstop {
namespace {

std::array<int, 2> ends{-1, -1}; // of the pipe, to read and to write

void onSignal(int signal)
{
    const auto number = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = ::write(ends[1], &number, 1);
}

int openedPipe() { return ::pipe(ends.data()) == 0 ? ends[0] : -1; }

} // namespace

EndSignals::EndSignals(std::function<void(int signal)> end)
    : m_notifier(openedPipe(), QSocketNotifier::Read)
{
    if (ends[0] < 0)
        return; // signals end the program as they do others
    QObject::connect(&m_notifier, &QSocketNotifier::activated, &m_notifier,
                     [this, end = std::move(end)] {
                         unsigned char number = SIGTERM;
                         m_notifier.setEnabled(false);
                         [[maybe_unused]] const ssize_t got = ::read(ends[0], &number, 1);
                         end(number);
                     });
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        if (std::signal(signal, onSignal) == SIG_IGN) // as nohup asks for
            std::signal(signal, SIG_IGN);
}

} // namespace ripstop
