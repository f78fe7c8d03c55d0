// A card of a gallery, for one design: a picture, a title and three lines about it. The whole card
// is a button. The start page shows the samples as cards. Only the window's thread uses it.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace ripstop {

class Card final : public QAbstractButton
{
    Q_OBJECT

public:
    // Where the picture is null, the icon of that name stands in for it.
    Card(const QString& title, const QString& note, const QPixmap& picture, const QString& iconName,
         QWidget* parent = nullptr);

    // px; every card has the same size with the same font.
    static QSize cardSize(const QFontMetrics& metrics);
    QSize sizeHint() const override { return cardSize(fontMetrics()); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintPicture(QPainter& painter, const QRectF& place) const;
    void paintWords(QPainter& painter, const QRectF& place) const;

    QString m_note;
    QPixmap m_picture;
};

} // namespace ripstop
