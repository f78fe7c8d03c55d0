// Reads OFF (see ply_file.h) as lines: the counts, the vertices, then the faces. Faces of one or
// two corners are counted as stray, and a face with a wrong index or a missing line ends the
// reading.
#include "shapes/ply_file.h"
#include "shapes/text_words.h"

#include <algorithm>

namespace ripstop {
namespace {

constexpr long long linesBetweenReports = 20000;

// The lines of the file that are neither empty nor only a comment.
class Lines
{
public:
    Lines(std::string_view text, const Progress& progress)
        : m_text(text)
        , m_size(double(text.size()))
        , m_progress(progress)
    {}

    // The next line; empty at the end of the file, and when the reading is cancelled.
    std::string_view take()
    {
        while (!m_text.empty()) {
            if (++m_number % linesBetweenReports == 0
                && !goesOn(m_progress, 1.0 - double(m_text.size()) / m_size))
                m_text = {};
            std::string_view line = takePlainLine(m_text);
            line = line.substr(0, line.find('#'));
            std::string_view rest = line;
            if (!takeWord(rest).empty())
                return line;
        }
        return {};
    }
    long long number() const { return m_number; }

private:
    std::string_view m_text;
    double m_size;
    const Progress& m_progress;
    long long m_number = 0;
};

} // namespace

Result<PolygonMesh> readOff(std::string_view content, const std::string& name,
                            const Progress& progress)
{
    Lines lines(content, progress);
    const auto refuse = [&](const Message& what) {
        return Failure("The mesh %1, line %2: %3. The file may be cut off; save it again.", name,
                       lines.number(), what);
    };
    std::string_view line = lines.take();
    std::string_view rest = line;
    if (takeWord(rest).ends_with("OFF")) {
        std::string_view counts = rest;
        line = takeWord(counts).empty() ? lines.take() : rest;
    }
    long long pointCount = 0;
    long long faceCount = 0;
    if (!readNumber(takeWord(line), pointCount) || !readNumber(takeWord(line), faceCount)
        || pointCount < 0 || faceCount < 0)
        return refuse(Message("the numbers of vertices and faces are missing"));
    PolygonMesh mesh;
    mesh.objects.emplace_back();
    mesh.materials.emplace_back();
    for (long long i = 0; i < pointCount; ++i) {
        line = lines.take();
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis)
            if (!readNumber(takeWord(line), point[axis]))
                return refuse(Message("vertex %1 of %2 needs three numbers", i + 1, pointCount));
        mesh.points.push_back(point);
    }
    for (long long i = 0; i < faceCount; ++i) {
        line = lines.take();
        int corners = 0;
        bool isWhole = readNumber(takeWord(line), corners) && corners >= 1;
        for (int c = 0; c < corners && isWhole; ++c) {
            int corner = 0;
            isWhole = readNumber(takeWord(line), corner) && corner >= 0 && corner < pointCount;
            if (isWhole && corners >= 3)
                mesh.corners.push_back(corner);
        }
        if (!isWhole)
            return refuse(Message("face %1 of %2 needs a count and as many vertices of the file",
                                  i + 1, faceCount));
        if (corners >= 3)
            mesh.endFace(0, 0);
        else
            ++mesh.strayElements;
    }
    if (!goesOn(progress, 1.0))
        return Failure{"The import was cancelled."};
    return mesh;
}

} // namespace ripstop
