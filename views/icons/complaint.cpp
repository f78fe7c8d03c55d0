#include "icons/complaint.h"

#include <QEvent>

namespace ripstop {

QColor wrongColor(const QPalette& ground)
{
    const bool isDark = ground.color(QPalette::Window).lightness() < 128;
    return isDark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb3, 0x26, 0x1e);
}

Complaint::Complaint(QWidget* parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText); // it repeats what was typed
    setWordWrap(true);
    hide();
    takeColor();
}

void Complaint::tell(const QString& sentence)
{
    setText(sentence);
    setVisible(!sentence.isEmpty());
}

void Complaint::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::ApplicationPaletteChange)
        takeColor();
    QLabel::changeEvent(event);
}

void Complaint::takeColor()
{
    QPalette colors;
    colors.setColor(QPalette::WindowText, wrongColor(colors));
    setPalette(colors);
}

} // namespace ripstop
