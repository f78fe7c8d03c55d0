#include "cli/study_line.h"

#include "study/study_search.h"

namespace ripstop {

StudyLine::StudyLine(OpenedStudy& opened)
    : m_line("study")
    , m_isOptimised(opened.optimiser.has_value())
{
    if (opened.optimiser)
        m_all = double(Optimiser::most(opened.study.plan));
    opened.plan.progress = &m_flights;
}

void StudyLine::tell(const FlightNews& news)
{
    const std::lock_guard lock(m_mutex);
    m_over = double(m_isOptimised ? news.point : news.flown.tally.flown);
    show();
}

void StudyLine::tellRecorded(std::size_t done, std::size_t wanted)
{
    const std::lock_guard lock(m_mutex);
    if (done == 0) // the time that is left is told from the start of the line
        m_line.emplace("recording the best");
    m_over = double(done);
    m_all = double(wanted);
    show();
}

bool StudyLine::isInterrupted()
{
    if (const std::unique_lock lock(m_mutex, std::try_to_lock); lock)
        show();
    return interrupted();
}

void StudyLine::show()
{
    const double all = m_all > 0.0 ? m_all : double(m_flights.planned());
    if (m_line && all > 0.0)
        m_line->show((m_over + m_flights.underWay()) / all);
}

} // namespace ripstop
