// The curves of a recording that is looked back at, unless it is of the run that goes on.
//
// They come from its certificate, which has every step; or from the history of that run, if it is
// one of those that are kept for comparison; or else from its frames, which a thread of its own
// reads (recording/probe_past.h), as an export of the recording does. The number of the reading
// tells what has been asked for since; an older one ends early and what it found is dropped.
#include "document/player.h"
#include "document/recordings.h"
#include "plots/plot_panel.h"
#include "recording/certificate.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace ripstop {
namespace {

bool hasAny(const History& history, const std::vector<Curve>& curves)
{
    return std::ranges::any_of(curves, [&](const Curve& curve) {
        return std::ranges::any_of(history.valuesOf(curve.probe),
                                   [](double value) { return std::isfinite(value); });
    });
}

} // namespace

void PlotPanel::takePlayed(const Frame& frame)
{
    // what was opened from files is of no run of the player, and its number says nothing
    std::shared_ptr<const Recording> recording = m_recordings ? m_recordings->current() : nullptr;
    if (recording && recording->run() != 0 && recording->run() == m_history.run())
        recording = nullptr;
    if (!recording)
        return leavePlayed();
    auto certificate = recording->certificate();
    if (recording == m_played && certificate == m_playedCertificate)
        return;
    if (!m_played && m_history.time().size() > 1)
        m_left = {tr("run %1").arg(m_runs + 1), std::make_shared<const History>(m_history)};
    m_played = std::move(recording);
    m_playedCertificate = std::move(certificate);
    m_playedHistory.clear();
    m_isOfFrames = false;
    ++m_reading;
    const auto kept = std::ranges::find_if(
        m_earlier, [&](const EarlierRun& run) { return run.history->run() == m_played->run(); });
    if (m_playedCertificate) {
        fillPlayed(*m_playedCertificate, frame);
    } else if (kept != m_earlier.end()) {
        m_playedHistory = *kept->history;
    } else {
        m_isOfFrames = true;
        readPlayed();
    }
    rebuildViews();
}

void PlotPanel::leavePlayed()
{
    if (!std::exchange(m_played, nullptr))
        return;
    m_playedCertificate = nullptr;
    m_left.reset();
    m_isOfFrames = false;
    ++m_reading;
    rebuildViews();
}

void PlotPanel::fillPlayed(const Certificate& certificate, const Frame& frame)
{
    const std::vector<CertifiedProbe>& probes = certificate.probes;
    std::vector<std::span<const double>> values; // [probes of the frame], empty for another
    for (const Layout::Probe& probe : frame.layout->probes) {
        const auto found = std::ranges::find(probes, probe.name, &CertifiedProbe::name);
        values.push_back(found != probes.end() ? found->value : std::span<const double>());
    }
    ProbeSample sample{frame.run, frame.layout, 0.0, {}};
    for (std::size_t i = 0; i < certificate.time.size(); ++i) {
        sample.time = certificate.time[i];
        sample.probe.clear();
        for (const std::span<const double> value : values)
            sample.probe.push_back(value.empty() ? std::nan("") : value[i]);
        m_playedHistory.add(sample);
    }
    noteTears();
}

// All probes that the design has now, whether the run had them or not.
void PlotPanel::readPlayed() { m_reader.post({m_played, m_probes, ++m_reading}); }

void PlotPanel::takeReading()
{
    const auto found = m_reader.take();
    if (!found || found->number != m_reading)
        return;
    auto layout = std::make_shared<Layout>();
    layout->probes = found->probes;
    for (Layout::Probe& probe : layout->probes)
        probe.unit = unitOf(Id{probe.id}).toStdString();
    ProbeSample sample{found->run, std::move(layout), 0.0, {}};
    m_playedHistory.clear();
    for (std::size_t i = 0; i < found->past.time.size(); ++i) {
        sample.time = found->past.time[i];
        sample.probe.clear();
        for (const std::vector<double>& values : found->past.value)
            sample.probe.push_back(values[i]);
        m_playedHistory.add(sample);
    }
    noteTears();
    rebuildViews();
}

void PlotPanel::noteTears()
{
    std::vector<double> times;
    for (const RunEvent& event : m_played->events())
        if (event.kind == RunEvent::Kind::Tear)
            times.push_back(event.time);
    m_playedHistory.setTears(std::move(times));
}

std::vector<EarlierRun> PlotPanel::shownEarlier() const
{
    std::vector<EarlierRun> others = m_earlier;
    if (m_played)
        std::erase_if(others,
                      [&](const EarlierRun& run) { return run.history->run() == m_played->run(); });
    if (m_left)
        others.push_back(*m_left);
    return others;
}

QString PlotPanel::lackOf(const PlotView& view) const
{
    if (!m_played || hasAny(m_playedHistory, view.curves()))
        return {};
    return isReading() ? tr("Reading the recording\u2026")
                       : tr("What these probes read is not in the recording.");
}

bool PlotPanel::hasValues() const { return hasAny(shownHistory(), m_views[m_current]->curves()); }

} // namespace ripstop
