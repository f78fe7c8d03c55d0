// The list of probes of the plots dock: what is drawn, what each reads now or under the mouse, and
// ticks, which become edits.
#include "base/quantity.h"
#include "document/document.h"
#include "document/player.h"
#include "document/spoken.h"
#include "document/words.h"
#include "icons/swatch.h"
#include "plots/curve_color.h"
#include "plots/plot_panel.h"

#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace ripstop {

void PlotPanel::rebuildList()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto& probe = std::get<Probe>(m_probes[i].item);
        auto* item = new QTreeWidgetItem(m_list, {QString::fromStdString(probe.name)});
        item->setCheckState(0, isDrawn(m_probes[i]) ? Qt::Checked : Qt::Unchecked);
        item->setIcon(0, swatch(curveColor(int(i), palette())));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(0, choiceLabel(choiceNames<Quantity>[std::size_t(probe.quantity)]));
    }
    showValues();
}

bool PlotPanel::isDrawn(const Entry& probe) const
{
    return std::ranges::any_of(m_views[m_current]->curves(), [&](const Curve& curve) {
        return curve.probe == std::uint32_t(probe.id);
    });
}

QString PlotPanel::unitOf(Id id) const
{
    // a recording that is looked back at need not have had the probe
    for (const auto& frame : {m_player.frame(), m_player.newest()})
        if (frame)
            for (const Layout::Probe& probe : frame->layout->probes)
                if (probe.id == std::uint32_t(id))
                    return QString::fromStdString(probe.unit);
    return {};
}

// Shows in the list what the probes read at the time under the mouse, or now.
void PlotPanel::showValues()
{
    const History& history = shownHistory();
    const bool past = m_hovered && !history.time().empty();
    const std::size_t sample = past ? history.nearest(*m_hovered) : 0;
    m_list->setHeaderLabels(
        {m_views.size() > 1 ? QString::fromStdString(plotOf(m_current).name) : tr("Probe"),
         past ? tr("at %1 s").arg(QLocale().toString(history.time()[sample], 'f', 2)) : tr("now")});
    const auto& frame = m_player.frame();
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto id = std::uint32_t(m_probes[i].id);
        double value = std::nan("");
        if (past) {
            const auto values = history.valuesOf(id);
            if (sample < values.size())
                value = values[sample];
        } else if (frame) {
            const auto& probes = frame->layout->probes;
            for (std::size_t p = 0; p < probes.size(); ++p)
                if (probes[p].id == id)
                    value = frame->probe[p];
        }
        const QSignalBlocker quiet(m_list);
        QTreeWidgetItem& row = *m_list->topLevelItem(int(i));
        row.setText(1, readingText(std::get<Probe>(m_probes[i].item).quantity, value,
                                   unitOf(m_probes[i].id).toStdString()));
        row.setToolTip(1, errorText(id, past ? m_hovered : std::nullopt));
    }
    m_list->viewport()->update(); // the blocked signals would have repainted it
}

// A plot with probes of its own ticks only those; all other plots share the ticks of the probes.
void PlotPanel::tick(QTreeWidgetItem* item)
{
    const Entry& entry = m_probes[std::size_t(m_list->indexOfTopLevelItem(item))];
    const bool wanted = item->checkState(0) == Qt::Checked;
    if (wanted == isDrawn(entry))
        return;
    // The edit is pushed later, because it makes the list anew, and with it the item whose signal
    // is being handled.
    const auto push = [this, id = entry.id, wanted] {
        Plot plot = plotOf(m_current);
        if (!plot.probes.empty()) {
            std::erase(plot.probes, id);
            if (wanted)
                plot.probes.insert(std::ranges::lower_bound(plot.probes, id), id);
            return plot.probes.empty() ? rebuildList() : change(plot); // empty means all
        }
        const auto* ticked = findItem<Probe>(m_document.scene(), id);
        const Property* property = &propertyOf<&Probe::plotted>();
        if (ticked && ticked->plotted != wanted)
            m_document.push({wanted ? Message("Plot %1", ticked->name)
                                    : Message("Do not plot %1", ticked->name),
                             {SetValues{property, {id}, {wanted}}}});
    };
    QMetaObject::invokeMethod(this, push, Qt::QueuedConnection);
}

} // namespace ripstop
