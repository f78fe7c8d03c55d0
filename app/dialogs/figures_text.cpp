#include "dialogs/figures_text.h"

#include "document/words.h"

#include <QStringList>

namespace ripstop {
namespace {

QString quantity(double value, const char* unit)
{
    return QLocale().toString(value, 'g', 4) + QChar(0xa0) + QString::fromUtf8(unit);
}

// "12.4 m", "4.5 m²", "320 g"
QString weight(double mass)
{
    return mass < 1.0 ? quantity(1000.0 * mass, "g") : quantity(mass, "kg");
}

} // namespace

QString textOf(const DesignFigures& figures)
{
    const QString point = QStringLiteral(" \u00b7 ");
    const QString box = words("%1 wide, %2 high, %3 deep")
                            .arg(quantity(figures.size.x(), "m"), quantity(figures.size.y(), "m"),
                                 quantity(figures.size.z(), "m"));
    if (figures.particles == 0) // an obstacle
        return box;
    QStringList counts{counted(Kind::Particle, qsizetype(figures.particles)),
                       counted(Kind::Link, qsizetype(figures.links))};
    if (figures.panels > 0)
        counts << counted(Kind::Panel, qsizetype(figures.panels));
    QStringList sizes{weight(figures.mass)};
    if (figures.area > 0.0)
        sizes << words("%1 of cloth").arg(quantity(figures.area, "m\u00b2"));
    if (figures.lineLength > 0.0)
        sizes << words("%1 of line").arg(quantity(figures.lineLength, "m"));
    QStringList shape;
    if (figures.aspect)
        shape << words("Span %1").arg(quantity(figures.span, "m"))
              << words("aspect ratio %1").arg(QLocale().toString(*figures.aspect, 'g', 3));
    else
        shape << box;
    shape << words("%1 substeps of %2")
                 .arg(figures.substeps)
                 .arg(quantity(1000.0 * figures.timeStep / figures.substeps, "ms"));
    return counts.join(point) + QChar('\n') + sizes.join(point) + QChar('\n') + shape.join(point);
}

QString textOf(const HandmadeParts& lost, std::size_t letGo)
{
    QStringList work;
    if (lost.moved > 0)
        work << words("%1 moved").arg(counted(Kind::Particle, qsizetype(lost.moved)));
    if (lost.changed > 0)
        work << words("%1 changed rows").arg(lost.changed);
    if (lost.added > 0)
        work << words("%1 added rows").arg(lost.added);
    if (lost.removed > 0)
        work << words("%1 removed rows").arg(lost.removed);
    QStringList lines;
    if (!work.isEmpty())
        lines << words("Takes back what was done by hand: %1. To keep it, detach the part instead.")
                     .arg(work.join(QStringLiteral(", ")));
    if (letGo > 0)
        lines << words("Lets go of what %1 others point at.").arg(letGo);
    return lines.join(QChar(' '));
}

} // namespace ripstop
