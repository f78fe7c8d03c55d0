#include "study/shown_value.h"

#include "document/words.h"

namespace ripstop {

QString fourDigits(double number)
{
    return compactNumber(QString::number(number, 'g', 4).toDouble());
}

QString shownValue(const std::string& value)
{
    const QString text = QString::fromStdString(value);
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber ? fourDigits(number) : text;
}

} // namespace ripstop
