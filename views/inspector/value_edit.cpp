// judge() runs with each letter that is typed and complains. commit() announces a text that is not
// broken; the new value then comes back through show(). leave() commits or reverts, as when the
// focus goes. revert() shows the last value again. paintEvent() adds the unit and the outline of a
// broken text.
#include "inspector/value_edit.h"

#include "document/plain_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int unitGap = 5;     // px, on both sides of the unit
constexpr int leastWidth = 40; // px
constexpr int besideText = 12; // px, of the frame and what a line leaves free beside its text

} // namespace

ValueEdit::ValueEdit(Judge judge, QWidget* parent)
    : NumberLine(parent)
    , m_judge(std::move(judge))
{
    setMinimumWidth(leastWidth);
    connect(this, &QLineEdit::textEdited, this, &ValueEdit::judge);
}

void ValueEdit::setUnit(const QString& unit)
{
    if (unit == m_unit)
        return;
    m_unit = unit;
    const int width = unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(unit) + unitGap;
    setTextMargins(0, 0, width, 0);
    if (!unit.isEmpty()) // which would be painted over the end of the number
        setMinimumWidth(
            std::max(leastWidth, fontMetrics().horizontalAdvance(QStringLiteral("-0.00000")) + width
                                     + besideText));
    update();
}

void ValueEdit::show(const QString& text, const QString& hint)
{
    setPlaceholderText(hint);
    m_shown = text;
    if (hasFocus() && isModified())
        return;
    if (text != this->text()) {
        setText(text); // also forgets the undo of typing
        setCursorPosition(0);
    }
    complain({});
}

void ValueEdit::leave()
{
    if (!isModified())
        return;
    judge();
    if (isBroken() || !commit())
        revert();
}

void ValueEdit::judge() { complain(text() == m_shown ? QString() : m_judge(text())); }

bool ValueEdit::commit()
{
    if (isBroken())
        return false;
    if (isModified()) {
        const QString typed = text();
        setModified(false); // the new value may be shown now
        emit committed(typed);
        setText(m_shown);
    }
    return true;
}

void ValueEdit::revert()
{
    setText(m_shown);
    complain({});
}

void ValueEdit::complain(const QString& sentence)
{
    if (sentence == m_complaint)
        return;
    m_complaint = sentence;
    update();
    emit complained(sentence);
}

bool ValueEdit::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip || !isBroken())
        return NumberLine::event(event);
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), shownAsIs(m_complaint), this);
    return true;
}

void ValueEdit::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        judge();
        if (commit())
            selectAll();
        return;
    }
    if (key == Qt::Key_Escape && isModified()) {
        revert();
        selectAll();
        return;
    }
    if (m_steps && (key == Qt::Key_Up || key == Qt::Key_Down)) {
        leave();
        const int size = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
        emit stepped(key == Qt::Key_Up ? size : -size, event->isAutoRepeat());
        return;
    }
    NumberLine::keyPressEvent(event);
}

void ValueEdit::focusOutEvent(QFocusEvent* event)
{
    if (event->reason() != Qt::PopupFocusReason)
        leave();
    NumberLine::focusOutEvent(event);
    setCursorPosition(0); // the front of a long text tells more than its end
}

void ValueEdit::paintEvent(QPaintEvent* event)
{
    NumberLine::paintEvent(event);
    QPainter painter(this);
    if (!m_unit.isEmpty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(0, 0, -unitGap - 1, 0), Qt::AlignRight | Qt::AlignVCenter,
                         m_unit);
    }
    if (isBroken()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(QColor(0xd6, 0x3b, 0x3b), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2.5, 2.5);
    }
}

} // namespace ripstop
