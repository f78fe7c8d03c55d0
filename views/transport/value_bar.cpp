#include "transport/value_bar.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double inset = 5.0; // px, so that the mark fits at either end

} // namespace

ValueBar::ValueBar(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMinimumWidth(90);
}

void ValueBar::setLimit(double limit)
{
    m_limit = limit;
    update();
}

void ValueBar::show(double value, double command)
{
    if (value == m_value && command == m_command)
        return;
    m_value = value;
    m_command = command;
    setToolTip(tr("%1 m of at most %2 m either way; told to go to %3 m")
                   .arg(QLocale().toString(value, 'f', 3), QLocale().toString(m_limit),
                        QLocale().toString(command, 'f', 3)));
    update();
}

QSize ValueBar::sizeHint() const { return {160, fontMetrics().height() + 8}; }

double ValueBar::place(double value) const
{
    const double part = m_limit > 0.0 ? std::clamp(value / m_limit, -1.0, 1.0) : 0.0;
    return inset + (0.5 + 0.5 * part) * (width() - 2.0 * inset);
}

void ValueBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(inset, 2.5, width() - 2.0 * inset, height() - 5.0);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(palette().base());
    painter.drawRoundedRect(track, 3.0, 3.0);

    // the value, from the middle
    const double middle = place(0.0);
    const double value = place(m_value);
    painter.setPen(Qt::NoPen);
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(0.55f);
    painter.setBrush(fill);
    painter.drawRect(QRectF(std::min(middle, value), track.top() + 1.0, std::abs(value - middle),
                            track.height() - 2.0));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawLine(QPointF(middle, track.top()), QPointF(middle, track.bottom()));

    // the command
    const double command = place(m_command);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawPolygon(QPolygonF{{command - 4.0, 0.0}, {command + 4.0, 0.0}, {command, 6.0}});
    painter.drawRect(QRectF(command - 0.5, 2.0, 1.0, height() - 4.0));

    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(track.adjusted(6, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter,
                     tr("%1 m").arg(QLocale().toString(m_value, 'f', 2)));
}

} // namespace ripstop
