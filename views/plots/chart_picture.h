// Pictures of a chart, for files and for the clipboard, as it looks on the screen. They are called
// from the window's thread, because they draw the widget.
#pragma once

#include <QPixmap>
#include <QString>

class QCustomPlot;

namespace ripstop {

QPixmap pictureOf(QCustomPlot& plot); // twice as fine as the screen

// Writes SVG or PDF when the file has that suffix, else PNG. False when the file cannot be written.
bool savePicture(QCustomPlot& plot, const QString& file);

} // namespace ripstop
