#include "export/frame_spool.h"

#include <algorithm>

namespace ripstop {
namespace {

template <typename T>
void write(std::ostream& out, const std::vector<T>& values)
{
    out.write(reinterpret_cast<const char*>(values.data()),
              std::streamsize(values.size() * sizeof(T)));
}

template <typename T>
void read(std::istream& in, std::vector<T>& values, std::size_t count)
{
    values.resize(count);
    in.read(reinterpret_cast<char*>(values.data()), std::streamsize(count * sizeof(T)));
}

// What has been gone once is counted as gone, also when the flags are of more elements by now.
void join(std::vector<std::uint8_t>& all, const std::vector<std::uint8_t>& now)
{
    all.resize(now.size(), 0);
    std::ranges::transform(all, now, all.begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::uint8_t(a | b); });
}

} // namespace

Result<FrameSpool> FrameSpool::open(OutputFiles& files, const std::filesystem::path& besides)
{
    Result<std::fstream> file = files.scratch(besides);
    if (!file)
        return file.failure();
    FrameSpool spool;
    spool.m_besides = besides;
    spool.m_file = std::move(*file);
    return spool;
}

std::optional<Failure> FrameSpool::add(const Frame& frame)
{
    std::vector<Eigen::Vector3f> position(frame.position.size());
    std::ranges::transform(frame.position, position.begin(),
                           [](const Vec3& x) -> Eigen::Vector3f { return x.cast<float>(); });
    m_file.seekp(0, std::ios::end);
    m_frames.push_back({frame.time, frame.layout, m_file.tellp()});
    write(m_file, position);
    write(m_file, frame.gone);
    write(m_file, frame.torn);
    m_file.flush();
    if (!m_file)
        return notWritten(m_besides, Message("there is no room for the shapes of the series"));
    join(m_everGone, frame.gone);
    join(m_everTorn, frame.torn);
    return std::nullopt;
}

Result<FrameSpool::Shape> FrameSpool::read(std::size_t i)
{
    const Layout& of = layout(i);
    Shape shape;
    m_file.seekg(m_frames[i].begin);
    ripstop::read(m_file, shape.position, of.particleId.size());
    ripstop::read(m_file, shape.gone, of.panelId.size());
    ripstop::read(m_file, shape.torn, of.links.size());
    if (!m_file)
        return notWritten(m_besides, Message("the shapes of the series cannot be read again"));
    return shape;
}

} // namespace ripstop
