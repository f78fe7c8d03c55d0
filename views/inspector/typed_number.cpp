#include "inspector/typed_number.h"

#include <cmath>

namespace ripstop {
namespace {

// "0.5", "0,5", "1e-3" or "1/240"; the locale of the desktop does not matter.
std::optional<double> plainNumber(QString text)
{
    text = text.trimmed();
    if (text.count(QChar(',')) == 1 && !text.contains(QChar('.')))
        text.replace(QChar(','), QChar('.'));
    bool isNumber = false;
    const double whole = text.toDouble(&isNumber);
    if (isNumber)
        return whole;
    const qsizetype slash = text.indexOf(QChar('/'));
    if (slash <= 0)
        return std::nullopt;
    const double above = text.first(slash).trimmed().toDouble(&isNumber);
    if (!isNumber)
        return std::nullopt;
    const double below = text.mid(slash + 1).trimmed().toDouble(&isNumber);
    return isNumber ? std::optional(above / below) : std::nullopt;
}

bool takeFront(QString& text, const char* mark)
{
    if (!text.startsWith(QLatin1String(mark)))
        return false;
    text.remove(0, qsizetype(qstrlen(mark)));
    return true;
}

} // namespace

double TypedNumber::appliedTo(double before) const
{
    if (sort == Sort::Absolute)
        return number;
    return sort == Sort::Times ? before * number : before + number;
}

std::optional<TypedNumber> typedNumber(QString text, const QString& unit)
{
    using enum TypedNumber::Sort;
    text.replace(QChar(0x2212), QChar('-')); // a typographic minus
    text = text.trimmed();
    if (!unit.isEmpty() && text.endsWith(unit))
        text.chop(unit.size());
    text = text.trimmed();
    const bool isPercent = text.endsWith(QChar('%'));
    if (isPercent)
        text.chop(1);

    const bool plusEquals = takeFront(text, "+=");
    const bool minusEquals = !plusEquals && takeFront(text, "-=");
    const bool times = takeFront(text, "*") || takeFront(text, "\u00d7");
    const bool over = !times && takeFront(text, "/");
    const bool signedPercent = isPercent && (text.startsWith('+') || text.startsWith('-'));
    const bool plus = plusEquals || (!isPercent && !times && !over && text.startsWith('+'));

    const std::optional<double> read = plainNumber(text);
    if (!read)
        return std::nullopt;
    const double number = isPercent ? *read / 100.0 : *read;
    if (isPercent && (plusEquals || minusEquals || signedPercent))
        return TypedNumber{Times, 1.0 + (minusEquals ? -number : number)};
    if (times || over)
        return TypedNumber{Times, times ? number : 1.0 / number};
    if (plus || minusEquals)
        return TypedNumber{Plus, minusEquals ? -number : number};
    return TypedNumber{Absolute, number};
}

Transform transformOf(TypedNumber typed, int axis)
{
    return [typed, axis](const Value& before) -> Value {
        if (const double* real = std::get_if<double>(&before))
            return typed.appliedTo(*real);
        if (const int* whole = std::get_if<int>(&before)) {
            const double result = typed.appliedTo(*whole);
            const bool fits = std::abs(result) < 2e9;
            // Left as it is, a broken number is refused by its type.
            const bool isWhole =
                typed.sort != TypedNumber::Sort::Absolute || result == std::rint(result);
            return fits && isWhole ? Value(int(std::lround(result))) : Value(result);
        }
        if (const Vec3* vector = std::get_if<Vec3>(&before)) {
            Vec3 result = *vector;
            result[axis] = typed.appliedTo(result[axis]);
            return result;
        }
        // absent: only a value of its own can take its place
        return typed.sort == TypedNumber::Sort::Absolute ? Value(typed.number) : before;
    };
}

Transform setTo(Value value)
{
    return [value = std::move(value)](const Value&) { return value; };
}

} // namespace ripstop
