// Reads OBJ line by line: a backslash joins lines, a keyword chooses what to add, and what is not
// known is passed over. Points and texture points are kept as they come; faces and lines keep
// indices only, because those may point forward, and checkFaces() and checkLines() look at all of
// them in the end. Which
// groups there are is known then as well. The first flaw ends the reading with its line and what to
// do about it. Colours and pictures of materials come from a second file,
// by name.
#include "shapes/obj_file.h"

#include "shapes/lines_within.h"
#include "shapes/text_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace ripstop {
namespace {

constexpr int linesBetweenReports = 20000;

// The rest of a line after the keyword, without blanks around it; names may have blanks inside.
std::string rest(std::string_view line)
{
    while (!line.empty() && isBlank(line.front()))
        line.remove_prefix(1);
    while (!line.empty() && isBlank(line.back()))
        line.remove_suffix(1);
    return std::string(line);
}

// Takes the next line, joined with those that a backslash at its end goes on with.
std::string_view takeLine(std::string_view& text, int& number, std::string& joined)
{
    joined.clear();
    for (;;) {
        std::string_view line = takePlainLine(text);
        ++number;
        const bool goesOn = !line.empty() && line.back() == '\\' && !text.empty();
        if (!goesOn && joined.empty())
            return line;
        if (goesOn)
            line.remove_suffix(1);
        joined.append(line).push_back(' ');
        if (!goesOn)
            return joined;
    }
}

class ObjReader
{
public:
    explicit ObjReader(const std::string& name)
        : m_name(name)
    {}

    Result<PolygonMesh> read(std::string_view text, const Progress& progress)
    {
        const double size = double(text.size());
        std::string joined;
        while (!text.empty()) {
            if (m_line % linesBetweenReports == 0
                && !goesOn(progress, 1.0 - double(text.size()) / size))
                return Failure{"The import was cancelled."};
            const bool hasEnd = text.find('\n') != std::string_view::npos;
            std::string_view line = takeLine(text, m_line, joined);
            m_isCutOff = text.empty() && !hasEnd;
            readLine(takeWord(line), line);
            if (m_failure)
                return *m_failure;
        }
        checkFaces();
        checkLines();
        if (m_failure)
            return *m_failure;
        leaveOutLines();
        divideByGroups();
        if (!m_hasTexture)
            m_mesh.texture.clear();
        return std::move(m_mesh);
    }

private:
    void readLine(std::string_view keyword, std::string_view line)
    {
        if (keyword == "v")
            addPoint(line);
        else if (keyword == "vt")
            addTexture(line);
        else if (keyword == "f")
            addFace(line);
        else if (keyword == "l")
            addLine(line);
        else if (keyword == "p")
            ++m_mesh.strayElements;
        else if (keyword == "o" || keyword == "g")
            startGroup(keyword == "o", rest(line));
        else if (keyword == "usemtl")
            useMaterial(rest(line));
        else if (keyword == "mtllib")
            m_mesh.materialFiles.push_back(rest(line));
    }

    void addPoint(std::string_view line)
    {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis)
            if (const std::string_view word = takeWord(line); !readNumber(word, point[axis]))
                return refuseNumber(word, Message("a vertex needs three numbers"));
        if (!point.allFinite())
            return refuse(Message("a vertex is not finite"));
        m_mesh.points.push_back(point);
    }

    void addTexture(std::string_view line)
    {
        PolygonMesh::TexturePoint point{};
        const std::string_view first = takeWord(line), second = takeWord(line); // may be absent
        const bool hasU = readNumber(first, point[0]);
        if (!hasU || (!second.empty() && !readNumber(second, point[1])) || !std::isfinite(point[0])
            || !std::isfinite(point[1]))
            return refuseNumber(hasU ? second : first,
                                Message("a texture point needs two finite numbers"));
        m_texture.push_back(point);
    }

    // Corners are "7", "7/3", "7//2" or "7/3/2".
    void addFace(std::string_view line)
    {
        const std::size_t before = m_mesh.corners.size();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            const std::size_t slash = word.find('/');
            const std::string_view point = word.substr(0, slash);
            std::string_view texture;
            if (slash != std::string_view::npos)
                texture = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
            const std::optional<int> corner = pointAt(point);
            if (!corner)
                return refuseCorner(word);
            m_mesh.corners.push_back(*corner);
            int at = 0;
            if (!texture.empty() && !readNumber(texture, at))
                return refuseCorner(word);
            m_textureAt.push_back(at > 0 ? at - 1 : at < 0 ? int(m_texture.size()) + at : -1);
        }
        if (m_mesh.corners.size() - before < 3)
            return refuseFace();
        if (m_objects.empty())
            startObject(false, {});
        if (m_mesh.materials.empty())
            useMaterial({});
        if (m_group < 0)
            m_group = placeOf(m_groupName, m_groups, m_groupNames);
        m_groupOf.push_back(m_group);
        m_mesh.endFace(m_object, m_material);
        m_faceLine.push_back(m_line);
    }

    // The index of a point, which counts from 1, or back from the last one.
    std::optional<int> pointAt(std::string_view word) const
    {
        int index = 0;
        if (!readNumber(word, index) || index == 0)
            return std::nullopt;
        return index > 0 ? index - 1 : int(m_mesh.points.size()) + index;
    }

    // Ends are "7" or "7/3"; a line may go on over many points.
    void addLine(std::string_view line)
    {
        std::optional<int> before;
        std::size_t count = 0;
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            const std::optional<int> end = pointAt(word.substr(0, word.find('/')));
            if (!end)
                return refuse(Message("\"%1\" is not an end of a line", word));
            if (before) {
                m_mesh.lines.push_back({*before, *end});
                m_lineLine.push_back(m_line);
            }
            before = end;
            ++count;
        }
        if (count < 2)
            ++m_mesh.strayElements;
    }

    using Places = std::map<std::string, int, std::less<>>;

    // The place of a name in the list, to whose end it comes where it is new.
    static int placeOf(const std::string& name, Places& places, std::vector<std::string>& list)
    {
        const auto [place, isNew] = places.emplace(name, int(list.size()));
        if (isNew)
            list.push_back(name);
        return place->second;
    }

    // Faces of an object before its first group are in one of the object's name, which is listed
    // when there is a face of it.
    void startGroup(bool isObject, const std::string& name)
    {
        m_groupName = name;
        m_group = -1;
        startObject(isObject, name);
    }

    // A file with objects has groups inside of them, which divide the only one (divideByGroups).
    void startObject(bool isObject, const std::string& name)
    {
        if (m_hasObjects && !isObject)
            return;
        m_hasObjects = m_hasObjects || isObject;
        m_object = placeOf(name, m_objects, m_mesh.objects);
    }

    // An object that is all of the file says nothing that its groups do not say better.
    void divideByGroups()
    {
        if (m_mesh.objects.size() != 1 || m_groupNames.size() < 2)
            return;
        m_mesh.objects = std::move(m_groupNames);
        m_mesh.object = std::move(m_groupOf);
    }

    void useMaterial(const std::string& name)
    {
        const auto [place, isNew] = m_materials.emplace(name, int(m_mesh.materials.size()));
        if (isNew)
            m_mesh.materials.push_back({name, {}, {}});
        m_material = place->second;
    }

    // Checks the indices of all faces. They may point forward, so this comes last.
    void checkFaces()
    {
        const int points = int(m_mesh.points.size());
        m_mesh.texture.resize(m_mesh.corners.size(), PolygonMesh::noTexture());
        for (std::size_t i = 0; i < m_mesh.faceCount(); ++i)
            for (int c = m_mesh.first[i]; c < m_mesh.first[i + 1]; ++c) {
                const int corner = m_mesh.corners[std::size_t(c)];
                if (corner < 0 || corner >= points) {
                    m_line = m_faceLine[i];
                    return refuseVertex(
                        Message("a face names vertex %1 of %2", corner + 1, points));
                }
                const int at = m_textureAt[std::size_t(c)];
                if (at < 0 || at >= int(m_texture.size()))
                    continue;
                m_mesh.texture[std::size_t(c)] = m_texture[std::size_t(at)];
                m_hasTexture = true;
            }
    }

    void checkLines()
    {
        const int points = int(m_mesh.points.size());
        for (std::size_t i = 0; i < m_mesh.lines.size() && !m_failure; ++i)
            for (const int end : m_mesh.lines[i])
                if (end < 0 || end >= points) {
                    m_line = m_lineLine[i];
                    return refuseVertex(Message("a line names vertex %1 of %2", end + 1, points));
                }
    }

    // A line of the file of which no piece is left counts once.
    void leaveOutLines()
    {
        const std::vector<std::uint8_t> within = linesWithinFaces(m_mesh);
        std::vector<std::array<int, 2>> kept;
        for (std::size_t i = 0; i < within.size();) {
            const int number = m_lineLine[i];
            const std::size_t before = kept.size();
            for (; i < within.size() && m_lineLine[i] == number; ++i)
                if (!within[i] && m_mesh.lines[i][0] != m_mesh.lines[i][1])
                    kept.push_back(m_mesh.lines[i]);
            m_mesh.strayElements += kept.size() == before ? 1 : 0;
        }
        m_mesh.lines = std::move(kept);
    }

    void refuseCorner(std::string_view word)
    {
        refuse(Message("\"%1\" is not a corner of a face", word));
    }

    // Of a word that is no number. Programs that follow the language of the system may write
    // commas.
    void refuseNumber(std::string_view word, const Message& what)
    {
        if (word.find(',') == std::string_view::npos)
            return refuse(what);
        refuse(Message("\"%1\" is a number with a decimal comma", word),
               Message("An OBJ has decimal points; save it again with those, or replace the "
                       "commas."));
    }

    void refuseFace()
    {
        const Message what("a face needs three corners");
        if (m_isCutOff)
            return refuse(what);
        refuse(what,
               Message("Delete it in the file, or write it as a line (l); a program for meshes "
                       "finds faces without area, too."));
    }

    void refuseVertex(const Message& what)
    {
        refuse(what, Message("Vertices count from 1, over all objects of the file; save it again "
                             "from where it was made, with all vertices."));
    }

    void refuse(const Message& what)
    {
        m_failure = Failure("The mesh %1, line %2: %3. The file may be cut off; save it again.",
                            m_name, m_line, what);
    }

    void refuse(const Message& what, const Message& remedy)
    {
        m_failure = Failure("The mesh %1, line %2: %3. %4", m_name, m_line, what, remedy);
    }

    const std::string& m_name;
    PolygonMesh m_mesh;
    std::vector<PolygonMesh::TexturePoint> m_texture;
    std::vector<int> m_textureAt; // [corners] index into m_texture, or -1
    std::vector<int> m_faceLine;  // [faces]
    std::vector<int> m_lineLine;  // [lines]
    Places m_objects;
    Places m_materials;
    Places m_groups;
    std::vector<std::string> m_groupNames; // [groups]
    std::vector<int> m_groupOf;            // [faces] index into m_groupNames
    std::string m_groupName;
    std::optional<Failure> m_failure;
    int m_object = 0;
    int m_material = 0;
    int m_group = -1; // of m_groupName, once it has a face
    int m_line = 0;
    bool m_isCutOff = false;   // the line is the last, and has no end
    bool m_hasObjects = false; // "o" stands in the file
    bool m_hasTexture = false;
};

// "#rrggbb" of three parts from 0 to 1; empty for the other ways to say a colour (spectral, xyz).
std::string colorOf(std::string_view line)
{
    std::string color = "#";
    for (int i = 0; i < 3; ++i) {
        double part = 0.0;
        if (!readNumber(takeWord(line), part) || !(part >= 0.0 && part <= 1.0))
            return {};
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x", unsigned(std::lround(255.0 * part)) & 0xffU);
        color += digits;
    }
    return color;
}

// The file of a texture, which may have spaces in its name, after options and their values:
// numbers, of which there may be up to three, or one word (Wavefront, "Object Files"). Folders as
// Windows has them count.
std::string pictureOf(std::string_view texture)
{
    const auto isOption = [&] {
        std::string_view ahead = texture;
        return takeWord(ahead).starts_with('-');
    };
    while (isOption()) {
        const std::string_view option = takeWord(texture);
        double number = 0.0;
        std::string_view ahead = texture;
        const bool hasNumbers = readNumber(takeWord(ahead), number);
        texture = ahead; // its first value
        const int most = option == "-o" || option == "-s" || option == "-t" ? 3
                         : option == "-mm"                                  ? 2
                                                                            : 1;
        for (int i = 1; hasNumbers && i < most && readNumber(takeWord(ahead), number); ++i)
            texture = ahead;
    }
    std::string file = rest(texture);
    std::ranges::replace(file, '\\', '/');
    return file;
}

} // namespace

Result<PolygonMesh> readObj(std::string_view text, const std::string& name,
                            const Progress& progress)
{
    return ObjReader(name).read(text, progress);
}

void readMtl(std::string_view text, PolygonMesh& mesh)
{
    PolygonMesh::Material* current = nullptr;
    std::string joined;
    for (int number = 0; !text.empty();) {
        std::string_view line = takeLine(text, number, joined);
        const std::string_view keyword = takeWord(line);
        if (keyword == "newmtl") {
            const std::string name = rest(line);
            const auto found =
                std::ranges::find(mesh.materials, name, &PolygonMesh::Material::name);
            current = found == mesh.materials.end() ? nullptr : &*found;
        } else if (keyword == "Kd" && current) {
            if (const std::string color = colorOf(line); !color.empty())
                current->color = color;
        } else if (keyword == "map_Kd" && current) {
            current->picture = pictureOf(rest(line));
        }
    }
}

} // namespace ripstop
