// For the ends of lines the faces around them are listed; the shorter list of two ends is looked
// for in the longer, once for each pair of points, so that files of strangers cost no more than
// they are worth.
#include "shapes/lines_within.h"

#include <algorithm>
#include <map>

namespace ripstop {

std::vector<std::uint8_t> linesWithinFaces(const PolygonMesh& mesh)
{
    std::vector<std::uint8_t> isEnd(mesh.points.size());
    for (const auto& [a, b] : mesh.lines)
        isEnd[std::size_t(a)] = isEnd[std::size_t(b)] = 1;
    std::map<int, std::vector<int>> facesAt; // of the ends, ascending
    for (std::size_t i = 0; i < mesh.faceCount(); ++i)
        for (const int corner : mesh.face(i))
            if (isEnd[std::size_t(corner)])
                facesAt[corner].push_back(int(i));
    const auto shareFace = [&](int a, int b) {
        const auto atA = facesAt.find(a), atB = facesAt.find(b);
        if (atA == facesAt.end() || atB == facesAt.end())
            return false;
        const auto& [few, many] =
            std::minmax(atA->second, atB->second, [](const auto& one, const auto& other) {
                return one.size() < other.size();
            });
        return std::ranges::any_of(
            few, [&](int face) { return std::ranges::binary_search(many, face); });
    };
    std::map<std::array<int, 2>, bool> known;
    std::vector<std::uint8_t> within;
    for (const auto& [a, b] : mesh.lines) {
        const auto [found, isNew] = known.try_emplace({std::min(a, b), std::max(a, b)}, false);
        if (isNew)
            found->second = shareFace(a, b);
        within.push_back(found->second ? 1 : 0);
    }
    return within;
}

} // namespace ripstop
