// How charts look in the colours and the font of the window.
#pragma once

class QCPAxis;
class QCPLegend;
class QWidget;

namespace ripstop {

void styleAxis(QCPAxis& axis, const QWidget& chart);
void styleLegend(QCPLegend& legend, const QWidget& chart);

} // namespace ripstop
