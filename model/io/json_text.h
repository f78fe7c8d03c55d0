// Pieces of JSON text. Numbers are the shortest that read back as the same bits. Nothing here
// fails: what JSON or UTF-8 cannot say is replaced.
#pragma once

#include <string>
#include <string_view>

namespace ripstop {

// A number that JSON has no word for (not a number, infinite) becomes null.
void appendNumber(std::string& text, double number);

// The same alone.
std::string numberText(double number);

// With quotation marks. Bytes that are not UTF-8 become question marks.
void appendQuoted(std::string& text, std::string_view value);

// Fit for one line of a message: control characters become blanks, bytes that are not UTF-8
// question marks.
std::string printable(std::string_view value);

} // namespace ripstop
