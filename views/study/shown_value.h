// Values of a study for people: numbers with four digits and without exponents, and all else as it
// was typed; and the words of its headings, "height (m)", for axes that say units by themselves.
#pragma once

#include "plots/spoken_axis.h"

#include <QString>

#include <string>

namespace ripstop {

struct OpenedStudy; // study/opened_study.h

QString fourDigits(double number);

QString shownValue(const std::string& value);

// "EA 3000 N": what a variable of a study is in a flight. A value that is no number alone stays as
// it was typed.
QString valueOfVariable(const OpenedStudy& study, std::size_t variable, const std::string& value);

AxisWords wordsOfHeading(const QString& heading);

// A value of what this is the heading of, with its unit.
QString measuredText(const QString& heading, double value);

} // namespace ripstop
