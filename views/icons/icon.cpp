// An icon is an engine that knows only the name of its drawing. When it is painted, it takes the
// colour that text has at that moment (normal, disabled or selected), draws the SVG in a pixmap,
// fills what is drawn with that colour, and keeps the result in the pixmap cache of Qt under name,
// size and colour. A drawing that does not exist gives an empty picture.
#include "icons/icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

// Resources of a static library are only linked in when they are asked for; outside any namespace.
static void loadResources() { Q_INIT_RESOURCE(ripstop); }

namespace ripstop {
namespace {

QString drawingOf(const QString& name)
{
    static const bool loaded = (loadResources(), true);
    Q_UNUSED(loaded);
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

QColor inkFor(QIcon::Mode mode)
{
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled)
        return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (mode == QIcon::Selected)
        return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::WindowText);
}

// Paints a one-colour drawing in the colour that text has now.
class InkEngine final : public QIconEngine
{
public:
    explicit InkEngine(QString name)
        : m_name(std::move(name))
    {}

    QIconEngine* clone() const override { return new InkEngine(m_name); }
    QString key() const override { return QStringLiteral("ripstop-ink"); }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatioF();
        painter->drawPixmap(rect, scaledPixmap(rect.size() * ratio, mode, state, ratio));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return scaledPixmap(size, mode, state, 1.0);
    }

    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override
    {
        const QColor ink = inkFor(mode);
        const QString cacheKey = QStringLiteral("ripstop-ink:%1:%2x%3@%4:%5")
                                     .arg(m_name)
                                     .arg(size.width())
                                     .arg(size.height())
                                     .arg(scale)
                                     .arg(ink.rgba());
        QPixmap picture;
        if (!QPixmapCache::find(cacheKey, &picture)) {
            picture = draw(size, ink);
            QPixmapCache::insert(cacheKey, picture);
        }
        return picture;
    }

private:
    QPixmap draw(const QSize& size, const QColor& ink) const
    {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        const QString drawing = drawingOf(m_name);
        if (size.isEmpty() || !QFile::exists(drawing))
            return picture;
        QSvgRenderer renderer(drawing);
        QPainter painter(&picture);
        const int side = std::min(size.width(), size.height());
        renderer.render(&painter, QRectF((size.width() - side) / 2.0, (size.height() - side) / 2.0,
                                         side, side));
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(picture.rect(), ink);
        return picture;
    }

    QString m_name;
};

} // namespace

QIcon icon(const QString& name) { return QIcon(new InkEngine(name)); }

QIcon applicationIcon()
{
    QSvgRenderer renderer(drawingOf(QStringLiteral("app")));
    QIcon whole;
    for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap picture(side, side);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        renderer.render(&painter);
        whole.addPixmap(picture);
    }
    return whole;
}

} // namespace ripstop
