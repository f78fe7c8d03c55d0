#include "icons/tinted.h"

#include "icons/icon.h"

#include <QApplication>
#include <QPainter>

namespace ripstop {

namespace {

QPixmap filled(QPixmap picture, const QColor& colour)
{
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(picture.rect(), colour);
    return picture;
}

} // namespace

QIcon tinted(const QString& name, const QColor& colour)
{
    const QSize side(20, 20); // px
    const QPixmap picture = icon(name).pixmap(side, qApp->devicePixelRatio());
    QIcon sign(filled(picture, colour));
    sign.addPixmap(filled(picture, qApp->palette().color(QPalette::HighlightedText)),
                   QIcon::Selected);
    return sign;
}

} // namespace ripstop
