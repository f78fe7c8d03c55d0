// Bands of what the values of probes may be off by, as certificates have it (plots/error_bands.h):
// where the certificates come from, the curves of a certified recording that is looked back at, and
// the words and the choice about them.
#include "document/document.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/spoken.h"
#include "plots/plot_panel.h"

#include <QMenu>

#include <algorithm>
#include <cmath>

namespace ripstop {

void PlotPanel::showErrorBands(bool shown)
{
    m_wantsBands = shown;
    drawSoon();
}

void PlotPanel::takeCertificates()
{
    m_bands.setCertificates(m_recordings->certificates());
    drawSoon();
}

// A certificate has the values of its run at every step. They are drawn while that run is looked
// back at, unless it is the one that is drawn anyway.
void PlotPanel::takePlayed(const Frame& frame)
{
    const auto& recording = m_recordings ? m_recordings->current() : nullptr;
    auto certificate =
        recording && frame.run != m_history.run() ? recording->certificate() : nullptr;
    if (certificate == m_played)
        return;
    m_played = std::move(certificate);
    if (m_played) {
        ProbeSample sample{frame.run, frame.layout, 0.0, {}};
        const std::vector<CertifiedProbe>& probes = m_played->probes;
        for (std::size_t i = 0; i < m_played->time.size(); ++i) {
            sample.time = m_played->time[i];
            sample.probe.assign(frame.layout->probes.size(), std::nan(""));
            for (std::size_t p = 0; p < sample.probe.size(); ++p) {
                const auto found =
                    std::ranges::find(probes, frame.layout->probes[p].name, &CertifiedProbe::name);
                if (found != probes.end())
                    sample.probe[p] = found->value[i];
            }
            m_playedHistory.add(sample);
        }
    }
    rebuildViews();
}

QString PlotPanel::errorText(std::uint32_t probe, std::optional<double> time) const
{
    const History& history = shownHistory();
    const auto band = m_bands.of(probe);
    if (!m_wantsBands || history.time().empty())
        return {};
    const std::size_t sample =
        time ? history.nearest(*time)
             : (m_player.isLookingBack() ? history.nearest(m_player.frame()->time)
                                         : history.time().size() - 1);
    if (sample >= band.low.size())
        return {};
    const double error = 0.5 * (band.high[sample] - band.low[sample]);
    return tr("It may be off by %1, as the certificate has it.")
        .arg(readingText(findItem<Probe>(m_document.scene(), Id{probe})->quantity, error,
                         unitOf(Id{probe}).toStdString(), 2));
}

void PlotPanel::addBands(QMenu& menu)
{
    QAction* action = menu.addAction(tr("Error bands"), this, &PlotPanel::showErrorBands);
    action->setCheckable(true);
    action->setChecked(m_wantsBands);
    action->setEnabled(m_bands.hasCertificates());
    action->setToolTip(
        !m_bands.hasCertificates()
            ? tr("Run > Certify finds how far the values of this design may be off.")
        : m_bands.sampleCount() == 0
            ? tr("The certificate is of another run: the design has been edited since, or the run "
                 "was steered or touched.")
            : tr("The shade around a curve is how far its values may be off, by the certificate "
                 "of this run. It ends where the run is no longer the one that was certified."));
}

} // namespace ripstop
