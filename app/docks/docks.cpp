// Stages: the constructor makes the docks in the order of the table, puts those of one area behind
// each other as tabs, brings the first of each area to the front, and gives the areas their first
// sizes at the end, when all are there. Below stands what is shown and hidden when the window goes
// between the start page and a scene; m_closed remembers what the user has closed, because the
// start page hides all.
#include "docks/docks.h"

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
{
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    for (const DockRow& row : dockTable())
        add(window, row, parts);

    std::map<Qt::DockWidgetArea, bool> seen;
    std::map<Qt::Orientation, std::pair<QList<QDockWidget*>, QList<int>>> sizes;
    for (const auto& [row, dock] : m_all) {
        if (!std::exchange(seen[row.area], true))
            dock->raise();
        if (row.size > 0) {
            auto& [docks, wanted] = sizes[isWide(row) ? Qt::Vertical : Qt::Horizontal];
            docks << dock;
            wanted << row.size;
        }
    }
    for (const auto& [along, wish] : sizes)
        window.resizeDocks(wish.first, wish.second, along);
}

void Docks::add(QMainWindow& window, const DockRow& row, const PanelParts& parts)
{
    auto* dock = new QDockWidget(row.title, &window);
    dock->setObjectName(row.id); // restoreState() knows docks by this
    QWidget* panel = row.make(parts, m_panels, *dock);
    dock->setWidget(panel);
    window.addDockWidget(row.area, dock);
    const auto before = std::ranges::find_if(m_all.rbegin(), m_all.rend(), [&](const Dock& other) {
        return other.row.area == row.area;
    });
    if (before != m_all.rend())
        window.tabifyDockWidget(before->widget, dock);
    m_panels.add(*panel);
    m_all.push_back({row, dock});
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
