// Writer has a text for each kind of item; the functions after it count the rows of a table, of the
// selected ones too.
#include "outline/detail.h"

#include "document/spoken.h"
#include "document/words.h"
#include "scene/wind.h"
#include "select/rows_among.h"

#include <QLocale>

#include <algorithm>

namespace ripstop {
namespace {

template <typename Visit>
auto withTable(const Part& part, Kind table, Visit visit)
{
    if (table == Kind::Particle)
        return visit(part.particles);
    if (table == Kind::Link)
        return visit(part.links);
    return visit(part.panels);
}

// That of MIL-F-8785C which is nearest, for 7.7, 15.4 and 23.2 m/s of wind at 20 ft: the number by
// itself reads as the speed of the gusts, which is a fifth of it.
QString turbulence(double windAt20Feet)
{
    return windAt20Feet <= 0.0    ? words("none")
           : windAt20Feet < 11.55 ? words("light")
           : windAt20Feet < 19.3  ? words("moderate")
                                  : words("severe");
}

struct Writer
{
    const Scene& scene;

    QString operator()(const Part& part) const { return choiceLabel(part.builder).toLower(); }
    QString operator()(const Material& material) const
    {
        return material.tearRule == TearRule::Never ? QString() : words("tears");
    }
    QString operator()(const Group& group) const
    {
        return QLocale().toString(qulonglong(group.members.size()));
    }
    QString operator()(const Collider& collider) const
    {
        return choiceLabel(choiceNames<ColliderShape>[std::size_t(collider.shape)]).toLower();
    }
    QString operator()(const Wind& wind) const
    {
        if (wind.kind == WindKind::Gusts)
            return turbulence(wind.gustiness);
        return spokenText(airflowOf(wind).velocity.norm(), "m/s", 3);
    }
    QString operator()(const Control& control) const
    {
        QStringList keys;
        for (const std::string& key : {control.keyLess, control.keyMore})
            if (!key.empty())
                keys << keyText(key);
        return keys.join(QStringLiteral(" / "));
    }
    QString operator()(const Probe& probe) const
    {
        const QString quantity =
            choiceLabel(choiceNames<Quantity>[std::size_t(probe.quantity)]).toLower();
        return probe.target == noId
                   ? quantity
                   : quantity + QStringLiteral(" \u00b7 ") + nameOf(scene, probe.target);
    }
    QString operator()(const Plot& plot) const
    {
        return choiceLabel(choiceNames<PlotAxis>[std::size_t(plot.axis)]).toLower();
    }
};

} // namespace

std::vector<Id> rowIds(const Part& part, Kind table)
{
    return withTable(part, table, [](const auto& rows) {
        std::vector<Id> ids;
        ids.reserve(rows.size());
        for (const auto& row : rows)
            ids.push_back(row.id);
        return ids;
    });
}

QString tableDetail(const Part& part, Kind table, const std::vector<Id>& selected)
{
    return withTable(part, table, [&](const auto& rows) {
        const QString all = QLocale().toString(qulonglong(rows.size()));
        if (rows.empty() || selected.empty())
            return all;
        std::size_t count = 0;
        forEachRowAmong(rows, selected, [&](const auto&, std::size_t) { ++count; });
        if (count == 0 || count == rows.size())
            return all;
        return words("%1 of %2").arg(QLocale().toString(qlonglong(count)), all);
    });
}

QString itemDetail(const Scene& scene, const Item& item) { return std::visit(Writer{scene}, item); }

} // namespace ripstop
