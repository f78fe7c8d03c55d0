// Values of a study for people: numbers with four digits and without exponents, and all else as it
// was typed; and the words of its headings, "height (m)", for axes that say units by themselves.
#pragma once

#include "plots/spoken_axis.h"

#include <QString>

#include <string>

namespace ripstop {

QString fourDigits(double number);

QString shownValue(const std::string& value);

AxisWords wordsOfHeading(const QString& heading);

// A value of what this is the heading of, with its unit.
QString measuredText(const QString& heading, double value);

} // namespace ripstop
