// Reads PLY in three stages:
// 1. The header lists elements with their properties, in the order of the body, and the format.
// 2. The body is numbers only. Numbers takes one after the other from text or from bytes of either
//    order; rows of vertices and faces are kept, and all others are read to get past them.
// 3. whole() checks the corners against the number of points, since faces may stand before
//    vertices, and gives corners the texture of their points.
// A body that ends too early fails at the row where it ends, and rows without properties are
// refused, because a count alone could make them endless.
#include "shapes/ply_file.h"

#include "shapes/text_words.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace ripstop {
namespace {

constexpr long long rowsBetweenReports = 20000;

enum class Format { Ascii, LittleEndian, BigEndian };

struct PlyType
{
    std::string_view name;
    std::string_view other; // of newer writers
    int bytes;
    char sort; // i: signed, u: unsigned, f: floating
};
constexpr std::array<PlyType, 8> types{{{"char", "int8", 1, 'i'},
                                        {"uchar", "uint8", 1, 'u'},
                                        {"short", "int16", 2, 'i'},
                                        {"ushort", "uint16", 2, 'u'},
                                        {"int", "int32", 4, 'i'},
                                        {"uint", "uint32", 4, 'u'},
                                        {"float", "float32", 4, 'f'},
                                        {"double", "float64", 8, 'f'}}};

struct PlyProperty
{
    std::string name;
    const PlyType* type;
    const PlyType* count = nullptr; // of a list
};

struct PlyElement
{
    std::string name;
    long long count;
    std::vector<PlyProperty> properties;
};

const PlyType* typeCalled(std::string_view name)
{
    const auto found = std::ranges::find_if(
        types, [&](const PlyType& type) { return type.name == name || type.other == name; });
    return found == types.end() ? nullptr : &*found;
}

// Takes one number after the other from the body, whatever the format.
class Numbers
{
public:
    Numbers(std::string_view body, Format format)
        : m_body(body)
        , m_format(format)
    {}

    bool take(const PlyType& type, double& number)
    {
        if (m_format == Format::Ascii)
            return takeText(number);
        if (m_body.size() < std::size_t(type.bytes))
            return false;
        std::array<unsigned char, 8> bytes{};
        std::memcpy(bytes.data(), m_body.data(), std::size_t(type.bytes));
        m_body.remove_prefix(std::size_t(type.bytes));
        if (m_format == Format::BigEndian)
            std::reverse(bytes.begin(), bytes.begin() + type.bytes);
        std::uint64_t bits = 0;
        for (int i = 0; i < type.bytes; ++i)
            bits |= std::uint64_t(bytes[std::size_t(i)]) << (8 * i);
        if (type.sort == 'f' && type.bytes == 4) {
            float value = 0.0f;
            const auto half = std::uint32_t(bits);
            std::memcpy(&value, &half, 4);
            number = value;
        } else if (type.sort == 'f') {
            std::memcpy(&number, &bits, 8);
        } else if (type.sort == 'i') {
            const int unused = 64 - 8 * type.bytes;
            number = double(std::int64_t(bits << unused) >> unused); // with its sign
        } else {
            number = double(bits);
        }
        return true;
    }

    double left() const { return double(m_body.size()); } // bytes

private:
    bool takeText(double& number)
    {
        const auto isSpace = [](char c) { return isBlank(c) || c == '\n'; };
        while (!m_body.empty() && isSpace(m_body.front()))
            m_body.remove_prefix(1);
        std::size_t end = 0;
        while (end < m_body.size() && !isSpace(m_body[end]))
            ++end;
        const bool isRead = readNumber(m_body.substr(0, end), number);
        m_body.remove_prefix(end);
        return isRead;
    }

    std::string_view m_body;
    Format m_format;
};

class PlyReader
{
public:
    explicit PlyReader(const std::string& name)
        : m_name(name)
    {
        m_mesh.objects.emplace_back();
        m_mesh.materials.emplace_back();
    }

    Result<PolygonMesh> read(std::string_view content, const Progress& progress)
    {
        if (!readHeader(content))
            return refuse(Message("its header cannot be understood"));
        Numbers numbers(content, m_format);
        const double size = std::max(numbers.left(), 1.0);
        for (const PlyElement& element : m_elements)
            for (long long row = 0; row < element.count; ++row) {
                if (row % rowsBetweenReports == 0 && !goesOn(progress, 1.0 - numbers.left() / size))
                    return Failure{"The import was cancelled."};
                if (!readRow(element, numbers))
                    return refuse(
                        Message("%1 %2 of %3 is not there", element.name, row + 1, element.count));
            }
        return whole();
    }

private:
    bool readHeader(std::string_view& content)
    {
        std::string_view line = takePlainLine(content);
        if (takeWord(line) != "ply")
            return false;
        bool hasFormat = false;
        while (!content.empty()) {
            line = takePlainLine(content);
            const std::string_view keyword = takeWord(line);
            if (keyword == "end_header")
                return hasFormat;
            bool isGood = true;
            if (keyword == "format")
                isGood = hasFormat = readFormat(takeWord(line));
            else if (keyword == "element")
                isGood = addElement(line);
            else if (keyword == "property")
                isGood = addProperty(line);
            if (!isGood)
                return false;
        }
        return false;
    }

    bool readFormat(std::string_view word)
    {
        m_format = word == "ascii"                  ? Format::Ascii
                   : word == "binary_little_endian" ? Format::LittleEndian
                                                    : Format::BigEndian;
        return m_format != Format::BigEndian || word == "binary_big_endian";
    }

    bool addElement(std::string_view line)
    {
        PlyElement element{std::string(takeWord(line)), 0, {}};
        if (!readNumber(takeWord(line), element.count) || element.count < 0)
            return false;
        m_elements.push_back(std::move(element));
        return true;
    }

    bool addProperty(std::string_view line)
    {
        PlyProperty property{};
        std::string_view word = takeWord(line);
        if (word == "list") {
            property.count = typeCalled(takeWord(line));
            if (!property.count)
                return false;
            word = takeWord(line);
        }
        property.type = typeCalled(word);
        property.name = takeWord(line);
        if (!property.type || m_elements.empty())
            return false;
        m_elements.back().properties.push_back(std::move(property));
        return true;
    }

    bool readRow(const PlyElement& element, Numbers& numbers)
    {
        const bool isVertex = element.name == "vertex";
        const bool isFace = element.name == "face";
        Vec3 point = Vec3::Zero();
        PolygonMesh::TexturePoint texture{};
        for (const PlyProperty& property : element.properties) {
            double number = 0.0;
            if (property.count) {
                const bool isCorners =
                    isFace
                    && (property.name == "vertex_indices" || property.name == "vertex_index");
                if (!readList(property, numbers, isCorners))
                    return false;
                continue;
            }
            if (!numbers.take(*property.type, number))
                return false;
            if (isVertex)
                place(property.name, number, point, texture);
        }
        if (isVertex) {
            m_mesh.points.push_back(point);
            m_texture.push_back(texture);
        }
        if (element.name == "edge")
            ++m_mesh.strayElements;
        return !element.properties.empty(); // rows without bytes could go on for ever
    }

    void place(const std::string& name, double number, Vec3& point,
               PolygonMesh::TexturePoint& texture)
    {
        if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z')
            point[name[0] - 'x'] = number;
        const bool isU = name == "s" || name == "u" || name == "texture_u";
        const bool isV = name == "t" || name == "v" || name == "texture_v";
        if (isU || isV) {
            texture[isU ? 0 : 1] = number;
            m_hasTexture = true;
        }
    }

    bool readList(const PlyProperty& property, Numbers& numbers, bool isCorners)
    {
        double count = 0.0;
        if (!numbers.take(*property.count, count) || !(count >= 0.0) || count > numbers.left())
            return false;
        const std::size_t before = m_mesh.corners.size();
        for (int i = 0; i < int(count); ++i) {
            double number = 0.0;
            if (!numbers.take(*property.type, number))
                return false;
            if (isCorners)
                m_mesh.corners.push_back(number >= 0.0 && number < 2e9 ? int(number) : -1);
        }
        if (!isCorners)
            return true;
        if (count >= 3.0) {
            m_mesh.endFace(0, 0);
        } else {
            m_mesh.corners.resize(before);
            ++m_mesh.strayElements;
        }
        return true;
    }

    // The mesh, when the parts of the file agree with each other.
    Result<PolygonMesh> whole()
    {
        for (std::size_t i = 0; i < m_mesh.faceCount(); ++i)
            for (const int corner : m_mesh.face(i))
                if (corner < 0 || corner >= int(m_mesh.points.size()))
                    return refuse(Message("face %1 names vertex %2, and there are %3", i + 1,
                                          corner, m_mesh.points.size()));
        if (m_hasTexture)
            for (const int corner : m_mesh.corners)
                m_mesh.texture.push_back(m_texture[std::size_t(corner)]);
        return std::move(m_mesh);
    }

    Failure refuse(const Message& what) const
    {
        return Failure("The mesh %1 cannot be read: %2. The file may be cut off; save it again.",
                       m_name, what);
    }

    const std::string& m_name;
    Format m_format = Format::Ascii;
    std::vector<PlyElement> m_elements;
    PolygonMesh m_mesh;
    std::vector<PolygonMesh::TexturePoint> m_texture; // [points]
    bool m_hasTexture = false;
};

} // namespace

Result<PolygonMesh> readPly(std::string_view content, const std::string& name,
                            const Progress& progress)
{
    return PlyReader(name).read(content, progress);
}

} // namespace ripstop
