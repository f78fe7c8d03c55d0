#include "study/study_progress.h"

#include <algorithm>

namespace ripstop {

// Shares are added and taken away in any order, so that rounding may leave less than nothing.
double StudyProgress::underWay() const { return std::max(m_underWay.load(), 0.0); }

StudyProgress::Flight::Flight(StudyProgress* progress, double seconds)
    : m_progress(progress)
    , m_seconds(seconds)
{}

StudyProgress::Flight::~Flight()
{
    if (m_progress)
        m_progress->m_underWay -= m_share;
}

void StudyProgress::Flight::reached(double time)
{
    if (!m_progress || !(m_seconds > 0.0))
        return;
    const double share = std::clamp(time / m_seconds, 0.0, 1.0);
    m_progress->m_underWay += share - m_share;
    m_share = share;
}

} // namespace ripstop
