// Charts as files and for the clipboard.
#pragma once

#include <QPixmap>
#include <QString>

class QCustomPlot;

namespace ripstop {

QPixmap pictureOf(QCustomPlot& plot); // sharp in print

// PNG, SVG or PDF by its suffix; false when it cannot be written.
bool savePicture(QCustomPlot& plot, const QString& file);

} // namespace ripstop
