// How charts look in the colours and the font of the window.
#pragma once

#include <QString>

#include <vector>

class QCPAbstractPlottable;
class QCPAxis;
class QCPAxisRect;
class QCPLegend;
class QCPRange;
class QCustomPlot;
class QWidget;

namespace ripstop {

QCustomPlot* makePlot(QWidget& chart); // that fills the chart

QString withUnit(const QString& name, const QString& unit); // "height (m)"

void styleAxis(QCPAxis& axis, const QWidget& chart);
void styleLegend(QCPLegend& legend, const QWidget& chart);
// Names of the curves above the axes, in as many columns as the width, px, has room for; of more
// than these rows the last name says how many are left out.
void fitLegend(QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, int width,
               int rows);

// What an axis shows of such values: some air around them, and never nothing.
QCPRange withAir(const QCPRange& values);

// Little room around the axes: the numbers take what they need.
void tighten(QCPAxisRect& rect);

void stylePlot(QCustomPlot& plot, const QWidget& chart); // of one pair of axes; draws it again

} // namespace ripstop
