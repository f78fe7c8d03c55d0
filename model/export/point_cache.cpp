// Both formats are a header and then the places of all vertices, frame after frame; they differ in
// the header and in the order of bytes. The mesh that they move is written beside them.
#include "export/point_cache.h"

#include "export/moment.h"
#include "export/spooled_sink.h"

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

class PointCache final : public SpooledSink
{
public:
    using Header = std::string (*)(const FrameSpool&, std::size_t points);

    PointCache(const std::filesystem::path& target, const MeshAppearance& appearance, Header header,
               std::endian order)
        : SpooledSink(target, appearance)
        , m_header(header)
        , m_order(order)
    {}

private:
    std::optional<Failure> write(ConstantMesh& mesh, std::ostream& out,
                                 const Progress& progress) override
    {
        out << m_header(spool(), mesh.surface().position.size());
        for (std::size_t i = 0; i < spool().count(); ++i) {
            if (!goesOn(progress, double(i) / double(spool().count())))
                return exportCancelled;
            const auto places = mesh.positions(spool(), i);
            if (!places)
                return places.failure();
            std::string bytes;
            for (const Eigen::Vector3f& place : *places)
                for (const float x : place)
                    put(bytes, m_order, x);
            out << bytes;
        }
        std::filesystem::path obj = target();
        obj.replace_extension(".obj");
        std::string text = objText(mesh.surface());
        if (const auto materials = objMaterials(obj, appearance())) {
            text = materials->line + text;
            if (auto failure = files().write(materials->file, materials->text))
                return failure;
        }
        return files().write(obj, text);
    }

    Header m_header;
    std::endian m_order;
};

} // namespace

Result<std::unique_ptr<FrameSink>> pc2Sink(const std::filesystem::path& target,
                                           const MeshAppearance& appearance)
{
    return opened(std::make_unique<PointCache>(target, appearance, pc2Header, std::endian::little));
}

Result<std::unique_ptr<FrameSink>> mddSink(const std::filesystem::path& target,
                                           const MeshAppearance& appearance)
{
    return opened(std::make_unique<PointCache>(target, appearance, mddHeader, std::endian::big));
}

} // namespace ripstop
