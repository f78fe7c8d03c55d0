#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace ripstop {

// One design of a gallery: a picture, a title and a line about it; the whole card is a button.
class Card final : public QAbstractButton
{
    Q_OBJECT

public:
    // Without a picture the icon of that name stands in for it.
    Card(const QString& title, const QString& note, const QPixmap& picture, const QString& iconName,
         QWidget* parent = nullptr);

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
