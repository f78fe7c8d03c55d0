#include "overlays/overlay_paint.h"

#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace ripstop {

void paintOver(QPainter& painter, QSize picture, std::initializer_list<QWidget*> overlays,
               QSize view)
{
    const double scale = double(picture.height()) / std::max(view.height(), 1);
    const int wider = int(picture.width() / scale) - view.width(); // pixels of the view
    painter.save();
    painter.scale(scale, scale);
    for (QWidget* overlay : overlays) {
        if (overlay->isHidden())
            continue;
        const bool isRight = overlay->geometry().left() > view.width() / 2;
        overlay->render(&painter, overlay->pos() + QPoint(isRight ? wider : 0, 0), {},
                        QWidget::RenderFlags{});
    }
    painter.restore();
}

} // namespace ripstop
