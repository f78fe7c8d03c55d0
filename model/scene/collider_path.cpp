#include "scene/collider_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace ripstop {
namespace {

// Takes one number from the front of the text; nothing when it does not begin with a finite one.
std::optional<double> takeNumber(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t,"), text.size()));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
        return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return value;
}

} // namespace

Result<std::vector<PathKey>> pathFromText(std::string_view text)
{
    std::vector<PathKey> path;
    while (text.find_first_not_of(" \t") != std::string_view::npos) {
        std::string_view key = text.substr(0, text.find(';'));
        text.remove_prefix(std::min(key.size() + 1, text.size()));
        const std::string told =
            "row " + std::to_string(path.size() + 1) + ", \"" + std::string(key) + "\",";
        const auto time = takeNumber(key);
        const bool colon = time && key.starts_with(':');
        key.remove_prefix(colon ? 1 : 0);
        const auto x = takeNumber(key), y = takeNumber(key), z = takeNumber(key);
        if (!colon || !x || !y || !z || key.find_first_not_of(" \t") != std::string_view::npos)
            return Failure("must be times and places as 0: 0 1 0; 2.5: 3 1 0 (%1 is not)", told);
        if (!path.empty() && *time <= path.back().time)
            return Failure("must have times that ascend (%1 is not later than the row before)",
                           told);
        path.push_back({*time, Vec3(*x, *y, *z)});
    }
    return path;
}

} // namespace ripstop
