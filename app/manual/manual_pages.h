// Which page of the manual tells of which part of the window, as one table: of docks and bars by
// the names of their objects, of dialogs and the view by their classes, of properties by the
// names that the inspector gives their widgets, "property material.porosity". Pages are named as in
// the tree, without their ending; headings as their links have them.
#pragma once

#include <QString>

#include <span>

class QWidget;

namespace ripstop {

struct ManualPage
{
    QString page;   // "docs/tuning"
    QString anchor; // "sliders"; empty is the top
};

struct ManualRow
{
    const char* of;
    const char* page;
    const char* anchor;
};

std::span<const ManualRow> manualTable();

ManualPage firstManualPage();

// By the nearest of the widget and those above it that the table knows: a property, a panel, a
// dialog. The first page where there is none.
ManualPage manualPageFor(const QWidget* widget);

} // namespace ripstop
