#include "builders/builder.h"

#include "builders/designs.h"
#include "scene/property.h"

#include <cmath>
#include <cstdio>

namespace ripstop {
namespace {

const Parameter* findParameter(const Builder& builder, std::string_view key)
{
    for (const Parameter& parameter : builder.parameters)
        if (parameter.key == key)
            return &parameter;
    return nullptr;
}

Failure unknown(const Builder& builder, const std::string& key)
{
    std::vector<std::string_view> keys;
    for (const Parameter& parameter : builder.parameters)
        keys.push_back(parameter.key);
    const std::string_view near = nearest(key, keys);
    std::string message =
        "The builder " + std::string(builder.name) + " has no parameter \"" + key + "\"";
    if (!near.empty())
        return Failure{message + "; did you mean \"" + std::string(near) + "\"?"};
    message += "; it has";
    for (std::size_t i = 0; i < keys.size(); ++i)
        message += (i ? ", " : " ") + std::string(keys[i]);
    return Failure{message + "."};
}

std::optional<Failure> refused(const Parameter& parameter, double value)
{
    const bool inRange = value >= parameter.low && value <= parameter.high; // false for NaN
    if (inRange && (!parameter.whole || value == std::floor(value)))
        return std::nullopt;
    const std::string unit(parameter.unit);
    char text[200];
    std::snprintf(text, sizeof text, "%s must be %s from %g to %g%s%s, and is %g.",
                  std::string(parameter.key).c_str(),
                  parameter.whole ? "a whole number" : "a number", parameter.low, parameter.high,
                  unit.empty() ? "" : " ", unit.c_str(), value);
    return Failure{text};
}

} // namespace

std::span<const Builder> allBuilders()
{
    static const std::array table{clothBuilder,      ropeBuilder,      hangGliderBuilder,
                                  deltaKiteBuilder,  parachuteBuilder, stiffenedRodBuilder,
                                  bendingTestBuilder};
    return table;
}

const Builder* findBuilder(std::string_view name)
{
    for (const Builder& builder : allBuilders())
        if (builder.name == name)
            return &builder;
    return nullptr;
}

Result<Scene> build(const Builder& builder, const Parameters& given)
{
    Parameters all;
    for (const Parameter& parameter : builder.parameters)
        all.emplace(parameter.key, parameter.initial);
    for (const auto& [key, value] : given) {
        const Parameter* parameter = findParameter(builder, key);
        if (!parameter)
            return unknown(builder, key);
        if (const auto failure = refused(*parameter, value))
            return *failure;
        all[key] = value;
    }
    return builder.build(all);
}

} // namespace ripstop
