// Reads a picture as heights. The first two bytes tell the format, whatever the name of the file
// is.
// 1. PGM, as text or binary, is read here: size, largest value, then samples of one or two bytes.
// 2. PNG is read by libpng, which turns palettes and colours into grey. It reports flaws by a long
//    jump, so that the function it jumps through holds nothing with a destructor.
// 3. Samples become heights from 0 (black) to 1 (white). Sizes are checked before memory is taken:
//    a PNG of one colour has a thousand points for each of its bytes, so that some kilobytes would
//    ask for half a gigabyte.
#include "shapes/height_picture.h"

#include <png.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <string>

namespace ripstop {
namespace {

constexpr int mostPoints = 8192;             // along a side
constexpr long pointsAtOnce = 8 << 20;       // of a PNG of any size, 2896 x 2896
constexpr std::uintmax_t pointsPerByte = 32; // more of them; a point takes ten bytes of memory

Failure unreadable(const std::filesystem::path& file, const Message& why)
{
    return Failure("The picture %1 cannot be read (%2); save it as a grey PNG of 8 or 16 bits, or "
                   "choose another file.",
                   file.string(), why);
}

std::optional<Message> badSize(long columns, long rows)
{
    if (columns >= 2 && rows >= 2 && columns <= mostPoints && rows <= mostPoints)
        return std::nullopt;
    return Message("it is %1 x %2 points, and 2 x 2 to 8192 x 8192 are possible", columns, rows);
}

// Whether a PNG has so few bytes for its points that it would take far more memory than it is
// worth.
bool isBomb(const std::filesystem::path& file, long columns, long rows)
{
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    return error || std::uintmax_t(columns * rows) > pointsAtOnce + pointsPerByte * bytes;
}

// Samples of one or two bytes, the high one first.
HeightGrid gridFrom(const std::vector<unsigned char>& samples, long columns, long rows,
                    double white, bool wide)
{
    HeightGrid grid{int(columns), int(rows), {}};
    const std::size_t count = std::size_t(columns) * std::size_t(rows);
    grid.height.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        grid.height.push_back((wide ? 256.0 * samples[2 * i] + samples[2 * i + 1] : samples[i])
                              / white);
    return grid;
}

Result<HeightGrid> readPgm(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    const auto number = [&]() -> long {
        for (in >> std::ws; in.peek() == '#'; in >> std::ws)
            in.ignore(1 << 20, '\n'); // a comment
        long value = -1;
        in >> value;
        return in ? value : -1;
    };
    char magic[2] = {};
    in.read(magic, 2);
    const long columns = number(), rows = number(), white = number();
    if (const auto reason = badSize(columns, rows))
        return unreadable(file, *reason);
    if (white < 1 || white > 65535)
        return unreadable(file, Message("its largest value is not 1 to 65535"));
    const bool wide = white > 255;
    const std::size_t count = std::size_t(columns) * std::size_t(rows);
    if (magic[1] == '2') { // as text
        HeightGrid grid{int(columns), int(rows), {}};
        for (std::size_t i = 0; i < count; ++i) {
            const long value = number();
            if (value < 0 || value > white)
                return unreadable(file,
                                  Message("it ends too early or has a value that is too large"));
            grid.height.push_back(double(value) / double(white));
        }
        return grid;
    }
    in.get();
    std::error_code error; // what the file does not have must not ask for memory
    if (count * (wide ? 2 : 1) > std::filesystem::file_size(file, error))
        return unreadable(file, Message("it ends too early"));
    std::vector<unsigned char> samples(count * (wide ? 2 : 1));
    in.read(reinterpret_cast<char*>(samples.data()), std::streamsize(samples.size()));
    if (!in)
        return unreadable(file, Message("it ends too early"));
    return gridFrom(samples, columns, rows, double(white), wide);
}

// Reads the rows of a PNG; false with a reason when that fails. libpng reports flaws by a jump back
// to here, so nothing with a destructor may live in between.
bool readRows(png_structp png, png_infop info, const std::filesystem::path& path, std::FILE* file,
              std::vector<unsigned char>& samples, long (&size)[2], bool& wide, Message& why)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, file);
    png_read_info(png, info);
    size[0] = long(png_get_image_width(png, info));
    size[1] = long(png_get_image_height(png, info));
    const int type = png_get_color_type(png, info);
    wide = png_get_bit_depth(png, info) == 16;
    if (size[0] > mostPoints || size[1] > mostPoints)
        return true;
    if (isBomb(path, size[0], size[1])) {
        why = Message("it has too few bytes for %1 x %2 points; fewer points, or a PGM, would do",
                      size[0], size[1]);
        return false;
    }
    png_set_expand(png); // palettes and few bits become 8 bits
    if (type & PNG_COLOR_MASK_COLOR)
        png_set_rgb_to_gray(png, PNG_ERROR_ACTION_NONE, -1, -1);
    png_set_strip_alpha(png);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t stride = png_get_rowbytes(png, info);
    if (stride != std::size_t(size[0]) * (wide ? 2 : 1)) {
        why = Message("its kind of colour is not known");
        return false;
    }
    samples.resize(stride * std::size_t(size[1]));
    for (int pass = 0; pass < passes; ++pass)
        for (long row = 0; row < size[1]; ++row)
            png_read_row(png, samples.data() + std::size_t(row) * stride, nullptr);
    return true;
}

Result<HeightGrid> readPng(const std::filesystem::path& file)
{
    Message why("it is damaged");
    const auto remember = [](png_structp png, png_const_charp message) {
        *static_cast<Message*>(png_get_error_ptr(png)) = Message::verbatim(message);
        png_longjmp(png, 1);
    };
    const auto ignore = [](png_structp, png_const_charp) {};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                             std::fclose);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &why, remember, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    std::vector<unsigned char> samples;
    long size[2] = {};
    bool wide = false;
    const bool read = in && info && readRows(png, info, file, in.get(), samples, size, wide, why);
    png_destroy_read_struct(&png, &info, nullptr);
    if (!read)
        return unreadable(file, why);
    if (const auto reason = badSize(size[0], size[1]))
        return unreadable(file, *reason);
    return gridFrom(samples, size[0], size[1], wide ? 65535.0 : 255.0, wide);
}

} // namespace

Result<HeightGrid> readHeightPicture(const std::filesystem::path& file)
{
    char start[2] = {};
    std::ifstream(file, std::ios::binary).read(start, 2);
    if (start[0] == 'P' && (start[1] == '2' || start[1] == '5'))
        return readPgm(file);
    if (std::memcmp(start, "\x89P", 2) == 0)
        return readPng(file);
    return unreadable(file, Message("it is neither a PNG nor a PGM"));
}

} // namespace ripstop
