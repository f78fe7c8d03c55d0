// How charts look in the colours and the font of the window, and the parts that all charts share:
// the plot inside a widget, axes, legends, and the room around values. Chart, XyChart and
// PolarChart call these again whenever palette or font change. Only the window's thread calls them.
#pragma once

#include <QString>

#include <string_view>
#include <vector>

class QCPAbstractPlottable;
class QCPAxis;
class QCPAxisRect;
class QCPLegend;
class QCPRange;
class QCustomPlot;
class QWidget;

namespace ripstop {

QCustomPlot* makePlot(QWidget& chart); // a plot that fills the chart and belongs to it

QString withUnit(const QString& name, const QString& unit); // "height (m)"

void styleAxis(QCPAxis& axis, const QWidget& chart);
void styleLegend(QCPLegend& legend, const QWidget& chart);
// Fills the legend with the names of the curves, in as many columns as the width, px, has room for.
// When they need more rows than `rows`, long names are shortened; when even those have no room, the
// last place says how many names are left out, which is never all of them.
void fitLegend(QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, int width,
               int rows);

// Above the axes, where it hides no curve; fitLegend() fills it.
void putLegendAbove(QCustomPlot& plot);

// The range of an axis that shows these values: 8 % of their span above and below, and never an
// empty range; of nothing but zeros, half of `one`. What is less than what the engine holds of that
// unit is nothing.
QCPRange withAir(const QCPRange& values, double one = 1.0, std::string_view unit = {});

// The range that an axis takes which shows `shown` and is to show these values: as it is where they
// fit, because an axis that moved with every sample could not be read.
QCPRange fittedRange(const QCPRange& values, const QCPRange& shown, bool logarithmic,
                     double one = 1.0, std::string_view unit = {});

// Leaves little room around the axes beyond what their numbers need.
void tighten(QCPAxisRect& rect);

void stylePlot(QCustomPlot& plot, const QWidget& chart); // draws it again

} // namespace ripstop
