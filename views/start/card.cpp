// paintEvent() draws from back to front: the ground with round corners, the picture clipped to
// them, the title and the lines of the note, and last the outline, which shows whether the mouse or
// the focus is here. The card is painted by hand because no button of Qt cuts a picture to fill its
// place.
#include "start/card.h"

#include "document/plain_text.h"
#include "icons/icon.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

namespace ripstop {
namespace {

constexpr int cardWidth = 224;     // px
constexpr int pictureHeight = 126; // px, 16 : 9
constexpr int margin = 10;         // px
constexpr double corner = 6.0;     // px
constexpr int noteLines = 3;

} // namespace

Card::Card(const QString& title, const QString& note, const QPixmap& picture,
           const QString& iconName, QWidget* parent)
    : QAbstractButton(parent)
    , m_note(note)
    , m_picture(picture)
{
    setText(title);
    setIcon(ripstop::icon(iconName));
    setAccessibleName(title);
    setAccessibleDescription(note);
    setToolTip(shownAsIs(note));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
}

QSize Card::cardSize(const QFontMetrics& metrics)
{
    return {cardWidth, pictureHeight + (1 + noteLines) * metrics.lineSpacing() + 2 * margin + 4};
}

void Card::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF whole = QRectF(rect()).adjusted(1, 1, -1, -1);
    QPainterPath outline;
    outline.addRoundedRect(whole, corner, corner);

    painter.fillPath(outline, palette().base());
    painter.save();
    painter.setClipPath(outline);
    paintPicture(painter, QRectF(whole.left(), whole.top(), whole.width(), pictureHeight));
    painter.restore();
    paintWords(painter, whole.adjusted(margin, pictureHeight + margin - 2, -margin, -margin / 2));

    const bool chosen = underMouse() || hasFocus();
    painter.setBrush(isDown() ? QColor(128, 128, 128, 48) : QColor(Qt::transparent));
    painter.setPen(
        QPen(palette().color(chosen ? QPalette::Highlight : QPalette::Mid), chosen ? 2.0 : 1.0));
    painter.drawPath(outline);
}

// The picture fills its place; what does not fit is cut off evenly.
void Card::paintPicture(QPainter& painter, const QRectF& place) const
{
    if (!m_picture.isNull()) {
        const QSizeF fit = place.size().scaled(m_picture.size(), Qt::KeepAspectRatio);
        QRectF part(QPointF(), fit);
        part.moveCenter(QRectF(m_picture.rect()).center());
        painter.drawPixmap(place, m_picture, part);
        return;
    }
    painter.fillRect(place, palette().alternateBase());
    constexpr int side = 56; // px
    QRect middle(0, 0, side, side);
    middle.moveCenter(place.center().toPoint());
    painter.setOpacity(0.6);
    icon().paint(&painter, middle);
    painter.setOpacity(1.0);
}

void Card::paintWords(QPainter& painter, const QRectF& place) const
{
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::Text));
    const double line = fontMetrics().lineSpacing();
    painter.drawText(QRectF(place.left(), place.top(), place.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(bold).elidedText(text(), Qt::ElideRight, int(place.width())));

    painter.setFont(font());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    QTextLayout note(m_note, font());
    note.beginLayout();
    for (int i = 0; i < noteLines; ++i) {
        QTextLine row = note.createLine();
        if (!row.isValid())
            break;
        row.setLineWidth(place.width());
        QString words = m_note.mid(row.textStart(), row.textLength());
        if (i + 1 == noteLines) // the last row takes what is left, cut short
            words = fontMetrics().elidedText(m_note.mid(row.textStart()), Qt::ElideRight,
                                             int(place.width()));
        painter.drawText(
            QRectF(place.left(), place.top() + (1 + i) * line + 2, place.width(), line),
            Qt::AlignLeft | Qt::AlignVCenter, words);
    }
    note.endLayout();
}

void Card::enterEvent(QEnterEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void Card::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

} // namespace ripstop
