#include "document/edit_words.h"

#include "document/spoken.h"
#include "document/words.h"

namespace ripstop {
namespace {

// "8, 0, 0 m/s". Where numbers have commas, semicolons stand between them.
QString saidInLine(const Vec3& vector, std::string_view unit)
{
    QStringList axes;
    for (const double axis : vector)
        axes << compactNumber(axis);
    const bool hasCommas = compactNumber(0.5).contains(QChar(','));
    const QString all = axes.join(hasCommas ? QStringLiteral("\u202f; ") : QStringLiteral(", "));
    return unit.empty() ? all : all + QChar(QChar::Nbsp) + text(unit);
}

// A value for the end of a step of the history, which tells steps of one property apart; empty for
// what has no room in a line, such as notes and lists.
QString saidInLine(const Property& property, const Value& value)
{
    if (const double* number = std::get_if<double>(&value))
        return spokenText(*number, property.unit);
    if (const int* number = std::get_if<int>(&value))
        return QString::number(*number);
    if (const bool* flag = std::get_if<bool>(&value))
        return *flag ? words("yes") : words("no");
    if (const Vec3* vector = std::get_if<Vec3>(&value))
        return saidInLine(*vector, property.unit);
    const std::string* choice = std::get_if<std::string>(&value);
    return choice && !property.choices.empty() ? choiceLabel(*choice) : QString();
}

} // namespace

Message settingLabel(const Scene& scene, const Property& property, const std::vector<Id>& ids,
                     std::span<const Value> values)
{
    const QString name = labelOf(property).toLower();
    const QString things = describe(scene, ids);
    const QString value = values.size() == 1 ? saidInLine(property, values.front()) : QString();
    //: history: "Set mass of 3 particles of kite"
    const QString label = value.isEmpty() ? words("Set %1 of %2").arg(name, things)
                                          //: history: "Set mass of 3 particles of kite to 2 g"
                                          : words("Set %1 of %2 to %3").arg(name, things, value);
    return Message::verbatim(label.toStdString());
}

} // namespace ripstop
