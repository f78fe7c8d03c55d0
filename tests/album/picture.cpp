#include "album/picture.h"

#include <QApplication>
#include <QPainter>
#include <QWidget>

namespace ripstop {

QImage pictureOf(QWidget& window)
{
    QPixmap picture = window.grab();
    QPainter painter(&picture);
    for (QWidget* one : QApplication::topLevelWidgets()) {
        if (!one->isVisible() || one == &window || one->windowType() == Qt::ToolTip)
            continue;
        const QPoint corner = one->mapToGlobal(QPoint()) - window.mapToGlobal(QPoint());
        painter.drawPixmap(corner, one->grab());
        painter.setPen(QPen(QColor(128, 128, 128), 1));
        painter.drawRect(QRect(corner, one->size()).adjusted(-1, -1, 0, 0));
    }
    painter.end();
    return picture.toImage();
}

} // namespace ripstop
