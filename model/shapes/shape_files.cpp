// A cache of shapes, one for heights of pictures, one for meshes, one for hills, and one for sizes
// of pictures:
// 1. A name says what the shape is made of: path, date and size of the file, or the numbers of
//    hills.
// 2. Shelf finds a shape of that name as long as anybody uses it, keeps the last four in any case,
//    and remembers the last failures, so that a flawed file is not read at every edit; of sizes,
//    which are small and which nobody keeps, so many that no scene has more.
// 3. A shape that is not known is made while the lock is held, so that two threads do not read one
//    file twice. A caller without effort does not wait for the lock and gets null.
#include "shapes/shape_files.h"

#include "shapes/height_picture.h"
#include "shapes/mesh_file.h"

#include <deque>
#include <mutex>
#include <sstream>

namespace ripstop {
namespace {

// Keeps the last few shapes alive; older ones are found as long as somebody uses them.
template <typename Shape>
class Shelf
{
public:
    explicit Shelf(std::size_t most = 4)
        : m_most(most)
    {}

    template <typename Make>
    Result<std::shared_ptr<const Shape>> take(const std::string& name, Effort effort, Make make)
    {
        const std::shared_ptr<const Shape> notYet;
        std::unique_lock lock(m_mutex, std::defer_lock);
        if (effort == Effort::Any)
            lock.lock();
        else if (!lock.try_lock()) // another thread is reading
            return notYet;
        for (const auto& [held, shape] : m_known)
            if (held == name)
                if (std::shared_ptr<const Shape> found = shape.lock())
                    return found;
        for (const auto& [held, failure] : m_failed) // a flawed file is not read at every edit
            if (held == name)
                return failure;
        if (effort == Effort::None)
            return notYet;
        Result<Shape> made = make();
        if (!made) {
            m_failed.emplace_back(name, made.failure());
            if (m_failed.size() > m_most)
                m_failed.pop_front();
            return made.failure();
        }
        std::shared_ptr<const Shape> shape = std::make_shared<const Shape>(std::move(*made));
        std::erase_if(m_known, [&](const auto& entry) {
            return entry.first == name || entry.second.expired();
        });
        m_known.emplace_back(name, shape);
        m_kept.push_back(shape);
        if (m_kept.size() > m_most)
            m_kept.pop_front();
        return shape;
    }

private:
    std::size_t m_most; // kept
    std::mutex m_mutex;
    std::vector<std::pair<std::string, std::weak_ptr<const Shape>>> m_known;
    std::deque<std::shared_ptr<const Shape>> m_kept;
    std::deque<std::pair<std::string, Failure>> m_failed; // the last few
};

template <typename Shape, typename Read>
Result<std::shared_ptr<const Shape>> fromFile(const std::filesystem::path& file,
                                              const Message& what, Shelf<Shape>& shelf,
                                              Effort effort, Read read)
{
    std::error_code error;
    const bool isThere = std::filesystem::is_regular_file(file, error);
    if (!isThere)
        return std::filesystem::exists(file, error)
                   ? Failure("The %1 %2 is not a file; choose another.", what, file.string())
                   : Failure("The %1 %2 does not exist; put it there, or choose another file.",
                             what, file.string());
    const auto date = std::filesystem::last_write_time(file, error);
    const auto size = std::filesystem::file_size(file, error);
    std::ostringstream name;
    name << file.string() << ' ' << date.time_since_epoch().count() << ' ' << size;
    return shelf.take(name.str(), effort, [&] { return read(file); });
}

} // namespace

std::filesystem::path placeOfFile(std::string_view folder, std::string_view file)
{
    return (std::filesystem::path(folder) / std::filesystem::path(file)).lexically_normal();
}

Result<std::shared_ptr<const HeightGrid>> heightsFromFile(const std::filesystem::path& file,
                                                          Effort effort)
{
    static Shelf<HeightGrid> shelf;
    return fromFile(file, Message("picture"), shelf, effort, readHeightPicture);
}

Result<std::shared_ptr<const TriangleTree>> meshFromFile(const std::filesystem::path& file,
                                                         Effort effort)
{
    static Shelf<TriangleTree> shelf;
    return fromFile(file, Message("mesh"), shelf, effort, readMeshFile);
}

Result<PictureSize> pictureSize(const std::filesystem::path& file)
{
    static Shelf<PictureSize> shelf(1000);
    const auto size = fromFile(file, Message("picture"), shelf, Effort::Any, readPictureSize);
    if (!size)
        return size.failure();
    return **size;
}

std::shared_ptr<const HeightGrid> hills(int grid, std::uint32_t seed, double length, Effort effort)
{
    static Shelf<HeightGrid> shelf;
    std::ostringstream name;
    name.precision(17);
    name << grid << ' ' << seed << ' ' << length;
    return *shelf.take(name.str(), effort,
                       [&] { return Result<HeightGrid>(generatedHills(grid, seed, length)); });
}

} // namespace ripstop
