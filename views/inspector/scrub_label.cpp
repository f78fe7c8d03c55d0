#include "inspector/scrub_label.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int mostCharacters = 20; // of a name in a line

} // namespace

ScrubLabel::ScrubLabel(const QString& text, QWidget* parent)
    : QLabel(text, parent)
{}

QSize ScrubLabel::sizeHint() const
{
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    if (m_wraps) {
        const QRect room(0, 0, mostCharacters * metrics.averageCharWidth(), QWIDGETSIZE_MAX);
        return metrics.boundingRect(room, Qt::TextWordWrap, text()).size();
    }
    QSize size = QLabel::sizeHint();
    size.setWidth(std::max(size.width(), metrics.horizontalAdvance(text())));
    return size;
}

void ScrubLabel::setWrapping()
{
    m_wraps = true;
    setWordWrap(true);
}

void ScrubLabel::setScrubbing(bool on)
{
    m_scrubbing = on;
    setCursor(on ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void ScrubLabel::setIdle(bool idle)
{
    const auto role = idle ? QPalette::PlaceholderText : QPalette::WindowText;
    if (foregroundRole() != role) // or it would be painted again
        setForegroundRole(role);
}

void ScrubLabel::mousePressEvent(QMouseEvent* event)
{
    if (!m_scrubbing)
        return QLabel::mousePressEvent(event);
    if (event->button() == Qt::RightButton && m_moving)
        emit cancelled();
    m_pressed = event->button() == Qt::LeftButton;
    m_moving = false;
    m_last = event->globalPosition().x();
    m_distance = 0.0;
}

void ScrubLabel::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_pressed)
        return;
    const double place = event->globalPosition().x();
    if (!m_moving) {
        if (std::abs(place - m_last) < QApplication::startDragDistance() / 2.0)
            return;
        m_moving = true;
        m_last = place;
        emit began();
    }
    const double fineness = event->modifiers() & Qt::ShiftModifier     ? 0.1
                            : event->modifiers() & Qt::ControlModifier ? 10.0
                                                                       : 1.0;
    m_distance += fineness * (place - m_last);
    m_last = place;
    emit dragged(m_distance);
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent*)
{
    m_pressed = false;
    m_moving = false;
}

} // namespace ripstop
