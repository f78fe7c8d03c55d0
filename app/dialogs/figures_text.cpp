#include "dialogs/figures_text.h"

#include "document/spoken.h"
#include "document/words.h"

#include <QStringList>

namespace ripstop {
QString textOf(const DesignFigures& figures)
{
    const QString point = QStringLiteral(" \u00b7 ");
    const QString box =
        words("%1 wide, %2 high, %3 deep")
            .arg(spokenText(figures.size.x(), "m"), spokenText(figures.size.y(), "m"),
                 spokenText(figures.size.z(), "m"));
    if (figures.particles == 0) // an obstacle
        return box;
    QStringList counts{counted(Kind::Particle, qsizetype(figures.particles)),
                       counted(Kind::Link, qsizetype(figures.links))};
    if (figures.panels > 0)
        counts << counted(Kind::Panel, qsizetype(figures.panels));
    QStringList sizes{spokenText(figures.mass, "kg")};
    if (figures.area > 0.0)
        sizes << words("%1 of cloth").arg(spokenText(figures.area, "m\u00b2"));
    if (figures.lineLength > 0.0)
        sizes << words("%1 of line").arg(spokenText(figures.lineLength, "m"));
    QStringList shape;
    if (figures.aspect)
        shape << words("Span %1").arg(spokenText(figures.span, "m"))
              << words("aspect ratio %1").arg(QLocale().toString(*figures.aspect, 'g', 3));
    else
        shape << box;
    if (figures.substeps > 0)
        shape << words("%1 substeps of %2")
                     .arg(QString::number(figures.substeps),
                          spokenText(figures.timeStep / figures.substeps, "s"));
    else
        shape << words("steps of %1").arg(spokenText(figures.timeStep, "s"));
    return counts.join(point) + QChar('\n') + sizes.join(point) + QChar('\n') + shape.join(point);
}

QString textOf(const std::vector<OtherMaterial>& staying)
{
    QStringList lines;
    for (const OtherMaterial& other : staying)
        lines << words("%1: of %2 by now, which stays until another is chosen.")
                     .arg(choiceLabel(other.parameter), translated(other.preset->label));
    return lines.join(QChar(' '));
}

QString textOf(const HandmadeParts& lost, std::size_t letGo)
{
    QStringList work;
    if (lost.moved > 0)
        work << words("%1 moved").arg(counted(Kind::Particle, qsizetype(lost.moved)));
    if (lost.changed > 0)
        work << words("%1 changed rows").arg(lost.changed);
    if (lost.painted > 0)
        work << words("%1 painted rows").arg(lost.painted);
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
