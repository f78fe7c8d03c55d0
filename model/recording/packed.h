// Bytes, compressed by zstd: stretches of recordings, in memory and in files. Free functions may be
// called from any thread; a Packer belongs to one.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace ripstop {

enum class Packing { Fast, Small };

std::string packed(std::string_view bytes, Packing packing = Packing::Fast);

// Packs one after the other, fast. It keeps the memory that this takes: fresh pages for each would
// cost more than packing does.
class Packer
{
public:
    Packer();

    std::string operator()(std::string_view bytes);

private:
    std::shared_ptr<ZSTD_CCtx_s> m_context;
    std::string m_room;
};

// As a difference to another text, which is needed to unpack it: a scene after an edit takes some
// hundred bytes.
std::string packedAfter(std::string_view before, std::string_view bytes);

// As packed bytes say it themselves, which may be false; nothing when they do not.
std::optional<std::uint64_t> unpackedSize(std::string_view packed);

// Takes as much memory as unpackedSize() says. A failure is half a sentence: why the bytes are
// damaged.
Result<std::string> unpacked(std::string_view packed, std::string_view before = {});

// Tells damaged bytes from whole ones.
std::uint64_t checksum(std::string_view bytes);

} // namespace ripstop
