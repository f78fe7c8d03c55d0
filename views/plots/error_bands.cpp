// match() starts over when samples that it has seen may be others now, lets each certificate follow
// the history as far as both agree, and takes the bands from the one that comes furthest.
#include "plots/error_bands.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// The probe that a certificate has for each of the layout: the first of its name and unit that no
// other one has, because names need not differ.
std::vector<const CertifiedProbe*> matched(const Certificate& certificate, const Layout& layout)
{
    std::vector<const CertifiedProbe*> found;
    for (const Layout::Probe& probe : layout.probes) {
        const auto fits = [&](const CertifiedProbe& one) {
            return one.name == probe.name && one.unit == probe.unit
                   && std::ranges::find(found, &one) == found.end();
        };
        const auto it = std::ranges::find_if(certificate.probes, fits);
        found.push_back(it == certificate.probes.end() ? nullptr : &*it);
    }
    return found;
}

} // namespace

void ErrorBands::setCertificates(const Certificates& certificates)
{
    const bool same = std::ranges::equal(certificates, m_tracks, {}, {}, &Track::certificate);
    if (same)
        return;
    m_tracks.clear();
    for (const auto& certificate : certificates)
        m_tracks.push_back({certificate});
    m_seen = nullptr; // nothing has been compared
    m_best = nullptr;
    m_shown = 0;
}

void ErrorBands::match(const History& history)
{
    if (m_seen != &history || m_revision != history.revision() || m_run != history.run()
        || m_layout != history.layout())
        startOver(history);
    const Track* best = nullptr;
    for (Track& track : m_tracks) {
        follow(track, history);
        const bool isFurther = best == nullptr || track.agreed > best->agreed;
        const bool isLonger = best && track.agreed == best->agreed
                              && track.certificate->seconds > best->certificate->seconds;
        if (isFurther || isLonger)
            best = &track;
    }
    if (best != m_best) {
        m_best = best;
        m_shown = 0;
    }
    if (best)
        extend(*best, history);
}

void ErrorBands::startOver(const History& history)
{
    m_seen = &history;
    m_revision = history.revision();
    m_run = history.run();
    m_layout = history.layout();
    m_best = nullptr;
    m_shown = 0;
    for (Track& track : m_tracks) {
        track = {track.certificate};
        if (m_layout)
            track.probes = matched(*track.certificate, *m_layout);
        track.isOver = std::ranges::none_of(track.probes, [](auto* probe) { return probe; });
    }
}

void ErrorBands::follow(Track& track, const History& history)
{
    const auto time = history.time();
    const std::vector<double>& moments = track.certificate->time;
    for (; !track.isOver && track.agreed < time.size(); ++track.agreed) {
        const std::size_t sample = track.agreed;
        while (track.next < moments.size() && moments[track.next] < time[sample])
            ++track.next;
        // times are sums of steps, and the same in each run
        track.isOver = track.next == moments.size() || moments[track.next] != time[sample];
        for (std::size_t i = 0; !track.isOver && i < track.probes.size(); ++i)
            if (const CertifiedProbe* probe = track.probes[i])
                track.isOver = !isSame(probe->value[track.next],
                                       history.valuesOf(history.layout()->probes[i].id)[sample]);
        if (track.isOver)
            return;
    }
}

void ErrorBands::extend(const Track& track, const History& history)
{
    const std::size_t count = track.agreed > 1 ? track.agreed : 0;
    const auto time = history.time();
    const std::vector<double>& moments = track.certificate->time;
    if (m_shown == 0)
        m_columns.clear();
    for (std::size_t i = 0, column = 0; i < track.probes.size(); ++i) {
        const CertifiedProbe* probe = track.probes[i];
        if (!probe)
            continue;
        if (column == m_columns.size())
            m_columns.push_back({history.layout()->probes[i].id, {}, {}});
        Column& band = m_columns[column++];
        for (std::size_t sample = band.low.size(); sample < count; ++sample) {
            const auto at = std::ranges::lower_bound(moments, time[sample]) - moments.begin();
            const double value = probe->value[std::size_t(at)];
            const double error = probe->error[std::size_t(at)];
            band.low.push_back(value - error);
            band.high.push_back(value + error);
        }
    }
    m_shown = count;
}

ErrorBands::Band ErrorBands::of(std::uint32_t probe) const
{
    const auto found = std::ranges::find(m_columns, probe, &Column::probe);
    if (m_shown == 0 || found == m_columns.end())
        return {};
    return {found->low, found->high};
}

} // namespace ripstop
