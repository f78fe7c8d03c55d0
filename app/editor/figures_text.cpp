#include "editor/figures_text.h"

#include "document/words.h"

#include <QCoreApplication>
#include <QStringList>

namespace ripstop {
namespace {

QString words(const char* text) { return QCoreApplication::translate("Figures", text); }

QString quantity(double value, const char* unit)
{
    return QString::number(value, 'g', 4) + QChar(0xa0) + QString::fromUtf8(unit);
}

// "12.4 m", "4.5 m²", "320 g"
QString weight(double mass)
{
    return mass < 1.0 ? quantity(1000.0 * mass, "g") : quantity(mass, "kg");
}

} // namespace

QString textOf(const Figures& figures)
{
    const QString point = QStringLiteral(" \u00b7 ");
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
              << words("aspect ratio %1").arg(QString::number(*figures.aspect, 'g', 3));
    else
        shape << words("%1 wide, %2 high, %3 deep")
                     .arg(quantity(figures.size.x(), "m"), quantity(figures.size.y(), "m"),
                          quantity(figures.size.z(), "m"));
    shape << words("%1 substeps of %2")
                 .arg(figures.substeps)
                 .arg(quantity(1000.0 * figures.timeStep / figures.substeps, "ms"));
    return counts.join(point) + QChar('\n') + sizes.join(point) + QChar('\n') + shape.join(point);
}

} // namespace ripstop
