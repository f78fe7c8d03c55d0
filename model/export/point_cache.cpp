#include "export/point_cache.h"

#include "export/constant_mesh.h"
#include "export/moment.h"
#include "export/output_files.h"

#include <algorithm>
#include <bit>
#include <concepts>

namespace ripstop {
namespace {

template <typename T>
void put(std::string& bytes, std::endian order, T value)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order != std::endian::native)
        std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

std::string pc2Header(const FrameSpool& spool, std::size_t points)
{
    constexpr auto low = std::endian::little;
    std::string bytes("POINTCACHE2\0", 12);
    put(bytes, low, std::int32_t(1));
    put(bytes, low, std::int32_t(points));
    put(bytes, low, 0.0f); // the first frame
    put(bytes, low, 1.0f); // frames from sample to sample
    put(bytes, low, std::int32_t(spool.count()));
    return bytes;
}

std::string mddHeader(const FrameSpool& spool, std::size_t points)
{
    constexpr auto high = std::endian::big;
    std::string bytes;
    put(bytes, high, std::int32_t(spool.count()));
    put(bytes, high, std::int32_t(points));
    for (std::size_t i = 0; i < spool.count(); ++i)
        put(bytes, high, float(spool.time(i) - spool.time(0)));
    return bytes;
}

class PointCache final : public FrameSink
{
public:
    using Header = std::string (*)(const FrameSpool&, std::size_t points);

    PointCache(const std::filesystem::path& target, const Dress& dress, Header header,
               std::endian order)
        : m_target(target)
        , m_dress(dress)
        , m_header(header)
        , m_order(order)
    {}

    std::optional<Failure> open()
    {
        Result<FrameSpool> spool = FrameSpool::open(m_files, m_target);
        if (!spool)
            return spool.failure();
        m_spool = std::move(*spool);
        return std::nullopt;
    }

    std::optional<Failure> add(const Frame& frame) override { return m_spool.add(frame); }

    std::optional<Failure> finish(const Progress& progress) override
    {
        Result<ConstantMesh> mesh = ConstantMesh::of(m_spool, m_dress);
        if (!mesh)
            return mesh.failure();
        Result<std::ofstream> out = m_files.open(m_target);
        if (!out)
            return out.failure();
        *out << m_header(m_spool, mesh->surface().position.size());
        for (std::size_t i = 0; i < m_spool.count(); ++i) {
            if (!goesOn(progress, double(i) / double(m_spool.count())))
                return exportCancelled;
            const auto places = mesh->positions(m_spool, i);
            if (!places)
                return places.failure();
            std::string bytes;
            for (const Eigen::Vector3f& place : *places)
                for (const float x : place)
                    put(bytes, m_order, x);
            *out << bytes;
        }
        if (auto failure = close(*out, m_target))
            return failure;
        std::filesystem::path obj = m_target;
        if (auto failure = m_files.write(obj.replace_extension(".obj"), objText(mesh->surface())))
            return failure;
        return m_files.commit();
    }

private:
    OutputFiles m_files;
    std::filesystem::path m_target;
    Dress m_dress;
    Header m_header;
    std::endian m_order;
    FrameSpool m_spool;
};

Result<std::unique_ptr<FrameSink>> opened(std::unique_ptr<PointCache> cache)
{
    if (auto failure = cache->open())
        return *failure;
    return std::unique_ptr<FrameSink>(std::move(cache));
}

} // namespace

Result<std::unique_ptr<FrameSink>> pc2Sink(const std::filesystem::path& target, const Dress& dress)
{
    return opened(std::make_unique<PointCache>(target, dress, pc2Header, std::endian::little));
}

Result<std::unique_ptr<FrameSink>> mddSink(const std::filesystem::path& target, const Dress& dress)
{
    return opened(std::make_unique<PointCache>(target, dress, mddHeader, std::endian::big));
}

} // namespace ripstop
