// The past of probes that are added to a run which has gone on without them, or is over: a thread
// of its own reads it from the recording of that run (recording/probe_past.h), one run after the
// other. What cannot be told from the recording begins when the probe was added, and its name says
// so.
#include "document/recordings.h"
#include "document/spoken.h"
#include "plots/plot_panel.h"

#include <algorithm>

namespace ripstop {

PlotPanel::PastFound PlotPanel::findPast(const PastWish& wish, const Progress& progress)
{
    PastFound found;
    found.run = wish.recording->run();
    found.number = wish.number;
    found.past = probePast(*wish.recording, wish.probes, progress);
    for (const Entry& probe : wish.probes)
        found.probes.push_back(
            {std::uint32_t(probe.id), std::get<Probe>(probe.item).name, {}, true});
    return found;
}

// Asks once for each run and each form of a probe, since some have no past.
void PlotPanel::askPast()
{
    if (!m_recordings)
        return;
    std::vector<const History*> all{&m_history};
    for (const EarlierRun& run : m_earlier)
        all.push_back(run.history.get());
    for (const History* history : all) {
        const auto recording = std::ranges::find_if(
            m_recordings->list(), [&](const auto& one) { return one->run() == history->run(); });
        // the run that goes on reads a new probe with its next frame, which says the unit
        const bool lacks = std::ranges::any_of(m_probes, [&](const Entry& probe) {
            const auto id = std::uint32_t(probe.id);
            return history == &m_history ? history->joined(id).has_value() : history->lacksPast(id);
        });
        if (recording == m_recordings->list().end() || !lacks
            || m_pastAsked[history->run()] == m_probes)
            continue;
        m_pastAsked[history->run()] = m_probes;
        return m_pastFinder.post({*recording, m_probes}); // the next when this one has come
    }
}

void PlotPanel::takePast()
{
    const auto found = m_pastFinder.take();
    if (!found)
        return;
    const auto fill = [&](History& history) {
        for (std::size_t i = 0; i < found->probes.size(); ++i) {
            Layout::Probe probe = found->probes[i];
            probe.unit = unitOf(Id{probe.id}).toStdString();
            if (history.lacksPast(probe.id) && (&history != &m_history || history.joined(probe.id)))
                history.fillPast(probe, found->past.time, found->past.value[i]);
        }
    };
    if (found->run == m_history.run())
        fill(m_history);
    for (EarlierRun& run : m_earlier)
        if (run.history->run() == found->run) {
            auto filled = std::make_shared<History>(*run.history);
            fill(*filled);
            run.history = std::move(filled);
            if (m_played && m_played->run() == found->run && !m_isOfFrames && !m_playedCertificate)
                m_playedHistory = *run.history;
        }
    rebuildViews(); // names may say since when, and earlier runs have other curves
    askPast();
}

QString PlotPanel::nameOf(const Entry& probe) const
{
    const QString name = QString::fromStdString(std::get<Probe>(probe.item).name);
    const auto since = shownHistory().joined(std::uint32_t(probe.id));
    return since ? tr("%1, known from %2 on").arg(name, spokenText(*since, "s")) : name;
}

} // namespace ripstop
