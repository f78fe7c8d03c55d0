#include "files/view_picture.h"

#include "document/write_beside.h"
#include "viewport/viewport.h"

#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int dotsPerInch = 300; // of a page: 3000 pixels are ten inches

bool paint(Viewport& viewport, const PictureLook& look, QPaintDevice& page)
{
    QPainter painter;
    if (!painter.begin(&page))
        return false;
    PictureLook bare = look;
    bare.overlays = false;
    painter.drawImage(QRect(QPoint(), look.size), pixelsOf(viewport, bare));
    if (look.overlays)
        viewport.paintOverlays(painter, look.size);
    return painter.end();
}

bool writeSvg(Viewport& viewport, const PictureLook& look, const QString& file)
{
    QSvgGenerator svg;
    svg.setFileName(file);
    svg.setSize(look.size);
    svg.setViewBox(QRect(QPoint(), look.size));
    svg.setTitle(QStringLiteral("Ripstop"));
    return paint(viewport, look, svg);
}

bool writePdf(Viewport& viewport, const PictureLook& look, const QString& file)
{
    QPdfWriter pdf(file);
    pdf.setCreator(QStringLiteral("Ripstop"));
    pdf.setResolution(dotsPerInch);
    pdf.setPageSize(
        QPageSize(QSizeF(look.size) / dotsPerInch, QPageSize::Inch, {}, QPageSize::ExactMatch));
    pdf.setPageMargins({});
    return paint(viewport, look, pdf);
}

bool writePixels(Viewport& viewport, PictureLook look, const QString& file, const QString& format)
{
    const bool hasAlpha = format == QLatin1String("png");
    if (look.backdrop == Backdrop::Transparent && !hasAlpha)
        look.backdrop = Backdrop::White;
    return pixelsOf(viewport, look).save(file, format.toLatin1().constData());
}

} // namespace

QSize sizeOfWidth(int width, QSize view)
{
    const double share = double(std::max(view.height(), 1)) / std::max(view.width(), 1);
    return {width, std::max(1, int(std::lround(width * share)))};
}

QImage pixelsOf(Viewport& viewport, const PictureLook& look)
{
    return viewport.image(Viewport::Shot{
        look.size, look.overlays ? Viewport::Overlays::With : Viewport::Overlays::Without,
        look.backdrop, look.pins ? Viewport::Pins::With : Viewport::Pins::Without});
}

bool writePicture(Viewport& viewport, const PictureLook& look, const QString& file)
{
    const QString suffix = QFileInfo(file).suffix().toLower();
    return writeBeside(file, [&](const QString& written) {
        if (suffix == QLatin1String("svg"))
            return writeSvg(viewport, look, written);
        if (suffix == QLatin1String("pdf"))
            return writePdf(viewport, look, written);
        return writePixels(viewport, look, written, suffix);
    });
}

} // namespace ripstop
