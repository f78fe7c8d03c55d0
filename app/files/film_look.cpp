#include "files/film_look.h"

#include "document/spoken.h"
#include "scene/scene.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {

std::vector<std::uint32_t> sharesOf(const Scene& scene)
{
    std::vector<std::uint32_t> ids;
    for (const Entry& entry : scene.items)
        if (const auto* probe = std::get_if<Probe>(&entry.item);
            probe && isSaidInPercent(probe->quantity))
            ids.push_back(std::uint32_t(entry.id));
    return ids;
}

QStringList captionOf(const Frame& frame, const FilmLook& look)
{
    QStringList lines;
    if (look.time)
        lines << QString("%L1 s").arg(frame.time, 0, 'f', 2);
    for (std::size_t i = 0; look.probes && i < frame.probe.size(); ++i) {
        const Layout::Probe& probe = frame.layout->probes[i];
        if (!probe.plotted)
            continue;
        const bool isShare = std::ranges::count(look.inPercent, probe.id) > 0;
        const QString value = std::isfinite(frame.probe[i])
                                  ? readingText(isShare, frame.probe[i], probe.unit)
                                  : QCoreApplication::translate("Film", "none", "value");
        lines << QString::fromStdString(probe.name) + QStringLiteral("  ") + value;
    }
    return lines;
}

void paintCaption(QImage& picture, const Frame& frame, const FilmLook& look)
{
    const QStringList lines = captionOf(frame, look);
    if (lines.isEmpty() || picture.isNull())
        return;
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    font.setPixelSize(std::max(10, picture.height() / 36));
    painter.setFont(font);
    const int margin = painter.fontMetrics().height() / 2;
    constexpr int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip;
    const QString caption = lines.join('\n');
    const QRect text =
        painter.boundingRect(picture.rect().translated(2 * margin, 2 * margin), flags, caption);

    // the caption is dark on a light field, so that it can be read on any background
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 200));
    painter.drawRoundedRect(text.adjusted(-margin, -margin / 2, margin, margin / 2), margin / 2.0,
                            margin / 2.0);
    painter.setPen(QColor(32, 36, 44));
    painter.drawText(text, flags, caption);
}

} // namespace ripstop
