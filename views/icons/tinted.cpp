#include "icons/tinted.h"

#include "icons/icon.h"

#include <QApplication>
#include <QPainter>

namespace ripstop {

QIcon tinted(const QString& name, const QColor& colour)
{
    const QSize side(20, 20); // px
    QPixmap picture = icon(name).pixmap(side, qApp->devicePixelRatio());
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(QRect(QPoint(), side), colour);
    painter.end();
    QIcon sign(picture);
    sign.addPixmap(picture, QIcon::Selected);
    return sign;
}

} // namespace ripstop
