// The size is in the first chunk of a PNG (ISO/IEC 15948, 11.2.2), and in the frame header of a
// JPEG (ISO/IEC 10918-1, B.2.2), which is found by going from segment to segment. Both are followed
// to their ends, as what draws them shows a damaged picture in part or not at all without a word.
#include "shapes/picture_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr double mostPixels = 64e6;              // what Qt reads into 256 MiB, its limit
constexpr std::uintmax_t mostBytes = 256U << 20; // of so many pixels, without compression

std::uint32_t wholeNumber(const std::string& bytes, std::size_t at, std::size_t count)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i)
        number = number << 8 | std::uint8_t(bytes[at + i]);
    return number;
}

// Whether all chunks are there and are as they were written.
bool isWholePng(const std::string& bytes)
{
    constexpr std::size_t around = 12; // bytes of a chunk beside its data: length, name, checksum
    for (std::size_t at = 8; at + around <= bytes.size();) {
        const std::size_t length = wholeNumber(bytes, at, 4);
        if (length > bytes.size() - at - around)
            return false;
        const auto* name = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        if (crc32(0, name, uInt(4 + length)) != wholeNumber(bytes, at + 8 + length, 4))
            return false;
        if (bytes.compare(at + 4, 4, "IEND") == 0)
            return true;
        at += around + length;
    }
    return false;
}

struct Jpeg
{
    std::optional<PictureSize> size;
    bool isWhole = false;
};

// Goes from mark to mark: 0xff and a byte that says what begins. In the picture itself 0xff 0x00
// stands for 0xff, and the marks from 0xd0 to 0xd7 have no data.
Jpeg readJpeg(const std::string& bytes)
{
    Jpeg jpeg;
    bool isInPicture = false;
    for (std::size_t at = 2; at + 2 <= bytes.size();) {
        const auto mark = std::uint8_t(bytes[at + 1]);
        if (std::uint8_t(bytes[at]) != 0xff || (isInPicture && mark == 0x00)) {
            if (!isInPicture)
                return jpeg;
            ++at;
            continue;
        }
        if (mark == 0xff) { // fills
            ++at;
            continue;
        }
        if (mark >= 0xd0 && mark <= 0xd9) {
            jpeg.isWhole = mark == 0xd9;
            if (jpeg.isWhole)
                return jpeg;
            at += 2;
            continue;
        }
        if (at + 9 > bytes.size())
            return jpeg;
        const bool isFrame = mark >= 0xc0 && mark <= 0xcf && mark != 0xc4 && mark != 0xc8
                             && mark != 0xcc; // tables and extensions
        if (isFrame)
            jpeg.size =
                PictureSize{int(wholeNumber(bytes, at + 7, 2)), int(wholeNumber(bytes, at + 5, 2))};
        isInPicture = mark == 0xda;
        at += 2 + std::max<std::size_t>(wholeNumber(bytes, at + 2, 2), 2);
    }
    return jpeg;
}

} // namespace

Result<PictureSize> readPictureSize(const fs::path& file)
{
    std::error_code error;
    const std::uintmax_t length = fs::file_size(file, error);
    if (!error && length > mostBytes)
        return Failure("%1 has more than 256 MiB: make it smaller.", file.string());
    std::string bytes(error ? 0 : std::size_t(length), '\0');
    std::ifstream in(file, std::ios::binary);
    if (error || !in.read(bytes.data(), std::streamsize(bytes.size())))
        return Failure("%1 cannot be read: check the path.", file.string());
    std::optional<PictureSize> size;
    bool isWhole = true;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.size() >= 24) {
        size = PictureSize{int(wholeNumber(bytes, 16, 4)), int(wholeNumber(bytes, 20, 4))};
        isWhole = isWholePng(bytes);
    } else if (bytes.starts_with("\xff\xd8")) {
        const Jpeg jpeg = readJpeg(bytes);
        size = jpeg.size;
        isWhole = jpeg.isWhole;
    }
    if (!size || size->width <= 0 || size->height <= 0)
        return Failure("%1 is neither a PNG nor a JPEG: save the picture as one of these.",
                       file.string());
    if (double(size->width) * size->height > mostPixels)
        return Failure("%1 has %2 x %3 pixels: make it smaller, of 64 million at most.",
                       file.string(), size->width, size->height);
    if (!isWhole)
        return Failure("%1 is cut off or damaged: save or copy the picture again.", file.string());
    return *size;
}

} // namespace ripstop
