// Files that are read and written as a whole, so that nobody sees half of one. Failures name the
// file, the reason and what to do.
#pragma once

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

// Waiting for the disk takes some milliseconds: worth it for a design, not for each file of a
// series.
enum class Flush { ToDisk, Later };

// Why a file cannot be written: its folder is missing, or it or its folder is protected. For long
// work that ends in writing it; nothing when it can be, as far as can be known beforehand.
std::optional<Failure> unwritable(const std::filesystem::path& file);

// Writes a file beside the target and renames it, so that whoever looks finds the old content or
// the new one whole, even after a crash. Follows symbolic links and keeps permissions. Devices and
// pipes are written as they are, and stay.
std::optional<Failure> replaceFile(const std::filesystem::path& file, std::string_view content,
                                   Flush flush = Flush::ToDisk);

// The same for what is written bit by bit. A failure of `write` leaves the old file.
using WriteInto = std::function<std::optional<Failure>(std::ostream&)>;
std::optional<Failure> replaceFile(const std::filesystem::path& file, const WriteInto& write,
                                   Flush flush = Flush::ToDisk);

} // namespace ripstop
