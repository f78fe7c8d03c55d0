#include "editor/window_tour.h"

#include "docks/docks.h"
#include "document/document.h"
#include "document/words.h"
#include "editor/tour.h"
#include "files/files.h"
#include "start/samples.h"
#include "viewport/viewport.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

namespace ripstop {
namespace {

void addDocks(std::vector<TourStop>& stops, const Docks& docks, Qt::DockWidgetAreas areas)
{
    for (const auto& [row, dock] : docks.all())
        if (areas.testFlag(row.area) && !row.tourTitle.isEmpty())
            stops.push_back({dock, row.tourTitle, row.tourText});
}

std::vector<TourStop> stopsOf(const TouredWindow& toured)
{
    const Qt::DockWidgetAreas beside = Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea;
    std::vector<TourStop> stops;
    stops.push_back(
        {&toured.viewport, words("The design, and its flight"),
         words("Drag to turn, wheel to zoom, middle drag to move. Click selects; box and lasso are "
               "at "
               "the upper left. Keys G, R and S move, turn and scale what is selected.")});
    addDocks(stops, toured.docks, beside);
    stops.push_back(
        {&toured.transport, words("Fly it"),
         words("Space plays and pauses, the full stop does one step, Ctrl+R goes back to "
               "the design. Keys of the controls steer; they stand under Controls.")});
    addDocks(stops, toured.docks, ~beside);
    stops.push_back(
        {toured.window.menuBar(), words("Everything else"),
         words(
             "New from builder begins with a whole kite, glider or parachute; Import makes fabric "
             "of a mesh; Export is for Blender and ParaView. F3 finds any action, F1 opens "
             "the manual where it tells of what is under the mouse.")});
    return stops;
}

} // namespace

void showTour(const TouredWindow& toured)
{
    const QStringList samples = sampleFiles().filter("delta_kite");
    if (!toured.document.scene().items.empty())
        toured.showScene();
    else if (samples.isEmpty() || !toured.files.open(samples.first()))
        return;
    auto* tour = new Tour(stopsOf(toured), &toured.window); // deletes itself
    QObject::connect(tour, &QObject::destroyed, &toured.viewport,
                     [&view = toured.viewport] { view.setFocus(); });
}

} // namespace ripstop
