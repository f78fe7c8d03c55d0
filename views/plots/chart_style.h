// How charts look in the colours and the font of the window.
#pragma once

class QCPAxis;
class QCPLegend;
class QCustomPlot;
class QWidget;

namespace ripstop {

void styleAxis(QCPAxis& axis, const QWidget& chart);
void styleLegend(QCPLegend& legend, const QWidget& chart);
void stylePlot(QCustomPlot& plot, const QWidget& chart); // of one pair of axes; draws it again

} // namespace ripstop
