// One list of loaded places: what it is, what it bears of what it could, and when. Those that have
// torn are numbered in the order in which they are given; one without a strength has no margin.
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
    std::vector<LoadedPlace> m_places; // of the rows
};

} // namespace ripstop
