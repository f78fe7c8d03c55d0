// What the study panel does with flights that were flown again: the timeline gets one, curves and
// ghosts show several, and the design gets the values of one.
#include "study/study_panel.h"

#include "document/document.h"
#include "document/recordings.h"
#include "document/words.h"
#include "study/flight_ghosts.h"
#include "study/point_scene.h"
#include "study/study_view.h"

#include <QLabel>

#include <algorithm>

namespace ripstop {

void StudyPanel::compare(const std::vector<std::size_t>& points)
{
    const std::size_t count = std::min(points.size(), StudyView::mostCompared);
    m_runner->compare({points.end() - std::ptrdiff_t(count), points.end()}, jobs());
    showState();
}

void StudyPanel::watched(std::size_t point)
{
    const auto kept = m_runner->kept(point);
    const std::shared_ptr<Recording>& recording = kept->recorded.recording;
    const QString values = StudyView::valuesOf(*m_runner->study(), point);
    recording->setName(values.toStdString());
    recording->setOrigin(m_title->text().toStdString());
    if (std::ranges::find(m_recordings.list(), recording) == m_recordings.list().end())
        m_recordings.add(recording);
    else
        m_recordings.setCurrent(recording);
    const FlightResult& flight = kept->recorded.flight;
    m_recordings.seekTime(flight.torn > 0 ? flight.firstTear
                                          : recording->timeOf(recording->frameCount() - 1));
    emit said(kept->isSame
                  ? tr("%1: flown again, the same to the bit. The timeline has it.").arg(values)
                  : tr("%1: flown again, and it came to another state than the study has: the "
                       "study is of another version or machine.")
                        .arg(values));
}

void StudyPanel::showCompared(const std::vector<std::size_t>& points)
{
    std::vector<FlightCurve> curves;
    std::size_t other = 0; // that came to another state than their rows have
    for (const std::size_t point : points)
        if (const auto kept = m_runner->kept(point)) {
            curves.push_back(
                {point, StudyView::valuesOf(*m_runner->study(), point), {kept, &kept->recorded}});
            other += !kept->isSame;
        }
    if (curves.empty())
        return;
    const std::size_t count = curves.size();
    m_view->showCurves(std::move(curves));
    watched(m_view->chosen().value_or(points.back()));
    showGhosts();
    emit said(other == 0 ? tr("%1 flights again, all the same to the bit.").arg(count)
                         : tr("%1 of %2 flights came to another state than the study has: the "
                              "study is of another version or machine.")
                               .arg(other)
                               .arg(count));
}

void StudyPanel::showGhosts()
{
    m_recordings.setGhosts(ghostsOf(m_view->curves(), m_recordings.current()));
}

void StudyPanel::applyToDesign(std::size_t point)
{
    auto edit = editWith(m_document.scene(), m_runner->study()->assignments(point),
                         Message("Values of a study"));
    if (!edit) {
        m_state->setText(tr("The open design cannot take it. %1").arg(translated(edit.message())));
        return;
    }
    m_document.push(std::move(*edit));
    emit said(tr("The design has the values of the study now: %1")
                  .arg(StudyView::valuesOf(*m_runner->study(), point)));
}

} // namespace ripstop
