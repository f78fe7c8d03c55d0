// One list of loaded places: what it is, what it bears of what it could, and when. Those that have
// torn are numbered in the order in which they are given; one without a strength has no margin.
//
// Where names of places have no room, what these can bear is told by the tips of their loads alone:
// margin and load say it, too.
//
// Rows are changed where they stand, so that a list that follows a run can be clicked; what was
// chosen stays marked where it goes.
#pragma once

#include "laws/load_margin.h"

#include <QTreeWidget>

#include <span>
#include <vector>

namespace ripstop {

struct Scene;

class LoadList final : public QTreeWidget
{
    Q_OBJECT

public:
    enum Column { Margin, Place, Load, Strength, Time };

    //   name  of the list, for those who hear it
    LoadList(const QString& title, const QString& name, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void showPlaces(const Scene& scene, std::span<const LoadedPlace> places);

signals:
    void chosen(const ripstop::LoadedPlace& place);

private:
    void resizeEvent(QResizeEvent* event) override;
    void makeRoomForPlaces();

    std::vector<LoadedPlace> m_places; // of the rows
    int m_widestPlace = 0;             // px, of all that stood here
    int m_widestStrength = 0;          // px, likewise: a hidden column has no width to ask for
};

} // namespace ripstop
