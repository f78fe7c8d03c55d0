// Which panels the plots dock has, and what each shows: edits of the scene that keeps them.
#include "document/document.h"
#include "plots/plot_panel.h"
#include "select/group.h"

namespace ripstop {
namespace {

// The changes that give the plot with this id the properties of `wanted`.
std::vector<Change> changesTo(const Plot& wanted, const Plot& now, Id id)
{
    std::vector<Change> changes;
    for (const Property& property : propertiesOf(Kind::Plot))
        if (const Value value = property.get(&wanted); value != property.get(&now))
            changes.emplace_back(SetValues{&property, {id}, {value}});
    return changes;
}

} // namespace

void PlotPanel::keepPlot()
{
    const Scene& scene = m_document.scene();
    Plot plot = m_own;
    plot.name = freeName(scene, kindName(Kind::Plot));
    m_document.push(
        {Message("Keep %1", plot.name), {AddItem{scene.items.size(), {scene.nextId, plot}}}});
}

void PlotPanel::addPlot()
{
    const Scene& scene = m_document.scene();
    Edit edit{Message("Add a plot"), {}};
    Id next = scene.nextId;
    std::size_t place = scene.items.size();
    Plot plot;
    plot.name = freeName(scene, kindName(Kind::Plot));
    if (m_plots.empty()) {
        Plot kept = m_own;
        kept.name = plot.name;
        plot.name += " 2";
        edit.changes.emplace_back(AddItem{place++, {next, kept}});
        next = Id{std::uint32_t(next) + 1};
    }
    for (const Curve& curve : m_views[m_current]->curves())
        plot.probes.push_back(Id{curve.probe}); // its own ticks from the beginning
    edit.changes.emplace_back(AddItem{place, {next, plot}});
    m_current = m_plots.empty() ? 1 : m_plots.size();
    m_document.push(edit);
}

void PlotPanel::removePlot(int number)
{
    if (std::size_t(number) < m_plots.size())
        m_document.push(removal(m_document.scene(), {m_plots[std::size_t(number)].id}));
}

void PlotPanel::change(const Plot& wanted)
{
    if (!m_plots.empty()) {
        auto changes = changesTo(wanted, plotOf(m_current), m_plots[m_current].id);
        if (!changes.empty())
            m_document.push({Message("Change %1", plotOf(m_current).name), std::move(changes)});
        return;
    }
    m_own = wanted;
    rebuildViews();
    rebuildList();
}

} // namespace ripstop
