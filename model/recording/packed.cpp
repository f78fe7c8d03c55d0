// Compression by zstd: one level for speed, one for size, a prefix for texts that differ little
// from the one before, and a bound on what is unpacked, as a damaged length must not take all
// memory.
#include "recording/packed.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include <zstd.h>

namespace ripstop {
namespace {

// Of what is unpacked; a length in a damaged file must not take all the memory there is.
constexpr unsigned long long largest = 8ull << 30; // bytes

struct FreeContext
{
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

constexpr int fast = 1; // of zstd's levels
constexpr int small = 9;

std::string_view packInto(std::string& room, ZSTD_CCtx& context, std::string_view bytes)
{
    room.resize(std::max(room.size(), ZSTD_compressBound(bytes.size())));
    const std::size_t size =
        ZSTD_compress2(&context, room.data(), room.size(), bytes.data(), bytes.size());
    return {room.data(), ZSTD_isError(size) ? 0 : size};
}

int windowFor(std::size_t bytes)
{
    int bits = 20;
    while (bits < 30 && (std::size_t(1) << bits) < bytes)
        ++bits;
    return bits;
}

std::string pack(std::string_view before, std::string_view bytes, int level)
{
    const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    if (!before.empty()) {
        ZSTD_CCtx_setParameter(context.get(), ZSTD_c_enableLongDistanceMatching, 1);
        ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog,
                               windowFor(before.size() + bytes.size()));
        ZSTD_CCtx_refPrefix(context.get(), before.data(), before.size());
    }
    std::string room;
    return std::string(packInto(room, *context, bytes));
}

} // namespace

std::string packed(std::string_view bytes, Packing packing)
{
    return pack({}, bytes, packing == Packing::Fast ? fast : small);
}

Packer::Packer()
    : m_context(ZSTD_createCCtx(), ZSTD_freeCCtx)
{
    ZSTD_CCtx_setParameter(m_context.get(), ZSTD_c_compressionLevel, fast);
}

std::string Packer::operator()(std::string_view bytes)
{
    return std::string(packInto(m_room, *m_context, bytes));
}

std::string packedAfter(std::string_view before, std::string_view bytes)
{
    return pack(before, bytes, 3);
}

std::optional<std::uint64_t> unpackedSize(std::string_view packed)
{
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR)
        return std::nullopt;
    return size;
}

Result<std::string> unpacked(std::string_view packed, std::string_view before)
{
    const std::optional<std::uint64_t> size = unpackedSize(packed);
    if (!size || *size > largest)
        return Failure{"it is no compressed data"};
    const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
    ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, 31);
    if (!before.empty())
        ZSTD_DCtx_refPrefix(context.get(), before.data(), before.size());
    std::string bytes(std::size_t(*size), '\0');
    const std::size_t done = ZSTD_decompressDCtx(context.get(), bytes.data(), bytes.size(),
                                                 packed.data(), packed.size());
    if (ZSTD_isError(done) || done != bytes.size())
        return ZSTD_isError(done) ? Failure(Message::verbatim(ZSTD_getErrorName(done)))
                                  : Failure("it is too short");
    return bytes;
}

// FNV-1a over words of eight bytes.
std::uint64_t checksum(std::string_view bytes)
{
    std::uint64_t value = 0xcbf29ce484222325u ^ bytes.size();
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        value = (value ^ word) * 0x100000001b3u;
        value ^= value >> 32; // a word's high bits must reach the low ones
    }
    return value;
}

} // namespace ripstop
