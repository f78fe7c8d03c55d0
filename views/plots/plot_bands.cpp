// Bands of what the values of probes may be off by, as certificates have it (plots/error_bands.h):
// where the certificates come from, and the words and the choice about them.
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
