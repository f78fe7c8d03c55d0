// Files that are read and written as a whole, so that nobody sees half of one. Failures name the
// file, the reason and what to do.
#pragma once

#include "base/new_file.h"
#include "base/result.h"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

// Given the first bytes of a file, the reason not to read the rest ("is not a scene"), or nothing.
using StartCheck = std::function<std::optional<Message>(std::string_view)>;

// Up to 4 GiB. Works on pipes too.
Result<std::string> readWholeFile(const std::filesystem::path& file, const StartCheck& check);

// Writes a file that is there whole or not at all (base/new_file.h).
std::optional<Failure> replaceFile(const std::filesystem::path& file, std::string_view content,
                                   Flush flush = Flush::ToDisk);

// The same for what is written bit by bit. A failure of `write` leaves the old file.
using WriteInto = std::function<std::optional<Failure>(std::ostream&)>;
std::optional<Failure> replaceFile(const std::filesystem::path& file, const WriteInto& write,
                                   Flush flush = Flush::ToDisk);

} // namespace ripstop
