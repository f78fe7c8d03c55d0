// What is said is model/scene/said_number.h's; here it gets the decimal point of the language.
#include "document/spoken.h"

#include "document/words.h"
#include "scene/said_number.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int fieldDigits = 6; // as compactNumber() has
constexpr double leastInField = 1e-3;
constexpr double leastMetresInField = 1e-2; // diameters are millimetres wherever they stand
constexpr double mostInField = 1e6;

QString plain(double number, int digits)
{
    return QString::fromStdString(plainNumber(number, digits))
        .replace(QChar('.'), QLocale().decimalPoint());
}

} // namespace

QString Spoken::text() const { return unit.isEmpty() ? number : number + QChar(0x00a0) + unit; }

Spoken spoken(double value, std::string_view unit, int digits)
{
    if (isNothing(value, unit))
        return {QStringLiteral("0"), text(unit)};
    const NumberInUnit said = inReadableUnit(value, unit);
    return {plain(said.number, digits), text(said.unit)};
}

QString spokenText(double value, std::string_view unit, int digits)
{
    return std::isfinite(value) ? spoken(value, unit, digits).text() : QString(QChar(0x2013));
}

bool isSaidInPercent(Quantity quantity)
{
    return quantity == Quantity::Strain || quantity == Quantity::MaxStrain
           || quantity == Quantity::MeanStrain || quantity == Quantity::HighStrain
           || quantity == Quantity::WrinkledShare;
}

QString readingText(bool isShare, double value, std::string_view unit, int digits)
{
    return isShare ? spokenText(100.0 * value, "%", digits) : spokenText(value, unit, digits);
}

QString readingText(Quantity quantity, double value, std::string_view unit, int digits)
{
    return readingText(isSaidInPercent(quantity), value, unit, digits);
}

QString spokenNumber(double value, int digits)
{
    return std::isfinite(value) ? plain(value, digits) : QString(QChar(0x2013));
}

double heldValue(double value) { return isNothing(value) ? 0.0 : value; }

double roundStep(double least)
{
    if (!(least > 0.0) || !std::isfinite(least))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least * (1.0 - 1e-9))
            return step * power;
    return 10.0 * power;
}

SpokenScale spokenScale(double largest, std::string_view unit, bool isShare)
{
    if (isShare)
        return {0.01, QStringLiteral("%")};
    const ReadableUnit said = readableUnit(largest, unit);
    return {said.factor, text(said.name)};
}

QString SpokenScale::number(double value, int digits) const
{
    return spokenNumber(heldValue(value) / factor, digits);
}

QString SpokenScale::atStep(double value, double step) const
{
    const double said = value / factor;
    const double apart = step / factor;
    if (!(apart > 0.0) || std::abs(said) < 1e-6 * apart)
        return QStringLiteral("0");
    const int decimals = std::clamp(int(std::ceil(-std::log10(apart) - 1e-9)), 0, 20);
    return QString::number(said, 'f', decimals).replace(QChar('.'), QLocale().decimalPoint());
}

Spoken spokenInField(double value, std::string_view unit)
{
    const double size = std::abs(value);
    const double least = unit == "m" ? leastMetresInField : leastInField;
    if (size == 0.0 || (size >= least && size < mostInField) || !std::isfinite(value))
        return {compactNumber(value), text(unit)};
    const NumberInUnit said = inReadableUnit(value, unit, least, mostInField);
    const QString number = plain(said.number, fieldDigits);
    return said.unit == unit ? Spoken{number, text(unit)}
                             : Spoken{number + QChar(' ') + text(said.unit), QString()};
}

} // namespace ripstop
