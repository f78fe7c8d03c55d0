// Values of a study for people: numbers with four digits, and all else as it was typed.
#pragma once

#include <QString>

#include <string>

namespace ripstop {

QString fourDigits(double number);

QString shownValue(const std::string& value);

} // namespace ripstop
