// SIGTERM, Ctrl-C in the terminal and its end close the editor in order: what is not saved is kept
// for the next start, and nothing is asked. main() ends with 128 and the number of the signal.
#pragma once

#include <QSocketNotifier>

#include <functional>

namespace ripstop {

class EndSignals
{
public:
    // `end` is called in the event loop, once.
    explicit EndSignals(std::function<void(int signal)> end);

private:
    QSocketNotifier m_notifier;
};

} // namespace ripstop
