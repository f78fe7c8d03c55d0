// What the mouse and the keyboard do in the viewport, when no tool takes them.
//
// Each event goes to Pointing first. A press only notes its place; a move beyond the distance that
// a hand trembles becomes a drag, which turns or shifts the camera; a release without a drag is a
// click, which selects or asks for a menu. A camera that a person has moved is no longer fitted by
// itself.
#include "viewport/viewport_data.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double zoomPerNotch = 0.85;

} // namespace

void Viewport::mousePressEvent(QMouseEvent* event)
{
    d->pressed = d->last = event->position();
    d->dragging = false;
    d->pointing.press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (d->pointing.move(*event) || event->buttons() == Qt::NoButton)
        return;
    // a hand trembles while it clicks
    if ((event->position() - d->pressed).manhattanLength() >= QApplication::startDragDistance())
        d->dragging = true;
    if (!d->dragging)
        return;
    const QPointF step = event->position() - d->last;
    d->last = event->position();
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool turns = event->buttons().testFlag(Qt::LeftButton)
                       || (d->pointing.hasTool() && event->buttons().testFlag(Qt::RightButton));
    if (turns && !shift)
        d->camera.orbit(step.x(), step.y());
    else
        d->camera.pan(step.x(), step.y(), height());
    d->untouched = false;
    d->screen.renderSoon();
    emit cameraChanged();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (d->pointing.release(*event) || d->dragging)
        return;
    const Id under = pick(event->position());
    if (event->button() == Qt::LeftButton)
        d->click(under, event->modifiers());
    if (event->button() == Qt::RightButton) {
        if (under != noId && !std::ranges::binary_search(d->selection.ids(), under))
            d->click(under, {});
        emit menuWanted(event->globalPosition().toPoint());
    }
}

void Viewport::leaveEvent(QEvent*) { d->pointing.hover({}); }

// Keys belong to the gesture under way before they are anyone's shortcut.
bool Viewport::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool gives = d->pointing.hasTool() || d->pointing.holds();
        if ((key.key() == Qt::Key_Escape && gives) || d->pointing.takesKey(key))
            event->accept();
    }
    if (event->type() == QEvent::LayoutRequest) // a bar has come, gone or another size
        d->place();
    return QWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    const bool escapes = event->key() == Qt::Key_Escape && d->pointing.escape();
    if (!escapes && !d->pointing.key(*event))
        QWidget::keyPressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (d->pointing.wheel(*event))
        return;
    const double notches = event->angleDelta().y() / 120.0;
    const double x = 2.0 * event->position().x() / width() - 1.0;
    const double y = 1.0 - 2.0 * event->position().y() / height();
    // a following camera keeps its object in the middle
    const bool centred = d->chase.isOn();
    d->camera.zoom(std::pow(zoomPerNotch, notches), centred ? 0.0 : x, centred ? 0.0 : y,
                   d->aspect());
    d->untouched = false;
    d->screen.renderSoon();
    emit cameraChanged();
}

} // namespace ripstop
