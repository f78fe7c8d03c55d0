#include "study/shown_value.h"

#include "document/spoken.h"
#include "study/opened_study.h"
#include "study/point_scene.h"

#include <QRegularExpression>

namespace ripstop {

QString fourDigits(double number) { return spokenNumber(number); }

QString shownValue(const std::string& value)
{
    const QString text = QString::fromStdString(value);
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber ? fourDigits(number) : text;
}

// The unit stands in brackets at the end: withUnit() has written it.
QString valueOfVariable(const OpenedStudy& study, std::size_t variable, const std::string& value)
{
    const StudyVariable& one = study.study.variables[variable];
    QString text = QString::fromStdString(value);
    bool isNumber = false;
    if (const double number = text.toDouble(&isNumber); isNumber)
        text = spokenText(number, unitOf(study.scene, one.paths.front()));
    return QString::fromStdString(one.name) + ' ' + text;
}

AxisWords wordsOfHeading(const QString& heading)
{
    static const QRegularExpression form(QStringLiteral("^(.*\\S) \\(([^()]*)\\)$"));
    const QRegularExpressionMatch parts = form.match(heading);
    return parts.hasMatch() ? AxisWords{parts.captured(1), parts.captured(2)}
                            : AxisWords{heading, {}};
}

QString measuredText(const QString& heading, double value)
{
    return spokenText(value, wordsOfHeading(heading).unit.toStdString());
}

} // namespace ripstop
