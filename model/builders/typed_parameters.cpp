// parametersFrom() splits each text at its first equals sign; a table is read from the text or from
// the file that it names, anything else is a number or a choice.
#include "builders/typed_parameters.h"

#include "scene/typed_number.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace ripstop {
namespace {

// "1.2, 0.5; 1.1, 0.4", or "@lengths.csv" for what stands in a file.
Result<NumberRows> tableFrom(const TableParameter& table, const std::string& text)
{
    if (!text.starts_with('@'))
        return tableFromText(table, text);
    std::ifstream file(text.substr(1));
    std::ostringstream content;
    content << file.rdbuf();
    if (!file)
        return Failure("%1: cannot read the file %2.", table.key, text.substr(1));
    return tableFromText(table, content.str());
}

} // namespace

std::string listed(std::span<const std::string_view> choices)
{
    std::string list;
    for (const std::string_view choice : choices)
        list.append(list.empty() ? "" : ", ").append(choice);
    return list;
}

Result<double> parameterValue(const Builder& builder, std::string_view key, std::string_view text)
{
    const auto parameter = std::ranges::find(builder.parameters, key, &Parameter::key);
    const bool isKnown = parameter != builder.parameters.end();
    const bool isChoice = isKnown && !parameter->choices.empty();
    if (isChoice)
        if (const auto choice = std::ranges::find(parameter->choices, text);
            choice != parameter->choices.end())
            return double(choice - parameter->choices.begin());
    const Typed typed =
        typedValue(text, isKnown ? parameter->unit : std::string_view(), ThreeDigits::AreRefused);
    if (typed.number)
        return typed.number->number;
    return isChoice
               ? Failure("%1 must be one of %2, not \"%3\".", key, listed(parameter->choices), text)
               : Failure("%1 %2, not \"%3\".", key, typed.complaint, text);
}

Result<Parameters> parametersFrom(const Builder& builder, const std::vector<std::string>& texts)
{
    Parameters parameters;
    for (const std::string& text : texts) {
        const auto equals = text.find('=');
        if (equals == std::string::npos)
            return Failure("\"%1\" sets nothing; write KEY=VALUE, like span=2.4.", text);
        const std::string key = text.substr(0, equals);
        if (builder.table && key == builder.table->key) {
            const Result<NumberRows> rows = tableFrom(*builder.table, text.substr(equals + 1));
            if (!rows)
                return rows.failure();
            setTable(parameters, *builder.table, *rows);
            continue;
        }
        const Result<double> value =
            parameterValue(builder, key, std::string_view(text).substr(equals + 1));
        if (!value)
            return value.failure();
        if (!parameters.emplace(key, *value).second)
            return Failure("%1 is given twice.", key);
    }
    return parameters;
}

} // namespace ripstop
