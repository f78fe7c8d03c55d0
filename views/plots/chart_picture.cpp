#include "plots/chart_picture.h"

#include "document/write_beside.h"

#include <QFileInfo>
#include <QSvgGenerator>
#include <qcustomplot.h>

namespace ripstop {
namespace {

constexpr double density = 2.0; // pixels of a picture for one of the screen

bool saveSvg(QCustomPlot& plot, const QString& file)
{
    QSvgGenerator svg;
    svg.setFileName(file);
    svg.setSize(plot.size());
    svg.setViewBox(QRect(QPoint(), plot.size()));
    QCPPainter painter;
    if (!painter.begin(&svg))
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot.toPainter(&painter, plot.width(), plot.height());
    return painter.end() && QFileInfo(file).size() > 0;
}

} // namespace

QPixmap pictureOf(QCustomPlot& plot) { return plot.toPixmap(0, 0, density); }

bool savePicture(QCustomPlot& plot, const QString& file)
{
    const QString suffix = QFileInfo(file).suffix().toLower();
    return writeBeside(file, [&](const QString& written) {
        if (suffix == QLatin1String("svg"))
            return saveSvg(plot, written);
        if (suffix == QLatin1String("pdf"))
            return plot.savePdf(written);
        return plot.savePng(written, 0, 0, density);
    });
}

} // namespace ripstop
