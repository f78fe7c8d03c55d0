#include "icons/swatch.h"

#include <QHash>
#include <QPainter>
#include <QPixmap>

namespace ripstop {

QIcon swatch(const QColor& color)
{
    static QHash<QRgb, QIcon> made; // lists ask for it whenever they are painted
    QIcon& icon = made[color.rgba()];
    if (!icon.isNull())
        return icon;

    constexpr int side = 16;   // px
    constexpr int density = 2; // stays sharp on dense screens
    QPixmap picture(side * density, side * density);
    picture.fill(Qt::transparent);
    picture.setDevicePixelRatio(density);

    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(128, 128, 128, 160), 1.0)); // seen on light and on dark
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(2.5, 2.5, 11, 11), 2.5, 2.5);
    painter.end();

    icon.addPixmap(picture);
    icon.addPixmap(picture, QIcon::Selected); // the colour itself, also in a selected row
    return icon;
}

} // namespace ripstop
