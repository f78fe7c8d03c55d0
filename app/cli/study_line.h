// The line of the terminal that says how far a study is, within its flights, too, as one may take
// hours. Whoever flies brings it up to date, from any thread.
#pragma once

#include "study/study_run.h"
#include "terminal/terminal.h"

#include <cstddef>
#include <mutex>
#include <optional>

namespace ripstop {

class StudyLine
{
public:
    explicit StudyLine(OpenedStudy& opened); // whose plan tells it how far flights are

    void tell(const FlightNews& news);
    void tellRecorded(std::size_t done, std::size_t wanted);
    bool isInterrupted(); // asked between any two steps: no thread waits for another one here
    void end() { m_line.reset(); }

private:
    void show();

    std::optional<ProgressLine> m_line;
    StudyProgress m_flights;
    std::mutex m_mutex;
    double m_over = 0.0; // flights
    double m_all = 0.0;  // flights; 0: as many as are planned
    bool m_isOptimised = false;
};

} // namespace ripstop
