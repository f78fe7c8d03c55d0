// Stages: the constructor makes the docks in the order of the table. arrange() puts those of one
// area behind each other as tabs, brings the first of each area to the front, and gives the areas
// their first sizes at the end, when all are there. Below stands what is shown and hidden when the
// window goes between the start page and a scene; m_closed remembers what the user has closed,
// because the start page hides all.
#include "docks/docks.h"

#include "inspector/inspector.h"
#include "loads/load_panel.h"
#include "plots/plot_panel.h"
#include "study/study_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

bool isWide(const DockRow& row)
{
    return row.area == Qt::BottomDockWidgetArea || row.area == Qt::TopDockWidgetArea;
}

} // namespace

Docks::Docks(QMainWindow& window, const PanelParts& parts)
    : m_window(window)
{
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    for (const DockRow& row : dockTable())
        add(row, parts);
    arrange();
}

void Docks::add(const DockRow& row, const PanelParts& parts)
{
    auto* dock = new QDockWidget(row.title, &m_window);
    dock->setObjectName(row.id); // restoreState() knows docks by this
    // the search finds a panel by the words of other programs under this name (other_words.h)
    dock->toggleViewAction()->setObjectName(QStringLiteral("dock.%1").arg(row.id));
    QWidget* panel = row.make(parts, m_panels, *dock);
    dock->setWidget(panel);
    m_panels.add(*panel);
    m_all.push_back({row, dock});
}

void Docks::place(const Dock& dock, const Dock* before) const
{
    dock.widget->setFloating(false);
    m_window.addDockWidget(dock.row.area, dock.widget);
    if (before)
        m_window.tabifyDockWidget(before->widget, dock.widget);
}

void Docks::arrange()
{
    std::map<Qt::DockWidgetArea, const Dock*> last;
    std::map<Qt::DockWidgetArea, QDockWidget*> first;
    std::map<Qt::Orientation, std::pair<QList<QDockWidget*>, QList<int>>> sizes;
    for (const Dock& dock : m_all) {
        place(dock, std::exchange(last[dock.row.area], &dock));
        first.try_emplace(dock.row.area, dock.widget);
        if (dock.row.size > 0) {
            auto& [docks, wanted] = sizes[isWide(dock.row) ? Qt::Vertical : Qt::Horizontal];
            docks << dock.widget;
            wanted << dock.row.size;
        }
    }
    m_closed.clear();
    showOpen();
    for (const auto& [area, dock] : first)
        dock->raise();
    for (const auto& [along, wish] : sizes)
        m_window.resizeDocks(wish.first, wish.second, along);
}

bool Docks::show(const QString& id) const
{
    const auto found = std::ranges::find_if(
        m_all, [&](const Dock& dock) { return dock.widget->objectName() == id; });
    if (found == m_all.end())
        return false;
    found->widget->show();
    found->widget->raise();
    return true;
}

bool Docks::showToggled(const QAction& toggle) const
{
    return std::ranges::any_of(m_all, [&](const Dock& dock) {
        return dock.widget->toggleViewAction() == &toggle && show(dock.widget->objectName());
    });
}

QList<QAction*> Docks::toggles() const
{
    std::map<QString, QAction*> sorted;
    for (const Dock& dock : m_all)
        sorted[dock.widget->objectName()] = dock.widget->toggleViewAction();
    QList<QAction*> toggles;
    for (const auto& [id, toggle] : sorted)
        toggles << toggle;
    return toggles;
}

void Docks::takeOver(const Docks& before)
{
    for (std::size_t i = 0; i < m_all.size(); ++i) // of the same table
        if (before.m_closed.contains(before.m_all[i].widget))
            m_closed.insert(m_all[i].widget);
    panel<PlotPanel>().takeOver(before.panel<PlotPanel>());
    panel<StudyPanel>().takeOver(before.panel<StudyPanel>());
    panel<Inspector>().sliders().takeOver(before.panel<Inspector>().sliders());
}

void Docks::catchUp() const
{
    panel<PlotPanel>().catchUp();
    panel<LoadPanel>().catchUp();
}

void Docks::hideAll() const
{
    for (const Dock& dock : m_all)
        dock.widget->hide();
}

void Docks::noteClosed()
{
    m_closed.clear();
    for (const Dock& dock : m_all)
        if (dock.widget->isHidden())
            m_closed.insert(dock.widget);
}

void Docks::showOpen() const
{
    for (const Dock& dock : m_all)
        dock.widget->setVisible(!m_closed.contains(dock.widget));
}

void Docks::bringForward() const
{
    for (const Dock& dock : m_all)
        if (dock.row.onOpening == OnOpening::ComesForward)
            dock.widget->raise();
}

} // namespace ripstop
