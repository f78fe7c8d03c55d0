// Bytes, compressed by zstd.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace ripstop {

enum class Packing { Fast, Small };

std::string packed(std::string_view bytes, Packing packing = Packing::Fast);

// As a difference to another text, which is needed to unpack it: a scene after an edit takes some
// hundred bytes.
std::string packedAfter(std::string_view before, std::string_view bytes);

// A failure is half a sentence: why the bytes are damaged.
Result<std::string> unpacked(std::string_view packed, std::string_view before = {});

// Tells damaged bytes from whole ones.
std::uint64_t checksum(std::string_view bytes);

} // namespace ripstop
