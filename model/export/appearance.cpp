// The constructor goes over the scene once: first the materials, each a fabric with the colour, the
// picture and the thickness of what is made of it, then the parts, whose rows it sorts by id.
// Questions are answered by looking into those.
#include "export/appearance.h"

#include "derived/fabric_picture.h"
#include "derived/link_thickness.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

// "#rrggbb"; grey when it is not.
std::array<double, 3> colorFrom(const std::string& text)
{
    unsigned value = 0xcccccc;
    if (text.size() == 7)
        std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    const auto part = [&](unsigned shift) { return double(value >> shift & 0xff) / 255.0; };
    return {part(16), part(8), part(0)};
}

template <typename T>
const T* find(const std::vector<std::pair<std::uint32_t, T>>& rows, std::uint32_t id)
{
    const auto row = std::ranges::lower_bound(rows, id, {}, &std::pair<std::uint32_t, T>::first);
    return row != rows.end() && row->first == id ? &row->second : nullptr;
}

// Finds the springs that bend a woven fabric: over two of its threads in a row, and as long as
// both. Other programs would take them for lines that lie on it.
class TwoThreads
{
public:
    explicit TwoThreads(const Part& part)
    {
        for (const Link& link : part.links)
            if (link.role == LinkRole::Thread) {
                m_threads.push_back({link.from, link.to, link.restLength});
                m_threads.push_back({link.to, link.from, link.restLength});
            }
        std::ranges::sort(m_threads, {}, &Thread::from);
    }

    bool lieUnder(const Link& link) const
    {
        constexpr double rounding = 1e-6; // of the length
        for (const Thread& one : std::ranges::equal_range(m_threads, link.from, {}, &Thread::from))
            for (const Thread& other :
                 std::ranges::equal_range(m_threads, link.to, {}, &Thread::from))
                if (one.to == other.to
                    && std::abs(one.length + other.length - link.restLength)
                           <= rounding * link.restLength)
                    return true;
        return false;
    }

private:
    struct Thread
    {
        Id from, to;
        double length; // m
    };
    std::vector<Thread> m_threads; // both ways, by `from`
};

} // namespace

MeshAppearance::MeshAppearance(const Scene& scene)
{
    Rows<std::size_t> materials;
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item)) {
            materials.emplace_back(std::uint32_t(entry.id), m_fabrics.size());
            m_fabrics.push_back(
                {material->name, colorFrom(material->color), {}, linkThickness(*material)});
            m_prints.emplace_back();
            for (const PrintedPoint& point : printedPoints(scene, entry.id))
                m_prints.back().emplace_back(point.particle, point.at);
            if (!m_prints.back().empty())
                m_fabrics.back().picture = placeOfPicture(scene, *material);
        }
    std::ranges::sort(materials);

    bool isTextured = false;
    bool isNamed = false;
    forEachPart(scene, [&](Id, const Part& part) {
        if (!isNamed)
            m_name = part.name;
        isNamed = true;
        for (const Particle& row : part.particles) {
            m_texture.emplace_back(std::uint32_t(row.id), TexturePoint{row.textureU, row.textureV});
            isTextured = isTextured || row.textureU != 0.0 || row.textureV != 0.0;
        }
        const auto takeFabric = [&](const auto& row) {
            const std::size_t* fabric = find(materials, std::uint32_t(row.material));
            m_fabricOf.emplace_back(std::uint32_t(row.id), fabric ? *fabric : 0);
        };
        for (const Panel& row : part.panels)
            takeFabric(row);
        const TwoThreads twoThreads(part);
        const auto isThin = [&](const Link& row) { // a batten is thick
            const std::size_t* material = find(materials, std::uint32_t(row.material));
            return !material || m_fabrics[*material].thickness == 0.0;
        };
        for (const Link& row : part.links)
            if (row.role != LinkRole::Line || (isThin(row) && twoThreads.lieUnder(row)))
                m_ofFabric.push_back(std::uint32_t(row.id));
            else
                takeFabric(row);
    });
    if (!isTextured)
        m_texture.clear();
    std::ranges::sort(m_texture, {}, &std::pair<std::uint32_t, TexturePoint>::first);
    std::ranges::sort(m_fabricOf);
    std::ranges::sort(m_ofFabric);
}

MeshAppearance::TexturePoint MeshAppearance::textureOf(std::uint32_t particle) const
{
    const TexturePoint* point = find(m_texture, particle);
    return point ? *point : TexturePoint{};
}

MeshAppearance::TexturePoint MeshAppearance::printOf(std::size_t fabric,
                                                     std::uint32_t particle) const
{
    const TexturePoint* point = find(m_prints[fabric], particle);
    return point ? *point : TexturePoint{};
}

std::size_t MeshAppearance::fabricOf(std::uint32_t element) const
{
    const std::size_t* fabric = find(m_fabricOf, element);
    return fabric ? *fabric : 0;
}

bool MeshAppearance::isLine(std::uint32_t link) const
{
    return !std::ranges::binary_search(m_ofFabric, link);
}

bool MeshAppearance::isRound(std::uint32_t link) const
{
    return isLine(link) && m_fabrics[fabricOf(link)].thickness > 0.0;
}

} // namespace ripstop
